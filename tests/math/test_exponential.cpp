// SPDX-License-Identifier: Apache-2.0
#include "math/exponential.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

using namespace parhelion;

TEST_CASE("the exponential of what is not positive is right within 4e-16") {
  double worst = 0.0;
  for (int k = 0; k < 200'000; ++k) {
    const double x = 1e-12 + 3.4e-3 * k;
    worst = std::max(worst, std::abs(expOfMinus(x) / std::exp(-x) - 1.0));
  }
  CHECK(worst < 4e-16);
  CHECK(expOfMinus(0.0) == 1.0);
  for (double x = 1e-18; x < 1.0; x *= 3.0) CHECK(std::abs(expOfMinus(x) - std::exp(-x)) < 3e-16);
  CHECK(expOfMinus(1e300) == expOfMinus(700.0));
  CHECK(expOfMinus(700.0) > 0.0);
}

TEST_CASE("lanes of exponentials have the bits of single ones") {
  using Two = Lanes<2>::Real;
  for (double x = 0.0; x < 30.0; x += 0.37) {
    const Two arguments{x, 1000.0 * x}, lanes = expOfMinus(arguments);
    for (int k = 0; k < 2; ++k) CHECK(lanes[k] == expOfMinus(double(arguments[k])));
  }
}
