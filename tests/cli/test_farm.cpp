// SPDX-License-Identifier: Apache-2.0
// The recipes for farms work as they stand, with plain processes in place of the farm's.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "shell.h"

using namespace parhelion::test;

namespace {

const std::filesystem::path kFarm = std::filesystem::path(PARHELION_SOURCE_DIR) / "docs/farm";

/// A folder with a small scene, and the program where the recipes look for it.
struct Farm : Folder {
  Farm() {
    std::filesystem::create_directory(*this / "bin");
    std::filesystem::create_directory(*this / "farm");
    std::filesystem::create_symlink(PARHELION_BINARY, *this / "bin/parhelion");
    writeFile(*this / "scene.toml",
              "[[population]]\nshape = 'prism'\naspect = 0.2\norientation = 'plate'\n"
              "[camera]\nprojection = 'fisheye-equal-area'\nelevation = 90\nfov_horizontal = 180\n"
              "resolution = [40, 40]\n[trace]\nrays = 40_000\n");
  }

  /// A program of the farm, as a shell script.
  void standIn(const std::string& name, const std::string& script) {
    writeFile(*this / "bin" / name, "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(*this / "bin" / name, std::filesystem::perms::owner_all);
  }

  Outcome shell(const std::string& command) {
    return run(*this, "export PATH=$PWD/bin:$PATH && unset -f parhelion && " + command);
  }
};

/// The text between two marks, from `from` on, which is set behind it; empty at the end.
std::string between(const std::string& text, std::size_t& from, const std::string& open, const std::string& close) {
  const std::size_t begin = text.find(open, from);
  if (begin == std::string::npos) return {};
  const std::size_t end = text.find(close, begin);
  from = end + close.size();
  return text.substr(begin + open.size(), end - begin - open.size());
}

void replaceAll(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
}

}  // namespace

TEST_CASE("a Slurm array traces all slices, and a task that is stopped is queued again and goes on") {
  Farm farm;
  farm.standIn("srun", "exec \"$@\"");
  farm.standIn("scontrol", "echo \"$*\" >>requeued");
  const auto task = [&](int k) {
    return farm.shell("SLURM_ARRAY_JOB_ID=7 SLURM_ARRAY_TASK_ID=" + std::to_string(k) +
                      " SLURM_ARRAY_TASK_COUNT=3 SLURM_CPUS_PER_TASK=1 sh '" + (kFarm / "slurm-array.sh").string() +
                      "' scene.toml farm");
  };
  // Of the second task the first attempt is stopped by the farm at once.
  farm.standIn("srun", "\"$@\" -D trace.rays=4_000_000_000 & sleep 0.5; kill -TERM $!; wait $!");
  CHECK(task(2).exit == 75);
  CHECK(readFile(farm / "requeued") == "requeue 7_2\n");
  std::filesystem::remove(farm / "farm/slice-2.tally.exr");
  farm.standIn("srun", "exec \"$@\"");
  for (const int k : {2, 1, 3}) {
    const Outcome outcome = task(k);
    CHECK_MESSAGE(outcome.exit == 0, outcome.err);
  }
  CHECK(farm.shell("parhelion merge farm/slice-*.tally.exr --complete -o sum.tally.exr").exit == 0);
  CHECK(farm.shell("parhelion trace scene.toml -o whole.tally.exr && cmp sum.tally.exr whole.tally.exr").exit == 0);
}

TEST_CASE("an OpenCue job traces all slices and makes their picture") {
  Farm farm;
  const std::string job = readFile(kFarm / "opencue.xml");
  std::vector<std::string> commands;
  for (std::size_t at = 0;;) {
    std::string command = between(job, at, "<cmd>", "</cmd>");
    if (command.empty()) break;
    const std::string range = between(job, at, "<range>", "</range>");
    replaceAll(command, "&amp;", "&");
    // A twentieth of the slices.
    replaceAll(command, "/64", "/3");
    const int last = range == "1-64" ? 3 : 1;
    for (int frame = 1; frame <= last; ++frame) {
      commands.push_back(command);
      replaceAll(commands.back(), "#IFRAME#", std::to_string(frame));
    }
  }
  REQUIRE(commands.size() == 4);
  for (const std::string& command : commands) {
    const Outcome outcome = farm.shell(command);
    CHECK_MESSAGE(outcome.exit == 0, command << "\n" << outcome.err);
  }
  CHECK(std::filesystem::exists(farm / "farm/halo.exr"));
  CHECK(farm.shell("parhelion trace scene.toml -o whole.tally.exr && cmp farm/whole.tally.exr whole.tally.exr").exit ==
        0);
}
