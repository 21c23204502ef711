// SPDX-License-Identifier: Apache-2.0
// Every command and every scene in the documentation works as written.
#include <doctest/doctest.h>

#include <cctype>
#include <sstream>
#include <string>
#include <vector>

#include "photographs.h"
#include "shell.h"

using namespace parhelion::test;

namespace {

const std::filesystem::path kSource = PARHELION_SOURCE_DIR;

std::vector<std::filesystem::path> documents() {
  std::vector<std::filesystem::path> all{kSource / "README.md", kSource / "CONTRIBUTING.md"};
  for (const auto& entry : std::filesystem::directory_iterator(kSource / "docs"))
    if (entry.path().extension() == ".md") all.push_back(entry.path());
  return all;
}

/// The fenced blocks of a document in one language.
std::vector<std::string> blocks(const std::filesystem::path& document, const std::string& language) {
  std::vector<std::string> found;
  std::istringstream text(readFile(document));
  std::string line;
  bool inside = false;
  while (std::getline(text, line)) {
    if (!inside && line == "```" + language) {
      inside = true;
      found.emplace_back();
    } else if (inside && line.rfind("```", 0) == 0) {
      inside = false;
    } else if (inside) {
      found.back() += line + "\n";
    }
  }
  return found;
}

/// Runs a command of the documentation as it is, but with few rays and, where it does not name a size, few pixels: what
/// is tested is that it works, not what it draws.
const std::string kQuickly =
    "parhelion() { c=$1; shift; few= last=; "
    "case \"$c $*\" in render*|trace*|profile*|map*|paths*|sweep*|composite*--scene*) few='-D trace.rays=3000';; esac; "
    "case \"$c $*\" in *--resolution*|*camera*) ;; render*|trace*|sweep*|paths*) few=\"$few -D "
    "camera.resolution=[256,128]\";; esac; "
    "for a; do shift; [ \"$last\" = --rays ] && a=3000; last=$a; set -- \"$@\" \"$a\"; done; "
    "'" PARHELION_BINARY "' $c \"$@\" $few; } && ";

/// The anchor of a heading, as GitHub makes it: lower case, blanks as hyphens, without punctuation.
std::string anchorOf(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ') anchor += '-';
    if (std::isalnum(byte) || c == '-' || c == '_' || byte >= 0x80) anchor += static_cast<char>(std::tolower(byte));
  }
  return anchor;
}

/// Whether a page has a heading with this anchor.
bool hasAnchor(const std::filesystem::path& page, const std::string& anchor) {
  std::istringstream lines(readFile(page));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t text = line.find_first_not_of('#');
    if (text != 0 && text != std::string::npos && line[text] == ' ' && anchorOf(line.substr(text + 1)) == anchor)
      return true;
  }
  return false;
}

}  // namespace

TEST_CASE("every parhelion command in the documentation runs") {
  Folder folder;
  std::filesystem::create_directory_symlink(kSource / "scenes", folder / "scenes");
  // What the documentation calls photo.jpg, with the focal length of a moderate wide angle.
  writeJpegWithExif(folder / "photo.jpg", landscape<std::uint8_t>(600, 400, 0.8), 1, 24);
  // The photograph that scripts/fetch-pictures brings.
  std::filesystem::create_directories(folder / "out/pictures");
  writePhotograph(folder / "out/pictures/evening.jpg", landscape<std::uint8_t>(2560, 1600, 0.35), {});
  int commands = 0;
  for (const auto& document : documents())
    for (const std::string& block : blocks(document, "sh")) {
      std::istringstream lines(block);
      std::string command;
      while (std::getline(lines, command)) {
        if (command.rfind("parhelion ", 0) != 0) continue;
        ++commands;
        const Outcome outcome = run(folder, kQuickly + command);
        CHECK_MESSAGE(outcome.exit == 0, document.filename() << ": " << command << "\n" << outcome.err);
      }
    }
  CHECK(commands >= 10);
}

TEST_CASE("every whole scene in the documentation is valid") {
  Folder folder;
  int scenes = 0;
  for (const auto& document : documents())
    for (const std::string& block : blocks(document, "toml")) {
      if (block.find("[[population]]") == std::string::npos) continue;
      ++scenes;
      writeFile(folder / "scene.toml", block);
      const Outcome outcome = run(folder, "parhelion check scene.toml");
      CHECK_MESSAGE(outcome.exit == 0, document.filename() << "\n" << outcome.err);
    }
  CHECK(scenes >= 1);
}

TEST_CASE("every picture, page and heading that the documentation links to is there") {
  for (const auto& document : documents()) {
    const std::string text = readFile(document);
    for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](", at + 1)) {
      const std::string target = text.substr(at + 2, text.find(')', at) - at - 2);
      if (target.rfind("http", 0) == 0) continue;
      const std::size_t hash = target.find('#');
      const auto page = hash == 0 ? document : document.parent_path() / target.substr(0, hash);
      CHECK_MESSAGE(std::filesystem::exists(page), document.filename() << " links to " << target);
      if (hash != std::string::npos && std::filesystem::exists(page))
        CHECK_MESSAGE(hasAnchor(page, target.substr(hash + 1)), document.filename() << " links to " << target);
    }
  }
}
