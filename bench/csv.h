// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace parhelion::bench {

/// "2 threads, Some CPU, GCC 12.2.0, release build".
std::string machine();

/// A table in a file: comments, the names of the columns, rows. Rows are on disk as soon as they are written.
class Csv {
 public:
  /// `comment` goes into the file before the machine. Throws std::runtime_error "path: cannot be written".
  Csv(const std::filesystem::path& path, const std::string& comment, const std::string& columns);

  /// Numbers have 6 digits; a text must hold no comma.
  template <class... Values>
  void row(const Values&... values) {
    std::ostringstream line;
    const char* separator = "";
    ((line << separator << values, separator = ","), ...);
    write(line.str());
  }

 private:
  void write(const std::string& line);

  std::filesystem::path path_;
  std::ofstream file_;
};

}  // namespace parhelion::bench
