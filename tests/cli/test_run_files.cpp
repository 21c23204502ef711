// SPDX-License-Identifier: Apache-2.0
// The files of a run: together or not at all, for one run at a time, and what is known before anything is traced.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "photographs.h"
#include "render/needs.h"
#include "rendered_sky.h"
#include "scene/parse_scene.h"

using namespace parhelion::test;
using namespace parhelion;

namespace {

const std::string kLong = "render s.toml --rays 10G --resolution 32x32 --quiet --stats s.json -o o.exr";

struct WithScene : Folder {
  WithScene() { writeFile(*this / "s.toml", kScene); }

  bool hasTemporaries() const {
    const auto all = names();
    return std::any_of(all.begin(), all.end(), [](const std::string& name) { return name.ends_with(".tmp"); });
  }
};

/// Starts a command and, when it has claimed its outputs, does `then`; $pid is the command's. What killed commands have
/// left goes away first.
std::string during(const std::string& command, const std::string& then) {
  return "{ ls -A | grep '^[.].*tmp$' | xargs -r rm -f; '" PARHELION_BINARY "' " + command +
         " & pid=$!; while kill -0 $pid && ! ls -A | grep -q '^[.].*tmp$'; do sleep 0.02; done; " + then + "; }";
}

}  // namespace

TEST_CASE("what a run writes is refused to a second one as long as the first lives, under all names and in part") {
  const WithScene folder;
  std::filesystem::create_symlink("o.exr", folder / "link.exr");
  std::filesystem::create_directory_symlink(".", folder / "here");
  for (const std::string second :
       {"render s.toml --rays 1k --quiet -o o.png", "render s.toml --rays 1k --quiet -o link.exr",
        "trace s.toml --rays 1k --quiet -o here/o.exr", "profile s.toml --rays 1k --quiet -o p.csv --stats s.json",
        "sweep s.toml trace.seed=1 --rays 1k --quiet -o %d.exr --contact-sheet ./o.png"}) {
    const Outcome outcome = run(folder, during(kLong, "parhelion " + second +
                                                          "; code=$?; kill -9 $pid; wait $pid; "
                                                          "echo process $pid; exit $code"));
    CHECK_MESSAGE(outcome.exit == 1, second);
    const std::string process = outcome.out.substr(0, outcome.out.find('\n'));
    CHECK_MESSAGE(outcome.err.find("another run writes it (" + process + ")") != std::string::npos, outcome.err);
    CHECK(folder.hasTemporaries());
  }
  // None of the killed runs is in the way, and the next one removes what they have left.
  CHECK(run(folder, "parhelion render s.toml --rays 1k --quiet --stats s.json -o o.exr").exit == 0);
  CHECK_FALSE(folder.hasTemporaries());
}

TEST_CASE("a run whose folder goes away in the middle leaves all other files as they were") {
  const WithScene folder;
  std::filesystem::create_directory(folder / "far");
  writeFile(folder / "s.json", "{}");
  const Outcome outcome = run(folder, during("profile s.toml --rays 10G --time 1 --quiet -o s.csv --stats far/s.json",
                                             "mv far gone; wait $pid; code=$?; mv gone far; exit $code"));
  CHECK(outcome.exit == 1);
  CHECK_MESSAGE(outcome.err.find("far/s.json: the folder far does not exist") != std::string::npos, outcome.err);
  CHECK(readFile(folder / "s.json") == "{}");
  CHECK_FALSE(std::filesystem::exists(folder / "s.csv"));
  CHECK_FALSE(folder.hasTemporaries());
}

TEST_CASE("a signal ends what cannot be resumed at once, with 128 and its number, and leaves no file half written") {
  const WithScene folder;
  REQUIRE(run(folder,
              "parhelion render s.toml --rays 1k --quiet -o sky.exr && "
              "parhelion trace s.toml --symmetry none --rays 1k --resolution 1500x1500 --quiet -o big.exr && cp "
              "sky.png c.png")
              .exit == 0);
  const std::string before = readFile(folder / "c.png");
  const struct {
    const char* command;
    const char* signal;
    int exit;
  } cases[] = {{"recon big.exr --quiet -o o.exr --stats o.json", "TERM", 143},
               {"recon big.exr --quiet -o o.exr --stats o.json", "INT", 130},
               {"composite sky.png --scene s.toml --rays 10G --quiet --all-sky --stats o.json -o c.png", "TERM", 143},
               {"composite sky.png --scene s.toml --rays 10G --quiet --all-sky --stats o.json -o c.png", "HUP", 129}};
  for (const auto& [command, signal, exit] : cases) {
    const Outcome outcome = run(folder, during(command, std::string("kill -") + signal + " $pid; wait $pid"));
    CHECK_MESSAGE(outcome.exit == exit, command);
    CHECK_MESSAGE(outcome.err.ends_with("parhelion: interrupted\n"), outcome.err);
    CHECK_FALSE(std::filesystem::exists(folder / "o.exr"));
    CHECK_FALSE(std::filesystem::exists(folder / "o.json"));
    CHECK(readFile(folder / "c.png") == before);
    CHECK_FALSE(folder.hasTemporaries());
  }
}

TEST_CASE("too little memory, too little room and what makes no file are one line before anything is traced") {
  const WithScene folder;
  const struct {
    const char* command;
    int exit;
    const char* says;
  } cases[] = {
      {"ulimit -v 1000000; parhelion render s.toml --resolution 9000x9000 -o o.exr", 1, "are allowed by ulimit -v"},
      {"ulimit -v 1000000; parhelion trace s.toml --resolution 9000x9000 -o o.exr", 1, "are allowed by ulimit -v"},
      {"ulimit -v 1000000; parhelion map s.toml --step 0.01", 1, "the map needs about"},
      {"ulimit -v 1000000; parhelion profile s.toml --bins 10000000", 1, "the profile needs about"},
      {"ulimit -v 1000000; parhelion sweep s.toml trace.seed=1 --resolution 9000x9000 -o %d.exr", 1, "0.exr needs"},
      {"ulimit -f 1000; parhelion render s.toml --resolution 1000x1000 -o o.exr", 1, "are allowed by ulimit -f"},
      {"SOURCE_DATE_EPOCH=soon parhelion render s.toml -o o.exr", 1, "SOURCE_DATE_EPOCH is no number of seconds"},
      {"SOURCE_DATE_EPOCH=-1 parhelion trace s.toml -o o.exr", 1, "SOURCE_DATE_EPOCH is no number of seconds"},
      {"parhelion render s.toml -o none/o.exr", 1, "none/o.exr: the folder none does not exist"},
      {"parhelion render s.toml -o s.toml/o.exr", 1, "s.toml/o.exr: s.toml is no folder"},
      {"parhelion trace s.toml -o /dev/full", 1, "/dev/full: No space left on device"},
      {"parhelion profile s.toml -o /dev/full", 1, "/dev/full: No space left on device"},
      {"parhelion profile s.toml -o o.csv/", 1, "o.csv/: names a folder, not a file"},
      {"parhelion trace s.toml -o /proc/o.exr", 1, "/proc/o.exr: "},
      {"parhelion profile s.toml -o ''", 2, "--output: expected a value, not ''"},
      {"parhelion render s.toml --stats ''", 2, "--stats: expected a value, not ''"},
      {"parhelion recon '' -o o.exr", 2, "expected a value, not ''"},
  };
  for (const auto& [command, exit, says] : cases) {
    const Outcome outcome = run(folder, command);
    CHECK_MESSAGE(outcome.exit == exit, command);
    CHECK_MESSAGE(outcome.err.find(says) != std::string::npos, command << " said " << outcome.err);
    CHECK_MESSAGE(outcome.err.find("rays") == std::string::npos, command);
    CHECK_MESSAGE(lines(outcome.err) == (exit == 1 ? 1 : 2), command << " said " << outcome.err);
  }
  const std::string longName(256, 'n');
  CHECK(run(folder, "parhelion profile s.toml -o " + longName).err.find("File name too long") != std::string::npos);
}

TEST_CASE("of an input in a folder that is not there the folder is named") {
  const WithScene folder;
  REQUIRE(run(folder, "parhelion render s.toml --rays 1k --quiet -o sky.exr").exit == 0);
  const std::string camera = " --fov-horizontal 60 --sun 3,4 --quiet";
  for (const std::string command :
       {"render none/s.toml", "trace none/s.toml -o o.exr", "check none/s.toml", "info none/s.toml", "info none/t.exr",
        "recon none/t.exr -o o.exr", "merge none/t.exr -o o.exr", "view none/p.png -o o.png",
        "view none/p.exr -o o.png", "composite none/p.jpg --scene s.toml -o o.png",
        "composite sky.png --mask none/m.png --scene s.toml -o o.png",
        "composite sky.png --halo none/h.exr --all-sky -o o.png"}) {
    const bool composes = command.starts_with("composite");
    const Outcome outcome = run(folder, "parhelion " + command + (composes ? camera : ""));
    CHECK_MESSAGE((outcome.exit == 1 || outcome.exit == 2), command);
    CHECK_MESSAGE(outcome.err.find("the folder none does not exist") != std::string::npos,
                  command << " said " << outcome.err);
    CHECK_MESSAGE(lines(outcome.err) == 1, command << " said " << outcome.err);
  }
}

TEST_CASE("where a standard stream is closed no output gets its words") {
  const WithScene folder;
  CHECK(run(folder, "parhelion profile s.toml --rays 1k -o a.csv").exit == 0);
  const std::string table = readFile(folder / "a.csv");
  for (const char* closed : {"<&-", ">&-", "2>&-", "<&- >&- 2>&-"}) {
    CHECK(run(folder, "parhelion profile s.toml --rays 1k -o b.csv --overwrite " + std::string(closed)).exit == 0);
    CHECK_MESSAGE(readFile(folder / "b.csv") == table, closed);
  }
  CHECK(run(folder, "parhelion profile s.toml --rays 1k --quiet >&-").err ==
        "parhelion: error: stdout: Bad file descriptor\n");
}

#ifndef __SANITIZE_ADDRESS__
TEST_CASE("the memory that runs take is known beforehand to within a factor of 1.5") {
  const WithScene folder;
  constexpr double kProgram = 17e6;  // bytes, without any picture
  const auto peak = [&] {
    return nlohmann::json::parse(readFile(folder / "s.json")).at("peak_memory_bytes").get<double>();
  };
  const auto isNear = [](double estimate, double is) { return estimate < 1.5 * is && estimate > is / 1.5; };
  for (const int side : {400, 900}) {
    const std::string size = std::to_string(side) + "x" + std::to_string(side);
    const SkySize sky{std::int64_t{side} * side, true};
    REQUIRE(run(folder,
                "parhelion trace s.toml --symmetry none --rays 20k --nthreads 2 --quiet -D sun.spectrum='\"D65\"' "
                "--resolution " +
                    size + " -o t.exr --stats s.json")
                .exit == 0);
    CHECK(isNear(kProgram + static_cast<double>(memoryToTrace(sky, 2)), peak()));
    const struct {
      const char* method;
      ReconSettings settings;
    } methods[] = {{"adaptive", AdaptiveSettings{}}, {"none", NoSettings{}}, {"gaussian", GaussianSettings{}}};
    for (const auto& [method, settings] : methods) {
      REQUIRE(run(folder,
                  "parhelion recon t.exr --nthreads 2 --quiet -o o.exr --stats s.json --method " + std::string(method))
                  .exit == 0);
      CHECK_MESSAGE(isNear(kProgram + static_cast<double>(memoryToReconstruct(sky, settings, 2)), peak()),
                    method << " " << side << " took " << peak());
    }
  }
}

namespace {

constexpr double kProgram = 17e6;  // bytes, without any picture

/// Memory that a run takes over what was told before it began.
double takenOverTold(const WithScene& folder, const std::string& command, const std::string& scene) {
  writeFile(folder / "layers.toml", scene);
  const Scene read = loadScene(folder / "layers.toml").scene;
  const SkySize sky = skySizeOf(read);
  const std::uint64_t told = command == "trace" ? memoryToTrace(sky, 2) : memoryToRender(sky, read.recon, 2);
  const Outcome outcome =
      run(folder,
          "parhelion " + command + " layers.toml --rays 3M --nthreads 2 --quiet --overwrite -o o.exr --stats s.json");
  REQUIRE_MESSAGE(outcome.exit == 0, outcome.err);
  const double peak = nlohmann::json::parse(readFile(folder / "s.json")).at("peak_memory_bytes").get<double>();
  return peak / (kProgram + static_cast<double>(told));
}

}  // namespace

TEST_CASE("the memory that runs of layers full of light take is known beforehand to within 15 %") {
  const WithScene folder;
  std::string text =
      "[[population]]\nname = \"swinging\"\norientation = \"plate\"\ntilt = 20.0\n[camera]\nresolution = [256, 256]\n";
  for (int k = 0; k < 8; ++k)
    text += "[[layer]]\nname = \"l" + std::to_string(k) + "\"\ntilt = [" + std::to_string(4 * k) + ".0, " +
            std::to_string(4 * k + 4) + ".0]\n";
  for (const char* command : {"trace", "render"}) {
    CAPTURE(command);
    CHECK(std::abs(takenOverTold(folder, command, text) - 1.0) < 0.15);
  }
}

TEST_CASE("runs of many layers take no more memory than is told beforehand, and less where layers are dark") {
  const WithScene folder;
  for (const int layers : {8, 64}) {
    // Small pictures: of random crystals' layers the rings take more than the pixels.
    std::string text =
        "[[population]]\nname = \"random\"\norientation = \"random\"\n[[population]]\n"
        "name = \"plates\"\norientation = \"plate\"\n[camera]\nresolution = [256, 256]\n";
    for (int i = 1; i < layers; ++i)
      text += "[[layer]]\nname = \"l" + std::to_string(i) + "\"\npaths = \"" + std::to_string(3 + i / 8 % 6) + "-" +
              std::to_string(1 + i % 8) + ", symmetry = none\"\n";
    for (const char* command : {"trace", "render"}) {
      CAPTURE(layers);
      CAPTURE(command);
      const double taken = takenOverTold(folder, command, text);
      CHECK(taken < 1.15);
      if (layers == 64 && std::string(command) == "trace") CHECK(taken < 0.5);
    }
  }
}

TEST_CASE("the memory that a run's figures tell has that of the picture in it") {
  const WithScene folder;
  const auto peakOf = [&](const std::string& command) {
    const Outcome outcome = run(folder, "parhelion " + command + " --quiet --rays 20k --overwrite --stats s.json");
    REQUIRE_MESSAGE(outcome.exit == 0, outcome.err);
    return nlohmann::json::parse(readFile(folder / "s.json")).at("peak_memory_bytes").get<double>();
  };
  const std::string size = " --resolution 900x900 -o o.exr";
  // Filtering takes more than three times as much as the tally.
  CHECK(peakOf("render s.toml" + size) > 2.0 * peakOf("trace s.toml --symmetry none" + size));
}

TEST_CASE("a photograph and its halo find room together, or nothing of it is begun") {
  const WithScene folder;
  writePhotograph(folder / "photo.png", landscape<std::uint8_t>(1600, 1200, 0.7), {});
  const std::string composite =
      "parhelion composite photo.png --scene s.toml --rays 20k --nthreads 2 --fov-horizontal 60 --sun 800,300 "
      "--sun-elevation 20 --quiet --coarseness 2 --overwrite --stats s.json -o o.png --memory ";
  REQUIRE(run(folder, composite + "2G").exit == 0);
  const double peak = nlohmann::json::parse(readFile(folder / "s.json")).at("peak_memory_bytes").get<double>();
  MESSAGE("peak memory, bytes: " << peak);
  std::filesystem::remove(folder / "o.png");
  // Where it is allowed to begin, it stays below what it is allowed.
  for (const double share : {0.5, 0.7, 0.8, 0.9, 1.0, 1.1, 1.3, 1.5}) {
    CAPTURE(share);
    const double allowed = share * peak;
    const Outcome outcome = run(folder, composite + std::to_string(static_cast<std::int64_t>(allowed)));
    if (outcome.exit == 0) {
      CHECK(share > 0.6);
      continue;
    }
    CHECK(share < 1.5);
    CHECK(outcome.exit == 1);
    CHECK_MESSAGE(outcome.err.find("photo.png: needs about") != std::string::npos, outcome.err);
    CHECK(lines(outcome.err) == 1);
    CHECK_FALSE(std::filesystem::exists(folder / "o.png"));
  }
}

TEST_CASE("a run that goes on needs no more memory than one that begins") {
  const WithScene folder;
  const std::string trace = "parhelion trace s.toml --symmetry none --quiet --nthreads 1 --resolution 1500x1500 ";
  REQUIRE(run(folder, trace + "--rays 1000 -o t.exr").exit == 0);
  REQUIRE(run(folder, "cp t.exr t.exr.previous; head -c 100000 t.exr > half.exr").exit == 0);
  // A tally alone takes 108 MB.
  for (const char* rest :
       {"--rays 1000 -o new.exr", "--rays 2000 --resume t.exr", "--rays 3000 --resume missing.exr"}) {
    const Outcome outcome = run(folder, trace + "--memory 190M " + rest);
    CHECK_MESSAGE(outcome.exit == 0, rest << " said " << outcome.err);
  }
}
#endif

TEST_CASE("poor environments end in one line, never by a signal") {
  const Folder folder;
  const Outcome outcome = run(folder, "'" PARHELION_SOURCE_DIR "/scripts/environments' '" PARHELION_BINARY "' 23");
  CHECK_MESSAGE(outcome.exit == 0, outcome.out << outcome.err);
  CHECK(outcome.out.find("0 went wrong") != std::string::npos);
}
