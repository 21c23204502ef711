// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "csv.h"
#include "picture/auto_exposure.h"
#include "picture/png.h"
#include "picture/tone.h"
#include "recon/compare.h"
#include "recon_methods.h"
#include "recon_scenes.h"
#include "sky/radiance.h"

namespace parhelion::bench {
namespace {

// The part of the whole-sky picture around the sun, pixel by pixel: shrunken noise would look like less.
constexpr int kLeft = 80, kTop = 262, kWidth = 352, kHeight = 240;

Image cropped(const Image& sky, float factor) {
  Image part{kWidth, kHeight, {}};
  for (const Channel& channel : sky.channels) {
    std::vector<float>& samples = part.add(channel.name);
    for (int y = 0; y < kHeight; ++y) {
      const float* row = channel.samples.data() + static_cast<std::size_t>(kTop + y) * sky.width + kLeft;
      for (int x = 0; x < kWidth; ++x) samples[static_cast<std::size_t>(y) * kWidth + x] = factor * row[x];
    }
  }
  return part;
}

/// With the same mean over the whole sky as the reference: so that it is what the error is of.
void writePart(const std::filesystem::path& path, const Image& sky, double energyError, double stops) {
  const float factor = static_cast<float>(1.0 / (1.0 + energyError));
  writePng(path, developPreview(cropped(sky, factor), {stops}), {});
}

}  // namespace

void drawPictures(const Plan& plan) {
  const BenchScene& scene = benchScenes(plan).front();
  const Tally reference = referenceTally(plan, scene);
  const Image truth = plainRadiance(reference);
  const double stops = autoExposure(truth);
  std::filesystem::create_directories(plan.results / "pictures");
  Csv csv(plan.results / "pictures.csv", "Pictures of contact sheets, scene " + scene.name, "rays,file,label,relMSE");
  for (const std::uint64_t rays : plan.rayCounts()) {
    const Tally tally = sceneTally(plan, scene, rays, 1);
    const auto add = [&](const std::string& id, const std::string& label, const Image& sky, const Comparison& error) {
      const std::string name = "pictures/" + std::to_string(rays) + "-" + id + ".png";
      writePart(plan.results / name, sky, error.energyError, stops);
      csv.row(rays, name, label, error.relMse);
    };
    for (const Contender& contender : contenders()) {
      const Image sky = reconstruct(tally, contender.method).image;
      add(contender.id, contender.label, sky, compare(sky, reference));
    }
    add("reference", "reference", truth, {});
  }
}

}  // namespace parhelion::bench
