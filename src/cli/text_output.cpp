// SPDX-License-Identifier: Apache-2.0
#include "cli/text_output.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "image/atomic_file.h"

namespace parhelion::cli {

void requireWritable(const std::string& path) {
  if (path != "-" && !path.empty()) AtomicFile file(path);
}

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
