// SPDX-License-Identifier: Apache-2.0
#include "beam/sheet_integration.h"

#include <algorithm>
#include <cmath>

#include "parallel/loops.h"

namespace parhelion {

namespace {

constexpr int kMostPoints = 1 << 12;  // a group
// What a mesh of half as many cells differs by, times this, is a pixel's own part of the error. Where both err alike
// that says nothing, so the mean of all pixels, relative, is added, times a second factor.
constexpr double kOfMesh = 0.6, kOfMean = 1.0;
// The same where meshes alone get finer. Their lines may miss what a pixel has: the worst of its neighbours counts, and
// some of the mean error, absolute.
constexpr double kOfMeshAlone = 0.3, kOfMeanAlone = 0.5, kOfMissed = 0.4;
// Light is faint if it is less than this, times the accuracy, of what a pixel has on average; and how much light the
// picture has, more or less, of crystals' surface.
constexpr double kFaint = 0.2, kInPicture = 0.15;

/// Splitmix64.
double random(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

}  // namespace

EvenPoints::EvenPoints(std::uint64_t seed, int group) {
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

double EvenPoints::at(int point, int dimension) const {
  const auto d = static_cast<std::size_t>(dimension);
  const double x = start_[d] + point * step_[d];
  return std::clamp(x - std::floor(x), 1e-12, 1.0 - 1e-12);
}

SheetIntegration::SheetIntegration(const AxisScene& scene, const SkyAccuracy& accuracy, const Camera& camera,
                                   Sheets sheets, int mostLevel)
    : scene_(scene), accuracy_(accuracy), lens_(camera.lens()), sheets_(sheets), mostLevel_(mostLevel) {}

SkyIntegral SheetIntegration::run() {
  startMesh(0);
  extend(1);
  while (true) {
    judge();
    const double goal = accuracy_.error;
    if (result_.error <= goal) {
      result_.reached = true;
      break;
    }
    // Whichever is in the way most is made better.
    if (sheets_ != Sheets::groups || (mesh_ > outer_ && mesh_ > 0.5 * goal)) {
      if (level_ == mostLevel_) break;
      const int points = std::max(1, points_ / 2);
      // Of a single sheet the last mesh has half as many cells as the next.
      if (sheets_ == Sheets::one) {
        previous_.clear();
        for (const auto& xyz : result_.xyz) previous_.push_back(static_cast<double>(xyz[1]));
      }
      startMesh(level_ + 1);
      extend(points);
    } else {
      if (points_ >= kMostPoints) break;
      extend(2 * points_);
    }
  }
  return std::move(result_);
}

void SheetIntegration::startMesh(int level) {
  level_ = level;
  points_ = 0;
  start(level);
  films_.clear();
  const std::size_t films = sheets_ == Sheets::one ? 1 : kFilms;
  for (std::size_t k = 0; k < films; ++k)
    films_.emplace_back(static_cast<int>(lens_.width), static_cast<int>(lens_.height));
  totals_.assign(films, {});
}

void SheetIntegration::extend(int points) {
  result_.sheets += add(points_, points, previous_.empty());
  points_ = points;
}

double SheetIntegration::faintest() const {
  const double pixel = kInPicture / (static_cast<double>(lens_.width) * lens_.height);
  return kFaint * accuracy_.error * wantedShare() * pixel;
}

/// Takes stock: the picture and its error.
void SheetIntegration::judge() {
  const int width = static_cast<int>(lens_.width), height = static_cast<int>(lens_.height);
  const std::size_t pixels = films_.front().pixels();
  result_.xyz.resize(pixels);
  result_.variance.resize(pixels);
  std::vector<double> outer(pixels), mesh(pixels), light(pixels);
  const bool alone = sheets_ == Sheets::all;
  const double ofMesh = alone ? kOfMeshAlone : kOfMesh, ofMean = alone ? kOfMeanAlone : kOfMean;
  const double per = 1.0 / points_, count = sheets_ == Sheets::groups ? static_cast<double>(films_.size()) : 1.0;
  const auto at = [&](std::size_t group, int x, int y) {
    const PixelFilm& film = films_[group];
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    PixelFilm::Four sum = film.at(row + static_cast<std::size_t>(x));
    if (accuracy_.folds) sum = 0.5 * (sum + film.at(row + static_cast<std::size_t>(width - 1 - x)));
    return PixelFilm::Four(per * sum);
  };
  forRows(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
      PixelFilm::Four sum{};
      std::array<double, kFilms> each{};
      for (std::size_t group = 0; group < films_.size(); ++group) {
        const PixelFilm::Four own = at(group, x, y);
        each[group] = own[1];
        sum += own;
      }
      sum *= 1.0 / count;
      double squares = 0.0;
      for (std::size_t group = 0; group < films_.size(); ++group)
        squares += (each[group] - sum[1]) * (each[group] - sum[1]);
      light[i] = sum[1];
      outer[i] = sheets_ == Sheets::groups ? squares / (count * (count - 1.0)) : 0.0;
      const double coarse = previous_.empty() ? sum[3] : previous_[i];
      mesh[i] = ofMesh * ofMesh * (coarse - sum[1]) * (coarse - sum[1]);
      result_.xyz[i] = {static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])};
    }
  });
  // What a pixel's own few groups say of its error is itself uncertain: its neighbours are asked, too.
  double outerSum = 0.0, meshSum = 0.0, lightSum = 0.0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
      double o = 0.0, m = 0.0, worst = 0.0;
      int pixelsAsked = 0;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const int nx = x + dx, ny = y + dy;
          if (nx < 0 || ny < 0 || nx >= width || ny >= height) continue;
          const std::size_t j =
              static_cast<std::size_t>(ny) * static_cast<std::size_t>(width) + static_cast<std::size_t>(nx);
          o += outer[j];
          m += mesh[j];
          worst = std::max(worst, mesh[j]);
          ++pixelsAsked;
        }
      o /= pixelsAsked;
      m = alone ? worst : std::max(m / pixelsAsked, mesh[i]);
      result_.variance[i] = static_cast<float>(o + m);
      outerSum += std::sqrt(o);
      meshSum += std::sqrt(m);
      lightSum += light[i];
    }
  outer_ = lightSum > 0.0 ? outerSum / lightSum : 0.0;
  mesh_ = lightSum > 0.0 ? meshSum / lightSum : 0.0;
  const double both = std::hypot(outer_, mesh_), mean = ofMean * both,
               missed = alone ? kOfMissed * both * lightSum / static_cast<double>(pixels) : 0.0;
  double error = 0.0;
  for (std::size_t i = 0; i < pixels; ++i) {
    result_.variance[i] += static_cast<float>(mean * mean * light[i] * light[i] + missed * missed);
    error += std::sqrt(static_cast<double>(result_.variance[i]));
  }
  result_.error = lightSum > 0.0 ? error / lightSum : 0.0;
  result_.directions = directions();
  result_.totals = {};
  for (const SheetTotals& totals : totals_) result_.totals.add(totals, per / count);
}

}  // namespace parhelion
