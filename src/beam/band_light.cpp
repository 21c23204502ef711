// SPDX-License-Identifier: Apache-2.0
#include "beam/band_light.h"

#include <algorithm>
#include <cmath>

#include "beam/edge_parts.h"
#include "beam/triangle_cells.h"
#include "math/arctangent.h"
#include "math/portable.h"
#include "parallel/loops.h"

namespace parhelion {

namespace {

/// As many floats side by side as there are channels.
template <int C>
struct Channels {
  using Floats [[gnu::vector_size(C * sizeof(float))]] = float;
};

constexpr int kEdgeDepth = 4;
// Pieces of work that bands are made by, each of which has a room of its own.
constexpr std::size_t kPieces = 4;
// Cells beyond either end of the half ring, for triangles that reach over it.
constexpr int kBeyond = 32;
// Faint light is put to its place by points: so many to a cell's side, and at most along a side.
constexpr double kFaintPoints = 1.2, kSpreadPoints = 2.5, kMostPoints = 64.0;
constexpr double kFaint = 0.05;
// Orders a ring needs: those of waves as long as cells are on the largest ring, times this, and some more.
constexpr double kOrders = 1.5, kMoreOrders = 24.0;

}  // namespace

/// Memory that bands are made in, one after the other.
struct BandLight::Scratch {
  virtual ~Scratch() = default;
  Ends ends;
};

/// Rings about the sun for one azimuth of c.
template <int C>
class BandLight::Room : public Scratch {
 public:
  using Floats = typename Channels<C>::Floats;

  Room(int cells, int first, int end)
      : cells_(cells),
        beyond_(std::min(kBeyond, cells)),
        width_(cells + 2 * beyond_),
        first_(first),
        rows_(end - first),
        film_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(rows_)),
        from_(static_cast<std::size_t>(rows_), width_),
        to_(static_cast<std::size_t>(rows_), -1) {}

  /// Adds the light of a triangle by its places among the rings and its turns, which may be of any sign.
  PARHELION_INLINE void add(const Corner& a, const Corner& b, const Corner& c, double share, const Floats& per) {
    const double light[3] = {share * a.density, share * b.density, share * c.density};
    if (!(light[0] + light[1] + light[2] > 0.0)) return;
    // One turn is a neighbour of the others; the sky is the same on both sides.
    double turn[3] = {a.turn, b.turn, c.turn};
    const double half = cells_;
    for (int k = 1; k < 3; ++k) {
      if (turn[k] - turn[0] > half) turn[k] -= 2.0 * half;
      if (turn[k] - turn[0] < -half) turn[k] += 2.0 * half;
    }
    const double mean = turn[0] + turn[1] + turn[2];
    if (mean < 0.0)
      for (double& t : turn) t = -t;
    if (std::abs(mean) > 3.0 * half)
      for (double& t : turn) t = 2.0 * half - t;
    double least = std::min({turn[0], turn[1], turn[2]}), most = std::max({turn[0], turn[1], turn[2]});
    if (least < -beyond_ || most > half + beyond_) {
      for (double& t : turn) t = std::clamp(std::abs(t), 0.0, half);
      least = std::min({turn[0], turn[1], turn[2]});
      most = std::max({turn[0], turn[1], turn[2]});
    }
    const double low = std::min({a.place, b.place, c.place}) - first_,
                 high = std::max({a.place, b.place, c.place}) - first_;
    if (!(high >= 0.0 && low < rows_)) return;
    const int lastRow = std::min(static_cast<int>(high), rows_ - 1), from = static_cast<int>(least + beyond_),
              to = std::min(static_cast<int>(most + beyond_), width_ - 1);
    for (int row = std::max(static_cast<int>(low), 0); row <= lastRow; ++row) {
      const auto r = static_cast<std::size_t>(row);
      from_[r] = std::min(from_[r], from);
      to_[r] = std::max(to_[r], to);
    }
    shareOverCells(
        {turn[0] + beyond_, a.place - first_, light[0]}, {turn[1] + beyond_, b.place - first_, light[1]},
        {turn[2] + beyond_, c.place - first_, light[2]}, width_,
        rows_, [&](int x, int y, double own) __attribute__((always_inline)) {
          film_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)] +=
              static_cast<float>(own) * per;
        });
  }

  /// The same of two triangles that share the edge from the second corner to the third, by points.
  PARHELION_INLINE void addFaint(const Corner (&corner)[4], double share, const Floats& per) {
    double turn[4];
    const double half = cells_;
    for (int k = 0; k < 4; ++k) {
      turn[k] = corner[k].turn;
      if (turn[k] - turn[0] > half) turn[k] -= 2.0 * half;
      if (turn[k] - turn[0] < -half) turn[k] += 2.0 * half;
    }
    const Corner &a = corner[0], &b = corner[1], &c = corner[2], &d = corner[3];
    const auto parts = [](double x0, double y0, double x1, double y1) __attribute__((always_inline)) {
      return std::min(1.0 + std::floor(kFaintPoints * std::max(std::abs(x1 - x0), std::abs(y1 - y0))), kMostPoints);
    };
    const double rows = std::max(parts(turn[0], a.place, turn[2], c.place), parts(turn[1], b.place, turn[3], d.place)),
                 columns =
                     std::max(parts(turn[0], a.place, turn[1], b.place), parts(turn[2], c.place, turn[3], d.place));
    const double perRow = 1.0 / rows, perColumn = 1.0 / columns, own = 2.0 * share * perRow * perColumn;
    const double top = first_, bottom = first_ + rows_;
    for (double i = 0.5; i < rows; i += 1.0) {
      const double t = i * perRow;
      const double x = turn[0] + t * (turn[2] - turn[0]), y = a.place + t * (c.place - a.place),
                   light = own * (a.density + t * (c.density - a.density));
      const double dx = perColumn * (turn[1] + t * (turn[3] - turn[1]) - x),
                   dy = perColumn * (b.place + t * (d.place - b.place) - y),
                   dLight = perColumn * (own * (b.density + t * (d.density - b.density)) - light);
      for (double j = 0.5; j < columns; j += 1.0) {
        double px = std::abs(x + j * dx);
        if (px > half) px = 2.0 * half - px;
        const double py = y + j * dy;
        if (!(py >= top && py < bottom && px >= 0.0)) continue;
        const int column = std::min(static_cast<int>(px), cells_ - 1) + beyond_;
        const auto row = static_cast<std::size_t>(py - top);
        film_[row * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column)] +=
            static_cast<float>(light + j * dLight) * per;
        from_[row] = std::min(from_[row], column);
        to_[row] = std::max(to_[row], column);
      }
    }
  }

  /// The same for light between two indices, at each of which it fills a quad. `at` says where between them its
  /// colours are.
  PARHELION_INLINE void addSpread(const Corner (&from)[4], const Corner (&to)[4], double share,
                                  const std::array<double, LightSegments::kColours>& at,
                                  const std::array<Floats, LightSegments::kColours>& colours, unsigned start) {
    double turn[2][4];
    const double half = cells_;
    double moved = 0.0;
    for (int k = 0; k < 4; ++k) {
      turn[0][k] = from[k].turn;
      turn[1][k] = to[k].turn;
      for (double& one : {std::ref(turn[0][k]), std::ref(turn[1][k])}) {
        if (one - from[0].turn > half) one -= 2.0 * half;
        if (one - from[0].turn < -half) one += 2.0 * half;
      }
      moved = std::max({moved, std::abs(to[k].place - from[k].place), std::abs(turn[1][k] - turn[0][k])});
    }
    const auto parts = [&](int a, int b) __attribute__((always_inline)) {
      const double across = std::max(std::abs(turn[0][a] - turn[0][b]), std::abs(from[a].place - from[b].place));
      return std::min(1.0 + std::floor(kSpreadPoints * across), kMostPoints);
    };
    const double rows = std::max(parts(0, 2), parts(1, 3));
    double columns = std::max(parts(0, 1), parts(2, 3));
    columns = std::max(columns, std::min(std::ceil(kSpreadPoints * moved / rows), kMostPoints));
    const double perRow = 1.0 / rows, perColumn = 1.0 / columns, own = 2.0 * share * perRow * perColumn;
    const double top = first_, bottom = first_ + rows_;
    struct Line {
      double x, y, light, dx, dy, dLight;
    };
    for (double i = 0.5; i < rows; i += 1.0) {
      const double t = i * perRow;
      const auto line = [&](const Corner(&c)[4], const double(&turns)[4]) __attribute__((always_inline)) {
        Line one;
        one.x = turns[0] + t * (turns[2] - turns[0]);
        one.y = c[0].place + t * (c[2].place - c[0].place);
        one.light = own * (c[0].density + t * (c[2].density - c[0].density));
        one.dx = perColumn * (turns[1] + t * (turns[3] - turns[1]) - one.x);
        one.dy = perColumn * (c[1].place + t * (c[3].place - c[1].place) - one.y);
        one.dLight = perColumn * (own * (c[1].density + t * (c[3].density - c[1].density)) - one.light);
        return one;
      };
      const Line p = line(from, turn[0]), q = line(to, turn[1]);
      for (double j = 0.5; j < columns; j += 1.0) {
        const std::size_t which = start++ * 5 % LightSegments::kColours;
        const double s = at[which];
        double px = p.x + j * p.dx, py = p.y + j * p.dy, light = p.light + j * p.dLight;
        px = std::abs(px + s * (q.x + j * q.dx - px));
        py += s * (q.y + j * q.dy - py);
        light += s * (q.light + j * q.dLight - light);
        if (px > half) px = 2.0 * half - px;
        if (!(py >= top && py < bottom && px >= 0.0)) continue;
        const int column = std::min(static_cast<int>(px), cells_ - 1) + beyond_;
        const auto row = static_cast<std::size_t>(py - top);
        film_[row * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column)] +=
            static_cast<float>(light) * colours[which];
        from_[row] = std::min(from_[row], column);
        to_[row] = std::max(to_[row], column);
      }
      start += 3;
    }
  }

  /// Takes a row's light out: pairs of cells.
  void take(int row, std::vector<CosineTable::CellPair<C>>& pairs) {
    pairs.clear();
    const auto r = static_cast<std::size_t>(row);
    Floats* const cells = film_.data() + r * static_cast<std::size_t>(width_) + beyond_;
    if (to_[r] < from_[r]) return;
    for (int k = 1; k <= beyond_; ++k) {
      cells[k - 1] += cells[-k];
      cells[cells_ - k] += cells[cells_ - 1 + k];
    }
    for (int cell = 0; cell < cells_ / 2; ++cell) {
      const Floats a = cells[cell], b = cells[cells_ - 1 - cell], sum = a + b, difference = a - b;
      CosineTable::CellPair<C> pair{cell, {}, {}};
      float any = 0.0F;
      for (int c = 0; c < C; ++c) {
        pair.sum[static_cast<std::size_t>(c)] = sum[c];
        pair.difference[static_cast<std::size_t>(c)] = difference[c];
        any += sum[c];
      }
      if (any != 0.0F) pairs.push_back(pair);
    }
    std::fill(cells - beyond_, cells + cells_ + beyond_, Floats{});
    from_[r] = width_;
    to_[r] = -1;
  }

 private:
  int cells_, beyond_, width_, first_, rows_;
  AlignedVector<Floats> film_;
  std::vector<int> from_, to_;  // cells of a row that have light
};

BandLight::BandLight(const LightTable& table, const CosineTable& cosines, const BandMesh& mesh, bool colours,
                     const LightSegments& lights, const LightSegments& fewLights)
    : table_(table),
      cosines_(cosines),
      mesh_(mesh),
      colours_(colours),
      lights_(lights),
      fewLights_(fewLights),
      places_(1) {
  for (int ring = 0; ring < mesh.rings; ++ring) {
    const double sine = portable::sincos(std::clamp((ring + 0.5) / mesh.rings, 0.0, 1.0) * kPi).sin;
    const double orders = std::min(kOrders * mesh.cells * sine + kMoreOrders, mesh.orders);
    rooms_.push_back(ring < mesh.first || ring >= mesh.end ? 0 : cosines.room(orders));
    places_.push_back(places_.back() + static_cast<std::size_t>(2 * channels() * rooms_.back()));
  }
}

BandLight::~BandLight() = default;

void BandLight::make(int first, const std::function<bool(int band)>& wanted, std::vector<Band>& to) {
  scratch_.resize(kPieces);
  forEach(kPieces, [&](std::size_t piece) {
    for (std::size_t k = piece; k < to.size(); k += kPieces) {
      clear(to[k]);
      const int band = first + static_cast<int>(k);
      if (band >= mesh_.bands || !wanted(band)) continue;
      if (colours_)
        make<4>(band, scratch_[piece], to[k]);
      else
        make<2>(band, scratch_[piece], to[k]);
    }
  });
}

void BandLight::clear(Band& band) const {
  band.totals = {};
  if (band.lit.empty()) {
    band.light.assign(size(), 0.0F);
    band.lit.assign(static_cast<std::size_t>(mesh_.rings), false);
  }
  for (int ring = mesh_.first; ring < mesh_.end; ++ring) {
    if (!band.lit[static_cast<std::size_t>(ring)]) continue;
    std::fill_n(band.light.begin() + static_cast<std::ptrdiff_t>(placeOf(ring)), 2 * channels() * room(ring), 0.0F);
    band.lit[static_cast<std::size_t>(ring)] = false;
  }
}

template <int C>
void BandLight::make(int band, std::unique_ptr<Scratch>& scratch, Band& to) const {
  if (!scratch) scratch = std::make_unique<Room<C>>(mesh_.cells, mesh_.first, mesh_.end);
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
    for (const int number : table_.classes()) {
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
      for (const LightSegments::Segment& segment : lights.segments) addSegment<C>(ends, lights, segment, step, room);
    }
  }
  analyse<C>(room, to);
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

BandLight::Corner BandLight::exitAt(Corner corner, double index, int number) const {
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
                           int step, Room<C>& room) const {
  const double share = 0.5 * step / table_.columns(), faint = kFaint / mesh_.rings;
  const bool isLine = segment.from == segment.to;
  std::array<typename Channels<C>::Floats, LightSegments::kColours> colours{};
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
    return Corner{alpha, phi, row.light[k], row.density[k], row.excess[k], row.place[k], row.turn[k]};
  };
  const std::size_t sides[2] = {segment.from, segment.to};
  for (int column = 0; column < table_.columns(); column += step) {
    const auto k = static_cast<std::size_t>(column), l = k + static_cast<std::size_t>(step);
    const auto lit = [&](const Row& row) { return row.dark ? 0.0 : row.light[k] + row.light[l]; };
    double all = lit(ends.a[segment.from]) + lit(ends.b[segment.from]);
    if (!isLine) all += lit(ends.a[segment.to]) + lit(ends.b[segment.to]);
    if (all <= 0.0) continue;
    Corner quad[2][4];
    double least = 1.0, most = -1.0, light = 0.0;
    for (int side = 0; side < (isLine ? 1 : 2); ++side) {
      const std::size_t n = sides[side];
      const double index = lights.indices[n];
      quad[side][0] = corner(ends.a[n], ends.alphaA, index, column);
      quad[side][1] = corner(ends.a[n], ends.alphaA, index, column + step);
      quad[side][2] = corner(ends.b[n], ends.alphaB, index, column);
      quad[side][3] = corner(ends.b[n], ends.alphaB, index, column + step);
      for (const Corner& one : quad[side]) {
        least = std::min(least, one.excess);
        most = std::max(most, one.excess);
        light += one.density;
      }
    }
    if (most <= 0.0) continue;
    if (least > 0.0 && !isLine) {
      room.addSpread(quad[0], quad[1], share, segment.at, colours, static_cast<unsigned>(3 * column));
      continue;
    }
    if (least > 0.0 && share * light < faint) {
      room.addFaint(quad[0], share, colours[0]);
      continue;
    }
    // Where light stops getting out, each quad takes one of the segment's colours.
    const std::size_t j = isLine ? 0 : static_cast<std::size_t>(5 * column + 3 * ends.number) % colours.size();
    const double index =
        lights.indices[segment.from] + segment.at[j] * (lights.indices[segment.to] - lights.indices[segment.from]);
    if (!isLine)
      for (int n = 0; n < 4; ++n) {
        Corner& own = quad[0][n];
        own.light += segment.at[j] * (quad[1][n].light - own.light);
        own = exitAt(own, index, ends.number);
      }
    const auto between = [&](const Corner& p, const Corner& q) {
      return exitAt({0.5 * (p.alpha + q.alpha), 0.5 * (p.phi + q.phi), 0.5 * (p.light + q.light), 0.0, 0.0, 0.0, 0.0},
                    index, ends.number);
    };
    const auto add = [&](const Corner& p, const Corner& q, const Corner& r, double part) {
      room.add(p, q, r, part, colours[j]);
    };
    const auto& [p, q, r, t] = quad[0];
    addParts(p, q, r, share, kEdgeDepth, between, add);
    addParts(q, t, r, share, kEdgeDepth, between, add);
  }
}

template <int C>
void BandLight::analyse(Room<C>& room, Band& to) const {
  std::vector<CosineTable::CellPair<C>> pairs;
  for (int ring = mesh_.first; ring < mesh_.end; ++ring) {
    room.take(ring - mesh_.first, pairs);
    if (pairs.empty()) continue;
    to.lit[static_cast<std::size_t>(ring)] = true;
    cosines_.analyse<C>(pairs, this->room(ring), to.light.data() + placeOf(ring));
  }
}

}  // namespace parhelion
