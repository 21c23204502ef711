// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "picture/atomic_file.h"

namespace parhelion {

/// A JPEG between its entropy coding and its transform: the quantised coefficients, to be changed in place, and all
/// that is needed to write it again. Takes 2 bytes a sample, blocks filled up.
class JpegCoefficients {
 public:
  struct Component {
    int across, down;                     // pixels per sample along rows and columns
    int blocksWide, blocksHigh;           // of 8 x 8 samples, those with pixels of the picture
    std::array<std::uint16_t, 64> steps;  // of quantisation, row-major, the mean first
  };

  /// Reads a file that readJpeg has accepted. Throws std::runtime_error "path: reason".
  explicit JpegCoefficients(const std::filesystem::path& path);
  ~JpegCoefficients();

  int width() const;   // pixels, as stored
  int height() const;  // pixels, as stored
  bool isRgb() const;  // three components are R, G, B; otherwise Y, Cb, Cr

  /// Whether writing gives a file that is decoded to the same picture. Not so where scans leave out the last bits of
  /// coefficients, which decoders then guess from the neighbours, or where a table changes on the way.
  bool repeatable() const;

  const std::vector<Component>& components() const { return components_; }

  /// The blocks of a row one after the other, 64 coefficients each in the order of `steps`.
  std::int16_t* row(std::size_t component, int y);

  /// Writes the markers (APPn and COM) as they were, in their order, behind them the comment unless it is empty or
  /// there already, and the picture with the tables and sampling it had, progressive if it was, with Huffman codes made
  /// for it and without restart markers. Throws std::runtime_error "path: reason" with the path of the original. Errors
  /// of the file come out at its commit().
  void write(AtomicFile& file, std::string_view comment);

 private:
  struct Library;

  std::filesystem::path path_;
  std::unique_ptr<Library> library_;
  std::vector<Component> components_;
};

}  // namespace parhelion
