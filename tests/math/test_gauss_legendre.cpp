// SPDX-License-Identifier: Apache-2.0
#include "math/gauss_legendre.h"

#include <cmath>

#include <doctest/doctest.h>

using namespace parhelion;

TEST_CASE("a Gauss-Legendre rule is exact for the polynomials that it should be, and no further") {
  for (const int count : {1, 2, 3, 8, 24}) {
    CAPTURE(count);
    const std::vector<QuadratureNode> nodes = gaussLegendre(count);
    REQUIRE(nodes.size() == static_cast<std::size_t>(count));
    const auto integral = [&](int power) {
      double sum = 0.0;
      for (const QuadratureNode& node : nodes) sum += node.weight * std::pow(node.x, power);
      return sum;
    };
    for (int power = 0; power < 2 * count; ++power)
      CHECK(integral(power) == doctest::Approx(power % 2 ? 0.0 : 2.0 / (power + 1)).epsilon(1e-13));
    if (count <= 8) CHECK(std::abs(integral(2 * count) - 2.0 / (2 * count + 1)) > 1e-6);
    for (std::size_t k = 1; k < nodes.size(); ++k) CHECK(nodes[k].x < nodes[k - 1].x);
  }
}
