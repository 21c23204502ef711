// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "picture/temporary_file.h"

namespace parhelion {

/// The open file of this process that a path stands for: 1 for /dev/stdout and for "-", 3 for /dev/fd/3.
std::optional<int> descriptorOf(const std::filesystem::path& path);

/// An output file whose content is not yet where it belongs. A regular file is written under a temporary name. What
/// goes to a pipe or an open descriptor waits in a nameless file, since a picture's writer goes back to its beginning.
/// Other devices are written to at once. Failures throw std::runtime_error "path: reason".
class StagedFile {
 public:
  /// `claim`: fails where another run writes that file (TemporaryFile::claim), and for a device that is always full.
  StagedFile(const std::filesystem::path& path, bool claim);

  /// Where to write, from the start; closed by close() or the destructor.
  std::FILE* stream();

  /// All is written: it is on the disk, with the permissions of the file that it replaces, and still locked.
  void complete();

  /// Passes on what waits for a pipe or descriptor.
  void passOn();

  /// Puts a file in its place; undo() takes that back (TemporaryFile).
  void place();
  void undo() noexcept;

  /// The folder in which place() changes a name; none for pipes and devices.
  std::optional<std::filesystem::path> folder() const;

  /// Throws "path: reason".
  [[noreturn]] void fail(int error) const;

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void openTemporary(bool claim);
  void openDirectly();

  std::filesystem::path path_;  // as the caller named it
  std::string shownPath_;       // the same, or "stdout"
  std::optional<TemporaryFile> temporary_;
  std::unique_ptr<std::FILE, Close> stream_;
  bool passesOn_ = false;  // what is in `stream_`
};

}  // namespace parhelion
