// SPDX-License-Identifier: Apache-2.0
#include "render/measured_tally.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "math/rotation.h"
#include "picture/exr_stream.h"
#include "picture/limits.h"
#include "render/scene_attributes.h"
#include "scene/traced_keys.h"
#include "sky/sums_exr.h"
#include "sky/tally_info_text.h"
#include "sky/tally_kind.h"
#include "trace/numerics.h"

namespace parhelion {

namespace {

constexpr int kMostBins = 1 << 30;
constexpr const char* kTotalPrefix = "total.";
enum Part : std::size_t { kLight, kSquaresHigh, kSquaresLow, kParts };
constexpr std::array<const char*, kParts> kPartNames{"light", "light.squares.high", "light.squares.low"};

/// What the bins are, as attributes.
ExrAttributes binsText(const MapTally& tally) {
  return {{"map.binsPerHalfTurn", textOfNumber(tally.sums.binsPerHalfTurn())},
          {"sun.elevation", textOfNumber(tally.sunElevation)}};
}
ExrAttributes binsText(const ProfileTally& tally) {
  return {{"profile.bins", textOfNumber(tally.sums.sums().size())},
          {"profile.from", textOfNumber(tally.sums.from())},
          {"profile.to", textOfNumber(tally.sums.to())}};
}

int binsIn(const AttributeReader& attributes, const char* name, int most) {
  const std::uint64_t bins = attributes.whole(name);
  if (bins < 1 || bins > static_cast<std::uint64_t>(most))
    attributes.reject(name, "a whole number from 1 to " + std::to_string(most));
  return static_cast<int>(bins);
}

std::vector<SumsPart> partsFor(std::size_t bins) {
  std::vector<SumsPart> parts;
  for (const char* name : kPartNames) parts.push_back(listPart(name, bins));
  return parts;
}

/// Where the part of a kind of number stands in a file. Throws unless it holds as many bins.
std::size_t placeOf(const std::filesystem::path& path, const SumsExr& file, const SumsPart& wanted) {
  const auto found = std::ranges::find(file.parts(), wanted.name, &SumsPart::name);
  if (found == file.parts().end() || found->width != wanted.width || found->height != wanted.height)
    throw exrError(path, "damaged: part " + wanted.name + " is missing or of another size than its header says");
  return static_cast<std::size_t>(found - file.parts().begin());
}

/// The places of all parts. The memory for the bins is to be had only once the file is known to hold them.
std::vector<std::size_t> placesFor(const std::filesystem::path& path, const SumsExr& file, std::size_t bins) {
  constexpr std::uint64_t kOfBin = sizeof(std::int64_t) + sizeof(SquareTotal);  // bytes
  requireMemoryFor(path, bins * kOfBin);
  std::vector<std::size_t> places;
  for (const SumsPart& wanted : partsFor(bins)) places.push_back(placeOf(path, file, wanted));
  if (file.parts().size() != places.size())
    throw exrError(path, "has parts that this version of parhelion does not know");
  return places;
}

MapTally emptyMap(const AttributeReader& attributes, const auto& requireRoom) {
  constexpr int kMostPerHalfTurn = 23170;  // whose map has kMostBins bins
  const int bins = binsIn(attributes, "map.binsPerHalfTurn", kMostPerHalfTurn);
  requireRoom(2 * static_cast<std::size_t>(bins) * (static_cast<std::size_t>(bins) + 1));
  const double elevation = attributes.number("sun.elevation", -0.5 * kPi, 0.5 * kPi);
  return {originFromText(attributes), elevation, SkyMap(skyDirection(0.0, elevation), bins)};
}
ProfileTally emptyProfile(const AttributeReader& attributes, const auto& requireRoom) {
  const int bins = binsIn(attributes, "profile.bins", kMostBins);
  requireRoom(static_cast<std::size_t>(bins));
  const double to = attributes.number("profile.to", 0.0, kPi);
  const double from = attributes.number("profile.from", 0.0, to);
  if (from == to) attributes.reject("profile.from", "less than profile.to");
  return {originFromText(attributes), ScatterProfile(bins, from, to)};
}

/// A number of a bin. The high half of a sum of squares has its sign, the low half is a bit pattern.
std::int64_t numberOf(const BundleBins& bins, std::size_t part, std::size_t bin) {
  if (bin >= static_cast<std::size_t>(bins.size())) return 0;
  const int i = static_cast<int>(bin);
  if (part == kLight) return bins.sum(i);
  return static_cast<std::int64_t>(part == kSquaresHigh ? bins.squares(i) >> 64 : bins.squares(i));
}

template <class Tally>
void write(const Output& output, const Tally& tally) {
  ExrAttributes attributes = textFromOrigin(tally.origin);
  attributes["software"] = kSoftware;
  attributes["kind"] = std::string(nameOf(kindOf(tally)));
  attributes.merge(binsText(tally));
  for (const auto& [name, units] : tally.sums.totals()) attributes[kTotalPrefix + name] = textOfUnits(units);
  const BundleBins& bins = tally.sums.sums();
  const std::vector<SumsPart> parts = partsFor(static_cast<std::size_t>(bins.size()));
  writeSumsExr(output, attributes, parts, [&](std::size_t part, std::size_t first, std::span<std::int64_t> values) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = numberOf(bins, part, first + i);
  });
}

void readBins(SumsExr& file, const std::vector<std::size_t>& places, BundleBins& bins) {
  const auto read = [&](Part part, const auto& set) {
    file.read(places[part], [&](std::size_t first, std::span<const std::int64_t> values) {
      for (std::size_t i = 0; i < values.size() && first + i < static_cast<std::size_t>(bins.size()); ++i)
        set(static_cast<int>(first + i), values[i]);
    });
  };
  using Units = SquareTotal::Units;
  read(kLight, [&](int bin, std::int64_t x) { bins.set(bin, x, 0); });
  read(kSquaresHigh,
       [&](int bin, std::int64_t x) { bins.set(bin, bins.sum(bin), static_cast<Units>(x) * (Units{1} << 64)); });
  read(kSquaresLow, [&](int bin, std::int64_t x) {
    bins.set(bin, bins.sum(bin), bins.squares(bin) + static_cast<Units>(static_cast<std::uint64_t>(x)));
  });
}

NamedTotals totalsIn(const AttributeReader& attributes, const ExrAttributes& all) {
  NamedTotals totals;
  for (const auto& [name, value] : all) {
    if (!name.starts_with(kTotalPrefix)) continue;
    const ExactSum::Units units = attributes.units(name);
    const bool maybeNegative = name == std::string(kTotalPrefix) + "cosine";
    if (units < 0 && !maybeNegative) attributes.reject(name, "0 or more");
    totals[name.substr(std::string_view(kTotalPrefix).size())] = units;
  }
  return totals;
}

[[noreturn]] void reject(const std::string& what, double found, const std::string& should, double limit) {
  throw std::invalid_argument("damaged, or not of a run: " + what + " is " + textOfNumber(found) + ", and should be " +
                              should + textOfNumber(limit));
}

/// Throws std::invalid_argument where no run can have made the sums.
void requirePlausible(const TallyOrigin& origin, const NamedTotals& totals, const BundleBins& bins) {
  constexpr double kRounding = 1e-9;  // relative; as for tallies (sky/tally_checks.cpp)
  const auto rays = static_cast<double>(origin.rayCount()), bundles = static_cast<double>(totals.at("bundles"));
  const double intercepted = ExactSum(totals.at("intercepted")).value();
  if (bundles > rays) reject("the number of bundles", bundles, "at most that of rays, ", rays);
  if (const auto counted = static_cast<double>(totals.at("rays")); counted != rays)
    reject("the number of rays", counted, "", rays);
  if (rays == 0.0 && intercepted != 0.0) reject("the light that no ray brought", intercepted, "", 0.0);
  double all = 0.0;
  for (int bin = 0; bin < bins.size(); ++bin) {
    const double light = bins.light(bin), squares = SquareTotal(bins.squares(bin)).value();
    const std::string ofBin = " of bin " + std::to_string(bin);
    if (light < 0.0) reject("the light" + ofBin, light, "at least ", 0.0);
    if (squares < 0.0) reject("the sum of squares" + ofBin, squares, "at least ", 0.0);
    // Each bundle's light and its square are rounded by half a unit.
    const double off = 0.5 * bundles / kWeightScale, offSquares = 0.5 * bundles / kSquareScale;
    const double most = std::pow(light + off, 2) * (1.0 + kRounding) + offSquares;
    if (squares > most) reject("the sum of squares" + ofBin, squares, "at most the squared light, ", most);
    const double least =
        std::pow(std::max(0.0, light - off), 2) / std::max(1.0, bundles) * (1.0 - kRounding) - offSquares;
    if (squares < least)
      reject("the sum of squares" + ofBin, squares, "at least the squared light over the bundles, ", least);
    all += light;
  }
  const double mostLight = intercepted * (1.0 + kRounding) + (bundles + rays) * bins.size() / kWeightScale;
  if (all > mostLight)
    reject("the light of all bins", all, "at most what the crystals have intercepted, ", intercepted);
}

template <class Tally, class Empty>
Tally read(const std::filesystem::path& path, TallyKind kind, const Empty& empty) {
  SumsExr file(path);
  return withExrErrors(path, [&] {
    requireTallyKind(path, file, kind);
    const AttributeReader attributes(file.attributes());
    std::vector<std::size_t> places;
    Tally tally = empty(attributes, [&](std::size_t bins) { places = placesFor(path, file, bins); });
    readBins(file, places, tally.sums.sums());
    const NamedTotals totals = totalsIn(attributes, file.attributes());
    try {
      tally.sums.setTotals(totals);
    } catch (const std::out_of_range&) {
      throw exrError(path, "damaged: one of its attributes parhelion:total... is missing");
    }
    requirePlausible(tally.origin, totals, tally.sums.sums());
    return tally;
  });
}

/// What both hold together (sign 1), or the first without the second (sign -1).
NamedTotals combined(NamedTotals totals, const NamedTotals& others, int sign) {
  for (const auto& [name, units] : others) {
    ExactSum sum(totals[name]);
    sign > 0 ? sum.addUnits(units) : sum.subtract(ExactSum(units));
    totals[name] = sum.units();
  }
  return totals;
}

template <class Tally>
std::string objection(const TallyOrigin& origin, const Tally& tally, const Tally& other) {
  if (binsText(tally) != binsText(other)) return "their bins are not the same";
  return objectionToAdding(origin, other.origin);
}

template <class Tally>
void add(Tally& tally, const Tally& other) {
  const std::string reason = objection(tally.origin, tally, other);
  if (!reason.empty()) throw std::invalid_argument("tally: " + reason);
  RayRanges rays = tally.origin.rays;
  rays.insert(rays.end(), other.origin.rays.begin(), other.origin.rays.end());
  rays = joined(std::move(rays));
  const NamedTotals totals = combined(tally.sums.totals(), other.sums.totals(), 1);
  tally.sums.sums().merge(other.sums.sums());
  tally.sums.setTotals(totals);
  tally.origin.rays = std::move(rays);
}

template <class Tally>
void takeOut(Tally& tally, const Tally& other) {
  TallyOrigin rest = tally.origin;
  rest.rays = raysWithout(tally.origin.rays, other.origin.rays);
  std::string reason = objection(rest, tally, other);
  if (reason.empty() && rest.rayCount() + other.origin.rayCount() != tally.origin.rayCount())
    reason = wordsFor(raysWithout(other.origin.rays, tally.origin.rays)) + " are not in it";
  if (!reason.empty()) throw std::invalid_argument("tally: " + reason);
  const NamedTotals totals = combined(tally.sums.totals(), other.sums.totals(), -1);
  tally.sums.sums().subtract(other.sums.sums());
  tally.sums.setTotals(totals);
  tally.origin = std::move(rest);
}

TallyOrigin originOf(const LoadedScene& loaded, const TraceSettings& chosen) {
  TallyOrigin origin;
  origin.sceneHash = hashOf(tracedKeys(loaded.scene, chosen));
  origin.numerics = kNumericsVersion;
  origin.seed = chosen.seed;
  origin.scene = loaded.text;
  origin.version = PARHELION_VERSION;
  return origin;
}

}  // namespace

MapTally emptyMapTally(const LoadedScene& loaded, const Cloud& cloud, int binsPerHalfTurn) {
  return {originOf(loaded, chosenSettings(cloud, loaded.scene.trace)), loaded.scene.sun.elevation,
          SkyMap(cloud.sun().toCentre(), binsPerHalfTurn)};
}

ProfileTally emptyProfileTally(const LoadedScene& loaded, const Cloud& cloud, int bins, double from, double to) {
  return {originOf(loaded, chosenSettings(cloud, loaded.scene.trace)), ScatterProfile(bins, from, to)};
}

void writeTally(const Output& output, const MapTally& tally) { write(output, tally); }
void writeTally(const Output& output, const ProfileTally& tally) { write(output, tally); }

MapTally readMapTally(const std::filesystem::path& path) {
  return read<MapTally>(path, TallyKind::map,
                        [](const auto& attributes, const auto& room) { return emptyMap(attributes, room); });
}
ProfileTally readProfileTally(const std::filesystem::path& path) {
  return read<ProfileTally>(path, TallyKind::profile,
                            [](const auto& attributes, const auto& room) { return emptyProfile(attributes, room); });
}

TallyOrigin readTallyOrigin(const std::filesystem::path& path) {
  const SumsExr file(path);
  return withExrErrors(path, [&] { return originFromText(AttributeReader(file.attributes())); });
}

void mergeTally(MapTally& tally, const MapTally& other) { add(tally, other); }
void mergeTally(ProfileTally& tally, const ProfileTally& other) { add(tally, other); }
void subtractTally(MapTally& tally, const MapTally& other) { takeOut(tally, other); }
void subtractTally(ProfileTally& tally, const ProfileTally& other) { takeOut(tally, other); }

}  // namespace parhelion
