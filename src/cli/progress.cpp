// SPDX-License-Identifier: Apache-2.0
#include "cli/progress.h"

#include <cstdio>

#include <unistd.h>

namespace parhelion::cli {

Readable readable(double count) {
  if (count >= 1e9) return {count / 1e9, "G"};
  if (count >= 1e6) return {count / 1e6, "M"};
  if (count >= 1e3) return {count / 1e3, "k"};
  return {count, ""};
}

Progress::Progress(std::uint64_t total, Style style) : total_(total), style_(style), terminal_(isatty(STDERR_FILENO)) {}

void Progress::update(std::uint64_t done, double seconds) {
  if (style_ == Style::none) return;
  const int tenth = static_cast<int>(10.0 * static_cast<double>(done) / static_cast<double>(total_));
  const bool due = terminal_ && style_ == Style::people ? seconds - lastDrawn_ >= 0.25 : tenth > lastTenth_;
  if (!due && done < total_) return;
  lastDrawn_ = seconds;
  lastTenth_ = tenth;
  print(done, seconds);
}

void Progress::print(std::uint64_t done, double seconds) {
  const double rate = seconds > 0.0 ? static_cast<double>(done) / seconds : 0.0;
  const double left = rate > 0.0 ? static_cast<double>(total_ - done) / rate : 0.0;
  if (style_ == Style::json) {
    std::fprintf(
        stderr,
        "{\"rays\": %llu, \"of\": %llu, \"seconds\": %.3f, \"rays_per_second\": %.0f, \"seconds_left\": %.1f}\n",
        static_cast<unsigned long long>(done), static_cast<unsigned long long>(total_), seconds, rate, left);
    return;
  }
  const Readable rays = readable(static_cast<double>(done)), all = readable(static_cast<double>(total_)),
                 speed = readable(rate);
  std::fprintf(stderr, "%s%5.1f %%  %.3g%s of %.3g%s rays, %.3g%s rays/s, %.0f s left%s", terminal_ ? "\r" : "",
               100.0 * static_cast<double>(done) / static_cast<double>(total_), rays.value, rays.suffix, all.value,
               all.suffix, speed.value, speed.suffix, left, terminal_ ? "    " : "\n");
  drawn_ = true;
}

void Progress::finish() {
  if (terminal_ && drawn_) std::fputc('\n', stderr);
}

}  // namespace parhelion::cli
