// SPDX-License-Identifier: Apache-2.0
#include "halos/edge_fit.h"

#include <cmath>
#include <limits>

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

namespace parhelion {

namespace {

/// Share of a disc of radius 1 on the near side of a line at signed distance x from its centre.
double coveredDisc(double x) {
  if (x <= -1.0) return 0.0;
  if (x >= 1.0) return 1.0;
  return 0.5 + (x * std::sqrt(1.0 - x * x) + std::asin(x)) / kPi;
}

/// Share of the step that a bin sees: by its part beyond a sharp edge, or by the disc's part at its centre.
double covered(const Histogram& h, int bin, double edge, double softness) {
  const double x = h.centre(bin) - edge;
  return softness > 0.0 ? coveredDisc(x / softness) : std::clamp(x / h.width() + 0.5, 0.0, 1.0);
}

struct Trial {
  double misfit, step;
};

/// Best background and step for an edge at a given place.
Trial fitLines(const Histogram& h, double edge, double softness) {
  glm::dmat4 normal(0.0);
  glm::dvec4 right(0.0);
  double squares = 0.0;
  const double scale = 1.0 / (h.to - h.from);
  for (int bin = 0; bin < static_cast<int>(h.energy.size()); ++bin) {
    const double x = (h.centre(bin) - edge) * scale, c = covered(h, bin, edge, softness);
    const glm::dvec4 terms(1.0, x, c, c * x);
    for (int i = 0; i < 4; ++i) normal[i] += terms[i] * terms;
    right += h.energy[bin] * terms;
    squares += h.energy[bin] * h.energy[bin];
  }
  const glm::dvec4 lines = glm::inverse(normal) * right;
  return {squares - glm::dot(lines, right), lines.z};
}

void improve(EdgeFit& best, double& least, const Histogram& h, double edge, double softness) {
  const Trial trial = fitLines(h, edge, softness);
  if (trial.misfit >= least) return;
  least = trial.misfit;
  best = {edge, softness, trial.step};
}

EdgeFit searchEdge(const Histogram& h, double widest, int softSteps) {
  EdgeFit best{};
  double least = std::numeric_limits<double>::infinity();
  constexpr int kSteps = 1000;
  for (int s = 0; s <= softSteps; ++s)
    for (int i = 0; i <= kSteps; ++i)
      improve(best, least, h, h.from + (h.to - h.from) * (0.25 + 0.5 * i / kSteps),
              softSteps > 0 ? widest * s / softSteps : 0.0);
  return best;
}

}  // namespace

EdgeFit fitEdge(const Histogram& histogram) { return searchEdge(histogram, 0.0, 0); }

EdgeFit fitSoftEdge(const Histogram& histogram, double widest) { return searchEdge(histogram, widest, 40); }

}  // namespace parhelion
