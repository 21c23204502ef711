// SPDX-License-Identifier: Apache-2.0
#include "scene/suggest.h"

#include <doctest/doctest.h>

#include <array>

#include "scene_support.h"

using namespace parhelion;
using namespace parhelion::test;

TEST_CASE("a word that is part of names suggests them all, where none is nearer") {
  const std::vector<std::string_view> names{"fov_diagonal", "fov_horizontal", "roll", "elevation"};
  CHECK(didYouMean("fov", names) == "did you mean 'fov_diagonal' or 'fov_horizontal'?");
  CHECK(didYouMean("horizontal", names) == "did you mean 'fov_horizontal'?");
  CHECK(didYouMean("elev", names) == "did you mean 'elevation'?");
  CHECK(didYouMean("rol", names) == "did you mean 'roll'?");
  // Of two that are as near, the one with an end more or less.
  const std::vector<std::string_view> near{"bits", "bin"};
  CHECK(didYouMean("bins", near) == "did you mean 'bin'?");
  for (const char* far : {"", "v", "fo", "ov_", "izontal", "size"}) CHECK_MESSAGE(didYouMean(far, names).empty(), far);
}

TEST_CASE("edit distance counts insertions, deletions, replacements and swaps of neighbours") {
  CHECK(editDistance("", "abc") == 3);
  CHECK(editDistance("abc", "") == 3);
  CHECK(editDistance("kitten", "sitting") == 3);
  CHECK(editDistance("elevatoin", "elevation") == 1);
  CHECK(editDistance("ab", "ba") == 1);
  CHECK(editDistance("same", "same") == 0);
}

TEST_CASE("the closest name is suggested only where it is within a third of its length") {
  constexpr std::array<std::string_view, 3> kNames{"elevation", "roll", "rays"};
  CHECK(didYouMean("elvaton", kNames) == "did you mean 'elevation'?");
  CHECK(didYouMean("rols", kNames) == "did you mean 'roll'?");
  CHECK(didYouMean("weight", kNames).empty());
  CHECK(didYouMean("", kNames).empty());
}

TEST_CASE("an unknown key is answered with the closest key, the accepted ones and the table it belongs to") {
  CHECK(errorsOf("[sun]\nelevatoin = 1\n[[population]]").at(0).hint ==
        "did you mean 'elevation'? accepted: azimuth, date, diameter, elevation, latitude, longitude, refraction, "
        "spectrum, "
        "visible");
  CHECK(
      errorsOf("[sun]\nrays = 1\n[[population]]").at(0).hint ==
      "it belongs to [trace]; accepted: azimuth, date, diameter, elevation, latitude, longitude, refraction, spectrum, "
      "visible");
  CHECK(errorsOf("elevation = 1\n[[population]]").at(0).hint ==
        "it belongs to [sun] or [camera]; accepted: camera, cloud, ice, layer, layers, observer, population, recon, "
        "sky, sun, "
        "trace");
  CHECK(errorsOf("[camera]\ntilt = 1\n[[population]]")
            .at(0)
            .hint.starts_with("it belongs to [[population]] or [[layer]];"));
  CHECK(errorsOf("[[populations]]\n").at(1).hint.starts_with("did you mean 'population'?"));
}

TEST_CASE("a misspelt name of an enumeration is answered with the closest one") {
  CHECK(errorsOf("[[population]]\norientation = 'plates'").at(0).hint == "did you mean 'plate'?");
  CHECK(errorsOf("[[population]]\n[camera]\nprojection = 'fisheye-equiarea'").at(0).hint ==
        "did you mean 'fisheye-equal-area'?");
  CHECK(errorsOf("[[population]]\norientation = 'plate'\ntilt = { unifrm = 1 }").at(0).hint ==
        "did you mean 'uniform'?");
}

TEST_CASE("an illuminant is recognised in whatever way people write it") {
  const auto hint = [](const std::string& spectrum) {
    return errorsOf("[[population]]\n[sun]\nspectrum = '" + spectrum + "'").at(0).hint;
  };
  for (const char* d65 : {"d65", "illuminant D65", "CIE-D65", "cie d65", "D_D65"})
    CHECK(hint(d65) == "did you mean 'D65'?");
  CHECK(hint("a") == "did you mean 'A'?");
  CHECK(hint("illuminant-a") == "did you mean 'A'?");
  CHECK(hint("equl") == "did you mean 'equal'?");
  CHECK(hint("blackbody") == "a black body is { blackbody = 3000 }, in kelvin");
  CHECK(hint("D60") == "did you mean 'D50'?");
  CHECK(hint("").empty());
}
