// SPDX-License-Identifier: Apache-2.0
#include "render/needs.h"

#include <algorithm>
#include <set>
#include <thread>
#include <utility>
#include <variant>

#include "beam/scatter_integral.h"
#include "crystal/symmetry.h"
#include "math/overloaded.h"
#include "sky/radial_sky.h"

namespace parhelion {

namespace {

std::uint64_t workers(int threads) {
  const int processors = static_cast<int>(std::thread::hardware_concurrency());
  return static_cast<std::uint64_t>(threads > 0 ? std::min(threads, 4 * processors) : processors);
}

// A worker's waves, and what its allocator keeps.
std::uint64_t memoryOfWorkers(int threads) { return 1'500'000 * workers(threads); }

std::uint64_t mapBins(int binsPerHalfTurn) {
  return 2 * static_cast<std::uint64_t>(binsPerHalfTurn) * static_cast<std::uint64_t>(binsPerHalfTurn + 1);
}

/// A pixel, of one tally.
std::uint64_t bytesOfTally(const SkySize& size) { return size.colours ? 66 : 34; }

/// Of all tallies' rings about the sun, once.
std::uint64_t bytesOfRings(const SkySize& size) {
  return static_cast<std::uint64_t>(size.radialTallies) * static_cast<std::uint64_t>(size.rings) * sizeof(SumLine);
}

/// Of a picture in colours, at the peak of its reconstruction.
std::uint64_t bytesPerPixel(const ReconSettings& settings) {
  return std::visit(Overloaded{
                        [](const NoSettings&) { return 80; },
                        [](const GaussianSettings&) { return 150; },
                        [](const GlassnerSettings&) { return 180; },
                        [](const MarvastiSettings&) { return 200; },
                        [](const VoronoiSettings&) { return 230; },
                        [](const ActSettings&) { return 175; },
                        [](const GonzatoMarchandSettings&) { return 205; },
                        [](const AdaptiveSettings&) { return 235; },
                    },
                    settings);
}

}  // namespace

SkySize skySizeOf(const Scene& scene) {
  const auto* lines = std::get_if<LineSpectrum>(&scene.sun.spectrum);
  const bool single =
      std::holds_alternative<MonochromaticSpectrum>(scene.sun.spectrum) || (lines && lines->wavelengths.size() == 1);
  std::set<std::pair<bool, bool>> symmetries;  // random, or else mirrored
  for (const PopulationSettings& population : scene.populations)
    symmetries.emplace(isFullyRandom(population), !isFullyRandom(population) && isMirrorSymmetric(population));
  const bool isMixed = scene.trace.symmetry == Symmetry::automatic;
  const bool isRadial = isMixed ? symmetries.contains({true, false}) : scene.trace.symmetry == Symmetry::radial;
  const int parts = isMixed ? static_cast<int>(symmetries.size()) : 1;
  const int named = static_cast<int>(scene.trace.paths.layers.size()), perPart = named > 0 ? named + 2 : 1;
  SkySize size{std::int64_t{scene.camera.width} * scene.camera.height, !single, perPart * parts,
               named > 0 ? named + 1 : 0};
  if (scene.cloud && scene.cloud->orders > 1) size.tallies += perPart;
  if (isRadial) {
    TallyInfo info;
    info.camera = scene.camera;
    size.radialTallies = perPart;
    size.rings = RadialSky(info, Vec3(1.0, 0.0, 0.0)).bins();
  }
  return size;
}

SkySize skySizeOf(const SkyTally& tally) {
  SkySize size{tally.pixels(), tally.colours() == 3, static_cast<int>(tally.parts().size() + tally.shared().size()),
               static_cast<int>(tally.layers().size())};
  const auto count = [&](const Tally& one) {
    if (!one.rings()) return;
    ++size.radialTallies;
    size.rings = one.rings()->bins();
  };
  for (const SkyTally::Part& part : tally.parts()) count(part.tally);
  for (const SkyTally::Shared& shared : tally.shared()) count(shared);
  return size;
}

std::uint64_t memoryToTrace(const SkySize& size, int threads) {
  // Each thread has rings of its own, and in the end the layers' are made densities at once.
  return static_cast<std::uint64_t>(size.pixels) * bytesOfTally(size) * static_cast<std::uint64_t>(size.tallies) +
         bytesOfRings(size) * (workers(threads) + 2) + memoryOfWorkers(threads);
}

std::uint64_t memoryToReconstruct(const SkySize& size, const ReconSettings& settings, int threads) {
  const std::uint64_t colours = static_cast<std::uint64_t>(size.pixels) * bytesPerPixel(settings);
  // Parts are reconstructed one after the other; their pictures are added, by layers.
  const std::uint64_t more = bytesOfTally(size) * static_cast<std::uint64_t>(size.tallies - 1) +
                             (size.tallies > 1 ? 20 : 0) + 12 * static_cast<std::uint64_t>(size.layers);
  return (size.colours ? colours : colours / 100 * 64) + static_cast<std::uint64_t>(size.pixels) * more +
         bytesOfRings(size) + memoryOfWorkers(threads);
}

std::uint64_t memoryToRender(const SkySize& size, const ReconSettings& settings, int threads) {
  return std::max(memoryToTrace(size, threads), memoryToReconstruct(size, settings, threads));
}

std::uint64_t memoryToMap(int binsPerHalfTurn, int threads) {
  return mapBins(binsPerHalfTurn) * (48 + 24 * workers(threads)) + memoryOfWorkers(threads);
}

std::uint64_t memoryToProfile(int bins, int threads) {
  return static_cast<std::uint64_t>(bins) * 125 + memoryOfWorkers(threads);
}

std::uint64_t memoryToIntegrate(int bins, int threads) {
  // Three tables of bins for each of the patches that are made at a time, and a few more.
  return static_cast<std::uint64_t>(bins) * (kPatchesAtATime * 3 + 8) * sizeof(double) + memoryOfWorkers(threads);
}

std::uint64_t memoryToIntegrate(const SkySize& size) {
  // Films of groups of sheets with four numbers a pixel, a population's light and that of all, tables and the image.
  constexpr std::uint64_t kIntegralBytes = 8 * 32 + 24 + 16 + 80 + 60, kLayerBytes = 36, kTables = 200'000'000;
  return static_cast<std::uint64_t>(size.pixels) *
             (kIntegralBytes + static_cast<std::uint64_t>(size.layers) * kLayerBytes) +
         kTables;
}

std::uint64_t memoryToComposite(std::uint64_t pixels, std::uint64_t halo) {
  // The halo is made when the mask, a byte a pixel, is there, and long before the picture is written.
  return std::max(pixels * kCompositeBytes, pixels + halo);
}

std::uint64_t leastBytesOfPicture(const SkySize& size, const ReconSettings& settings) {
  // What is filtered has no two pixels alike: the three colours, or a grey, and one or two errors of them.
  const std::uint64_t bytes = std::holds_alternative<NoSettings>(settings) ? 1 : size.colours ? 12 : 6;
  return static_cast<std::uint64_t>(size.pixels) * bytes;
}

std::uint64_t leastBytesOfTally(const SkySize& size) { return static_cast<std::uint64_t>(size.pixels); }

std::uint64_t leastBytesOfMap(int binsPerHalfTurn, bool asText) { return mapBins(binsPerHalfTurn) * (asText ? 16 : 1); }

}  // namespace parhelion
