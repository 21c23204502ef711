// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "halos/closed_forms.h"
#include "halos/edge_fit.h"
#include "halos/position.h"
#include "trace/scatter_profile.h"

using namespace parhelion;

namespace {

/// Light over the scattering angle (degrees) of randomly oriented crystals, all of it, whatever faces it has met.
Histogram scattered(const Cloud& cloud, std::uint64_t rays, Histogram histogram, Engine engine) {
  ScatterProfile profile(static_cast<int>(histogram.energy.size()), radians(histogram.from), radians(histogram.to));
  traceRays(cloud, {.rays = rays, .engine = engine}, 0, profile);
  const auto bins = profile.bins();
  for (std::size_t i = 0; i < bins.size(); ++i) histogram.energy[i] = bins[i].energy;
  return histogram;
}

EdgeFit ringEdge(double wavelength, const IceSettings& ice, double guess, std::uint64_t rays,
                 Engine engine = Engine::planes) {
  const Cloud cloud = cloudUnderPointSun(radians(20), {prisms(1.0, RandomOrientation{})}, ice, wavelength);
  return fitEdge(scattered(cloud, rays, Histogram(guess - 0.8, guess + 0.8, 320), engine));
}

}  // namespace

TEST_CASE("the 22 degree ring's inner edge lies at the least deviation of the 60 degree wedge, 21.839 at n = 1.31") {
  const double expected = degrees(theory::leastDeviation(radians(60), kIndex));
  CHECK(expected == doctest::Approx(21.839).epsilon(5e-5));
  const EdgeFit edge = ringEdge(550.0, ConstantIndex{kIndex}, 21.8, 800'000);
  CHECK(edge.step > 0.0);
  checkPosition("22° ring, inner edge, n = 1.31", expected, edge.position, 0.01);
  CHECK(std::abs(ringEdge(550.0, ConstantIndex{kIndex}, 21.8, 800'000, Engine::embree).position - expected) < 0.01);
}

TEST_CASE("the 46 degree ring's inner edge lies at the least deviation of the 90 degree wedge, 45.733 at n = 1.31") {
  const double expected = degrees(theory::leastDeviation(radians(90), kIndex));
  CHECK(expected == doctest::Approx(45.733).epsilon(5e-5));
  const EdgeFit edge = ringEdge(550.0, ConstantIndex{kIndex}, 45.7, 2'000'000);
  CHECK(edge.step > 0.0);
  checkPosition("46° ring, inner edge, n = 1.31", expected, edge.position, 0.03);
  CHECK(std::abs(ringEdge(550.0, ConstantIndex{kIndex}, 45.7, 2'000'000, Engine::embree).position - expected) < 0.03);
}

TEST_CASE("the 22 degree ring is red inside: its edge is at 22.272 degrees in 450 nm, 21.915 in 550, 21.688 in 650") {
  // Warren & Brandt 2008: n = 1.3157, 1.3110, 1.3080.
  struct Colour {
    double wavelength, index, edge;
  };
  for (const Colour& c : {Colour{450, 1.3157, 22.272}, Colour{550, 1.3110, 21.915}, Colour{650, 1.3080, 21.688}}) {
    CAPTURE(c.wavelength);
    const double expected = degrees(theory::leastDeviation(radians(60), c.index));
    CHECK(std::abs(expected - c.edge) < 0.001);
    const EdgeFit edge = ringEdge(c.wavelength, PublishedIndex{}, 22.0, 500'000);
    checkPosition("22° ring, inner edge, " + std::to_string(int(c.wavelength)) + " nm", expected, edge.position, 0.015);
  }
}
