// SPDX-License-Identifier: Apache-2.0
#include "beam/band_light.h"

#include <algorithm>
#include <cmath>

#include "beam/edge_parts.h"
#include "math/arctangent.h"
#include "math/portable.h"
#include "parallel/loops.h"

namespace parhelion {

namespace {

// Triangles across which light stops getting out are parted so often, where it is faint less often, and not below this
// share of a cell.
constexpr int kEdgeDepth = 4, kFaintEdgeDepth = 2;
constexpr double kSmallPart = 0.5;
// Pieces of work that bands are made by, each of which has a room of its own.
constexpr std::size_t kPieces = 4;
// Light of a class is faint in a band if it is less than this over the number of rings.
constexpr double kFaint = 0.05;
// Orders a ring needs: those of waves as long as cells are on the largest ring, times this, and some more.
constexpr double kOrders = 1.5, kMoreOrders = 24.0;

}  // namespace

RingLayout::RingLayout(const BandMesh& mesh, const CosineTable& cosines, int channels) : places_(1) {
  for (int ring = 0; ring < mesh.rings; ++ring) {
    const double sine = portable::sincos(std::clamp((ring + 0.5) / mesh.rings, 0.0, 1.0) * kPi).sin;
    const double orders = std::min(kOrders * mesh.cells * sine + kMoreOrders, mesh.orders);
    rooms_.push_back(ring < mesh.first || ring >= mesh.end ? 0 : cosines.room(orders));
    places_.push_back(places_.back() + static_cast<std::size_t>(2 * channels * rooms_.back()));
  }
}

/// Memory that bands are made in, one after the other.
struct BandLight::Scratch {
  virtual ~Scratch() = default;
  Ends ends;
};

/// The same with the rings' film.
template <int C>
struct BandLight::Room : Scratch {
  explicit Room(const BandMesh& mesh) : film(mesh.cells, mesh.first, mesh.end) {}
  RingFilm<C> film;
};

BandLight::BandLight(const LightTable& table, const CosineTable& cosines, const BandMesh& mesh, bool colours,
                     const LightSegments& lights, const LightSegments& fewLights)
    : table_(table),
      cosines_(cosines),
      mesh_(mesh),
      colours_(colours),
      lights_(lights),
      fewLights_(fewLights),
      layout_(mesh, cosines, channels()) {}

BandLight::~BandLight() = default;

void BandLight::make(std::span<const int> numbers, std::vector<Band>& to) {
  scratch_.resize(kPieces);
  forEach(std::min(kPieces, numbers.size()), [&](std::size_t piece) {
    for (std::size_t k = piece; k < numbers.size(); k += kPieces) {
      clear(to[k]);
      if (colours_)
        make<4>(numbers[k], scratch_[piece], to[k]);
      else
        make<2>(numbers[k], scratch_[piece], to[k]);
    }
  });
}

void BandLight::clear(Band& band) const {
  band.totals = {};
  if (band.lit.empty()) {
    band.light.assign(layout_.size(), 0.0F);
    band.lit.assign(static_cast<std::size_t>(mesh_.rings), false);
  }
  for (int ring = mesh_.first; ring < mesh_.end; ++ring) {
    if (!band.lit[static_cast<std::size_t>(ring)]) continue;
    std::fill_n(band.light.begin() + static_cast<std::ptrdiff_t>(layout_.placeOf(ring)),
                2 * channels() * layout_.room(ring), 0.0F);
    band.lit[static_cast<std::size_t>(ring)] = false;
  }
}

template <int C>
void BandLight::make(int band, std::unique_ptr<Scratch>& scratch, Band& to) const {
  if (!scratch) scratch = std::make_unique<Room<C>>(mesh_);
  auto& room = static_cast<Room<C>&>(*scratch);
  Ends& ends = room.ends;
  const double thick = 0.5 * kPi / mesh_.bands;
  ends.alphaA = band * thick;
  ends.alphaB = ends.alphaA + thick;
  for (const int step : {1, 2}) {
    const LightSegments& lights = step == 1 ? lights_ : fewLights_;
    const std::size_t indices = lights.indices.size();
    std::vector<std::vector<double>> parts;
    for (const double index : lights.indices) parts.push_back(table_.partsOf(index));
    ends.a.resize(std::max(ends.a.size(), indices));
    ends.b.resize(std::max(ends.b.size(), indices));
    const auto mean = [&](const auto& of) {
      double sum = 0.0;
      for (const LightSegments::Segment& segment : lights.segments)
        sum += 0.25 * segment.share *
               (of(ends.alphaA, segment.from) + of(ends.alphaA, segment.to) + of(ends.alphaB, segment.from) +
                of(ends.alphaB, segment.to));
      return sum;
    };
    if (step == 1) {
      to.totals.intercepted +=
          mean([&](double alpha, std::size_t n) { return table_.totalsAt(alpha, parts[n]).intercepted; });
      to.totals.cutOff += mean([&](double alpha, std::size_t n) { return table_.totalsAt(alpha, parts[n]).cutOff; });
    }
    for (const int number : table_.classesIn(band)) {
      ends.number = number;
      bool dark = true;
      for (std::size_t n = 0; n < indices; ++n) {
        see(ends.alphaA, lights.indices[n], parts[n], number, step, ends.a[n]);
        see(ends.alphaB, lights.indices[n], parts[n], number, step, ends.b[n]);
        dark = dark && ends.a[n].dark && ends.b[n].dark;
      }
      if (dark) continue;
      if (LightClass(number).isUndeviated()) {
        if (step == 1)
          to.totals.undeviated += mean([&](double alpha, std::size_t n) {
            const Row& row = alpha == ends.alphaA ? ends.a[n] : ends.b[n];
            return row.dark ? 0.0 : table_.meanOf(row.density);
          });
        continue;
      }
      for (const LightSegments::Segment& segment : lights.segments)
        addSegment<C>(ends, lights, segment, step, room.film);
    }
  }
  analyse<C>(room.film, to);
}

PARHELION_ALSO_AVX2 void BandLight::see(double alpha, double index, const std::vector<double>& parts, int number,
                                        int stride, Row& row) const {
  const auto size = static_cast<std::size_t>(table_.room());
  for (auto* values : {&row.light, &row.density, &row.excess, &row.place, &row.turn}) values->resize(size);
  row.dark = !table_.lightAt(alpha, number, parts, stride, row.light.data());
  if (row.dark) return;
  const LightClass of(number);
  const RelativeIndexOf<Four> relative(all<Four>(index));
  const auto [sin, cos] = portable::sincos(alpha);
  const double ringsPerAngle = mesh_.rings / kPi, cellsPerAngle = mesh_.cells / kPi;
  for (std::size_t k = 0; k < size; k += 4) {
    const Four light = higher(load<Four>(&row.light[k]), Four{});
    const ClassExit<Four> exit =
        of.exitAcross(sin, cos, load<Four>(&table_.sines()[k]), load<Four>(&table_.cosines()[k]), relative);
    const auto& [along, aside, upward] = exit.lightDir;
    // Toward the sky, by the direction of the sun, that of c across it, and what is at right angles to both.
    const Four onto = sin * along - cos * upward, toward = -(cos * along + sin * upward);
    store(&row.light[k], light);
    store(&row.density[k], Four(light * exit.transmittance));
    store(&row.excess[k], exit.excess);
    store(&row.place[k], Four(ringsPerAngle * arctangent(Four(squareRoot(toward * toward + aside * aside)), onto)));
    store(&row.turn[k], Four(cellsPerAngle * arctangent(aside, toward)));
  }
}

RingCorner BandLight::exitAt(RingCorner corner, double index, int number) const {
  const auto [sin, cos] = portable::sincos(corner.alpha);
  const auto [sinPhi, cosPhi] = portable::sincos(corner.phi);
  const ClassExit<double> exit =
      LightClass(number).exitAcross(sin, cos, sinPhi, cosPhi, RelativeIndexOf<double>(index));
  const auto& [along, aside, upward] = exit.lightDir;
  const double onto = sin * along - cos * upward, toward = -(cos * along + sin * upward);
  corner.density = corner.light * exit.transmittance;
  corner.excess = exit.excess;
  corner.place = mesh_.rings / kPi * arctangent(std::sqrt(toward * toward + aside * aside), onto);
  corner.turn = mesh_.cells / kPi * arctangent(aside, toward);
  return corner;
}

template <int C>
void BandLight::addSegment(const Ends& ends, const LightSegments& lights, const LightSegments::Segment& segment,
                           int step, RingFilm<C>& film) const {
  const double share = 0.5 * step / table_.columns(), faint = kFaint * table_.wantedShare() / mesh_.rings;
  const bool isLine = segment.from == segment.to;
  std::array<typename RingFilm<C>::Floats, LightSegments::kColours> colours{};
  for (std::size_t j = 0; j < colours.size(); ++j) {
    if (step == 2)
      colours[j][C - 1] = static_cast<float>(segment.share * (C == 4 ? segment.xyz[j][1] : 1.0));
    else if (C == 4)
      for (int c = 0; c < 3; ++c)
        colours[j][c] = static_cast<float>(segment.share * segment.xyz[j][static_cast<std::size_t>(c)]);
    else
      colours[j][0] = static_cast<float>(segment.share);
  }
  const auto corner = [&](const Row& row, double alpha, double index, int column) {
    const auto k = static_cast<std::size_t>(column);
    const double phi = table_.azimuthAt(column);
    if (row.dark) return exitAt({alpha, phi, 0.0, 0.0, 0.0, 0.0, 0.0}, index, ends.number);
    return RingCorner{alpha, phi, row.light[k], row.density[k], row.excess[k], row.place[k], row.turn[k]};
  };
  const std::size_t sides[2] = {segment.from, segment.to};
  for (int column = 0; column < table_.columns(); column += step) {
    const auto k = static_cast<std::size_t>(column), l = k + static_cast<std::size_t>(step);
    const auto lit = [&](const Row& row) { return row.dark ? 0.0 : row.light[k] + row.light[l]; };
    double all = lit(ends.a[segment.from]) + lit(ends.b[segment.from]);
    if (!isLine) all += lit(ends.a[segment.to]) + lit(ends.b[segment.to]);
    if (all <= 0.0) continue;
    RingCorner quad[2][4];
    double least = 1.0, most = -1.0, light = 0.0;
    for (int side = 0; side < (isLine ? 1 : 2); ++side) {
      const std::size_t n = sides[side];
      const double index = lights.indices[n];
      quad[side][0] = corner(ends.a[n], ends.alphaA, index, column);
      quad[side][1] = corner(ends.a[n], ends.alphaA, index, column + step);
      quad[side][2] = corner(ends.b[n], ends.alphaB, index, column);
      quad[side][3] = corner(ends.b[n], ends.alphaB, index, column + step);
      for (const RingCorner& one : quad[side]) {
        least = std::min(least, one.excess);
        most = std::max(most, one.excess);
        light += one.density;
      }
    }
    if (most <= 0.0) continue;
    if (least > 0.0 && !isLine) {
      film.addSpread(quad[0], quad[1], share, segment.at, colours, static_cast<unsigned>(3 * column));
      continue;
    }
    if (least > 0.0 && share * light < faint) {
      film.addFaint(quad[0], share, colours[0]);
      continue;
    }
    // Where light stops getting out, each quad takes one of the segment's colours.
    const std::size_t j = isLine ? 0 : static_cast<std::size_t>(5 * column + 3 * ends.number) % colours.size();
    const double index =
        lights.indices[segment.from] + segment.at[j] * (lights.indices[segment.to] - lights.indices[segment.from]);
    if (!isLine)
      for (int n = 0; n < 4; ++n) {
        RingCorner& own = quad[0][n];
        own.light += segment.at[j] * (quad[1][n].light - own.light);
        own = exitAt(own, index, ends.number);
      }
    const auto between = [&](const RingCorner& p, const RingCorner& q) {
      return exitAt({0.5 * (p.alpha + q.alpha), 0.5 * (p.phi + q.phi), 0.5 * (p.light + q.light), 0.0, 0.0, 0.0, 0.0},
                    index, ends.number);
    };
    const auto add = [&](const RingCorner& p, const RingCorner& q, const RingCorner& r, double part) {
      film.add(p, q, r, part, colours[j]);
    };
    const auto isSmall = [&](const RingCorner& p, const RingCorner& q, const RingCorner& r) {
      const auto width = [](double a, double b, double c) { return std::max({a, b, c}) - std::min({a, b, c}); };
      return std::max(width(p.place, q.place, r.place), width(p.turn, q.turn, r.turn)) < kSmallPart;
    };
    const int depth = share * all < faint ? kFaintEdgeDepth : kEdgeDepth;
    const auto& [p, q, r, t] = quad[0];
    addParts(p, q, r, share, depth, between, add, isSmall);
    addParts(q, t, r, share, depth, between, add, isSmall);
  }
}

template <int C>
void BandLight::analyse(RingFilm<C>& film, Band& to) const {
  std::vector<CosineTable::CellPair<C>> pairs;
  for (int ring = mesh_.first; ring < mesh_.end; ++ring) {
    film.take(ring, pairs);
    if (pairs.empty()) continue;
    to.lit[static_cast<std::size_t>(ring)] = true;
    cosines_.analyse<C>(pairs, layout_.room(ring), to.light.data() + layout_.placeOf(ring));
  }
}

}  // namespace parhelion
