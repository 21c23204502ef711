// SPDX-License-Identifier: Apache-2.0
#include "beam/prism_tracer.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "optics/interface.h"

namespace parhelion {

namespace {

// Light within this cosine of running along a side does not meet it: it is a strip as narrow as that.
constexpr double kAlong = 1e-14;
// Light this close to c, as its part in the plane, runs from end to end without meeting a side.
constexpr double kStraight = 1e-12;
// What has become thin is followed to this share of where it became so.
constexpr double kGivenUp = 1e-3;
// Light that no side lets through is given up after so many of them.
constexpr int kMostSides = 20'000;
// Light across c is told to be this little off, so that it has a way along c.
constexpr double kAcross = 1e-9;
// Reflections at ends are told one by one until this share is left.
constexpr double kNothing = 1e-12;

// What meanOfWay() is where light that entered by a side begins.
constexpr double kStart = 0.5;

/// The mean of max(0, y) over y from y0 to y1.
double meanAbove(double y0, double y1) {
  constexpr double kShort = 1e-6;
  const double a = std::max(0.0, y0), b = std::max(0.0, y1);
  if (std::abs(y1 - y0) < kShort) return std::max(0.0, 0.5 * (y0 + y1));
  return 0.5 * (b * b - a * a) / (y1 - y0);
}

}  // namespace

PrismTracer::PrismTracer(const PrismSection& section, double length, double index, double cutShare, bool detailed)
    : section_(section), length_(length), cutShare_(cutShare), into_(index), outOf_(1.0 / index), detailed_(detailed) {}

void PrismTracer::meetOutside(const Vec3& lightDir, PrismLight& light) const {
  for (int face = 0; face < kPrismFaces; ++face) {
    const double cosine = -glm::dot(normalVectorOf(face), lightDir);
    const double area = face < kUpperEnd ? section_.side[face] * length_ : section_.area;
    light.shadow[face] = light.mirrored[face] = cosine > 0.0 ? cosine * area : 0.0;
    light.reflectance[face] = cosine > 0.0 ? fresnel(cosine, into_).reflectance : 1.0;
  }
}

void PrismTracer::trace(const Vec3& lightDir, PrismLight& light) {
  meetOutside(lightDir, light);
  light.cutOff.fill(0.0);
  told_ = &light;
  light.byOrder.fill(0.0);
  light.path = 0.0;
  const double least = cutShare_ * light.totalShadow();
  for (int face = 0; face < kPrismFaces; ++face) {
    const double goesIn = light.shadow[face] * (1.0 - light.reflectance[face]);
    if (!(goesIn > 0.0)) {
      for (auto& exits : light.arrived[face]) exits.fill(0.0);
      continue;
    }
    const Vec3 normal = normalVectorOf(face);
    const double cosine = -glm::dot(normal, lightDir);
    goesIn_ = goesIn;
    smallest_ = least / goesIn;
    begin(face, refract(lightDir, normal, cosine, fresnel(cosine, into_).cosTheta_t, into_));
  }
}

void PrismTracer::begin(int entry, const Vec3& inside) {
  arrived_ = &told_->arrived[entry];
  cutOff_ = &told_->cutOff[entry];
  for (auto& exits : *arrived_) exits.fill(0.0);
  fromSide_ = entry < kUpperEnd;
  firstEnd_ = inside.z > 0.0 ? kUpperEnd : kLowerEnd;
  const double inPlane = glm::length(Vec2(inside));
  const double reflectance = fresnel(std::abs(inside.z), outOf_).reflectance;
  if (!fromSide_ && inPlane < kStraight) return passStraight(reflectance);
  const double along = std::max(std::abs(inside.z), kAcross);
  rate_ = along / (inPlane * length_);
  lengthPerY_ = length_ / along;
  ends_.reset(reflectance, fromSide_);
  const Vec2 direction = Vec2(inside) / inPlane;
  prepare(direction, inPlane);
  stack_.clear();
  fromSide_ ? enterSide(entry) : enterEnd();
  while (!stack_.empty()) {
    const Part part = stack_.back();
    stack_.pop_back();
    step(part);
  }
}

void PrismTracer::passStraight(double reflectance) {
  const double even = 1.0 / (1.0 - reflectance * reflectance);
  (*arrived_)[0][firstEnd_] = even;
  (*arrived_)[kPlaneElements][oppositeFace(firstEnd_)] = reflectance * even;
  if (!detailed_) return;
  double left = goesIn_;
  for (double& order : told_->byOrder) {
    order += left * (1.0 - reflectance);
    left *= reflectance;
  }
  told_->path += goesIn_ * length_ / (1.0 - reflectance);
}

PARHELION_ALSO_AVX2 void PrismTracer::prepare(const Vec2& direction, double inPlane) {
  for (int e = 0; e < kPlaneElements; ++e) {
    Direction& of = directions_[e];
    const Vec2 d = parhelion::inPlane(e, direction), across(-d.y, d.x);
    std::array<double, 6> cosine;
    for (int k = 0; k < 6; ++k) {
      cosine[k] = glm::dot(section_.normal[k], d);
      const double along = glm::dot(section_.tangent[k], d);
      // In axes along and across the direction the side's normal is (cosine, -along).
      const double perCosine = 1.0 / cosine[k];
      Side& side = of.side[k];
      side.foot = section_.distance[k] * perCosine;
      side.slope = along * perCosine;
      // A point at t on the side's tangent has w = -along distance + cosine t, and cosine changes its sign.
      side.turned = -2.0 * along * section_.distance[k];
      side.reflectance = fresnel(std::abs(cosine[k]) * inPlane, outOf_).reflectance;
      side.next = afterReflection(e, k);
    }
    of.firstExit = 0;
    for (int k = 0; k < 6; ++k)
      if (cosine[k] > kAlong && !(cosine[(k + 5) % 6] > kAlong)) of.firstExit = k;
    of.exits = cosine[(of.firstExit + 2) % 6] > kAlong ? 3 : 2;
    for (int c = 0; c < 6; ++c) of.corner[c] = glm::dot(across, section_.corner[c]);
  }
}

void PrismTracer::enterSide(int side) {
  const double from = directions_[0].corner[(side + 1) % 6], to = directions_[0].corner[side];
  if (!(to > from)) return;
  perWidth_ = 1.0 / (to - from);
  stack_.push_back({from, to, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0, side, 0});
}

void PrismTracer::enterEnd() {
  // Light that enters by an end starts anywhere between the sides that light of its direction comes from and those it
  // runs to: as strips from the former, in which nothing is on its way yet.
  perWidth_ = 1.0 / (rate_ * section_.area);
  const Direction& of = directions_[0];
  for (int k = 0; k < 6; ++k) {
    const double from = of.corner[(k + 1) % 6], to = of.corner[k];
    if ((k - of.firstExit + 6) % 6 >= of.exits && to > from)
      stack_.push_back({from, to, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0, k, 0});
  }
}

PARHELION_ALSO_AVX2 void PrismTracer::step(const Part& part) {
  const Direction& of = directions_[part.element];
  const auto corner = [&](int exit) { return of.corner[(of.firstExit + exit) % 6]; };
  if (part.met > 0 && part.share < smallest_) {
    const double middle = 0.5 * (part.w0 + part.w1);
    int exit = 0;
    while (exit + 1 < of.exits && middle >= corner(exit + 1)) ++exit;
    const int side = (of.firstExit + exit) % 6;
    const double way = of.way(part.side, side, middle);
    meet(part, side, part.w0, part.w1, way, way);
    return;
  }
  for (int exit = 0; exit < of.exits; ++exit) {
    const double w0 = exit == 0 ? part.w0 : std::max(part.w0, corner(exit));
    const double w1 = exit + 1 == of.exits ? part.w1 : std::min(part.w1, corner(exit + 1));
    const int side = (of.firstExit + exit) % 6;
    if (w1 > w0) meet(part, side, w0, w1, of.way(part.side, side, w0), of.way(part.side, side, w1));
  }
}

PARHELION_ALSO_AVX2 void PrismTracer::meet(const Part& part, int side, double w0, double w1, double way0, double way1) {
  const Side& at = directions_[part.element].side[side];
  const double perPart = 1.0 / (part.w1 - part.w0), at0 = (w0 - part.w0) * perPart, at1 = (w1 - part.w0) * perPart;
  const double y0 = part.y0 + at0 * (part.y1 - part.y0) + rate_ * way0;
  const double y1 = part.y0 + at1 * (part.y1 - part.y0) + rate_ * way1;
  double window0 = y0, window1 = y1;  // light that came by an end has filled its first way
  EndCrossings::Four met = ends_.mean(y0, y1);
  if (fromSide_) {
    window0 = window1 = 1.0;
  } else if (part.met > 0) {
    window0 = part.window0 + at0 * (part.window1 - part.window0);
    window1 = part.window0 + at1 * (part.window1 - part.window0);
    met -= ends_.mean(std::max(0.0, y0 - window0), std::max(0.0, y1 - window1));
  }
  met *= part.weight * perWidth_ * (w1 - w0);
  const int otherEnd = oppositeFace(firstEnd_);
  auto& even = (*arrived_)[part.element];
  auto& odd = (*arrived_)[part.element + kPlaneElements];
  even[side] += met[0];
  odd[side] += met[1];
  even[firstEnd_] += met[2];
  odd[otherEnd] += met[3];

  const double kept = at.reflectance * (met[0] + met[1]);
  const bool goesOn = kept >= smallest_ * kGivenUp && part.met < kMostSides;
  if (detailed_) {
    const Part here{w0, w1, y0, y1, window0, window1, part.weight, 0.0, part.element, side, part.met};
    tellOrders(here, goesIn_ * part.weight * perWidth_ * (w1 - w0), at.reflectance, goesOn);
  }
  if (!goesOn) {
    *cutOff_ += kept;
    return;
  }
  // What met ends so far did so before this side: it is not met again after it.
  (*arrived_)[at.next][firstEnd_] -= at.reflectance * met[2];
  (*arrived_)[at.next + kPlaneElements][otherEnd] -= at.reflectance * met[3];
  stack_.push_back({at.turned - w1, at.turned - w0, y1, y0, window1, window0, part.weight * at.reflectance, kept,
                    at.next, side, part.met + 1});
}

void PrismTracer::tellOrders(const Part& met, double light, double sideReflectance, bool goesOn) {
  const double begin0 = met.y0 - met.window0, begin1 = met.y1 - met.window1;
  // What came before this side, and what does not come after it.
  const double here = goesOn ? 1.0 - sideReflectance : 1.0;
  double way = ends_.meanOfWay(met.y0, met.y1);
  way -= fromSide_ ? kStart : ends_.meanOfWay(std::max(0.0, begin0), std::max(0.0, begin1));
  told_->path += light * here * lengthPerY_ * way;

  const auto add = [&](int order, double left) {
    if (order <= PrismLight::kOrdersTold) told_->byOrder[order - 1] += left;
  };
  // Starts that have met k ends or more: those more than k lengths behind.
  const auto behind = [&](double k) { return meanAbove(met.y0 - k, met.y1 - k) - meanAbove(begin0 - k, begin1 - k); };
  const double endReflectance = ends_.reflectance(), first = std::floor(std::max(0.0, std::min(begin0, begin1)));
  const double last = std::min(std::max(met.y0, met.y1), static_cast<double>(PrismLight::kOrdersTold - met.met));
  double power = 1.0, more = behind(0.0);
  for (int k = 0; k <= last && power > kNothing; ++k, power *= endReflectance) {
    const double evenMore = behind(k + 1.0);
    if (k >= first) add(met.met + 1 + k, light * (1.0 - sideReflectance) * power * (more - evenMore));
    // The next end is met by the next evenMore; after the side it is one encounter later.
    const double left = light * power * (1.0 - endReflectance) * evenMore;
    add(met.met + k + 1, left);
    if (goesOn) add(met.met + k + 2, -sideReflectance * left);
    more = evenMore;
  }
}

}  // namespace parhelion
