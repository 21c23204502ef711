// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "picture/envmap.h"
#include "picture/exif.h"
#include "picture/image.h"
#include "picture/transfer.h"

namespace parhelion {

/// Components of pixels, row-major from the top left, interleaved: 8 or 16 bits through the sRGB transfer function, or
/// linear floats.
using Samples = std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>>;

/// A picture as its file holds it, turned upright. Primaries are those of Rec.709 (sRGB).
struct Photograph {
  int width = 0;     // pixels, upright
  int height = 0;    // pixels, upright
  int channels = 3;  // R, G, B and, if 4, alpha (not premultiplied in 8 and 16 bits, as the file has it in EXR)
  Samples samples;
  Exif exif;
  std::map<std::string, std::string> text;  // PNG text chunks, text attributes of an EXR

  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

/// The linear value of one of the samples.
inline float linearAt(const Samples& samples, std::size_t i) {
  return std::visit([i](const auto& all) { return linearOf(all[i]); }, samples);
}

struct PhotographRules {
  bool assumeSrgb = false;  // take the samples for sRGB whatever profile the file is tagged with
};

/// Largest number of pixels of a photograph that is read.
inline constexpr std::int64_t kMaxPhotographPixels = std::int64_t{1} << 27;

/// Reads a JPEG (8 bits, grey or colour, baseline or progressive), a PNG (any kind) or an EXR (flat scan lines), told
/// apart by their first bytes, and turns it upright by its Exif orientation. Memory is bounded by the size the header
/// states, which must be plausible for the file's length. Throws std::runtime_error "path: reason" in one line: for
/// what is damaged, cut short, too large, of another kind or tagged with a colour space other than sRGB, which it
/// names.
Photograph readPhotograph(const std::filesystem::path& path, const PhotographRules& rules = {});

/// The extension of a file's name in small letters, with its dot; empty where it has none.
std::string extensionOf(const std::filesystem::path& path);

/// Writes a picture by the extension of `path`: .png (8 bits, 16 for samples of 16 bits and floats), .jpg or .jpeg (8
/// bits, quality 95, no chroma subsampling, no alpha) or .exr (linear 32-bit floats). Upright, tagged sRGB (EXR:
/// Rec.709 chromaticities and `envmap`), `text` as text chunks, comment or attributes. In one piece or not at all
/// (atomic_file.h). Samples whose kind the file holds are written as they are. Throws std::runtime_error "path:
/// reason".
void writePhotograph(const std::filesystem::path& path, const Photograph& photograph,
                     const std::map<std::string, std::string>& text, Envmap envmap = Envmap::none);

/// The colours as linear Rec.709 in channels R, G, B, averaged over squares of `reduction` x `reduction` pixels (those
/// at the right and bottom borders may be smaller): ceil(width / reduction) x ceil(height / reduction) pixels.
Image linearImage(const Photograph& photograph, int reduction = 1);

}  // namespace parhelion
