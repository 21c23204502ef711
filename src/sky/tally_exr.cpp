// SPDX-License-Identifier: Apache-2.0
#include "sky/tally_exr.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
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
constexpr const char* kSharedPrefix = "*/";  // no layer's name has a '/'

/// One tally of a file, of which some numbers of each place are stored, in parts whose names begin alike.
template <class AnyTally>
struct Member {
  AnyTally* tally;
  std::string prefix;
  std::vector<int> slots;
};

std::vector<int> allSlots(const Tally& tally) {
  std::vector<int> slots;
  for (int slot = 0; slot < tally.slots(); ++slot) slots.push_back(slot);
  return slots;
}

/// All tallies of a file. A tally of one part has names without prefixes.
template <class AnySkyTally>
auto membersOf(AnySkyTally& sky) {
  using AnyTally = std::remove_reference_t<decltype((sky.parts().front().tally))>;
  std::vector<Member<AnyTally>> members;
  const bool named = sky.symmetries().size() > 1;
  const auto symmetryPrefix = [&](const Tally& tally) {
    return named ? std::string(nameOf(tally.info.symmetry)) + "." : std::string();
  };
  for (auto& part : sky.parts())
    members.push_back(
        {&part.tally, (part.layer.empty() ? "" : part.layer + "/") + symmetryPrefix(part.tally), allSlots(part.tally)});
  for (auto& shared : sky.shared())
    members.push_back({&shared, kSharedPrefix + symmetryPrefix(shared), {Tally::kSquares, Tally::kHits}});
  return members;
}

/// Where the numbers of a part of the file are.
template <class AnyTally>
struct Place {
  AnyTally* tally;
  int slot;
  bool inRings;
};

/// The parts of a tally's file: a picture for each number of a pixel, and a list for each number of a ring.
template <class AnyTally>
void listParts(const std::vector<Member<AnyTally>>& members, std::vector<SumsPart>& parts,
               std::vector<Place<AnyTally>>& places) {
  for (const Member<AnyTally>& member : members)
    for (const bool inRings : {false, true}) {
      if (inRings && !member.tally->rings()) continue;
      for (const int slot : member.slots) {
        const std::string name =
            member.prefix + (inRings ? kRingPrefix : "") + kSlotNames[static_cast<std::size_t>(slot)];
        if (inRings)
          parts.push_back(listPart(name, static_cast<std::size_t>(member.tally->rings()->bins())));
        else
          parts.push_back({name, member.tally->width(), member.tally->height(), member.tally->isBlank()});
        places.push_back({member.tally, slot, inRings});
      }
    }
}

std::int64_t ringSum(const RadialSky& rings, std::size_t bin, int slot) {
  return bin < static_cast<std::size_t>(rings.bins()) ? rings.raw(static_cast<int>(bin), slot) : 0;
}

/// The parts of the file that are wanted, by their places in the file. Throws unless they are all that is there.
std::vector<std::size_t> placesOf(const std::filesystem::path& path, const SumsExr& file,
                                  const std::vector<SumsPart>& wantedParts) {
  std::vector<std::size_t> places;
  for (const SumsPart& wanted : wantedParts) {
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

/// Into a tally that is empty.
void readPixels(SumsExr& file, std::size_t place, int slot, Tally& tally) {
  file.read(place, [&](std::size_t first, std::span<const std::int64_t> values) {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i] != 0) tally.setRaw(static_cast<int>(first + i), slot, values[i]);
  });
}

bool endsWithPart(const SumsPart& part, std::string_view slot) {
  const std::string& name = part.name;
  if (!name.ends_with(slot) || name.ends_with(std::string(kRingPrefix) + std::string(slot))) return false;
  const char before = name.size() > slot.size() ? name[name.size() - slot.size() - 1] : '/';
  return before == '/' || before == '.';
}

/// The info of a file whose header has been checked.
TallyInfo infoOf(const std::filesystem::path& path, const SumsExr& file) {
  TallyInfo info = infoFromText(file.attributes());
  const auto y = std::ranges::find_if(file.parts(), [](const SumsPart& part) { return endsWithPart(part, "Y"); });
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

/// Gives all parts the totals of the first, by what a ray counts for in them.
void shareTotals(SkyTally& sky) {
  const TallyInfo first = sky.info();
  const auto times = [&](TallyInfo& info) {
    const auto share = [&](LightTotal& total, const LightTotal& of) {
      total = LightTotal(of.units() / first.images() * info.images());
    };
    if (first.images() != info.images() && first.intercepted.units() % first.images() != 0)
      throw std::invalid_argument("damaged: its light counts twice, and is an odd number");
    share(info.intercepted, first.intercepted);
    share(info.undeviated, first.undeviated);
    for (std::size_t k = 0; k < 3; ++k) share(info.interceptedXyz[k], first.interceptedXyz[k]);
  };
  for (SkyTally::Part& part : sky.parts()) times(part.tally.info);
  for (SkyTally::Shared& shared : sky.shared()) times(shared.info);
}

}  // namespace

void writeSkyTallyExr(const Output& output, const SkyTally& sky) {
  ExrAttributes attributes = textFromInfo(sky.info());
  attributes["symmetry"] = textFromSymmetries(sky.symmetries());
  for (std::size_t layer = 0; layer + 1 < sky.layers().size(); ++layer)
    attributes[layerKey(layer)] = sky.layers()[layer];
  attributes["kind"] = std::string(nameOf(TallyKind::sky));
  attributes["software"] = "Parhelion " + sky.info().version;
  std::vector<SumsPart> parts;
  std::vector<Place<const Tally>> places;
  listParts(membersOf(sky), parts, places);
  writeSumsExr(output, attributes, parts, [&](std::size_t part, std::size_t first, std::span<std::int64_t> values) {
    const auto& [tally, slot, inRings] = places[part];
    if (inRings)
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = ringSum(*tally->rings(), first + i, slot);
    else
      for (std::size_t i = 0; i < values.size(); ++i) {
        const int pixel = static_cast<int>(first + i);
        values[i] = tally->isBlank(pixel) ? 0 : tally->raw(pixel, slot);
      }
  });
}

void writeTallyExr(const Output& output, const Tally& tally) { writeSkyTallyExr(output, SkyTally(tally)); }

TallyInfo readTallyInfo(const std::filesystem::path& path) {
  const SumsExr file(path);
  return withExrErrors(path, [&] {
    requireTallyKind(path, file, TallyKind::sky);
    return infoOf(path, file);
  });
}

SkyTally readSkyTallyExr(const std::filesystem::path& path) {
  SumsExr file(path);
  return withExrErrors(path, [&] {
    requireTallyKind(path, file, TallyKind::sky);
    requireMemoryFor(path, memoryOf(file));
    const bool grey = std::ranges::none_of(file.parts(), [](const SumsPart& part) { return endsWithPart(part, "X"); });
    SkyTally sky(infoOf(path, file), grey ? 1 : 3, symmetriesFromText(file.attributes()),
                 layersFromText(file.attributes()));
    shareTotals(sky);
    std::vector<SumsPart> parts;
    std::vector<Place<Tally>> places;
    listParts(membersOf(sky), parts, places);
    const std::vector<std::size_t> inFile = placesOf(path, file, parts);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto& [tally, slot, inRings] = places[i];
      if (inRings)
        readRings(file, inFile[i], slot, tally->makeRings(tally->info.toSun()));
      else
        readPixels(file, inFile[i], slot, *tally);
    }
    for (const SkyTally::Part& part : sky.parts()) requirePlausible(part.tally);
    for (const SkyTally::Shared& shared : sky.shared()) requirePlausibleShared(shared);
    return sky;
  });
}

Tally readTallyExr(const std::filesystem::path& path) { return readSkyTallyExr(path).flattened(); }

}  // namespace parhelion
