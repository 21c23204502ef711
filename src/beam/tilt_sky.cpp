// SPDX-License-Identifier: Apache-2.0
#include "beam/tilt_sky.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "beam/pixel_film.h"
#include "beam/sun_frame.h"
#include "math/arctangent.h"
#include "math/portable.h"
#include "parallel/loops.h"

namespace parhelion {

namespace {

using Four = Lanes<4>::Real;
using FourFloats [[gnu::vector_size(16)]] = float;

// Tilts that their distribution is looked at, closest at its ends, and azimuths for each.
constexpr int kTilts = 192, kAzimuths = 360;
// Orders that all bands have less of than this, over the crystals of the fullest band, do not matter.
constexpr double kFaintOrder = 1e-4;
// From this share of a ring's orders on, the last ones fade.
constexpr double kFade = 0.7;
// What cells blur is put back to second order: a band of angles, even light in it; two boxes and linear lookups along
// the rings; a box and linear lookups across them.
constexpr double kOfBand = 1.0 / 12.0, kAlong = 1.0 / 6.0, kAcross = 1.0 / 8.0;
// Pixels wider than this (rad) are looked at by more points.
constexpr double kWide = 0.03;
// Pixels of so many points to a side and less share them out over the points of the sun's disc.
constexpr int kMostShares = 4;
// Points to a pixel's side: at most, in one that is not whole, beside the sun and in the one that the sun is in.
constexpr int kManyPoints = 96, kBrokenPoints = 6, kBesideSun = 16, kAtSun = 64;

/// Looks rings about one elevation of the sun up.
class RingLookUp {
 public:
  RingLookUp(const SunRow& sun, const float* cells, const BandMesh& mesh)
      : about_(sun.toSun), sun_(sun.toSun), cells_(cells), mesh_(mesh) {
    for (const SunRow::Point& point : sun.points) {
      const auto [sin, cos] = portable::sincos(point.azimuth);
      points_.push_back({sin, cos, point.weight});
    }
  }

  /// Adds what directions see by all points of the sun, times `part` of each. They lie in `shares` equal groups: one
  /// point of the sun is looked at from one of these, and the next from the next. `first` is the first point's group.
  PARHELION_INLINE void add(const Vec3* toSky, const double* part, int count, int shares, int first,
                            FourFloats& sum) const {
    double x[4]{}, y[4]{}, z[4]{}, weight[4]{};
    int filled = 0;
    const int each = count / shares;
    int share = first % shares;
    for (const Point& point : points_) {
      for (int k = share * each; k < (share + 1) * each; ++k) {
        // Turned back about the vertical.
        x[filled] = toSky[k].x * point.cos + toSky[k].y * point.sin;
        y[filled] = toSky[k].y * point.cos - toSky[k].x * point.sin;
        z[filled] = toSky[k].z;
        weight[filled++] = part[k] * point.weight;
        if (filled == 4) {
          addFour({load<Four>(x), load<Four>(y), load<Four>(z)}, weight, 4, sum);
          filled = 0;
        }
      }
      share = share + 1 < shares ? share + 1 : 0;
    }
    if (filled) addFour({load<Four>(x), load<Four>(y), load<Four>(z)}, weight, filled, sum);
  }

 private:
  struct Point {
    double sin, cos, weight;
  };

  PARHELION_INLINE void addFour(const Triple<Four>& toSky, const double* weight, int count, FourFloats& sum) const {
    const auto onto = [&](const Vec3& v) __attribute__((always_inline)) {
      return Four(toSky.x * v.x + toSky.y * v.y + toSky.z * v.z);
    };
    const Four along = onto(sun_), toward = onto(about_.up), beside = onto(about_.left);
    const double perAngle = mesh_.cells / kPi;
    const Four across = squareRoot(Four(toward * toward + beside * beside));
    const Four ring = arctangent(across, along) * perAngle - 0.5,
               cell = arctangent(higher(beside, Four(-beside)), toward) * perAngle - 0.5;
    const Four y = lower(higher(ring, all<Four>(mesh_.first)), all<Four>(mesh_.end - 1.001)),
               x = lower(higher(cell, Four{}), all<Four>(mesh_.cells - 1.001));
    for (int k = 0; k < count; ++k) {
      const auto row = static_cast<int>(y[k]), column = static_cast<int>(x[k]);
      const auto v = static_cast<float>(y[k] - row), u = static_cast<float>(x[k] - column);
      const float* const at = cells_ + 4 * (static_cast<std::ptrdiff_t>(row - mesh_.first) * mesh_.cells + column);
      const float* const below = at + 4 * static_cast<std::ptrdiff_t>(mesh_.cells);
      const FourFloats a = load<FourFloats>(at), b = load<FourFloats>(at + 4), c = load<FourFloats>(below),
                       d = load<FourFloats>(below + 4);
      const FourFloats upper = a + u * (b - a), lower = c + u * (d - c);
      sum += static_cast<float>(weight[k]) * (upper + v * (lower - upper));
    }
  }

  SunFrame about_;
  Vec3 sun_;
  const float* cells_;
  BandMesh mesh_;
  std::vector<Point> points_;
};

}  // namespace

TiltSky::TiltSky(const CosineTable& cosines, const BandMesh& mesh, std::vector<SunRow> rows,
                 const std::function<double(double)>& tilt, CrystalSide side, std::vector<AlignedVector<float>>& room)
    : cosines_(cosines),
      mesh_(mesh),
      room_(cosines.room(mesh.cells)),
      crystals_(rows.size()),
      reached_(static_cast<std::size_t>(mesh.bands)) {
  room.resize(std::max(room.size(), 2 * rows.size() + 1));
  plain_ = &room.back();
  forEach(rows.size(), [&](std::size_t k) {
    crystals_[k].sky = &room[2 * k];
    crystals_[k].cells = &room[2 * k + 1];
    crystals_[k].sun = std::move(rows[k]);
    distribute(tilt, side, crystals_[k]);
  });
  for (Crystals& crystals : crystals_) findOrders(crystals);
}

void TiltSky::distribute(const std::function<double(double)>& tilt, CrystalSide side, Crystals& crystals) const {
  // c by its angle from the sun, up to half a turn, and its azimuth about the sun from the zenith's.
  const auto bands = static_cast<std::size_t>(mesh_.bands), cells = static_cast<std::size_t>(mesh_.cells);
  std::vector<float> film(2 * bands * cells);
  const Vec3 sun = crystals.sun.toSun;
  const auto [ahead, left, up] = SunFrame(sun);
  std::vector<portable::SinCos> azimuths;
  for (int j = 0; j <= kAzimuths; ++j) azimuths.push_back(portable::sincos(kPi * j / kAzimuths));
  const auto placeOf = [&](const portable::SinCos& ofTilt, const portable::SinCos& azimuth) {
    const auto [sinTilt, cosTilt] = ofTilt;
    const auto [sin, cos] = azimuth;
    const Vec3 c = sinTilt * cos * ahead + sinTilt * sin * left + Vec3(0.0, 0.0, cosTilt);
    const double across = glm::dot(c, up), beside = std::abs(glm::dot(c, left));
    const double x = arctangent(beside, across) / kPi * mesh_.cells,
                 y = arctangent(std::hypot(across, beside), glm::dot(c, sun)) / kPi * 2.0 * mesh_.bands;
    return LitPlace{std::min(x, mesh_.cells * (1.0 - 1e-12)), std::min(y, 2.0 * mesh_.bands * (1.0 - 1e-12)), 0.0};
  };
  const auto quantile = [](int k) { return 0.5 - 0.5 * portable::cos(kPi * k / kTilts); };
  const auto addTriangle = [&](LitPlace a, LitPlace b, LitPlace c, double light) {
    a.light = b.light = c.light = 0.5 * light;
    shareOverCells(a, b, c, mesh_.cells, 2 * mesh_.bands, [&](int x, int y, double own) {
      film[static_cast<std::size_t>(y) * cells + static_cast<std::size_t>(x)] += static_cast<float>(own);
    });
  };
  std::vector<LitPlace> before, row;
  for (int k = 0; k <= kTilts; ++k) {
    const portable::SinCos at = portable::sincos(tilt(std::clamp(quantile(k), 1e-9, 1.0 - 1e-9)));
    row.clear();
    for (const portable::SinCos& azimuth : azimuths) row.push_back(placeOf(at, azimuth));
    if (k > 0) {
      const double light = (quantile(k) - quantile(k - 1)) / kAzimuths;
      for (std::size_t j = 0; j < kAzimuths; ++j) {
        addTriangle(before[j], before[j + 1], row[j], light);
        addTriangle(before[j + 1], row[j + 1], row[j], light);
      }
    }
    before.swap(row);
  }
  // -c does what c does, on the other side of the sun.
  std::vector<float> shares(bands * cells);
  crystals.shares.assign(bands, 0.0);
  for (std::size_t band = 0; band < bands; ++band)
    for (std::size_t cell = 0; cell < cells; ++cell) {
      const float upper = film[band * cells + cell], lower = film[(2 * bands - 1 - band) * cells + (cells - 1 - cell)];
      const float share = (side == CrystalSide::lower ? 0.0F : upper) + (side == CrystalSide::upper ? 0.0F : lower);
      shares[band * cells + cell] = share;
      crystals.shares[band] += static_cast<double>(share);
    }
  // Orders of the bands and of their pairs.
  const auto room = static_cast<std::size_t>(room_);
  crystals.orders.assign(bands * 4 * room, 0.0F);
  std::vector<CosineTable::CellPair<2>> pairs;
  for (std::size_t band = 0; band < bands; ++band) {
    const std::size_t lower = band > 0 ? band - 1 : band, upper = band + 1 < bands ? band + 1 : band, other = band ^ 1u;
    if (crystals.shares[band] + crystals.shares[lower] + crystals.shares[upper] <= 0.0) continue;
    const auto at = [&](std::size_t cell) {
      const float own = shares[band * cells + cell];
      const float bend = shares[lower * cells + cell] - 2.0F * own + shares[upper * cells + cell];
      const float pair = other < bands ? 0.5F * (own + shares[other * cells + cell]) : own;
      return std::array{own - static_cast<float>(kOfBand) * bend, pair};
    };
    pairs.clear();
    for (std::size_t cell = 0; cell < cells / 2; ++cell) {
      const auto [fineA, coarseA] = at(cell);
      const auto [fineB, coarseB] = at(cells - 1 - cell);
      if (fineA == 0.0F && fineB == 0.0F && coarseA == 0.0F && coarseB == 0.0F) continue;
      pairs.push_back({static_cast<int>(cell), {fineA + fineB, coarseA + coarseB}, {fineA - fineB, coarseA - coarseB}});
    }
    cosines_.analyse<2>(pairs, room_, crystals.orders.data() + band * 4 * room);
  }
}

void TiltSky::findOrders(Crystals& crystals) {
  const auto room = static_cast<std::size_t>(room_);
  double most = 0.0;
  for (std::size_t band = 0; band < reached_.size(); ++band) {
    const float* orders = crystals.orders.data() + band * 4 * room;
    if (std::any_of(orders, orders + 4 * room, [](float order) { return order != 0.0F; })) reached_[band] = true;
    most = std::max(most, crystals.shares[band]);
  }
  for (std::size_t band = 0; band < reached_.size(); ++band)
    for (std::size_t k = 0; k < 4 * room; ++k)
      if (std::abs(static_cast<double>(crystals.orders[band * 4 * room + k])) > kFaintOrder * most)
        highestOrder_ = std::max(highestOrder_, static_cast<double>(2 * (k % room) + 1));
}

void TiltSky::start(const BandMesh& mesh, int channels) {
  mesh_ = mesh;
  channels_ = channels;
  layout_.emplace(mesh, cosines_, channels);
  totals_ = {};
  for (Crystals& crystals : crystals_) crystals.sky->assign(layout_->size(), 0.0F);
}

PARHELION_ALSO_AVX2 static void addProducts(const float* a, const float* b, int count, float* to) {
  for (int k = 0; k < count; ++k) to[k] += a[k] * b[k];
}

void TiltSky::add(const BandLight& light, std::span<const NumberedBand> bands) {
  for (const Crystals& crystals : crystals_) {
    double weight = 0.0;
    for (const SunRow::Point& point : crystals.sun.points) weight += point.weight;
    for (const auto& [number, band] : bands)
      totals_.add(band->totals, weight * crystals.shares[static_cast<std::size_t>(number)]);
  }
  forRows(mesh_.end - mesh_.first, [&](int row) {
    const int ring = mesh_.first + row, room = layout_->room(ring), roomOfBand = light.layout().room(ring);
    for (Crystals& crystals : crystals_) {
      float* const to = crystals.sky->data() + layout_->placeOf(ring);
      for (const auto& [number, band] : bands) {
        if (!band->lit[static_cast<std::size_t>(ring)]) continue;
        const float* const from = band->light.data() + light.layout().placeOf(ring);
        const float* const orders =
            crystals.orders.data() + static_cast<std::size_t>(number) * 4 * static_cast<std::size_t>(room_);
        for (int part = 0; part < 2 * channels_; ++part) {
          const int own = (part >= 2 * (channels_ - 1) ? 2 : 0) + part % 2;
          addProducts(orders + own * room_, from + part * roomOfBand, room, to + part * room);
        }
      }
    }
  });
}

void TiltSky::synthesise(Crystals& crystals) const {
  const int channels = channels_, rings = mesh_.end - mesh_.first;
  const std::size_t stride = 4 * static_cast<std::size_t>(mesh_.cells);
  AlignedVector<float>& plain = *plain_;
  plain.resize(std::max(plain.size(), static_cast<std::size_t>(rings) * stride));
  forRows(rings, [&](int row) {
    const int ring = mesh_.first + row, room = layout_->room(ring);
    const double from = kPi * ring / mesh_.cells, to = kPi * (ring + 1) / mesh_.cells;
    const double per = 1.0 / (2.0 * kPi * (portable::cos(from) - portable::cos(to)));
    std::vector<float> orders(static_cast<std::size_t>(2 * channels * room));
    for (int part = 0; part < 2 * channels; ++part)
      for (int k = 0; k < room; ++k) {
        const int order = 2 * k + part % 2;
        const double waves = order * kPi / mesh_.cells, place = static_cast<double>(k) / room;
        const double faded = std::max(place - kFade, 0.0) / (1.0 - kFade);
        const double fade = 1.0 - faded * faded * (3.0 - 2.0 * faded);
        const double sharp = part < 2 * (channels - 1) ? 1.0 + kAlong * waves * waves : 1.0;
        const double weight = per * fade * sharp * (order == 0 ? 1.0 : 2.0);
        const auto at = static_cast<std::size_t>(part * room + k);
        orders[at] = static_cast<float>(weight * static_cast<double>((*crystals.sky)[layout_->placeOf(ring) + at]));
      }
    float* const cells = plain.data() + static_cast<std::size_t>(row) * stride;
    if (channels == 4)
      cosines_.synthesise<4>(orders.data(), room, cells);
    else
      cosines_.synthesise<2>(orders.data(), room, cells);
  });
  crystals.cells->resize(std::max(crystals.cells->size(), static_cast<std::size_t>(rings) * stride));
  forRows(rings, [&](int row) {
    const auto at = [&](int which) {
      return plain.data() + static_cast<std::size_t>(std::clamp(which, 0, rings - 1)) * stride;
    };
    const float *above = at(row - 1), *own = at(row), *below = at(row + 1);
    float* const to = crystals.cells->data() + static_cast<std::size_t>(row) * stride;
    for (std::size_t k = 0; k < stride; ++k) {
      const bool fine = static_cast<int>(k % 4) < channels - 1;
      to[k] = fine ? own[k] - static_cast<float>(kAcross) * (above[k] - 2.0F * own[k] + below[k]) : own[k];
    }
  });
}

PARHELION_ALSO_AVX2 static void lookUpAll(const std::vector<RingLookUp>& rows, const Vec3* toSky, const double* part,
                                          int count, int shares, float* sum) {
  FourFloats four = load<FourFloats>(sum);
  int first = 0;
  for (const RingLookUp& row : rows) row.add(toSky, part, count, shares, first++, four);
  store(sum, four);
}

void TiltSky::expose(const PixelDirections& directions, bool isMirrored, std::vector<PixelLight>& pixels) {
  std::vector<RingLookUp> rows;
  for (Crystals& crystals : crystals_) {
    synthesise(crystals);
    rows.emplace_back(crystals.sun, crystals.cells->data(), mesh_);
  }
  const Camera& camera = directions.camera();
  const double cell = kPi / mesh_.cells;
  const bool isDisc = crystals_.size() > 1;
  const Vec3 sun = crystals_[crystals_.size() / 2].sun.toSun;
  // How much sky there is at a place of a wide pixel.
  const auto stretch = [&](Vec2 at, const Vec3& toSky) {
    constexpr double kStep = 1e-3;
    const auto right = camera.directionAt(at + Vec2(kStep, 0.0)), down = camera.directionAt(at + Vec2(0.0, kStep));
    return right && down ? glm::length(glm::cross(*right - toSky, *down - toSky)) : 0.0;
  };
  const auto width = static_cast<std::size_t>(camera.width());
  pixels.assign(width * static_cast<std::size_t>(camera.height()), {});
  // The parhelic circle beside a sun below the zenith crosses the diagonal that most points lie on in the right half.
  const int mirrored = isMirrored ? camera.width() / 2 : 0;
  forRows(camera.height(), [&](int y) {
    std::vector<Vec3> toSky;
    std::vector<double> parts;
    for (int x = mirrored; x < camera.width(); ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
      const double solidAngle = directions.solidAngle(pixel);
      if (solidAngle <= 0.0) continue;
      const bool whole = directions.isWhole(x, y);
      const Vec3& middle = directions.middle(pixel);
      const double fromSun = middle != Vec3(0.0) ? glm::distance(middle, sun) : 1.0;
      const double size = whole ? directions.size(x, y) : std::sqrt(2.0 * solidAngle);
      int side = static_cast<int>(std::clamp(std::ceil(std::sqrt(0.5) * size / cell), 1.0, double{kManyPoints}));
      if (!whole) side = std::max(side, kBrokenPoints);
      if (size > kWide) side = std::min(2 * side, kManyPoints);
      if (fromSun < 3.0 * size) side = std::max(side, kBesideSun);
      if (fromSun < size) side = std::max(side, kAtSun);
      double all = 0.0;
      // At the picture's rim a pixel may see less of the sky than points lie apart.
      for (;; side *= 2) {
        toSky.clear();
        parts.clear();
        for (int k = 0; k < side; ++k)
          for (int j = 0; j < side; ++j) {
            const int i = (j + k) % side;
            const double u = (i + 0.5) / side, v = (j + 0.5) / side;
            if (whole) {
              toSky.push_back(directions.within(x, y, u, v));
              parts.push_back(1.0);
            } else if (const auto there = camera.toSky({x + u, y + v})) {
              toSky.push_back(*there);
              parts.push_back(stretch({x + u, y + v}, *there));
            } else {
              continue;
            }
            all += parts.back();
          }
        if (all > 0.0 || 2 * side > kManyPoints) break;
      }
      if (!(all > 0.0)) continue;
      // Each point of the sun is seen from each row and each column of places once.
      const int shares = whole && isDisc && side <= kMostShares ? side : 1;
      for (double& part : parts) part *= shares * solidAngle / all;
      lookUpAll(rows, toSky.data(), parts.data(), static_cast<int>(toSky.size()), shares, pixels[pixel].data());
    }
    const auto row = pixels.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * width);
    std::reverse_copy(row + (camera.width() - mirrored), row + camera.width(), row);
  });
}

}  // namespace parhelion
