// SPDX-License-Identifier: Apache-2.0
#include "render/sweep.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <memory>
#include <utility>
#include <vector>

#include "parallel/loops.h"
#include "parallel/run_clock.h"
#include "parallel/threads.h"
#include "picture/exr.h"
#include "render/mixed_sky.h"
#include "render/sky_files.h"
#include "render/traced_sky.h"
#include "view/contact_sheet.h"

namespace parhelion {

namespace {

// Pictures that are held at the same time while previews are made.
constexpr int kMostPictures = 4;
// Files that wait for their names are open, and a process may have 1024.
constexpr std::size_t kMostTogether = 256;

/// A frame that waits to be written.
struct RenderedFrame {
  Image image;
  TallyInfo info;
  double imbalance;  // of its energy, relative
};

/// Renders a frame as render does. None if it was stopped before all its rays were traced.
std::optional<RenderedFrame> renderFrame(const LoadedScene& loaded, const TraceControl& control, LightStore& store) {
  if (loaded.error) {
    MixedSky made;
    if (loaded.scene.trace.engine == Engine::mixed)
      made = mixSky(loaded, {*loaded.error}, control, &store);
    else
      made.sky = withThreads(control.threads, [&] { return integrateSky(loaded, *loaded.error, &store); });
    if (made.report.interrupted) return std::nullopt;
    return RenderedFrame{std::move(made.sky.image), made.sky.info, made.report.energy.imbalance()};
  }
  const TracedSky traced = traceSky(loaded, cloudOf(loaded.scene), control);
  if (traced.report.interrupted) return std::nullopt;
  ReconstructedSky sky = developSky(traced, loaded, control.threads);
  return RenderedFrame{std::move(sky.image), traced.tally.info(), traced.report.energy.imbalance()};
}

/// Writes a frame while the next one is rendered, which is in work for long: files are packed by one thread.
class FrameWriter {
 public:
  FrameWriter(bool beside, std::uint64_t mostBytes) : beside_(beside), room_(mostBytes) {}

  void write(std::shared_ptr<Transaction> run, const SweepFrame& frame, RenderedFrame rendered) {
    finish();
    auto work = [this, run = std::move(run), &frame, rendered = std::move(rendered)]() mutable {
      writeSky(run->at(frame.exr), rendered.image, rendered.info, frame.loaded, frame.gamut);
      run->commit();
      keep(frame.exr, std::move(rendered.image));
    };
    written_ = std::async(beside_ ? std::launch::async : std::launch::deferred, std::move(work));
    if (!beside_) finish();
  }

  /// Waits for the last frame. Throws what writing it has thrown.
  void finish() {
    if (written_.valid()) written_.get();
  }

  /// Of frames that are finished.
  FramePictures takePictures() { return std::move(pictures_); }

 private:
  void keep(const std::filesystem::path& exr, Image image) {
    const std::uint64_t bytes = 3 * sizeof(float) * image.pixels();
    if (bytes > room_) return;
    room_ -= bytes;
    std::erase_if(image.channels, [](const Channel& c) { return c.name != "R" && c.name != "G" && c.name != "B"; });
    pictures_[exr] = std::move(image);
  }

  bool beside_;
  std::uint64_t room_;  // bytes
  FramePictures pictures_;
  std::future<void> written_;
};

/// Hands a finished frame's picture to `take`.
template <class F>
void withPicture(const SweepFrame& frame, const FramePictures* known, const F& take) {
  if (known)
    if (const auto picture = known->find(frame.exr); picture != known->end()) return take(picture->second);
  take(readExr(frame.exr, ExrColours::rec709, {true}).image);
}

/// Median of the exposures that the frames would choose for themselves, of those that have light: a few frames that
/// are nearly dark or flooded do not matter, and no two frames differ.
double medianExposure(std::span<const SweepFrame> frames, const FramePictures* known) {
  std::vector<std::optional<double>> own(frames.size());
  forEach(frames.size(), [&](std::size_t k) {
    withPicture(frames[k], known, [&](const Image& image) {
      const std::vector<float>& green = *image.rgb()[1];
      if (std::any_of(green.begin(), green.end(), [](float g) { return g > 0.0F; }))
        own[k] = ownExposure(image, frames[k].loaded.scene);
    });
  });
  std::vector<double> stops;
  for (const std::optional<double>& exposure : own)
    if (exposure) stops.push_back(*exposure);
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
  int labelWidth = 0;
  for (const SweepFrame& frame : frames) labelWidth = std::max(labelWidth, labelWidthOf(frame.values));
  return layOutSheet(frames.size(), width, height, static_cast<int>(frames.front().values.size()), labelWidth);
}

}  // namespace

SweepReport renderFrames(std::span<const SweepFrame> frames, const SweepControl& control) {
  const RunClock clock;
  SweepReport report;
  LightStore store{BandStore(control.keptLight), control.rings};
  FrameWriter writer(Threads(control.trace.threads).count() > 1, control.keptPictures);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (frames[i].lacks.empty()) continue;
    const RunClock frameClock;
    TraceControl one = control.trace;
    one.timeLimit -= clock.seconds();
    std::optional<RenderedFrame> rendered;
    const auto run = std::make_shared<Transaction>();
    if (!(one.stop && *one.stop) && one.timeLimit > 0.0) {
      run->claim(frames[i].exr);
      rendered = renderFrame(frames[i].loaded, one, store);
    }
    if (!rendered) {
      writer.finish();
      return report;
    }
    report.worstImbalance = std::max(report.worstImbalance, std::abs(rendered->imbalance));
    ++report.rendered;
    writer.write(run, frames[i], std::move(*rendered));
    if (control.onFrame) control.onFrame(i, frameClock.seconds());
  }
  writer.finish();
  report.pictures = writer.takePictures();
  report.complete = true;
  return report;
}

namespace {

/// Writes the previews of some frames, and what a contact sheet has of each. The number of bad pixels.
std::size_t previewSome(std::span<const SweepFrame> frames, const SweepPreviewSettings& settings,
                        const ToneSettings& tone, const SheetLayout& layout, Transaction& together,
                        std::span<SheetCell> cells) {
  for (const SweepFrame& frame : frames) together.claim(frame.png());
  std::atomic<std::size_t> badPixels = 0;
  forEach(frames.size(), [&](std::size_t k) {
    if (settings.stop && *settings.stop) return;
    const SweepFrame& frame = frames[k];
    withPicture(frame, settings.known, [&](const Image& image) {
      const Preview preview = developPreview(image, tone);
      badPixels += preview.badPixels;
      writePreview(together.at(frame.png()), preview, tone.exposureStops, frame.loaded.text);
      if (!settings.contactSheet.empty()) cells[k] = {reducedToFit(image, layout), labelsOf(frame)};
    });
  });
  return badPixels;
}

/// Of all frames, whose units are alike.
ToneSettings toneOf(std::span<const SweepFrame> frames, LightDisplay display, const FramePictures* known) {
  if (!display.exposure && !display.exposureValue) display.exposure = medianExposure(frames, known);
  return toneFor(display, {}, whiteLuminanceOf(readExrAttributes(frames.front().exr)));
}

std::optional<SweepPreviews> writeAllPreviews(std::span<const SweepFrame> frames,
                                              const SweepPreviewSettings& settings) {
  SweepPreviews written;
  const ToneSettings tone = toneOf(frames, settings.display, settings.known);
  written.exposure = tone.exposureStops;
  const SheetLayout layout = layoutOf(frames);
  std::vector<SheetCell> cells(frames.size());
  Transaction together;
  for (std::size_t first = 0; first < frames.size(); first += kMostTogether) {
    if (first > 0) together.commit();
    const std::size_t count = std::min(kMostTogether, frames.size() - first);
    written.badPixels += previewSome(frames.subspan(first, count), settings, tone, layout, together,
                                     std::span(cells).subspan(first, count));
    if (settings.stop && *settings.stop) return std::nullopt;
  }
  if (!settings.contactSheet.empty())
    writePreview(together.at(settings.contactSheet), contactSheet(layout, cells, tone), written.exposure, {});
  together.commit();
  return written;
}

}  // namespace

std::optional<SweepPreviews> writePreviews(std::span<const SweepFrame> frames, const SweepPreviewSettings& settings) {
  const int threads = Threads(settings.threads).count();
  return withThreads(std::min(threads, kMostPictures), [&] { return writeAllPreviews(frames, settings); });
}

}  // namespace parhelion
