// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "picture/exif.h"

namespace parhelion {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

enum Type : std::uint32_t {
  kByte = 1,
  kAscii,
  kShort,
  kLong,
  kRational,
  kUndefined = 7,
  kSignedLong = 9,
  kSignedRational,
  kDouble = 12
};

// Right behind the header.
constexpr std::size_t kFirstDirectory = 8;

/// Writes TIFF in either byte order: a header, then directories one after the other, each followed by its values.
class Tiff {
 public:
  explicit Tiff(bool bigEndian) : bigEndian_(bigEndian) {
    bytes_ = bigEndian ? Bytes{'M', 'M'} : Bytes{'I', 'I'};
    append(42, 2);
    append(kFirstDirectory, 4);
  }

  struct Field {
    std::uint32_t tag, type, count;
    std::vector<std::uint32_t> words;  // bytes, shorts or longs; a fraction is two
  };

  /// The offset of a directory that is appended.
  std::uint32_t directory(const std::vector<Field>& fields) {
    const auto at = static_cast<std::uint32_t>(bytes_.size());
    std::size_t valuesAt = at + 2 + 12 * fields.size() + 4;
    append(static_cast<std::uint32_t>(fields.size()), 2);
    Bytes values;
    for (const Field& field : fields) {
      append(field.tag, 2);
      append(field.type, 2);
      append(field.count, 4);
      Bytes value;
      for (const std::uint32_t word : field.words) put(value, word, wordBytes(field.type));
      if (value.size() > 4) {
        append(static_cast<std::uint32_t>(valuesAt + values.size()), 4);
        values.insert(values.end(), value.begin(), value.end());
      } else {
        value.resize(4);
        bytes_.insert(bytes_.end(), value.begin(), value.end());
      }
    }
    append(0, 4);
    bytes_.insert(bytes_.end(), values.begin(), values.end());
    return at;
  }

  Bytes& bytes() { return bytes_; }

  void put(Bytes& to, std::uint32_t value, std::size_t count) const {
    for (std::size_t k = 0; k < count; ++k)
      to.push_back(static_cast<std::uint8_t>(value >> 8 * (bigEndian_ ? count - 1 - k : k)));
  }

 private:
  static std::size_t wordBytes(std::uint32_t type) {
    return type <= kAscii || type == kUndefined ? 1 : type == kShort ? 2 : 4;
  }
  void append(std::uint32_t value, std::size_t count) { put(bytes_, value, count); }

  bool bigEndian_;
  Bytes bytes_;
};

Tiff::Field text(std::uint32_t tag, const std::string& s) {
  Tiff::Field field{tag, kAscii, static_cast<std::uint32_t>(s.size() + 1), {}};
  for (const char c : s) field.words.push_back(static_cast<std::uint8_t>(c));
  field.words.push_back(0);
  return field;
}

/// A block with the picture's fields and, reached from them, the camera's.
Bytes block(bool bigEndian, std::vector<Tiff::Field> picture, const std::vector<Tiff::Field>& camera) {
  // The picture's directory with its values in front of the camera's: written twice, once to learn where it ends.
  picture.push_back({0x8769, kLong, 1, {0}});
  Tiff trial(bigEndian);
  trial.directory(picture);
  picture.back().words = {static_cast<std::uint32_t>(trial.bytes().size())};
  Tiff tiff(bigEndian);
  tiff.directory(picture);
  tiff.directory(camera);
  return tiff.bytes();
}

const std::vector<Tiff::Field> kPicture = {text(0x010F, "ACME Optical"), text(0x0110, "X1"), {0x0112, kShort, 1, {6}}};
const std::vector<Tiff::Field> kCamera = {{0x920A, kRational, 1, {425, 100}}, {0xA002, kLong, 1, {4032}},
                                          {0xA003, kShort, 1, {3024}},        {0xA20E, kRational, 1, {18000, 1}},
                                          {0xA20F, kRational, 1, {9000, 2}},  {0xA210, kShort, 1, {3}},
                                          {0xA404, kRational, 1, {3, 2}},     {0xA405, kShort, 1, {28}}};

Exif expected() {
  Exif exif;
  exif.orientation = 6;
  exif.focalLength = 4.25;
  exif.focalLength35mm = 28.0;
  exif.focalPlaneX = 18000.0;
  exif.focalPlaneY = 4500.0;
  exif.focalPlaneUnit = 3;
  exif.digitalZoom = 1.5;
  exif.pixelWidth = 4032;
  exif.pixelHeight = 3024;
  exif.make = "ACME Optical";
  exif.model = "X1";
  return exif;
}

Exif readCamera(const std::vector<Tiff::Field>& camera) { return readExif(block(true, {}, camera)); }

/// A block with the notes of a maker: a directory of this field behind `heading`, in the same or the other byte order.
/// It reads like the rest of the block, with offsets from the block's start.
Bytes blockWithNote(bool bigEndian, bool sameOrder, const std::string& make, const std::string& heading,
                    const Tiff::Field& field) {
  std::vector<Tiff::Field> camera = {{0x927C, kUndefined, 0, {}}};
  const std::vector<Tiff::Field> picture = {text(0x010F, make)};
  Bytes note(heading.begin(), heading.end());
  const std::size_t noteAt = block(bigEndian, picture, camera).size();
  const Tiff order(bigEndian == sameOrder);
  const auto put = [&](std::size_t value, std::size_t count) {
    order.put(note, static_cast<std::uint32_t>(value), count);
  };
  put(1, 2);
  put(field.tag, 2);
  put(field.type, 2);
  put(field.count, 4);
  put(noteAt + heading.size() + 2 + 12 + 4, 4);
  put(0, 4);
  for (const std::uint32_t word : field.words) put(word, field.type == kShort ? 2 : 4);
  camera[0].count = static_cast<std::uint32_t>(note.size());
  camera[0].words.assign(note.begin(), note.end());
  return block(bigEndian, picture, camera);
}

const std::string kSonyHeading("SONY DSC \0\0\0", 12);
const Tiff::Field kCanonSize{0x0026, kShort, 8, {96, 2, 9, 9, 5472, 3648, 5472, 3648}};
const Tiff::Field kOldCanonSize{0x0012, kShort, 6, {9, 9, 3504, 2336, 3504, 2336}};
const Tiff::Field kSonySize{0xB02B, kLong, 2, {3376, 6000}};

/// A copy of its own size on the heap, so that the address sanitizer sees any step outside it.
Exif readExact(const Bytes& bytes) { return readExif(Bytes(bytes)); }

}  // namespace

TEST_CASE("Exif of either byte order says the same") {
  CHECK(readExif(block(false, kPicture, kCamera)) == expected());
  CHECK(readExif(block(true, kPicture, kCamera)) == expected());
}

TEST_CASE("the notes of Canon and Sony tell the size that a picture had in the camera") {
  for (const bool bigEndian : {false, true}) {
    for (const bool sameOrder : {false, true}) {
      const auto sizes = [&](const std::string& make, const std::string& heading, const Tiff::Field& field) {
        return readExact(blockWithNote(bigEndian, sameOrder, make, heading, field)).sizesTaken;
      };
      CHECK(sizes("Canon", "", kCanonSize) == std::vector<PictureSize>{{5472, 3648}});
      CHECK(sizes("Canon", "", kOldCanonSize) == std::vector<PictureSize>{{3504, 2336}});
      CHECK(sizes("SONY", kSonyHeading, kSonySize) == std::vector<PictureSize>{{6000, 3376}});
      CHECK(sizes("NIKON", "", kCanonSize).empty());
      CHECK(sizes("SONY", "", kSonySize).empty());
    }
  }
}

TEST_CASE("notes of a maker that are cut off, too short a list or no numbers tell no size") {
  const auto sizes = [](const Tiff::Field& field) {
    return readExact(blockWithNote(true, true, "Canon", "", field)).sizesTaken;
  };
  CHECK(sizes({0x0026, kShort, 5, {96, 2, 9, 9, 5472}}).empty());
  CHECK(sizes({0x0026, kShort, 8, {96, 2, 9, 9, 0, 0, 0, 0}}).empty());
  CHECK(sizes({0x0026, kSignedLong, 6, {96, 2, 9, 9, 5472, 3648}}).empty());
  CHECK(sizes({0x0026, kShort, 0xFFFFFFFF, {96, 2, 9, 9, 5472, 3648}}).empty());
  const Bytes whole = blockWithNote(true, true, "Canon", "", kCanonSize);
  for (std::size_t length = 0; length < whole.size(); ++length)
    CHECK(readExact(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length))).sizesTaken.empty());
  CHECK(readExact(blockWithNote(true, true, "SONY", "SONY DSC ", kSonySize)).sizesTaken.empty());
}

TEST_CASE("the interoperability directory tells the size that a picture had in the camera") {
  for (const bool bigEndian : {false, true}) {
    Tiff tiff(bigEndian);
    const std::vector<Tiff::Field> interoperability = {{0x1001, kShort, 1, {4000}}, {0x1002, kLong, 1, {3000}}};
    const std::uint32_t camera = kFirstDirectory + 2 + 12 + 4;
    tiff.directory({{0x8769, kLong, 1, {camera}}});
    tiff.directory({{0xA005, kLong, 1, {camera + 2 + 12 + 4}}});
    tiff.directory(interoperability);
    CHECK(readExact(tiff.bytes()).sizesTaken == std::vector<PictureSize>{{4000, 3000}});
    Bytes cut = tiff.bytes();
    cut.resize(cut.size() - 10);
    CHECK(readExact(cut).sizesTaken.empty());
  }
}

TEST_CASE("a focal length is returned as it is written, however absurd") {
  const auto focal = [](std::uint32_t type, std::uint32_t a, std::uint32_t b) {
    return readCamera({{0x920A, type, 1, {a, b}}}).focalLength;
  };
  CHECK(focal(kRational, 0, 7) == 0.0);
  CHECK(focal(kRational, 50, 0) == kInfinity);
  CHECK(focal(kSignedRational, 0xFFFFFFCE, 0) == -kInfinity);
  CHECK(focal(kSignedRational, 0xFFFFFFCE, 1) == -50.0);
  CHECK(focal(kRational, 0xFFFFFFCE, 1) == 4294967246.0);
  CHECK_FALSE(focal(kRational, 0, 0).has_value());
  CHECK(readCamera({{0xA405, kShort, 1, {0}}}).focalLength35mm == 0.0);
}

TEST_CASE("Exif numbers are taken from every type that holds one") {
  const auto width = [](std::uint32_t type, std::vector<std::uint32_t> words) {
    return readCamera({{0xA002, type, 1, std::move(words)}}).pixelWidth;
  };
  CHECK(width(kByte, {200}) == 200);
  CHECK(width(kShort, {60000}) == 60000);
  CHECK(width(kLong, {70000}) == 70000);
  CHECK(width(kSignedLong, {0xFFFFFFFF}) == -1);
  CHECK(width(kRational, {9000, 3}) == 3000);
  CHECK(readCamera({{0xA405, kRational, 1, {57, 2}}}).focalLength35mm == 28.5);
}

TEST_CASE("Exif values of another type or number than they should have are passed over") {
  CHECK_FALSE(readCamera({text(0xA002, "4032")}).pixelWidth.has_value());
  CHECK_FALSE(readCamera({{0xA002, kLong, 2, {4032, 4032}}}).pixelWidth.has_value());
  CHECK_FALSE(readCamera({{0xA002, kLong, 0, {4032}}}).pixelWidth.has_value());
  CHECK_FALSE(readCamera({{0xA002, kRational, 1, {1, 2}}}).pixelWidth.has_value());
  CHECK_FALSE(readCamera({{0xA002, kLong, 1, {0xFFFFFFFF}}}).pixelWidth.has_value());
  CHECK_FALSE(readCamera({{0x920A, kDouble, 1, {0, 0}}}).focalLength.has_value());
  CHECK_FALSE(readCamera({{0x920A, 0xFFFF, 1, {0, 0}}}).focalLength.has_value());
  CHECK(readCamera({{0xA210, kRational, 1, {0, 0}}}).focalPlaneUnit == 2);
  for (const std::uint32_t orientation : {0u, 9u, 65535u})
    CHECK(readExif(block(false, {{0x0112, kShort, 1, {orientation}}}, {})).orientation == 1);
  CHECK(readExif(block(false, {{0x010F, kShort, 1, {65}}}, {})).make.empty());
}

TEST_CASE("Exif texts are printable, without padding and no longer than 64 characters") {
  const auto make = [](const std::string& s) { return readExif(block(true, {text(0x010F, s)}, {})).make; };
  CHECK(make("Nik\x1B[2Jon\xFF\n") == "Nik?[2Jon??");
  CHECK(make("NIKON CORPORATION   ") == "NIKON CORPORATION");
  CHECK(make("    ").empty());
  CHECK(make(std::string("A\0B", 3)) == "A");
  CHECK(make(std::string(500, 'x')) == std::string(64, 'x'));
}

TEST_CASE("a picture was taken when the camera says so, else when the file was made") {
  const Tiff::Field changed = text(0x0132, "2025:02:03 04:05:06"), taken = text(0x9003, "2024:01:31 12:00:00");
  CHECK(readExif(block(true, {changed}, {})).taken == "2025:02:03 04:05:06");
  CHECK(readExif(block(true, {changed}, {taken})).taken == "2024:01:31 12:00:00");
  CHECK(readExif(block(false, {}, {})).taken.empty());
}

TEST_CASE("Exif fields whose value lies outside the block are passed over and their neighbours read") {
  for (const bool bigEndian : {false, true}) {
    for (const std::uint32_t offset : {0x00010000u, 0x7FFFFFFFu, 0xFFFFFFF8u, 0xFFFFFFFFu}) {
      Bytes bytes = block(bigEndian, {}, kCamera);
      // The picture's directory has one field; the focal length is the first of the camera's.
      const std::size_t value = kFirstDirectory + 2 + 12 + 4 + 2 + 8;
      Bytes written;
      Tiff(bigEndian).put(written, offset, 4);
      std::copy(written.begin(), written.end(), bytes.begin() + static_cast<std::ptrdiff_t>(value));
      const Exif exif = readExact(bytes);
      CHECK_FALSE(exif.focalLength.has_value());
      CHECK(exif.focalLength35mm == 28.0);
    }
  }
}

TEST_CASE("Exif counts of four thousand million are passed over") {
  constexpr std::uint32_t kCount = 0xFFFFFFFF;
  for (const std::uint32_t type : {kByte, kAscii, kShort, kLong, kRational, kSignedRational}) {
    const std::vector<Tiff::Field> picture = {{0x010F, type, kCount, {65, 66}}, {0x0112, kShort, 1, {3}}};
    const std::vector<Tiff::Field> camera = {{0x920A, type, kCount, {1, 1}}, {0xA405, kShort, 1, {35}}};
    const Exif exif = readExact(block(false, picture, camera));
    CHECK(exif.make.empty());
    CHECK(exif.orientation == 3);
    CHECK_FALSE(exif.focalLength.has_value());
    CHECK(exif.focalLength35mm == 35.0);
  }
}

TEST_CASE("an Exif directory that points to itself is read once as each of the two") {
  Tiff tiff(true);
  tiff.directory({{0x0112, kShort, 1, {8}}, {0x8769, kLong, 1, {kFirstDirectory}}, {0xA405, kShort, 1, {24}}});
  // Its link to the next directory leads back to it, too.
  tiff.bytes().resize(tiff.bytes().size() - 4);
  tiff.put(tiff.bytes(), kFirstDirectory, 4);
  const Exif exif = readExact(tiff.bytes());
  CHECK(exif.orientation == 8);
  CHECK(exif.focalLength35mm == 24.0);
}

TEST_CASE("what is no Exif says nothing") {
  CHECK(readExif({}) == Exif{});
  CHECK(readExact(Bytes(100, 0xFF)) == Exif{});
  Bytes bytes = block(false, kPicture, kCamera);
  bytes[2] = 43;
  CHECK(readExact(bytes) == Exif{});
  for (const std::uint32_t offset : {0u, 0xFFFFu, 0xFFFFFFFFu}) {
    Tiff tiff(true);
    tiff.bytes().resize(4);
    tiff.put(tiff.bytes(), offset, 4);
    CHECK(readExact(tiff.bytes()) == Exif{});
  }
}

TEST_CASE("Exif cut off at any byte says nothing that the whole does not say") {
  for (const bool bigEndian : {false, true}) {
    const Bytes whole = block(bigEndian, kPicture, kCamera);
    const Exif all = readExif(whole);
    for (std::size_t length = 0; length < whole.size(); ++length) {
      CAPTURE(length);
      const Exif exif = readExact(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)));
      const auto missingOrSame = [](const auto& part, const auto& full) { return !part || part == full; };
      CHECK((exif.orientation == 1 || exif.orientation == all.orientation));
      CHECK(missingOrSame(exif.focalLength, all.focalLength));
      CHECK(missingOrSame(exif.focalLength35mm, all.focalLength35mm));
      CHECK(missingOrSame(exif.focalPlaneX, all.focalPlaneX));
      CHECK(missingOrSame(exif.pixelHeight, all.pixelHeight));
      CHECK((exif.make.empty() || exif.make == all.make));
    }
  }
}

TEST_CASE("Exif bent in twenty thousand ways is read to the end") {
  const std::vector<Bytes> seeds = {block(false, kPicture, kCamera), block(true, kPicture, kCamera)};
  std::mt19937 random(5);
  const auto below = [&](std::size_t n) { return std::size_t{random()} % n; };
  std::size_t focalLengths = 0;
  for (int k = 0; k < 20000; ++k) {
    Bytes bytes = seeds[below(seeds.size())];
    for (std::size_t flips = below(8); flips > 0; --flips)
      bytes[below(bytes.size())] = static_cast<std::uint8_t>(random());
    if (below(4) == 0) {
      const Bytes& other = seeds[below(seeds.size())];
      const std::size_t from = below(other.size()), count = below(other.size() - from), at = below(bytes.size());
      const auto first = other.begin() + static_cast<std::ptrdiff_t>(from);
      bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), first, first + static_cast<std::ptrdiff_t>(count));
    }
    if (below(4) == 0) bytes.resize(below(bytes.size()));
    const Exif exif = readExact(bytes);
    CHECK_MESSAGE((exif.orientation >= 1 && exif.orientation <= 8), k);
    CHECK_MESSAGE(exif.make.size() <= 64, k);
    if (exif.focalLength) ++focalLengths;
  }
  // The blocks are bent, not all broken: most of them still say something, and many do not.
  CHECK(focalLengths > 5000);
  CHECK(focalLengths < 18000);
}

}  // namespace parhelion
