// SPDX-License-Identifier: Apache-2.0
#include "beam/tilt_bands.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "beam/edge_parts.h"
#include "beam/sun_frame.h"
#include "beam/triangle_steps.h"
#include "math/portable.h"

namespace parhelion {

namespace {

// Tilts that their distribution is looked at, closest at its ends, and azimuths for each.
constexpr int kTilts = 256, kAzimuths = 360;
constexpr int kEdgeDepth = 2;
// Points to a pixel's side: at least, at most, at most in one that is wide, and in one that the sun is in.
constexpr int kFewPoints = 3, kManyPoints = 12, kMostPoints = 64, kPointsAtSun = 256;
// Pixels whose corners are farther apart (rad) than this have each of their points looked up.
constexpr double kWidePixel = 0.05;

double angle(const Vec3& a, const Vec3& b) { return portable::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

}  // namespace

PixelDirections::PixelDirections(const Camera& camera) : camera_(camera), solidAngles_(camera.solidAngles()) {
  for (int y = 0; y <= camera.height(); ++y)
    for (int x = 0; x <= camera.width(); ++x)
      corners_.push_back(camera.directionAt({static_cast<double>(x), static_cast<double>(y)}).value_or(Vec3(0.0)));
}

bool PixelDirections::isWhole(int x, int y) const {
  const Vec3 &a = corner(x, y), &b = corner(x + 1, y), &c = corner(x, y + 1), &d = corner(x + 1, y + 1);
  for (const Vec3* one : {&a, &b, &c, &d})
    if (*one == Vec3(0.0)) return false;
  return glm::distance(a, d) < kWidePixel && glm::distance(b, c) < kWidePixel && camera_.seam() == 0.0;
}

Vec3 PixelDirections::within(int x, int y, double u, double v) const {
  return (1.0 - v) * ((1.0 - u) * corner(x, y) + u * corner(x + 1, y)) +
         v * ((1.0 - u) * corner(x, y + 1) + u * corner(x + 1, y + 1));
}

double PixelDirections::size(int x, int y) const { return glm::distance(corner(x, y), corner(x + 1, y + 1)); }

TiltBands::TiltBands(const LightTable& table, const PixelDirections& directions, std::function<double(double)> tilt,
                     const BandMesh& mesh)
    : table_(table),
      directions_(directions),
      tilt_(std::move(tilt)),
      bands_(2 * std::max(1, static_cast<int>(std::ceil(0.25 * kPi / mesh.band)))),
      rings_(static_cast<std::size_t>(std::ceil(kPi / mesh.ring))),
      cells_(static_cast<std::size_t>(std::ceil(kPi / mesh.cell))),
      wantsCoarse_(mesh.coarse) {}

void TiltBands::distribute() {
  if (distributedFor_ == point_.toSun) return;
  distributedFor_ = point_.toSun;
  // c by its angle from the sun, up to half a turn, and its azimuth about the sun from the zenith's.
  PixelFilm film(static_cast<int>(cells_), 2 * bands_);
  const Vec3 sun = point_.toSun;
  const auto [ahead, left, up] = SunFrame(sun);
  const auto placeOf = [&](double tilt, double azimuth) {
    const auto [sinTilt, cosTilt] = portable::sincos(tilt);
    const auto [sin, cos] = portable::sincos(azimuth);
    const Vec3 c = sinTilt * cos * ahead + sinTilt * sin * left + Vec3(0.0, 0.0, cosTilt);
    const double across = glm::dot(c, up), beside = std::abs(glm::dot(c, left));
    return LitPlace{portable::atan2(beside, across) / kPi * static_cast<double>(cells_),
                    portable::atan2(std::hypot(across, beside), glm::dot(c, sun)) / kPi * 2.0 * bands_, 0.0};
  };
  const auto quantile = [](int k) { return 0.5 - 0.5 * portable::cos(kPi * k / kTilts); };
  const PixelFilm::Four per{1.0, 0.0, 0.0, 0.0};
  std::vector<LitPlace> before, row;
  for (int k = 0; k <= kTilts; ++k) {
    const double tilt = tilt_(std::clamp(quantile(k), 1e-9, 1.0 - 1e-9));
    row.clear();
    for (int j = 0; j <= kAzimuths; ++j) row.push_back(placeOf(tilt, kPi * j / kAzimuths));
    if (k > 0) {
      const double light = (quantile(k) - quantile(k - 1)) / kAzimuths;
      for (std::size_t j = 0; j < kAzimuths; ++j) {
        LitPlace corner[4] = {before[j], before[j + 1], row[j], row[j + 1]};
        for (LitPlace& one : corner) {
          one.light = light;
          one.x = std::min(one.x, static_cast<double>(cells_) * (1.0 - 1e-12));
          one.y = std::min(one.y, 2.0 * bands_ * (1.0 - 1e-12));
        }
        film.addQuad(corner, per);
      }
    }
    before.swap(row);
  }
  // -c does what c does, on the other side of the sun.
  azimuths_.assign(static_cast<std::size_t>(bands_), {});
  std::vector<float> share(cells_);
  for (std::size_t band = 0; band < azimuths_.size(); ++band) {
    const std::size_t mirrored = 2 * azimuths_.size() - 1 - band;
    std::size_t first = cells_, last = 0;
    Azimuths& azimuths = azimuths_[band];
    for (std::size_t cell = 0; cell < cells_; ++cell) {
      const double sum = film.at(band * cells_ + cell)[0] + film.at(mirrored * cells_ + (cells_ - 1 - cell))[0];
      share[cell] = static_cast<float>(sum);
      azimuths.all += sum;
      if (sum <= 0.0) continue;
      first = std::min(first, cell);
      last = cell;
    }
    if (azimuths.all <= 0.0) continue;
    azimuths.first = first;
    azimuths.share.assign(share.begin() + static_cast<std::ptrdiff_t>(first),
                          share.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  }
}

SheetTotals TiltBands::add(const SheetPoint& point, PixelFilm& film) {
  point_ = point;
  parts_ = table_.partsOf(point.index);
  distribute();
  fine_.light.assign(rings_ * 3 * cells_, 0.0F);
  coarse_.light.assign(wantsCoarse_ ? fine_.light.size() : 0, 0.0F);
  const double thick = 0.5 * kPi / bands_;
  SheetTotals totals;
  for (int band = 0; band < bands_; ++band) {
    const double all = azimuths_[static_cast<std::size_t>(band)].all;
    if (all <= 0.0) continue;
    for (const double alpha : {band * thick, (band + 1) * thick}) {
      const LightTable::Totals at = table_.totalsAt(alpha, parts_);
      totals.intercepted += 0.5 * all * at.intercepted;
      totals.cutOff += 0.5 * all * at.cutOff;
    }
  }
  Azimuths both;
  Row rows[3];
  for (const int number : table_.classes()) {
    class_ = number;
    const bool undeviated = LightClass(number).isUndeviated();
    double seen[3] = {-1.0, -1.0, -1.0};
    const auto rowAt = [&](int band) -> Row& {
      const auto slot = static_cast<std::size_t>(band % 3);
      if (seen[slot] != band) see(band * thick, number, rows[slot]);
      seen[slot] = band;
      return rows[slot];
    };
    for (int band = 0; band < bands_; band += 2) {
      const Azimuths &first = azimuths_[static_cast<std::size_t>(band)],
                     &second = azimuths_[static_cast<std::size_t>(band) + 1];
      if (first.all + second.all <= 0.0) continue;
      const Row &a = rowAt(band), &b = rowAt(band + 1), &c = rowAt(band + 2);
      if (a.dark && b.dark && c.dark) continue;
      if (undeviated) {
        const auto mean = [&](const Row& row) { return row.dark ? 0.0 : table_.meanOf(row.density); };
        totals.undeviated += 0.5 * (first.all * (mean(a) + mean(b)) + second.all * (mean(b) + mean(c)));
        continue;
      }
      const double alpha = band * thick;
      addBand(a, alpha, b, alpha + thick, 1, first, fine_);
      addBand(b, alpha + thick, c, alpha + 2.0 * thick, 1, second, fine_);
      if (!wantsCoarse_) continue;
      // Both bands together.
      const std::size_t firstCell = first.all <= 0.0    ? second.first
                                    : second.all <= 0.0 ? first.first
                                                        : std::min(first.first, second.first);
      const std::size_t end = std::max(first.first + first.share.size(), second.first + second.share.size());
      both.first = firstCell;
      both.share.assign(end - firstCell, 0.0F);
      both.all = first.all + second.all;
      for (const Azimuths* one : {&first, &second})
        for (std::size_t k = 0; k < one->share.size(); ++k) both.share[one->first - firstCell + k] += one->share[k];
      addBand(a, alpha, c, alpha + 2.0 * thick, 2, both, coarse_);
    }
  }
  fold(fine_);
  if (wantsCoarse_) fold(coarse_);
  expose(film);
  return totals;
}

PARHELION_ALSO_AVX2 void TiltBands::see(double alpha, int number, Row& row) {
  const auto room = static_cast<std::size_t>(table_.room());
  for (auto* values : {&row.light, &row.density, &row.excess, &row.place, &row.turn}) values->resize(room);
  row.dark = !table_.lightAt(alpha, number, parts_, row.light.data());
  if (row.dark) return;
  const LightClass of(number);
  const RelativeIndexOf<Four> index(all<Four>(point_.index));
  const auto [sin, cos] = portable::sincos(alpha);
  const double ringsPerAngle = static_cast<double>(rings_) / kPi, cellsPerAngle = static_cast<double>(cells_) / kPi;
  for (std::size_t k = 0; k < room; k += 4) {
    const Four light = higher(load<Four>(&row.light[k]), Four{});
    const ClassExit<Four> exit =
        of.exitAcross(sin, cos, load<Four>(&table_.sines()[k]), load<Four>(&table_.cosines()[k]), index);
    const auto& [along, aside, upward] = exit.lightDir;
    // Toward the sky, by the direction of the sun, that of c across it, and what is at right angles to both.
    const Four onto = sin * along - cos * upward, toward = -(cos * along + sin * upward);
    const Four beside = higher(aside, Four(-aside));
    store(&row.light[k], light);
    store(&row.density[k], Four(light * exit.transmittance));
    store(&row.excess[k], exit.excess);
    store(&row.place[k], Four(ringsPerAngle * arctangent(Four(squareRoot(toward * toward + beside * beside)), onto)));
    store(&row.turn[k], Four(cellsPerAngle * arctangent(beside, toward)));
  }
}

TiltBands::Corner TiltBands::exitAt(Corner corner) const {
  const auto [sin, cos] = portable::sincos(corner.alpha);
  const auto [sinPhi, cosPhi] = portable::sincos(corner.phi);
  const ClassExit<double> exit =
      LightClass(class_).exitAcross(sin, cos, sinPhi, cosPhi, RelativeIndexOf<double>(point_.index));
  const auto& [along, aside, upward] = exit.lightDir;
  const double onto = sin * along - cos * upward, toward = -(cos * along + sin * upward);
  corner.density = corner.light * exit.transmittance;
  corner.excess = exit.excess;
  corner.place = static_cast<double>(rings_) / kPi * portable::atan2(std::hypot(toward, aside), onto);
  corner.turn = static_cast<double>(cells_) / kPi * portable::atan2(std::abs(aside), toward);
  return corner;
}

void TiltBands::addBand(const Row& a, double alphaA, const Row& b, double alphaB, int step, const Azimuths& azimuths,
                        Rings& rings) {
  if (azimuths.all <= 0.0 || (a.dark && b.dark)) return;
  const double share = 0.5 * step / table_.columns();
  const auto corner = [&](const Row& row, double alpha, int column) {
    const auto k = static_cast<std::size_t>(column);
    const double phi = table_.azimuthAt(column);
    if (row.dark) return exitAt({alpha, phi, 0.0, 0.0, 0.0, 0.0, 0.0});
    return Corner{alpha, phi, row.light[k], row.density[k], row.excess[k], row.place[k], row.turn[k]};
  };
  const auto between = [&](const Corner& p, const Corner& q) {
    return exitAt({0.5 * (p.alpha + q.alpha), 0.5 * (p.phi + q.phi), 0.5 * (p.light + q.light), 0.0, 0.0, 0.0, 0.0});
  };
  const auto add = [&](const Corner& p, const Corner& q, const Corner& r, double part) {
    addTriangle(p, q, r, part, azimuths, rings);
  };
  for (int column = 0; column < table_.columns(); column += step) {
    const auto k = static_cast<std::size_t>(column), l = k + static_cast<std::size_t>(step);
    const auto lit = [&](const Row& row) { return row.dark ? 0.0 : row.light[k] + row.light[l]; };
    if (lit(a) + lit(b) <= 0.0) continue;
    const Corner ca = corner(a, alphaA, column), cb = corner(a, alphaA, column + step), cc = corner(b, alphaB, column),
                 cd = corner(b, alphaB, column + step);
    const int depth = step == 1 ? kEdgeDepth : kEdgeDepth + 1;
    addParts(ca, cb, cc, share, depth, between, add);
    addParts(cb, cd, cc, share, depth, between, add);
  }
}

void TiltBands::addTriangle(const Corner& a, const Corner& b, const Corner& c, double share, const Azimuths& azimuths,
                            Rings& rings) {
  // Across the rings exactly. Along them, light of a ring is where the triangle is there on average, as wide as it is.
  double place[3] = {a.place, b.place, c.place};
  double light[3] = {share * a.density, share * b.density, share * c.density};
  const double turns[3] = {a.turn, b.turn, c.turn};
  const double all = light[0] + light[1] + light[2];
  if (!(all > 0.0)) return;
  const double least = std::min({place[0], place[1], place[2]}), most = std::max({place[0], place[1], place[2]});
  const double widest = std::max({turns[0], turns[1], turns[2]}) - std::min({turns[0], turns[1], turns[2]});
  if (std::floor(least) == std::floor(most) || widest < 0.25) {
    const double mean = (light[0] * turns[0] + light[1] * turns[1] + light[2] * turns[2]) / all;
    return shareOut(place, light, static_cast<double>(rings_), [&](double ring, double part) {
      addTurned(static_cast<std::size_t>(ring), part, mean, widest, azimuths, rings);
    });
  }
  // The azimuth is linear in the place, but for what it varies at one place.
  const auto [p0, p1, p2] = std::array{a.place, b.place, c.place};
  const double middle = (p0 + p1 + p2) / 3.0, turn = (turns[0] + turns[1] + turns[2]) / 3.0;
  double covariance = 0.0, variance = 0.0, rest = 0.0;
  for (const auto& [p, t] : {std::pair{p0, turns[0]}, {p1, turns[1]}, {p2, turns[2]}}) {
    covariance += (p - middle) * (t - turn);
    variance += (p - middle) * (p - middle);
  }
  const double slope = covariance / variance;
  for (const auto& [p, t] : {std::pair{p0, turns[0]}, {p1, turns[1]}, {p2, turns[2]}})
    rest = std::max(rest, std::abs(t - turn - slope * (p - middle)));
  shareOut(place, light, static_cast<double>(rings_), [&](double ring, double part) {
    const double at = std::clamp(ring + 0.5, least, most);
    const double within = std::min(ring + 1.0, most) - std::max(ring, least);
    addTurned(static_cast<std::size_t>(ring), part, turn + slope * (at - middle), std::abs(slope) * within + rest,
              azimuths, rings);
  });
}

PARHELION_ALSO_AVX2 void TiltBands::addTurned(std::size_t ring, double light, double turn, double width,
                                              const Azimuths& azimuths, Rings& rings) {
  if (!(light > 0.0)) return;
  // A box of cells, one for each of its own.
  const int parts = 1 + static_cast<int>(std::min(width, static_cast<double>(cells_)));
  float* const row = rings.light.data() + ring * 3 * cells_ + cells_;  // of azimuth 0
  const std::size_t count = azimuths.share.size();
  const float* const share = azimuths.share.data();
  for (int part = 0; part < parts; ++part) {
    const double at = turn + width * ((part + 0.5) / parts - 0.5);
    for (const double sign : {1.0, -1.0}) {
      const double shift = sign * std::clamp(at, 0.0, static_cast<double>(cells_));
      const double whole = std::floor(shift), t = shift - whole;
      const double own = 0.5 * light / parts;
      const auto here = static_cast<float>(own * (1.0 - t)), next = static_cast<float>(own * t);
      float* const to = row + static_cast<std::ptrdiff_t>(azimuths.first) + static_cast<std::ptrdiff_t>(whole);
      to[0] += here * share[0];
      for (std::size_t k = 1; k < count; ++k) to[k] += here * share[k] + next * share[k - 1];
      if (shift < static_cast<double>(cells_)) to[count] += next * share[count - 1];
    }
  }
}

void TiltBands::fold(Rings& rings) const {
  const auto cells = static_cast<std::ptrdiff_t>(cells_);
  for (std::size_t ring = 0; ring < rings_; ++ring) {
    float* const row = rings.light.data() + ring * 3 * cells_ + cells_;
    for (std::ptrdiff_t k = 0; k < cells; ++k) row[k] += row[-1 - k] + row[2 * cells - 1 - k];
  }
}

void TiltBands::expose(PixelFilm& film) const {
  const Camera& camera = directions_.camera();
  const Vec3 sun = point_.toSun;
  const SunFrame about(sun);
  const double ringAngle = kPi / static_cast<double>(rings_), cellAngle = kPi / static_cast<double>(cells_);
  std::vector<double> perSolidAngle;
  for (std::size_t ring = 0; ring < rings_; ++ring) {
    const double from = static_cast<double>(ring) * ringAngle;
    perSolidAngle.push_back(1.0 / (2.0 * cellAngle * (portable::cos(from) - portable::cos(from + ringAngle))));
  }
  // Light to solid angle between the middles of cells.
  const auto lookUp = [&](const Vec3& toSky, double part, double& fine, double& coarse) {
    const double onto = glm::dot(toSky, sun), toward = glm::dot(toSky, about.up),
                 beside = std::abs(glm::dot(toSky, about.left));
    const double theta = arctangent(std::sqrt(toward * toward + beside * beside), onto),
                 turn = arctangent(beside, toward);
    const double y = std::clamp(theta / ringAngle - 0.5, 0.0, static_cast<double>(rings_) - 1.001),
                 x = std::clamp(turn / cellAngle - 0.5, 0.0, static_cast<double>(cells_) - 1.001);
    const auto ring = static_cast<std::size_t>(y), cell = static_cast<std::size_t>(x);
    const double v = y - static_cast<double>(ring), u = x - static_cast<double>(cell);
    for (int side = 0; side < 2; ++side) {
      const std::size_t at = (ring + static_cast<std::size_t>(side)) * 3 * cells_ + cells_ + cell;
      const double weight = part * (side ? v : 1.0 - v) * perSolidAngle[ring + static_cast<std::size_t>(side)];
      const auto between = [&](const Rings& rings) {
        return (1.0 - u) * static_cast<double>(rings.light[at]) + u * static_cast<double>(rings.light[at + 1]);
      };
      fine += weight * between(fine_);
      if (wantsCoarse_) coarse += weight * between(coarse_);
    }
  };
  // How much sky there is at a place of a wide pixel.
  const auto stretch = [&](Vec2 at, const Vec3& toSky) {
    constexpr double kStep = 1e-3;
    const auto right = camera.directionAt(at + Vec2(kStep, 0.0)), down = camera.directionAt(at + Vec2(0.0, kStep));
    return right && down ? glm::length(glm::cross(*right - toSky, *down - toSky)) : 0.0;
  };
  const Tristimulus& xyz = point_.xyz;
  for (int y = 0; y < camera.height(); ++y)
    for (int x = 0; x < camera.width(); ++x) {
      const std::size_t pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(camera.width()) + static_cast<std::size_t>(x);
      const double solidAngle = directions_.solidAngle(pixel);
      if (solidAngle <= 0.0) continue;
      const bool whole = directions_.isWhole(x, y);
      // As close together as cells are small, which they are near the sun.
      const auto middle = camera.directionAt({x + 0.5, y + 0.5});
      const double theta = middle ? angle(*middle, sun) : 0.5 * kPi;
      const double size = whole ? directions_.size(x, y) : std::sqrt(solidAngle);
      const double smallest = std::clamp(theta * cellAngle, 1e-9, ringAngle);
      const int most = theta < size ? kPointsAtSun : size > kWidePixel ? kMostPoints : kManyPoints;
      const int side = std::clamp(static_cast<int>(std::min(std::ceil(size / smallest), 1e6)), kFewPoints, most);
      double fine = 0.0, coarse = 0.0;
      double parts = 0.0;
      for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
          const double u = (i + 0.5) / side, v = (j + 0.5) / side;
          if (whole) {
            lookUp(directions_.within(x, y, u, v), 1.0, fine, coarse);
            parts += 1.0;
          } else if (const auto seen = camera.toSky({x + u, y + v})) {
            const double part = stretch({x + u, y + v}, *seen);
            lookUp(*seen, part, fine, coarse);
            parts += part;
          }
        }
      if (!(parts > 0.0)) continue;
      const double share = solidAngle / parts;
      film.add({x + 0.5, y + 0.5, share}, Four{fine * xyz[0], fine * xyz[1], fine * xyz[2], coarse * xyz[1]});
    }
}

}  // namespace parhelion
