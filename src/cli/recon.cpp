// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/number_options.h"
#include "cli/outputs.h"
#include "cli/picture.h"
#include "cli/progress.h"
#include "cli/run_options.h"
#include "cli/say.h"
#include "cli/stats.h"
#include "cli/tally_input.h"
#include "cli/text_output.h"
#include "parallel/run_clock.h"
#include "parallel/threads.h"
#include "picture/memory_limit.h"
#include "picture/png.h"
#include "picture/staged_file.h"
#include "recon/compare.h"
#include "render/needs.h"
#include "render/scene_attributes.h"
#include "scene/suggest.h"
#include "sky/confidence.h"

namespace parhelion::cli {

namespace {

struct ReconOptions {
  std::vector<std::string> tallies;
  std::string method;
  std::vector<std::string> overrides, references, layers, gains;
  PictureOptions picture;
  std::string confidence, stats;
  std::string progress = "auto";  // "auto", "json"
  int threads = 0;
  bool json = false, quiet = false, overwrite = false;

  LoadedScene load(const SkyTally& traced) const {
    std::vector<SceneOverride> all;
    const auto namesMethod = [](const std::string& o) {
      return o.starts_with("recon.method") || o.starts_with("recon=");
    };
    if (!method.empty() && std::any_of(overrides.begin(), overrides.end(), namesMethod))
      throw CLI::ValidationError("--method", "-D says another method");
    // The settings of the scene's own method are none of another's.
    if (!method.empty()) all.push_back(overrideOf("--method", method, "recon", "{method='" + method + "'}"));
    for (SceneOverride& one : overridesOf(overrides)) all.push_back(std::move(one));
    return parseScene(traced.info().scene, "the scene in " + tallies.front(), all);
  }
};

/// "reconstruction  42 %", or a line of JSON.
std::string progressLine(Progress::Style style, double share, double seconds) {
  char line[100];
  if (style == Progress::Style::json)
    std::snprintf(line, sizeof line, "{\"share\": %.3f, \"seconds\": %.3f}", share, seconds);
  else
    std::snprintf(line, sizeof line, "reconstruction %3d %%", static_cast<int>(share * 100.0));
  return line;
}

struct ReconRun {
  ReconstructedSky sky;
  double seconds = 0.0, cpuSeconds = 0.0;  // of the reconstruction alone
};

/// The gains that options ask for. Throws Unfit for layers that the tally does not have.
LayerGains gainsOf(const ReconOptions& options, const SkyTally& tally) {
  std::vector<std::string_view> accepted(tally.layers().begin(), tally.layers().end());
  const auto require = [&](const std::string& option, const std::string& name) {
    if (std::ranges::find(accepted, name) != accepted.end()) return;
    if (accepted.empty()) throw Unfit(option + ": the tally has no layers; a scene asks for them by [[layer]]");
    const std::string hint = didYouMean(name, accepted);
    throw Unfit(option + ": the tally has no layer '" + name + "'" + (hint.empty() ? "" : "; " + hint));
  };
  LayerGains gains;
  if (!options.layers.empty()) {
    for (const std::string& layer : tally.layers()) gains[layer] = 0.0;
    for (const std::string& name : options.layers) {
      require("--layers", name);
      gains[name] = 1.0;
    }
  }
  for (const std::string& text : options.gains) {
    const std::size_t equals = text.rfind('=');
    const std::string name = text.substr(0, equals);
    require("--gain", name);
    gains[name] = numbersIn(text.substr(equals + 1), "").front();
  }
  return gains;
}

ReconRun timedReconstruction(const ReconOptions& options, const SkyTally& tally, const ReconSettings& settings) {
  Progress progress(progressStyle(options.quiet, options.progress), Progress::kOfReconstruction);
  const double cpuBefore = processUsage().cpuSeconds;
  const RunClock clock;
  Watch watch;
  watch.onProgress = [&](double share) {
    const double seconds = clock.seconds();
    progress.update(share, seconds, [&](Progress::Style style) { return progressLine(style, share, seconds); });
  };
  const LayerGains gains = gainsOf(options, tally);
  ReconRun run{withThreads(options.threads, [&] { return reconstruct(tally, settings, gains, watch); })};
  run.seconds = clock.seconds();
  run.cpuSeconds = processUsage().cpuSeconds - cpuBefore;
  return run;
}

template <class Check>
void requirePair(const std::string& a, const std::string& b, const Check& check) {
  try {
    check();
  } catch (const std::invalid_argument& error) {
    throw Unfit(a + " and " + b + ": " + error.what());
  }
}

Tally readAlone(const std::string& path) {
  const TallyInputs input(std::vector{path});
  return sumOfTallies(input.files()).flattened();
}

/// The tallies of --compare. Throws Unfit unless they can be compared with the sky of `tally`.
std::vector<Tally> readReferences(const ReconOptions& options, const SkyTally& tally) {
  const std::vector<std::string>& paths = options.references;
  std::vector<Tally> references;
  for (const std::string& path : paths) {
    references.push_back(readAlone(path));
    requirePair(options.tallies.front(), path, [&] { requireReferencePair(tally.info(), references.back().info); });
  }
  if (references.size() == 2)
    requirePair(paths[0], paths[1], [&] { requireReferencePair(references[0].info, references[1].info); });
  return references;
}

/// The rows of the table: 6 digits each, null for what is not finite.
nlohmann::ordered_json comparisonJson(const Comparison& c) {
  nlohmann::ordered_json json;
  const auto add = [&json](const char* name, double value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.6g", value);
    json[name] = std::strtod(digits, nullptr);
  };
  add("relMSE", c.relMse);
  add("relMSE_stderr", c.relMseError);
  add("MSE", c.mse);
  add("logMSE", c.logMse);
  add("SSIM", c.ssim);
  add("energy_error", c.energyError);
  add("negative_pixels", c.negativePixels);
  if (!c.relMseRgb) return json;
  add("relMSE_R", (*c.relMseRgb)[0]);
  add("relMSE_G", (*c.relMseRgb)[1]);
  add("relMSE_B", (*c.relMseRgb)[2]);
  add("relMSE_rgb", c.meanRelMseRgb());
  return json;
}

std::string comparisonText(const nlohmann::ordered_json& table) {
  std::string text;
  char line[64];
  for (const auto& [name, value] : table.items()) {
    std::snprintf(line, sizeof line, "%-16s %.6g\n", name.c_str(), value.get<double>());
    text += line;
  }
  return text;
}

/// Compares with the references, if there are any, and prints the table.
void printComparison(const ReconOptions& options, const ReconRun& run, const std::vector<Tally>& references,
                     Transaction& outputs) {
  if (references.empty()) return;
  const Tally* second = references.size() == 2 ? &references[1] : nullptr;
  const Comparison result = withThreads(options.threads, [&] { return compare(run.sky.image, references[0], second); });
  const nlohmann::ordered_json table = comparisonJson(result);
  writeText(outputs.at("-"), options.json ? table.dump() + "\n" : comparisonText(table));
}

void writeReconStats(const ReconOptions& options, const SkyTally& tally, std::string_view method, const ReconRun& run,
                     const std::optional<OrderReport>& orders, Transaction& outputs) {
  std::int64_t hits = 0;
  for (const SkyTally::Part& part : tally.parts())
    for (int pixel = 0; pixel < tally.pixels(); ++pixel) hits += part.tally.hits(pixel);
  nlohmann::ordered_json json;
  json["method"] = method;
  json["seconds"] = run.seconds;
  json["cpu_seconds"] = run.cpuSeconds;
  json["threads"] = threadCount(options.threads);
  json["width"] = tally.width();
  json["height"] = tally.height();
  json["rays"] = tally.info().rayCount();
  json["hits"] = hits;
  json["peak_memory_bytes"] = processUsage().peakMemory;
  json["remarks"] = run.sky.remarks;
  if (orders) json["orders"] = ordersJson(*orders);
  writeJson(outputs.at(options.stats), json);
}

Transaction claimOutputsOf(const ReconOptions& options, const SkyFiles& sky, std::uint64_t leastBytes) {
  Files files{options.references, {}};
  files.inputs.insert(files.inputs.end(), options.tallies.begin(), options.tallies.end());
  const std::string table = options.references.empty() ? "" : "-";
  files.outputs = {sky.exr, sky.png, options.confidence, options.stats, table};
  files.leastBytes = {{sky.exr, leastBytes}};
  return claimOutputs(files, options.overwrite);
}

int runRecon(const ReconOptions& options) {
  const TallyInputs inputs(options.tallies);
  const TallySet set = requireFitting(inputs);
  if (options.tallies.size() > 1) reportMissing(set, false, options.quiet);
  const SkyTally tally = sumOfTallies(inputs.files());
  const LoadedScene loaded = options.load(tally);
  // A tally is an EXR, too: the picture's name must differ.
  const std::string& first = options.tallies.front();
  const std::string name = descriptorOf(first) ? first : std::filesystem::path(first).stem().string() + "-sky";
  SkyFiles files = options.picture.files(name);
  requireUnit(files.display, loaded.scene);
  const SkySize size = skySizeOf(tally);
  requireMemory("the picture", memoryToReconstruct(size, loaded.scene.recon, options.threads));
  Transaction outputs = claimOutputsOf(options, files, leastBytesOfPicture(size, loaded.scene.recon));
  const std::vector<Tally> references = readReferences(options, tally);

  ReconRun run = timedReconstruction(options, tally, loaded.scene.recon);
  // Before the sun is drawn.
  if (!options.confidence.empty())
    writePng(outputs.at(options.confidence), confidence(run.sky.image), {{"Software", kSoftware}});
  printComparison(options, run, references, outputs);
  files.run = &outputs;
  files.threads = options.threads;
  files.gains = gainsOf(options, tally);
  const WrittenSky written = writeSkyFiles(files, std::move(run.sky.image), tally.info(), loaded);
  if (!options.stats.empty()) writeReconStats(options, tally, nameOf(loaded.scene.recon), run, written.orders, outputs);
  outputs.commit();
  if (!options.quiet) reportPicture(files, written, run.sky.remarks);
  return kDone;
}

/// For CLI11: -D may change what is still to be done, the reconstruction.
std::string validOverride(const std::string& text) {
  if (text.starts_with("recon.")) return {};
  return expectedNot("a key of recon, the rest being traced already", text);
}

/// For CLI11: a name and a number from 0.
std::string validGain(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  const std::vector<double> number =
      equals == std::string::npos ? std::vector<double>{} : numbersIn(text.substr(equals + 1), "");
  constexpr double kMostGain = 1e6;
  if (equals != 0 && number.size() == 1 && number.front() >= 0.0 && number.front() <= kMostGain) return {};
  return expectedNot("NAME=X with a number X from 0 to 1e6, for one plates=0.5", text);
}

void addOptions(CLI::App& command, ReconOptions& options) {
  command
      .add_option("tallies", options.tallies,
                  "A tally that trace has written, or several of different rays, which are added up; - for stdin")
      ->required()
      ->type_name("TALLY");
  command.add_option("--method", options.method, "How hits become an image; as the scene says when left out")
      ->type_name("NAME")
      ->check(nameOfOne<ReconSettings>());
  addOverrides(command, options.overrides);
  command.get_option("-D")
      ->description("Override a key of recon, for one recon.method=none; may be repeated")
      ->check(CLI::Validator(validOverride, ""));
  options.picture.addTo(command);
  command.add_option("--layers", options.layers, "Only these layers of the tally, with commas between them")
      ->type_name("A,B")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      .add_option("--gain", options.gains, "How much a layer counts in the picture, 1 when left out; may be repeated")
      ->type_name("NAME=X")
      ->allow_extra_args(false)
      ->check(CLI::Validator(validGain, ""));
  command
      .add_option("--compare", options.references,
                  "Print how far the sky is from the tally REF of many rays, or from two of different rays")
      ->type_name("REF")
      ->expected(1, 2);
  command.add_flag("--json", options.json, "What --compare prints as JSON")->needs("--compare");
  command
      .add_option("--confidence", options.confidence, "Picture of the relative standard error: white 1 %, black 100 %")
      ->type_name("FILE")
      ->check(fileOfKind({".png"}, ".png"));
  command.add_option("--stats", options.stats, "Write the reconstruction's figures as JSON")->type_name("FILE");
  addOverwrite(command, options.overwrite);
  command.add_option("--nthreads", options.threads, "Threads; as many as there are processors when left out")
      ->type_name("N")
      ->transform(wholeNumber(1, kMostThreads));
  command.add_flag("--quiet", options.quiet, "Nothing on stderr");
  command.add_option("--progress", options.progress, "Progress as lines of JSON, for farms")
      ->check(oneOf({"auto", "json"}));
}

}  // namespace

void addRecon(CLI::App& app, int& exit) {
  auto options = std::make_shared<ReconOptions>();
  CLI::App* command =
      app.add_subcommand("recon", "Turn a tally from disk into a linear EXR and a PNG preview beside it");
  addOptions(*command, *options);
  command->callback([options, &exit] { exit = runRecon(*options); });
}

}  // namespace parhelion::cli
