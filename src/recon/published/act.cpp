// SPDX-License-Identifier: Apache-2.0
#include "recon/published/act.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "parallel/loops.h"
#include "recon/methods.h"
#include "recon/published/filter_size.h"
#include "recon/published/fourier.h"
#include "recon/published/low_pass.h"

namespace parhelion {

namespace {

constexpr double kMargin = 4.0;        // sampling periods by which edges that do not touch are kept apart
constexpr double kLostDigits = 1e-12;  // relative: a quotient just below a whole number counts as that
constexpr double kRounding = 1e-14;    // of the residual relative to the right side: nothing is left to fit

using Pictures = std::vector<Raster<double>>;

// One axis of the polynomial: its period in pixels, its highest frequency, and the points of the grid on which products
// of polynomials by the weights are exact.
struct Axis {
  int period, degree, points;

  Axis(int side, bool wrap, double samplingPeriod) {
    const double margin = std::min(std::ceil(kMargin * samplingPeriod), 3.0 * side);
    period = wrap || side == 1 ? side : fastLength(side + static_cast<int>(margin));
    degree = static_cast<int>(std::min(period / (2.0 * samplingPeriod) * (1.0 + kLostDigits), period / 2.0));
    points = std::min(period, fastLength(4 * degree + 1));
  }
};

double innerProduct(const Raster<double>& a, const Raster<double>& b) {
  return sumOverRows(a.height(), [&](int y) {
    double sum = 0.0;
    for (int x = 0; x < a.width(); ++x) sum += a.at(x, y) * b.at(x, y);
    return sum;
  });
}

// y = factor y + x
void scaleAndAdd(Pictures& y, double factor, const Pictures& x) {
  for (std::size_t k = 0; k < y.size(); ++k) {
    for (std::size_t i = 0; i < y[k].size(); ++i) y[k][i] = factor * y[k][i] + x[k][i];
  }
}

// y += factor x
void addScaled(Pictures& y, double factor, const Pictures& x) {
  for (std::size_t k = 0; k < y.size(); ++k) {
    for (std::size_t i = 0; i < y[k].size(); ++i) y[k][i] += factor * x[k][i];
  }
}

// The normal equations of the weighted fit. Polynomials are held by their values on the small grid, where the
// block-Toeplitz matrix is a product by the weights and a return to the polynomials.
class NormalEquations {
 public:
  NormalEquations(const HitMap& map, const KnownValues& known, double period)
      : known_(known),
        width_(static_cast<std::size_t>(map.width())),
        x_(map.width(), map.wrapX, period),
        y_(map.height(), map.wrapY, period),
        band_(bandPass(x_, y_, period)),
        weights_(onSmallGrid(known.weights)) {}

  Pictures rightSides() const {
    Pictures sides;
    for (const std::vector<double>& values : known_.lights) {
      std::vector<double> weighted(values.size());
      for (std::size_t i = 0; i < values.size(); ++i) weighted[i] = values[i] * known_.weights[i];
      sides.push_back(onSmallGrid(weighted));
    }
    return band_(sides);
  }

  Pictures apply(Pictures polynomials) const {
    for (Raster<double>& p : polynomials) {
      for (std::size_t i = 0; i < p.size(); ++i) p[i] *= weights_[i];
    }
    return band_(polynomials);
  }

  // The constants that are the weighted means.
  Pictures means() const {
    double total = 0.0;
    for (const double weight : known_.weights) total += weight;
    Pictures constants;
    for (const std::vector<double>& values : known_.lights) {
      const double sum = std::inner_product(values.begin(), values.end(), known_.weights.begin(), 0.0);
      constants.emplace_back(x_.points, y_.points, total > 0.0 ? sum / total : 0.0);
    }
    return constants;
  }

  // The values of a polynomial on the whole period.
  Raster<double> evaluate(const Raster<double>& polynomial) const { return resample(polynomial, x_.period, y_.period); }

 private:
  static LowPass bandPass(const Axis& x, const Axis& y, double period) {
    Raster<double> transfer(x.points, y.points);
    for (int j = 0; j < y.points; ++j) {
      for (int i = 0; i < x.points; ++i) {
        const int kx = signedFrequency(i, x.points), ky = signedFrequency(j, y.points);
        transfer.at(i, j) = passes(kx, x.period, ky, y.period, period) ? 1.0 : 0.0;
      }
    }
    return LowPass(std::move(transfer));
  }

  Raster<double> onSmallGrid(const std::vector<double>& values) const {
    Raster<double> scattered(x_.period, y_.period);
    for (std::size_t i = 0; i < values.size(); ++i) {
      scattered.at(static_cast<int>(known_.pixels[i] % width_), static_cast<int>(known_.pixels[i] / width_)) =
          values[i];
    }
    return resample(scattered, x_.points, y_.points);
  }

  const KnownValues& known_;
  std::size_t width_;
  Axis x_, y_;
  LowPass band_;
  Raster<double> weights_;
};

// Starts from the means, which no step has then to find.
Pictures conjugateGradients(const NormalEquations& equations, int iterations, const Watch& watch) {
  Pictures solution = equations.means();
  Pictures rest = equations.rightSides();
  const double rounding = kRounding * kRounding * innerProduct(rest[0], rest[0]);
  addScaled(rest, -1.0, equations.apply(solution));
  Pictures direction = rest;
  double square = innerProduct(rest[0], rest[0]);
  for (int i = 0; i < iterations && square > rounding; ++i) {
    watch.at(static_cast<double>(i) / iterations);
    const Pictures image = equations.apply(direction);
    const double step = square / innerProduct(direction[0], image[0]);
    addScaled(solution, step, direction);
    addScaled(rest, -step, image);
    const double next = innerProduct(rest[0], rest[0]);
    scaleAndAdd(direction, next / square, rest);
    square = next;
  }
  return solution;
}

}  // namespace

Reconstruction fitPolynomial(const HitMap& map, const KnownValues& known, double period, int iterations,
                             const Watch& watch) {
  const NormalEquations equations(map, known, period);
  Reconstruction result;
  for (const Raster<double>& solution : conjugateGradients(equations, iterations, watch)) {
    const Raster<double> whole = equations.evaluate(solution);
    Raster<double>& picture = result.lights.emplace_back(map.width(), map.height());
    forRows(map.height(), [&](int y) {
      for (int x = 0; x < map.width(); ++x) picture.at(x, y) = map.omega.at(x, y) > 0.0 ? whole.at(x, y) : 0.0;
    });
  }
  return result;
}

Reconstruction reconstructHits(const HitMap& map, const ActSettings& settings, const Watch& watch) {
  watch.at(0.0);
  const KnownValues known = voronoiCells(map, NearestHits(map), settings.reading);
  const double period = settings.period.value_or(sizeByHits(map, kActPeriod));
  Reconstruction result = fitPolynomial(map, known, period, settings.iterations, watch);
  result.remarks.push_back(sizeRemark("period", period));
  return result;
}

}  // namespace parhelion
