// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "beam/tristimulus.h"

namespace parhelion {

/// Light that is traced at some indices of the ice and lies between them, or at lines alone.
struct LightSegments {
  static constexpr int kColours = 8;

  /// Light from one index to another, the same for a line.
  struct Segment {
    std::size_t from, to;
    double share;                           // of all light
    std::array<double, kColours> at;        // places between both, from 0 to 1, of as much light each
    std::array<Tristimulus, kColours> xyz;  // its colour there

    bool operator==(const Segment&) const = default;
  };

  std::vector<double> indices;
  std::vector<Segment> segments;

  bool operator==(const LightSegments&) const = default;

  /// Lines, each as likely.
  static LightSegments ofLines(const std::vector<IndexColour>& lines) {
    LightSegments all;
    for (const IndexColour& line : lines) {
      Segment segment{all.indices.size(), all.indices.size(), 1.0 / static_cast<double>(lines.size()), {}, {}};
      segment.xyz.fill(line.xyz);
      all.segments.push_back(segment);
      all.indices.push_back(line.index);
    }
    return all;
  }

  /// Light by a number in (0, 1), in `count` parts.
  static LightSegments of(const std::function<IndexColour(double)>& light, std::size_t count) {
    constexpr double kEnd = 1e-9;
    LightSegments all;
    const double per = 1.0 / static_cast<double>(count);
    for (std::size_t k = 0; k <= count; ++k) {
      all.indices.push_back(light(kEnd + (1.0 - 2.0 * kEnd) * per * static_cast<double>(k)).index);
      if (k == count) break;
      all.segments.push_back({k, k + 1, per, {}, {}});
    }
    for (Segment& segment : all.segments) {
      const double from = all.indices[segment.from], width = all.indices[segment.to] - from;
      for (std::size_t j = 0; j < kColours; ++j) {
        const IndexColour own =
            light((static_cast<double>(segment.from) + (static_cast<double>(j) + 0.5) / kColours) * per);
        segment.at[j] = width != 0.0 ? (own.index - from) / width : 0.0;
        segment.xyz[j] = own.xyz;
      }
    }
    return all;
  }
};

}  // namespace parhelion
