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
#include "picture/exr.h"
#include "picture/image.h"
#include "picture/transaction.h"
#include "picture/transfer.h"

namespace parhelion {

/// The components of all pixels, interleaved, row-major from the top left. They are 8 or 16 bits, encoded by the sRGB
/// transfer function, or linear floats.
using Samples = std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>>;

/// A picture with the samples of its file, turned upright. Its primaries are those of Rec.709 (sRGB).
struct Photograph {
  int width = 0;     // pixels, upright
  int height = 0;    // pixels, upright
  int channels = 3;  // R, G, B; if 4, alpha, too (straight in 8 and 16 bits, as the file has it in EXR)
  Samples samples;
  Exif exif;
  std::map<std::string, std::string> text;  // PNG text chunks, text attributes of an EXR

  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

/// The linear value of sample i.
inline float linearAt(const Samples& samples, std::size_t i) {
  return std::visit([i](const auto& all) { return linearOf(all[i]); }, samples);
}

struct PhotographRules {
  bool assumeSrgb = false;  // take the samples as sRGB, whatever colour space the file is tagged with
  int bytesForUse = 0;      // a pixel, that the caller is going to take beside the samples
  bool edited = false;      // read an EXR of ours even if it is not as we have written it

  EditedPictures editedPictures() const { return edited ? EditedPictures::read : EditedPictures::refused; }
};

/// How an EXR is to be read by these rules.
ExrColours exrColours(const PhotographRules& rules);

/// Reads a JPEG (8 bits, grey or colour, baseline or progressive), a PNG (any kind) or an EXR (flat scan lines). The
/// file's first bytes tell which of them it is. The picture is turned upright by its Exif orientation.
///
/// Before memory is taken, the size that the header states must be plausible for the file's length, and samples and use
/// together must find room (requireMemoryFor).
///
/// An EXR with other chromaticities is converted as readExr() does. Throws std::runtime_error "path: reason", in one
/// line, where the file is damaged, cut short, too large, of another kind or, a JPEG or PNG, tagged with a colour space
/// other than sRGB. The message names that colour space.
Photograph readPhotograph(const std::filesystem::path& path, const PhotographRules& rules = {});

/// The same of a JPEG or PNG without its samples, whatever its colours are: only the kind of samples is right. It takes
/// no memory for pixels. Of a JPEG it does not notice whether they are all there.
Photograph readPhotographHeader(const std::filesystem::path& path);

/// The extension of a file's name, in small letters and with its dot. Empty where the name has none.
std::string extensionOf(const std::filesystem::path& path);

/// Writes a picture upright. The extension of the name chooses the format:
///   - .png: 8 bits for samples of 8 bits, else 16 bits;
///   - .jpg, .jpeg: 8 bits, quality 95, no chroma subsampling, no alpha;
///   - .exr: linear 32-bit floats.
///
/// Samples that the format holds as they are stay unchanged. The file is tagged as sRGB, an EXR with Rec.709
/// chromaticities and `envmap`. `text` becomes text chunks, a comment or attributes. The file is written in one piece
/// or not at all (atomic_file.h). Throws std::runtime_error "path: reason".
void writePhotograph(const Output& output, const Photograph& photograph, const std::map<std::string, std::string>& text,
                     Envmap envmap = Envmap::none);

/// The colours as linear Rec.709 in channels R, G, B, averaged over squares of `reduction` x `reduction` pixels.
/// Squares at the right and bottom border may be smaller. The result has ceil(width / reduction) x ceil(height /
/// reduction) pixels.
Image linearImage(const Photograph& photograph, int reduction = 1);

}  // namespace parhelion
