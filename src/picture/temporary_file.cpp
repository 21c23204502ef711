// SPDX-License-Identifier: Apache-2.0
#include "picture/temporary_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <climits>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

namespace parhelion {
namespace {

constexpr int kMostLinks = 40;  // as the kernel does
constexpr std::size_t kRandomLetters = 10;
constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz234567";  // a power of two of them
constexpr std::string_view kEnding = ".tmp";

/// The names of all temporary files, where a signal handler can find them.
struct Slot {
  std::atomic<bool> taken{false}, named{false};
  std::array<char, PATH_MAX> name;
};
std::array<Slot, 64> slots;
std::atomic<bool> placing{false};

int registered(const std::string& name) {
  for (std::size_t i = 0; i < slots.size() && name.size() < PATH_MAX; ++i) {
    if (slots[i].taken.exchange(true)) continue;
    std::copy_n(name.c_str(), name.size() + 1, slots[i].name.begin());
    slots[i].named = true;
    return static_cast<int>(i);
  }
  return -1;
}

void unregister(int slot) {
  if (slot < 0) return;
  slots[static_cast<std::size_t>(slot)].named = false;
  slots[static_cast<std::size_t>(slot)].taken = false;
}

[[noreturn]] void failWith(int error) { throw std::system_error(error, std::generic_category()); }

/// FNV-1a, for what of a name is too long to be kept.
std::string sumOf(std::string_view text) {
  std::uint64_t sum = 0xCBF29CE484222325u;
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
  return std::to_string(sum);
}

/// What the names of all temporary files of a target begin with.
std::string stemOf(const std::filesystem::path& target) {
  constexpr std::size_t kLongest = 200;  // names may have 255 bytes, the rest takes under 50
  const std::string name = target.filename().string();
  return "." + (name.size() <= kLongest ? name : name.substr(0, kLongest - 20) + sumOf(name)) + ".";
}

std::string randomLetters() {
  std::array<unsigned char, kRandomLetters> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<::ssize_t>(bytes.size())) failWith(EIO);
  std::string letters;
  for (const unsigned char byte : bytes) letters += kLetters[byte % kLetters.size()];
  return letters;
}

/// The process in the name of a temporary file with that stem, "STEM1234-letters.tmp"; none if it is another file.
std::optional<pid_t> processIn(std::string_view name, std::string_view stem) {
  if (!name.starts_with(stem) || !name.ends_with(kEnding)) return {};
  name = name.substr(stem.size(), name.size() - stem.size() - kEnding.size());
  pid_t process = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), process);
  const std::string_view rest = name.substr(static_cast<std::size_t>(end - name.data()));
  const bool known = error == std::errc{} && rest.size() == kRandomLetters + 1 && rest[0] == '-' &&
                     rest.find_first_not_of(kLetters, 1) == std::string_view::npos;
  return known ? std::optional(process) : std::nullopt;
}

std::filesystem::path folderOf(const std::filesystem::path& target) {
  return target.has_parent_path() ? target.parent_path() : ".";
}

/// Holds a lock on a folder for the moment in which its temporary files are looked through and a new one is added. Goes
/// on without where there are no locks or somebody keeps one.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder)
      : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    constexpr int kTries = 400;
    constexpr std::chrono::milliseconds kPause(5);
    for (int i = 0; descriptor_ >= 0 && i < kTries; ++i) {
      if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
      std::this_thread::sleep_for(kPause);
    }
  }
  ~FolderLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

/// Removes a temporary file if nobody holds it. True if somebody does.
bool isHeld(const std::filesystem::path& file) {
  constexpr int kFlags = O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
  int descriptor = ::open(file.c_str(), O_RDWR | kFlags);  // NFS locks only what can be written
  if (descriptor < 0) descriptor = ::open(file.c_str(), O_RDONLY | kFlags);
  if (descriptor < 0) return false;
  struct stat status {};
  bool held = false;
  if (::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode)) {
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
      ::unlink(file.c_str());
    else
      held = errno == EWOULDBLOCK;
  }
  ::close(descriptor);
  return held;
}

/// Removes what dead processes have left of a target. The process that lives and writes it, if there is one.
std::optional<pid_t> writerOf(const std::filesystem::path& target) {
  const std::string stem = stemOf(target);
  std::optional<pid_t> writer;
  std::error_code none;  // a folder that cannot be read has no news
  for (std::filesystem::directory_iterator entry(folderOf(target), none), end; entry != end; entry.increment(none)) {
    const std::optional<pid_t> process = processIn(entry->path().filename().string(), stem);
    if (process && isHeld(entry->path())) writer = process;
  }
  return writer;
}

std::string processText(pid_t process) {
  if (process == ::getpid()) return "this process";
  const bool here = ::kill(process, 0) == 0 || errno == EPERM;
  return here ? "process " + std::to_string(process) : "a process of another machine or container";
}

/// Opens a new file, locked. Nobody can have removed it in between, as if it were of a dead process.
std::pair<std::filesystem::path, int> openedBeside(const std::filesystem::path& target) {
  constexpr int kTries = 100;
  for (int i = 0; i < kTries; ++i) {
    std::filesystem::path name = target.parent_path() / (stemOf(target) + std::to_string(::getpid()) + "-" +
                                                         randomLetters() + std::string(kEnding));
    const int descriptor = ::open(name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno == EEXIST) continue;
    if (descriptor < 0) failWith(errno);
    ::flock(descriptor, LOCK_EX | LOCK_NB);
    struct stat status {};
    if (::fstat(descriptor, &status) != 0 || status.st_nlink > 0) return {std::move(name), descriptor};
    ::close(descriptor);
  }
  failWith(EEXIST);
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

TemporaryFile::TemporaryFile(const std::filesystem::path& target) : target_(target) {
  std::tie(name_, descriptor_) = openedBeside(target);
  slot_ = registered(name_.string());
}

TemporaryFile TemporaryFile::claim(const std::filesystem::path& target) {
  const FolderLock lock(folderOf(target));
  if (const std::optional<pid_t> writer = writerOf(target))
    throw std::runtime_error("another run writes it (" + processText(*writer) + "); wait for that, or name another");
  return TemporaryFile(target);
}

TemporaryFile::TemporaryFile(TemporaryFile&& other) noexcept
    : target_(std::move(other.target_)),
      name_(std::move(other.name_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      state_(other.state_),
      slot_(std::exchange(other.slot_, -1)) {}

TemporaryFile& TemporaryFile::operator=(TemporaryFile&& other) noexcept {
  std::swap(target_, other.target_);
  std::swap(name_, other.name_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(state_, other.state_);
  std::swap(slot_, other.slot_);
  return *this;
}

TemporaryFile::~TemporaryFile() {
  if (descriptor_ < 0) return;
  if (state_ == State::temporary || state_ == State::swapped) ::unlink(name_.c_str());
  unregister(slot_);
  ::close(descriptor_);
}

void TemporaryFile::place() {
  struct stat status {};
  if (::lstat(target_.c_str(), &status) == 0) {
    if (S_ISDIR(status.st_mode)) failWith(EISDIR);
    if (::renameat2(AT_FDCWD, name_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0) {
      state_ = State::swapped;
      return;
    }
    if (::rename(name_.c_str(), target_.c_str()) != 0) failWith(errno);
    state_ = State::placed;
    return;
  }
  if (::rename(name_.c_str(), target_.c_str()) != 0) failWith(errno);
  state_ = State::placedAlone;
}

void TemporaryFile::undo() noexcept {
  if (state_ == State::swapped)
    ::renameat2(AT_FDCWD, name_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE);
  else if (state_ == State::placedAlone)
    ::rename(target_.c_str(), name_.c_str());
  else
    return;
  state_ = State::temporary;
}

void removeTemporaryFiles() noexcept {
  constexpr timespec kMoment{0, 1'000'000};  // ns
  while (placing) ::nanosleep(&kMoment, nullptr);
  for (const Slot& slot : slots)
    if (slot.named) ::unlink(slot.name.data());
}

Placing::Placing() {
  sigset_t all;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_BLOCK, &all, &before_);
  placing = true;
}

Placing::~Placing() {
  placing = false;
  ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void syncFolder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace parhelion
