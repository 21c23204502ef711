// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "math/gauss_legendre.h"

namespace parhelion {

// Gauss-Legendre on [-1, 1]: the nodes above 0, each stands for two.
inline constexpr QuadratureNode kGauss4[] = {{0.33998104358485626, 0.65214515486254609},
                                             {0.86113631159405257, 0.34785484513745385}};
inline constexpr QuadratureNode kGauss16[] = {
    {0.095012509837637441, 0.1894506104550685}, {0.28160355077925892, 0.18260341504492358},
    {0.45801677765722737, 0.16915651939500254}, {0.61787624440264377, 0.14959598881657674},
    {0.755404408355003, 0.12462897125553388},   {0.86563120238783176, 0.095158511682492786},
    {0.9445750230732326, 0.062253523938647894}, {0.98940093499164994, 0.027152459411754096},
};

// Up to this length (rad) four nodes do: the integrands are analytic within 1.5 rad, so their error is below 1e-14.
inline constexpr double kShortEdge = 0.1;

/// Integral of a function along an edge of a pixel or a part of it, which is `length` (rad) long.
template <typename Function>
double integrate(Function f, double from, double length) {
  const double half = 0.5 * length, middle = from + half;
  double sum = 0.0;
  for (const QuadratureNode& n :
       length < kShortEdge ? std::span<const QuadratureNode>(kGauss4) : std::span<const QuadratureNode>(kGauss16)) {
    sum += n.weight * (f(middle - half * n.x) + f(middle + half * n.x));
  }
  return sum * half;
}

}  // namespace parhelion
