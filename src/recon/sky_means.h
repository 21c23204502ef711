// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "math/portable.h"
#include "parallel/loops.h"
#include "picture/raster.h"
#include "sky/camera.h"

namespace parhelion {

using Plane = Raster<double>;

/// Means over the sky by solid angle.
struct SkyMeans {
  Plane omega;  // sr, 0 where there is no sky
  double all = 0.0;

  explicit SkyMeans(const CameraSettings& settings) : omega(settings.width, settings.height) {
    const std::vector<double> solidAngles = Camera(settings).solidAngles();
    for (std::size_t i = 0; i < omega.size(); ++i) all += omega[i] = solidAngles[i];
  }

  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * omega.width() + x; }

  template <class F>
  double mean(const F& value) const {
    const double sum = sumOverRows(omega.height(), [&](int y) {
      double row = 0.0;
      for (int x = 0; x < omega.width(); ++x)
        if (omega.at(x, y) > 0.0) row += omega.at(x, y) * value(index(x, y));
      return row;
    });
    return sum / all;
  }
};

/// Means under a Gaussian, weighted by solid angle, so that what lies outside the sky does not count.
class SkySmoother {
  static constexpr double kReach = 3.3;  // standard deviations: a thousandth of a Gaussian is beyond

 public:
  SkySmoother(const SkyMeans& sky, double sigma) : sky_(sky), reach_(static_cast<int>(std::ceil(kReach * sigma))) {
    for (int k = -reach_; k <= reach_; ++k) taps_.push_back(portable::exp(-0.5 * k * k / (sigma * sigma)));
    weight_ = blurred([](std::size_t) { return 1.0; });
  }

  template <class F>
  Plane operator()(const F& value) const {
    Plane plane = blurred(value);
    forRows(plane.height(), [&](int y) {
      for (int x = 0; x < plane.width(); ++x)
        plane.at(x, y) = sky_.omega.at(x, y) > 0.0 ? plane.at(x, y) / weight_.at(x, y) : 0.0;
    });
    return plane;
  }

 private:
  template <class F>
  Plane blurred(const F& value) const {
    Plane light(sky_.omega.width(), sky_.omega.height());
    forRows(light.height(), [&](int y) {
      for (int x = 0; x < light.width(); ++x)
        if (sky_.omega.at(x, y) > 0.0) light.at(x, y) = sky_.omega.at(x, y) * value(sky_.index(x, y));
    });
    Plane across(light.width(), light.height());
    forRows(light.height(), [&](int y) {
      for (int x = 0; x < light.width(); ++x) across.at(x, y) = tapped(&light.at(x, y), x, light.width(), 1);
    });
    forRows(light.height(), [&](int y) {
      for (int x = 0; x < light.width(); ++x)
        light.at(x, y) = tapped(&across.at(x, y), y, light.height(), light.width());
    });
    return light;
  }

  /// The taps over a line of `count` values, `stride` apart, around the one at `place`.
  double tapped(const double* centre, int place, int count, std::ptrdiff_t stride) const {
    const int from = std::max(-reach_, -place), to = std::min(reach_, count - 1 - place);
    double sum = 0.0;
    for (int k = from; k <= to; ++k) sum += taps_[static_cast<std::size_t>(k + reach_)] * centre[k * stride];
    return sum;
  }

  const SkyMeans& sky_;
  int reach_;
  std::vector<double> taps_;
  Plane weight_;
};

}  // namespace parhelion
