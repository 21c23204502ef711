// SPDX-License-Identifier: Apache-2.0
#include "picture/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <stdexcept>
#include <system_error>

namespace parhelion {
namespace {

constexpr int kMostLinks = 40;  // as the kernel does

/// A name beside the target that no other process and no other thread takes.
std::filesystem::path temporaryName(const std::filesystem::path& target) {
  static std::atomic<unsigned> counter{0};
  constexpr std::size_t kLongestStem = 200;  // names may have 255 bytes, the rest takes under 40
  const std::string stem = target.filename().string().substr(0, kLongestStem);
  return target.parent_path() /
         ("." + stem + "." + std::to_string(::getpid()) + "." + std::to_string(counter++) + ".tmp");
}

/// Makes a rename survive a power failure. Some file systems cannot; the data is complete either way.
void syncDirectory(const std::filesystem::path& directory) {
  const int fd = ::open(directory.empty() ? "." : directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) return;
  ::fsync(fd);
  ::close(fd);
}

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

}  // namespace

std::filesystem::path followLinks(std::filesystem::path path) {
  for (int i = 0; i < kMostLinks; ++i) {
    std::error_code none;
    const std::filesystem::path next = std::filesystem::read_symlink(path, none);
    if (none) return path;
    path = path.parent_path() / next;
  }
  return path;
}

std::optional<int> descriptorOf(const std::filesystem::path& path) {
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

AtomicFile::AtomicFile(const std::filesystem::path& path) : shownPath_(path.string()), target_(path) {
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) fail(errno);
  if (exists && S_ISDIR(status.st_mode)) fail(EISDIR);
  if (exists && ::access(path.c_str(), W_OK) != 0) fail(errno);
  if (exists && (!S_ISREG(status.st_mode) || descriptorOf(path).has_value())) {
    openDirectly();
  } else {
    target_ = followLinks(path);
    openTemporary(status.st_mode & 07777U, exists);
  }
}

AtomicFile::~AtomicFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::openDirectly() {
  // A picture's writer goes back to its beginning, which neither a pipe nor a file opened by others allows.
  passesOn_ = !std::filesystem::is_character_file(target_) || descriptorOf(target_).has_value();
  file_.reset(passesOn_ ? std::tmpfile() : std::fopen(target_.c_str(), "wbe"));
  if (!file_) fail(errno);
}

void AtomicFile::passOn() {
  const std::optional<int> descriptor = descriptorOf(target_);
  const int target = descriptor ? ::dup(*descriptor) : ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
  if (target < 0) fail(errno);
  const int failed = copyAll(file_.get(), target);
  const int unclosed = ::close(target) == 0 ? 0 : errno;
  if (failed != 0 || unclosed != 0) fail(failed != 0 ? failed : unclosed);
  passesOn_ = false;
}

void AtomicFile::openTemporary(unsigned mode, bool replaces) {
  std::filesystem::path name = temporaryName(target_);
  const int fd = ::open(name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (fd < 0) fail(errno);
  temporary_ = std::move(name);
  file_.reset(::fdopen(fd, "wb"));
  if (!file_ || (replaces && ::fchmod(fd, static_cast<mode_t>(mode)) != 0)) {
    const int error = errno;
    if (!file_) ::close(fd);
    ::unlink(temporary_.c_str());  // a constructor that throws has no destructor to do it
    fail(error);
  }
}

void AtomicFile::fail(int error) {
  if (firstError_ == 0) firstError_ = error;
  throw std::runtime_error(shownPath_ + ": " + std::generic_category().message(firstError_));
}

void AtomicFile::write(const void* data, std::size_t bytes) {
  if (firstError_ != 0) fail(firstError_);
  if (std::fwrite(data, 1, bytes, file_.get()) != bytes) fail(errno);
  position_ += bytes;
}

void AtomicFile::seek(std::uint64_t position) {
  if (firstError_ != 0) fail(firstError_);
  if (::fseeko(file_.get(), static_cast<off_t>(position), SEEK_SET) != 0) fail(errno);
  position_ = position;
}

void AtomicFile::commit() {
  if (firstError_ != 0) fail(firstError_);
  if (std::fflush(file_.get()) != 0) fail(errno);
  if (passesOn_) passOn();
  const bool direct = temporary_.empty();
  if (!direct && ::fsync(::fileno(file_.get())) != 0) fail(errno);
  if (std::fclose(file_.release()) != 0) fail(errno);
  if (direct) return;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
  syncDirectory(target_.parent_path());
}

}  // namespace parhelion
