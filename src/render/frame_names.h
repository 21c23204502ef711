// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace parhelion {

/// File names with a number in them, "frame_%04d.exr": one %d, padded with zeros to N digits by %0Nd; %% is a percent
/// sign.
class FrameNames {
 public:
  /// Throws std::invalid_argument unless the pattern has its one number and ends in .exr, in small or capital letters.
  explicit FrameNames(const std::string& pattern);

  std::filesystem::path operator()(std::size_t number) const;

 private:
  std::string before_, after_;
  std::size_t digits_ = 1;
};

}  // namespace parhelion
