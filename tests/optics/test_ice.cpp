// SPDX-License-Identifier: Apache-2.0
#include "optics/ice.h"

#include <cmath>

#include <doctest/doctest.h>

#include "math/names.h"
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
  CHECK(refractiveIndex(ConstantIndex{1.31}, 400.0) == 1.31);
  CHECK(refractiveIndex(ConstantIndex{1.31}, 700.0) == 1.31);
  CHECK(refractiveIndex(PublishedIndex{}, 550.0) == doctest::Approx(1.3110).epsilon(1e-9));
}

TEST_CASE("published indices are those of their sources") {
  const auto at = [](Material material, double wavelength) {
    return refractiveIndex(PublishedIndex{material}, wavelength);
  };
  // Li 1976 tabulates 1.5441 at the sodium line and 1.56769 at 400 nm; the handbooks' n_D of water at 20 degrees is
  // 1.33299 relative to air, 1.33336 to vacuum.
  CHECK(std::abs(at(Material::salt, 589.3) - 1.5441) < 1e-4);
  CHECK(std::abs(at(Material::salt, 400.0) - 1.5675) < 3e-4);
  CHECK(std::abs(at(Material::water, 589.3) - 1.33336) < 3e-5);
  CHECK(at(Material::cubicIce, 550.0) == iceIndex(550.0));
  const Node co2[] = {{333, 1.438}, {363, 1.432}, {401, 1.426}, {427, 1.423}, {452, 1.420},
                      {490, 1.417}, {515, 1.415}, {553, 1.413}, {578, 1.412}, {616, 1.411},
                      {679, 1.409}, {742, 1.407}, {805, 1.406}, {868, 1.406}, {931, 1.405}};
  for (const Node& node : co2) CHECK(std::abs(at(Material::co2Ice, node.wavelength) - node.index) < 5.5e-4);
  for (const Node& node : {Node{433, 1.449}, Node{668, 1.423}, Node{1462, 1.408}})
    CHECK(std::abs(at(Material::ammoniaIce, node.wavelength) - node.index) < 2e-4);
  for (const Material material : kMembersOf<Material>) {
    CAPTURE(nameOf(material));
    for (double w = 360.0; w < 830.0; w += 1.0) CHECK(at(material, w) >= at(material, w + 1.0));
    CHECK(at(material, 1.0) == at(material, 150.0));  // the ends' values beyond
    CHECK(at(material, 1e5) == at(material, 1e6));
  }
}

TEST_CASE("formulas count wavelengths in micrometres, and tables are linear between their nodes") {
  CHECK(refractiveIndex(CauchyIndex{{1.3, 0.004, 0.0001}}, 500.0) == doctest::Approx(1.3 + 0.016 + 0.0016));
  CHECK(refractiveIndex(SellmeierIndex{1.1, {{0.6, 0.01}}}, 500.0) ==
        doctest::Approx(std::sqrt(1.1 + 0.6 * 0.25 / (0.25 - 0.01))));
  const IceSettings table = IndexTable{{{400, 1.33}, {500, 1.32}, {700, 1.30}}};
  CHECK(refractiveIndex(table, 450.0) == doctest::Approx(1.325));
  CHECK(refractiveIndex(table, 500.0) == 1.32);
  CHECK(refractiveIndex(table, 650.0) == doctest::Approx(1.305));
  CHECK(refractiveIndex(table, 100.0) == 1.33);
  CHECK(refractiveIndex(table, 700.0) == 1.30);
  CHECK(refractiveIndex(IndexTable{{{550, 1.4}}}, 500.0) == 1.4);
}

TEST_CASE("of a mixture of indices every half of the bundles takes each in turn") {
  const IceSettings ice = IndexMixture{{1.30, 1.31, 1.32}};
  for (const std::uint64_t half : {0, 1}) {
    double sum = 0.0;
    for (std::uint64_t bundle = half; bundle < 12; bundle += 2) sum += refractiveIndex(ice, 550.0, bundle);
    CHECK(sum == doctest::Approx(6 * 1.31));
  }
}
