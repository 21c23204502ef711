// SPDX-License-Identifier: Apache-2.0
#include "picture/atomic_file.h"

#include <cerrno>
#include <utility>

namespace parhelion {

AtomicFile::AtomicFile(const Output& output)
    : transaction_(output.transaction),
      file_(transaction_ ? transaction_->take(output.path) : StagedFile(output.path, false)),
      stream_(file_.stream()) {}

void AtomicFile::fail(int error) {
  if (firstError_ == 0) firstError_ = error;
  file_.fail(firstError_);
}

void AtomicFile::write(const void* data, std::size_t bytes) {
  if (firstError_ != 0) fail(firstError_);
  if (std::fwrite(data, 1, bytes, stream_) != bytes) fail(errno);
  position_ += bytes;
}

void AtomicFile::seek(std::uint64_t position) {
  if (firstError_ != 0) fail(firstError_);
  if (::fseeko(stream_, static_cast<off_t>(position), SEEK_SET) != 0) fail(errno);
  position_ = position;
}

void AtomicFile::commit() {
  if (firstError_ != 0) fail(firstError_);
  file_.complete();
  if (transaction_) return transaction_->stage(std::move(file_));
  Transaction alone;
  alone.stage(std::move(file_));
  alone.commit();
}

}  // namespace parhelion
