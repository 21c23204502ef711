// SPDX-License-Identifier: Apache-2.0
#include "csv.h"

#include <stdexcept>

#include <tbb/task_arena.h>

namespace parhelion::bench {
namespace {

/// As the system calls its processors.
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  std::string line;
  while (std::getline(file, line)) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

}  // namespace

std::string machine() {
  return std::to_string(tbb::this_task_arena::max_concurrency()) + " threads, " + processor() +
         ", "
#if defined(__clang__)
         __VERSION__
#else
         "GCC " __VERSION__
#endif
#ifdef NDEBUG
         ", release build";
#else
         ", with assertions";
#endif
}

Csv::Csv(const std::filesystem::path& path, const std::string& comment, const std::string& columns)
    : path_(path), file_(path) {
  std::istringstream lines(comment);
  for (std::string line; std::getline(lines, line);) write("# " + line);
  write("# " + machine());
  write(columns);
}

void Csv::write(const std::string& line) {
  file_ << line << std::endl;
  if (!file_) throw std::runtime_error(path_.string() + ": cannot be written");
}

}  // namespace parhelion::bench
