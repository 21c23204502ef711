// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_error.h"

#include <utility>

#include "scene/utf8.h"

namespace parhelion {

namespace {

std::string reportOf(const std::vector<Diagnostic>& diagnostics) {
  std::string report;
  for (const Diagnostic& d : diagnostics) {
    report += escaped(d.file);
    if (d.line > 0) report += ':' + std::to_string(d.line) + ':' + std::to_string(d.column);
    report += ": error: " + escaped(d.message) + '\n' + d.excerpt;
    if (!d.hint.empty()) report += "      " + escaped(d.hint) + '\n';
  }
  if (!report.empty()) report.pop_back();  // whoever prints it ends the line
  return report;
}

}  // namespace

SceneError::SceneError(std::vector<Diagnostic> diagnostics)
    : diagnostics_(std::move(diagnostics)), report_(reportOf(diagnostics_)) {}

}  // namespace parhelion
