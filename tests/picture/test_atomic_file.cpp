// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <stdexcept>

#include "picture/atomic_file.h"
#include "temporary_directory.h"

namespace parhelion {

TEST_CASE("a file appears when it is committed, and not before") {
  const TemporaryDirectory directory;
  const auto path = directory / "out.txt";
  {
    AtomicFile file(path);
    file.write("halo ......");
    file.seek(5);
    file.write("22");
    CHECK(file.tell() == 7);
    CHECK_FALSE(std::filesystem::exists(path));
    file.seek(7);
    file.commit();
  }
  CHECK(contents(path) == "halo 22....");
  CHECK(directory.names().size() == 1);
}

TEST_CASE("without a commit the old file stays and no temporary file is left") {
  const TemporaryDirectory directory;
  const auto path = directory / "out.txt";
  put(path, "precious");
  {
    AtomicFile file(path);
    file.write("half of");
    CHECK(directory.names().size() == 2);
  }
  CHECK(contents(path) == "precious");
  CHECK(directory.names().size() == 1);
}

TEST_CASE("an existing file keeps its permissions, a new one gets those of the umask") {
  const TemporaryDirectory directory;
  const auto mode = [](const std::filesystem::path& path) {
    struct stat status {};
    REQUIRE(::stat(path.c_str(), &status) == 0);
    return status.st_mode & 07777U;
  };
  const auto writeTo = [](const std::filesystem::path& path) {
    AtomicFile file(path);
    file.write("x");
    file.commit();
  };
  put(directory / "old", "y");
  ::chmod((directory / "old").c_str(), 0640);
  const mode_t before = ::umask(0027);
  writeTo(directory / "old");
  writeTo(directory / "new");
  ::umask(before);
  CHECK(mode(directory / "old") == 0640);
  CHECK(mode(directory / "new") == 0640);
  ::chmod((directory / "old").c_str(), 0604);
  writeTo(directory / "old");
  CHECK(mode(directory / "old") == 0604);
}

TEST_CASE("links are followed, whether their target exists or not") {
  const TemporaryDirectory directory;
  std::filesystem::create_directory(directory / "far");
  std::filesystem::create_symlink("far/target", directory / "link");
  for (const char* text : {"first", "second"}) {
    AtomicFile file(directory / "link");
    file.write(text);
    file.commit();
    CHECK(std::filesystem::is_symlink(directory / "link"));
    CHECK(contents(directory / "far" / "target") == text);
  }
}

TEST_CASE("a missing directory, a directory and a full disk are told with path and reason") {
  const TemporaryDirectory directory;
  const auto missing = directory / "none" / "out";
  CHECK(errorOf([&] { AtomicFile file(missing); }) == noFolderFor(missing));
  CHECK(errorOf([&] { AtomicFile file(directory / "."); }).find("Is a directory") != std::string::npos);
  CHECK(errorOf([] {
          AtomicFile file("/dev/full");
          file.write("x");
          file.commit();
        }) == "/dev/full: No space left on device");
}

TEST_CASE("a failure that a library swallows comes up again at the commit") {
  AtomicFile file("/dev/full");
  const std::string much(1 << 20, 'x');
  CHECK_THROWS_AS(file.write(much), std::runtime_error);
  CHECK_THROWS_AS(file.commit(), std::runtime_error);
}

TEST_CASE("a pipe is written to directly") {
  const TemporaryDirectory directory;
  const auto path = directory / "pipe";
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK);
  AtomicFile file(path);
  file.write("through");
  file.commit();
  char text[8] = {};
  CHECK(::read(reader, text, 7) == 7);
  CHECK(std::string(text) == "through");
  ::close(reader);
  CHECK(std::filesystem::is_fifo(path));
}

TEST_CASE("a pipe gets nothing without a commit, and what was written out of order comes in order") {
  const TemporaryDirectory directory;
  const auto path = directory / "pipe";
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK);
  { AtomicFile(path).write("half of"); }
  AtomicFile file(path);
  file.write("halo ......");
  file.seek(5);
  file.write("22");
  file.commit();
  char text[32] = {};
  CHECK(::read(reader, text, 31) == 11);
  CHECK(std::string(text) == "halo 22....");
  ::close(reader);
}

TEST_CASE("an open file goes on where it is, also through links") {
  const TemporaryDirectory directory;
  put(directory / "log", "before ");
  const int log = ::open((directory / "log").c_str(), O_WRONLY | O_APPEND);
  REQUIRE(log >= 0);
  const std::string name = "/dev/fd/" + std::to_string(log);
  std::filesystem::create_symlink(name, directory / "link");
  for (const std::filesystem::path& path : {std::filesystem::path(name), directory / "link"}) {
    CHECK(descriptorOf(path) == log);
    AtomicFile file(path);
    file.write("22 ");
    file.commit();
  }
  ::close(log);
  CHECK(contents(directory / "log") == "before 22 22 ");
  CHECK(descriptorOf("/dev/stdout") == 1);
  for (const char* none : {"", "1", "/dev/null", "/proc/self/status"}) CHECK_FALSE(descriptorOf(none));
}

}  // namespace parhelion
