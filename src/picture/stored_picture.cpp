// SPDX-License-Identifier: Apache-2.0
#include "picture/stored_picture.h"

#include <algorithm>

#include "picture/image.h"

namespace parhelion {

std::runtime_error pictureError(const std::filesystem::path& path, std::string reason) {
  std::replace_if(
      reason.begin(), reason.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return std::runtime_error(path.string() + ": " + reason);
}

void requireReadableSize(const std::filesystem::path& path, std::int64_t width, std::int64_t height) {
  if (width < 1 || height < 1) throw pictureError(path, "the picture has no pixels");
  if (width <= kMaxImageSide && height <= kMaxImageSide && width * height <= kMaxPhotographPixels) return;
  throw pictureError(path, "the picture is too large: " + std::to_string(width) + " x " + std::to_string(height) +
                               " pixels; at most " + std::to_string(kMaxImageSide) + " a side and " +
                               std::to_string(kMaxPhotographPixels) + " in all");
}

void requireFileBytes(const std::filesystem::path& path, std::uint64_t have, std::uint64_t need) {
  if (have < need) throw pictureError(path, "the header promises more pixels than the file can hold");
}

}  // namespace parhelion
