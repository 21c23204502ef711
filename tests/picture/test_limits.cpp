// SPDX-License-Identifier: Apache-2.0
// Files of a few bytes that ask for gigabytes.
#include <doctest/doctest.h>

#include "memory_taken.h"
#include "picture/exr.h"
#include "picture/limits.h"
#include "picture/memory_limit.h"
#include "picture/photograph.h"
#include "picture_files.h"
#include "temporary_directory.h"

namespace parhelion {
namespace {

constexpr int kFew = 16;  // MB

std::string littleEndian(std::uint32_t number, int bytes = 4) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text.push_back(static_cast<char>(number >> 8 * i));
  return text;
}

std::string exrAttribute(const std::string& name, const std::string& type, const std::string& value) {
  const std::string zero(1, '\0');
  return name + zero + type + zero + littleEndian(static_cast<std::uint32_t>(value.size())) + value;
}

/// A header of one half channel and a picture of so many pixels a side, with more attributes.
std::string exrHeader(const std::string& more, std::uint32_t side = 32768) {
  const std::string zero(1, '\0'),
      window = littleEndian(0) + littleEndian(0) + littleEndian(side - 1) + littleEndian(side - 1);
  const std::string channel = "Y" + zero + littleEndian(1) + littleEndian(0) + littleEndian(1) + littleEndian(1) + zero;
  return exrAttribute("channels", "chlist", channel) + exrAttribute("compression", "compression", zero) +
         exrAttribute("dataWindow", "box2i", window) + exrAttribute("displayWindow", "box2i", window) +
         exrAttribute("lineOrder", "lineOrder", zero) +
         exrAttribute("pixelAspectRatio", "float", littleEndian(0x3F800000)) +
         exrAttribute("screenWindowCenter", "v2f", std::string(8, '\0')) +
         exrAttribute("screenWindowWidth", "float", littleEndian(0x3F800000)) + more + zero;
}

std::string exrFile(std::uint32_t flags, const std::string& headers) {
  return littleEndian(20000630) + littleEndian(2 | flags) + headers + std::string(1000, '\0');
}

/// What reading in every way says; few megabytes are taken for all of it.
std::vector<std::string> refusalsOf(const std::filesystem::path& path) {
  const auto all = [&] {
    return std::vector{errorOf([&] {
                         readPhotograph(path, {true, 36});
                       }),
                       errorOf([&] { readExr(path); }), errorOf([&] { readExrRanges(path); }),
                       errorOf([&] { readExrAttributes(path); })};
  };
  CHECK(megabytesOf(all) < kFew);
  return all();
}

}  // namespace

TEST_CASE("a PNG chunk that is longer than its file takes no memory") {
  const TemporaryDirectory directory;
  const std::string sound = pngFile({1, 1}, scanLines("abc", 3));
  const std::size_t afterHeader = 8 + 25;
  for (const char* kind :
       {"tEXt", "zTXt", "iTXt", "sPLT", "pCAL", "sCAL", "iCCP", "eXIf", "hIST", "tIME", "prVt", "PLTE"}) {
    CAPTURE(kind);
    for (const std::uint32_t length : {0x7fffffffU, 0x7ffffff0U, 0x10000000U}) {
      put(directory / "bad.png",
          sound.substr(0, afterHeader) + bigEndian(length) + kind + "x" + sound.substr(afterHeader));
      CHECK(megabytesOf([&] { errorOf([&] { readPhotograph(directory / "bad.png"); }); }) < kFew);
      CHECK(errorOf([&] { readPhotograph(directory / "bad.png"); }) != "");
      CHECK(errorOf([&] { readPhotographHeader(directory / "bad.png"); }) != "");
    }
    // Nothing is behind its length and kind, or less than a checksum.
    for (const char* rest : {"", "abc"}) {
      put(directory / "bad.png", sound.substr(0, afterHeader) + bigEndian(0x7ffffff0U) + kind + rest);
      CHECK(megabytesOf([&] { errorOf([&] { readPhotograph(directory / "bad.png"); }); }) < kFew);
    }
  }
}

TEST_CASE("texts and profiles that are larger than any are left out, an Exif block so large is refused") {
  const TemporaryDirectory directory;
  const auto path = directory / "large.png";
  const std::string lines = scanLines("abc", 3), large(kMostPngChunk + 1, 'x'), zero(1, '\0');
  const auto withChunk = [&](const char* kind, const std::string& data) {
    put(path, pngFile({1, 1}, lines, pngChunk("tEXt", "Title" + zero + "sky") + pngChunk(kind, data)));
  };
  withChunk("iTXt", "XML" + zero + zero + zero + zero + zero + large);
  CHECK(readPhotograph(path).text == std::map<std::string, std::string>{{"Title", "sky"}});
  withChunk("sPLT", large);
  CHECK(readPhotograph(path).text.size() == 1);
  withChunk("iCCP", large);
  CHECK(errorOf([&] { readPhotograph(path); }).find("damaged profile") != std::string::npos);
  withChunk("eXIf", large);
  CHECK(errorOf([&] { readPhotograph(path); }).find("Exif block is larger") != std::string::npos);
}

TEST_CASE("large pictures in small files are refused before memory is taken, unless it is allowed") {
  const TemporaryDirectory directory;
  constexpr int kSide = 6000;
  {
    const std::string row(1 + 3 * kSide, '\0');
    std::string lines;
    for (int y = 0; y < kSide; ++y) lines += row;
    put(directory / "bomb.png", pngFile({kSide, kSide}, lines));
    const std::vector<std::uint8_t> grey(std::size_t{kSide} * kSide, 128);
    put(directory / "bomb.jpg", jpegFile(grey, kSide, kSide, TJPF_GRAY, TJSAMP_GRAY));
    put(directory / "scans.jpg", jpegFile(grey, kSide, kSide, TJPF_GRAY, TJSAMP_GRAY, TJFLAG_PROGRESSIVE));
    Image image{kSide, kSide, {}};
    image.add("Y");
    writeBeautyExr(directory / "bomb.exr", image, {});
  }
  for (const char* name : {"bomb.png", "bomb.jpg", "scans.jpg", "bomb.exr"}) {
    const auto path = directory / name;
    CHECK(std::filesystem::file_size(path) < 1'500'000);
    const auto view = [&] { return errorOf([&] { readPhotograph(path, {true, 36}); }); };
    CHECK_MESSAGE(view().find("GB unasked; --memory SIZE allows more") != std::string::npos, view());
    CHECK(view().find('\n') == std::string::npos);
    CHECK(megabytesOf(view) < kFew);
    setMemoryLimit(100'000'000);
    CHECK_MESSAGE(view().find("are allowed by --memory") != std::string::npos, view());
    setMemoryLimit(8'000'000'000);
    CHECK(errorOf([&] { requireMemoryFor(path, 2'000'000'000); }) == "");
    setMemoryLimit(0);
  }
  // What needs no samples takes none.
  CHECK(megabytesOf([&] { readPhotographHeader(directory / "bomb.png"); }) < kFew);
  CHECK(megabytesOf([&] { readPhotographHeader(directory / "scans.jpg"); }) < kFew);
  CHECK(readPhotographHeader(directory / "bomb.jpg").width == kSide);
  CHECK(megabytesOf([&] { readExrRanges(directory / "bomb.exr"); }) < kFew);
  CHECK(readExrRanges(directory / "bomb.exr")[0].greatest == 0.0F);
}

TEST_CASE("a large file may take memory in proportion") {
  const TemporaryDirectory directory;
  put(directory / "large", std::string(6'000'000, 'x'));
  put(directory / "small", "x");
  setMemoryLimit(0);
  if (memoryLimit().bytes < 1'500'000'000) return;  // on this machine nobody gets that much
  CHECK(errorOf([&] { requireMemoryFor(directory / "large", 1'100'000'000); }) == "");
  CHECK(errorOf([&] { requireMemoryFor(directory / "small", 1'100'000'000); }) != "");
  CHECK(errorOf([&] { requireMemoryFor(directory / "small", 900'000'000); }) == "");
}

TEST_CASE("EXR files of a billion tiles, of deep pixels or of thousands of parts take no memory") {
  const TemporaryDirectory directory;
  const auto path = directory / "bad.exr";
  const std::string tiles = exrAttribute("tiles", "tiledesc", littleEndian(1) + littleEndian(1) + std::string(1, '\0'));
  const auto parts = [](int count, std::uint32_t side, std::uint32_t chunks) {
    std::string headers;
    for (int i = 0; i < count; ++i)
      headers += exrHeader(exrAttribute("name", "string", std::to_string(i)) +
                               exrAttribute("type", "string", "scanlineimage") +
                               exrAttribute("chunkCount", "int", littleEndian(chunks)),
                           side);
    return headers + std::string(1, '\0');
  };
  const std::string deep = exrAttribute("type", "string", "deepscanline");
  for (const std::string& file : {exrFile(0x200, exrHeader(tiles)), exrFile(0, exrHeader(tiles)),
                                  exrFile(0x800, exrHeader(deep)), exrFile(0x1000, parts(3000, 16, 16)),
                                  // As many parts as there may be, with tables that are not in the file.
                                  exrFile(0x1000, parts(1000, 32768, 32768)), exrFile(0x1000, parts(1000, 16, 32768)),
                                  exrFile(0x1000, parts(250, 32768, 32768)),
                                  exrFile(0, exrHeader(exrAttribute("chunkCount", "int", littleEndian(0x7fffffff)))),
                                  exrFile(0, exrHeader(""))}) {
    put(path, file);
    const std::vector<std::string> refusals = refusalsOf(path);
    for (int way = 0; way < 3; ++way) CHECK(refusals[static_cast<std::size_t>(way)] != "");
  }
}

TEST_CASE("an EXR attribute of another size than its type is refused, as OpenEXR would go on within it") {
  const TemporaryDirectory directory;
  const auto path = directory / "bad.exr";
  Image black{4, 3, {}};
  for (const char* name : {"R", "G", "B"}) black.add(name);
  writeBeautyExr(path, black, {});
  const std::string whole = contents(path);
  const auto refusalOf = [&](const std::string& type, const std::string& value) {
    constexpr std::size_t kStart = 8;  // of the first attribute
    put(path, whole.substr(0, kStart) + exrAttribute("first", type, value) + whole.substr(kStart));
    return errorOf([&] { readExrAttributes(path); });
  };
  const std::string zero(1, '\0'), promise = "after" + zero + "opaque" + zero + littleEndian(0x7fffffff);
  const std::string channel = "Y" + zero + std::string(16, '\1'), pixels = littleEndian(1) + littleEndian(2);
  std::string film;  // numbers that a key code may have
  for (const std::uint32_t number : {1, 1, 1, 1, 1, 4, 64}) film += littleEndian(number);
  const std::vector<std::pair<std::string, std::string>> sound{{"box2f", std::string(16, '\1')},
                                                               {"box2i", std::string(16, '\1')},
                                                               {"chlist", channel + channel + zero},
                                                               {"chromaticities", std::string(32, '\1')},
                                                               {"double", std::string(8, '\1')},
                                                               {"envmap", zero},
                                                               {"float", std::string(4, '\1')},
                                                               {"floatvector", std::string(20, '\1')},
                                                               {"int", std::string(4, '\1')},
                                                               {"keycode", film},
                                                               {"m33d", std::string(72, '\1')},
                                                               {"m33f", std::string(36, '\1')},
                                                               {"m44d", std::string(128, '\1')},
                                                               {"m44f", std::string(64, '\1')},
                                                               {"preview", pixels + std::string(8, '\1')},
                                                               {"rational", std::string(8, '\1')},
                                                               {"timecode", std::string(8, '\1')},
                                                               {"v2d", std::string(16, '\1')},
                                                               {"v2f", std::string(8, '\1')},
                                                               {"v2i", std::string(8, '\1')},
                                                               {"v3d", std::string(24, '\1')},
                                                               {"v3f", std::string(12, '\1')},
                                                               {"v3i", std::string(12, '\1')}};
  for (const auto& [type, value] : sound) {
    CHECK_MESSAGE(refusalOf(type, value) == "", type);
    CHECK_MESSAGE(refusalOf(type, value + promise).find("header is damaged") != std::string::npos, type);
    CHECK_MESSAGE(refusalOf(type, value.substr(1)).find("header is damaged") != std::string::npos, type);
  }
  CHECK(refusalOf("a type of others", promise) == "");
}

}  // namespace parhelion
