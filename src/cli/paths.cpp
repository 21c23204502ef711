// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/integral_run.h"
#include "cli/long_run_options.h"
#include "cli/number_options.h"
#include "cli/outputs.h"
#include "cli/run_options.h"
#include "cli/say.h"
#include "cli/stats.h"
#include "cli/stop_signal.h"
#include "cli/tables.h"
#include "cli/text_output.h"
#include "cli/trace_watch.h"
#include "math/rotation.h"
#include "parallel/run_clock.h"
#include "parallel/threads.h"
#include "picture/auto_exposure.h"
#include "picture/memory_limit.h"
#include "render/integrated_paths.h"
#include "render/mixed_sky.h"
#include "render/needs.h"
#include "render/path_map.h"
#include "render/sky_files.h"
#include "render/traced_sky.h"
#include "scene/suggest.h"
#include "sky/sky_tally.h"
#include "trace/path_ledger.h"
#include "view/path_picture.h"

namespace parhelion::cli {

namespace {

constexpr double kReferenceWavelength = 550.0;  // nm, at which least deviations are told
constexpr double kUsualRadius = 1.0;            // degrees about --at and --ray-for

struct PathsOptions {
  RunOptions run;
  std::string at, rayFor, layer, symmetry = std::string(nameOf(PathSymmetry::orientation));
  double radius = kUsualRadius;  // degrees
  int top = 0;                   // 0: all in files, kUsualTop on the terminal
  std::string csv, json, map;
  std::string error;  // aimed at by the integral engine; empty: as chosen

  static constexpr int kUsualTop = 20;
};

/// "az,el" in degrees.
std::optional<Vec3> directionIn(const std::string& text) {
  const std::vector<double> numbers = numbersIn(text, ",");
  if (numbers.size() != 2 || std::abs(numbers[0]) > 360.0 || std::abs(numbers[1]) > 90.0) return std::nullopt;
  return skyDirection(radians(numbers[0]), radians(numbers[1]));
}

std::string validDirection(const std::string& text) {
  if (directionIn(text)) return {};
  return expectedNot("AZIMUTH,ELEVATION in degrees, for one -22.5,20", text);
}

/// A field of a CSV table.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string angle(double degreesValue) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.3f", degreesValue);
  return digits;
}

std::string csvOf(const std::vector<PathLedger::Entry>& entries, const Cloud& cloud) {
  std::string text = kPathColumns + std::string("\n");
  char shares[64];
  for (const PathLedger::Entry& entry : entries) {
    std::snprintf(shares, sizeof shares, ",%.9g,%.4g,", entry.share, entry.error);
    text += field(entry.path) + "," + field(cloud.populations()[entry.population].name()) + shares;
    const SkyPoint peak = skyPoint(entry.toPeak);
    text += angle(degrees(peak.azimuth)) + "," + angle(degrees(peak.elevation)) + ",";
    text += (entry.leastDeviation ? angle(degrees(*entry.leastDeviation)) : "") + "," + field(entry.name) + "\n";
  }
  return text;
}

nlohmann::ordered_json jsonOf(const std::vector<PathLedger::Entry>& entries, const Cloud& cloud,
                              const PathLedger& ledger, std::uint64_t rays) {
  nlohmann::ordered_json json;
  json["rays"] = rays;
  json["share_of_intercepted"] = ledger.shareOfIntercepted();
  json["paths"] = nlohmann::ordered_json::array();
  for (const PathLedger::Entry& entry : entries) {
    nlohmann::ordered_json one;
    one["path"] = entry.path;
    one["population"] = cloud.populations()[entry.population].name();
    one["share"] = entry.share;
    one["stderr"] = entry.error;
    const SkyPoint peak = skyPoint(entry.toPeak);
    one["azimuth_deg"] = degrees(peak.azimuth);
    one["elevation_deg"] = degrees(peak.elevation);
    one["least_deviation_deg"] =
        entry.leastDeviation ? nlohmann::ordered_json(degrees(*entry.leastDeviation)) : nlohmann::ordered_json();
    one["name"] = entry.name;
    json["paths"].push_back(one);
  }
  return json;
}

/// The first rows for people, and how many there are besides.
void printTable(const std::vector<PathLedger::Entry>& entries, const Cloud& cloud, int rows) {
  answer("%8s %7s  %-16s %-14s %8s %8s %8s  %s", "share %", "+-", "path", "population", "azimuth", "elev.", "least",
         "name");
  double rest = 0.0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const PathLedger::Entry& entry = entries[i];
    if (i >= static_cast<std::size_t>(rows)) {
      rest += entry.share;
      continue;
    }
    const SkyPoint peak = skyPoint(entry.toPeak);
    answer("%8.3f %7.3f  %-16s %-14s %8s %8s %8s  %s", 100.0 * entry.share, 100.0 * entry.error, entry.path.c_str(),
           cloud.populations()[entry.population].name().c_str(), angle(degrees(peak.azimuth)).c_str(),
           angle(degrees(peak.elevation)).c_str(),
           entry.leastDeviation ? angle(degrees(*entry.leastDeviation)).c_str() : "", entry.name.c_str());
  }
  if (entries.size() > static_cast<std::size_t>(rows))
    answer("%8.3f          %zu more", 100.0 * rest, entries.size() - static_cast<std::size_t>(rows));
}

PathLedgerScope scopeOf(const PathsOptions& options, const PathSettings& paths) {
  PathLedgerScope scope;
  scope.symmetry = *memberNamed<PathSymmetry>(options.symmetry);
  const std::string& centre = options.rayFor.empty() ? options.at : options.rayFor;
  if (!centre.empty()) scope.region = SkyRegion{*directionIn(centre), radians(options.radius)};
  if (options.layer.empty()) return scope;
  std::vector<std::string_view> names;
  for (const LayerSettings& layer : paths.layers) names.push_back(layer.name);
  names.push_back(kRestLayer);
  const auto found = std::ranges::find(names, options.layer);
  if (found == names.end() || names.size() == 1) {
    std::string hint = didYouMean(options.layer, names);
    throw Unfit("--layer: the scene has no layer '" + options.layer + "'" + (hint.empty() ? "" : "; " + hint));
  }
  scope.layer = static_cast<int>(found - names.begin());
  return scope;
}

/// The scene with the strongest families of a ledger's paths for its layers.
LoadedScene layeredBy(const PathLedger& ledger, const PathsOptions& options, const LoadedScene& loaded,
                      const Cloud& cloud) {
  LoadedScene layered = loaded;
  layered.scene.trace.paths.layers =
      strongestPaths(ledger.entries(kReferenceWavelength), cloud,
                     options.top > 0 ? std::min<std::size_t>(options.top, kMostHues) : kMostHues);
  return layered;
}

/// A sky painted by its layers.
void writeLayered(const PathsOptions& options, const LoadedScene& layered, const Image& sky, Transaction& outputs) {
  std::vector<std::string> names;
  for (const LayerSettings& layer : layered.scene.trace.paths.layers) names.push_back(layer.name);
  const double stops = autoExposure(sky);
  writePreview(outputs.at(options.map), paintByLayer(sky, names, stops), stops, layered.text);
}

/// Only light that the scene's camera sees: which paths there are in the picture.
PathLedgerScope scopeOfMap(const PathsOptions& options, const Scene& scene) {
  PathLedgerScope scope = scopeOf(options, scene.trace.paths);
  scope.view = scene.camera;
  return scope;
}

/// The sky painted by the strongest families of paths.
void writeMap(const PathsOptions& options, const LoadedScene& loaded, const Cloud& cloud, Transaction& outputs) {
  constexpr std::uint64_t kPilotRays = 500'000;
  TraceSettings pilot = loaded.scene.trace;
  pilot.rays = kPilotRays;
  PathLedger ledger(cloud, scopeOfMap(options, loaded.scene));
  traceRays(cloud, pilot, 0, ledger, traceControl(options.run, nullptr));

  const LoadedScene layered = layeredBy(ledger, options, loaded, cloud);
  requireMemory("the map of paths", memoryToRender(skySizeOf(layered.scene), layered.scene.recon, options.run.threads));
  TraceWatch watch(options.run, layered.scene.trace.rays);
  const TracedSky traced = traceSky(layered, cloud, watch.control());
  watch.report(traced.report, traced.settings);
  writeLayered(options, layered, developSky(traced, layered, options.run.threads).image, outputs);
}

/// The same without rays.
void writeSmoothMap(const PathsOptions& options, const LoadedScene& loaded, const Cloud& cloud, Transaction& outputs) {
  constexpr double kPilotError = 1e-3, kPictureError = 0.05;
  const LoadedScene layered = withThreads(options.run.threads, [&] {
    const IntegratedPaths pilot = integratePaths(loaded.scene, cloud, scopeOfMap(options, loaded.scene), kPilotError);
    return layeredBy(pilot.ledger, options, loaded, cloud);
  });
  requireIntegrable(layered.scene);
  requireMemory("the map of paths",
                memoryToIntegrate(skySizeOf(layered.scene)) + memoryOfOrientations(layered.scene, kPictureError));
  const MixedSky made = mixSky(layered, {kPictureError}, traceControl(options.run, nullptr));
  if (!options.run.quiet) reportSmooth(made);
  writeLayered(options, layered, made.sky.image, outputs);
}

/// The tables of a ledger.
void writeTables(const PathsOptions& options, const PathLedger& ledger, const Cloud& cloud, std::uint64_t rays,
                 Transaction& outputs) {
  std::vector<PathLedger::Entry> entries = ledger.entries(kReferenceWavelength);
  if (options.csv.empty() && options.json.empty() && options.map.empty())
    printTable(entries, cloud, options.top > 0 ? options.top : PathsOptions::kUsualTop);
  if (options.top > 0 && entries.size() > static_cast<std::size_t>(options.top))
    entries.resize(static_cast<std::size_t>(options.top));
  if (!options.csv.empty()) writeText(outputs.at(options.csv), csvOf(entries, cloud));
  if (!options.json.empty()) writeJson(outputs.at(options.json), jsonOf(entries, cloud, ledger, rays));
}

Transaction claimPaths(const PathsOptions& options) {
  return claimOutputs({{options.run.scene}, {options.csv, options.json, options.map, options.run.stats}},
                      options.run.overwrite);
}

int runIntegral(const PathsOptions& options, const CLI::App& command, const LoadedScene& loaded) {
  refuseRayOptions(command, RayOptions::seed);
  if (!options.rayFor.empty()) throw Unfit("--ray-for: the integral engine follows no rays");
  if (const std::string objection = objectionToIntegratedPaths(loaded.scene); !objection.empty())
    throw Unfit("engine integral: " + objection + "; rays can do it, with another engine, such as auto");
  constexpr double kGoal = 1e-4;
  const double goal = options.error.empty() ? kGoal : errorGoalIn(options.error);
  const Cloud cloud = cloudByLight(loaded.scene);
  const PathLedgerScope scope = scopeOf(options, loaded.scene.trace.paths);
  Transaction outputs = claimPaths(options);
  const RunClock clock;
  const IntegratedPaths paths =
      withThreads(options.run.threads, [&] { return integratePaths(loaded.scene, cloud, scope, goal); });
  const double seconds = clock.seconds(), out = 1.0 - paths.filtered - paths.cutOff;
  if (!options.run.quiet) {
    say("%ld directions in %.2f s, %.3g a second: shares to %.2g", paths.directions, seconds,
        static_cast<double>(paths.directions) / seconds, paths.error);
    say("energy: in 1 = out %.9f + filtered %.9f + cut off %.3g", out, paths.filtered, paths.cutOff);
  }
  if (!paths.reached) say("warning: the error asked for was not reached; the table has its errors as they are");
  if (!options.map.empty()) writeSmoothMap(options, loaded, cloud, outputs);
  writeTables(options, paths.ledger, cloud, 0, outputs);
  if (!options.run.stats.empty()) {
    nlohmann::ordered_json json = integralStats(seconds, options.run.threads, paths.cutOff);
    json["energy"]["out"] = out;
    json["energy"]["filtered"] = paths.filtered;
    json["directions"] = paths.directions;
    json["error"] = paths.error;
    json["reached"] = paths.reached;
    writeJson(outputs.at(options.run.stats), json);
  }
  outputs.commit();
  return kDone;
}

int runPaths(const PathsOptions& options, const CLI::App& command) {
  LoadedScene loaded = options.run.load();
  if (asksForErrorAlone(command) && loaded.scene.trace.engine == Engine::automatic)
    loaded.scene.trace.engine = Engine::integral;
  if (loaded.scene.trace.engine == Engine::integral) return runIntegral(options, command, loaded);
  if (loaded.scene.trace.engine == Engine::mixed)
    throw Unfit("engine mixed: it makes pictures and maps; paths take rays, or the engine integral");
  if (!options.error.empty()) throw Unfit("--error: it is for light that is integrated; rays take --rays or --time");
  const Cloud cloud = cloudOf(loaded.scene);
  TraceSettings settings = chosenSettings(cloud, loaded.scene.trace);
  settings.symmetry = Symmetry::none;
  const PathLedgerScope scope = scopeOf(options, settings.paths);
  Transaction outputs = claimPaths(options);
  PathLedger ledger(cloud, scope);
  TraceWatch watch(options.run, settings.rays);
  const StopSignal stop;
  TraceControl control = watch.control();
  control.stop = &stop.requested();
  const TraceReport report = traceRays(cloud, settings, 0, ledger, control);
  const RunFigures figures = watch.report(report, settings);
  if (!options.rayFor.empty()) {
    const auto ray = ledger.brightestRay();
    if (!ray) throw std::runtime_error("no ray lit that part of the sky: more --rays or a larger --radius");
    answer("%llu", static_cast<unsigned long long>(*ray));
  } else {
    if (!options.map.empty() && !stop.requested()) writeMap(options, loaded, cloud, outputs);
    writeTables(options, ledger, cloud, report.rays, outputs);
  }
  if (!options.run.stats.empty()) writeJson(outputs.at(options.run.stats), statsJson(figures));
  outputs.commit();
  return stop.requested() ? kInterrupted : kDone;
}

}  // namespace

void addPaths(CLI::App& app, int& exit) {
  auto options = std::make_shared<PathsOptions>();
  CLI::App* command = app.add_subcommand(
      "paths",
      "Which raypaths make the light: of the whole sky or of a part of it, most light first, with their names");
  options->run.addTo(*command, false);
  CLI::Option* at =
      command
          ->add_option("--at", options->at,
                       "Only light from about this place of the sky, degrees: azimuth to 360, elevation to 90")
          ->type_name("AZ,EL")
          ->check(CLI::Validator(validDirection, ""));
  command->add_option("--radius", options->radius, "How far about it, degrees; 1 when left out")
      ->type_name("R")
      ->transform(number(0.001, 180.0));
  command->add_option("--layer", options->layer, "Only light of this layer of the scene, or of the rest")
      ->type_name("NAME");
  command
      ->add_option("--symmetry", options->symmetry,
                   "Which paths count as one: up to the crystal's symmetry, up to "
                   "that which leaves its orientations alone, or none")
      ->type_name("crystal|orientation|none")
      ->check(nameOfOne<PathSymmetry>());
  command->add_option("--top", options->top, "Only so many paths; 20 on the terminal and all in files when left out")
      ->type_name("N")
      ->transform(wholeNumber(1, 1'000'000));
  command->add_option("--csv", options->csv, "The table as CSV; - for stdout")->type_name("FILE");
  command->add_option("--json", options->json, "The same as JSON; - for stdout")->type_name("FILE");
  command
      ->add_option(
          "--map", options->map,
          "Paint the sky by the paths that make most of the light at each place, with a legend; takes a run more")
      ->type_name("FILE")
      ->check(fileOfKind({".png"}, ".png"));
  command
      ->add_option("--ray-for", options->rayFor,
                   "Print the index of a ray that lit this place of the sky, degrees, for replay --ray")
      ->type_name("AZ,EL")
      ->check(CLI::Validator(validDirection, ""))
      ->excludes(at);
  addErrorGoal(
      *command, options->error,
      "Integrate, as --engine integral does, and aim at this standard error of shares; the engine takes 0.01% when "
      "it is left out");
  options->run.mayIntegrate = true;
  command->callback([options, command, &exit] {
    if (command->count("--radius") > 0 && options->at.empty() && options->rayFor.empty())
      throw CLI::ValidationError("--radius", "is that of --at or --ray-for");
    exit = runPaths(*options, *command);
  });
}

}  // namespace parhelion::cli
