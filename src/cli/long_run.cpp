// SPDX-License-Identifier: Apache-2.0
#include "cli/long_run.h"

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/duration.h"
#include "cli/file_words.h"
#include "cli/own_files.h"
#include "cli/say.h"
#include "cli/stats.h"
#include "cli/trace_watch.h"
#include "picture/exr.h"
#include "picture/file_kind.h"
#include "picture/picture_text.h"

namespace parhelion::cli {

namespace {

const char* wordFor(RunEnd end) {
  switch (end) {
    case RunEnd::complete:
      return "rays";
    case RunEnd::stopped:
      return "signal";
    case RunEnd::timeOver:
      return "time";
    case RunEnd::goodEnough:
      return "error";
  }
  return "";
}

/// Throws CLI::ValidationError for what is no tally. An EXR that does not tell what it is may be a damaged one.
void requireTally(const std::filesystem::path& path) {
  const std::optional<Misfit> misfit = misfitOf(path, startOfFile(path), Wanted::tally);
  if (!misfit) return;
  try {
    if (isExr(path)) readPictureText(path);
  } catch (const std::runtime_error&) {
    return;
  }
  throw CLI::ValidationError("--resume", path.string() + " " + misfit->message);
}

/// Throws CLI::ValidationError for the tally of something else. What is damaged or missing is for others to judge.
void requireKind(const std::filesystem::path& path, TallyKind wanted) {
  TallyKind found = wanted;
  try {
    found = tallyKindOf(path);
  } catch (const std::runtime_error&) {
  }
  if (found == wanted) return;
  throw CLI::ValidationError("--resume", path.string() + " is the tally of a " + std::string(nameOf(found)) +
                                             ", not of a " + std::string(nameOf(wanted)));
}

std::string percent(double share) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3g %%", 100.0 * share);
  return text;
}

}  // namespace

Transaction claimRun(Files files, const RunOptions& run, const LongRunOptions& longRun) {
  if (!longRun.resume.empty()) requireTally(longRun.resume);
  const auto resumed = longRun.resume.empty() ? files.outputs.end() : std::ranges::find(files.outputs, longRun.resume);
  const bool isOutput = resumed != files.outputs.end();
  if (isOutput) files.outputs.erase(resumed);
  Transaction outputs = claimOutputs(files, run.overwrite);
  if (isOutput) outputs.claim(longRun.resume);
  return outputs;
}

LongRun::LongRun(LongRunTask task, RunSums& sums, const StopSignal& stop)
    : task_(std::move(task)),
      sums_(sums),
      stop_(stop),
      progress_(progressStyle(task_.run.quiet, task_.run.progress), Progress::kOfTracing) {
  if (!task_.longRun.hasCheckpoints()) task_.checkpoint.clear();
}

void LongRun::trace() {
  if (!task_.longRun.resume.empty()) goOnFromTally();
  const RayRanges missing = raysWithout(joined({task_.wanted}), sums_.origin().rays);
  heldBefore_ = task_.wanted.count - countOf(missing);
  if (task_.longRun.isPart() || !task_.longRun.resume.empty()) sayWhatIsMissing(missing);
  Film& film = sums_.film();
  const std::unique_ptr<RayTracer> tracer =
      task_.tracers.make(task_.cloud, task_.settings, sums_, task_.run.threads, valueOf<Simd>(task_.run.simd));
  report_ = traceRun(*tracer, film, sums_.origin().rays, missing, task_.cloud.bundleSize(), control());
  cpuSeconds_ = processUsage().cpuSeconds;
  progress_.finish();
}

void LongRun::goOnFromTally() {
  const std::string& file = task_.longRun.resume;
  requireKind(file, sums_.kind());
  try {
    const Resumed resumed = resumeFrom(file, sums_);
    for (const std::string& remark : resumed.remarks) tell("--resume: " + remark);
    keepsPrevious_ = resumed.from != previousOf(file) || task_.checkpoint != file;
    takeOutCutBundles(sums_, task_.wanted, task_.cloud, task_.settings);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("--resume", error.what());
  }
}

void LongRun::sayWhatIsMissing(const RayRanges& missing) {
  std::string text = wordsFor(joined({task_.wanted})) + " are wanted, ";
  if (missing.empty())
    text += "and all are there";
  else
    text += std::to_string(countOf(missing)) + (heldBefore_ > 0 ? " of them are missing" : " of them");
  tell(text);
}

RunControl LongRun::control() {
  RunControl control;
  static_cast<TraceControl&>(control) = traceControl(task_.run, &stop_);
  control.onProgress = [this](std::uint64_t done, double seconds) { showProgress(done, seconds); };
  control.checkpoints.write = [this] { checkpointOnTheWay(); };
  control.checkpoints.requested = [this] { return stop_.takeCheckpointRequest(); };
  control.checkpoints.interval = task_.longRun.interval();
  // Nothing but a signal asks for what can go nowhere.
  if (task_.checkpoint.empty()) control.checkpoints.interval = std::numeric_limits<double>::infinity();
  control.goal.error = task_.longRun.goal();
  control.goal.measure = [this] { return measureError(); };
  return control;
}

std::optional<double> LongRun::measureError() {
  const std::optional<double> error = task_.measureError();
  if (error) error_ = error;
  return error;
}

void LongRun::showProgress(std::uint64_t done, double seconds) {
  if (stop_.requested() && task_.tracers.processes() > 1) tellOfLosses();
  const double goal = task_.longRun.goal(), all = static_cast<double>(heldBefore_ + done);
  double share = all / static_cast<double>(task_.wanted.count);
  // The error falls with the root of the rays.
  if (error_) share = std::max(share, std::min(1.0, goal * goal / (*error_ * *error_)));
  progress_.update(share, seconds,
                   [&](Progress::Style style) { return progressLine(style, static_cast<double>(done), seconds); });
}

std::string LongRun::progressLine(Progress::Style style, double done, double seconds) const {
  TraceProgress progress{static_cast<double>(heldBefore_) + done,
                         static_cast<double>(task_.wanted.count),
                         done,
                         seconds,
                         error_,
                         task_.longRun.goal()};
  return parhelion::cli::progressLine(style, progress);
}

void LongRun::checkpointOnTheWay() {
  if (task_.checkpoint.empty()) return tell("SIGUSR1: there is no file for a checkpoint");
  if (!tryCheckpoint()) return;
  wroteCheckpoint_ = true;
  raysOnDisk_ = sums_.origin().rayCount();
  tellOfCheckpoint();
}

void LongRun::tellOfCheckpoint() {
  if (isJson()) return tellEvent({{"checkpoint", task_.checkpoint.string()}, {"rays", raysOnDisk_}});
  const Readable rays = readable(static_cast<double>(raysOnDisk_));
  char text[64];
  std::snprintf(text, sizeof text, "checkpoint: %.4g%s rays in ", rays.value, rays.suffix);
  tell(text + task_.checkpoint.string());
}

/// A run that can go on is worth more than a checkpoint of it: failures are told, once.
bool LongRun::tryCheckpoint() {
  try {
    if (std::filesystem::exists(task_.checkpoint) && !task_.run.overwrite && !isOwnFile(task_.checkpoint))
      throw std::runtime_error(task_.checkpoint.string() + ": is there and was not written by parhelion");
    writeCheckpoint(task_.checkpoint, sums_, keepsPrevious_);
    keepsPrevious_ = true;
    failed_ = false;
  } catch (const std::runtime_error& error) {
    if (!failed_) warn(std::string("no checkpoint: ") + error.what());
    failed_ = true;
  }
  return !failed_;
}

void LongRun::writeLastCheckpoint() {
  const bool leavesOne = task_.longRun.leavesCheckpoint() || wroteCheckpoint_ || report_.end == RunEnd::stopped;
  if (task_.checkpoint.empty() || !leavesOne || !tryCheckpoint()) return;
  isSaved_ = true;
  raysOnDisk_ = sums_.origin().rayCount();
  isJson() ? tellOfCheckpoint() : tell("wrote " + task_.checkpoint.string());
}

void LongRun::report() const {
  if (task_.run.quiet) return;
  const std::uint64_t held = sums_.origin().rayCount();
  printLedger(report_, report_.end == RunEnd::timeOver);
  if (held != report_.rays) say("with those traced before %" PRIu64 " rays", held);
  if (report_.error)
    say("error: %s%s", percent(*report_.error).c_str(),
        *report_.error <= task_.longRun.goal() ? "" : ", more than was asked for");
}

void LongRun::writeStats(Transaction& outputs, const nlohmann::ordered_json* more) const {
  if (task_.run.stats.empty()) return;
  nlohmann::ordered_json json = statsJson({task_.settings, report_, task_.run.threads, cpuSeconds_});
  json["rays_held"] = sums_.origin().rayCount();
  json["ray_ranges"] = nlohmann::ordered_json::array();
  for (const RayRange& range : sums_.origin().rays) json["ray_ranges"].push_back({range.first, range.end()});
  if (task_.tracers.processes() > 1) {
    json["ranks"] = task_.tracers.processes();
    json["bytes_reduced"] = task_.tracers.bytesReduced();
  }
  json["ended_by"] = wordFor(report_.end);
  if (report_.error) json["error"] = *report_.error;
  if (more) json.update(*more);
  writeJson(outputs.at(task_.run.stats), json);
}

void LongRun::writeSums(const Output& output) {
  sums_.write(output);
  const bool isCheckpoint = !task_.checkpoint.empty() && (wroteCheckpoint_ || task_.longRun.asksForCheckpoints());
  if (isCheckpoint && keepsPrevious_) keepPrevious(output.path);
  failed_ = false;
  isSaved_ = true;
}

int LongRun::exitCode() const {
  if (failed_) return kRunTimeFailure;
  return report_.end == RunEnd::stopped || endsWithoutPicture() ? kInterrupted : kDone;
}

/// What ends a run of many processes may be the loss of one, which takes the others' light with it, and this process
/// very soon.
void LongRun::tellOfLosses() {
  if (std::exchange(toldOfLosses_, true)) return;
  const std::string file = task_.checkpoint.string();
  std::string text = "stopping; if a rank is lost, ";
  if (raysOnDisk_ > 0)
    text += file + " holds " + std::to_string(raysOnDisk_) + " rays, and --resume " + file + " goes on from them";
  else
    text += "nothing of this run is on disk: there was no checkpoint yet";
  isJson() ? tellEvent({{"remark", text}}) : say("%s", text.c_str());
}

/// Whether each line that is written while the run lasts is to be JSON.
bool LongRun::isJson() const { return progressStyle(task_.run.quiet, task_.run.progress) == Progress::Style::json; }

void LongRun::tell(const std::string& text) {
  if (isJson()) return tellEvent({{"remark", text}});
  progress_.finish();
  if (!task_.run.quiet) say("%s", text.c_str());
}

void LongRun::warn(const std::string& text) {
  if (isJson()) return tellEvent({{"warning", text}});
  progress_.finish();
  say("parhelion: warning: %s", text.c_str());
}

void LongRun::tellEvent(const nlohmann::ordered_json& event) {
  // In ASCII, of which say() changes nothing; a path need not be UTF-8.
  say("%s", event.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace).c_str());
}

}  // namespace parhelion::cli
