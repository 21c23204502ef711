// SPDX-License-Identifier: Apache-2.0
#include "beam/sky_integral.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "beam/tilt_integral.h"
#include "parallel/loops.h"

namespace parhelion {

namespace {

// Sheets come in groups, each of which is spread evenly by itself. By how much groups differ, their mean errs.
constexpr int kGroups = 8;
// The first mesh: cells for 30 degrees of azimuth, and for 90 of the angle from -c.
constexpr int kColumns = 40, kRows = 120, kMostLevel = 4;
constexpr int kMostPoints = 1 << 12;  // a group
// What a mesh of half as many cells differs by, times this, is a pixel's own part of the error. Where both err alike
// that says nothing, so the mean of all pixels, relative, is added, times a second factor.
constexpr double kOfMesh = 0.6, kOfMean = 1.0;

// Light is faint if it is less than this, times the accuracy, of what a pixel has on average; and how much light the
// picture has, more or less, of crystals' surface.
constexpr double kFaint = 0.2, kInPicture = 0.15;

/// Numbers in (0, 1), evenly spread in each dimension and together: additive, by powers of the inverse of the root of
/// x^(d + 1) = x + 1 (Roberts 2018, the R sequence), with a start of its own for each group.
class EvenPoints {
 public:
  static constexpr int kDimensions = 5;

  EvenPoints(std::uint64_t seed, int group) {
    double root = 1.2;
    for (int k = 0; k < 60; ++k) root = std::pow(1.0 + root, 1.0 / (kDimensions + 1));
    std::uint64_t state = seed * 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(group) * 0xd1b54a32d192ed03u;
    double step = 1.0;
    for (int k = 0; k < kDimensions; ++k) {
      step /= root;
      step_[static_cast<std::size_t>(k)] = step;
      start_[static_cast<std::size_t>(k)] = random(state);
    }
  }

  double at(int point, int dimension) const {
    const auto d = static_cast<std::size_t>(dimension);
    const double x = start_[d] + point * step_[d];
    return std::clamp(x - std::floor(x), 1e-12, 1.0 - 1e-12);
  }

 private:
  /// Splitmix64.
  static double random(std::uint64_t& state) {
    std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }
  std::array<double, kDimensions> step_{}, start_{};
};

class Integration {
 public:
  Integration(const AxisScene& scene, const SkyAccuracy& accuracy, const Camera& camera)
      : scene_(scene),
        accuracy_(accuracy),
        lens_(camera.lens()),
        single_(scene.oneTilt && scene.sun.radius == 0.0 && scene.lines.size() == 1),
        groups_(single_ ? 1 : kGroups) {}

  SkyIntegral run() {
    start(0);
    extend(1);
    while (true) {
      judge();
      const double goal = accuracy_.error;
      if (result_.error <= goal) {
        result_.reached = true;
        break;
      }
      // Whichever is in the way most is made better.
      if (single_ || (mesh_ > outer_ && mesh_ > 0.5 * goal)) {
        if (level_ == kMostLevel) break;
        const int points = std::max(1, points_ / 2);
        // Of a single sheet the last mesh has half as many cells as the next.
        if (single_) {
          previous_.clear();
          for (const auto& xyz : result_.xyz) previous_.push_back(static_cast<double>(xyz[1]));
        }
        start(level_ + 1);
        extend(points);
      } else {
        if (points_ >= kMostPoints) break;
        extend(2 * points_);
      }
    }
    return std::move(result_);
  }

 private:
  void start(int level) {
    level_ = level;
    points_ = 0;
    table_ = std::make_unique<LightTable>(scene_.prisms, scene_.indices, kColumns << level, kRows << level,
                                          accuracy_.cutShare, scene_.wanted);
    films_.clear();
    for (std::size_t group = 0; group < groups_; ++group)
      films_.emplace_back(static_cast<int>(lens_.width), static_cast<int>(lens_.height));
    totals_.assign(groups_, {});
  }

  void extend(int points) {
    std::vector<std::vector<SheetPoint>> sheets(groups_);
    for (std::size_t group = 0; group < groups_; ++group) {
      const EvenPoints even(accuracy_.seed, static_cast<int>(group));
      for (int k = points_; k < points; ++k) {
        SheetPoint point;
        point.tilt = scene_.tilt(even.at(k, 0));
        point.toSun = scene_.toSun(even.at(k, 1), even.at(k, 2));
        const IndexColour light = scene_.light(even.at(k, 3));
        point.index = light.index;
        point.xyz = light.xyz;
        point.offset = even.at(k, 4);
        prepare(point);
        sheets[group].push_back(point);
      }
    }
    SheetMesh mesh{kPi / 6.0 / (kColumns << level_),
                   accuracy_.folds,
                   faintest(),
                   accuracy_.hasEdge,
                   accuracy_.widest,
                   previous_.empty(),
                   scene_.side};
    forEach(groups_, [&](std::size_t group) {
      OrientationSheet sheet(*table_, lens_, mesh);
      for (const SheetPoint& point : sheets[group]) totals_[group].add(sheet.add(point, films_[group]), 1.0);
    });
    result_.sheets += static_cast<long>(groups_) * (points - points_);
    points_ = points;
  }

  /// Traces what a sheet needs.
  void prepare(const SheetPoint& point) {
    const auto [least, most] = OrientationSheet::anglesAt(point.tilt, point.toSun);
    table_->prepare(least, most);
  }

  /// Light to a pixel, of one sheet, that does not matter to the accuracy.
  double faintest() const {
    const double pixel = kInPicture / (static_cast<double>(lens_.width) * lens_.height);
    return kFaint * accuracy_.error * table_->wantedShare() * pixel;
  }

  /// Takes stock: the picture and its error.
  void judge() {
    const int width = static_cast<int>(lens_.width), height = static_cast<int>(lens_.height);
    const std::size_t pixels = films_.front().pixels();
    result_.xyz.resize(pixels);
    result_.variance.resize(pixels);
    std::vector<double> outer(pixels), mesh(pixels), light(pixels);
    const double per = 1.0 / points_, count = static_cast<double>(groups_);
    const auto at = [&](std::size_t group, int x, int y) {
      const PixelFilm& film = films_[group];
      const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
      PixelFilm::Four sum = film.at(row + static_cast<std::size_t>(x));
      if (accuracy_.folds) sum = 0.5 * (sum + film.at(row + static_cast<std::size_t>(width - 1 - x)));
      return PixelFilm::Four(per * sum);
    };
    forRows(height, [&](int y) {
      for (int x = 0; x < width; ++x) {
        const std::size_t i =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
        PixelFilm::Four sum{};
        std::array<double, kGroups> each{};
        for (std::size_t group = 0; group < groups_; ++group) {
          const PixelFilm::Four own = at(group, x, y);
          each[group] = own[1];
          sum += own;
        }
        sum *= 1.0 / count;
        double squares = 0.0;
        for (std::size_t group = 0; group < groups_; ++group)
          squares += (each[group] - sum[1]) * (each[group] - sum[1]);
        light[i] = sum[1];
        outer[i] = groups_ > 1 ? squares / (count * (count - 1.0)) : 0.0;
        const double coarse = previous_.empty() ? sum[3] : previous_[i];
        mesh[i] = kOfMesh * kOfMesh * (coarse - sum[1]) * (coarse - sum[1]);
        result_.xyz[i] = {static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])};
      }
    });
    // What a pixel's own few groups say of its error is itself uncertain: its neighbours are asked, too.
    double outerSum = 0.0, meshSum = 0.0, lightSum = 0.0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const std::size_t i =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
        double o = 0.0, m = 0.0;
        int pixelsAsked = 0;
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) {
            const int nx = x + dx, ny = y + dy;
            if (nx < 0 || ny < 0 || nx >= width || ny >= height) continue;
            const std::size_t j =
                static_cast<std::size_t>(ny) * static_cast<std::size_t>(width) + static_cast<std::size_t>(nx);
            o += outer[j];
            m += mesh[j];
            ++pixelsAsked;
          }
        o /= pixelsAsked;
        m = std::max(m / pixelsAsked, mesh[i]);
        result_.variance[i] = static_cast<float>(o + m);
        outerSum += std::sqrt(o);
        meshSum += std::sqrt(m);
        lightSum += light[i];
      }
    outer_ = lightSum > 0.0 ? outerSum / lightSum : 0.0;
    mesh_ = lightSum > 0.0 ? meshSum / lightSum : 0.0;
    const double mean = kOfMean * std::hypot(outer_, mesh_);
    double error = 0.0;
    for (std::size_t i = 0; i < pixels; ++i) {
      result_.variance[i] += static_cast<float>(mean * mean * light[i] * light[i]);
      error += std::sqrt(static_cast<double>(result_.variance[i]));
    }
    result_.error = lightSum > 0.0 ? error / lightSum : 0.0;
    result_.directions = table_->directions();
    result_.totals = {};
    for (const SheetTotals& totals : totals_) result_.totals.add(totals, per / count);
  }

  const AxisScene& scene_;
  SkyAccuracy accuracy_;
  Lens lens_;
  bool single_;
  std::size_t groups_;
  int level_ = 0, points_ = 0;
  std::unique_ptr<LightTable> table_;
  std::vector<PixelFilm> films_;
  std::vector<double> previous_;  // Y of a single sheet at the last level
  std::vector<SheetTotals> totals_;
  double outer_ = 0.0, mesh_ = 0.0;
  SkyIntegral result_;
};

}  // namespace

SkyIntegral integrateSky(const AxisScene& scene, const SkyAccuracy& accuracy, const Camera& camera, BandStore& store) {
  if (isForTilts(scene, camera)) return integrateTilts(scene, accuracy, camera, store);
  return Integration(scene, accuracy, camera).run();
}

}  // namespace parhelion
