// SPDX-License-Identifier: Apache-2.0
#include "render/run_sums.h"

#include <stdexcept>
#include <system_error>

#include "picture/temporary_file.h"
#include "trace/trace.h"

namespace parhelion {

namespace {

/// Whether a file is a tally, by its header.
bool isTally(const std::filesystem::path& path) {
  try {
    tallyKindOf(path);
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
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

void keepPrevious(const std::filesystem::path& checkpoint) {
  const std::filesystem::path file = followLinks(checkpoint), previous = previousOf(checkpoint);
  std::error_code none;  // where it cannot be kept, the file itself is still there
  if (!std::filesystem::is_regular_file(file, none) || !isTally(file)) return;
  std::filesystem::remove(previous, none);
  std::filesystem::create_hard_link(file, previous, none);
  if (none) std::filesystem::rename(file, previous, none);  // on file systems without such links
}

void writeCheckpoint(const std::filesystem::path& path, const RunSums& sums, bool keepsBefore) {
  Transaction files;
  sums.write(files.at(path));
  if (keepsBefore) keepPrevious(path);
  files.commit();
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
