// SPDX-License-Identifier: Apache-2.0
#include "optics/ice.h"

#include <cmath>

#include <doctest/doctest.h>

#include "optics/tables.h"

using namespace parhelion;

namespace {

struct Node {
  double wavelength, index;
};

// Warren & Brandt 2008, the visible part of their table.
constexpr Node kPublished[] = {{390, 1.3203}, {400, 1.3194}, {410, 1.3185}, {420, 1.3177}, {430, 1.3170}, {440, 1.3163},
                               {450, 1.3157}, {460, 1.3151}, {470, 1.3145}, {480, 1.3140}, {490, 1.3135}, {500, 1.3130},
                               {510, 1.3126}, {520, 1.3121}, {530, 1.3117}, {540, 1.3114}, {550, 1.3110}, {560, 1.3106},
                               {570, 1.3103}, {580, 1.3100}, {590, 1.3097}, {600, 1.3094}, {610, 1.3091}, {620, 1.3088},
                               {630, 1.3085}, {640, 1.3083}, {650, 1.3080}, {660, 1.3078}, {670, 1.3076}, {680, 1.3073},
                               {690, 1.3071}, {700, 1.3069}, {710, 1.3067}, {720, 1.3065}, {730, 1.3062}, {740, 1.3060},
                               {750, 1.3059}, {760, 1.3057}, {770, 1.3055}, {780, 1.3053}, {790, 1.3051}, {800, 1.3049},
                               {810, 1.3047}, {820, 1.3046}, {830, 1.3044}};

}  // namespace

TEST_CASE("the index of ice is Warren and Brandt's at every visible node") {
  for (const Node& node : kPublished) {
    INFO(node.wavelength);
    CHECK(std::abs(iceIndex(node.wavelength) - node.index) < 1e-5);
  }
}

TEST_CASE("the index of ice follows the dispersion formula to 9e-5 from 400 to 780 nm") {
  for (double w = 400.0; w <= 780.0; w += 0.5) {
    // A fit to the same measurements, in micrometres.
    const double w2 = 1e-6 * w * w;
    const double fit = std::sqrt(1.69913518 + 0.00690978 / w2 - 0.0108402 * w2);
    INFO(w);
    // The chord of a convex curve lies up to 1e-6 above it.
    CHECK(std::abs(iceIndex(w) - fit) < 9e-5 + 1e-6);
  }
}

TEST_CASE("the index of ice falls steadily with wavelength and keeps its ends' values beyond the table") {
  for (double w = 350.0; w < 900.0; w += 0.25) {
    INFO(w);
    CHECK(iceIndex(w) > iceIndex(w + 0.25));
    CHECK(iceIndex(w) - iceIndex(w + 0.25) < 5e-5);
  }
  CHECK(iceIndex(200.0) == iceIndex(350.0));
  CHECK(iceIndex(2000.0) == iceIndex(900.0));
  for (std::size_t i = 1; i < kIceIndex.size(); ++i) CHECK(kIceIndex[i].wavelength > kIceIndex[i - 1].wavelength);
}

TEST_CASE("a constant index is the same at every wavelength") {
  CHECK(refractiveIndex(ConstantIce{1.31}, 400.0) == 1.31);
  CHECK(refractiveIndex(ConstantIce{1.31}, 700.0) == 1.31);
  CHECK(refractiveIndex(TabulatedIce{}, 550.0) == doctest::Approx(1.3110).epsilon(1e-9));
}

TEST_CASE("of a mixture of indices every half of the bundles takes each in turn") {
  const IceSettings ice = IceMixture{{1.30, 1.31, 1.32}};
  for (const std::uint64_t half : {0, 1}) {
    double sum = 0.0;
    for (std::uint64_t bundle = half; bundle < 12; bundle += 2) sum += refractiveIndex(ice, 550.0, bundle);
    CHECK(sum == doctest::Approx(6 * 1.31));
  }
}
