// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace parhelion::cli {

// The first lines of the tables that commands write. By them and by these keys such files are known again.
inline constexpr const char* kProfileColumns = "from_deg,to_deg,energy,stderr,phase";
inline constexpr const char* kMapColumns = "azimuth_deg,elevation_deg,energy,stderr";
inline constexpr const char* kPathColumns =
    "path,population,share,stderr,azimuth_deg,elevation_deg,least_deviation_deg,name";
inline constexpr const char* kLightColumns = "from_deg,to_deg,R,G,B,luminance,stderr,pixels";
inline constexpr const char* kOtherLightColumns = ",R_other,G_other,B_other,luminance_other,stderr_other,pixels_other";

}  // namespace parhelion::cli
