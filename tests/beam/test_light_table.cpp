// SPDX-License-Identifier: Apache-2.0
// A table of light has every row that is looked at.
#include <doctest/doctest.h>

#include "beam/light_table.h"

using namespace parhelion;

TEST_SUITE("beam/light_table") {
  TEST_CASE("whatever rounding makes of a band's ends, the rows that it looks at are traced") {
    constexpr int kRows = 98;  // some ends of whose bands, times the rows over a quarter turn, are no whole numbers
    constexpr double kThick = 0.5 * kPi / kRows;
    for (int band = 0; band < kRows; ++band) {
      LightTable table({{1.0, 1.0}}, {1.31}, 2, kRows, 1e-3);
      table.prepare(band * kThick, (band + 1) * kThick);
      std::vector<double> light(static_cast<std::size_t>(table.room()));
      for (const double zeta : {band * kThick, band * kThick + kThick})
        for (const int stride : {1, 2}) {
          CAPTURE(band);
          CAPTURE(stride);
          bool any = false;
          for (const int number : table.classes()) any |= table.lightAt(zeta, number, {1.0}, stride, light.data());
          CHECK(any);
        }
    }
  }
}
