// SPDX-License-Identifier: Apache-2.0
#include "cli/file_words.h"

#include <map>
#include <stdexcept>

#include "cli/commands.h"
#include "cli/own_files.h"
#include "picture/file_kind.h"
#include "picture/picture_text.h"
#include "render/own_pictures.h"
#include "render/scene_attributes.h"

namespace parhelion::cli {

namespace {

using Family = FileKind::Family;

constexpr const char* kOfPhotograph =
    "parhelion composite sets a halo into it, parhelion view looks at it, parhelion info says what it holds";
constexpr const char* kOfScene = "parhelion render makes a picture of a scene, parhelion trace a tally";
constexpr const char* kOfTally =
    "parhelion recon makes a picture of it, parhelion view looks at it, parhelion merge adds others, parhelion info "
    "--scene prints its scene";
constexpr const char* kOfOwnPicture = "parhelion view looks at it, parhelion info says what it holds";
constexpr const char* kOfSky = "parhelion view looks at it, parhelion info --scene prints the scene it was made from";

/// What a file is to commands.
enum class Role { scene, tally, exr, otherPhotograph, none };

struct Found {
  Role role;
  std::string name;  // with its article
  std::string hint;
};

Found foundPicture(const std::filesystem::path& path, const FileKind& kind) {
  Found found{kind.family == Family::exr ? Role::exr : Role::otherPhotograph, kind.name, kOfPhotograph};
  std::map<std::string, std::string> text;
  try {
    text = readPictureText(path);
  } catch (const std::runtime_error&) {  // damaged, or in a pipe: its kind is all there is to say
  }
  if (text.contains(kTallyKey)) return {Role::tally, "a tally", kOfTally};
  if (!saysParhelion(text)) return found;
  found.name += " that parhelion has made";
  found.hint = text.contains(kSceneKey) ? kOfSky : kOfOwnPicture;
  return found;
}

Found foundIn(const std::filesystem::path& path, std::string_view start) {
  const FileKind kind = kindOf(start);
  if (kind.isPhotograph()) return foundPicture(path, kind);
  switch (kind.family) {
    case Family::text:
      if (std::filesystem::is_regular_file(path) && isOwnFile(path))
        return {Role::none, "a table or chart that parhelion has written", ""};
      return {Role::scene, "a text file", kOfScene};
    case Family::otherPicture:
      return {Role::none, kind.name, "convert it to JPEG, PNG or EXR, the pictures that parhelion reads"};
    default:
      return {Role::none, kind.name, ""};
  }
}

bool serves(Role role, Wanted wanted) {
  switch (wanted) {
    case Wanted::scene:
      return role == Role::scene;
    case Wanted::tally:
      return role == Role::tally;
    case Wanted::sky:
      return role == Role::exr;
    case Wanted::photograph:
      return role == Role::exr || role == Role::otherPhotograph;
    case Wanted::view:
      return role == Role::exr || role == Role::otherPhotograph || role == Role::tally;
  }
  return true;
}

const char* nameOf(Wanted wanted) {
  switch (wanted) {
    case Wanted::scene:
      return "a scene";
    case Wanted::tally:
      return "a tally";
    case Wanted::sky:
      return "a sky that render or recon has written";
    case Wanted::photograph:
      return "a photograph";
    case Wanted::view:
      return "a picture";
  }
  return "";
}

}  // namespace

std::optional<Misfit> misfitOf(const std::filesystem::path& path, std::string_view start, Wanted wanted) {
  if (start.empty()) return {};  // what is not there or cannot be read is its reader's to tell
  const Found found = foundIn(path, start);
  if (serves(found.role, wanted)) return {};
  return Misfit{"is " + found.name + ", not " + nameOf(wanted), found.hint};
}

void requireFit(const std::filesystem::path& path, Wanted wanted) {
  const std::optional<Misfit> misfit = misfitOf(path, startOfFile(path), wanted);
  if (!misfit) return;
  throw Unfit(path.string() + ": " + misfit->message + (misfit->hint.empty() ? "" : ": " + misfit->hint));
}

}  // namespace parhelion::cli
