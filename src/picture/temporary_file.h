// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signal.h>
#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>

namespace parhelion {

/// The file a chain of symbolic links leads to, though it need not exist yet.
std::filesystem::path followLinks(std::filesystem::path path);

/// An empty file beside the one that it is to become, its target. Its name is known from the target's, but cannot be
/// guessed. While its process lives it is locked (flock), so that others can tell it from what a dead process has left.
/// File systems without locks do without: there nothing of the dead is removed, and nobody is waited for.
class TemporaryFile {
 public:
  /// For a target whose links have been followed. Throws std::system_error.
  explicit TemporaryFile(const std::filesystem::path& target);

  /// The same, but throws std::runtime_error, "another run writes it (process 1234)", where a process that lives, this
  /// one included, has a temporary file for that target already. Removes those that dead processes have left. Of two
  /// processes that come at the same time one succeeds.
  static TemporaryFile claim(const std::filesystem::path& target);

  /// Removes the file if it has not become its target.
  ~TemporaryFile();
  TemporaryFile(TemporaryFile&& other) noexcept;
  TemporaryFile& operator=(TemporaryFile&& other) noexcept;

  /// Open for reading and writing, closed on exec. The lock lasts as long as it is open.
  int descriptor() const { return descriptor_; }

  const std::filesystem::path& target() const { return target_; }

  /// Becomes the target. What was there is kept as the temporary file, where the file system can swap names, so that
  /// undo() can bring it back until the destructor removes it. Throws std::system_error.
  void place();

  /// Takes place() back as far as that can be done.
  void undo() noexcept;

 private:
  enum class State { temporary, swapped, placed, placedAlone };

  std::filesystem::path target_, name_;
  int descriptor_ = -1;
  State state_ = State::temporary;
  int slot_ = -1;  // among the names known to removeTemporaryFiles()
};

/// For a signal handler that ends the program: waits until no file is being placed, and removes all temporary files of
/// this process. Files beyond the first 64 at a time are left to the next run.
void removeTemporaryFiles() noexcept;

/// While it lives files are being placed, which no signal to this thread interrupts.
class Placing {
 public:
  Placing();
  ~Placing();
  Placing(const Placing&) = delete;
  Placing& operator=(const Placing&) = delete;

 private:
  sigset_t before_;
};

/// Makes renames in a folder survive a power failure. Some file systems cannot; the data is complete either way.
void syncFolder(const std::filesystem::path& folder);

}  // namespace parhelion
