// SPDX-License-Identifier: Apache-2.0
#include "cli/long_run_options.h"

#include <stdexcept>
#include <utility>

#include "cli/duration.h"
#include "cli/number_options.h"
#include "math/duration_text.h"
#include "math/number_text.h"
#include "render/wanted_rays.h"

namespace parhelion::cli {

namespace {

constexpr std::int64_t kMostSlices = 1'000'000'000;

/// The number of a slice and how many there are.
std::optional<std::pair<std::uint64_t, std::uint64_t>> sliceIn(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return {};
  const auto i = wholeNumberIn(text.substr(0, slash)), count = wholeNumberIn(text.substr(slash + 1));
  if (!i || !count || *i < 1 || *i > *count || *count > kMostSlices) return {};
  return std::pair(static_cast<std::uint64_t>(*i), static_cast<std::uint64_t>(*count));
}

/// The number of a ray: 0, or what --rays understands.
std::uint64_t rayIn(std::string_view text) { return text == "0" ? 0 : parseRayCount(text); }

std::optional<RayRange> rangeIn(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return {};
  try {
    const std::uint64_t first = rayIn(text.substr(0, colon)), end = rayIn(text.substr(colon + 1));
    if (first >= end) return {};
    return RayRange{first, end - first};
  } catch (const std::invalid_argument&) {
    return {};
  }
}

/// 0.01 and 1% are the same.
std::optional<double> shareIn(std::string_view text) {
  const bool percent = text.ends_with('%');
  if (percent) text.remove_suffix(1);
  const std::optional<double> value = numberIn(text);
  return value && percent ? *value / 100.0 : value;
}

CLI::Validator check(std::string expected, bool (*isGood)(std::string_view)) {
  return CLI::Validator(
      [=](const std::string& text) { return isGood(text) ? std::string() : expectedNot(expected, text); }, "");
}

const char* wordsFor(LongRunOptions::Keeps keeps) {
  return keeps == LongRunOptions::Keeps::output        ? "the tally"
         : keeps == LongRunOptions::Keeps::tallyBeside ? "the tally, NAME.tally.exr beside NAME.exr,"
                                                       : "the tally of --tally";
}

bool isError(std::string_view text) {
  const std::optional<double> share = shareIn(text);
  return share && *share >= 1e-6 && *share < 1.0;
}

}  // namespace

CLI::Option* addErrorGoal(CLI::App& command, std::string& error, const std::string& description) {
  return command.add_option("--error", error, description)
      ->type_name("SHARE")
      ->check(check("a share below 1, for one 1% or 0.01", isError));
}

double errorGoalIn(const std::string& error) { return *shareIn(error); }

void LongRunOptions::addTo(CLI::App& command, Keeps keeps) {
  command
      .add_option("--slice", slice, "Trace one of n equal parts of the rays, for one 3/10; merge puts them together")
      ->type_name("I/N")
      ->check(check("the number of a slice and how many there are, for one 3/10",
                    [](std::string_view text) { return sliceIn(text).has_value(); }));
  command.add_option("--ray-range", rayRange, "Trace these rays only, the end excluded, for one 0:5M")
      ->type_name("FIRST:END")
      ->check(check("the first ray and the one after the last, for one 0:5M",
                    [](std::string_view text) { return rangeIn(text).has_value(); }));
  command
      .add_option("--resume", resume,
                  "Go on from this tally and trace what it lacks; from the first ray if it is not there")
      ->type_name("TALLY");
  command
      .add_option("--checkpoint", checkpoint,
                  std::string("How often to write ") + wordsFor(keeps) +
                      " on the way, or none; every 10min in runs over 20min when left out, at most 1 % of the time")
      ->type_name("TIME")
      ->check(duration(1e-3, 1e9, "none"));
  if (keeps == Keeps::tallyByName) {
    command
        .add_option("--tally", tally,
                    "The exact sums, an EXR, to be merged and gone on from; that of --resume when left out")
        ->type_name("FILE");
    return;
  }
  addErrorGoal(command, error,
               std::string("Stop when the picture's mean relative error is so small, for one 1%; --rays is the most") +
                   (keeps == Keeps::tallyBeside ? ". By itself it takes the quickest engine for that" : ""));
}

std::string LongRunOptions::tallyFile() const {
  const std::string& file = tally.empty() ? resume : tally;
  if (file.empty() && asksForCheckpoints()) throw CLI::ValidationError("--checkpoint", "--tally FILE says where to");
  return file;
}

RayRange LongRunOptions::wanted(std::uint64_t rays, int bundleSize, const RunOptions& run) const {
  if (!slice.empty() && !rayRange.empty())
    throw CLI::ValidationError("--slice", "--ray-range says already which rays to trace");
  if (isPart() && !error.empty())
    throw CLI::ValidationError("--error", "a part of the rays cannot tell when the picture of all is good enough");
  if (!slice.empty()) {
    const auto [i, count] = *sliceIn(slice);
    return sliceOf(rays, bundleSize, i, count);
  }
  if (rayRange.empty()) return {0, rays};
  const RayRange range = *rangeIn(rayRange);
  if (!run.rays.empty() && range.end() > rays)
    throw CLI::ValidationError("--ray-range", rayRange + " ends beyond the " + run.rays + " of --rays");
  try {
    requireBundleStart(range, bundleSize);
  } catch (const std::invalid_argument& refused) {
    throw CLI::ValidationError("--ray-range", refused.what());
  }
  return range;
}

std::optional<double> LongRunOptions::interval() const { return secondsIn(checkpoint); }

double LongRunOptions::goal() const { return error.empty() ? 0.0 : errorGoalIn(error); }

}  // namespace parhelion::cli
