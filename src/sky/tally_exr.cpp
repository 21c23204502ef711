// SPDX-License-Identifier: Apache-2.0
#include "sky/tally_exr.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "picture/exr_stream.h"
#include "picture/limits.h"
#include "sky/sums_exr.h"
#include "sky/tally_checks.h"
#include "sky/tally_info_text.h"
#include "sky/tally_kind.h"

namespace parhelion {
namespace {

constexpr std::array<const char*, 6> kSlotNames = {"Y", "Y.firstHalf", "Y.squares", "hits", "X", "Z"};
constexpr const char* kRingPrefix = "rings.";

/// The parts of a tally's file: a picture for each number of a pixel, and a list for each number of a ring.
std::vector<SumsPart> partsOf(const Tally& tally) {
  std::vector<SumsPart> parts;
  const auto slots = static_cast<std::size_t>(tally.slots());
  for (std::size_t slot = 0; slot < slots; ++slot) parts.push_back({kSlotNames[slot], tally.width(), tally.height()});
  if (!tally.rings()) return parts;
  for (std::size_t slot = 0; slot < slots; ++slot)
    parts.push_back(
        listPart(std::string(kRingPrefix) + kSlotNames[slot], static_cast<std::size_t>(tally.rings()->bins())));
  return parts;
}

std::int64_t ringSum(const RadialSky& rings, std::size_t bin, int slot) {
  return bin < static_cast<std::size_t>(rings.bins()) ? rings.raw(static_cast<int>(bin), slot) : 0;
}

/// The parts of the file that a tally needs, by their places in the file. Throws unless they are all that is there.
std::vector<std::size_t> placesOf(const std::filesystem::path& path, const SumsExr& file, const Tally& tally) {
  std::vector<std::size_t> places;
  for (const SumsPart& wanted : partsOf(tally)) {
    const auto found = std::ranges::find(file.parts(), wanted.name, &SumsPart::name);
    if (found == file.parts().end()) throw exrError(path, "damaged: it has no part " + wanted.name);
    if (found->width != wanted.width || found->height != wanted.height)
      throw exrError(path, "damaged: part " + wanted.name + " is " + std::to_string(found->width) + " x " +
                               std::to_string(found->height) + ", and should be " + std::to_string(wanted.width) +
                               " x " + std::to_string(wanted.height));
    places.push_back(static_cast<std::size_t>(found - file.parts().begin()));
  }
  if (places.size() == file.parts().size()) return places;
  for (std::size_t i = 0; i < file.parts().size(); ++i)
    if (std::ranges::find(places, i) == places.end())
      throw exrError(path, "its part " + file.parts()[i].name + " is none that this version of parhelion knows");
  return places;
}

void readRings(SumsExr& file, std::size_t place, int slot, RadialSky& rings) {
  file.read(place, [&](std::size_t first, std::span<const std::int64_t> values) {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (first + i < static_cast<std::size_t>(rings.bins()))
        rings.setRaw(static_cast<int>(first + i), slot, values[i]);
  });
}

void readPixels(SumsExr& file, std::size_t place, int slot, Tally& tally) {
  file.read(place, [&](std::size_t first, std::span<const std::int64_t> values) {
    for (std::size_t i = 0; i < values.size(); ++i) tally.setRaw(static_cast<int>(first + i), slot, values[i]);
  });
}

/// The info of a file whose header has been checked.
TallyInfo infoOf(const std::filesystem::path& path, const SumsExr& file) {
  TallyInfo info = infoFromText(file.attributes());
  const auto y = std::ranges::find(file.parts(), "Y", &SumsPart::name);
  if (y == file.parts().end()) throw exrError(path, "damaged: it has no part Y");
  info.camera.width = y->width;
  info.camera.height = y->height;
  return info;
}

std::uint64_t memoryOf(const SumsExr& file) {
  std::uint64_t bytes = 0;
  for (const SumsPart& part : file.parts()) bytes += sizeof(std::int64_t) * part.size();
  return bytes;
}

}  // namespace

void writeTallyExr(const Output& output, const Tally& tally) {
  ExrAttributes attributes = textFromInfo(tally.info);
  attributes["kind"] = std::string(nameOf(TallyKind::sky));
  attributes["software"] = "Parhelion " + tally.info.version;
  const auto slots = static_cast<std::size_t>(tally.slots());
  writeSumsExr(
      output, attributes, partsOf(tally), [&](std::size_t part, std::size_t first, std::span<std::int64_t> values) {
        const int slot = static_cast<int>(part % slots);
        for (std::size_t i = 0; i < values.size(); ++i)
          values[i] =
              part < slots ? tally.raw(static_cast<int>(first + i), slot) : ringSum(*tally.rings(), first + i, slot);
      });
}

TallyInfo readTallyInfo(const std::filesystem::path& path) {
  const SumsExr file(path);
  return withExrErrors(path, [&] {
    requireTallyKind(path, file, TallyKind::sky);
    return infoOf(path, file);
  });
}

Tally readTallyExr(const std::filesystem::path& path) {
  SumsExr file(path);
  return withExrErrors(path, [&] {
    requireTallyKind(path, file, TallyKind::sky);
    requireMemoryFor(path, memoryOf(file));
    const bool grey = std::ranges::find(file.parts(), "X", &SumsPart::name) == file.parts().end();
    Tally tally(infoOf(path, file), grey ? 1 : 3);
    RadialSky* rings = tally.rings() ? &tally.makeRings(tally.info.toSun()) : nullptr;
    const std::vector<std::size_t> places = placesOf(path, file, tally);
    for (int slot = 0; slot < tally.slots(); ++slot) {
      readPixels(file, places[static_cast<std::size_t>(slot)], slot, tally);
      if (rings) readRings(file, places[static_cast<std::size_t>(tally.slots() + slot)], slot, *rings);
    }
    requirePlausible(tally);
    return tally;
  });
}

}  // namespace parhelion
