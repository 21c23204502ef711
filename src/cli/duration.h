// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace parhelion::cli {

/// For an option: complains unless its text is such a time from `least` to `most` seconds, or the word `also`, if there
/// is one.
CLI::Validator duration(double least, double most, std::string also = {});

/// For an option's transform(): the same, and turns the time into seconds.
CLI::Validator durationInSeconds(double least, double most);

/// A time as people read it: "40 s", "12 min", "3 h 20 min", "2 d 5 h"; "forever" from 30 million years on.
std::string durationText(double seconds);

}  // namespace parhelion::cli
