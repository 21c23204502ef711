// SPDX-License-Identifier: Apache-2.0
// Whatever others have put into a file, a name or a word: nothing of it acts on the terminal.
#include <doctest/doctest.h>

#include <algorithm>

#include "command_line.h"
#include "photographs.h"
#include "picture/picture_files.h"
#include "rendered_sky.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

// Red letters, a bell, "begin of a command" as one character and as one byte, a broken character, letters from right to left, a line's end.
const std::string kEvil = "x\x1b[31m\a\xc2\x9b\x9b\xff\xe2\x80\xae\x7f\ry";

std::string inShell(const std::string& word) { return "'" + word + "'"; }

/// Nothing but the characters that letters, ends of lines and tabs are made of.
void checkQuiet(const Outcome& outcome, const std::string& command) {
  CAPTURE(command);
  for (const std::string& said : {outcome.out, outcome.err}) {
    const auto acts = [](char c) {
      return (static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\t') || c == '\x7f';
    };
    CHECK(std::none_of(said.begin(), said.end(), acts));
    for (const char* mark : {"\xff", "\xc2\x9b", "\xe2\x80\xae", "m\x9b"})
      CHECK_MESSAGE(said.find(mark) == std::string::npos, said);
  }
}

void runAll(const Folder& folder, const std::vector<std::string>& commands) {
  for (const std::string& command : commands) checkQuiet(run(folder, "parhelion " + command), command);
}

}  // namespace

TEST_CASE("words of every command and option reach the terminal escaped") {
  const WithSky folder;
  CommandLine line;
  std::vector<std::string> commands{inShell(kEvil), inShell("--" + kEvil)};
  for (const std::string& command : line.commands()) {
    commands.push_back(command + " " + inShell(kEvil));
    commands.push_back(command + " s.toml " + inShell("--" + kEvil));
    commands.push_back(command + " s.toml a b " + inShell(kEvil));
  }
  for (const Asked& asked : line.asked()) {
    std::string command;
    for (const std::string& word : asked.with(kEvil)) command += " " + inShell(word);
    commands.push_back(command);
    // With the scene or the picture, so that files are looked for, too.
    if (takesAnyText(asked)) commands.push_back(command + " s.exr -o c.png --fov-horizontal 60 --sun 3,3");
    if (takesAnyText(asked)) commands.push_back(command + " s.toml --rays 10 -o c.exr");
  }
  runAll(folder, commands);
  CHECK(commands.size() > 200);
}

TEST_CASE("names of files that are there or are written reach the terminal escaped") {
  const WithSky folder;
  const std::string name = inShell(kEvil), scene = inShell(kEvil + ".toml"), sky = inShell(kEvil + ".exr");
  REQUIRE(run(folder, "cp s.toml " + scene + "; cp s.exr " + sky + "; cp s.png " + inShell(kEvil + ".png") +
                          "; cp hits.exr " + inShell("hits" + kEvil + ".exr"))
              .exit == 0);
  runAll(folder, {"render " + scene + " --rays 10", "check " + scene, "info " + scene, "info " + sky,
                  "info " + inShell(kEvil + ".png"), "recon " + inShell("hits" + kEvil + ".exr"),
                  "recon hits.exr -o " + name, "trace s.toml --rays 10 -o " + inShell(kEvil + "t.exr"),
                  "view s.exr -o " + inShell(kEvil + "v.png"), "view " + sky + " --overlay -o v.png",
                  "sweep " + scene + " sun.elevation=1,2 --rays 10 -o " + inShell(kEvil + "%d.exr"),
                  "sweep s.toml " + inShell(kEvil + "=1,2") + " --rays 10 -o f%d.exr",
                  "composite photo.png --all-sky --fov-horizontal 60 --sun 3,3 --scene " + scene + " --rays 10 -o " +
                      inShell(kEvil + "c.png")});
}

TEST_CASE("texts in a scene reach the terminal escaped") {
  const Folder folder;
  const std::vector<std::string> scenes{
      kEvil, "# " + kEvil + "\n" + kScene, kScene + "\"" + kEvil + "\" = 1\n", kScene + "engine = \"" + kEvil + "\"\n",
      "[" + kEvil + "]\n" + kScene, kScene + "seed = " + kEvil,
      // Valid UTF-8 and TOML, by its escapes or by marks that nobody sees.
      kScene + "engine = \"\\u001b[31m\\u009b\"\n",
      kScene + "[[population]]\nname = \"\\u001b\\u202e\"\naspect = 1.0\n",
      kScene + "[[population]]\nname = \"\xe2\x80\xae\"\naspect = 1.0\n", kScene + "# \xe2\x80\xae\n"};
  for (const std::string& scene : scenes) {
    writeFile(folder / "s.toml", scene);
    runAll(folder, {"check s.toml", "info s.toml", "info --scene s.toml", "replay s.toml --ray 1",
                    "profile s.toml --rays 10 --bins 1", "check s.toml -D " + inShell("trace.engine=" + kEvil)});
  }
}

TEST_CASE("texts in pictures of any kind reach the terminal escaped") {
  const WithSky folder;
  const Photograph picture = landscape<std::uint8_t>(60, 40, 0.5);
  const std::map<std::string, std::string> texts{
      {"software", kEvil}, {"parhelion:scene", "# " + kEvil + kScene}, {kEvil.substr(0, 5), "value"}};
  writePhotograph(folder / "a.exr", picture, texts);
  Image image{4, 4, {}};
  image.add("R" + kEvil);
  writeBeautyExr(folder / "b.exr", image, {{"parhelion:scene", kScene + "\xe2\x80\xae"}});
  const std::string lines = scanLines(asText(noiseSamples<std::uint8_t>(3 * 20 * 30)), 60);
  const auto chunk = [](const char* type, const std::string& data) { return pngChunk(type, data); };
  writeFile(folder / "c.png", pngFile({20, 30}, lines,
                                      chunk("tEXt", "Title" + std::string(1, '\0') + kEvil) +
                                          chunk("iTXt", std::string("parhelion:scene\0\0\0\0\0", 20) + kEvil) +
                                          chunk("iCCP", kEvil.substr(0, 3) + std::string("\0\0", 2) + "nothing")));
  const std::string jpeg = jpegFile(noiseSamples<std::uint8_t>(3 * 50 * 40), 50, 40);
  writeFile(folder / "d.jpg", withSegments(jpeg, jpegSegment(0xFE, kEvil)));
  const std::string tiff = "II" + bytes(42, 2) + bytes(8, 4) + bytes(1, 2) + bytes(0x0110, 2) + bytes(2, 2) +
                           bytes(static_cast<unsigned>(kEvil.size()), 4) + bytes(26, 4) + bytes(0, 4) + kEvil;
  writeFile(folder / "e.jpg", withSegments(jpeg, jpegSegment(0xE1, std::string("Exif\0\0", 6) + tiff)));
  for (const char* file : {"a.exr", "b.exr", "c.png", "d.jpg", "e.jpg"}) {
    const std::string name = file;
    runAll(folder, {"info " + name, "info --scene " + name, "recon " + name, "render " + name,
                    "view " + name + " -o v.png", "view " + name + " --overlay -o v.png",
                    "view " + name + " --halos --fov-horizontal 60 --sun 3,3 --sun-elevation 20 -o v.png",
                    "view s.exr --minus " + name + " -o v.png", "view s.exr --beside " + name + " -o v.png",
                    "composite " + name + " --scene s.toml --rays 10 -o c.png",
                    "composite photo.png --fov-horizontal 60 --sun 3,3 --halo " + name + " -o c.png",
                    "trace s.toml --rays 10 -o " + name});
  }
  CHECK(run(folder, "parhelion info a.exr").out.find("\\u001b[31m") != std::string::npos);
}
