// SPDX-License-Identifier: Apache-2.0
#include "beam/tilt_integral.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include <glm/geometric.hpp>

#include "beam/tilt_mesh.h"
#include "beam/tilt_sky.h"
#include "math/portable.h"
#include "parallel/loops.h"

namespace parhelion {

namespace {

// What the coarse mesh differs by, times this, is a pixel's own part of the error. Where both meshes err alike that
// says nothing, so the mean of all pixels, relative, is added, times a second factor, and absolute, times a third: dim
// pixels may have something of an edge beside them that both miss.
constexpr double kOfCoarse = 0.25, kOfMean = 0.75, kOfMissed = 0.1;
// The same where tilts are spread by less than a cell, and meshes get better but by their fineness: under a point of
// the sun, and under a disc, which spreads light, too.
constexpr double kOfCoarseAtRest = 1.2, kOfCoarseUnderDisc = 0.55;
// Waves that are left out leave ripples, of this share of the light beside them and of what pixels have on average.
constexpr double kRipple = 1e-3, kFarRipple = 3e-4;
// Pixels around that one without light is compared with, to either side.
constexpr int kAround = 2;
// Pixels that are narrower than a cell may have as much of the difference between their neighbours' light as this.
constexpr double kWithinCell = 0.25;
// What a picture needs of bands is rounded to such steps, that the next one may need the same: cosines of so many
// waves, and rings by so many to all of them.
constexpr double kOrderSteps = 64.0;
constexpr int kRingSteps = 16;

class TiltIntegration {
 public:
  TiltIntegration(const AxisScene& scene, const SkyAccuracy& accuracy, const Camera& camera, BandStore& store)
      : scene_(scene),
        accuracy_(accuracy),
        camera_(camera),
        store_(scene.wanted ? own_ : store),
        kept_(store.directions(camera)),
        directions_(*kept_) {}

  SkyIntegral run() {
    for (level_ = kTiltLevels.firstFor(accuracy_.error);; ++level_) {
      result_.refused = !integrate();
      if (result_.refused) break;
      judge();
      result_.reached = result_.error <= accuracy_.error;
      if (result_.reached || isFinestMesh(camera_, scene_.sun.radius, level_)) break;
    }
    return std::move(result_);
  }

 private:
  /// False if it is not to.
  bool integrate() {
    BandMesh mesh = tiltMeshOf(cell(), spreadOfTilts(), level_);
    seenRings(mesh);
    const auto cosines = store_.cosines(mesh.cells);
    TiltSky sky(*cosines, mesh, sunRows(scene_.sun, sunRowsOf(scene_.sun.radius, mesh.cells)), scene_.tilt, scene_.side,
                store_.room);
    colours_ = scene_.hasColours();
    std::vector<int> numbers;
    for (int band = 0; band < mesh.bands; ++band)
      if (sky.hasBand(band)) numbers.push_back(band);
    result_.totals = {};
    if (numbers.empty()) {
      pixels_.assign(static_cast<std::size_t>(camera_.width()) * static_cast<std::size_t>(camera_.height()), {});
      return true;
    }
    mesh.orders = kOrderSteps * std::ceil(sky.highestOrder() / kOrderSteps);
    const int columns = tiltColumnsAt(level_), lights = tiltLightsAt(level_);
    if (accuracy_.goOn && !accuracy_.goOn(workLeft(mesh, static_cast<int>(numbers.size()), columns, lights)))
      return false;
    BandStore::Bands& bands = store_.open({scene_.prisms, scene_.indices, columns, accuracy_.cutShare, mesh, colours_,
                                           scene_.segments(lights), scene_.segments(lights / 2), scene_.wanted});
    const BandLight& light = bands.light();
    const long traced = bands.directions();
    sky.start(mesh, light.channels());
    bands.forEach(numbers, [&](std::span<const NumberedBand> some) { sky.add(light, some); });
    sky.expose(directions_, accuracy_.folds, pixels_);
    result_.totals = sky.totals();
    result_.directions += bands.directions() - traced;
    result_.sheets += static_cast<long>(numbers.size());
    return true;
  }

  /// Of this mesh, and of those that are likely to follow it.
  double workLeft(const BandMesh& mesh, int bands, int columns, int lights) const {
    const auto count = [](std::size_t n) { return static_cast<int>(n); };
    const double work = workOf(
        {bands, mesh.end - mesh.first, mesh.cells, columns, scene_.lines.empty() ? lights : count(scene_.lines.size()),
         count(scene_.indices.size()), count(scene_.prisms.size()), sunRowsOf(scene_.sun.radius, mesh.cells),
         camera_.width() * camera_.height(), 1.0 / camera_.focalLength()});
    if (result_.error <= 0.0) return work;
    const int more = kTiltLevels.levelsFrom(result_.error / kTiltLevels.better, accuracy_.error);
    return work * workOfLevels(std::min(more, kTiltLevels.most - level_));
  }

  double spreadOfTilts() const { return 0.5 * std::abs(scene_.tilt(0.84) - scene_.tilt(0.16)); }

  double ofCoarse() const {
    const double atRest = scene_.sun.radius > 0.0 ? kOfCoarseUnderDisc : kOfCoarseAtRest;
    return kOfCoarse + (atRest - kOfCoarse) * std::clamp(1.0 - spreadOfTilts() / cell(), 0.0, 1.0);
  }

  double cell() const { return cellOf(blurOf(camera_, scene_.sun.radius), level_); }

  /// Rings that the picture shows, and those beside them.
  void seenRings(BandMesh& mesh) const {
    double nearest = -1.0, farthest = 1.0;  // cosines
    for (std::size_t pixel = 0; pixel < directions_.solidAngles().size(); ++pixel) {
      const Vec3& middle = directions_.middle(pixel);
      if (directions_.solidAngle(pixel) <= 0.0 || middle == Vec3(0.0)) continue;
      const double onto = glm::dot(middle, scene_.sun.toCentre);
      nearest = std::max(nearest, onto);
      farthest = std::min(farthest, onto);
    }
    const double least = std::acos(std::min(nearest, 1.0)), most = std::acos(std::max(farthest, -1.0));
    const double beyond = directions_.largest() + 1.5 * scene_.sun.radius + (directions_.hasBroken() ? 0.1 : 0.0);
    const double perAngle = mesh.cells / kPi;
    const int step = (mesh.cells + kRingSteps - 1) / kRingSteps;
    mesh.first = std::clamp(static_cast<int>((least - beyond) * perAngle) - 3, 0, mesh.cells - 2) / step * step;
    mesh.end = std::min((static_cast<int>((most + beyond) * perAngle) + 4 + step - 1) / step * step, mesh.cells);
  }

  void judge() {
    const double factor = ofCoarse();
    const int width = camera_.width(), height = camera_.height(), mirrored = accuracy_.folds ? width / 2 : 0;
    result_.xyz.assign(pixels_.size(), {});
    result_.variance.assign(pixels_.size(), 0.0F);
    const std::size_t coarse = colours_ ? 3 : 1, y0 = colours_ ? 1 : 0;
    std::vector<double> errors(static_cast<std::size_t>(height)), light(static_cast<std::size_t>(height));
    const Tristimulus grey = scene_.lines.empty() ? Tristimulus{} : scene_.lines[0].xyz;
    // Light per solid angle is what neighbours are compared by: at the rim of a picture they may differ widely in size.
    double sum = 0.0, sky = 0.0;
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      sum += static_cast<double>(pixels_[i][y0]);
      sky += directions_.solidAngle(i);
    }
    const double least = sky > 0.0 ? kFarRipple * sum / sky : 0.0;
    forRows(height, [&](int y) {
      for (int x = mirrored; x < width; ++x) {
        if (perSolidAngle(x, y) == 0.0) continue;
        // What a pixel's own sums say of its error is itself uncertain: its neighbours are asked, too.
        double most = least * least, lowest = 1e300, highest = 0.0, across = directions_.width(x, y);
        const bool isRim = across == 0.0;
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) {
            const int nx = x + dx, ny = y + dy;
            if (nx < 0 || ny < 0 || nx >= width || ny >= height) continue;
            const double per = perSolidAngle(nx, ny);
            if (per == 0.0) continue;
            const auto& pixel = pixels_[indexOf(nx, ny)];
            const double off = per * static_cast<double>(pixel[coarse] - pixel[y0]),
                         luminance = per * static_cast<double>(pixel[y0]), ripple = kRipple * luminance;
            // Of the rim's pixels only parts see the sky, but they lie as far apart as others.
            if (isRim) across = std::max(across, directions_.width(nx, ny));
            lowest = std::min(lowest, luminance);
            highest = std::max(highest, luminance);
            most = std::max(most, off * off + ripple * ripple);
          }
        const std::size_t i = indexOf(x, y);
        if (across > 0.0 && across < cell()) {
          // Light is not told apart within a cell.
          const double apart = kWithinCell * (highest - lowest);
          most += apart * apart / (factor * factor);
        }
        const double scale = directions_.solidAngle(i) * (colours_ ? 1.0 : grey[1]);
        const double variance = factor * factor * scale * scale * most;
        result_.variance[i] = static_cast<float>(variance);
        const TiltSky::PixelLight lit = litAt(x, y, factor * directions_.solidAngle(i) * std::sqrt(most));
        for (std::size_t c = 0; c < 3; ++c)
          result_.xyz[i][c] = colours_ ? lit[c] : static_cast<float>(static_cast<double>(lit[0]) * grey[c]);
        const int seen = x >= width - mirrored ? 2 : 1;  // and in the mirror
        errors[static_cast<std::size_t>(y)] += seen * std::sqrt(variance);
        light[static_cast<std::size_t>(y)] += seen * static_cast<double>(result_.xyz[i][1]);
      }
      const auto mirror = [&](auto row) { std::reverse_copy(row + (width - mirrored), row + width, row); };
      mirror(result_.xyz.begin() + static_cast<std::ptrdiff_t>(indexOf(0, y)));
      mirror(result_.variance.begin() + static_cast<std::ptrdiff_t>(indexOf(0, y)));
    });
    const auto together = [](const std::vector<double>& rows) {
      return std::accumulate(rows.begin(), rows.end(), 0.0);
    };
    const double all = together(light), mean = all > 0.0 ? together(errors) / all : 0.0,
                 missed = sky > 0.0 ? kOfMissed * mean * all / sky : 0.0;
    double error = 0.0;
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      const double own = kOfMean * mean * static_cast<double>(result_.xyz[i][1]),
                   dim = missed * directions_.solidAngle(i);
      result_.variance[i] += static_cast<float>(own * own + dim * dim);
      error += std::sqrt(static_cast<double>(result_.variance[i]));
    }
    result_.error = all > 0.0 ? error / all : 0.0;
  }

  std::size_t indexOf(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(camera_.width()) + static_cast<std::size_t>(x);
  }

  /// One over the solid angle of a pixel; 0 where it sees no sky.
  double perSolidAngle(int x, int y) const {
    const double solidAngle = directions_.solidAngle(indexOf(x, y));
    return solidAngle > 0.0 ? 1.0 / solidAngle : 0.0;
  }

  /// What the light of a pixel with such an error is taken for. Beside a sharp edge what is put back of blur may leave
  /// less than nothing: there it is that of the darkest pixel around with any, and no more than the error.
  TiltSky::PixelLight litAt(int x, int y, double error) const {
    // No visible light has a Y without an X, but red has next to no Z.
    const std::size_t luminance = colours_ ? 1 : 0;
    const auto isLight = [&](const TiltSky::PixelLight& one) { return one[0] > 0.0F && one[luminance] > 0.0F; };
    TiltSky::PixelLight light = pixels_[indexOf(x, y)];
    const double per = perSolidAngle(x, y);
    if (!isLight(light) && per > 0.0) {
      light = {};
      for (int row = std::max(y - kAround, 0); row <= std::min(y + kAround, camera_.height() - 1); ++row)
        for (int column = std::max(x - kAround, 0); column <= std::min(x + kAround, camera_.width() - 1); ++column) {
          TiltSky::PixelLight other = pixels_[indexOf(column, row)];
          if (!isLight(other)) continue;
          for (float& channel : other) channel *= static_cast<float>(perSolidAngle(column, row) / per);
          if (!isLight(light) || other[luminance] < light[luminance]) light = other;
        }
      const auto lit = static_cast<double>(light[luminance]);
      if (lit > error)
        for (float& channel : light) channel *= static_cast<float>(error / lit);
    }
    for (float& channel : light) channel = std::max(channel, 0.0F);
    return light;
  }

  const AxisScene& scene_;
  SkyAccuracy accuracy_;
  const Camera& camera_;
  BandStore own_;  // of light that is wanted, which no other picture asks for
  BandStore& store_;
  std::shared_ptr<const PixelDirections> kept_;
  const PixelDirections& directions_;
  int level_ = 0;
  bool colours_ = true;
  std::vector<TiltSky::PixelLight> pixels_;
  SkyIntegral result_;
};

}  // namespace

SkyIntegral integrateTilts(const AxisScene& scene, const SkyAccuracy& accuracy, const Camera& camera,
                           BandStore& store) {
  return TiltIntegration(scene, accuracy, camera, store).run();
}

}  // namespace parhelion
