// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <sys/wait.h>

#include "picture/temporary_directory.h"

namespace parhelion::test {

inline std::string readFile(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline void writeFile(const std::filesystem::path& path, const std::string& text) { std::ofstream(path) << text; }

using Folder = TemporaryDirectory;

struct Outcome {
  int exit;
  std::string out, err;
};

/// Runs a shell command in `folder` with `parhelion` standing for the built binary.
inline Outcome run(const Folder& folder, const std::string& command) {
  const std::string script =
      "cd '" + folder.path().string() + "' && parhelion() { '" PARHELION_BINARY "' \"$@\"; } && " + command;
  writeFile(folder / "command.sh", script + "\n");
  const std::string files = " >'" + (folder / "stdout").string() + "' 2>'" + (folder / "stderr").string() + "'";
  const int status = std::system(("sh '" + (folder / "command.sh").string() + "'" + files).c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readFile(folder / "stdout"), readFile(folder / "stderr")};
}

inline long lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

}  // namespace parhelion::test
