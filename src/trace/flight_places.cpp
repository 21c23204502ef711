// SPDX-License-Identifier: Apache-2.0
#include "trace/flight_places.h"

#include <algorithm>

#include "math/portable.h"

namespace parhelion {

namespace {

constexpr double kGuided = 0.25;  // share of places drawn by each face
constexpr double kLongest = 8.0;  // depth of flights of which next to nothing gets from face to face
constexpr double kLeast = 1e-2;   // of the flight's depth

}  // namespace

double takenOver(double depth) { return depth < 1e-5 ? depth - 0.5 * depth * depth : 1.0 - portable::exp(-depth); }

FlightPlaces::FlightPlaces(double depth, double behind, Faces wanted)
    : depth_(depth), behind_(behind), taken_(takenOver(depth)), least_(kLeast * (depth + behind)) {
  if (depth + behind > kLongest) return;
  if (wanted.ahead) ahead_ = kGuided;
  if (wanted.behind) toBehind_ = kGuided;
  logAhead_ = portable::log((least_ + depth) / least_);
  logBehind_ = portable::log((behind + least_ + depth) / (behind + least_));
}

double FlightPlaces::at(double u) const {
  // Distances from a face, from `first` on to the flight's other end, evenly by their logarithms.
  if (u < ahead_) return std::clamp(depth_ + least_ - least_ * portable::exp(u / ahead_ * logAhead_), 0.0, depth_);
  if (u < ahead_ + toBehind_) {
    const double first = behind_ + least_;
    return std::clamp(first * portable::exp((u - ahead_) / toBehind_ * logBehind_) - first, 0.0, depth_);
  }
  const double rest = (u - ahead_ - toBehind_) / (1.0 - ahead_ - toBehind_);
  return depth_ < 1e-5 ? rest * depth_ : std::min(depth_, -portable::log(1.0 - rest * taken_));
}

double FlightPlaces::weight(double from, double to) const {
  if (!isGuided() || !(from > 0.0 || to < depth_)) return 1.0;
  const auto share = [](double first, double near, double far, double whole) {
    return portable::log((first + far) / (first + near)) / whole;
  };
  return over(portable::exp(-from) * takenOver(to - from) / taken_,
              share(least_, depth_ - to, depth_ - from, logAhead_), share(behind_ + least_, from, to, logBehind_));
}

double FlightPlaces::weightAt(double place) const {
  if (!isGuided()) return 1.0;
  return over(portable::exp(-place) / taken_, 1.0 / ((least_ + depth_ - place) * logAhead_),
              1.0 / ((behind_ + least_ + place) * logBehind_));
}

double FlightPlaces::over(double scattered, double byAhead, double byBehind) const {
  return scattered / ((1.0 - ahead_ - toBehind_) * scattered + ahead_ * byAhead + toBehind_ * byBehind);
}

}  // namespace parhelion
