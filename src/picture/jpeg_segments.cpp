// SPDX-License-Identifier: Apache-2.0
#include "picture/jpeg_segments.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string_view>

namespace parhelion {
namespace {

using Bytes = std::span<const std::uint8_t>;

// Markers, the byte after 0xFF (ITU-T T.81, table B.1).
constexpr int kRestart0 = 0xD0, kRestart7 = 0xD7, kStart = 0xD8, kEnd = 0xD9, kScan = 0xDA, kTemporary = 0x01;
constexpr int kApp1 = 0xE1, kApp2 = 0xE2, kComment = 0xFE;

bool isFrame(int marker) {
  constexpr int kHuffmanTables = 0xC4, kExtension = 0xC8, kArithmeticTables = 0xCC;
  return marker >= 0xC0 && marker <= 0xCF && marker != kHuffmanTables && marker != kExtension &&
         marker != kArithmeticTables;
}

class Walk {
 public:
  explicit Walk(Bytes jpeg) : jpeg_(jpeg) {}

  /// The next marker, past whatever lies before it: image data, where 0xFF is followed by 0 or a restart marker, or
  /// bytes that do not belong there. 0 at the end of the file.
  int marker() {
    while (at_ + 1 < jpeg_.size()) {
      if (jpeg_[at_++] != 0xFF) continue;
      const int code = jpeg_[at_];
      if (code != 0 && code != 0xFF && (code < kRestart0 || code > kRestart7)) {
        ++at_;
        return code;
      }
    }
    return 0;
  }

  /// What the segment after a marker holds; nothing if it is cut off.
  std::optional<Bytes> segment() {
    if (at_ + 2 > jpeg_.size()) return {};
    const std::size_t length = static_cast<std::size_t>(jpeg_[at_] << 8 | jpeg_[at_ + 1]);
    if (length < 2 || length > jpeg_.size() - at_) return {};
    const Bytes payload = jpeg_.subspan(at_ + 2, length - 2);
    at_ += length;
    return payload;
  }

 private:
  Bytes jpeg_;
  std::size_t at_ = 0;
};

bool startsWith(Bytes bytes, std::string_view text) {
  return bytes.size() >= text.size() && std::equal(text.begin(), text.end(), bytes.begin());
}

std::optional<JpegFrame> frameOf(int marker, Bytes header) {
  if (header.size() < 6 || header.size() < 6 + 3 * std::size_t{header[5]}) return {};
  JpegFrame frame{marker, header[3] << 8 | header[4], header[1] << 8 | header[2], {}};
  for (std::size_t i = 0; i < header[5]; ++i) {
    const std::uint8_t factors = header[6 + 3 * i + 1];
    frame.components.push_back({factors >> 4, factors & 15});
    const auto& [across, down] = frame.components.back();
    if (across < 1 || across > 4 || down < 1 || down > 4) return {};
  }
  return frame;
}

/// Parts of a profile by their number (ICC.1:2010, B.4).
struct ProfileParts {
  std::map<int, Bytes> parts;
  int count = 0;

  void add(Bytes segment) {
    if (segment.size() < 2) return;
    parts.emplace(segment[0], segment.subspan(2));
    count = segment[1];
  }

  bool whole() const {
    return static_cast<int>(parts.size()) == count && parts.begin()->first == 1 && parts.rbegin()->first == count;
  }
};

}  // namespace

JpegSegments walkJpeg(Bytes jpeg) {
  constexpr std::string_view kExif("Exif\0\0", 6), kProfile("ICC_PROFILE\0", 12);
  JpegSegments found;
  ProfileParts profile;
  Walk walk(jpeg);
  for (int marker = walk.marker(); marker != 0; marker = walk.marker()) {
    found.complete = marker == kEnd;
    if (found.complete) break;
    if (marker == kStart || marker == kTemporary) continue;
    const std::optional<Bytes> segment = walk.segment();
    if (!segment) break;
    if (marker == kScan) ++found.scans;
    if (isFrame(marker) && !found.frame) found.frame = frameOf(marker, *segment);
    if (marker == kApp1 && found.exif.empty() && startsWith(*segment, kExif)) {
      found.exif.assign(segment->begin() + kExif.size(), segment->end());
    }
    if (marker == kComment) found.comments.emplace_back(segment->begin(), segment->end());
    if (marker == kApp2 && startsWith(*segment, kProfile)) profile.add(segment->subspan(kProfile.size()));
  }
  found.damagedProfile = !profile.parts.empty() && !profile.whole();
  if (found.damagedProfile) return found;
  for (const auto& [number, part] : profile.parts) found.profile.insert(found.profile.end(), part.begin(), part.end());
  return found;
}

std::uint64_t leastJpegBytes(const JpegFrame& frame) {
  int across = 1, down = 1;
  for (const JpegFrame::Component& c : frame.components) {
    across = std::max(across, c.across);
    down = std::max(down, c.down);
  }
  const auto blocks = [](int size, int factor, int most) {
    const int samples = (size * factor + most - 1) / most;
    return static_cast<std::uint64_t>((samples + 7) / 8);
  };
  std::uint64_t all = 0;
  for (const JpegFrame::Component& c : frame.components) {
    all += blocks(frame.width, c.across, across) * blocks(frame.height, c.down, down);
  }
  // No Huffman code is shorter than a bit. Each block of 8 x 8 has one for its mean and one for the end of the rest; in
  // progressive files a code can end the rest of 32767 blocks.
  constexpr int kProgressive = 0xC2;
  return all * (frame.marker == kProgressive ? 1 : 2) / 8;
}

}  // namespace parhelion
