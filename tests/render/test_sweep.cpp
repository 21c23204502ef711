// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <atomic>
#include <stdexcept>

#include "picture/temporary_directory.h"
#include "render/scenes.h"
#include "render/sweep.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

const std::vector<std::vector<std::string>> kSuns{{"sun.elevation=10"}, {"sun.elevation=20"}, {"sun.elevation=30"}};

std::vector<SweepFrame> planIn(const TemporaryDirectory& folder, Gamut gamut = Gamut::exact) {
  return planFrames(kSuns, smallScene, FrameNames((folder / "f_%02d.exr").string()), 5, gamut);
}

std::vector<std::string> lacks(const std::vector<SweepFrame>& frames) {
  std::vector<std::string> all;
  for (const SweepFrame& frame : frames) all.push_back(frame.lacks);
  return all;
}

}  // namespace

TEST_CASE("names of frames hold their number once, as wide as asked, and anything else is refused") {
  CHECK(FrameNames("f_%d.exr")(12) == "f_12.exr");
  CHECK(FrameNames("f_%04d.exr")(12) == "f_0012.exr");
  CHECK(FrameNames("50%%_%02d.exr")(123) == "50%_123.exr");
  for (const char* bad : {"f.exr", "f_%d_%d.exr", "f_%4d.exr", "f_%x.exr", "f_%d.png", "f_%"})
    CHECK_THROWS_AS(FrameNames{bad}, std::invalid_argument);
}

TEST_CASE("a sweep that is stopped goes on to the same files, without a word printed") {
  const TemporaryDirectory halted, whole;
  Printed printed;
  std::atomic<bool> stop = false;
  std::vector<std::size_t> done;
  SweepControl control;
  control.trace.stop = &stop;
  control.onFrame = [&](std::size_t frame, double) {
    done.push_back(frame);
    stop = true;
  };
  const SweepReport first = renderFrames(planIn(halted), control);
  CHECK_FALSE(first.complete);
  CHECK(first.rendered == 1);
  CHECK(halted.names() == std::vector<std::string>{"f_05.exr"});

  stop = false;
  control.onFrame = [&](std::size_t frame, double) { done.push_back(frame); };
  const std::vector<SweepFrame> rest = planIn(halted);
  CHECK(lacks(rest) == std::vector<std::string>{"", "not there yet", "not there yet"});
  const SweepReport second = renderFrames(rest, control);
  CHECK(second.complete);
  CHECK(second.rendered == 2);
  CHECK(lacks(planIn(halted, Gamut::clip)) == std::vector<std::string>(3, "has another parhelion:gamut"));
  CHECK(done == std::vector<std::size_t>{0, 1, 2});
  CHECK(second.worstImbalance > 0.0);
  CHECK(second.worstImbalance < 1e-9);

  stop = true;
  CHECK_FALSE(writePreviews(planIn(halted), {{}, {}, &stop}));

  CHECK(renderFrames(planIn(whole), {}).rendered == 3);
  for (const TemporaryDirectory* folder : {&halted, &whole})
    CHECK(writePreviews(planIn(*folder), {{}, *folder / "sheet.png", nullptr}));
  CHECK(printed.text() == "");
  CHECK(lacks(planIn(halted)) == std::vector<std::string>(3));
  CHECK(whole.names().size() == 7);
  for (const std::string& name : whole.names()) CHECK_MESSAGE(contents(halted / name) == contents(whole / name), name);
}

TEST_CASE("previews and their sheet appear together or not at all") {
  const TemporaryDirectory folder;
  REQUIRE(renderFrames(planIn(folder), {}).complete);
  CHECK_THROWS_AS(writePreviews(planIn(folder), {{}, folder / "none/sheet.png", nullptr}), std::runtime_error);
  CHECK(folder.names().size() == 3);
  CHECK(writePreviews(planIn(folder), {{}, folder / "sheet.png", nullptr}));
  CHECK(folder.names().size() == 7);
}

TEST_CASE("previews of frames that were kept in memory are those of the files") {
  const TemporaryDirectory kept, read;
  REQUIRE(renderFrames(planIn(read), {}).complete);
  const std::vector<SweepFrame> frames = planIn(kept);
  SweepControl control;
  control.keptPictures = 2 * 3 * sizeof(float) * 48 * 32;  // two of three
  const SweepReport report = renderFrames(frames, control);
  REQUIRE(report.pictures.size() == 2);
  put(kept / "f_06.exr", "no picture any more");
  CHECK(writePreviews(frames, {{}, kept / "sheet.png", nullptr, 0, &report.pictures}));
  CHECK(writePreviews(planIn(read), {{}, read / "sheet.png", nullptr}));
  for (const char* name : {"f_05.png", "f_06.png", "f_07.png", "sheet.png"})
    CHECK_MESSAGE(contents(kept / name) == contents(read / name), name);
}

TEST_CASE("a sweep whose time is over renders nothing") {
  const TemporaryDirectory folder;
  SweepControl control;
  control.trace.timeLimit = 1e-9;
  const SweepReport report = renderFrames(planIn(folder), control);
  CHECK_FALSE(report.complete);
  CHECK(report.rendered == 0);
  CHECK(folder.names().empty());
}

TEST_CASE("a frame of another scene is rendered again, and what no render has written is left alone") {
  const TemporaryDirectory folder;
  REQUIRE(renderFrames(planIn(folder), {}).complete);
  std::filesystem::rename(folder / "f_05.exr", folder / "f_06.exr");
  CHECK(lacks(planIn(folder)) == std::vector<std::string>{"not there yet", "has another parhelion:scene", ""});

  put(folder / "f_07.png", "somebody's own");
  CHECK(errorOf([&] { planIn(folder); }).find("a sweep writes over nothing but pictures") != std::string::npos);
  std::filesystem::remove(folder / "f_07.png");
  put(folder / "f_06.exr", "somebody's own");
  CHECK(errorOf([&] { planIn(folder); }).find("f_06.exr") != std::string::npos);
}
