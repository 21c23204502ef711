// SPDX-License-Identifier: Apache-2.0
#include "picture/photograph.h"

#include <array>
#include <cerrno>
#include <fstream>
#include <new>
#include <string_view>
#include <system_error>

#include "picture/exr_photograph.h"
#include "picture/file_reason.h"
#include "picture/jpeg.h"
#include "picture/png_read.h"
#include "picture/stored_picture.h"
#include "picture/upright.h"

namespace parhelion {
namespace {

/// The first bytes of a regular file; a shorter file gives zeros.
std::array<char, 8> firstBytes(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (error) throw pictureError(path, reasonFor(path, error.value()));
  if (!std::filesystem::is_regular_file(status)) throw pictureError(path, "not a regular file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw pictureError(path, reasonFor(path, errno));
  std::array<char, 8> bytes{};
  stream.read(bytes.data(), bytes.size());
  return bytes;
}

constexpr std::string_view kJpegStart = "\xff\xd8\xff", kPngStart = "\x89PNG\r\n\x1a\n", kExrStart = "\x76\x2f\x31\x01";

StoredPicture readStored(const std::filesystem::path& path, const PhotographRules& rules) {
  const std::array<char, 8> first = firstBytes(path);
  const std::string_view start(first.data(), first.size());
  if (start.starts_with(kJpegStart)) return readJpeg(path, rules.bytesForUse);
  if (start == kPngStart) return readPng(path, rules.bytesForUse);
  if (start.starts_with(kExrStart)) return readExrPhotograph(path, rules);
  throw pictureError(path, "not a JPEG, PNG or EXR file");
}

}  // namespace

ExrColours exrColours(const PhotographRules& rules) {
  return rules.assumeSrgb ? ExrColours::asStored : ExrColours::rec709;
}

Photograph readPhotograph(const std::filesystem::path& path, const PhotographRules& rules) {
  try {
    StoredPicture stored = readStored(path, rules);
    if (!stored.objection.empty() && !rules.assumeSrgb) {
      throw pictureError(path, stored.objection + "; convert it, or say --assume-srgb to take them as they are");
    }
    stored.picture.exif = readExif(stored.exif);
    turnUpright(stored.picture, stored.picture.exif.orientation);
    return std::move(stored.picture);
  } catch (const std::bad_alloc&) {
    throw pictureError(path, "not enough memory");
  }
}

Photograph readPhotographHeader(const std::filesystem::path& path) {
  const std::array<char, 8> first = firstBytes(path);
  const std::string_view start(first.data(), first.size());
  if (!start.starts_with(kJpegStart) && start != kPngStart) throw pictureError(path, "not a JPEG or PNG file");
  StoredPicture stored = start == kPngStart ? readPngFrame(path) : readJpegFrame(path);
  stored.picture.exif = readExif(stored.exif);
  turnUpright(stored.picture, stored.picture.exif.orientation);
  return std::move(stored.picture);
}

}  // namespace parhelion
