// SPDX-License-Identifier: Apache-2.0
#include "render/sweep.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "parallel/run_clock.h"
#include "parallel/threads.h"
#include "picture/auto_exposure.h"
#include "picture/exr.h"
#include "render/mixed_sky.h"
#include "render/sky_files.h"
#include "render/traced_sky.h"
#include "view/contact_sheet.h"

namespace parhelion {

namespace {

// Files that wait for their names are open, and a process may have 1024.
constexpr std::size_t kMostTogether = 256;

/// Renders a frame as render does, and tells how far its energy is open, relative. None, and nothing is written, if it
/// was stopped before all its rays were traced.
std::optional<double> renderFrame(const SweepFrame& frame, const TraceControl& control, LightStore& store) {
  Transaction run;
  run.claim(frame.exr);
  const LoadedScene& loaded = frame.loaded;
  const Engine engine = loaded.scene.trace.engine;
  const auto write = [&](Image& image, const TallyInfo& info) {
    writeSky(run.at(frame.exr), image, info, loaded, frame.gamut);
    run.commit();
  };
  if (loaded.error) {
    MixedSky made;
    if (engine == Engine::mixed)
      made = mixSky(loaded, {*loaded.error}, control, &store);
    else
      made.sky = withThreads(control.threads, [&] { return integrateSky(loaded, *loaded.error, &store); });
    if (made.report.interrupted) return std::nullopt;
    write(made.sky.image, made.sky.info);
    return made.report.energy.imbalance();
  }
  const TracedSky traced = traceSky(loaded, cloudOf(loaded.scene), control);
  if (traced.report.interrupted) return std::nullopt;
  ReconstructedSky sky = developSky(traced, loaded, control.threads);
  write(sky.image, traced.tally.info());
  return traced.report.energy.imbalance();
}

/// Median of the exposures that the frames would choose for themselves, of those that have light: a few frames that
/// are nearly dark or flooded do not matter, and no two frames differ.
double medianExposure(std::span<const SweepFrame> frames) {
  std::vector<double> stops;
  for (const SweepFrame& frame : frames) {
    const Image image = readExr(frame.exr, ExrColours::rec709, {true}).image;
    const std::vector<float>& green = *image.rgb()[1];
    if (std::any_of(green.begin(), green.end(), [](float g) { return g > 0.0F; })) stops.push_back(autoExposure(image));
  }
  if (stops.empty()) return 0.0;
  std::sort(stops.begin(), stops.end());
  return 0.5 * (stops[(stops.size() - 1) / 2] + stops[stops.size() / 2]);
}

std::vector<std::string> labelsOf(const SweepFrame& frame) {
  std::vector<std::string> labels = frame.values;
  for (std::string& label : labels) label[label.find('=')] = ' ';
  return labels;
}

SheetLayout layoutOf(std::span<const SweepFrame> frames) {
  int width = 1, height = 1;
  for (const SweepFrame& frame : frames) {
    width = std::max(width, frame.loaded.scene.camera.width);
    height = std::max(height, frame.loaded.scene.camera.height);
  }
  return layOutSheet(frames.size(), width, height, static_cast<int>(frames.front().values.size()));
}

}  // namespace

SweepReport renderFrames(std::span<const SweepFrame> frames, const SweepControl& control) {
  const RunClock clock;
  SweepReport report;
  LightStore store{BandStore(control.keptLight), {}};
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (frames[i].lacks.empty()) continue;
    const RunClock frameClock;
    TraceControl one = control.trace;
    one.timeLimit -= clock.seconds();
    if ((one.stop && *one.stop) || one.timeLimit <= 0.0) return report;
    const std::optional<double> imbalance = renderFrame(frames[i], one, store);
    if (!imbalance) return report;
    report.worstImbalance = std::max(report.worstImbalance, std::abs(*imbalance));
    ++report.rendered;
    if (control.onFrame) control.onFrame(i, frameClock.seconds());
  }
  report.complete = true;
  return report;
}

std::optional<SweepPreviews> writePreviews(std::span<const SweepFrame> frames, const SweepPreviewSettings& settings) {
  SweepPreviews written;
  written.exposure = settings.exposure ? *settings.exposure : medianExposure(frames);
  const SheetLayout layout = layoutOf(frames);
  std::vector<SheetCell> cells;
  Transaction together;
  std::size_t waiting = 0;
  for (const SweepFrame& frame : frames) {
    if (settings.stop && *settings.stop) return std::nullopt;
    const Image image = readExr(frame.exr, ExrColours::rec709, {true}).image;
    const Preview preview = developPreview(image, {written.exposure});
    written.badPixels += preview.badPixels;
    if (waiting == kMostTogether) together.commit();
    waiting = waiting % kMostTogether + 1;
    together.claim(frame.png());
    writePreview(together.at(frame.png()), preview, written.exposure, frame.loaded.text);
    if (!settings.contactSheet.empty()) cells.push_back({reducedToFit(image, layout), labelsOf(frame)});
  }
  if (!cells.empty())
    writePreview(together.at(settings.contactSheet), contactSheet(layout, cells, written.exposure), written.exposure,
                 {});
  together.commit();
  return written;
}

}  // namespace parhelion
