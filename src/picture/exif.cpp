// SPDX-License-Identifier: Apache-2.0
#include "picture/exif.h"

#include <algorithm>
#include <limits>
#include <string_view>
#include <vector>

namespace parhelion {
namespace {

// Only names of makers and models and dates are read; longer ones are none.
constexpr std::size_t kMaxText = 64;

constexpr std::size_t kHeaderBytes = 8;  // byte order, the number 42, offset of the first directory
constexpr std::size_t kFieldBytes = 12;  // tag, type, count, value or its offset

// Types of values by their number in TIFF 6.0.
enum Type : std::uint32_t {
  kByte = 1,
  kAscii,
  kShort,
  kLong,
  kRational,
  kUndefined = 7,
  kSignedLong = 9,
  kSignedRational
};

struct Block {
  std::span<const std::uint8_t> bytes;
  bool bigEndian;

  bool holds(std::uint64_t at, std::uint64_t count) const { return at <= bytes.size() && count <= bytes.size() - at; }

  /// The unsigned number of `count` bytes at a place that holds it.
  std::uint32_t number(std::size_t at, std::size_t count) const {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < count; ++k) value = value << 8 | bytes[at + (bigEndian ? k : count - 1 - k)];
    return value;
  }
};

/// One entry of a directory; all of its value lies in the block, from `at` on.
struct Field {
  std::uint32_t tag, type, count;
  std::size_t at;
};

/// Bytes of one value; 0 for types that nothing here is written in.
std::uint64_t sizeOf(std::uint32_t type) {
  switch (type) {
    case kByte:
    case kAscii:
    case kUndefined:
      return 1;
    case kShort:
      return 2;
    case kLong:
    case kSignedLong:
      return 4;
    case kRational:
    case kSignedRational:
      return 8;
    default:
      return 0;
  }
}

/// The fields of the directory at an offset, as far as they and their values lie in the block. Its link to a next
/// directory is not followed.
std::vector<Field> directoryAt(const Block& block, std::size_t at) {
  std::vector<Field> fields;
  if (!block.holds(at, 2)) return fields;
  const std::size_t stated = block.number(at, 2);
  at += 2;
  for (std::size_t k = 0; k < stated && block.holds(at, kFieldBytes); ++k, at += kFieldBytes) {
    Field field{block.number(at, 2), block.number(at + 2, 2), block.number(at + 4, 4), at + 8};
    const std::uint64_t bytes = sizeOf(field.type) * field.count;
    // Values of up to four bytes stand in the place of their offset.
    if (bytes > 4) field.at = block.number(at + 8, 4);
    if (bytes > 0 && block.holds(field.at, bytes)) fields.push_back(field);
  }
  return fields;
}

/// A single number, infinite where a fraction's denominator is 0; none for texts, lists and 0/0.
std::optional<double> numberIn(const Block& block, const Field& field) {
  if (field.count != 1 || field.type == kAscii || field.type == kUndefined) return std::nullopt;
  const bool isFraction = field.type == kRational || field.type == kSignedRational;
  const bool isSigned = field.type == kSignedLong || field.type == kSignedRational;
  const auto whole = [&](std::size_t at) {
    const std::uint32_t bits = block.number(at, isFraction ? 4 : sizeOf(field.type));
    return isSigned ? static_cast<double>(static_cast<std::int32_t>(bits)) : static_cast<double>(bits);
  };
  const double numerator = whole(field.at);
  if (!isFraction) return numerator;
  const double denominator = whole(field.at + 4);
  if (denominator != 0.0) return numerator / denominator;
  if (numerator == 0.0) return std::nullopt;
  return numerator > 0.0 ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
}

/// The same as an int; none for fractions and what an int does not hold.
std::optional<int> integerIn(const Block& block, const Field& field) {
  const std::optional<double> number = numberIn(block, field);
  if (!number || !(*number >= std::numeric_limits<int>::min() && *number <= std::numeric_limits<int>::max())) return {};
  const int whole = static_cast<int>(*number);
  return static_cast<double>(whole) == *number ? std::optional(whole) : std::nullopt;
}

/// Text up to its first NUL without the blanks that follow it; what cannot be printed becomes '?'.
std::string textIn(const Block& block, const Field& field) {
  if (field.type != kAscii) return {};
  std::string text;
  for (const std::uint8_t c : block.bytes.subspan(field.at, std::min<std::size_t>(field.count, kMaxText))) {
    if (c == 0) break;
    text += c >= 0x20 && c < 0x7F ? static_cast<char>(c) : '?';
  }
  text.resize(text.find_last_not_of(' ') + 1);
  return text;
}

/// Fields of the picture itself: make, model, date and how it was held. Returns where the Exif directory is.
std::optional<std::size_t> readPicture(const Block& block, std::size_t at, Exif& exif) {
  std::optional<std::size_t> exifAt;
  for (const Field& field : directoryAt(block, at)) {
    if (field.tag == 0x010F) exif.make = textIn(block, field);
    if (field.tag == 0x0110) exif.model = textIn(block, field);
    if (field.tag == 0x0132) exif.taken = textIn(block, field);
    if (field.tag == 0x0112) {
      const int orientation = integerIn(block, field).value_or(1);
      exif.orientation = orientation >= 1 && orientation <= 8 ? orientation : 1;
    }
    if (field.tag == 0x8769 && field.type == kLong && field.count == 1) exifAt = block.number(field.at, 4);
  }
  return exifAt;
}

/// Adds a size unless it is none.
void addSize(std::vector<PictureSize>& sizes, std::optional<int> width, std::optional<int> height) {
  if (width.value_or(0) > 0 && height.value_or(0) > 0) sizes.push_back({*width, *height});
}

/// A number out of a list of shorts or longs; none beyond its end.
std::optional<int> integerOf(const Block& block, const Field& list, std::size_t index) {
  const std::size_t size = sizeOf(list.type);
  if ((list.type != kShort && list.type != kLong) || index >= list.count) return std::nullopt;
  return integerIn(block, {list.tag, list.type, 1, list.at + index * size});
}

/// Where the notes of a maker tell the picture's size: the field, and the places of width and height in its list.
struct SizeInNote {
  std::uint32_t tag;
  std::size_t width, height;
};

// As ExifTool documents them: Canon's AFInfo2 and AFInfo, Sony's FullImageSize.
constexpr SizeInNote kCanonSizes[] = {{0x0026, 4, 5}, {0x0012, 2, 3}};
constexpr SizeInNote kSonySizes[] = {{0xB02B, 1, 0}};

/// The sizes that a maker's note tells. The notes of Canon are a directory, those of Sony one behind twelve bytes; both
/// count offsets as the block does.
void readMakerNote(Block block, const Field& note, Exif& exif) {
  std::span<const SizeInNote> places;
  std::size_t at = note.at;
  const auto text = [&] { return std::string_view(reinterpret_cast<const char*>(&block.bytes[at]), note.count); };
  if (exif.make.starts_with("Canon")) places = kCanonSizes;
  if (text().starts_with("SONY DSC ") || text().starts_with("SONY CAM ")) places = kSonySizes, at += 12;
  if (places.empty() || !block.holds(at, 2)) return;

  // Programs that write the block anew in the other byte order leave the notes as they are.
  constexpr std::uint32_t kManyFields = 255;
  if (block.number(at, 2) > kManyFields) block.bigEndian = !block.bigEndian;
  for (const Field& field : directoryAt(block, at)) {
    for (const SizeInNote& place : places) {
      if (field.tag == place.tag)
        addSize(exif.sizesTaken, integerOf(block, field, place.width), integerOf(block, field, place.height));
    }
  }
}

/// The size that the interoperability directory tells.
void readInteroperability(const Block& block, std::size_t at, Exif& exif) {
  std::optional<int> width, height;
  for (const Field& field : directoryAt(block, at)) {
    if (field.tag == 0x1001) width = integerIn(block, field);
    if (field.tag == 0x1002) height = integerIn(block, field);
  }
  addSize(exif.sizesTaken, width, height);
}

/// Fields of the Exif directory: the date, the lens and the sensor.
void readCamera(const Block& block, std::size_t at, Exif& exif) {
  for (const Field& field : directoryAt(block, at)) {
    switch (field.tag) {
      case 0x9003:
        exif.taken = textIn(block, field);
        break;
      case 0x920A:
        exif.focalLength = numberIn(block, field);
        break;
      case 0xA405:
        exif.focalLength35mm = numberIn(block, field);
        break;
      case 0xA20E:
        exif.focalPlaneX = numberIn(block, field);
        break;
      case 0xA20F:
        exif.focalPlaneY = numberIn(block, field);
        break;
      case 0xA210:
        exif.focalPlaneUnit = integerIn(block, field).value_or(2);
        break;
      case 0xA404:
        exif.digitalZoom = numberIn(block, field);
        break;
      case 0x927C:
        readMakerNote(block, field, exif);
        break;
      case 0xA005:
        if (field.type == kLong && field.count == 1) readInteroperability(block, block.number(field.at, 4), exif);
        break;
      case 0xA002:
        exif.pixelWidth = integerIn(block, field);
        break;
      case 0xA003:
        exif.pixelHeight = integerIn(block, field);
        break;
    }
  }
}

}  // namespace

Exif readExif(std::span<const std::uint8_t> tiff) {
  Exif exif;
  if (tiff.size() < kHeaderBytes) return exif;
  const bool bigEndian = tiff[0] == 'M' && tiff[1] == 'M';
  if (!bigEndian && !(tiff[0] == 'I' && tiff[1] == 'I')) return exif;
  const Block block{tiff, bigEndian};
  if (block.number(2, 2) != 42) return exif;

  // These directories and what they name by a tag of its own, so that there are no circles to turn in.
  const std::optional<std::size_t> exifAt = readPicture(block, block.number(4, 4), exif);
  if (exifAt) readCamera(block, *exifAt, exif);
  return exif;
}

}  // namespace parhelion
