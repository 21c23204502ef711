// SPDX-License-Identifier: Apache-2.0
#pragma once

// Scenes of each kind of tally, and commands that are killed.

#include <string>
#include <vector>

#include "shell.h"

namespace parhelion::test {

/// A folder with three scenes: plain, mirrored (with a middle column) and radial. Bundles have two rays, so that odd
/// numbers of rays end within one.
struct LongRuns : Folder {
  LongRuns() {
    const std::string plates = "[[population]]\naspect = 0.3\norientation = 'plate'\ntilt = 2.0\n";
    write("plain", plates + "[trace]\nsymmetry = 'none'\n", 64);
    write("mirror", plates, 65);
    write("radial", "[[population]]\naspect = 1.0\norientation = 'random'\n", 64);
  }
  static inline const std::vector<std::string> kScenes{"plain", "mirror", "radial"};

 private:
  void write(const std::string& name, const std::string& populations, int width) {
    writeFile(*this / (name + ".toml"), "[sun]\nelevation = 20.0\n[camera]\nresolution = [" + std::to_string(width) +
                                            ", 48]\nfov_horizontal = 90.0\nelevation = 25.0\n" + populations);
  }
};

/// Whether two files hold the same bytes.
inline bool isSame(const Folder& folder, const std::string& a, const std::string& b) {
  return readFile(folder / a) == readFile(folder / b) && !readFile(folder / a).empty();
}

/// The program in the background, as `pid`, followed by what is done to it. Its exit code is that of the whole.
inline std::string inBackground(const std::string& arguments, const std::string& then) {
  return "{ '" PARHELION_BINARY "' " + arguments + " & pid=$!; " + then + " ; wait $pid; }";
}

/// Waits until the program heeds signals, or has ended: the handler of SIGUSR1, the tenth bit, is set last.
inline const std::string kUntilReady =
    "while kill -0 $pid 2>/dev/null && ! grep -q 'SigCgt:.*[2367abef][0-9a-f][0-9a-f]$' /proc/$pid/status; do sleep "
    "0.01; done";

/// Waits until a file is there, or the program has ended.
inline std::string until(const std::string& file) {
  return "while kill -0 $pid 2>/dev/null && ! [ -s " + file + " ]; do sleep 0.01; done";
}

}  // namespace parhelion::test
