// SPDX-License-Identifier: Apache-2.0
#include "beam/direction_patch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/portable.h"

namespace parhelion {

namespace {

// Triangles across which angles stray from linear ones by more than the first share of a bin are parted, with exact
// directions, until it is less than the second; and those across which light stops getting out until they are as wide
// as the third. Not more often than so many times.
constexpr double kStraight = 0.03, kBent = 0.1, kEdgeWidth = 0.5;
constexpr int kMostDepth = 5;
// Between its corners light of a triangle may go as far beyond their angles, over what these differ by.
constexpr double kBeyond = 1.0;
// For light that is no more than this share of what a bin would have if all were spread evenly, bins count as wider.
constexpr double kFaint = 0.03;
// A class with less than this share of a patch's light is added node by node.
constexpr double kWeak = 1e-8;
// Classes that most patches have.
constexpr int kUsualClasses = 192;
// Multiples of these, less their whole parts, are spread evenly (the golden ratio and its square root).
constexpr double kByClass = 0.6180339887498949, kByPatch = 0.7861513777574233;

// By how many of a segment's places they differ from one segment, row and column of quads to the next: as evenly
// spread over the quads around each as they can be.
constexpr std::size_t kBySegment = 11, kByRow = 7, kByColumn = 19;

double fraction(double x) { return x - std::floor(x); }

PARHELION_INLINE double mixed(double from, double to, double at) { return from + at * (to - from); }

}  // namespace

void ScatterTotals::add(const ScatterTotals& other, double factor) {
  intercepted += factor * other.intercepted;
  external += factor * other.external;
  undeviated += factor * other.undeviated;
  cosine += factor * other.cosine;
  path += factor * other.path;
  cutOff += factor * other.cutOff;
  out += factor * other.out;
  for (std::size_t k = 0; k < byOrder.size(); ++k) byOrder[k] += factor * other.byOrder[k];
}

DirectionPatch::DirectionPatch(const ScatterScene& scene, double allDirections, double cutShare, bool detailed)
    : scene_(scene), allDirections_(allDirections) {
  std::vector<const WantedPaths*> kinds;
  for (const WantedPaths& wanted : scene.wanted) kinds.push_back(&wanted);
  if (kinds.empty()) kinds.push_back(nullptr);
  for (const PrismShare& prism : scene.prisms)
    for (const WantedPaths* wanted : kinds) {
      const double share = prism.share / static_cast<double>(kinds.size());
      perShadow_.push_back(4.0 * share / scene.section.surface(prism.length));
      for (const double index : scene.light.nodes())
        tracers_.emplace_back(scene.section, prism.length, index, cutShare, detailed, wanted);
    }
  slot_.fill(-1);
  classes_.reserve(kUsualClasses);
  for (Row& coordinate : lightDir_) coordinate.fill(0.5);  // behind the last node, too
}

DirectionPatch::Class& DirectionPatch::classOf(int number) {
  int& slot = slot_[static_cast<std::size_t>(number)];
  if (slot < 0) {
    slot = used_++;
    if (classes_.size() < static_cast<std::size_t>(used_))
      classes_.push_back({number, std::vector<Row>(scene_.light.nodes().size())});
    Class& made = classes_[static_cast<std::size_t>(slot)];
    made.number = number;
    for (Row& row : made.met) row.fill(0.0);
  }
  return classes_[static_cast<std::size_t>(slot)];
}

void DirectionPatch::add(const PatchBounds& bounds, int number, Bins& bins) {
  bounds_ = bounds;
  for (int k = 0; k < used_; ++k) slot_[static_cast<std::size_t>(classes_[static_cast<std::size_t>(k)].number)] = -1;
  used_ = 0;
  for (int node = 0; node < kNodes; ++node) traceNode(node);
  strong_ = kWeak * (scene_.wanted.empty() ? totals(1).intercepted : met());
  for (int k = 0; k < used_; ++k) {
    const Class& c = classes_[static_cast<std::size_t>(k)];
    addClass(c, fraction(kByClass * c.number + kByPatch * number), bins);
  }
}

double DirectionPatch::evenLight(double angle, double width) const {
  return 0.5 * portable::sin(angle) * width * allDirections_;
}

double DirectionPatch::met() const {
  double sum = 0.0;
  for (int k = 0; k < used_; ++k)
    for (std::size_t n = 0; n < scene_.light.nodes().size(); ++n)
      for (std::size_t node = 0; node < kNodes; ++node)
        sum += scene_.light.nodeShares()[n] * classes_[static_cast<std::size_t>(k)].met[n][node];
  return sum * bounds_.area() / kNodes;
}

void DirectionPatch::traceNode(int node) {
  const double phi = bounds_.phi0 + (bounds_.phi1 - bounds_.phi0) * (node % kSide) / kCells;
  const double zeta = bounds_.zeta0 + (bounds_.zeta1 - bounds_.zeta0) * (node / kSide) / kCells;
  const Triple<double> lightDir = lightDirAt(phi, zeta);
  const auto k = static_cast<std::size_t>(node);
  lightDir_[0][k] = lightDir.x;
  lightDir_[1][k] = lightDir.y;
  lightDir_[2][k] = lightDir.z;
  totals_[k] = {};
  for (std::size_t tracer = 0; tracer < tracers_.size(); ++tracer) {
    traceAt(tracers_[tracer], phi, zeta, 0.5 * (bounds_.phi0 + bounds_.phi1), light_);
    takeLight(node, portable::sin(zeta), tracer);
  }
}

void DirectionPatch::takeLight(int node, double perAngles, std::size_t tracer) {
  const std::size_t indices = scene_.light.nodes().size(), n = tracer % indices;
  const double share = perShadow_[tracer / indices] * perAngles;  // of such prisms, at this index
  const double ofAll = share * scene_.light.nodeShares()[n];
  ScatterTotals& totals = totals_[static_cast<std::size_t>(node)];
  totals.intercepted += ofAll * light_.totalShadow();
  totals.path += ofAll * light_.path;
  for (std::size_t order = 0; order < totals.byOrder.size(); ++order)
    totals.byOrder[order] += ofAll * light_.byOrder[order];
  for (std::size_t e = 0; e < kPrismFaces; ++e) {
    const double outside = light_.shadow[e] * light_.reflectance[e];
    totals.external += ofAll * (light_.mirrored[e] * light_.reflectance[e]);
    totals.cutOff += ofAll * (light_.shadow[e] - outside) * light_.cutOff[e];
  }
  forEachClass(light_, [&](int number, double light) {
    classOf(number).met[n][static_cast<std::size_t>(node)] += share * light;
  });
}

void DirectionPatch::addClass(const Class& c, double start, Bins& bins) {
  const LightClass of = c.of();
  constexpr std::size_t kNone = ~std::size_t{0};
  std::array<std::size_t, 2> sampleOf{kNone, kNone};
  const auto seenAt = [&](std::size_t sample) -> const Seen& {
    Seen& seen = seen_[sample % 2];
    if (std::exchange(sampleOf[sample % 2], sample) != sample) {
      see(c, scene_.light.samples()[sample], seen);
      findBends(seen);
    }
    return seen;
  };
  auto first = static_cast<std::size_t>(start * IceLight::Segment::kPlaces);
  for (const IceLight::Segment& light : scene_.light.segments()) {
    const Exit exit{of, light, seenAt(light.from), seenAt(light.to), first += kBySegment};
    count(exit);
    if (of.isUndeviated()) continue;
    if (isWeak(exit)) {
      addNodes(exit, bins);
    } else if (light.isLine()) {
      addQuads<true>(bins.fine, exit, 1);
      addQuads<true>(bins.coarse, exit, 2);
    } else {
      addQuads<false>(bins.fine, exit, 1);
      addQuads<false>(bins.coarse, exit, 2);
      const Exit other{of, light, exit.from, exit.to, first + IceLight::Segment::kPlaces / 2};
      addQuads<false>(bins.other, other, 2);
    }
  }
}

PARHELION_ALSO_AVX2 void DirectionPatch::see(const Class& c, const IceLight::Sample& sample, Seen& seen) const {
  const LightClass of = c.of();
  const RelativeIndexOf<Four> index(all<Four>(sample.index));
  const auto row = [&](int k) {
    return c.met[static_cast<std::size_t>(sample.node[static_cast<std::size_t>(k)])].data();
  };
  for (std::size_t node = 0; node < kNodes; node += 4) {
    Four energy = sample.part[0] * load<Four>(row(0) + node);
    for (int k = 1; k < IceLight::kMixed; ++k)
      if (sample.part[static_cast<std::size_t>(k)] != 0.0)
        energy += sample.part[static_cast<std::size_t>(k)] * load<Four>(row(k) + node);
    energy = higher(energy, Four{});
    const Triple<Four> s{load<Four>(&lightDir_[0][node]), load<Four>(&lightDir_[1][node]),
                         load<Four>(&lightDir_[2][node])};
    const auto exit = of.exit(s, index);
    store(&seen.energy[node], energy);
    store(&seen.density[node], Four(energy * exit.transmittance));
    store(&seen.angle[node], angleBetweenUnit(s, exit.lightDir));
    store(&seen.excess[node], exit.excess);
    store(&seen.cosine[node], dot(s, exit.lightDir));
  }
}

void DirectionPatch::count(const Exit& exit) {
  double far = 0.0;
  for (const double at : exit.light.at) far += at / IceLight::Segment::kPlaces;
  const auto countAt = [&](const Seen& seen, double share) {
    for (std::size_t node = 0; node < kNodes; ++node) {
      const double light = share * seen.density[node];
      totals_[node].cosine += light * seen.cosine[node];
      totals_[node].out += light;
      if (exit.of.isUndeviated()) totals_[node].undeviated += light;
    }
  };
  countAt(exit.from, (1.0 - far) * exit.light.share);
  if (!exit.light.isLine()) countAt(exit.to, far * exit.light.share);
}

bool DirectionPatch::isWeak(const Exit& exit) const {
  double light = 0.0;
  for (std::size_t node = 0; node < kNodes; ++node) light += 0.5 * (exit.from.density[node] + exit.to.density[node]);
  return light * exit.light.share * bounds_.area() / kNodes < strong_;
}

void DirectionPatch::addNodes(const Exit& exit, Bins& bins) const {
  const double area = exit.light.share * bounds_.area() / kNodes;
  for (std::size_t node = 0; node < kNodes; ++node) {
    const double t = exit.light.at[(exit.first + node) % IceLight::Segment::kPlaces];
    const double density = mixed(exit.from.density[node], exit.to.density[node], t);
    if (!(density > 0.0)) continue;
    const double angle = mixed(exit.from.angle[node], exit.to.angle[node], t);
    for (AngleBins* all : {&bins.fine, &bins.coarse, &bins.other}) all->add(angle, area * density);
  }
}

DirectionPatch::Corner DirectionPatch::seen(const Exit& exit, double phi, double zeta, double energy, double at) const {
  const std::vector<IceLight::Sample>& samples = scene_.light.samples();
  const double index = mixed(samples[exit.light.from].index, samples[exit.light.to].index, at);
  const Triple<double> s = lightDirAt(phi, zeta);
  const auto leaves = exit.of.exit(s, RelativeIndexOf<double>(index));
  return {phi, zeta, energy, energy * leaves.transmittance, angleBetweenUnit(s, leaves.lightDir), leaves.excess};
}

DirectionPatch::Corner DirectionPatch::corner(const Exit& exit, std::size_t node, double at) const {
  const std::size_t row = node / kSide, column = node % kSide;
  const double phi = bounds_.phi0 + (bounds_.phi1 - bounds_.phi0) * static_cast<double>(column) / kCells,
               zeta = bounds_.zeta0 + (bounds_.zeta1 - bounds_.zeta0) * static_cast<double>(row) / kCells;
  return seen(exit, phi, zeta, mixed(exit.from.energy[node], exit.to.energy[node], at), at);
}

void DirectionPatch::findBends(Seen& seen) {
  // Between nodes an angle strays from a line by an eighth of its second difference.
  const auto at = [&](int row, int column) { return seen.angle[static_cast<std::size_t>(row * kSide + column)]; };
  const auto across = [&](int row, int column, int rows, int columns) {
    // At a rim the last one inside counts.
    const int r = std::clamp(row, std::abs(rows), kCells - std::abs(rows)),
              c = std::clamp(column, std::abs(columns), kCells - std::abs(columns));
    return std::abs(at(r - rows, c - columns) - 2.0 * at(r, c) + at(r + rows, c + columns)) / 8.0;
  };
  for (int row = 0; row <= kCells; ++row)
    for (int column = 0; column <= kCells; ++column)
      seen.bend[static_cast<std::size_t>(row * kSide + column)] =
          std::max({across(row, column, 0, 1), across(row, column, 1, 0), across(row, column, 1, -1)});
}

void DirectionPatch::addPart(AngleBins& bins, const Exit& exit, double at, const Corner& a, const Corner& b,
                             const Corner& c, double area, int depth) const {
  if (std::max({a.excess, b.excess, c.excess}) <= 0.0) return;
  const auto add = [&](double shift) {
    const double angle[3] = {a.angle + shift, b.angle + shift, c.angle + shift};
    const double density[3] = {area * a.density, area * b.density, area * c.density};
    bins.addTriangle(angle, density);
  };
  if (depth == 0) return add(0.0);
  const auto between = [&](const Corner& p, const Corner& q) {
    return seen(exit, 0.5 * (p.phi + q.phi), 0.5 * (p.zeta + q.zeta), 0.5 * (p.energy + q.energy), at);
  };
  const Corner ab = between(a, b), bc = between(b, c), ca = between(c, a);
  const auto bent = [](const Corner& p, const Corner& middle, const Corner& q) {
    return std::abs(middle.angle - 0.5 * (p.angle + q.angle));
  };
  const auto [low, high] = std::minmax({a.angle, b.angle, c.angle, ab.angle, bc.angle, ca.angle});
  if (!bins.reaches(low - kBeyond * (high - low), high + kBeyond * (high - low))) return;
  const double light = area * (a.density + b.density + c.density);
  const double width = bins.width() * (1.0 + kFaint * evenLight(high, bins.width()) / light);
  // Where some light does not get out, its density has a root at the edge.
  if (std::min({a.excess, b.excess, c.excess}) <= 0.0) {
    if (high - low < kEdgeWidth * width) return add(0.0);
  } else if (std::max({bent(a, ab, b), bent(b, bc, c), bent(c, ca, a)}) < kBent * width) {
    // The mean of a quadratic function is that of the middles of the edges.
    return add((ab.angle + bc.angle + ca.angle - a.angle - b.angle - c.angle) / 3.0);
  }
  addPart(bins, exit, at, a, ab, ca, 0.25 * area, depth - 1);
  addPart(bins, exit, at, ab, b, bc, 0.25 * area, depth - 1);
  addPart(bins, exit, at, ca, bc, c, 0.25 * area, depth - 1);
  addPart(bins, exit, at, ab, bc, ca, 0.25 * area, depth - 1);
}

template <bool isLine>
PARHELION_INLINE void DirectionPatch::addQuads(AngleBins& bins, const Exit& exit, int step) const {
  const double area = 0.5 * exit.light.share * bounds_.area() * step * step / (kCells * kCells);
  const int depth = step == 1 ? kMostDepth : kMostDepth + 1;
  const double straight = kStraight * bins.width() / (step * step);
  const auto stride = static_cast<std::size_t>(step);
  std::size_t rowPlace = exit.first;
  for (std::size_t row = 0; row < kCells; row += stride, rowPlace += kByRow) {
    std::size_t place = rowPlace;
    for (std::size_t column = 0; column < kCells; column += stride, place += kByColumn) {
      const std::size_t a = row * kSide + column, c = a + stride * kSide;
      const std::size_t node[4] = {a, a + stride, c, c + stride};
      double energy = 0.0, light = 0.0, least = exit.from.excess[a], most = least, bend = 0.0, low = exit.from.angle[a],
             high = low;
      const auto look = [&](const Seen& seen) __attribute__((always_inline)) {
        for (const std::size_t n : node) {
          energy += seen.energy[n];
          light += seen.density[n];
          least = std::min(least, seen.excess[n]);
          most = std::max(most, seen.excess[n]);
          bend = std::max(bend, seen.bend[n]);
          low = std::min(low, seen.angle[n]);
          high = std::max(high, seen.angle[n]);
        }
      };
      look(exit.from);
      if (!isLine) look(exit.to);
      if (!(most > 0.0 && energy > 0.0)) continue;
      const double beyond = kBeyond * (bend + high - low);
      if (!bins.reaches(low - beyond, high + beyond)) continue;
      const double t = isLine ? 0.0 : exit.light.at[place % IceLight::Segment::kPlaces];
      const bool isStraight =
          bend < straight ||
          bend * area * light < straight * (area * light + kFaint * evenLight(exit.from.angle[a], bins.width()));
      if (least > 0.0 && isStraight) {
        double angle[4], density[4];
        for (std::size_t k = 0; k < 4; ++k) {
          angle[k] = exit.from.angle[node[k]];
          density[k] = exit.from.density[node[k]];
          if (!isLine) {
            angle[k] = mixed(angle[k], exit.to.angle[node[k]], t);
            density[k] = mixed(density[k], exit.to.density[node[k]], t);
          }
          density[k] *= area;
        }
        bins.addTriangle(angle, density);
        bins.addTriangle(angle + 1, density + 1);
        continue;
      }
      const Corner corners[4] = {corner(exit, node[0], t), corner(exit, node[1], t), corner(exit, node[2], t),
                                 corner(exit, node[3], t)};
      addPart(bins, exit, t, corners[0], corners[1], corners[2], area, depth);
      addPart(bins, exit, t, corners[1], corners[3], corners[2], area, depth);
    }
  }
}

ScatterTotals DirectionPatch::totals(int step) const {
  ScatterTotals sum, result;
  for (int row = 0; row <= kCells; row += step)
    for (int column = 0; column <= kCells; column += step)
      sum.add(totals_[static_cast<std::size_t>(row * kSide + column)],
              (row % kCells ? 1.0 : 0.5) * (column % kCells ? 1.0 : 0.5));
  result.add(sum, bounds_.area() * step * step / (kCells * kCells));
  return result;
}

}  // namespace parhelion
