// SPDX-License-Identifier: Apache-2.0
#include "cli/view_profile.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "cli/tables.h"
#include "cli/text_output.h"
#include "math/rotation.h"
#include "render/scene_attributes.h"
#include "view/chart.h"

namespace parhelion::cli {

namespace {

using Profile = std::vector<SkyProfileBin>;

/// A bin without pixels has no light to speak of: its columns stay empty.
std::string columns(const SkyProfileBin& bin) {
  if (bin.pixels == 0) return ",,,,,,0";
  char text[160];
  std::snprintf(text, sizeof text, ",%.7g,%.7g,%.7g,%.7g,%.3g,%lld", bin.mean.x, bin.mean.y, bin.mean.z, bin.luminance,
                bin.error, static_cast<long long>(bin.pixels));
  return text;
}

std::string csv(const std::vector<Profile>& profiles) {
  std::string text = kLightColumns;
  if (profiles.size() == 2) text += kOtherLightColumns;
  text += "\n";
  char angles[80];
  for (std::size_t i = 0; i < profiles[0].size(); ++i) {
    std::snprintf(angles, sizeof angles, "%.10g,%.10g", tableDegrees(profiles[0][i].from),
                  tableDegrees(profiles[0][i].to));
    text += angles;
    for (const Profile& profile : profiles) text += columns(profile[i]);
    text += "\n";
  }
  return text;
}

/// Luminance over the angle, its greatest value made 1: photographs and simulations have no unit in common.
ChartCurve curveOf(const Profile& profile, const std::string& path) {
  double greatest = 0.0;
  for (const SkyProfileBin& bin : profile) greatest = std::max(greatest, bin.luminance);
  ChartCurve curve{std::filesystem::path(path).filename().string(), {}};
  for (const SkyProfileBin& bin : profile)
    if (bin.pixels > 0)
      curve.points.emplace_back(degrees(0.5 * (bin.from + bin.to)),
                                greatest > 0.0 ? bin.luminance / greatest : bin.luminance);
  return curve;
}

/// Throws if there is nothing to show.
void requireSky(const Profile& profile, const std::string& path) {
  if (std::any_of(profile.begin(), profile.end(), [](const SkyProfileBin& bin) { return bin.pixels > 0; })) return;
  char text[100];
  std::snprintf(text, sizeof text, ": no pixel of sky between %g and %g degrees from the sun",
                tableDegrees(profile.front().from), tableDegrees(profile.back().to));
  throw std::runtime_error(path + text);
}

}  // namespace

void writeProfile(const ViewOptions& options, std::vector<Observed> pictures, const std::vector<std::uint8_t>& mask,
                  Transaction& outputs) {
  std::vector<Camera> cameras;
  for (const Observed& picture : pictures) cameras.emplace_back(picture.camera.camera);
  std::vector<std::vector<std::uint8_t>> shares{mask};
  if (pictures.size() == 2)
    shares = {sharedSky(cameras[0], mask, cameras[1], {}), sharedSky(cameras[1], {}, cameras[0], mask)};

  std::vector<Profile> profiles;
  std::vector<ChartCurve> curves;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const std::string path = pictures[i].input.path;
    const Vec3 toSun = skyDirection(0.0, pictures[i].camera.sunElevation);
    const Image light = lightOf(std::move(pictures[i].input));
    profiles.push_back(skyProfile(light, cameras[i], toSun, options.profileSettings(), shares[i]));
    requireSky(profiles.back(), path);
    curves.push_back(curveOf(profiles.back(), path));
  }
  // The chart first: gnuplot may be missing, and then there is to be no table either.
  if (!options.chart.empty())
    drawChart(outputs.at(options.chart), {"angle from the sun, degrees", "luminance, share of the greatest"}, curves,
              kSoftware);
  writeText(outputs.at(options.profile), csv(profiles));
}

}  // namespace parhelion::cli
