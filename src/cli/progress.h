// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

namespace parhelion::cli {

/// Shows on stderr how far some work is: one line redrawn on a terminal, for logs and as JSON a line each tenth of the
/// way.
class Progress {
 public:
  enum class Style { none, people, json };

  /// When a line is due.
  struct Pace {
    bool timed;     // redrawn four times a second; else each percent
    bool inLogs;    // for people, too, where stderr is no terminal
    int firstLine;  // tenth of the way at which the first line is written
  };
  static constexpr Pace kOfTracing{true, true, 1};
  static constexpr Pace kOfReconstruction{false, false, 0};

  Progress(Style style, Pace pace);

  /// Ends the line on a terminal.
  ~Progress() { finish(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows what `line` makes, without its end, where one is due. `share` is that of the work done, 0 to 1.
  void update(double share, double seconds, const std::function<std::string(Style)>& line);

  /// Ends the line on a terminal: something else is to be written.
  void finish();

 private:
  Style style_;
  Pace pace_;
  bool redraws_;  // one line on a terminal
  double lastSeconds_ = -1.0;
  int lastStep_;
  bool open_ = false;  // a line on the terminal waits for its end
};

/// The style that options ask for.
Progress::Style progressStyle(bool quiet, const std::string& progress);

/// A number with a suffix k, M, G or T, three digits.
struct Readable {
  double value;
  const char* suffix;
};
Readable readable(double count);

}  // namespace parhelion::cli
