// SPDX-License-Identifier: Apache-2.0
#include "picture/file_kind.h"

#include <array>
#include <fstream>
#include <system_error>

namespace parhelion {
namespace {

using Family = FileKind::Family;

struct Signature {
  std::size_t at;  // bytes from the start
  std::string_view bytes;
  FileKind kind;
};

// As the formats' specifications have them; the more special ones first.
constexpr std::array kSignatures{
    Signature{0, {"\xff\xd8\xff", 3}, {Family::jpeg, "a JPEG picture"}},
    Signature{0, {"\x89PNG\r\n\x1a\n", 8}, {Family::png, "a PNG picture"}},
    Signature{0, {"\x76\x2f\x31\x01", 4}, {Family::exr, "an EXR picture"}},
    Signature{0, {"GIF8", 4}, {Family::otherPicture, "a GIF picture"}},
    Signature{8, {"CR\x02", 3}, {Family::otherPicture, "a camera's raw file (CR2)"}},
    Signature{0, {"II*\0", 4}, {Family::otherPicture, "a TIFF picture or a camera's raw file"}},
    Signature{0, {"MM\0*", 4}, {Family::otherPicture, "a TIFF picture or a camera's raw file"}},
    Signature{0, {"FUJIFILMCCD-RAW", 15}, {Family::otherPicture, "a camera's raw file (RAF)"}},
    Signature{4, {"ftypcrx", 7}, {Family::otherPicture, "a camera's raw file (CR3)"}},
    Signature{4, {"ftypavif", 8}, {Family::otherPicture, "an AVIF picture"}},
    Signature{4, {"ftyphei", 7}, {Family::otherPicture, "a HEIC picture"}},
    Signature{4, {"ftypmif1", 8}, {Family::otherPicture, "a HEIC picture"}},
    Signature{4, {"JXL \r\n\x87\n", 8}, {Family::otherPicture, "a JPEG XL picture"}},
    Signature{0, {"\xff\x0a", 2}, {Family::otherPicture, "a JPEG XL picture"}},
    Signature{4, {"jP  \r\n\x87\n", 8}, {Family::otherPicture, "a JPEG 2000 picture"}},
    Signature{8, {"WEBP", 4}, {Family::otherPicture, "a WebP picture"}},
    Signature{0, {"#?RADIANCE", 10}, {Family::otherPicture, "a Radiance HDR picture"}},
    Signature{0, {"#?RGBE", 6}, {Family::otherPicture, "a Radiance HDR picture"}},
    Signature{0, {"8BPS", 4}, {Family::otherPicture, "a Photoshop picture"}},
    Signature{0, {"BM", 2}, {Family::otherPicture, "a BMP picture"}},
    Signature{0, {"%PDF-", 5}, {Family::otherBinary, "a PDF document"}},
    Signature{0, {"PK\x03\x04", 4}, {Family::otherBinary, "a ZIP archive or an office document"}},
    Signature{0, {"\x1f\x8b", 2}, {Family::otherBinary, "a gzip archive"}},
    Signature{0, {"\177ELF", 4}, {Family::otherBinary, "a program"}},
};

constexpr std::size_t kStartBytes = 512;  // reaches the zeros that every binary file has early

/// Formats whose names are plain letters are such only if more than text follows.
bool fits(const Signature& signature, std::string_view start) {
  if (start.size() < signature.at || !start.substr(signature.at).starts_with(signature.bytes)) return false;
  return signature.bytes != "BM" || start.find('\0') != std::string_view::npos;
}

}  // namespace

FileKind kindOf(std::string_view start) {
  if (start.empty()) return {Family::empty, "an empty file"};
  for (const Signature& signature : kSignatures)
    if (fits(signature, start)) return signature.kind;
  const bool isUtf16 = start.starts_with("\xff\xfe") || start.starts_with("\xfe\xff");
  if (isUtf16 || start.find('\0') == std::string_view::npos) return {Family::text, "a text file"};
  return {Family::otherBinary, "a binary file"};
}

std::string startOfFile(const std::filesystem::path& path) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) return {};
  std::string start(kStartBytes, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  return start;
}

}  // namespace parhelion
