// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string_view>

#include "picture/transaction.h"

namespace parhelion {

/// An output file that appears complete or not at all: it is written under a temporary name in the same folder and
/// renamed by commit(), or with the other files of its transaction. Without a commit the temporary file goes away and
/// what was there before stays as it is. Symbolic links are followed, an existing file's permissions kept. Pipes and
/// open descriptors (/dev/stdout, /dev/fd/3, "-") get all of it at the commit, behind what went there before; devices
/// are written to directly. Every failure throws std::runtime_error "path: reason".
class AtomicFile {
 public:
  explicit AtomicFile(const Output& output);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(const void* data, std::size_t bytes);
  void write(std::string_view text) { write(text.data(), text.size()); }

  /// Position of the next write, in bytes from the start.
  std::uint64_t tell() const { return position_; }
  void seek(std::uint64_t position);

  /// Flushes to the disk and puts the file in its place, or gives it to its transaction. Throws if this or any earlier
  /// call failed, so that a library in between may swallow exceptions.
  void commit();

 private:
  [[noreturn]] void fail(int error);

  Transaction* transaction_;
  StagedFile file_;
  std::FILE* stream_;
  std::uint64_t position_ = 0;
  int firstError_ = 0;  // errno, 0 so far so good
};

}  // namespace parhelion
