// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace parhelion {

/// The frame header of a JPEG (ITU-T T.81, B.2.2).
struct JpegFrame {
  struct Component {
    int across, down;  // sampling factors, 1 to 4
  };

  int marker = 0;  // SOF0 is 0xC0: baseline, 1 extended, 2 progressive, 9 and 10 arithmetic, others lossless and so on
  int width = 0;
  int height = 0;
  std::vector<Component> components;
};

struct JpegSegments {
  std::optional<JpegFrame> frame;     // none if there is none, or it is damaged
  std::vector<std::uint8_t> exif;     // what follows "Exif\0\0" in the first APP1 of that kind
  std::vector<std::uint8_t> profile;  // the ICC profile, put together from its APP2 segments
  std::vector<std::string> comments;
  bool damagedProfile = false;  // parts of the profile are missing
  bool complete = false;        // there is an end of the image
  int scans = 0;                // as far as the file goes
};

/// Walks through the marker segments of a JPEG; stays inside `jpeg` whatever they say.
JpegSegments walkJpeg(std::span<const std::uint8_t> jpeg);

/// The fewest bytes a Huffman-coded picture of that frame takes.
std::uint64_t leastJpegBytes(const JpegFrame& frame);

}  // namespace parhelion
