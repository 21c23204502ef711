// SPDX-License-Identifier: Apache-2.0
#include "trace/flight_places.h"

#include <cmath>

#include <doctest/doctest.h>

using namespace parhelion;

TEST_CASE("weights make up for where places on a flight are drawn: means over draws are those of what is scattered") {
  for (const double depth : {1e-7, 0.3, 2.0, 20.0})
    for (const double behind : {0.0, 0.5})
      for (const FlightPlaces::Faces faces :
           {FlightPlaces::Faces{true, true}, {true, false}, {false, true}, {false, false}}) {
        CAPTURE(depth);
        CAPTURE(behind);
        const FlightPlaces places(depth, behind, faces);
        constexpr int kDraws = 20'000;
        double all = 0.0, lower = 0.0, nearEnd = 0.0;
        const double half = 0.5 * depth, close = 0.97 * depth;
        for (int k = 0; k < kDraws; ++k) {
          const double at = places.at((k + 0.5) / kDraws), weight = places.weightAt(at) / kDraws;
          CHECK_UNARY(at >= 0.0 && at <= depth);
          all += weight;
          if (at < half) lower += weight;
          if (at > close) nearEnd += weight;
        }
        const auto exact = [&](double from, double to) { return (std::exp(-from) - std::exp(-to)) / takenOver(depth); };
        CHECK(all == doctest::Approx(1.0).epsilon(2e-3));
        CHECK(lower == doctest::Approx(exact(0.0, half)).epsilon(2e-3));
        if (depth < 8.0) CHECK(nearEnd == doctest::Approx(exact(close, depth)).epsilon(5e-3));
        CHECK(places.weight(0.0, depth) == doctest::Approx(1.0).epsilon(1e-9));
        CHECK(places.weight(half, half * (1.0 + 1e-6)) == doctest::Approx(places.weightAt(half)).epsilon(1e-4));
      }
}
