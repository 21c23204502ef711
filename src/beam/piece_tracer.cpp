// SPDX-License-Identifier: Apache-2.0
#include "beam/piece_tracer.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "optics/interface.h"

namespace parhelion {

namespace {

// Light within this cosine of running along a face does not meet it.
constexpr double kAlong = 1e-12;
// What has become thin is followed to this share of where it became so.
constexpr double kGivenUp = 1e-3;
// Light that no face lets through is given up after so many of them.
constexpr int kMostFaces = 5000;

}  // namespace

PieceTracer::PieceTracer(const PrismSection& section, double length, double index, double cutShare, bool detailed,
                         const WantedPaths& wanted)
    : section_(section),
      length_(length),
      cutShare_(cutShare),
      into_(index),
      outOf_(1.0 / index),
      detailed_(detailed),
      wanted_(wanted) {}

void PieceTracer::trace(const Vec3& lightDir, PrismLight& light, LightChains* chains) {
  light.cutOff.fill(0.0);
  if (detailed_) light.byOrder.fill(0.0);
  told_ = &light;
  chains_ = chains;
  const double least = cutShare_ * light.totalShadow();
  for (int face = 0; face < kPrismFaces; ++face) {
    for (auto& exits : light.arrived[face]) exits.fill(0.0);
    const double goesIn = light.shadow[face] * (1.0 - light.reflectance[face]);
    if (!(goesIn > 0.0) || !wanted_.goesOn(wanted_.next(WantedPaths::kStart, face))) continue;
    arrived_ = &light.arrived[face];
    cutOff_ = &light.cutOff[face];
    goesIn_ = goesIn;
    smallest_ = least / goesIn;
    const Vec3 normal = normalVectorOf(face);
    const double cosine = -glm::dot(normal, lightDir);
    begin(face, refract(lightDir, normal, cosine, fresnel(cosine, into_).cosTheta_t, into_));
  }
}

void PieceTracer::begin(int entry, const Vec3& inside) {
  entry_ = entry;
  static_cast<Beam&>(from_) = {inside, 1.0, 1.0, 0, wanted_.next(WantedPaths::kStart, entry), 0, {}};
  if (chains_) from_.faces = code_.with({}, chains_->numberOf[static_cast<std::size_t>(entry)], 0);
  from_.count = 0;
  const double half = 0.5 * length_;
  const auto add = [&](const Vec2& at, double z) { from_.corners[from_.count++].at = Vec3(at, z); };
  if (entry < kUpperEnd) {
    const Vec2 &a = section_.corner[entry], &b = section_.corner[(entry + 1) % 6];
    add(a, -half);
    add(b, -half);
    add(b, half);
    add(a, half);
  } else {
    for (const Vec2& corner : section_.corner) add(corner, entry == kUpperEnd ? half : -half);
  }
  perAcross_ = 1.0 / across(from_);
  waiting_ = 0;
  step();
  while (waiting_ > 0) {
    from_.take(stack_[--waiting_]);
    step();
  }
}

double PieceTracer::across(const Piece& piece) const {
  Vec3 twice(0.0);
  for (int k = 2; k < piece.count; ++k)
    twice += glm::cross(piece.corners[k - 1].at - piece.corners[0].at, piece.corners[k].at - piece.corners[0].at);
  return 0.5 * std::abs(glm::dot(twice, piece.direction));
}

PieceTracer::Ahead PieceTracer::aheadOf(const Vec3& direction) const {
  Ahead ahead;
  ahead.count = 0;
  for (int face = 0; face < kPrismFaces; ++face) {
    const double cosine = glm::dot(normalVectorOf(face), direction);
    if (cosine <= kAlong) continue;
    ahead.face[ahead.count] = face;
    ahead.cosine[ahead.count++] = cosine;
  }
  return ahead;
}

double PieceTracer::wayTo(int face, double cosine, const Vec3& at) const {
  const double before = face < kUpperEnd ? section_.distance[face] - glm::dot(section_.normal[face], Vec2(at))
                                         : 0.5 * length_ - (face == kUpperEnd ? at.z : -at.z);
  return before / cosine;
}

void PieceTracer::step() {
  if (!wanted_.areShort() && from_.share < smallest_) return followMiddle();
  const Ahead ahead = aheadOf(from_.direction);
  for (int k = 0; k < from_.count; ++k)
    for (int which = 0; which < ahead.count; ++which)
      from_.corners[k].way[which] = wayTo(ahead.face[which], ahead.cosine[which], from_.corners[k].at);
  for (int which = 0; which < ahead.count; ++which) {
    const int state = wanted_.next(from_.state, ahead.face[which]);
    if ((wanted_.isWanted(state) || wanted_.goesOn(state)) && cutTo(ahead, which)) meet(ahead, which);
  }
}

bool PieceTracer::cutTo(const Ahead& ahead, int which) {
  part_.take(from_);
  for (int other = 0; other < ahead.count; ++other) {
    if (other == which) continue;
    const auto over = [&](const Corner& c) { return c.way[other] - c.way[which]; };
    int count = 0;
    for (int k = 0; k < part_.count && count + 2 <= kMostCorners; ++k) {
      const Corner &p = part_.corners[k], &q = part_.corners[k + 1 < part_.count ? k + 1 : 0];
      const double op = over(p), oq = over(q);
      if (op >= 0.0) kept_[count++] = p;
      if (!((op > 0.0 && oq < 0.0) || (op < 0.0 && oq > 0.0))) continue;
      const double t = op / (op - oq);
      Corner& between = kept_[count++];
      between.at = p.at + t * (q.at - p.at);
      for (int way = 0; way < ahead.count; ++way) between.way[way] = p.way[way] + t * (q.way[way] - p.way[way]);
    }
    if (count < 3) return false;
    part_.count = count;
    std::copy_n(kept_.begin(), count, part_.corners.begin());
  }
  part_.share = part_.weight * perAcross_ * across(part_);
  return part_.share > 0.0;
}

void PieceTracer::meet(const Ahead& ahead, int which) {
  if (!goesOnFrom(part_, ahead.face[which], ahead.cosine[which])) return;
  for (int k = 0; k < part_.count; ++k) {
    Corner& corner = part_.corners[k];
    corner.at += corner.way[which] * from_.direction;
  }
  if (stack_.size() == waiting_) stack_.emplace_back();
  stack_[waiting_++].take(part_);
}

void PieceTracer::followMiddle() {
  Vec3 at(0.0);
  for (int k = 0; k < from_.count; ++k) at += from_.corners[k].at;
  at /= static_cast<double>(from_.count);
  while (true) {
    const Ahead ahead = aheadOf(from_.direction);
    std::array<double, 4> way;
    for (int which = 0; which < ahead.count; ++which) way[which] = wayTo(ahead.face[which], ahead.cosine[which], at);
    const auto next = std::min_element(way.begin(), way.begin() + ahead.count) - way.begin();
    at += way[next] * from_.direction;
    if (!goesOnFrom(from_, ahead.face[next], ahead.cosine[next])) return;
  }
}

bool PieceTracer::goesOnFrom(Beam& beam, int face, double cosine) {
  beam.state = wanted_.next(beam.state, face);
  const bool isWanted = wanted_.isWanted(beam.state), goesOn = wanted_.goesOn(beam.state);
  if (isWanted) (*arrived_)[beam.element][face] += beam.share;
  if (chains_) {
    beam.faces = code_.with(beam.faces, chains_->numberOf[static_cast<std::size_t>(face)], beam.met + 1);
    if (isWanted)
      chains_->all.push_back(
          {{entry_, beam.element, face}, goesIn_ * beam.share, beam.state, beam.faces, beam.met + 2});
  }
  if (!goesOn && !(isWanted && detailed_)) return false;
  const double reflectance = fresnel(std::min(cosine, 1.0), outOf_).reflectance;
  if (isWanted && detailed_ && beam.met < PrismLight::kOrdersTold)
    told_->byOrder[static_cast<std::size_t>(beam.met)] += goesIn_ * beam.share * (1.0 - reflectance);
  if (!goesOn) return false;
  beam.share *= reflectance;
  beam.weight *= reflectance;
  if (!wanted_.areShort() && (beam.share < smallest_ * kGivenUp || beam.met == kMostFaces)) {
    *cutOff_ += beam.share;
    return false;
  }
  beam.direction -= (2.0 * cosine) * normalVectorOf(face);
  const int plane = beam.element % kPlaneElements, odd = beam.element - plane;
  beam.element =
      face < kUpperEnd ? afterReflection(plane, face) + odd : (beam.element + kPlaneElements) % kPrismElements;
  ++beam.met;
  return true;
}

}  // namespace parhelion
