// SPDX-License-Identifier: Apache-2.0
#include "beam/end_crossings.h"

#include <algorithm>

namespace parhelion {

namespace {

/// A share of light that no sum notices.
constexpr double kNothing = 1e-20;

}  // namespace

void EndCrossings::reset(double reflectance, bool window) {
  reflectance_ = reflectance;
  window_ = window;
  repeats_ = reflectance >= 1.0;
  power_ = 1.0;
  arrived_ = Four{};
  steepness_ = Four{1.0, 0.0, 0.0, 0.0};
  nodes_.clear();
  nodes_.push_back({Four{}, steepness_, Four{}, 0.0});
}

std::size_t EndCrossings::extend(std::size_t cell) {
  while (nodes_.size() <= cell && power_ > kNothing) {
    const std::size_t odd = nodes_.size() % 2;
    const Node& last = nodes_.back();
    if (!repeats_) arrived_[static_cast<int>(3 - odd)] += power_;  // by light reflected once less
    power_ *= reflectance_;
    Four steepness = arrived_;
    steepness[static_cast<int>(odd)] = power_;
    const Four integral = last.value + 0.5 * last.slope;
    const double twice = last.integral[0] + last.integral[1] + 0.5 * (last.value[0] + last.value[1]) +
                         (last.slope[0] + last.slope[1]) / 6.0;
    const Node next{last.value + last.slope, window_ ? steepness - steepness_ : steepness, last.integral + integral,
                    last.twice + twice};
    steepness_ = steepness;
    nodes_.push_back(next);
  }
  return std::min(cell, nodes_.size() - 1);
}

void EndCrossings::across(double low, std::size_t first, double high, std::size_t last, Four& mean) const {
  const double before = static_cast<double>(first + 1) - low, behind = high - static_cast<double>(last);
  const Node& from = nodes_[first];
  const Node& to = nodes_[last];
  const Four sum = before * (from.value + (1.0 - 0.5 * before) * from.slope) +
                   (to.integral - nodes_[first + 1].integral) + behind * (to.value + (0.5 * behind) * to.slope);
  mean = sum / (high - low);
}

double EndCrossings::wayAt(double y) {
  const std::size_t cell = cellOf(y);
  const Node& node = nodes_[cell];
  const double t = y - static_cast<double>(cell);
  const Four way = node.integral + t * (node.value + (0.5 * t) * node.slope);
  return way[0] + way[1];
}

double EndCrossings::twiceAt(double y) {
  const std::size_t cell = cellOf(y);
  const Node& node = nodes_[cell];
  const double t = y - static_cast<double>(cell);
  const Four way = node.integral + (0.5 * t) * (node.value + (t / 3.0) * node.slope);
  return node.twice + t * (way[0] + way[1]);
}

double EndCrossings::meanOfWay(double y0, double y1) {
  if (repeats_) return 0.5 * (y0 + y1) - 0.5;  // all of it is there still
  // Over a short way the quotient would be rounding; there Simpson's rule errs by the cube of it at most.
  constexpr double kShort = 1e-3;
  if (std::abs(y1 - y0) < kShort) return (wayAt(y0) + 4.0 * wayAt(0.5 * (y0 + y1)) + wayAt(y1)) / 6.0;
  return (twiceAt(y1) - twiceAt(y0)) / (y1 - y0);
}

}  // namespace parhelion
