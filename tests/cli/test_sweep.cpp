// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <array>
#include <set>
#include <vector>

#include "picture/exr.h"
#include "picture/photograph.h"
#include "shell.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

const std::string kScene = R"(
[sun]
elevation = 20.0
spectrum = 550.0
[[population]]
name = "plates"
aspect = 0.3
orientation = "plate"
tilt = 1.0
[camera]
resolution = [48, 48]
[trace]
rays = "20k"
)";

struct WithScene : Folder {
  WithScene() { writeFile(*this / "s.toml", kScene); }
};

std::filesystem::file_time_type age(const Folder& folder, const std::string& name) {
  return std::filesystem::last_write_time(folder / name);
}

int framesIn(const Folder& folder) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    count += entry.path().extension() == ".exr" ? 1 : 0;
  return count;
}

/// Width and height of a PNG, from its header.
std::array<int, 2> sizeOfPng(const std::string& bytes) {
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = 256 * value + static_cast<unsigned char>(bytes.at(i));
    return value;
  };
  return {number(16), number(20)};
}

}  // namespace

TEST_CASE("the frames of a sweep are the pictures that render makes, bit by bit") {
  WithScene folder;
  const Outcome sweep =
      run(folder, "parhelion sweep s.toml sun.elevation=10:12:1 population.plates.tilt=3,2,1 -o f_%02d.exr --seed 9");
  CHECK(sweep.exit == 0);
  CHECK(sweep.out.empty());
  CHECK(sweep.err.find("frame 2 of 3: sun.elevation=11, population.plates.tilt=2, ") != std::string::npos);
  for (const std::string name : {"f_00", "f_01", "f_02"}) {
    const int i = name.back() - '0';
    REQUIRE(run(folder, "parhelion render s.toml --quiet --seed 9 -o r.exr --nthreads 1 -D sun.elevation=" +
                            std::to_string(10 + i) + " -D population.plates.tilt=" + std::to_string(3 - i))
                .exit == 0);
    CHECK(readFile(folder / (name + ".exr")) == readFile(folder / "r.exr"));
  }
}

TEST_CASE("a sweep steps through the hours of a day, each frame with the sun of its moment") {
  WithScene folder;
  const std::string place = " -D sun.latitude=47.42 -D sun.longitude=10.98 ";
  REQUIRE(run(folder, "parhelion sweep s.toml sun.date=2026-12-21T09:30:00+01:00:2026-12-21T11:30:00+01:00:2h" + place +
                          "-o f_%d.exr --rays 1k --quiet")
              .exit == 0);
  CHECK(framesIn(folder) == 2);
  for (const auto& [frame, date] :
       {std::pair{"f_0.exr", "2026-12-21T09:30:00+01:00"}, {"f_1.exr", "2026-12-21T11:30:00+01:00"}}) {
    CHECK(run(folder, std::string("parhelion info --scene ") + frame).out.find(std::string("date = ") + date) !=
          std::string::npos);
    const std::string told = run(folder, "parhelion check s.toml -D sun.date=" + std::string(date) + place).out;
    CHECK(told.find("s.toml: ok, the sun at elevation ") == 0);
    const std::string elevation =
        told.substr(told.find("elevation ") + 10, told.find("°") - told.find("elevation ") - 10);
    CHECK(run(folder, std::string("parhelion info ") + frame).out.find("elevation " + elevation + "°") !=
          std::string::npos);
    REQUIRE(run(folder, "parhelion render s.toml --rays 1k --quiet -o r.exr -D sun.elevation=" + elevation).exit == 0);
    CHECK(*readExr(folder / "r.exr").image.find("G") == *readExr(folder / frame).image.find("G"));
  }
}

TEST_CASE("with --product the last key runs fastest, and --first numbers the frames") {
  WithScene folder;
  REQUIRE(run(folder,
              "parhelion sweep s.toml --product sun.elevation=10,20 trace.seed=1:3:1 -o f%d.exr --first 98 "
              "--rays 1k --quiet")
              .err.empty());
  CHECK(framesIn(folder) == 6);
  for (int i = 0; i < 6; ++i) {
    const std::string scene = run(folder, "parhelion info --scene f" + std::to_string(98 + i) + ".exr").out;
    CHECK(scene.find("elevation = " + std::to_string(i < 3 ? 10 : 20) + "\n") != std::string::npos);
    CHECK(scene.find("seed = " + std::to_string(i % 3 + 1) + "\n") != std::string::npos);
  }
}

TEST_CASE("what is there already is not rendered again, what differs is") {
  WithScene folder;
  const std::string sweep = "parhelion sweep s.toml sun.elevation=10:13:1 -o f_%d.exr ";
  CHECK(run(folder, sweep).err.find("4 frames: 0 skipped, 4 to render (f_0.exr: not there yet)") != std::string::npos);
  const auto before = age(folder, "f_2.exr");
  const std::string bytes = readFile(folder / "f_2.exr");
  CHECK(run(folder, sweep).err.find("4 frames: 4 skipped, 0 to render\n") != std::string::npos);
  CHECK(age(folder, "f_2.exr") == before);

  // Half a file and another sun: two frames of four.
  REQUIRE(run(folder,
              "head -c 3000 f_2.exr > cut && mv cut f_2.exr && "
              "parhelion render s.toml -D sun.elevation=40 -o f_3.exr --quiet")
              .exit == 0);
  const std::string mended = run(folder, sweep).err;
  CHECK(mended.find("4 frames: 2 skipped, 2 to render (f_2.exr: is damaged: ") != std::string::npos);
  CHECK(mended.find("frame 3 of 4: sun.elevation=12") != std::string::npos);
  CHECK(mended.find("frame 1 of 4") == std::string::npos);
  CHECK(readFile(folder / "f_2.exr") == bytes);

  for (const auto& [change, why] : {std::pair<std::string, std::string>{"--rays 10k", "parhelion:rays"},
                                    {"--rays 10k --seed 5", "parhelion:seed"},
                                    {"--rays 10k --seed 5 -D population.0.aspect=0.4", "parhelion:scene"}}) {
    const std::string changed = run(folder, sweep + change).err;
    CHECK_MESSAGE(changed.find("0 skipped, 4 to render (f_0.exr: has another " + why) != std::string::npos, changed);
  }
}

TEST_CASE("an interrupted sweep keeps its finished frames and goes on to the same bits") {
  WithScene folder;
  // The second frame takes long enough to be caught.
  const std::string sweep = " sweep s.toml trace.rays=10000,3000000,20000 -o ";
  const Outcome outcome = run(folder, "{ '" PARHELION_BINARY "'" + sweep +
                                          "f_%d.exr & pid=$!; while kill -0 $pid && ! [ -s f_0.exr ]; do sleep 0.01; "
                                          "done; kill -INT $pid; wait $pid; }");
  REQUIRE(outcome.exit == 75);
  CHECK(outcome.err.find("interrupted: finished frames stay") != std::string::npos);
  CHECK(framesIn(folder) == 1);
  CHECK_FALSE(std::filesystem::exists(folder / "f_0.png"));

  CHECK(run(folder, "parhelion" + sweep + "f_%d.exr").err.find("3 frames: 1 skipped") != std::string::npos);
  REQUIRE(run(folder, "parhelion" + sweep + "g_%d.exr").exit == 0);
  for (const std::string i : {"0", "1", "2"})
    for (const std::string kind : {".exr", ".png"})
      CHECK(readFile(folder / ("f_" + i + kind)) == readFile(folder / ("g_" + i + kind)));
}

TEST_CASE("a frame that the time limit cuts short is not written") {
  WithScene folder;
  const Outcome outcome = run(folder, "parhelion sweep s.toml sun.elevation=10,20 -o f_%d.exr --rays 10G --time 0.3");
  CHECK(outcome.exit == 75);
  CHECK(framesIn(folder) == 0);
  CHECK(outcome.err.find("the same command goes on") != std::string::npos);
}

TEST_CASE("a sweep writes over nothing but pictures of parhelion, and looks before it renders") {
  WithScene folder;
  REQUIRE(
      run(folder, "parhelion map s.toml -o map.exr --step 10 --quiet && parhelion trace s.toml -o tally.exr --quiet")
          .exit == 0);
  REQUIRE(run(folder,
              "parhelion render s.toml -o halo.exr --quiet && parhelion composite halo.png --halo halo.exr "
              "--projection fisheye-equal-area --fov-horizontal 180 --azimuth 0 --elevation 90 --all-sky --strength 1 "
              "-o composite.exr --quiet")
              .exit == 0);
  writeFile(folder / "text", "my diary");
  for (const std::string mine : {"text", "tally.exr", "map.exr", "composite.exr"}) {
    const std::string before = readFile(folder / mine);
    std::filesystem::copy_file(folder / mine, folder / "f_2.exr", std::filesystem::copy_options::overwrite_existing);
    const Outcome outcome = run(folder, "parhelion sweep s.toml sun.elevation=1:3:1 -o f_%d.exr");
    CHECK(outcome.exit == 1);
    CHECK_MESSAGE(outcome.err.find("writes over nothing but pictures") != std::string::npos, outcome.err);
    CHECK(lines(outcome.err) == 1);
    CHECK_FALSE(std::filesystem::exists(folder / "f_0.exr"));
    CHECK(readFile(folder / "f_2.exr") == before);
  }
}

TEST_CASE("a picture in the place of a preview that is none is not written over, nothing is rendered") {
  WithScene folder;
  REQUIRE(
      run(folder, "parhelion render s.toml -o halo.exr --quiet && parhelion view halo.exr -o view.png --quiet").exit ==
      0);
  writeFile(folder / "text", "my diary");
  // A picture without a word in it.
  parhelion::Photograph picture;
  picture.width = picture.height = 4;
  picture.samples = std::vector<std::uint8_t>(48, 100);
  parhelion::writePhotograph(folder / "own.png", picture, {});
  const std::string sweep = "parhelion sweep s.toml sun.elevation=1:3:1 -o f_%d.exr --rays 1k";
  for (const std::string mine : {"text", "own.png", "view.png"}) {
    const std::string before = readFile(folder / mine);
    std::filesystem::copy_file(folder / mine, folder / "f_1.png", std::filesystem::copy_options::overwrite_existing);
    const Outcome outcome = run(folder, sweep);
    CHECK(outcome.exit == 1);
    CHECK_MESSAGE(outcome.err.find("writes over nothing but pictures") != std::string::npos, outcome.err);
    CHECK(lines(outcome.err) == 1);
    CHECK_FALSE(std::filesystem::exists(folder / "f_0.exr"));
    CHECK(readFile(folder / "f_1.png") == before);
  }
  std::filesystem::copy_file(folder / "halo.png", folder / "f_1.png",
                             std::filesystem::copy_options::overwrite_existing);
  CHECK(run(folder, sweep).exit == 0);
}

TEST_CASE("at the end a sweep says what it has written") {
  WithScene folder;
  const std::string sweep = "parhelion sweep s.toml --rays 1k sun.elevation=";
  CHECK(run(folder, sweep + "1:3:1 -o f_%d.exr").err.ends_with("\nwrote 3 frames, f_0.exr to f_2.exr\n"));
  CHECK(run(folder, sweep + "1:3:1 -o f_%d.exr --contact-sheet ALL.PNG")
            .err.ends_with("\nwrote 3 frames, f_0.exr to f_2.exr, and ALL.PNG\n"));
  CHECK(run(folder, sweep + "1 -o f_%d.exr").err.ends_with("\nwrote 1 frame, f_0.exr\n"));
}

TEST_CASE("all previews have one exposure: as told, or the median of what the frames would choose") {
  WithScene folder;
  const std::string sweep = "parhelion sweep s.toml sun.elevation=5:45:20 -o f_%d.exr ";
  const std::string median = run(folder, sweep).err;
  std::set<double> own;
  for (const std::string elevation : {"5", "25", "45"}) {
    const std::string err = run(folder, "parhelion render s.toml -o r.exr -D sun.elevation=" + elevation).err;
    own.insert(std::stod(err.substr(err.find("(exposure ") + std::string("(exposure ").size())));
  }
  REQUIRE(own.size() == 3);
  const std::string said = median.substr(median.find("at exposure ") + std::string("at exposure ").size(), 5);
  CHECK_MESSAGE(std::stod(said) == *std::next(own.begin()), said);
  for (const std::string i : {"0", "1", "2"})
    CHECK(readFile(folder / ("f_" + i + ".png")).find(said + " stops") != std::string::npos);

  CHECK(run(folder, sweep + "--exposure -2.5").err.find("exposure -2.50 stops\n") != std::string::npos);
  REQUIRE(run(folder, "parhelion render s.toml -o r.exr --quiet -D sun.elevation=25 --exposure -2.5").exit == 0);
  CHECK(readFile(folder / "f_1.png") == readFile(folder / "r.png"));
}

TEST_CASE("previews of render, recon and sweep are developed by an exposure value and a curve, as view does it") {
  WithScene folder;
  const std::string how = " --ev 9 --tone filmic ";
  REQUIRE(run(folder, "parhelion render s.toml -D cloud.optical_depth=0.2 -o r.exr --quiet" + how).exit == 0);
  REQUIRE(run(folder, "parhelion view r.exr -o v.png --quiet" + how).exit == 0);
  const auto shown = readPhotograph(folder / "v.png").samples;
  CHECK(readPhotograph(folder / "r.png").samples == shown);
  REQUIRE(run(folder, "parhelion view r.exr -o w.png --quiet --ev 9").exit == 0);
  CHECK(readPhotograph(folder / "w.png").samples != shown);
  REQUIRE(run(folder, "parhelion trace s.toml -D cloud.optical_depth=0.2 -o t.exr --quiet").exit == 0);
  REQUIRE(run(folder, "parhelion recon t.exr -o again.exr --quiet" + how).exit == 0);
  CHECK(readPhotograph(folder / "again.png").samples == shown);
  REQUIRE(run(folder,
              "parhelion sweep s.toml -D cloud.optical_depth=0.2 sun.elevation=20,25 -o f_%d.exr "
              "--contact-sheet sheet.png --quiet" +
                  how)
              .exit == 0);
  CHECK(readPhotograph(folder / "f_0.png").samples == shown);
  for (const std::string command : {"render s.toml -o x.exr", "recon plain.exr -o x.exr"}) {
    REQUIRE(run(folder, "parhelion trace s.toml -o plain.exr --quiet --overwrite").exit == 0);
    const Outcome outcome = run(folder, "parhelion " + command + how);
    CHECK(outcome.exit == 2);
    CHECK_MESSAGE(outcome.err.find("--ev: the scene's light has no absolute unit") != std::string::npos, outcome.err);
    CHECK(!std::filesystem::exists(folder / "x.exr"));
  }
}

TEST_CASE("the contact sheet shows all frames at once") {
  WithScene folder;
  REQUIRE(run(folder, "parhelion sweep s.toml sun.elevation=10:15:1 -o f_%d.exr --contact-sheet all.png").exit == 0);
  const auto [width, height] = sizeOfPng(readFile(folder / "all.png"));
  CHECK(width > 2 * 48);
  CHECK(height > 2 * 48);
  CHECK(width * height > 6 * 48 * 48);
  CHECK(width < 6 * 48);
  CHECK(readFile(folder / "all.png").find("Exposure") != std::string::npos);
}

TEST_CASE("progress of a sweep is a line a frame, or JSON, or nothing") {
  WithScene folder;
  const std::string sweep = "parhelion sweep s.toml sun.elevation=10,20 --rays 1k ";
  CHECK(run(folder, sweep + "-o a%d.exr --quiet").err.empty());
  CHECK(run(folder, sweep + "-o b%d.exr --progress json").err.find("{\"frame\": 2, \"of\": 2, \"seconds\": ") !=
        std::string::npos);
  const std::string people = run(folder, sweep + "-o c%d.exr").err;
  CHECK(people.find("frame 1 of 2: sun.elevation=10, ") != std::string::npos);
  CHECK(people.find("rays/s") == std::string::npos);
}

TEST_CASE("mistakes of a sweep are told before anything is rendered") {
  WithScene folder;
  const struct {
    const char *arguments, *says;
  } cases[] = {
      {"-o f_%d.exr", "keys is required"},
      {"sun.elevation=1:2:1", "--output is required"},
      {"sun.elevation=0:60:1 population.0.tilt=1,2 -o f_%d.exr",
       "sun.elevation has 61 values and population.0.tilt has 2"},
      {"sun.elevation=0:2:1 -o f.exr", "expected one number such as %04d"},
      {"sun.elevation=0:2:1 -o f_%d_%d.exr", "expected one number such as %04d"},
      {"sun.elevation=0:2:1 -o f_%s.exr", "expected one number such as %04d"},
      {"sun.elevation=0:2:1 -o f_%n%d.exr", "expected one number such as %04d"},
      {"sun.elevation=0:2:1 -o f_%4d.exr", "expected one number such as %04d"},
      {"sun.elevation=0:2:1 -o 'f_%d.exr%'", "expected one number such as %04d"},
      {"sun.elevation=0:2:1 -o f_%d.png", "frames are .exr"},
      {"sun.elevation=70:100:10 -o f_%d.exr", "-D sun.elevation=100"},
      {"sun.elevatoin=1:2:1 -o f_%d.exr", "did you mean 'elevation'"},
      {"camera.projection=1:2:1 -o f_%d.exr", "'projection' must be one of"},
      {"sun.elevation=low,high -o f_%d.exr", "'low' is not a number"},
      {"sun.elevation=1:2:1 sun.elevation=1:2:1 -o f_%d.exr", "given twice"},
      {"trace.rays=1000:2000:1000 --rays 5k -o f_%d.exr", "trace.rays is swept"},
      {"camera.resolution=10,20 -o f_%d.exr", "camera.resolution is no single number"},
      {"camera.resolution.0=10,20 -o f_%d.exr --resolution 5x5", "camera.resolution.0 is swept"},
      {"sun.elevation=1:2:1 -o f_%d.exr -D sun.elevation=3", "sun.elevation is swept"},
      {"sun.date=2026-12-21T09:00:00Z -o f_%d.exr -D sun.elevation=3", "sun.date is swept"},
      {"sun.date=2026-12-21T09:00:00Z sun.elevation=3 -o f_%d.exr", "placed twice"},
      {"sun.date=2026-12-21T09:00:00Z -o f_%d.exr", "'latitude' is missing"},
      {"sun.date=2026-12-32T09:00:00Z -o f_%d.exr", "is no date and time that exists"},
      {"sun.elevation=1:2:1 -o f_%d.exr --ev 13", "--ev: the scene's light has no absolute unit"},
      {"sun.elevation=1:2:1 -o f_%d.exr --contact-sheet f_1.png", "written over"},
      {"sun.elevation=1:2:1 -o f_%d.exr --contact-sheet all.exr", "name of a .png"},
      {"sun.elevation=1:2:1 -o f_%d.exr --first -1", "--first"},
      {"trace.seed=1:3000:1 -o f_%d.exr --contact-sheet all.png", "at most 2500 frames"},
  };
  for (const auto& [arguments, says] : cases) {
    const Outcome outcome = run(folder, std::string("parhelion sweep s.toml ") + arguments);
    CHECK_MESSAGE(outcome.exit == 2, arguments);
    CHECK_MESSAGE(outcome.err.find(says) != std::string::npos, arguments << " said " << outcome.err);
  }
  CHECK(framesIn(folder) == 0);
}

TEST_CASE("a percent sign in a frame's name is written as two, and no other part of the name is read as a format") {
  WithScene folder;
  REQUIRE(run(folder, "parhelion sweep s.toml sun.elevation=1 -o '50%%_%03d.exr' --rays 1k --first 7").exit == 0);
  CHECK(std::filesystem::exists(folder / "50%_007.exr"));
}
