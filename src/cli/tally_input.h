// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cli/run_options.h"
#include "render/tally_sum.h"

namespace parhelion::cli {

/// Tallies as a command line names them: files, pipes, or "-" for stdin. What comes out of a pipe is kept in a nameless
/// file as long as this lives.
class TallyInputs {
 public:
  /// Throws std::runtime_error "name: reason" for what cannot be read and for files that are no tallies.
  explicit TallyInputs(std::span<const std::string> names);

  std::span<const TallyFile> files() const { return files_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  using Spooled = std::unique_ptr<std::FILE, Close>;

  /// All that a pipe gives, which must be an EXR.
  Spooled spooled(const std::string& name) const;

  std::vector<Spooled> spooled_;
  std::vector<TallyFile> files_;
};

/// Whether a file is a tally, as far as its header tells.
bool isTallyFile(const std::string& name);

/// Whether it is one of a map or a profile, from which these commands make their tables.
bool isMeasuredTally(const std::string& name);

/// For commands that make a table of a tally instead of tracing a scene: throws Unfit if it is the tally of something
/// else, or if options ask for tracing.
void requireMeasured(const RunOptions& options, TallyKind kind);

/// Says on stderr which rays are missing, if some are. With `complete` that throws Unfit.
void reportMissing(const TallySet& set, bool complete, bool quiet);

/// fittingTallies() with Unfit for what does not fit.
TallySet requireFitting(const TallyInputs& inputs);

}  // namespace parhelion::cli
