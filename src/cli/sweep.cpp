// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "cli/commands.h"
#include "cli/integral_run.h"
#include "cli/long_run_options.h"
#include "cli/number_options.h"
#include "cli/outputs.h"
#include "cli/picture.h"
#include "cli/run_options.h"
#include "cli/say.h"
#include "cli/trace_watch.h"
#include "picture/memory_limit.h"
#include "render/integrated_sky.h"
#include "render/mixed_sky.h"
#include "render/needs.h"
#include "render/sky_files.h"
#include "render/sweep.h"
#include "render/table_cache.h"
#include "scene/key_range.h"
#include "view/contact_sheet.h"

namespace parhelion::cli {

namespace {

struct SweepOptions {
  RunOptions run;
  std::vector<std::string> keys;
  std::string output, contactSheet, gamut, error;
  DisplayWords display;
  std::size_t first = 0;
  bool product = false;
};

/// The sun stands at an elevation or where it stood at a date: of these keys the later one would displace the other.
bool placesSun(const std::string& key) { return key == "sun.elevation" || key == "sun.date"; }

/// Throws std::invalid_argument for a key that is no single number or has a value for all frames, too.
void requireSweepable(const std::string& key, const RunOptions& run) {
  for (const char* list : {"camera.resolution", "camera.distortion"})
    if (key == list)
      throw std::invalid_argument(key + " is no single number; a sweep changes single numbers, for one " + key + ".0");
  // What these options say would win over every frame's own value.
  bool fixed = (key == "trace.rays" && !run.rays.empty()) || (key == "trace.seed" && !run.seed.empty()) ||
               (key.starts_with("camera.resolution.") && !run.resolution.empty());
  for (const std::string& said : run.overrides) {
    const std::string before = said.substr(0, said.find('=')),
                      other = before.substr(0, before.find_last_not_of(' ') + 1);
    fixed = fixed || other == key || (placesSun(other) && placesSun(key));
  }
  if (fixed) throw std::invalid_argument(key + " is swept: it cannot have one value for all frames, too");
}

std::vector<std::vector<std::string>> valuesOf(const SweepOptions& options) {
  try {
    std::vector<KeyRange> ranges;
    for (const std::string& key : options.keys) ranges.push_back(parseKeyRange(key));
    for (const KeyRange& range : ranges) requireSweepable(range.key, options.run);
    std::vector<std::vector<std::string>> frames = sweepFrames(ranges, options.product);
    if (std::count_if(ranges.begin(), ranges.end(), [](const KeyRange& range) { return placesSun(range.key); }) > 1)
      throw std::invalid_argument("the sun is placed twice, by sun.elevation and by sun.date");
    return frames;
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("sweep", error.what());
  }
}

FrameNames frameNamesOf(const std::string& pattern) {
  try {
    return FrameNames(pattern);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("-o", error.what());
  }
}

/// Bytes that a frame takes.
std::uint64_t memoryOf(const SweepFrame& frame, int threads) {
  const Scene& scene = frame.loaded.scene;
  const SkySize size = skySizeOf(scene);
  std::uint64_t bytes = memoryToRender(size, scene.recon, threads);
  if (isIntegrated(scene)) bytes += memoryToIntegrate(size) + memoryOfOrientations(scene, *frame.loaded.error);
  // The picture of the frame before it is being written.
  constexpr std::uint64_t kPictureBytes = 20, kLayerBytes = 12;
  return bytes + static_cast<std::uint64_t>(size.pixels) *
                     (kPictureBytes + kLayerBytes * static_cast<std::uint64_t>(size.layers));
}

/// Bytes that no frame takes.
std::uint64_t memoryLeft(const std::vector<SweepFrame>& frames, int threads) {
  std::uint64_t most = 0;
  for (const SweepFrame& frame : frames) most = std::max(most, memoryOf(frame, threads));
  const std::uint64_t room = memoryLimit().bytes;
  return room - std::min(room, most);
}

/// Of these, what light may take that integrated frames leave to the next, and finished frames that wait for previews.
std::uint64_t keptLight(std::uint64_t left) { return std::min<std::uint64_t>(4'000'000'000, left / 2); }
std::uint64_t keptPictures(std::uint64_t left) { return std::min<std::uint64_t>(1'000'000'000, left / 8); }

/// Throws before anything is rendered if something cannot be written.
void requireOutputsOf(const SweepOptions& options, const std::vector<SweepFrame>& frames) {
  if (!options.contactSheet.empty() && frames.size() > kMaxSheetPictures)
    throw CLI::ValidationError("--contact-sheet", "a sheet holds at most " + std::to_string(kMaxSheetPictures) +
                                                      " frames, not " + std::to_string(frames.size()));
  Files files{{options.run.scene}, {options.contactSheet}};
  for (const SweepFrame& frame : frames) {
    requireUnit(options.display.settings(), frame.loaded.scene);
    files.outputs.push_back(frame.exr);
    files.outputs.push_back(frame.png());
    const SkySize size = skySizeOf(frame.loaded.scene);
    if (!frame.lacks.empty()) files.leastBytes[frame.exr] = leastBytesOfPicture(size, frame.loaded.scene.recon);
    const Scene& scene = frame.loaded.scene;
    requireMemory(frame.exr.string(), memoryOf(frame, options.run.threads));
    if (isIntegrated(scene))
      requireIntegrable(scene);
    else if (!options.error.empty())
      throw Unfit("--error: it is for light that is integrated; rays take trace.rays");
  }
  requireOutputs(files, options.run.overwrite);
}

/// Says how much there is to do and, for the first frame, why.
void reportPlan(const std::vector<SweepFrame>& frames) {
  const auto isLacking = [](const SweepFrame& frame) { return !frame.lacks.empty(); };
  const auto lacking = static_cast<std::size_t>(std::count_if(frames.begin(), frames.end(), isLacking));
  const auto firstLacking = std::find_if(frames.begin(), frames.end(), isLacking);
  std::string reason;
  if (firstLacking != frames.end()) reason = " (" + firstLacking->exr.string() + ": " + firstLacking->lacks + ")";
  say("%zu frames: %zu skipped, %zu to render%s", frames.size(), frames.size() - lacking, lacking, reason.c_str());
}

/// Says how many frames have no halo, and why the first of them has none.
void reportUnlit(const std::vector<SweepFrame>& frames) {
  std::size_t count = 0;
  std::string reason;
  for (const SweepFrame& frame : frames)
    if (const std::string why = whyUnlit(frame.loaded.scene); !why.empty() && count++ == 0) reason = why;
  if (count > 0) say("%zu of %zu frames have no halo: %s", count, frames.size(), reason.c_str());
}

void reportFrame(const RunOptions& run, const SweepFrame& frame, std::size_t number, std::size_t count,
                 double seconds) {
  if (run.quiet) return;
  if (run.progress == "json")
    say("{\"frame\": %zu, \"of\": %zu, \"seconds\": %.3f}", number, count, seconds);
  else
    say("frame %zu of %zu: %s, %.1f s", number, count, frame.valuesText().c_str(), seconds);
}

/// Renders what is lacking. None if a signal or the time limit, which is for the whole sweep, came first.
std::optional<FramePictures> renderLacking(const RunOptions& run, const std::vector<SweepFrame>& frames,
                                           const StopSignal& stop) {
  const std::uint64_t left = memoryLeft(frames, run.threads);
  SweepControl control{
      traceControl(run, &stop), {}, keptLight(left), ringStoreWith(tableCacheOfUser()), keptPictures(left)};
  control.onFrame = [&](std::size_t frame, double seconds) {
    reportFrame(run, frames[frame], frame + 1, frames.size(), seconds);
  };
  SweepReport report = renderFrames(frames, control);
  if (report.complete && report.rendered > 0 && !run.quiet)
    say("energy: open by at most %.1e in any frame", report.worstImbalance);
  if (!report.complete || stop.requested()) return std::nullopt;
  return std::move(report.pictures);
}

/// The previews of all frames and their contact sheet, if one is asked for. False if a signal came.
bool makePreviews(const SweepOptions& options, const std::vector<SweepFrame>& frames, const FramePictures& pictures,
                  const StopSignal& stop) {
  const auto written = writePreviews(
      frames, {options.display.settings(), options.contactSheet, &stop.requested(), options.run.threads, &pictures});
  if (!written || options.run.quiet) return written.has_value();
  say("previews of %zu frames at exposure %s%s", frames.size(), exposureText(written->exposure).c_str(),
      options.display.exposure || options.display.exposureValue ? "" : ", the median of what the frames would choose");
  if (written->badPixels > 0) say("%zu pixels are not finite and black in the previews", written->badPixels);
  return true;
}

/// Says what lies there now.
void reportWritten(const SweepOptions& options, const std::vector<SweepFrame>& frames) {
  const std::size_t count = frames.size();
  std::string text = "wrote " + std::to_string(count) + (count == 1 ? " frame, " : " frames, ");
  text += frames.front().exr.string();
  if (count > 1) text += " to " + frames.back().exr.string();
  if (!options.contactSheet.empty()) text += ", and " + options.contactSheet;
  say("%s", text.c_str());
}

int runSweep(const SweepOptions& options, const CLI::App& command) {
  const FrameNames names = frameNamesOf(options.output);
  const std::vector<std::vector<std::string>> values = valuesOf(options);
  const FrameLoader load = [&](const std::vector<std::string>& own) {
    LoadedScene loaded = options.run.load(own);
    if (asksForErrorAlone(command)) loaded.scene.trace.engine = integratingEngine(loaded.scene);
    if (isIntegrated(loaded.scene)) loaded.error = integralGoal(options.error);
    return loaded;
  };
  const std::vector<SweepFrame> frames =
      planFrames(values, load, names, options.first, gamutOf(options.gamut), options.run.overwrite);
  requireOutputsOf(options, frames);
  if (!options.run.quiet) reportPlan(frames);
  if (!options.run.quiet) reportUnlit(frames);
  const StopSignal stop;
  const std::optional<FramePictures> pictures = renderLacking(options.run, frames, stop);
  if (pictures && makePreviews(options, frames, *pictures, stop)) {
    if (!options.run.quiet) reportWritten(options, frames);
    return kDone;
  }
  say("interrupted: finished frames stay, the same command goes on from them");
  return kInterrupted;
}

void addOptions(CLI::App& command, SweepOptions& options) {
  options.run.addTo(command, true);
  options.run.mayIntegrate = true;
  command.remove_option(command.get_option("--stats"));
  command.get_option("--time")->description("Stop after this time; the same command goes on from there");
  command
      .add_option(
          "keys", options.keys,
          "A key of the scene and its values, for one sun.elevation=0:60:1 or trace.seed=1,5,7; several keys go "
          "together, value by value")
      ->required()
      ->type_name("KEY=FROM:TO:STEP");
  command.add_flag("--product", options.product, "All combinations of the keys' values, the last key's fastest");
  command
      .add_option("-o,--output", options.output,
                  "The frames, numbered by %d or, with zeros before, %04d; a PNG stands beside each")
      ->required()
      ->type_name("FRAME_%04d.exr");
  command.add_option("--first", options.first, "Number of the first frame")->transform(wholeNumber(0, 1'000'000'000));
  options.display.addTo(command, "Exposure of all previews; the median of what the frames would choose when left out");
  addErrorGoal(
      command, options.error,
      "Integrate what can be, as --engine mixed does, and aim at this mean relative error of each frame; engines that "
      "integrate take 2% when it is left out");
  addGamut(command, options.gamut);
  command.add_option("--contact-sheet", options.contactSheet, "All frames small on one picture, with their values")
      ->type_name("FILE.png")
      ->check(fileOfKind({".png"}, ".png"));
}

}  // namespace

void addSweep(CLI::App& app, int& exit) {
  auto options = std::make_shared<SweepOptions>();
  CLI::App* command = app.add_subcommand("sweep", "Render a scene again and again while keys of it change");
  addOptions(*command, *options);
  command->callback([options, command, &exit] { exit = runSweep(*options, *command); });
}

}  // namespace parhelion::cli
