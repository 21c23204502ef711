// SPDX-License-Identifier: Apache-2.0
#pragma once

// Photographs of a made-up landscape, with and without Exif.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "picture/photograph.h"
#include "shell.h"

namespace parhelion::test {

/// The samples of a picture of 8 bits, whatever it says of itself.
inline std::vector<std::uint8_t> samplesOf(const std::filesystem::path& path) {
  return std::get<std::vector<std::uint8_t>>(readPhotograph(path).samples);
}

/// A smooth sky over rough land; the border runs across the picture at `skyline` of its height. 8 or 16 bits.
template <class Code>
Photograph landscape(int width, int height, double skyline) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> grain(-0.01, 0.01);
  constexpr double kWhite = std::numeric_limits<Code>::max();
  std::vector<Code> samples;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool sky = y < skyline * height + 6.0 * std::sin(x * 0.05);
      const double shade = sky ? 0.45 + 0.1 * y / height : 0.2 + 4.0 * grain(random);
      for (const double tint : {0.9, 1.0, 1.15})
        samples.push_back(static_cast<Code>(kWhite * std::clamp(shade * tint + grain(random), 0.0, 1.0)));
    }
  }
  Photograph photograph;
  photograph.width = width;
  photograph.height = height;
  photograph.samples = std::move(samples);
  return photograph;
}

/// The mask of landscape(): the same border, hard.
inline Photograph skyOf(int width, int height, double skyline) {
  std::vector<std::uint8_t> samples;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x)
      samples.insert(samples.end(), 3, y < skyline * height + 6.0 * std::sin(x * 0.05) ? 255 : 0);
  }
  Photograph mask;
  mask.width = width;
  mask.height = height;
  mask.samples = std::move(samples);
  return mask;
}

/// Two bytes, little-endian; the other integers of a TIFF file are longer.
inline std::string bytes(unsigned value, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text.push_back(static_cast<char>(value >> (8 * i) & 0xFF));
  return text;
}

/// One entry of a TIFF directory: a short (type 3) or a long (4).
inline std::string tiffEntry(unsigned tag, unsigned type, unsigned value) {
  return bytes(tag, 2) + bytes(type, 2) + bytes(1, 4) + bytes(value, 4);
}

/// Writes a JPEG whose Exif tells orientation (1 to 8), the 35 mm equivalent of its focal length (mm) and that it was
/// taken at 2024:01:31 12:00:00; `stored` is the picture as the file holds it.
inline void writeJpegWithExif(const std::filesystem::path& path, const Photograph& stored, unsigned orientation,
                              unsigned focal35mm) {
  writePhotograph(path, stored, {});
  const std::string jpeg = readFile(path);
  constexpr unsigned kDirectory = 8, kEntry = 12;
  const unsigned sub = kDirectory + 2 + 2 * kEntry + 4;
  const std::string date("2024:01:31 12:00:00\0", 20);
  const std::string tiff = "II" + bytes(42, 2) + bytes(kDirectory, 4) + bytes(2, 2) +
                           tiffEntry(0x0112, 3, orientation) + tiffEntry(0x8769, 4, sub) + bytes(0, 4) + bytes(2, 2) +
                           bytes(0x9003, 2) + bytes(2, 2) + bytes(static_cast<unsigned>(date.size()), 4) +
                           bytes(sub + 2 + 2 * kEntry + 4, 4) + tiffEntry(0xA405, 3, focal35mm) + bytes(0, 4) + date;
  const std::string body = std::string("Exif\0\0", 6) + tiff;
  const unsigned length = static_cast<unsigned>(body.size()) + 2;
  std::string segment = "\xFF\xE1";
  segment += {static_cast<char>(length >> 8), static_cast<char>(length & 0xFF)};
  writeFile(path, jpeg.substr(0, 2) + segment + body + jpeg.substr(2));
}

}  // namespace parhelion::test
