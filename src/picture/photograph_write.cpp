// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <cctype>
#include <cmath>
#include <string>

#include "math/overloaded.h"
#include "picture/exr.h"
#include "picture/jpeg.h"
#include "picture/photograph.h"
#include "picture/png.h"
#include "picture/stored_picture.h"
#include "picture/transfer.h"

namespace parhelion {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Words = std::vector<std::uint16_t>;
using Floats = std::vector<float>;

std::uint8_t byteOf(std::uint8_t code) { return code; }
std::uint8_t byteOf(std::uint16_t code) { return static_cast<std::uint8_t>((code + 128U) / 257U); }
std::uint8_t byteOf(float linear) { return toSrgb8(linear); }

// Alpha is linear in all files.
float alphaOf(std::uint8_t code) { return static_cast<float>(code) / 255.0F; }
float alphaOf(std::uint16_t code) { return static_cast<float>(code) / 65535.0F; }
float alphaOf(float alpha) { return alpha; }

/// R, G, B in 8 bits.
Bytes bytesOf(const Photograph& photograph) {
  Bytes rgb(3 * photograph.pixels());
  std::visit(
      [&](const auto& samples) {
        const auto channels = static_cast<std::size_t>(photograph.channels);
        for (std::size_t i = 0; i < photograph.pixels(); ++i) {
          for (std::size_t c = 0; c < 3; ++c) rgb[3 * i + c] = byteOf(samples[channels * i + c]);
        }
      },
      photograph.samples);
  return rgb;
}

/// Linear floats as sRGB of 16 bits.
Words wordsOf(const Floats& linear, int channels) {
  Words words(linear.size());
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool isAlpha = channels == 4 && i % 4 == 3;
    const float alpha = std::isfinite(linear[i]) ? std::clamp(linear[i], 0.0F, 1.0F) : 0.0F;
    words[i] = isAlpha ? static_cast<std::uint16_t>(std::lround(alpha * 65535.0F)) : toSrgb16(linear[i]);
  }
  return words;
}

Image planesOf(const Photograph& photograph) {
  Image image{photograph.width, photograph.height, {}};
  const auto channels = static_cast<std::size_t>(photograph.channels);
  for (std::size_t c = 0; c < channels; ++c) {
    Floats& plane = image.add(std::string(1, "RGBA"[c]));
    std::visit(
        [&](const auto& samples) {
          for (std::size_t i = 0; i < plane.size(); ++i) {
            plane[i] = c == 3 ? alphaOf(samples[4 * i + 3]) : linearOf(samples[channels * i + c]);
          }
        },
        photograph.samples);
  }
  return image;
}

void writePngPhotograph(const Output& output, const Photograph& photograph,
                        const std::map<std::string, std::string>& text) {
  PngSamples png{photograph.width, photograph.height, photograph.channels, {}};
  Words words;
  std::visit(Overloaded{
                 [&](const Floats& floats) {
                   words = wordsOf(floats, photograph.channels);
                   png.samples = std::span<const std::uint16_t>(words);
                 },
                 [&](const Words& deep) { png.samples = std::span<const std::uint16_t>(deep); },
                 [&](const Bytes& bytes) { png.samples = std::span<const std::uint8_t>(bytes); },
             },
             photograph.samples);
  writePng(output, png, text);
}

void writeJpegPhotograph(const Output& output, const Photograph& photograph,
                         const std::map<std::string, std::string>& text) {
  const auto software = text.find("Software");
  const std::string comment = software == text.end() ? "" : software->second;
  const auto* bytes = std::get_if<Bytes>(&photograph.samples);
  if (bytes && photograph.channels == 3) {
    writeJpeg(output, photograph.width, photograph.height, *bytes, comment);
  } else {
    writeJpeg(output, photograph.width, photograph.height, bytesOf(photograph), comment);
  }
}

}  // namespace

std::string extensionOf(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

void writePhotograph(const Output& output, const Photograph& photograph, const std::map<std::string, std::string>& text,
                     Envmap envmap) {
  const auto count = std::visit([](const auto& samples) { return samples.size(); }, photograph.samples);
  assert(count == photograph.pixels() * static_cast<std::size_t>(photograph.channels));
  static_cast<void>(count);
  const std::string extension = extensionOf(output.path);
  try {
    if (extension == ".png") return writePngPhotograph(output, photograph, text);
    if (extension == ".jpg" || extension == ".jpeg") return writeJpegPhotograph(output, photograph, text);
    if (extension == ".exr") return writeBeautyExr(output, planesOf(photograph), text, envmap);
  } catch (const std::bad_alloc&) {
    throw pictureError(output.path, "not enough memory");
  }
  throw pictureError(output.path, "a picture is written as .png, .jpg, .jpeg or .exr");
}

}  // namespace parhelion
