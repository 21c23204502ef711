// SPDX-License-Identifier: Apache-2.0
#include "sky/tally_info_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "math/checksum.h"
#include "math/names.h"
#include "sky/camera_text.h"

namespace parhelion {
namespace {

constexpr std::array<std::string_view, 3> kXyzKeys{"intercepted.X", "intercepted.Y", "intercepted.Z"};
constexpr std::array<std::string_view, 3> kWhiteKeys{"white.X", "white.Y", "white.Z"};

std::string rangesText(const RayRanges& ranges) {
  std::string list;
  for (const RayRange& r : ranges) {
    if (!list.empty()) list += ' ';
    list += textOfNumber(r.first);
    list += '+';
    list += textOfNumber(r.count);
  }
  return list;
}

/// "first+count" off the front of a list; none where that is not what comes next.
std::optional<RayRange> takeRange(std::string_view& list) {
  RayRange range;
  const char* const end = list.data() + list.size();
  const auto first = std::from_chars(list.data(), end, range.first);
  if (first.ec != std::errc{} || first.ptr == end || *first.ptr != '+') return {};
  const auto count = std::from_chars(first.ptr + 1, end, range.count);
  if (count.ec != std::errc{} || (count.ptr != end && *count.ptr != ' ')) return {};
  list.remove_prefix(static_cast<std::size_t>(count.ptr - list.data()) + (count.ptr != end ? 1 : 0));
  return range;
}

RayRanges rangesIn(const AttributeReader& attributes) {
  const auto reject = [&attributes] {
    attributes.reject("rays", "ranges first+count of ray numbers below 2^64, in ascending order and without overlap");
  };
  std::string_view list = attributes.text("rays");
  if (list.ends_with(' ')) reject();
  RayRanges ranges;
  while (!list.empty()) {
    const std::optional<RayRange> range = takeRange(list);
    const std::uint64_t room = range ? std::numeric_limits<std::uint64_t>::max() - range->first : 0;
    if (!range || range->count == 0 || range->count > room || (!ranges.empty() && range->first < ranges.back().end()))
      reject();
    ranges.push_back(*range);
  }
  return joined(std::move(ranges));
}

LightTotal totalIn(const AttributeReader& attributes, std::string_view name) {
  const LightTotal total(attributes.units(name));
  if (total.units() < 0) attributes.reject(name, "light, which is never negative");
  return total;
}

}  // namespace

ExrAttributes textFromOrigin(const TallyOrigin& origin) {
  return {{"version", origin.version},
          {"scene", origin.scene},
          {"scene.hash", hexOf(origin.sceneHash)},
          {"numerics", textOfNumber(origin.numerics)},
          {"seed", textOfNumber(origin.seed)},
          {"rays", rangesText(origin.rays)}};
}

TallyOrigin originFromText(const AttributeReader& attributes) {
  TallyOrigin origin;
  origin.version = attributes.text("version");
  origin.scene = attributes.text("scene");
  origin.sceneHash = attributes.hash("scene.hash");
  const std::uint64_t numerics = attributes.whole("numerics");
  if (numerics > std::numeric_limits<int>::max()) attributes.reject("numerics", "the version of a tracer");
  origin.numerics = static_cast<int>(numerics);
  origin.seed = attributes.whole("seed");
  origin.rays = rangesIn(attributes);
  return origin;
}

ExrAttributes textFromInfo(const TallyInfo& info) {
  ExrAttributes plain = textFromOrigin(info);
  plain["symmetry"] = std::string(nameOf(info.symmetry));
  plain["intercepted"] = textOfUnits(info.intercepted.units());
  plain["undeviated"] = textOfUnits(info.undeviated.units());
  for (int k = 0; k < 3; ++k) {
    plain[std::string(kXyzKeys[k])] = textOfUnits(info.interceptedXyz[k].units());
    plain[std::string(kWhiteKeys[k])] = textOfNumber(info.white[k]);
  }
  plain["sun.elevation"] = textOfNumber(info.sunElevation);
  plain["sun.diameter"] = textOfNumber(info.sunDiameter);
  plain.merge(textFromCamera(info.camera));
  return plain;
}

std::string textFromSymmetries(const std::vector<TallySymmetry>& symmetries) {
  std::string text;
  for (const TallySymmetry symmetry : symmetries) text.append(text.empty() ? "" : " ").append(nameOf(symmetry));
  return text;
}

std::vector<TallySymmetry> symmetriesFromText(const ExrAttributes& attributes) {
  const AttributeReader reader(attributes);
  const auto reject = [&reader] {
    reader.reject("symmetry", "none, mirror or radial, or several of them in this order");
  };
  if (!reader.has("symmetry")) reject();
  std::string_view text = reader.text("symmetry");
  std::vector<TallySymmetry> symmetries;
  while (true) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const auto symmetry = memberNamed<TallySymmetry>(text.substr(0, end));
    if (!symmetry || (!symmetries.empty() && symmetries.back() >= *symmetry)) reject();
    symmetries.push_back(*symmetry);
    if (end == text.size()) return symmetries;
    text.remove_prefix(end + 1);
  }
}

std::vector<std::string> layersFromText(const ExrAttributes& attributes) {
  const AttributeReader reader(attributes);
  std::vector<std::string> layers;
  for (std::size_t i = 0; reader.has(layerKey(i)); ++i) layers.emplace_back(reader.text(layerKey(i)));
  return layers;
}

std::string layerKey(std::size_t layer) { return "layer." + std::to_string(layer); }

TallyInfo infoFromText(const ExrAttributes& attributes) {
  constexpr double kBrightestWhite = 1e6;  // X or Z over Y; beyond those of all single wavelengths
  const AttributeReader reader(attributes);
  TallyInfo info;
  static_cast<TallyOrigin&>(info) = originFromText(reader);
  info.symmetry = symmetriesFromText(attributes).front();
  info.intercepted = totalIn(reader, "intercepted");
  info.undeviated = totalIn(reader, "undeviated");
  for (int k = 0; k < 3; ++k) {
    info.interceptedXyz[k] = totalIn(reader, kXyzKeys[k]);
    info.white[k] = reader.number(kWhiteKeys[k], 0.0, kBrightestWhite);
  }
  info.sunElevation = reader.number("sun.elevation", -0.5 * kPi, 0.5 * kPi);
  info.sunDiameter = reader.number("sun.diameter", 0.0, kPi);
  readCamera(reader, info.camera);
  return info;
}

}  // namespace parhelion
