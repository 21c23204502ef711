// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace parhelion {

/// Of a quadrature over [-1, 1].
struct QuadratureNode {
  double x, weight;
};

/// The Gauss-Legendre rule of so many nodes, the highest first. Polynomials below degree 2 `count` are integrated to
/// rounding.
std::vector<QuadratureNode> gaussLegendre(int count);

}  // namespace parhelion
