// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "cli/run_options.h"
#include "scene/key_range.h"

namespace parhelion::cli {

/// File names with a number in them, "frame_%04d.exr": one %d, padded with zeros to N digits by %0Nd; %% is a percent
/// sign.
class FrameNames {
 public:
  /// Throws CLI::ValidationError unless the pattern has its one number and ends in .exr.
  explicit FrameNames(const std::string& pattern);

  std::filesystem::path operator()(std::size_t number) const;

 private:
  std::string before_, after_;
  std::size_t digits_ = 1;
};

/// A picture of a sweep.
struct SweepFrame {
  std::vector<std::string> values;  // "key=value" of the keys that are swept
  LoadedScene loaded;
  std::filesystem::path exr;
  std::string lacks;  // why it must be rendered; empty: the file is the picture already

  std::filesystem::path png() const { return std::filesystem::path(exr).replace_extension(".png"); }

  /// "sun.elevation=12, trace.seed=3"
  std::string valuesText() const;
};

/// The frames in order, numbered from `first`, each with its scene validated, and its file looked at if there is one.
/// Throws SceneError for the first scene that cannot be used, and std::runtime_error for a file in the place of a frame
/// or its preview that no render has written: it must not be written over.
std::vector<SweepFrame> planFrames(const RunOptions& run, std::span<const std::vector<std::string>> values,
                                   const FrameNames& names, std::size_t first);

}  // namespace parhelion::cli
