// SPDX-License-Identifier: Apache-2.0
#include "cli/progress.h"

#include <cstdio>

#include <unistd.h>

namespace parhelion::cli {

namespace {

constexpr double kRedrawSeconds = 0.25;

}  // namespace

Progress::Progress(Style style, Pace pace)
    : style_(style),
      pace_(pace),
      redraws_(style == Style::people && isatty(STDERR_FILENO)),
      lastStep_(pace.firstLine - 1) {
  if (style_ == Style::people && !redraws_ && !pace_.inLogs) style_ = Style::none;
}

void Progress::update(double share, double seconds, const std::function<std::string(Style)>& line) {
  if (style_ == Style::none) return;
  const int step = static_cast<int>(share * (redraws_ ? 100.0 : 10.0));
  const bool timed = redraws_ && pace_.timed;
  const bool due = timed ? seconds - lastSeconds_ >= kRedrawSeconds || share >= 1.0 : step > lastStep_;
  if (!due) return;
  lastSeconds_ = seconds;
  lastStep_ = step;
  const std::string text = line(style_);
  // Spaces cover what is left of a longer line.
  if (redraws_)
    std::fprintf(stderr, "\r%s%s", text.c_str(), pace_.timed ? "    " : "");
  else
    std::fprintf(stderr, "%s\n", text.c_str());
  open_ = redraws_;
}

void Progress::finish() {
  if (open_) std::fputc('\n', stderr);
  open_ = false;
}

Progress::Style progressStyle(bool quiet, const std::string& progress) {
  return quiet ? Progress::Style::none : progress == "json" ? Progress::Style::json : Progress::Style::people;
}

Readable readable(double count) {
  if (count >= 1e12) return {count / 1e12, "T"};
  if (count >= 1e9) return {count / 1e9, "G"};
  if (count >= 1e6) return {count / 1e6, "M"};
  if (count >= 1e3) return {count / 1e3, "k"};
  return {count, ""};
}

}  // namespace parhelion::cli
