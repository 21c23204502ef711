// SPDX-License-Identifier: Apache-2.0
#include "view/canvas.h"

#include <stdexcept>
#include <string>

#include <doctest/doctest.h>

using namespace parhelion;

namespace {

constexpr Colour kWhite{1.0, 1.0, 1.0, 1.0}, kBlack{0.0, 0.0, 0.0, 1.0};

LineArt written(const std::string& text) {
  Canvas canvas(200, 30);
  canvas.text(text, {2.0, 2.0}, 16.0, kWhite, kBlack);
  return canvas.lineArt();
}

}  // namespace

TEST_CASE("a canvas begins transparent and keeps straight colours") {
  Canvas canvas(4, 2);
  CHECK(canvas.lineArt().rgba == std::vector<std::uint8_t>(32, 0));
  canvas.rectangle({{1.0, 0.0}, {2.0, 1.0}}, {1.0, 0.5, 0.0, 0.5});
  const LineArt lines = canvas.lineArt();
  const auto component = [&](std::size_t c) { return static_cast<int>(lines.rgba[4 + c]); };
  CHECK(component(3) == 128);
  CHECK(component(0) == 255);
  // Kept premultiplied in 8 bits, half transparent colours come back within 1.
  CHECK(std::abs(component(1) - 128) <= 1);
  CHECK(component(2) == 0);
  CHECK(lines.rgba[0 + 3] == 0);
}

TEST_CASE("text stays within the box it is said to take") {
  for (const std::string text : {"22° halo", "−120°", "Ångström"}) {
    CAPTURE(text);
    Canvas canvas(300, 60);
    const Box box = canvas.textBox(text, 20.0);
    canvas.text(text, {30.0, 15.0}, 20.0, kWhite, kBlack);
    const LineArt lines = canvas.lineArt();
    // The outline stands out by 0.13 of 20 pixels.
    const Box allowed = Box{Vec2(30.0, 15.0), Vec2(30.0, 15.0) + box.size()}.grownBy(3.7);
    bool inside = true;
    int drawn = 0;
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 300; ++x)
        if (lines.rgba[4 * static_cast<std::size_t>(300 * y + x) + 3] > 0) {
          ++drawn;
          inside = inside && allowed.holds(Vec2(x + 0.5, y + 0.5));
        }
    CHECK(inside);
    CHECK(drawn > 100);
  }
}

TEST_CASE("text that is not UTF-8 comes out as replacement characters and later text is still written") {
  for (const std::string bad :
       {"\xFF", "\xC3", "\xC0\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x82", "\n", "\x7F", "\xC2\x85"}) {
    CAPTURE(bad.size());
    std::string replaced;
    for (std::size_t i = 0; i < bad.size(); ++i) replaced += "\uFFFD";
    CHECK(written("a" + bad + "z").rgba == written("a" + replaced + "z").rgba);

    Canvas canvas(60, 30);
    canvas.text(bad, {2.0, 2.0}, 10.0, kWhite, kBlack);
    const LineArt before = canvas.lineArt();
    canvas.rectangle({{0.0, 0.0}, {60.0, 30.0}}, kWhite);
    CHECK(canvas.lineArt().rgba != before.rgba);
  }
  for (const std::string good : {"é", "°", "−", "€", "𝄞"}) CHECK(written(good).rgba != written("\uFFFD").rgba);
}

TEST_CASE("a canvas without pixels or larger than cairo can draw is refused") {
  CHECK_THROWS_AS(Canvas(0, 5), std::invalid_argument);
  CHECK_THROWS_AS(Canvas(5, -1), std::invalid_argument);
  CHECK_THROWS_AS(Canvas(32768, 1), std::invalid_argument);
}
