// SPDX-License-Identifier: Apache-2.0
#include "cli/text_output.h"

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <set>
#include <stdexcept>

#include <CLI/CLI.hpp>

#include "math/conventions.h"
#include "picture/atomic_file.h"

namespace parhelion::cli {

void requireOutputs(const std::string& input, const std::vector<std::string>& outputs) {
  std::set<std::filesystem::path> taken{std::filesystem::weakly_canonical(std::filesystem::absolute(input))};
  for (const std::string& output : outputs) {
    if (output.empty()) continue;
    const auto place = output == "-" ? std::filesystem::path("-")
                                     : std::filesystem::weakly_canonical(std::filesystem::absolute(output));
    // Devices and pipes take any number of outputs.
    if (std::filesystem::exists(place) && !std::filesystem::is_regular_file(place) &&
        !std::filesystem::is_directory(place))
      continue;
    if (!taken.insert(place).second)
      throw CLI::ValidationError("output", output + " would be written over the input or another output");
    if (output != "-") AtomicFile file(output);
  }
}

double tableDegrees(double radians) { return std::round(degrees(radians) * 1e9) / 1e9; }

void writeText(const std::string& path, std::string_view text) {
  if (path == "-") {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
      throw std::runtime_error(std::string("stdout: ") + std::strerror(errno));
    return;
  }
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace parhelion::cli
