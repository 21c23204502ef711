// SPDX-License-Identifier: Apache-2.0
// No command replaces a file that parhelion has not written, unless it is told to.
#include <doctest/doctest.h>

#include "photographs.h"
#include "rendered_sky.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

const std::string kCamera = " --fov-horizontal 60 --sun 30,20 --sun-elevation 10 ";

/// A sky, a tally and a photograph.
struct WithPhoto : WithSky {
  WithPhoto() { writeJpegWithExif(*this / "photo.jpg", landscape<std::uint8_t>(60, 40, 0.5), 1, 24); }
};

struct Command {
  std::string line;                  // writes the outputs, all of them new
  std::vector<std::string> outputs;  // files
};

std::vector<Command> everyCommand() {
  const std::string composite = "composite photo.jpg --scene s.toml --rays 1k" + kCamera;
  return {
      {"render s.toml --rays 1k -o x.exr --stats x.json", {"x.exr", "x.png", "x.json"}},
      {"render s.toml --rays 1k -o X.EXR", {"X.EXR", "X.png"}},
      {"render s.toml --rays 1k -o x.Png", {"x.exr", "x.Png"}},
      {"trace s.toml --rays 1k -o x.exr --stats x.json", {"x.exr", "x.json"}},
      {"recon hits.exr -o x --confidence sure.PNG --stats x.json", {"x.exr", "x.png", "sure.PNG", "x.json"}},
      {"profile s.toml --rays 1k -o x.csv --summary x.json --stats y.json", {"x.csv", "x.json", "y.json"}},
      {"map s.toml --rays 1k --step 10 -o x.csv --stats x.json", {"x.csv", "x.json"}},
      {"map s.toml --rays 1k --step 10 -o x.EXR", {"x.EXR"}},
      {"sweep s.toml sun.elevation=1,2 --rays 1k -o f_%d.EXR --contact-sheet x.png",
       {"f_0.EXR", "f_1.EXR", "f_0.png", "f_1.png", "x.png"}},
      {"view s.exr --overlay -o x.jpg --layer l.png", {"x.jpg", "l.png"}},
      {"view s.exr --unsharp 3,5 -o x.Jpeg", {"x.Jpeg"}},
      {"view s.exr --profile x.csv --chart x.svg", {"x.csv", "x.svg"}},
      {"view s.exr --beside s.exr --profile x.csv --chart x.png", {"x.csv", "x.png"}},
      {composite + "-o x.jpg --stats x.json", {"x.jpg", "x-mask.png", "x.json"}},
      {composite + "-o x.png --mask-out m.png --layers layers",
       {"x.png", "m.png", "layers/halo.exr", "layers/sum.exr", "layers/halo-dodge.png", "layers/mask.png",
        "layers/grid.png"}},
      {composite + "-o x.exr --all-sky", {"x.exr"}},
  };
}

}  // namespace

TEST_CASE("every command writes its own files again, and over no other's, until it is told to") {
  WithPhoto folder;
  for (const auto& [line, outputs] : everyCommand()) {
    const std::string command = "parhelion " + line + " --quiet";
    for (const char* when : {"first", "again"}) {
      const Outcome outcome = run(folder, command);
      REQUIRE_MESSAGE(outcome.exit == 0, when << ": " << line << " said " << outcome.err);
    }
    const std::string photo = readFile(folder / "photo.jpg");
    for (const std::string& output : outputs) {
      REQUIRE_MESSAGE(std::filesystem::exists(folder / output), output);
      const std::string ours = readFile(folder / output), theirs = output.ends_with("json") ? "{\"my\": 1}" : photo;
      writeFile(folder / output, theirs);
      const Outcome refused = run(folder, command);
      CHECK_MESSAGE(refused.exit == 1, line << " over " << output);
      CHECK_MESSAGE(refused.err.find(output + ": ") != std::string::npos, refused.err);
      CHECK_MESSAGE(refused.err.find("--overwrite") != std::string::npos, refused.err);
      CHECK_MESSAGE(lines(refused.err) == 1, refused.err);
      CHECK_MESSAGE(readFile(folder / output) == theirs, output);
      if (&output != &outputs.back()) writeFile(folder / output, ours);
    }
    const Outcome told = run(folder, command + " --overwrite");
    CHECK_MESSAGE(told.exit == 0, told.err);
    CHECK_MESSAGE(readFile(folder / outputs.back()) != photo, outputs.back());
    for (const std::string& output : outputs) std::filesystem::remove(folder / output);
  }
}

TEST_CASE("other programs' pictures, tables and data are known as such by what is in them") {
  WithPhoto folder;
  writePhotograph(folder / "theirs.png", landscape<std::uint8_t>(60, 40, 0.5), {{"Software", "GIMP"}});
  writePhotograph(folder / "theirs.exr", landscape<std::uint8_t>(60, 40, 0.5), {{"software", "Blender"}});
  // A sky of ours that another program has changed, with our attributes still in it.
  writePhotograph(folder / "changed.exr", landscape<std::uint8_t>(60, 40, 0.5),
                  {{"software", "another program"}, {"parhelion:scene", kScene}});
  writeFile(folder / "theirs.csv", "from_deg,to_deg,energy,stderr,phase,my_notes\n0,1,2,3,4,precious\n");
  writeFile(folder / "theirs.json", "{\"rays\": 5, \"g\": 0.8, \"mine\": true}\n");
  writeFile(folder / "theirs.svg", "<?xml version=\"1.0\"?>\n<svg></svg>\n");
  writeFile(folder / "binary", std::string("\0\1\2", 3));
  for (const char* theirs :
       {"theirs.png", "theirs.exr", "changed.exr", "theirs.csv", "theirs.json", "theirs.svg", "binary", "s.toml"}) {
    const std::string before = readFile(folder / theirs);
    std::filesystem::copy_file(folder / theirs, folder / "x.csv", std::filesystem::copy_options::overwrite_existing);
    const Outcome outcome = run(folder, "parhelion profile s.toml --rays 1k --quiet -o x.csv");
    CHECK_MESSAGE(outcome.exit == 1, theirs);
    CHECK_MESSAGE(outcome.err.find("x.csv: is there and was not written by parhelion") != std::string::npos,
                  outcome.err);
    CHECK_MESSAGE(readFile(folder / "x.csv") == before, theirs);
  }
}

TEST_CASE("our own pictures are known where they are cut short, and an empty file is nobody's") {
  WithSky folder;
  for (const char* make : {"head -c 3000 s.exr > c.exr", "head -c -40 s.png > c.png", ": > c.exr", ": > c.png"}) {
    const Outcome outcome = run(folder, std::string(make) + " && parhelion render s.toml --rays 1k --quiet -o c.exr");
    CHECK_MESSAGE(outcome.exit == 0, make << " said " << outcome.err);
    const Outcome sweep =
        run(folder, std::string(make) + " && parhelion sweep s.toml trace.seed=1 --rays 1k --quiet -o c%d.exr");
    CHECK_MESSAGE(sweep.exit == 0, sweep.err);
  }
}

TEST_CASE("links lead to what is guarded, folders are no outputs, and an input is no output even when told") {
  WithPhoto folder;
  std::filesystem::create_symlink("photo.jpg", folder / "link.csv");
  std::filesystem::create_symlink("new.csv", folder / "dangling.csv");
  std::filesystem::create_symlink("loop.csv", folder / "loop.csv");
  std::filesystem::create_hard_link(folder / "s.toml", folder / "hard.csv");
  std::filesystem::create_directory(folder / "folder.csv");
  std::filesystem::create_directory_symlink(".", folder / "here");
  const std::string photo = readFile(folder / "photo.jpg");
  const struct {
    const char* output;
    int exit;
    const char* says;
  } cases[] = {
      {"link.csv", 1, "link.csv: is there and was not written by parhelion"},
      {"loop.csv", 1, "loop.csv: Too many levels of symbolic links"},
      {"folder.csv", 1, "folder.csv: Is a directory"},
      {"none/x.csv", 1, "none/x.csv: the folder none does not exist"},
      {"hard.csv --overwrite", 2, "written over"},
      {"here/s.toml --overwrite", 2, "written over"},
      {"./s.toml --overwrite", 2, "written over"},
      {"x.csv --summary here/x.csv --overwrite", 2, "written over"},
      {"new.csv --summary dangling.csv", 2, "written over"},
  };
  for (const auto& [output, exit, says] : cases) {
    const Outcome outcome = run(folder, std::string("parhelion profile s.toml --rays 1k --quiet -o ") + output);
    CHECK_MESSAGE(outcome.exit == exit, output);
    CHECK_MESSAGE(outcome.err.find(says) != std::string::npos, output << " said " << outcome.err);
  }
  CHECK(readFile(folder / "photo.jpg") == photo);
  CHECK(readFile(folder / "s.toml") == kScene);
  CHECK(run(folder, "parhelion profile s.toml --rays 1k --quiet -o dangling.csv").exit == 0);
  CHECK(std::filesystem::is_symlink(folder / "dangling.csv"));
  CHECK(run(folder, "parhelion profile s.toml --rays 1k --quiet -o link.csv --overwrite").exit == 0);
  CHECK(readFile(folder / "photo.jpg").starts_with("from_deg"));
  for (const char* same : {"photo.jpg -o photo.jpg", "s.png -o here/s.png"})
    CHECK(run(folder, std::string("parhelion composite ") + same + " --scene s.toml --overwrite" + kCamera).exit == 2);
}

TEST_CASE("a corrected mask is kept until --overwrite is said") {
  WithPhoto folder;
  const std::string composite = "parhelion composite photo.jpg --scene s.toml --rays 1k --quiet -o x.png" + kCamera;
  REQUIRE(run(folder, composite).exit == 0);
  writePhotograph(folder / "x-mask.png", skyOf(60, 40, 0.3), readPhotograph(folder / "x-mask.png").text);
  const Outcome refused = run(folder, composite);
  CHECK(refused.exit == 1);
  CHECK(refused.err.find("--mask-out, or say --overwrite") != std::string::npos);
  CHECK(run(folder, composite + " --overwrite").exit == 0);
  CHECK(run(folder, composite).exit == 0);
}
