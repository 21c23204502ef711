// SPDX-License-Identifier: Apache-2.0
#include "sky/sum_lines.h"

#include <doctest/doctest.h>

#include <vector>

#include "sky/tally.h"

using namespace parhelion;

namespace {

constexpr std::size_t kPage = SumLines::kPageLines;

SumLine lineOf(std::int64_t first) {
  SumLine line;
  line.place[0] = first;
  return line;
}

std::vector<bool> blankPages(const SumLines& lines) {
  std::vector<bool> blank;
  for (std::size_t i = 0; i < lines.size(); i += kPage) blank.push_back(lines.isBlank(i));
  return blank;
}

}  // namespace

TEST_CASE("sums are 0 and blank but where they were written to, and so are their copies and their sums") {
  SumLines lines(3 * kPage + 1);
  CHECK(lines.isBlank());
  CHECK(std::as_const(lines)[3 * kPage] == SumLine{});
  CHECK(lines.isBlank());
  lines[kPage + 5] = lineOf(7);
  CHECK(blankPages(lines) == std::vector{true, false, true, true});

  SumLines copy = lines;
  CHECK(copy == lines);
  CHECK(blankPages(copy) == std::vector{true, false, true, true});
  copy[3 * kPage] = lineOf(0);
  CHECK(copy == lines);  // blank or dark is the same
  CHECK(lines == copy);
  copy[3 * kPage] = lineOf(2);
  CHECK_FALSE(copy == lines);
  CHECK_FALSE(lines == copy);

  addLines(lines, copy);
  CHECK(blankPages(lines) == std::vector{true, false, true, false});
  CHECK(std::as_const(lines)[kPage + 5] == lineOf(14));
  CHECK(std::as_const(lines)[3 * kPage] == lineOf(2));
  CHECK(lines.fullness() == 14.0 / 0x1p63);
  subtractLines(lines, copy);
  CHECK(std::as_const(lines)[kPage + 5] == lineOf(7));
  CHECK(std::as_const(lines)[3 * kPage] == SumLine{});

  copy[0] = lineOf(std::numeric_limits<std::int64_t>::max());
  lines[0] = lineOf(1);
  const SumLines before = lines;
  CHECK_THROWS_AS(addLines(lines, copy), std::overflow_error);
  CHECK(lines == before);

  lines.clear();
  CHECK(lines.isBlank());
  CHECK(lines.size() == 3 * kPage + 1);
}

TEST_CASE("a mirror image writes to no blank page but that of light") {
  TallyInfo info;
  info.camera.width = 4 * static_cast<int>(kPage);
  info.camera.height = 3;
  Tally tally(info);
  const int row = info.camera.width;
  tally.addExclusively(row + 1, Vec3(1.0), true);
  tally.addMirrorImage();
  int blank = 0;
  for (int pixel = 0; pixel < tally.pixels(); pixel += static_cast<int>(kPage)) blank += tally.isBlank(pixel);
  CHECK(blank == 3 * 4 - 2);
  CHECK(tally.hits(row + 1) == 1);
  CHECK(tally.hits(2 * row - 2) == 1);
  tally.removeMirrorImage();
  CHECK(tally.hits(row + 1) == 1);
  CHECK(tally.hits(2 * row - 2) == 0);
}
