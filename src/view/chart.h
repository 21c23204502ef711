// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "math/conventions.h"
#include "picture/transaction.h"

namespace parhelion {

struct ChartCurve {
  std::string title;         // shown as it is
  std::vector<Vec2> points;  // finite, x ascending
};

struct ChartAxes {
  std::string x, y;  // what is shown, with its unit
};

/// Draws curves as .svg or .png, by the name's extension, with the program gnuplot; `software` is what the file says
/// has made it. In one piece or not at all (atomic_file.h). Throws std::runtime_error in one line where gnuplot is not
/// installed or fails, or the file cannot be written, std::invalid_argument where no curve has a point.
void drawChart(const Output& output, const ChartAxes& axes, std::span<const ChartCurve> curves,
               const std::string& software);

}  // namespace parhelion
