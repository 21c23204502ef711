// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <functional>
#include <vector>

#include "picture/atomic_file.h"
#include "temporary_directory.h"

namespace parhelion {
namespace {

void write(const Output& output, const std::string& text) {
  AtomicFile file(output);
  file.write(text);
  file.commit();
}

/// Calls `work` in another process, which then waits to be killed. The destructor kills it, as a power cut would.
class OtherRun {
 public:
  explicit OtherRun(const std::function<void()>& work) {
    int ready[2];
    REQUIRE(::pipe(ready) == 0);
    process_ = ::fork();
    if (process_ == 0) {
      work();
      [[maybe_unused]] const auto told = ::write(ready[1], "!", 1);
      for (;;) ::pause();
    }
    ::close(ready[1]);
    char mark = 0;
    REQUIRE(::read(ready[0], &mark, 1) == 1);
    ::close(ready[0]);
  }
  ~OtherRun() { kill(); }
  OtherRun(const OtherRun&) = delete;
  OtherRun& operator=(const OtherRun&) = delete;

  void kill() {
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
    process_ = 0;
  }
  pid_t process() const { return process_; }

 private:
  pid_t process_ = 0;
};

}  // namespace

TEST_CASE("the files of a transaction appear together at its commit") {
  const TemporaryDirectory directory;
  put(directory / "a", "old a");
  Transaction run;
  run.claim(directory / "a");
  run.claim(directory / "b");
  write(run.at(directory / "a"), "new a");
  write(run.at(directory / "b"), "new b");
  write(run.at(directory / "c"), "not claimed");
  CHECK(contents(directory / "a") == "old a");
  CHECK_FALSE(std::filesystem::exists(directory / "b"));
  run.commit();
  CHECK(contents(directory / "a") == "new a");
  CHECK(contents(directory / "b") == "new b");
  CHECK(contents(directory / "c") == "not claimed");
  CHECK(directory.names().size() == 3);
}

TEST_CASE("without a commit a transaction leaves files and folders as they were") {
  const TemporaryDirectory directory;
  put(directory / "a", "old a");
  {
    Transaction run;
    run.makeFolder(directory / "new");
    run.claim(directory / "a");
    run.claim(directory / "new" / "b");
    write(run.at(directory / "a"), "new a");
    write(run.at(directory / "new" / "b"), "new b");
  }
  CHECK(contents(directory / "a") == "old a");
  CHECK(directory.names().size() == 1);
}

TEST_CASE("what cannot be placed has all files before it taken back") {
  const TemporaryDirectory directory;
  put(directory / "a", "old a");
  std::filesystem::create_directory(directory / "gone");
  {
    Transaction run;
    for (const char* name : {"a", "b", "gone/c"}) write(run.at(directory / name), std::string("new ") + name);
    std::filesystem::rename(directory / "gone", directory / "moved");
    CHECK(errorOf([&] { run.commit(); }) ==
          (directory / "gone" / "c").string() + ": the folder " + (directory / "gone").string() + " does not exist");
  }
  CHECK(contents(directory / "a") == "old a");
  CHECK_FALSE(std::filesystem::exists(directory / "b"));
  CHECK(directory.names().size() == 2);
}

TEST_CASE("pipes get theirs before the first file is renamed") {
  const TemporaryDirectory directory;
  Transaction run;
  write(run.at(directory / "a"), "a");
  const int full = ::open("/dev/full", O_WRONLY);
  write(run.at("/dev/fd/" + std::to_string(full)), "too much");
  CHECK_THROWS_AS(run.commit(), std::runtime_error);
  CHECK_FALSE(std::filesystem::exists(directory / "a"));
  ::close(full);
}

TEST_CASE("a file is claimed by one run at a time, whatever it is called, until that run ends or dies") {
  const TemporaryDirectory directory;
  std::filesystem::create_directory(directory / "far");
  std::filesystem::create_symlink("far/target", directory / "link");
  std::filesystem::create_directory_symlink("far", directory / "near");
  Transaction run;
  const auto claim = [&](const std::string& name) {
    return errorOf([&] {
      Transaction second;
      second.claim(directory / name);
    });
  };
  OtherRun other([&] { run.claim(directory / "far" / "target"); });
  for (const char* name : {"far/target", "link", "near/target", "far/../far/./target"})
    CHECK(claim(name) == (directory / name).string() + ": another run writes it (process " +
                             std::to_string(other.process()) + "); wait for that, or name another");
  CHECK(claim("far/other") == "");
  other.kill();
  CHECK(claim("link") == "");
  CHECK(std::filesystem::is_empty(directory / "far"));
}

TEST_CASE("of many runs that claim a file at the same time one gets it") {
  const TemporaryDirectory directory;
  constexpr int kRuns = 20;
  int start[2];
  REQUIRE(::pipe(start) == 0);
  std::vector<pid_t> runs;
  for (int i = 0; i < kRuns; ++i) {
    runs.push_back(::fork());
    if (runs.back() != 0) continue;
    char mark = 0;
    [[maybe_unused]] const auto go = ::read(start[0], &mark, 1);
    Transaction run;
    const bool refused = !errorOf([&] { run.claim(directory / "a"); }).empty();
    put(directory / ((refused ? "refused" : "claimed") + std::to_string(i)), "");
    for (;;) ::pause();  // the claim must last until all have tried
  }
  REQUIRE(::write(start[1], std::string(kRuns, '!').data(), kRuns) == kRuns);
  const auto count = [&](const char* what) {
    const auto names = directory.names();
    return std::count_if(names.begin(), names.end(), [&](const auto& name) { return name.starts_with(what); });
  };
  for (int tries = 0; count("refused") + count("claimed") < kRuns && tries < 3000; ++tries) ::usleep(10'000);
  CHECK(count("claimed") == 1);
  CHECK(count("refused") == kRuns - 1);
  for (const pid_t process : runs) {
    ::kill(process, SIGKILL);
    ::waitpid(process, nullptr, 0);
  }
  ::close(start[0]);
  ::close(start[1]);
}

TEST_CASE("the next claim removes what killed runs have left of its file, and of no other") {
  const TemporaryDirectory directory;
  for (int i = 0; i < 3; ++i)
    OtherRun([&] {
      static Transaction run;
      write(run.at(directory / "a"), "half");
      write(run.at(directory / "a.b"), "half");
    });
  OtherRun living([&] {
    static Transaction run;
    run.claim(directory / "c");
  });
  put(directory / ".a.tmp", "of somebody else");
  put(directory / ".a.1-x.tmp", "of somebody else");
  CHECK(directory.names().size() == 9);
  for (const char* name : {"a", "c"}) {
    Transaction run;
    if (name[0] == 'a')
      run.claim(directory / name);
    else
      CHECK_THROWS(run.claim(directory / name));
  }
  CHECK(directory.names().size() == 6);  // the two of others, that of c, three of a.b
}

TEST_CASE("names of any length are told apart, and names that are too long are told") {
  const TemporaryDirectory directory;
  const std::string longest(254, 'n');
  Transaction run;
  run.claim(directory / (longest + "1"));
  run.claim(directory / (longest + "2"));
  CHECK(errorOf([&] { run.claim(directory / (longest + "12")); }).ends_with(": File name too long"));
  for (const char* end : {"1", "2"}) write(run.at(directory / (longest + end)), end);
  run.commit();
  CHECK(contents(directory / (longest + "2")) == "2");
}

}  // namespace parhelion
