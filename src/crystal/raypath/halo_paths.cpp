// SPDX-License-Identifier: Apache-2.0
#include "crystal/raypath/halo_paths.h"

#include <algorithm>
#include <string>

namespace parhelion {

namespace {

constexpr std::string_view kGreenler = "Greenler 1980";
constexpr std::string_view kTape = "Tape 1994";
constexpr std::string_view kTapeMoilanen = "Tape & Moilanen 2006";
constexpr std::string_view kCowley = "Cowley, Atmospheric Optics, Kern arc";
constexpr std::string_view kCowleyBelow = "Cowley, Atmospheric Optics, subhorizon halos";
constexpr std::string_view kGreenlerTraenkle = "Greenler & Traenkle 1984";
constexpr std::string_view kCowleyAntisolar = "Cowley, Atmospheric Optics, antisolar arcs";
constexpr std::string_view kMeteoros = "Arbeitskreis Meteore, Haloarten, EE 57";
constexpr std::string_view kSelmke = "Borchardt & Selmke 2015";

/// What observers say for short, and the other names of a halo, by plainName().
constexpr std::pair<std::string_view, std::string_view> kShortNames[] = {
    {"sundog", "parhelion"},
    {"sun dog", "parhelion"},
    {"mock sun", "parhelion"},
    {"cza", "circumzenithal arc"},
    {"cha", "circumhorizontal arc"},
    {"uta", "upper tangent arc"},
    {"lta", "lower tangent arc"},
    {"paranthelion", "120° parhelion"},
    {"helic arc", "heliac arc"},
    {"anthelic diffuse arc", "diffuse arc"},
    {"greenler's diffuse arc", "diffuse arc"},
    {"parry antisolar arc", "antisolar arc"},
    {"tricker's anthelic arc", "tricker arc"},
    {"wegener's anthelic arc", "wegener arc"},
};

/// One word for what people write in several ways.
std::string plainName(std::string_view name) {
  std::string plain;
  for (const char c : name) plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  for (const auto& [written, meant] : {std::pair<std::string, std::string>{" degrees", "°"},
                                       {" degree", "°"},
                                       {" deg", "°"},
                                       {"-degree", "°"},
                                       {"parhelia", "parhelion"},
                                       {"arcs", "arc"},
                                       {"halos", "halo"},
                                       {"circumhorizon arc", "circumhorizontal arc"}})
    if (const std::size_t at = plain.find(written); at != std::string::npos) plain.replace(at, written.size(), meant);
  // 22 halo
  const std::size_t digits = plain.find_first_not_of("0123456789");
  if (digits != 0 && digits != std::string::npos && plain[digits] == ' ') plain.insert(digits, "°");
  if (plain.ends_with("dogs") || plain.ends_with("suns")) plain.pop_back();
  for (const auto& [said, meant] : kShortNames)
    if (plain == said) return std::string(meant);
  return plain;
}

}  // namespace

std::span<const HaloPath> haloPaths() {
  using enum Stance;
  static const std::vector<HaloPath> table{
      // The 60 degree wedges of prism faces.
      {"22° halo", "3-5", {random}, kGreenler},
      {"parhelion", "3-5 | 3-2-1-5 | 3-1-2-5 | 3-2-1-2-1-5 | 3-1-2-1-2-5", {plate}, kGreenler},
      {"circumscribed halo", "3-5", {column}, kGreenler},
      {"upper tangent arc", "3-5", {column}, kGreenler},
      {"lower tangent arc", "3-5", {column}, kGreenler},
      {"Parry arc", "3-5, symmetry = crystal", {parry}, kTape},
      {"Lowitz arc", "3-5, symmetry = crystal", {lowitz}, kTapeMoilanen},
      // The 90 degree wedges of a prism face and an end.
      {"46° halo", "1-3 | 3-1", {random}, kGreenler},
      {"circumzenithal arc", "1-3", {plate}, kGreenler},
      {"circumhorizontal arc", "3-2", {plate}, kGreenler},
      {"supralateral arc", "3-1", {column}, kTape},
      {"infralateral arc", "1-3", {column}, kTape},
      // Reflections.
      {"parhelic circle", "prism | 1-prism-2 | 1-prism-prism-prism-2", {plate}, kTape},
      {"parhelic circle", "basal | 3-1-6, symmetry = crystal", {column, parry}, kTape},
      {"120° parhelion", "1-3-4-2 | 1-3-5-2", {plate}, kTape},
      {"subsun", "1 | 1-2-1 | 3-2-6 | 3-2-1-2-6", {plate}, kGreenler},
      {"subparhelion", "3-2-5 | 3-1-5 | 3-2-1-2-5 | 3-1-2-1-5", {plate}, kTape},
      {"subparhelic circle",
       "1-2-prism-1 | 1-prism-2-1 | 1-(2-prism-prism-prism | prism-2-prism-prism | prism-prism-2-prism | "
       "prism-prism-prism-2)-1",
       {plate},
       kCowleyBelow},
      {"120° subparhelion", "1-(2-3-4 | 3-2-4 | 3-4-2 | 2-3-5 | 3-2-5 | 3-5-2)-1", {plate}, kCowleyBelow},
      {"subcircumzenithal arc", "1-2-3", {plate}, kCowleyBelow},
      {"sun pillar", "basal | 1-2-1 | 2-1-2 | 3-2-6 | 3-1-6", {plate}, kGreenler},
      {"Wegener arc", "3-1-5", {column}, kTape},
      {"Hastings arc", "3-1-5, symmetry = crystal", {parry}, kTape},
      // Rare ones. Where light inside is turned around by ends, any of the reflections may be the first.
      {"heliac arc", "4 | 5", {parry}, kTape},
      {"subhelic arc", "1-3-(4 | 5)-2 | 3-5-7-4 | 3-6-4-8, symmetry = crystal", {column, parry}, kTape},
      {"Tricker arc",
       "3-(1-5-7 | 5-1-7 | 5-7-1)-4 | 3-(1-6-4 | 6-1-4 | 6-4-1)-8 | 1-(2-3 | 3-2)-(4 | 5)-1 | 1-3-(4 | 5)-2-1, "
       "symmetry = crystal",
       {column, parry},
       kMeteoros},
      {"diffuse arc", "3-(1-5 | 5-1)-7 | 3-(1-5-6-7 | 5-1-6-7 | 5-6-1-7 | 5-6-7-1)-3", {column}, kGreenlerTraenkle},
      {"antisolar arc",
       "4-(1-7 | 7-1)-4 | 5-(1-8 | 8-1)-5 | 3-(1-5 | 5-1)-7 | 7-(1-5 | 5-1)-3 | 6-(1-4 | 4-1)-8 | 8-(1-4 | 4-1)-6 | "
       "1-(2-(4 | 5) | (4 | 5)-2)-1",
       {parry},
       kCowleyAntisolar},
      {"Kern arc", "1-(3 | 3-2-1 | 2-3-1 | 2-1-3)-(4 | 5)", {plate}, kCowley},
      {"Liljequist parhelion",
       "3-(5-6 | 2-1-5-6 | 2-5-1-6 | 2-5-6-1 | 5-2-1-6 | 5-2-6-1 | 5-6-2-1)-7 | "
       "3-(4-5 | 2-1-4-5 | 2-4-1-5 | 2-4-5-1 | 4-2-1-5 | 4-2-5-1 | 4-5-2-1)-7 | "
       "3-(5-6-7 | 2-1-5-6-7 | 2-5-1-6-7 | 2-5-6-1-7 | 2-5-6-7-1 | 5-2-1-6-7 | 5-2-6-1-7 | 5-2-6-7-1 | 5-6-2-1-7 | "
       "5-6-2-7-1 | 5-6-7-2-1)-3",
       {plate},
       kSelmke},
      // Rings of pyramids, by the wedges of their least deviations.
      {"9° halo", "3-16 | 3-26 | 16-3 | 26-3", {random}, kTapeMoilanen},
      {"18° halo", "13-25 | 25-13", {random}, kTapeMoilanen},
      {"20° halo", "13-16 | 23-26", {random}, kTapeMoilanen},
      {"23° halo", "1-23 | 23-1 | 2-13 | 13-2", {random}, kTapeMoilanen},
      {"24° halo", "3-15 | 3-25 | 15-3 | 25-3", {random}, kTapeMoilanen},
      {"35° halo", "13-15 | 23-25", {random}, kTapeMoilanen},
  };
  return table;
}

std::vector<const HaloPath*> halosNamed(std::string_view name) {
  std::vector<const HaloPath*> halos;
  if (name.empty()) return halos;
  const std::string plain = plainName(name);
  for (const HaloPath& halo : haloPaths())
    if (plainName(halo.name) == plain) halos.push_back(&halo);
  return halos;
}

std::vector<std::string_view> haloNames() {
  std::vector<std::string_view> names;
  for (const HaloPath& halo : haloPaths())
    if (std::ranges::find(names, halo.name) == names.end()) names.push_back(halo.name);
  return names;
}

}  // namespace parhelion
