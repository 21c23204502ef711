// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#include "sky/sum_line.h"

namespace parhelion {

/// Asks the system for pages of megabytes within this memory: light falls all over a picture, and with small pages the
/// processor looks up their addresses more often than it adds.
void askForLargePages(void* memory, std::size_t bytes);

/// A fixed number of sums, which begin as 0, for tallies of rare light: there may be dozens of them, each nearly empty.
/// They know which of their pages nobody has asked to write to. Such pages are blank: all 0, and none that the system
/// has had to provide, unless they are read. Asking for lines to read and to write is safe from any number of threads.
class SumLines {
 public:
  static constexpr std::size_t kPageLines = 64;  // as many as a page of memory holds

  /// Throws std::bad_alloc.
  explicit SumLines(std::size_t count)
      : memory_(std::calloc(count + 1, sizeof(SumLine))),
        count_(count),
        written_((count + kPageLines - 1) / kPageLines, 0) {
    if (!memory_) throw std::bad_alloc();
    std::size_t room = (count + 1) * sizeof(SumLine);
    void* aligned = memory_.get();
    lines_ = static_cast<SumLine*>(std::align(alignof(SumLine), count * sizeof(SumLine), aligned, room));
    askForLargePages(lines_, count * sizeof(SumLine));
  }
  SumLines(SumLines&&) = default;
  SumLines& operator=(SumLines&&) = default;
  SumLines(const SumLines& other) : SumLines(other.count_) {
    other.forWritten([&](std::size_t i) { (*this)[i] = other[i]; });
  }
  SumLines& operator=(const SumLines& other) { return *this = SumLines(other); }

  void clear() {
    if (!isBlank()) *this = SumLines(count_);
  }

  std::size_t size() const { return count_; }
  const SumLine& operator[](std::size_t i) const { return lines_[i]; }
  SumLine& operator[](std::size_t i) {
    const std::atomic_ref<std::uint8_t> written(written_[i / kPageLines]);
    if (!written.load(std::memory_order_relaxed)) written.store(1, std::memory_order_relaxed);
    return lines_[i];
  }

  /// All of them, to be written to.
  std::span<SumLine> all() {
    std::ranges::fill(written_, std::uint8_t{1});
    return {lines_, count_};
  }

  /// Whether the page of a line is blank.
  bool isBlank(std::size_t line) const { return !written_[line / kPageLines]; }

  /// Whether all pages are.
  bool isBlank() const { return std::ranges::find(written_, 1) == written_.end(); }

  /// Calls act(line) for all lines of pages that are not blank.
  template <class Act>
  void forWritten(const Act& act) const {
    for (std::size_t page = 0; page < written_.size(); ++page)
      if (written_[page])
        for (std::size_t i = page * kPageLines; i < std::min(count_, (page + 1) * kPageLines); ++i) act(i);
  }

  double fullness() const {
    double most = 0.0;
    forWritten([&](std::size_t i) { most = std::max(most, parhelion::fullness({&lines_[i], 1})); });
    return most;
  }

  bool operator==(const SumLines& other) const {
    if (count_ != other.count_) return false;
    bool same = true;
    const auto compare = [&](std::size_t i) { same = same && lines_[i] == other.lines_[i]; };
    forWritten(compare);
    other.forWritten(compare);
    return same;
  }

 private:
  struct Free {
    void operator()(void* memory) const { std::free(memory); }
  };
  std::unique_ptr<void, Free> memory_;
  std::size_t count_;
  SumLine* lines_;
  std::vector<std::uint8_t> written_;  // by page: whether it is not blank
};

inline void addLines(SumLines& sums, const SumLines& amounts) {
  combineLines<1>(sums, amounts, [&](const auto& act) { amounts.forWritten(act); });
}

inline void subtractLines(SumLines& sums, const SumLines& amounts) {
  combineLines<-1>(sums, amounts, [&](const auto& act) { amounts.forWritten(act); });
}

}  // namespace parhelion
