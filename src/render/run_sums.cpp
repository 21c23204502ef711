// SPDX-License-Identifier: Apache-2.0
#include "render/run_sums.h"

#include <unistd.h>

#include <stdexcept>
#include <system_error>

#include "picture/atomic_file.h"
#include "trace/trace.h"

namespace parhelion {

namespace {

/// The file under a second name, in the place of what has that name. Where there are no hard links, the file changes
/// its name; where that fails too, there is no file before the last.
void keepAs(const std::filesystem::path& previous, const std::filesystem::path& file) {
  std::error_code none;
  const std::filesystem::path target = followLinks(file);
  if (!std::filesystem::is_regular_file(target, none)) return;
  // A link cannot replace a file, a rename can.
  std::filesystem::path link = previous;
  link += "." + std::to_string(::getpid());
  std::filesystem::create_hard_link(target, link, none);
  if (none)
    std::filesystem::rename(target, previous, none);
  else
    std::filesystem::rename(link, previous, none);
  // Two names of one file stay as they are when one is renamed to the other.
  std::filesystem::remove(link, none);
}

void readFrom(const std::filesystem::path& path, RunSums& sums, Resumed& resumed) {
  sums.read(path);
  resumed.from = path;
}

}  // namespace

std::filesystem::path previousOf(const std::filesystem::path& checkpoint) {
  std::filesystem::path previous = checkpoint;
  return previous += ".previous";
}

void writeCheckpoint(const std::filesystem::path& path, const RunSums& sums, bool keepsPrevious) {
  std::filesystem::path fresh = path;
  fresh += ".new";
  sums.write(fresh);
  if (keepsPrevious) keepAs(previousOf(path), path);
  std::filesystem::rename(fresh, path);
}

Resumed resumeFrom(const std::filesystem::path& checkpoint, RunSums& sums) {
  const std::filesystem::path previous = previousOf(checkpoint);
  const bool isThere = std::filesystem::exists(checkpoint), hasPrevious = std::filesystem::exists(previous);
  Resumed resumed;
  if (isThere) {
    try {
      readFrom(checkpoint, sums, resumed);
      return resumed;
    } catch (const std::runtime_error& error) {
      if (!hasPrevious) throw;
      resumed.remarks.emplace_back(error.what());
    }
  }
  if (hasPrevious) {
    if (!isThere) resumed.remarks.push_back(checkpoint.string() + " is not there");
    readFrom(previous, sums, resumed);
    resumed.remarks.push_back("going on from the one before, " + previous.string());
  } else {
    resumed.remarks.push_back(checkpoint.string() + " is not there: starting with the first ray");
  }
  return resumed;
}

void takeOutCutBundles(RunSums& sums, const RayRange& wanted, const Cloud& cloud, const TraceSettings& settings) {
  const auto size = static_cast<std::uint64_t>(cloud.bundleSize());
  RayRanges cut;
  for (const RayRange& range : sums.origin().rays)
    if (range.end() % size != 0 && wanted.first <= range.end() && range.end() < wanted.end())
      cut.push_back({range.end() / size * size, range.end() % size});
  for (const RayRange& range : cut) {
    const std::unique_ptr<RunSums> part = sums.empty();
    TraceSettings own = settings;
    own.rays = range.end();
    traceRays(cloud, own, range.first, part->film(), {.threads = 1, .onProgress = {}});
    part->origin().rays = {range};
    sums.subtract(*part);
  }
}

}  // namespace parhelion
