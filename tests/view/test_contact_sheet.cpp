// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "view/contact_sheet.h"

using namespace parhelion;

namespace {

constexpr std::uint8_t kPaper = 40;  // as contact_sheet.cpp has it

Image noise(int width, int height) {
  Image image{width, height, {}};
  std::mt19937 random(3);
  std::exponential_distribution<float> light;
  for (const char* name : {"R", "G", "B"})
    for (float& sample : image.add(name)) sample = light(random);
  return image;
}

Image grey(int width, int height, float value) {
  Image image{width, height, {}};
  for (const char* name : {"R", "G", "B"})
    for (float& sample : image.add(name)) sample = value;
  return image;
}

SheetLayout roomOf(int width, int height) { return {1, 1, width, height, 0}; }

double mean(const std::vector<float>& samples) {
  double sum = 0.0;
  for (const float sample : samples) sum += sample;
  return sum / static_cast<double>(samples.size());
}

/// Components of the rectangle that are not those of the paper.
int inked(const Preview& sheet, int left, int top, int width, int height) {
  int count = 0;
  for (int y = top; y < top + height; ++y)
    for (int x = 3 * left; x < 3 * (left + width); ++x)
      count += sheet.rgb[static_cast<std::size_t>(3 * y * sheet.width + x)] != kPaper;
  return count;
}

}  // namespace

TEST_CASE("a picture made smaller keeps its mean light, whatever the ratio of the sizes") {
  const Image picture = noise(97, 53);
  for (const auto& [width, height] : {std::pair{48, 27}, {31, 17}, {97, 53}, {10, 6}, {2, 1}, {1, 1}}) {
    const Image small = reducedToFit(picture, roomOf(width, height));
    CHECK(small.width <= width);
    CHECK(small.height <= height);
    // All pixels of the small picture cover the same area; what differs is the rounding to floats.
    for (const char* name : {"R", "G", "B"})
      CHECK(mean(*small.find(name)) == doctest::Approx(mean(*picture.find(name))).epsilon(1e-6));
  }
}

TEST_CASE("each pixel of the smaller picture is the average of the pixels it covers") {
  Image picture{4, 2, {}};
  for (const char* name : {"R", "G", "B"}) picture.add(name) = {1, 2, 3, 4, 5, 6, 7, 16};
  CHECK(*reducedToFit(picture, roomOf(2, 1)).find("G") == std::vector<float>{3.5F, 7.5F});
  Image row{3, 1, {}};
  for (const char* name : {"R", "G", "B"}) row.add(name) = {3, 6, 12};
  CHECK(*reducedToFit(row, roomOf(2, 1)).find("R") == std::vector<float>{4.0F, 10.0F});
}

TEST_CASE("a picture that fits stays as it is, and none is made larger") {
  const Image picture = noise(20, 30);
  const Image same = reducedToFit(picture, roomOf(50, 50));
  CHECK(same.width == 20);
  CHECK(same.height == 30);
  for (const char* name : {"R", "G", "B"}) CHECK(*same.find(name) == *picture.find(name));
}

TEST_CASE("pictures are averaged as light, before the tone curve") {
  Image checks{2, 2, {}};
  for (const char* name : {"R", "G", "B"}) checks.add(name) = {0, 8, 8, 0};
  const SheetLayout layout = roomOf(1, 1);
  const SheetCell averaged{reducedToFit(checks, layout), {}}, even{grey(1, 1, 4.0F), {}};
  CHECK(contactSheet(layout, {&averaged, 1}, {-3.0}).rgb == contactSheet(layout, {&even, 1}, {-3.0}).rgb);
}

TEST_CASE("a sheet has room for all its pictures, is about square, and is no more than 2000 pixels across") {
  const struct {
    std::size_t pictures;
    int width, height;
  } cases[] = {{1, 64, 64}, {5, 1024, 1024}, {12, 2048, 1024}, {61, 1920, 1080}, {400, 300, 900}, {2500, 1024, 1024}};
  for (const auto& [pictures, width, height] : cases) {
    CAPTURE(pictures);
    const SheetLayout layout = layOutSheet(pictures, width, height, 1);
    CHECK(static_cast<std::size_t>(layout.columns * layout.rows) >= pictures);
    CHECK(static_cast<std::size_t>(layout.columns * (layout.rows - 1)) < pictures);
    CHECK(layout.width() <= 2000);
    CHECK(layout.pictureWidth <= width);
    CHECK(layout.pictureHeight <= height);
    if (pictures > 10) CHECK(std::abs(std::log(static_cast<double>(layout.width()) / layout.height())) < std::log(1.5));
    // The pictures keep their shape to within a pixel.
    CHECK(std::abs(layout.pictureWidth - static_cast<double>(layout.pictureHeight) * width / height) <=
          1.0 + static_cast<double>(width) / height);
  }
}

TEST_CASE("every picture has its text under it, inside its own column") {
  const SheetLayout layout = layOutSheet(5, 100, 80, 2);
  std::vector<SheetCell> cells(5);
  for (SheetCell& cell : cells)
    cell = {grey(100, 80, 0.0F), {"sun.elevation 12.5", "population.a-very-long-name-that-fits-nowhere.tilt 7"}};
  const Preview labelled = contactSheet(layout, cells, {0.0});
  for (SheetCell& cell : cells) cell.labels.clear();
  const Preview plain = contactSheet(layout, cells, {0.0});

  const int gap = (layout.width() - layout.columns * layout.pictureWidth) / (layout.columns + 1);
  const int line = layout.labelHeight / 2;
  for (int i = 0; i < 5; ++i) {
    const int left = gap + i % layout.columns * (layout.pictureWidth + gap);
    const int top = gap + i / layout.columns * (layout.pictureHeight + layout.labelHeight + gap) + layout.pictureHeight;
    for (const int y : {top, top + line}) {
      CHECK(inked(labelled, left, y, layout.pictureWidth, line) > 100);
      CHECK(inked(plain, left, y, layout.pictureWidth, line) == 0);
      // The gap at the right is free but for the smoothed edge of a letter.
      CHECK(inked(labelled, left + layout.pictureWidth + 2, y, gap - 2, line) == 0);
    }
  }
}

TEST_CASE("a key too long for its picture loses whole parts from the left before letters, and only then") {
  const SheetLayout layout{1, 1, 110, 10, 36};
  const auto sheet = [&](const std::string& label, int width) {
    SheetLayout narrow = layout;
    narrow.pictureWidth = width;
    // The second line keeps the letters of all sheets at their smallest.
    const SheetCell cell{grey(10, 10, 0.0F), {label, std::string(100, 'm')}};
    return contactSheet(narrow, {&cell, 1}, {0.0}).rgb;
  };
  CHECK(sheet("population.plates.aspect 0.1", 110) == sheet("plates.aspect 0.1", 110));
  CHECK(sheet("population.plates.aspect 0.1", 70) == sheet("aspect 0.1", 70));
  CHECK(sheet("population.plates.aspect 0.1", 30) == sheet("aspect 0.1", 30));
  CHECK(sheet("population.plates.aspect 0.1", 300) != sheet("plates.aspect 0.1", 300));
  CHECK(sheet("plates.aspect 0.1", 110) != sheet("aspect 0.1", 110));
}

TEST_CASE("one exposure serves all pictures of a sheet, and brighter frames come out brighter") {
  const SheetLayout layout = layOutSheet(2, 8, 8, 0);
  const std::vector<SheetCell> cells{{grey(8, 8, 0.25F), {}}, {grey(8, 8, 0.5F), {}}};
  const std::vector<SheetCell> doubled{{grey(8, 8, 0.5F), {}}, {grey(8, 8, 1.0F), {}}};
  const Preview sheet = contactSheet(layout, cells, {1.0});
  CHECK(sheet.rgb == contactSheet(layout, doubled, {0.0}).rgb);
  const auto middle = [&](int column) {
    const int x = column * layout.width() / 2 + layout.width() / 4;
    return sheet.rgb[static_cast<std::size_t>(3 * (layout.height() / 2 * layout.width() + x))];
  };
  REQUIRE(layout.columns == 2);
  CHECK(middle(1) > middle(0) + 20);
}

TEST_CASE("small pictures have columns wide enough for their lines") {
  const std::vector<std::string> lines{"cloud.optical_depth 0.05"};
  const SheetLayout layout = layOutSheet(3, 30, 20, 1, labelWidthOf(lines));
  CHECK(layout.pictureWidth == 30);
  CHECK(layout.columnWidth() > 80);
  // The beginning is there: another one makes another sheet.
  SheetCell cell{grey(30, 20, 0.0F), lines}, other{grey(30, 20, 0.0F), {"zzzzz.optical_depth 0.05"}};
  CHECK(contactSheet(layout, {&cell, 1}, {0.0}).rgb != contactSheet(layout, {&other, 1}, {0.0}).rgb);
  const SheetLayout narrow = layOutSheet(3, 30, 20, 1);
  CHECK(contactSheet(narrow, {&cell, 1}, {0.0}).rgb == contactSheet(narrow, {&other, 1}, {0.0}).rgb);
  CHECK(layOutSheet(2500, 30, 20, 1, 200).width() <= 2000);
  CHECK(labelWidthOf(std::vector<std::string>{std::string(1000, 'm')}) == 200);
}
