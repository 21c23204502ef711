// SPDX-License-Identifier: Apache-2.0
#include "beam/direction_patch.h"

#include <algorithm>
#include <cmath>

#include "math/portable.h"

namespace parhelion {

namespace {

// Triangles across which light stops getting out are parted so often, with exact directions.
constexpr int kEdgeDepth = 2;
// A class with less than this share of a patch's light is added node by node.
constexpr double kWeak = 1e-8;
// Classes that most patches have.
constexpr int kUsualClasses = 192;
// Multiples of these, less their whole parts, are spread evenly (the golden ratio and its square root).
constexpr double kByClass = 0.6180339887498949, kByPatch = 0.7861513777574233;

double fraction(double x) { return x - std::floor(x); }

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

DirectionPatch::DirectionPatch(const ScatterScene& scene, double cutShare, bool detailed) : scene_(scene) {
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
  const bool undeviated = c.of().isUndeviated();
  scene_.light.sample(start, samples_);
  for (const IceLight::Sample& sample : samples_) {
    see(c, sample);
    count(c, sample.xyz[1]);
    if (undeviated) continue;
    if (isWeak()) {
      for (std::size_t node = 0; node < kNodes; ++node)
        if (const double light = seen_.density[node] * bounds_.area() / kNodes; light > 0.0)
          for (AngleBins* all : {&bins.fine, &bins.coarse, &bins.other}) all->add(seen_.angle[node], light, sample.xyz);
      continue;
    }
    addTriangles(bins.fine, {c.of(), sample.index, sample.xyz}, 1);
    addTriangles(bins.coarse, {c.of(), sample.index, sample.xyz}, 2);
  }
  if (undeviated || !scene_.light.isContinuous()) return;
  scene_.light.sample(fraction(start + 0.5), samples_);
  for (const IceLight::Sample& sample : samples_) {
    see(c, sample);
    if (!isWeak()) addTriangles(bins.other, {c.of(), sample.index, sample.xyz}, 2);
  }
}

PARHELION_ALSO_AVX2 void DirectionPatch::see(const Class& c, const IceLight::Sample& sample) {
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
    energy = sample.share * higher(energy, Four{});
    const Triple<Four> s{load<Four>(&lightDir_[0][node]), load<Four>(&lightDir_[1][node]),
                         load<Four>(&lightDir_[2][node])};
    const auto exit = of.exit(s, index);
    store(&seen_.energy[node], energy);
    store(&seen_.density[node], Four(energy * exit.transmittance));
    store(&seen_.angle[node], angleBetweenUnit(s, exit.lightDir));
    store(&seen_.excess[node], exit.excess);
    store(&seen_.cosine[node], dot(s, exit.lightDir));
  }
}

void DirectionPatch::count(const Class& c, double light) {
  const bool undeviated = c.of().isUndeviated();
  for (std::size_t node = 0; node < kNodes; ++node) {
    totals_[node].cosine += light * seen_.density[node] * seen_.cosine[node];
    totals_[node].out += light * seen_.density[node];
    if (undeviated) totals_[node].undeviated += light * seen_.density[node];
  }
}

bool DirectionPatch::isWeak() const {
  double light = 0.0;
  for (std::size_t node = 0; node < kNodes; ++node) light += seen_.density[node];
  return light * bounds_.area() / kNodes < strong_;
}

DirectionPatch::Corner DirectionPatch::corner(int row, int column) const {
  const auto node = static_cast<std::size_t>(row * kSide + column);
  return {bounds_.phi0 + (bounds_.phi1 - bounds_.phi0) * column / kCells,
          bounds_.zeta0 + (bounds_.zeta1 - bounds_.zeta0) * row / kCells,
          seen_.energy[node],
          seen_.density[node],
          seen_.angle[node],
          seen_.excess[node]};
}

PARHELION_ALSO_AVX2 void DirectionPatch::addTriangles(AngleBins& bins, const Exit& exit, int step) const {
  const double area = 0.5 * bounds_.area() * step * step / (kCells * kCells);
  const int depth = step == 1 ? kEdgeDepth : kEdgeDepth + 1;
  for (int row = 0; row < kCells; row += step)
    for (int column = 0; column < kCells; column += step) {
      const Corner a = corner(row, column), b = corner(row, column + step), c = corner(row + step, column),
                   d = corner(row + step, column + step);
      addTriangle(bins, exit, a, b, c, area, depth);
      addTriangle(bins, exit, b, d, c, area, depth);
    }
}

void DirectionPatch::addTriangle(AngleBins& bins, const Exit& exit, const Corner& a, const Corner& b, const Corner& c,
                                 double area, int depth) const {
  const int out = (a.excess > 0.0) + (b.excess > 0.0) + (c.excess > 0.0);
  if (out == 0 || !(a.energy + b.energy + c.energy > 0.0)) return;
  if (out == 3 || depth == 0) {
    const double angle[3] = {a.angle, b.angle, c.angle};
    const double density[3] = {area * a.density, area * b.density, area * c.density};
    return bins.addTriangle(angle, density, exit.xyz);
  }
  const auto between = [&](const Corner& p, const Corner& q) {
    const double phi = 0.5 * (p.phi + q.phi), zeta = 0.5 * (p.zeta + q.zeta), energy = 0.5 * (p.energy + q.energy);
    const Triple<double> s = lightDirAt(phi, zeta);
    const auto leaves = exit.of.exit(s, RelativeIndexOf<double>(exit.index));
    return Corner{phi,          zeta, energy, energy * leaves.transmittance, angleBetweenUnit(s, leaves.lightDir),
                  leaves.excess};
  };
  const Corner ab = between(a, b), bc = between(b, c), ca = between(c, a);
  addTriangle(bins, exit, a, ab, ca, 0.25 * area, depth - 1);
  addTriangle(bins, exit, ab, b, bc, 0.25 * area, depth - 1);
  addTriangle(bins, exit, ca, bc, c, 0.25 * area, depth - 1);
  addTriangle(bins, exit, ab, bc, ca, 0.25 * area, depth - 1);
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
