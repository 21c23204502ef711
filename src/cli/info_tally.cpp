// SPDX-License-Identifier: Apache-2.0
#include "cli/info_tally.h"

#include <cstdint>

#include "cli/commands.h"
#include "cli/say.h"
#include "cli/tally_input.h"
#include "math/checksum.h"
#include "render/measured_tally.h"
#include "scene/describe.h"
#include "scene/parse_scene.h"
#include "sky/tally_exr.h"

namespace parhelion::cli {

namespace {

void printSky(const std::string& path) {
  const SkyTally tally = readSkyTallyExr(path);
  std::int64_t hits = 0;
  for (const SkyTally::Part& part : tally.parts())
    for (int pixel = 0; pixel < tally.pixels(); ++pixel) hits += part.tally.hits(pixel);
  answer("%s: tally of a sky, %d x %d%s", path.c_str(), tally.width(), tally.height(),
         tally.colours() == 1 ? ", luminance only" : "");
  std::string symmetries;
  for (const TallySymmetry one : tally.symmetries())
    symmetries.append(symmetries.empty() ? "" : ", ").append(nameOf(one));
  answer("symmetry: %s", symmetries.c_str());
  if (!tally.layers().empty()) {
    std::string layers;
    for (const std::string& layer : tally.layers()) layers += (layers.empty() ? "" : ", ") + layer;
    answer("layers: %s", layers.c_str());
  }
  answer("intercepted: %.15g", tally.info().interceptedLight());
  answer("undeviated: %.15g", tally.info().undeviated.value());
  answer("hits: %lld", static_cast<long long>(hits));
}

void printMap(const std::string& path) {
  const MapTally tally = readMapTally(path);
  answer("%s: tally of a map, %d x %d bins", path.c_str(), tally.sums.columns(), tally.sums.rows());
}

void printProfile(const std::string& path) {
  const ProfileTally tally = readProfileTally(path);
  answer("%s: tally of a profile, %d bins from %.10g to %.10g degrees", path.c_str(), tally.sums.sums().size(),
         degrees(tally.sums.from()), degrees(tally.sums.to()));
}

/// Reads all of it, so that what is damaged is told as that.
void printSums(const std::string& path, TallyKind kind) {
  switch (kind) {
    case TallyKind::sky:
      return printSky(path);
    case TallyKind::map:
      return printMap(path);
    case TallyKind::profile:
      return printProfile(path);
  }
}

}  // namespace

int infoTally(const std::string& path) {
  const std::vector<TallyFile> file{{path, path}};
  const TallySet set = fittingTallies(file);
  printSums(path, set.kind);
  const TallyOrigin& origin = set.origin;
  answer("rays: %llu (%s)", static_cast<unsigned long long>(origin.rayCount()), wordsFor(origin.rays).c_str());
  if (!set.missing.empty())
    answer("missing: %llu (%s)", static_cast<unsigned long long>(countOf(set.missing)), wordsFor(set.missing).c_str());
  answer("seed: %llu", static_cast<unsigned long long>(origin.seed));
  answer("scene hash: %s, numerics: %d", hexOf(origin.sceneHash).c_str(), origin.numerics);
  answer("traced by: parhelion %s", shortened(origin.version).c_str());
  answer("made from the scene (print it with --scene):");
  answerLines(describeScene(parseScene(origin.scene, path).scene));
  return kDone;
}

}  // namespace parhelion::cli
