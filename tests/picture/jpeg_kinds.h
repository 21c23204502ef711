// SPDX-License-Identifier: Apache-2.0
#pragma once

// JPEGs of all the codings that photographs come in.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "picture_files.h"

#include <jpeglib.h>  // needs what <cstdio> declares

namespace parhelion {

inline constexpr int kStep = 2;  // of quantisation, for all coefficients

/// How a JPEG is coded.
struct JpegKind {
  int across = 1, down = 1;  // pixels per chroma sample
  bool progressive = false;
  bool rgb = false;  // three components R, G, B, as Adobe's
  int orientation = 1;
  unsigned restart = 0;     // MCUs
  bool unfinished = false;  // the last bits of the coefficients are left out
};

inline std::string nameOf(const JpegKind& kind) {
  return std::to_string(kind.across) + "x" + std::to_string(kind.down) + (kind.progressive ? " progressive" : "") +
         (kind.rgb ? " RGB" : "") + " orientation " + std::to_string(kind.orientation) + " restart " +
         std::to_string(kind.restart);
}

inline std::string jpegOf(const std::vector<std::uint8_t>& samples, int width, int height, const JpegKind& kind,
                          const std::string& segments = "") {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &buffer, &size);
  jpeg.image_width = static_cast<JDIMENSION>(width);
  jpeg.image_height = static_cast<JDIMENSION>(height);
  jpeg.input_components = static_cast<int>(samples.size()) / (width * height);
  jpeg.in_color_space = jpeg.input_components == 3 ? JCS_RGB : JCS_GRAYSCALE;
  jpeg_set_defaults(&jpeg);
  if (kind.rgb) jpeg_set_colorspace(&jpeg, JCS_RGB);
  const std::vector<unsigned> steps(64, kStep);
  for (int table = 0; table < 2; ++table) jpeg_add_quant_table(&jpeg, table, steps.data(), 100, TRUE);
  jpeg.comp_info[0].h_samp_factor = kind.across;
  jpeg.comp_info[0].v_samp_factor = kind.down;
  jpeg.restart_interval = kind.restart;
  const jpeg_scan_info unfinished[] = {
      {3, {0, 1, 2}, 0, 0, 0, 0}, {1, {0}, 1, 63, 0, 1}, {1, {1}, 1, 63, 0, 0}, {1, {2}, 1, 63, 0, 0}};
  if (kind.progressive) jpeg_simple_progression(&jpeg);
  if (kind.unfinished) jpeg.scan_info = unfinished, jpeg.num_scans = 4;
  jpeg_start_compress(&jpeg, TRUE);
  for (int y = 0; y < height; ++y) {
    JSAMPROW row = const_cast<JSAMPROW>(samples.data()) + y * width * jpeg.input_components;
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  const std::string file(reinterpret_cast<const char*>(buffer), size);
  jpeg_destroy_compress(&jpeg);
  std::free(buffer);
  const std::string exif = jpegSegment(0xE1, std::string("Exif\0\0", 6) + exifBlock(kind.orientation));
  return withSegments(file, exif + segments);
}

/// Every kind of coding, each under another orientation.
inline std::vector<JpegKind> jpegKinds() {
  std::vector<JpegKind> all;
  int orientation = 0;
  const auto next = [&] { return orientation++ % 8 + 1; };
  for (const auto& [across, down] : {std::pair{1, 1}, {2, 1}, {2, 2}, {1, 2}, {4, 1}, {4, 2}}) {
    for (const bool progressive : {false, true}) all.push_back({across, down, progressive, false, next()});
  }
  for (int i = 0; i < 4; ++i) all.push_back({2, 2, i % 2 == 1, false, next(), 3});
  all.push_back({1, 1, false, true, next()});
  all.push_back({1, 1, true, true, next()});
  return all;
}

}  // namespace parhelion
