// SPDX-License-Identifier: Apache-2.0
#include "picture/staged_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <stdexcept>
#include <system_error>

#include "picture/file_reason.h"

namespace parhelion {
namespace {

/// All bytes of a file to another, from the start. Returns errno, 0 if all went well.
int copyAll(std::FILE* from, int to) {
  std::rewind(from);
  std::array<char, 65536> block;
  while (const std::size_t bytes = std::fread(block.data(), 1, block.size(), from)) {
    for (std::size_t done = 0; done < bytes;) {
      const ::ssize_t more = ::write(to, block.data() + done, bytes - done);
      if (more < 0 && errno != EINTR) return errno;
      if (more > 0) done += static_cast<std::size_t>(more);
    }
  }
  return std::ferror(from) ? EIO : 0;
}

/// A file without a name. In memory where there is no place for temporary files.
std::FILE* namelessFile() {
  if (std::FILE* file = std::tmpfile()) return file;
  const int descriptor = ::memfd_create("parhelion", MFD_CLOEXEC);
  return descriptor < 0 ? nullptr : ::fdopen(descriptor, "w+b");
}

/// Whether a device can be written to as files are, back and forth: /dev/null can, a terminal cannot.
bool isSeekable(const std::filesystem::path& device) {
  const int descriptor = ::open(device.c_str(), O_WRONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool seekable = ::lseek(descriptor, 0, SEEK_CUR) == 0;
  ::close(descriptor);
  return seekable;
}

/// Whether it is the device on which there is never any room, /dev/full. Of other devices nobody knows what they take.
bool isAlwaysFull(const struct stat& device) {
  struct stat full {};
  return S_ISCHR(device.st_mode) && ::stat("/dev/full", &full) == 0 && S_ISCHR(full.st_mode) &&
         device.st_rdev == full.st_rdev;
}

/// Whether somebody else's file in a folder such as /tmp would be replaced, which only its owner may do.
bool isForeignInSticky(const std::filesystem::path& target, const struct stat& file) {
  struct stat folder {};
  const std::filesystem::path parent = target.has_parent_path() ? target.parent_path() : ".";
  if (::geteuid() == 0 || ::stat(parent.c_str(), &folder) != 0 || (folder.st_mode & S_ISVTX) == 0) return false;
  return file.st_uid != ::geteuid() && folder.st_uid != ::geteuid();
}

}  // namespace

std::optional<int> descriptorOf(const std::filesystem::path& path) {
  if (path == "-") return STDOUT_FILENO;
  constexpr int kMostLinks = 40;  // as the kernel does
  std::error_code none;
  const std::filesystem::path own = std::filesystem::canonical("/proc/self/fd", none);
  if (none) return {};
  // The last link leads out of the folder again, to the open file.
  std::filesystem::path step = path;
  for (int i = 0; i < kMostLinks; ++i) {
    const std::filesystem::path folder =
        std::filesystem::canonical(std::filesystem::absolute(step, none).parent_path(), none);
    const std::string name = step.filename().string();
    int descriptor = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), descriptor);
    if (!none && folder == own && error == std::errc{} && end == name.data() + name.size()) return descriptor;
    const std::filesystem::path next = std::filesystem::read_symlink(step, none);
    if (none) return {};
    step = step.parent_path() / next;
  }
  return {};
}

StagedFile::StagedFile(const std::filesystem::path& path, bool claim)
    : path_(path), shownPath_(path == "-" ? "stdout" : path.string()) {
  struct stat status {};
  const bool exists = (path == "-" ? ::fstat(STDOUT_FILENO, &status) : ::stat(path.c_str(), &status)) == 0;
  if (!exists && errno != ENOENT) fail(errno);
  const bool isOpen = descriptorOf(path).has_value();
  if (!path.has_filename() && !exists) throw std::runtime_error(shownPath_ + ": names a folder, not a file");
  if (!path.has_filename() || (exists && S_ISDIR(status.st_mode))) fail(EISDIR);
  if (exists && S_ISSOCK(status.st_mode) && !isOpen) fail(ENXIO);
  if (exists && !isOpen && ::access(path.c_str(), W_OK) != 0) fail(errno);
  if (claim && exists && isAlwaysFull(status)) fail(ENOSPC);
  if (exists && (!S_ISREG(status.st_mode) || isOpen)) {
    openDirectly();
  } else {
    if (exists && isForeignInSticky(followLinks(path), status)) fail(EPERM);
    openTemporary(claim);
  }
}

void StagedFile::openDirectly() {
  passesOn_ = descriptorOf(path_).has_value() || !std::filesystem::is_character_file(path_) || !isSeekable(path_);
  stream_.reset(passesOn_ ? namelessFile() : std::fopen(path_.c_str(), "wbe"));
  if (!stream_) fail(errno);
}

void StagedFile::openTemporary(bool claim) {
  const std::filesystem::path target = followLinks(path_);
  try {
    if (claim)
      temporary_.emplace(TemporaryFile::claim(target));
    else
      temporary_.emplace(target);
  } catch (const std::system_error& error) {
    fail(error.code().value());
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(shownPath_ + ": " + error.what());
  }
}

std::FILE* StagedFile::stream() {
  if (!stream_) {
    // The lock stays with the other descriptor when this one is closed.
    const int descriptor = ::fcntl(temporary_->descriptor(), F_DUPFD_CLOEXEC, 0);
    if (descriptor < 0) fail(errno);
    stream_.reset(::fdopen(descriptor, "wb"));
    if (!stream_) {
      ::close(descriptor);
      fail(ENOMEM);
    }
  }
  return stream_.get();
}

void StagedFile::complete() {
  if (std::fflush(stream()) != 0) fail(errno);
  if (passesOn_) return;
  if (temporary_) {
    struct stat before {};
    const int descriptor = temporary_->descriptor();
    if (::stat(temporary_->target().c_str(), &before) == 0 && ::fchmod(descriptor, before.st_mode & 07777U) != 0)
      fail(errno);
    if (::fsync(descriptor) != 0) fail(errno);
  }
  if (std::fclose(stream_.release()) != 0) fail(errno);
}

void StagedFile::passOn() {
  if (!passesOn_) return;
  std::fflush(stdout);  // what was printed comes before
  const std::optional<int> open = descriptorOf(path_);
  const int to = open ? ::fcntl(*open, F_DUPFD_CLOEXEC, 0) : ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
  if (to < 0) fail(errno);
  const int failed = copyAll(stream_.get(), to);
  const int unclosed = ::close(to) == 0 ? 0 : errno;
  if (failed != 0 || unclosed != 0) fail(failed != 0 ? failed : unclosed);
}

void StagedFile::place() {
  if (!temporary_) return;
  try {
    temporary_->place();
  } catch (const std::system_error& error) {
    fail(error.code().value());
  }
}

void StagedFile::undo() noexcept {
  if (temporary_) temporary_->undo();
}

std::optional<std::filesystem::path> StagedFile::folder() const {
  return temporary_ ? std::optional(temporary_->target().parent_path()) : std::nullopt;
}

void StagedFile::fail(int error) const { throw std::runtime_error(shownPath_ + ": " + reasonFor(path_, error)); }

}  // namespace parhelion
