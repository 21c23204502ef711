// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "picture/temporary_directory.h"
#include "view/chart.h"

using namespace parhelion;

namespace {

const ChartAxes kAxes{"angle, degrees", "light"};
const std::vector<ChartCurve> kCurves{{"it's `touch bad` $(x) @home _a^b", {{0.0, 0.5}, {1.0, 1.0}, {2.0, 0.1}}},
                                      {"two\nlines", {{0.0, 1.0}, {2.0, 0.0}}}};

}  // namespace

TEST_CASE("a chart is an SVG or a PNG by its name, with axes and titles as they are, the same bytes again") {
  const TemporaryDirectory folder;
  drawChart(folder / "a.svg", kAxes, kCurves, "parhelion");
  const std::string svg = contents(folder / "a.svg");
  CHECK(svg.find("<svg") != std::string::npos);
  for (const char* said : {"angle, degrees", "light", "`touch bad` $(x) @home _a^b", "two lines"})
    CHECK_MESSAGE(svg.find(said) != std::string::npos, said);
  drawChart(folder / "b.svg", kAxes, kCurves, "parhelion");
  CHECK(contents(folder / "b.svg") == svg);
  drawChart(folder / "c.png", kAxes, kCurves, "parhelion");
  CHECK(contents(folder / "c.png").substr(1, 3) == "PNG");
  drawChart(folder / "d.SVG", kAxes, kCurves, "parhelion");
  CHECK(contents(folder / "d.SVG") == svg);
  CHECK(folder.names().size() == 4);
}

TEST_CASE("without gnuplot the error names the package, and nothing is written") {
  const TemporaryDirectory folder;
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  const std::string error = errorOf([&] { drawChart(folder / "a.svg", kAxes, kCurves, "parhelion"); });
  ::setenv("PATH", path.c_str(), 1);
  CHECK(error.find("gnuplot-nox") != std::string::npos);
  CHECK(folder.names().empty());
}

TEST_CASE("a chart without a point is refused, and nothing is written") {
  const TemporaryDirectory folder;
  const std::vector<ChartCurve> empty{{"nothing", {}}};
  CHECK_THROWS_AS(drawChart(folder / "a.svg", kAxes, {}, "parhelion"), std::invalid_argument);
  CHECK_THROWS_AS(drawChart(folder / "a.svg", kAxes, empty, "parhelion"), std::invalid_argument);
  CHECK(folder.names().empty());
}
