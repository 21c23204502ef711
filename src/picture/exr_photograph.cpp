// SPDX-License-Identifier: Apache-2.0
#include "picture/exr_photograph.h"

#include <algorithm>
#include <cstdint>

#include "picture/limits.h"

namespace parhelion {
namespace {

/// The planes that make R, G, B and perhaps alpha.
std::vector<const std::vector<float>*> planesOf(const std::filesystem::path& path, const Image& image,
                                                const std::vector<std::string>& channels) {
  std::vector<const std::vector<float>*> planes{image.find("R"), image.find("G"), image.find("B")};
  if (!planes[0] && !planes[1] && !planes[2]) planes.assign(3, image.find("Y"));
  if (std::find(planes.begin(), planes.end(), nullptr) != planes.end()) {
    std::string names;
    for (const std::string& channel : channels) names += (names.empty() ? "" : ", ") + channel;
    throw pictureError(path, "no channels R, G, B, nor Y; it has " + names);
  }
  if (const auto* alpha = image.find("A")) planes.push_back(alpha);
  return planes;
}

/// Memory must stay in proportion to the file even where the display window is far larger than the data.
void requireReadableDisplay(const std::filesystem::path& path, const ExrFrame& frame) {
  const DisplayWindow& display = frame.display;
  requireReadableSize(path, display.width, display.height);
  if (static_cast<std::int64_t>(display.width) * display.height > kMostDisplayTimesData * frame.width * frame.height) {
    throw pictureError(path, "the display window is far larger than the picture in it");
  }
}

}  // namespace

StoredPicture readExrPhotograph(const std::filesystem::path& path, const PhotographRules& rules) {
  const ExrFrame frame = readExrFrame(path);
  requireReadableDisplay(path, frame);
  const DisplayWindow& display = frame.display;
  const std::uint64_t most = 4 * sizeof(float);  // of a pixel in the file and of one on display
  requireMemoryFor(path, static_cast<std::uint64_t>(frame.width) * static_cast<std::uint64_t>(frame.height) * most +
                             static_cast<std::uint64_t>(display.width) * static_cast<std::uint64_t>(display.height) *
                                 (most + static_cast<std::uint64_t>(rules.bytesForUse)));
  ExrFile file = readExr(path, exrColours(rules), {.coloursOnly = true, .edited = rules.editedPictures()});
  const auto planes = planesOf(path, file.image, frame.channels);
  StoredPicture stored;
  stored.picture.width = display.width;
  stored.picture.height = display.height;
  stored.picture.channels = static_cast<int>(planes.size());
  std::vector<float> samples(planes.size() * stored.picture.pixels());

  // In 64 bits: windows may lie anywhere.
  const auto begin = [](int offset) { return std::max<std::int64_t>(0, -std::int64_t{offset}); };
  const auto end = [](int size, int offset, int full) {
    return std::min<std::int64_t>(full, std::int64_t{size} - std::int64_t{offset});
  };
  const std::int64_t left = begin(display.left), right = end(file.image.width, display.left, display.width);
  for (std::int64_t y = begin(display.top); y < end(file.image.height, display.top, display.height); ++y) {
    const std::int64_t from = (y + display.top) * file.image.width + display.left;
    for (std::int64_t x = left; x < right; ++x) {
      float* to = samples.data() + static_cast<std::size_t>(y * display.width + x) * planes.size();
      for (const std::vector<float>* plane : planes) *to++ = (*plane)[static_cast<std::size_t>(from + x)];
    }
  }
  stored.picture.samples = std::move(samples);
  stored.picture.text = std::move(file.attributes);
  return stored;
}

}  // namespace parhelion
