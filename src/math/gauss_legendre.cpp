// SPDX-License-Identifier: Apache-2.0
#include "math/gauss_legendre.h"

#include "math/conventions.h"
#include "math/portable.h"

namespace parhelion {

std::vector<QuadratureNode> gaussLegendre(int count) {
  std::vector<QuadratureNode> nodes;
  for (int k = 0; k < count; ++k) {
    // Newton's method, with Legendre's polynomials by their recurrence.
    double x = portable::cos(kPi * (k + 0.75) / (count + 0.5)), slope = 1.0;
    for (int round = 0; round < 20; ++round) {
      double before = 1.0, value = x;
      for (int n = 2; n <= count; ++n) {
        const double next = ((2.0 * n - 1.0) * x * value - (n - 1.0) * before) / n;
        before = value;
        value = next;
      }
      slope = count * (x * value - before) / (x * x - 1.0);
      x -= value / slope;
    }
    nodes.push_back({x, 2.0 / ((1.0 - x * x) * slope * slope)});
  }
  return nodes;
}

}  // namespace parhelion
