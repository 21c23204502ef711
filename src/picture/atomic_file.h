// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace parhelion {

/// The file a chain of symbolic links leads to, though it need not exist yet.
std::filesystem::path followLinks(std::filesystem::path path);

/// The open file of this process that a path stands for: 1 for /dev/stdout, 3 for /dev/fd/3.
std::optional<int> descriptorOf(const std::filesystem::path& path);

/// An output file that appears complete or not at all: it is written under a temporary name in the same directory and
/// renamed by commit(); without a commit the temporary file goes away and what was there before stays as it is.
/// Symbolic links are followed, an existing file's permissions kept. What is no regular file is written to directly: a
/// device at once; a pipe and an open descriptor (/dev/stdout, /dev/fd/3) at the commit, behind what went there before.
/// Every failure throws std::runtime_error "path: reason".
class AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(const void* data, std::size_t bytes);
  void write(std::string_view text) { write(text.data(), text.size()); }

  /// Position of the next write, in bytes from the start.
  std::uint64_t tell() const { return position_; }
  void seek(std::uint64_t position);

  /// Flushes to the disk and puts the file in its place. Throws if this or any earlier call failed, so that a library
  /// in between may swallow exceptions.
  void commit();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  [[noreturn]] void fail(int error);
  void openDirectly();
  void passOn();
  void openTemporary(unsigned mode, bool replaces);

  std::string shownPath_;            // as the caller named it
  std::filesystem::path target_;     // links followed
  std::filesystem::path temporary_;  // empty: writing to the target directly, or committed
  std::unique_ptr<std::FILE, Close> file_;
  bool passesOn_ = false;  // what is in `file_`, to the target at the commit
  std::uint64_t position_ = 0;
  int firstError_ = 0;  // errno, 0 so far so good
};

}  // namespace parhelion
