// SPDX-License-Identifier: Apache-2.0
// Whoever gives a file to the wrong command, or a word that is nearly right, is told what would be right.
#include <doctest/doctest.h>

#include "photographs.h"
#include "rendered_sky.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

struct Complaint {
  const char* command;
  int exit;
  std::vector<const char*> says;
};

void checkAll(const Folder& folder, const std::vector<Complaint>& complaints) {
  for (const auto& [command, exit, says] : complaints) {
    const Outcome outcome = run(folder, std::string("parhelion ") + command);
    CHECK_MESSAGE(outcome.exit == exit, command);
    for (const char* words : says)
      CHECK_MESSAGE(outcome.err.find(words) != std::string::npos, command << " said " << outcome.err);
    CHECK_MESSAGE(outcome.err.find("UTF-8") == std::string::npos, outcome.err);
    CHECK_MESSAGE(outcome.err.find("1 MiB") == std::string::npos, outcome.err);
  }
}

}  // namespace

TEST_CASE("a file given to the wrong command is called what it is, with the command that wants it") {
  WithSky folder;
  writeJpegWithExif(folder / "photo.jpg", landscape<std::uint8_t>(60, 40, 0.5), 1, 24);
  writePhotograph(folder / "theirs.exr", landscape<std::uint8_t>(60, 40, 0.5), {});
  writeFile(folder / "raw", std::string("II*\0\x10\0\0\0CR\x02\0", 12) + std::string(2 << 20, '\7'));
  writeFile(folder / "binary", std::string("\0\1\2\3", 4));
  REQUIRE(run(folder, "parhelion profile s.toml --rays 1k --quiet -o table.csv").exit == 0);
  // Larger than a scene may be.
  REQUIRE(run(folder, "parhelion trace s.toml --rays 2k --resolution 700x700 --quiet -o big.exr").exit == 0);
  for (const char* command : {"render", "trace -o x.exr", "profile", "map", "check", "replay --ray 1"}) {
    const std::string with = command;
    checkAll(folder, {{(with + " photo.jpg").c_str(), 2, {"is a JPEG picture, not a scene", "parhelion composite"}}});
    checkAll(folder, {{(with + " big.exr").c_str(), 2, {"is a tally, not a scene", "parhelion recon"}}});
  }
  checkAll(folder,
           {{"render s.png", 2, {"is a PNG picture that parhelion has made, not a scene", "parhelion view"}},
            {"render s.exr", 2, {"is an EXR picture that parhelion has made", "parhelion info --scene"}},
            {"render theirs.exr", 2, {"is an EXR picture, not a scene", "parhelion composite"}},
            {"render raw", 2, {"is a camera's raw file (CR2), not a scene", "convert it"}},
            {"render binary", 2, {"is a binary file, not a scene"}},
            {"render table.csv", 2, {"is a table or chart that parhelion has written"}},
            {"sweep photo.jpg sun.elevation=1,2 -o f%d.exr", 2, {"is a JPEG picture, not a scene"}},
            {"check s.toml photo.jpg binary", 2, {"photo.jpg: error: is a JPEG", "binary: error: is a binary"}},
            {"info raw", 2, {"is a camera's raw file"}},
            {"recon s.toml", 2, {"is a text file, not a tally", "parhelion trace"}},
            {"recon photo.jpg", 2, {"is a JPEG picture, not a tally"}},
            {"recon s.exr", 2, {"is an EXR picture that parhelion has made, not a tally"}},
            {"recon hits.exr --compare s.exr", 2, {"s.exr: is an EXR picture that parhelion has made, not a tally"}},
            {"view s.toml -o v.png", 2, {"is a text file, not a picture", "parhelion render"}},
            {"view raw -o v.png", 2, {"is a camera's raw file", "convert it to JPEG, PNG or EXR"}},
            {"view s.exr --beside s.toml -o v.png", 2, {"s.toml: is a text file, not a picture"}},
            {"composite s.toml --scene s.toml -o v.png", 2, {"is a text file, not a photograph"}},
            {"composite hits.exr --scene s.toml -o v.png", 2, {"is a tally, not a photograph"}},
            {"composite s.png --scene photo.jpg -o v.png", 2, {"photo.jpg: error: is a JPEG picture, not a scene"}},
            {"composite s.png --halo s.toml -o v.png", 2, {"s.toml: is a text file, not a sky"}},
            {"composite s.png --halo hits.exr -o v.png", 2, {"hits.exr: is a tally, not a sky"}}});
}

TEST_CASE("info of a photograph tells its size, lens, field of view and date, of our pictures what made them") {
  WithSky folder;
  // 24 mm on film of 36 mm x 24 mm sees 73.7 x 53.1 degrees.
  const Photograph picture = landscape<std::uint8_t>(60, 40, 0.5);
  writeJpegWithExif(folder / "photo.jpg", picture, 1, 24);
  const Outcome plain = run(folder, "parhelion info photo.jpg");
  CHECK(plain.exit == 0);
  for (const char* says : {"JPEG, 60 x 40, 8 bits", "lens: 35 mm equivalent 24 mm", "73.7 x 53.1 degrees",
                           "as of 24 mm", "taken: 2024-01-31 12:00:00"})
    CHECK_MESSAGE(plain.out.find(says) != std::string::npos, plain.out);
  writePhotograph(folder / "bare.png", picture, {{"Comment", "\x1b[31mred"}});
  const Outcome bare = run(folder, "parhelion info bare.png");
  CHECK(bare.out.find("PNG, 60 x 40, 8 bits") != std::string::npos);
  CHECK(bare.out.find("--fov-horizontal") != std::string::npos);
  CHECK(bare.out.find('\x1b') == std::string::npos);
  CHECK(run(folder, "parhelion info s.png").out.find("Software: parhelion") != std::string::npos);
  CHECK(run(folder, "parhelion info --scene bare.png").err.find("holds no scene") != std::string::npos);
  CHECK(run(folder, "parhelion info --scene s.png").out == run(folder, "parhelion info --scene s.exr").out);
  REQUIRE(run(folder, "parhelion view s.exr -o v.png --quiet").exit == 0);
  CHECK(run(folder, "parhelion info --scene v.png").out == run(folder, "parhelion info --scene s.exr").out);
}

TEST_CASE("the scene in a picture comes out as it was, with the ends of its lines") {
  Folder folder;
  std::string scene = "# columns\tat random\n" + kScene, windows;
  for (const char c : scene) windows += c == '\n' ? "\r\n" : std::string(1, c);
  for (const std::string& text : {scene, windows}) {
    writeFile(folder / "s.toml", text);
    REQUIRE(run(folder, "parhelion render s.toml --quiet").exit == 0);
    for (const char* file : {"s.exr", "s.png", "s.toml"})
      CHECK_MESSAGE(run(folder, std::string("parhelion info --scene ") + file).out == text, file);
  }
}

TEST_CASE("words in a picture reach the terminal without what would act on it") {
  Folder folder;
  writePhotograph(folder / "x.exr", landscape<std::uint8_t>(60, 40, 0.5),
                  {{"software", "\x1b]0;owned\a\x1b[2J"}, {"parhelion:scene", "# \x1b[31m\n[sun]\n"}});
  for (const char* command : {"parhelion info --scene x.exr", "parhelion info x.exr"}) {
    const Outcome outcome = run(folder, command);
    CHECK((outcome.out + outcome.err).find('\x1b') == std::string::npos);
    CHECK((outcome.out + outcome.err).find('\a') == std::string::npos);
  }
}

TEST_CASE("options and keys that are nearly right get their suggestion") {
  WithSky folder;
  checkAll(folder, {{"profile s.toml --bin 10", 2, {"unknown option '--bin' of profile", "did you mean '--bins'?"}},
                    {"view s.exr --bins=2 -o v.png", 2, {"unknown option '--bins' of view", "did you mean '--bin'?"}},
                    {"render s.toml --bins 3", 2, {"unknown option '--bins' of render", "it belongs to profile"}},
                    {"composite s.png --fov 60 --scene s.toml", 2, {"'--fov' of composite", "'--fov-horizontal'"}},
                    {"render s.toml --threads 2", 2, {"did you mean '--nthreads'?"}},
                    {"--verbose", 2, {"unknown option '--verbose'"}},
                    {"render s.toml more.toml", 2, {"render does not expect 'more.toml'"}},
                    {"rendr s.toml", 2, {"unknown command 'rendr'; did you mean 'render'?"}},
                    {"render s.toml -D columns.tilt=3", 2, {"did you mean 'population.columns.tilt'?"}},
                    {"render s.toml -D column.tilt=3", 2, {"did you mean 'population.columns.tilt'?"}},
                    {"render s.toml -D camera.fov=180", 2, {"'fov_diagonal', 'fov_horizontal' or 'fov_vertical'"}},
                    {"render s.toml -D sun.elev=18", 2, {"did you mean 'elevation'?"}},
                    {"map s.toml --step=nan", 2, {"expected a number from 0.01 to 90"}},
                    {"profile s.toml --from nan", 2, {"expected a number from 0 to 180"}}});
  // A table of the scene is no population, whatever that is called.
  CHECK(run(folder, "parhelion check s.toml -D population.columns.name=ice -D ice.index=1.3").exit == 0);
}
