// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace parhelion {

/// Blurs a plane (row-major, width x height) by a Gaussian of standard deviation `sigma` pixels, beyond its borders
/// continued by their own pixels. Rows, then columns, each four times by an extended box, whose fractional ends give
/// the four together the Gaussian's variance exactly (Gwosdek, Grewenig, Bruhn & Weickert, "Theoretical Foundations of
/// Gaussian Convolution by Extended Box Filtering", 2011): time does not depend on sigma. An edge comes out within
/// kBlurError of its height. A constant plane stays as it is, bit for bit. Throws std::invalid_argument unless
/// 0 < sigma <= kMaxBlur and the plane has that size.
void blurGaussian(std::vector<float>& plane, int width, int height, double sigma);

inline constexpr double kMaxBlur = 4096.0;  // pixels

/// Share of an edge's height for sigma >= 1.3, from the fourth cumulant that four boxes leave: 0.3 / 24 of the third
/// derivative of the Gaussian's integral, 0.69 %, and what comes after it; 6 % below, where boxes have few pixels.
inline constexpr double kBlurError = 0.0075;

}  // namespace parhelion
