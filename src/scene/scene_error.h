// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <string>
#include <vector>

namespace parhelion {

/// One thing wrong with a scene.
struct Diagnostic {
  std::string file;     // the scene file, or "-D key=value", "--paths '3-5'" for an override
  int line = 0;         // from 1; 0 where the complaint is about the file as a whole
  int column = 0;       // from 1, in Unicode code points, a tab counting as one
  std::string message;  // what is wrong
  std::string hint;     // what would be right; may be empty
  std::string excerpt;  // the line and a caret under the place, ready to print; empty where line is 0
};

/// A scene that cannot be used. `what()` is the whole report, all errors sorted by position, ready to print.
class SceneError : public std::exception {
 public:
  explicit SceneError(std::vector<Diagnostic> diagnostics);

  const char* what() const noexcept override { return report_.c_str(); }
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
  std::string report_;
};

}  // namespace parhelion
