// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "memory_taken.h"
#include "picture/icc_profile.h"
#include "picture/transfer.h"
#include "picture_files.h"

namespace parhelion {
namespace {

const cmsCIExyYTRIPLE kRec709{{0.64, 0.33, 1.0}, {0.30, 0.60, 1.0}, {0.15, 0.06, 1.0}};

std::string objection(const std::string& profile, bool grey = false) {
  return profileObjection({reinterpret_cast<const std::uint8_t*>(profile.data()), profile.size()}, grey);
}

/// sRGB's curve as a table of `entries`.
cmsToneCurve* srgbTable(int entries) {
  std::vector<float> table;
  for (int i = 0; i < entries; ++i)
    table.push_back(static_cast<float>(srgbDecode(static_cast<double>(i) / (entries - 1))));
  return cmsBuildTabulatedToneCurveFloat(nullptr, static_cast<cmsUInt32Number>(entries), table.data());
}

std::string greyProfile(cmsToneCurve* curve) {
  const std::string bytes = profileBytes(cmsCreateGrayProfile(cmsD50_xyY(), curve));
  cmsFreeToneCurve(curve);
  return bytes;
}

}  // namespace

TEST_CASE("profiles of sRGB are taken for sRGB however they write its curve") {
  CHECK(objection(profileBytes(cmsCreate_sRGBProfile())).empty());
  CHECK(objection(profileBytes(cmsCreate_sRGBProfile()), true).empty());
  CHECK(objection(rgbProfile(kRec709, srgbTable(1024), "sRGB of 1024")).empty());
  CHECK(objection(rgbProfile(kRec709, srgbTable(64), "sRGB of 64")).empty());
  const std::vector<std::uint8_t> ours = srgbProfile();
  CHECK(objection({ours.begin(), ours.end()}).empty());
  CHECK(srgbProfile() == ours);
}

TEST_CASE("other profiles are named") {
  CHECK(objection(adobeRgbProfile()) == "its colours are in the profile \"Adobe RGB (1998)\", not sRGB");
  const cmsCIExyYTRIPLE p3{{0.680, 0.320, 1.0}, {0.265, 0.690, 1.0}, {0.150, 0.060, 1.0}};
  CHECK(objection(rgbProfile(p3, srgbTable(1024), "Display P3")).find("\"Display P3\"") != std::string::npos);
  CHECK(objection(rgbProfile(kRec709, cmsBuildGamma(nullptr, 1.0), "linear")).find("\"linear\"") != std::string::npos);
  // Little CMS 2.14 leaves a byte that is no ASCII out, 2.16 writes a question mark for it.
  const std::string odd = objection(rgbProfile(kRec709, cmsBuildGamma(nullptr, 1.8), "a \"b\"\n\xff"));
  CHECK((odd.find("\"a b\"") != std::string::npos || odd.find("\"a b?\"") != std::string::npos));
  CHECK(objection(profileBytes(cmsCreateLab4Profile(nullptr))).find("not sRGB") != std::string::npos);
}

TEST_CASE("grey profiles count for grey pictures with the curve of sRGB or a power of 2.2") {
  CHECK(objection(greyProfile(srgbTable(1024)), true).empty());
  CHECK(objection(greyProfile(cmsBuildGamma(nullptr, 2.2)), true).empty());
  CHECK(objection(greyProfile(cmsBuildGamma(nullptr, 1.8)), true).find("not sRGB") != std::string::npos);
  CHECK(objection(greyProfile(cmsBuildGamma(nullptr, 1.0)), true).find("not sRGB") != std::string::npos);
  CHECK(objection(greyProfile(srgbTable(1024)), false).find("not sRGB") != std::string::npos);
}

TEST_CASE("a damaged profile is told as such and never crashes") {
  const std::string damaged = "its colours are in a damaged profile";
  const std::string whole = adobeRgbProfile();
  CHECK(objection("") == damaged);
  CHECK(objection("no profile") == damaged);
  CHECK(objection(whole.substr(0, whole.size() / 2)) != "");
  std::mt19937 random(9);
  for (int i = 0; i < 1000; ++i) {
    std::string bytes = whole;
    for (int k = 0; k <= i % 4; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
    CHECK(objection(bytes.substr(0, i % 3 == 0 ? random() % bytes.size() : bytes.size())).find('\n') ==
          std::string::npos);
  }
}

TEST_CASE("a profile that promises names in a million languages takes little memory") {
  const std::vector<std::uint8_t> sound = srgbProfile();
  std::string profile(sound.begin(), sound.end());
  // ICC.1:2010, 10.13: behind "mluc" and four bytes comes the number of names.
  const std::size_t at = profile.find("mluc");
  REQUIRE(at != std::string::npos);
  profile[at + 8] = 1;
  profile.replace(profile.find("RGB "), 4, "CMYK");  // so that the name is asked for
  CHECK(megabytesOf([&] { objection(profile); }) < 80);
  CHECK(objection(profile).find("not sRGB") != std::string::npos);
}

}  // namespace parhelion
