// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <stdexcept>

#include "picture/memory_limit.h"
#include "temporary_directory.h"

namespace parhelion {
namespace {

/// Files as the kernel has them, of a machine of our own.
struct Machine : TemporaryDirectory {
  void file(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((*this / name).parent_path());
    put(*this / name, text);
  }
};

constexpr std::uint64_t kMega = 1'000'000;

}  // namespace

TEST_CASE("what the machine has free, with its swap space, is a limit") {
  const Machine machine;
  machine.file("proc/meminfo", "MemTotal: 8000 kB\nMemFree: 100 kB\nMemAvailable:   2000 kB\nSwapFree: 500 kB\n");
  const MemoryLimit limit = memoryLimit(machine.path());
  CHECK(limit.bytes == 2500 * 1024);
  CHECK(limit.by == "what the machine has free");
}

TEST_CASE("control groups of both versions count, with all that are above, less what they use but can give back") {
  const Machine second;
  second.file("proc/self/cgroup", "0::/farm/job\n");
  second.file("sys/fs/cgroup/farm/job/memory.max", "max\n");
  second.file("sys/fs/cgroup/farm/memory.max", "3000000\n");
  second.file("sys/fs/cgroup/farm/memory.current", "1500000\n");
  second.file("sys/fs/cgroup/farm/memory.stat", "anon 1\ninactive_file 500000\nactive_file 7\n");
  CHECK(memoryLimit(second.path()).bytes == 2 * kMega);
  CHECK(memoryLimit(second.path()).by == "the control group (cgroup)");

  const Machine first;
  first.file("proc/self/cgroup", "5:cpu,cpuacct:/x\n4:memory:/docker/1234\n0::/\n");
  first.file("sys/fs/cgroup/memory/memory.limit_in_bytes", "5000000\n");  // in a container the group is the root
  first.file("sys/fs/cgroup/memory/memory.usage_in_bytes", "1000000\n");
  CHECK(memoryLimit(first.path()).bytes == 4 * kMega);
}

TEST_CASE("a group that uses more than it may leaves nothing, and nobody's limit is none") {
  const Machine machine;
  CHECK(memoryLimit(machine.path()).bytes > 1'000'000 * kMega);
  machine.file("proc/self/cgroup", "0::/\n");
  machine.file("sys/fs/cgroup/memory.max", "10\n");
  machine.file("sys/fs/cgroup/memory.current", "20\n");
  CHECK(memoryLimit(machine.path()).bytes == 0);
}

TEST_CASE("what the user says is the limit, and what needs more is refused in words") {
  setMemoryLimit(1);
  const Machine machine;
  machine.file("proc/self/statm", "100 0 0 0 0 0 0\n");
  CHECK(memoryLimit(machine.path()).bytes == 1);
  CHECK(errorOf([] { requireMemory("the picture", 3'100'000'000); }) ==
        "the picture needs about 3.1 GB of memory, 0 bytes are allowed by --memory");
  setMemoryLimit(0);
  CHECK(errorOf([] { requireMemory("the picture", 1000); }) == "");
}

TEST_CASE("bytes are told with two digits") {
  CHECK(byteText(0) == "0 bytes");
  CHECK(byteText(999) == "999 bytes");
  CHECK(byteText(1000) == "1.0 kB");
  CHECK(byteText(9960) == "10 kB");
  CHECK(byteText(999'600) == "1.0 MB");
  CHECK(byteText(3'140'000'000) == "3.1 GB");
}

}  // namespace parhelion
