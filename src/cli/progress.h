// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace parhelion::cli {

/// Shows on stderr how far a run is: redrawn four times a second on a terminal, a line each tenth of the way elsewhere.
class Progress {
 public:
  enum class Style { none, people, json };

  Progress(std::uint64_t total, Style style);

  void update(std::uint64_t done, double seconds);

  /// Ends the line on a terminal.
  void finish();

 private:
  void print(std::uint64_t done, double seconds);

  std::uint64_t total_;
  Style style_;
  bool terminal_;
  double lastDrawn_ = -1.0;  // s
  int lastTenth_ = 0;
  bool drawn_ = false;
};

/// A number with a suffix k, M or G, three digits.
struct Readable {
  double value;
  const char* suffix;
};
Readable readable(double count);

}  // namespace parhelion::cli
