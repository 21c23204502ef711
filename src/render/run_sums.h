// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "picture/transaction.h"
#include "render/measurement.h"
#include "sky/tally_info.h"
#include "sky/tally_kind.h"
#include "trace/cloud.h"
#include "trace/film.h"

namespace parhelion {

/// What a run adds up: exact sums, in memory and in a file, that know which rays they hold.
class RunSums {
 public:
  virtual ~RunSums() = default;

  /// The film that adds to the sums. Valid as long as they are, from the last read() on.
  virtual Film& film() = 0;

  /// What is added up.
  virtual Measurement measurement() const = 0;

  /// What they are made of. The rays are those that the film has got.
  virtual TallyOrigin& origin() = 0;

  virtual TallyKind kind() const = 0;

  /// Takes the sums of a file in the place of these, so that there is never room needed for more than two. Throws
  /// std::runtime_error "path: reason" where the file cannot be read or is damaged, and std::invalid_argument
  /// "path: reason" where it is of another scene, seed or kind; then they are empty.
  virtual void read(const std::filesystem::path& path) = 0;

  /// Writes them so that read() gives them back, bit for bit. The film's result must be made (Film::finish()).
  virtual void write(const Output& file) const = 0;

  /// Empty ones of the same kind.
  virtual std::unique_ptr<RunSums> empty() const = 0;

  /// Takes out rays, which it must hold, exactly. Both have their results made.
  virtual void subtract(RunSums& other) = 0;
};

/// The file in which the checkpoint before the last one is kept: NAME.previous beside NAME.
std::filesystem::path previousOf(const std::filesystem::path& checkpoint);

/// Keeps a tally, if there is one, as previousOf() it, in the place of what that was. To be called when what replaces
/// the file is complete and on the disk: whenever the process is killed, one of the two can be read.
void keepPrevious(const std::filesystem::path& checkpoint);

/// Writes a checkpoint. The one before is kept as previousOf() if `keepsBefore`. Throws std::runtime_error
/// "path: reason", and then leaves it as it was.
void writeCheckpoint(const std::filesystem::path& path, const RunSums& sums, bool keepsBefore = true);

/// Where a run went on from.
struct Resumed {
  std::filesystem::path from;        // the checkpoint or the one before; empty: neither is there
  std::vector<std::string> remarks;  // for the user, if it is not the checkpoint itself
};

/// Takes the sums of a checkpoint, of the one before where it is missing or damaged, or leaves these, which are empty,
/// where there is neither. Throws as RunSums::read() does, for a damaged checkpoint only if there is none before it.
Resumed resumeFrom(const std::filesystem::path& checkpoint, RunSums& sums);

/// Takes out the last rays of ranges that end within a bundle of which more rays are wanted: a bundle's rays can only
/// be traced together. Afterwards these rays are missing.
void takeOutCutBundles(RunSums& sums, const RayRange& wanted, const Cloud& cloud, const TraceSettings& settings);

}  // namespace parhelion
