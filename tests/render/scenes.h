// SPDX-License-Identifier: Apache-2.0
#pragma once

// Small scenes, and an ear for what is printed.

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include <unistd.h>

#include "scene/parse_scene.h"

namespace parhelion::test {

/// Plates and random columns, a twentieth of a second to render.
inline LoadedScene smallScene(const std::vector<std::string>& overrides = {}) {
  static const std::string text = R"(
[sun]
elevation = 20.0
[[population]]
name = "plates"
aspect = 0.3
tilt = 2.0
orientation = "plate"
[[population]]
name = "columns"
aspect = 2.0
orientation = "random"
[camera]
projection = "rectilinear"
resolution = [48, 32]
fov_horizontal = 80.0
elevation = 25.0
[trace]
rays = "20k"
)";
  return parseScene(text, "small.toml", overrides);
}

/// The same with random columns alone.
inline LoadedScene columnsScene() {
  return parseScene("[[population]]\naspect = 1.0\norientation = \"random\"\n[camera]\nresolution = [32, 32]\n",
                    "columns.toml");
}

/// All that is written to stdout and stderr while it lives.
class Printed {
 public:
  Printed() {
    std::fflush(stdout);
    for (int i = 0; i < 2; ++i) {
      before_[i] = dup(i + 1);
      dup2(fileno(file_), i + 1);
    }
  }
  ~Printed() { end(); }
  Printed(const Printed&) = delete;
  Printed& operator=(const Printed&) = delete;

  /// Ends it.
  std::string text() {
    end();
    std::rewind(file_);
    std::string all;
    for (int c = std::fgetc(file_); c != EOF; c = std::fgetc(file_)) all += static_cast<char>(c);
    return all;
  }

 private:
  void end() {
    std::fflush(stdout);
    for (int i = 0; i < 2; ++i) {
      if (before_[i] < 0) continue;
      dup2(before_[i], i + 1);
      close(before_[i]);
      before_[i] = -1;
    }
  }

  std::FILE* file_ = std::tmpfile();  // goes away with the process
  std::array<int, 2> before_{};
};

}  // namespace parhelion::test
