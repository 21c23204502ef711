// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "picture/transaction.h"
#include "render/traced_sky.h"
#include "sky/tally_info.h"
#include "sky/tally_kind.h"
#include "trace/scatter_profile.h"
#include "trace/sky_map.h"

namespace parhelion {

// What tallies are for pictures: the exact sums of a map or a profile with what they were traced from. They can be kept
// in files and added, and give the same bits however their rays were divided.

struct MapTally {
  TallyOrigin origin;
  double sunElevation = 0.0;  // rad
  SkyMap sums;
};

struct ProfileTally {
  TallyOrigin origin;
  ScatterProfile sums;
};

inline TallyKind kindOf(const MapTally&) { return TallyKind::map; }
inline TallyKind kindOf(const ProfileTally&) { return TallyKind::profile; }

/// With all that is known before the rays of a scene are traced by this version of the program. `cloud` is the scene's.
MapTally emptyMapTally(const LoadedScene& loaded, const Cloud& cloud, int binsPerHalfTurn);
ProfileTally emptyProfileTally(const LoadedScene& loaded, const Cloud& cloud, int bins, double from, double to);

/// Writes a file of sums (sky/sums_exr.h) that reading gives back to the bit. In one piece or not at all. Throws
/// std::runtime_error "path: reason".
void writeTally(const Output& output, const MapTally& tally);
void writeTally(const Output& output, const ProfileTally& tally);

/// Throws std::runtime_error "path: reason" for files that are no such tally, are damaged, or hold what no run can have
/// made.
MapTally readMapTally(const std::filesystem::path& path);
ProfileTally readProfileTally(const std::filesystem::path& path);

/// Their origins alone, after a look at the header only.
TallyOrigin readTallyOrigin(const std::filesystem::path& path);

/// Adds the rays of another tally of the same scene and bins. Where it throws, it changes nothing:
/// std::invalid_argument with the reason why they do not fit, std::overflow_error where the sums are too full.
void mergeTally(MapTally& tally, const MapTally& other);
void mergeTally(ProfileTally& tally, const ProfileTally& other);

/// Takes out again what mergeTally() has added. Throws std::invalid_argument, and changes nothing, unless all rays of
/// `other` are in it.
void subtractTally(MapTally& tally, const MapTally& other);
void subtractTally(ProfileTally& tally, const ProfileTally& other);

}  // namespace parhelion
