// SPDX-License-Identifier: Apache-2.0
#include "cli/text_output.h"

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "math/conventions.h"
#include "picture/atomic_file.h"

namespace parhelion::cli {

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
