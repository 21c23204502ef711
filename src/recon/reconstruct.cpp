// SPDX-License-Identifier: Apache-2.0
#include "recon/reconstruct.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "recon/methods.h"
#include "recon/sky_light.h"
#include "sky/picture_parts.h"
#include "sky/radiance.h"

namespace parhelion {
namespace {

/// By a method that is given the tally.
template <class Settings>
auto byMethod(const Tally& tally, const Settings& settings, const Watch& watch)
    -> decltype(reconstructSky(tally, settings, watch)) {
  return reconstructSky(tally, settings, watch);
}

/// By a method that knows nothing but pixels.
template <class Settings>
auto byMethod(const Tally& tally, const Settings& settings, const Watch& watch)
    -> decltype(reconstructHits(HitMap(), settings, watch), ReconstructedSky()) {
  const SkyLight light(tally);
  if (light.hitsPerLight() <= 0.0) return {emptyRadiance(tally.width(), tally.height()), {}};
  Reconstruction result = reconstructHits(light.hitMap(), settings, watch);
  return {light.develop(result.lights), std::move(result.remarks)};
}

bool isDark(const Tally& tally) {
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) {
    if (tally.raw(pixel, Tally::kY) != 0) return false;
  }
  return true;
}

ReconstructedSky ofWhole(const Tally& tally, const ReconSettings& settings, const Watch& watch) {
  return std::visit([&](const auto& own) { return byMethod(tally, own, watch); }, settings);
}

Tally partOf(const Tally& tally, const PicturePart& part) {
  TallyInfo info = tally.info;
  info.camera = part.camera;
  Tally own(std::move(info), tally.colours());
  for (int y = 0; y < own.height(); ++y)
    for (int x = 0; x < own.width(); ++x)
      for (int slot = 0; slot < own.slots(); ++slot)
        own.setRaw(y * own.width() + x, slot, tally.raw(y * tally.width() + part.left + x, slot));
  return own;
}

/// Puts a part into its place in the whole image.
void place(const Image& part, int left, Image& whole) {
  for (const Channel& channel : part.channels) {
    if (!whole.find(channel.name)) whole.add(channel.name);
    const auto into = std::ranges::find(whole.channels, channel.name, &Channel::name);
    for (int y = 0; y < part.height; ++y)
      std::copy_n(channel.samples.begin() + static_cast<std::ptrdiff_t>(y) * part.width, part.width,
                  into->samples.begin() + static_cast<std::ptrdiff_t>(y) * whole.width + left);
  }
}

/// Part by part: beyond a part's border there is other sky, from which no light may come over and to which none may go.
ReconstructedSky byParts(const Tally& tally, const std::vector<PicturePart>& parts, const ReconSettings& settings,
                         const Watch& watch) {
  ReconstructedSky sky{{tally.width(), tally.height(), {}}, {}};
  const double share = 1.0 / static_cast<double>(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Watch own = watch;
    own.onProgress = [&](double done) { watch.at((static_cast<double>(i) + done) * share); };
    ReconstructedSky part = ofWhole(partOf(tally, parts[i]), settings, own);
    place(part.image, parts[i].left, sky.image);
    for (std::string& remark : part.remarks)
      if (std::ranges::find(sky.remarks, remark) == sky.remarks.end()) sky.remarks.push_back(std::move(remark));
  }
  return sky;
}

/// An image of a tally's size without light, with the channels of every reconstruction.
Image darkOf(const SkyTally& tally) {
  Image image{tally.width(), tally.height(), {}};
  for (const char* name : {"R", "G", "B", kVarianceChannel}) image.add(name);
  return image;
}

/// Adds `gain` times the samples of a channel, or `gain` squared times those of a variance.
void addChannel(const std::vector<float>& samples, double gain, std::vector<float>& sum) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += static_cast<float>(gain * static_cast<double>(samples[i]));
}

/// Biases of parts have nothing to do with each other.
void addBias(const std::vector<float>& samples, double gain, std::vector<float>& sum) {
  for (std::size_t i = 0; i < sum.size(); ++i)
    sum[i] = static_cast<float>(std::hypot(static_cast<double>(sum[i]), gain * static_cast<double>(samples[i])));
}

/// R, G, B as the sums of all layers.
void addLayers(const std::vector<std::string>& layers, Image& all) {
  for (const char* colour : {"R", "G", "B"}) {
    std::vector<double> sum(all.pixels(), 0.0);
    for (const std::string& layer : layers)
      if (const auto* samples = all.find(layer + "." + colour))
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += static_cast<double>((*samples)[i]);
    std::ranges::transform(sum, all.findOrAdd(colour).begin(), [](double x) { return static_cast<float>(x); });
  }
}

}  // namespace

void addPart(const Image& part, double gain, const std::string& layer, Image& all) {
  for (const Channel& channel : part.channels) {
    if (channel.name == kVarianceChannel)
      addChannel(channel.samples, gain * gain, all.findOrAdd(channel.name));
    else if (channel.name == kBiasChannel)
      addBias(channel.samples, gain, all.findOrAdd(channel.name));
    else
      addChannel(channel.samples, gain, all.findOrAdd(layer.empty() ? channel.name : layer + "." + channel.name));
  }
}

ReconstructedSky reconstruct(const SkyTally& tally, const ReconSettings& settings, const LayerGains& gains,
                             const Watch& watch) {
  const std::vector<SkyTally::Part>& parts = tally.parts();
  if (parts.size() == 1 && gains.empty()) return reconstruct(parts.front().tally, settings, watch);
  ReconstructedSky sky{darkOf(tally), {}};
  const double share = 1.0 / static_cast<double>(parts.size());
  bool hasLight = false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto found = gains.find(parts[i].layer);
    const double gain = found == gains.end() ? 1.0 : found->second;
    if (!parts[i].layer.empty())
      for (const char* colour : {"R", "G", "B"}) sky.image.findOrAdd(parts[i].layer + "." + colour);
    if (gain == 0.0 || isDark(parts[i].tally)) continue;
    hasLight = true;
    Watch own = watch;
    own.onProgress = [&](double done) { watch.at((static_cast<double>(i) + done) * share); };
    ReconstructedSky part = reconstruct(parts[i].tally, settings, own);
    addPart(part.image, gain, parts[i].layer, sky.image);
    for (std::string& remark : part.remarks)
      if (std::ranges::find(sky.remarks, remark) == sky.remarks.end()) sky.remarks.push_back(std::move(remark));
  }
  if (!tally.layers().empty()) addLayers(tally.layers(), sky.image);
  if (!hasLight) sky.remarks.emplace_back("no light in the sky: the picture is black");
  watch.at(1.0);
  return sky;
}

ReconstructedSky reconstructSky(const Tally& tally, const NoSettings&, const Watch&) {
  return {plainRadiance(tally), {}};
}

ReconstructedSky reconstruct(const Tally& tally, const ReconSettings& settings, const Watch& watch) {
  const std::vector<PicturePart> parts = partsOf(tally.info.camera);
  ReconstructedSky sky = parts.size() == 1 ? ofWhole(tally, settings, watch) : byParts(tally, parts, settings, watch);
  if (isDark(tally)) sky.remarks.emplace_back("no light in the sky: the picture is black");
  watch.at(1.0);
  return sky;
}

}  // namespace parhelion
