// SPDX-License-Identifier: Apache-2.0
#include "render/tally_sum.h"

#include <algorithm>
#include <utility>

#include "render/measured_tally.h"
#include "scene/traced_keys.h"
#include "sky/tally_exr.h"

namespace parhelion {

namespace {

/// Reads from a file so that errors have its name instead of its path.
template <class Read>
auto readNamed(const TallyFile& file, const Read& read) {
  try {
    return read(file.file);
  } catch (const std::runtime_error& error) {
    const std::string reason = error.what(), path = file.file.string() + ": ";
    if (file.name == file.file.string() || !reason.starts_with(path)) throw;
    throw std::runtime_error(file.name + ": " + reason.substr(path.size()));
  }
}

std::vector<TracedKey> keysOf(const std::string& text, TallyKind kind) {
  const Scene scene = parseScene(text, "").scene;
  const TraceSettings chosen = chosenSettings(cloudByLight(scene), scene.trace);
  return kind == TallyKind::sky ? talliedKeys(scene, chosen) : tracedKeys(scene, chosen);
}

/// ": sun.elevation and population.0.aspect differ"; empty where the scenes cannot be compared.
std::string differingKeys(const std::string& one, const std::string& other, TallyKind kind) {
  constexpr std::size_t kMostNamed = 3;
  std::vector<std::string> names;
  try {
    const std::vector<TracedKey> a = keysOf(one, kind), b = keysOf(other, kind);
    for (const auto& [keys, others] : {std::pair{&a, &b}, std::pair{&b, &a}})
      for (const TracedKey& key : *keys)
        if (std::ranges::find(*others, key) == others->end() && std::ranges::find(names, key.key) == names.end())
          names.push_back(key.key);
  } catch (const std::exception&) {  // of another version of the program, perhaps
    return {};
  }
  if (names.empty()) return {};
  const bool more = names.size() > kMostNamed;
  if (more) names.resize(kMostNamed);
  std::string words = ": " + names.front();
  for (std::size_t i = 1; i < names.size(); ++i) words += (i + 1 == names.size() && !more ? " and " : ", ") + names[i];
  return words + (more ? " and more" : "") + (names.size() == 1 ? " differs" : " differ");
}

/// What of a tally is known by its header.
struct Header {
  TallyKind kind;
  TallyOrigin origin;
  TallyInfo info;  // of a picture's tally
};

Header headerOf(const TallyFile& file) {
  return readNamed(file, [](const std::filesystem::path& path) -> Header {
    const TallyKind kind = tallyKindOf(path);
    if (kind != TallyKind::sky) return {kind, readTallyOrigin(path), {}};
    TallyInfo info = readTallyInfo(path);
    return {kind, info, info};
  });
}

/// Why the sums of two files cannot be added, their rays aside; empty if they can.
std::string objectionTo(const Header& one, const Header& other) {
  if (one.kind != other.kind)
    return "one is the tally of a " + std::string(nameOf(one.kind)) + ", the other of a " +
           std::string(nameOf(other.kind));
  Header a = one, b = other;
  for (TallyOrigin* origin :
       {&a.origin, &b.origin, static_cast<TallyOrigin*>(&a.info), static_cast<TallyOrigin*>(&b.info)})
    origin->rays.clear();
  const bool sameScene = a.origin.sceneHash == b.origin.sceneHash || a.origin.numerics != b.origin.numerics;
  if (!sameScene) return "they are of different scenes" + differingKeys(a.origin.scene, b.origin.scene, a.kind);
  return a.kind == TallyKind::sky ? objectionToAdding(a.info, b.info) : objectionToAdding(a.origin, b.origin);
}

[[noreturn]] void misfit(const TallyFile& a, const TallyFile& b, const std::string& reason) {
  throw TallyMisfit(a.name + " and " + b.name + ": " + reason);
}

/// Throws where two files have a ray in common.
void requireDisjoint(std::span<const TallyFile> files, const std::vector<Header>& headers) {
  std::vector<std::pair<RayRange, std::size_t>> ranges;
  for (std::size_t i = 0; i < headers.size(); ++i)
    for (const RayRange& range : headers[i].origin.rays) ranges.emplace_back(range, i);
  std::ranges::sort(ranges, {}, [](const auto& entry) { return entry.first.first; });
  for (std::size_t i = 1; i < ranges.size(); ++i)
    if (const auto common = commonRays({ranges[i - 1].first}, {ranges[i].first}))
      misfit(files[std::min(ranges[i - 1].second, ranges[i].second)],
             files[std::max(ranges[i - 1].second, ranges[i].second)], wordsFor({*common}) + " are in both");
}

/// What the scene asks for and what is before the last ray, without what is there.
RayRanges missingOf(const TallyOrigin& origin) {
  std::uint64_t end = origin.rays.empty() ? 0 : origin.rays.back().end();
  try {
    end = std::max(end, parseScene(origin.scene, "").scene.trace.rays);
  } catch (const SceneError&) {  // of another version of the program, perhaps
  }
  return end > 0 ? raysWithout({{0, end}}, origin.rays) : RayRanges();
}

/// Adds all files to the first.
template <class Tally, class Read, class Add>
Tally summed(std::span<const TallyFile> files, const Read& read, const Add& add) {
  Tally sum = readNamed(files.front(), read);
  for (const TallyFile& file : files.subspan(1)) {
    const Tally next = readNamed(file, read);
    try {
      add(sum, next);
    } catch (const std::overflow_error&) {
      throw std::runtime_error(file.name +
                               ": together with the files before it a sum does not fit into 64 bits; add up fewer "
                               "rays, and take the mean of the pictures that recon makes of each sum");
    } catch (const std::invalid_argument& error) {  // of what the headers do not show
      throw TallyMisfit(files.front().name + " and " + file.name + ": " + error.what());
    }
  }
  return sum;
}

}  // namespace

TallySet fittingTallies(std::span<const TallyFile> files) {
  std::vector<Header> headers;
  for (const TallyFile& file : files) {
    headers.push_back(headerOf(file));
    const std::string reason = objectionTo(headers.front(), headers.back());
    if (!reason.empty()) misfit(files.front(), file, reason);
  }
  requireDisjoint(files, headers);
  TallySet set{headers.front().kind, headers.front().origin, {}};
  std::vector<RayRange> rays;
  for (const Header& header : headers) rays.insert(rays.end(), header.origin.rays.begin(), header.origin.rays.end());
  set.origin.rays = joined(std::move(rays));
  set.missing = missingOf(set.origin);
  return set;
}

SkyTally sumOfTallies(std::span<const TallyFile> files) {
  SkyTally sum =
      summed<SkyTally>(files, readSkyTallyExr, [](SkyTally& all, const SkyTally& more) { all.addSums(more); });
  if (files.size() > 1) sum.spreadRings();
  return sum;
}

void writeSumOfTallies(const Output& output, std::span<const TallyFile> files, TallyKind kind) {
  const auto add = [](auto& all, const auto& more) { mergeTally(all, more); };
  switch (kind) {
    case TallyKind::sky:
      return writeSkyTallyExr(output, sumOfTallies(files));
    case TallyKind::map:
      return writeTally(output, summed<MapTally>(files, readMapTally, add));
    case TallyKind::profile:
      return writeTally(output, summed<ProfileTally>(files, readProfileTally, add));
  }
}

}  // namespace parhelion
