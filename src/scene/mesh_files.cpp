// SPDX-License-Identifier: Apache-2.0
#include "scene/mesh_files.h"

#include <fstream>
#include <optional>
#include <string>
#include <system_error>

#include "crystal/mesh/mesh_from_obj.h"
#include "picture/limits.h"
#include "scene/named_files.h"

namespace parhelion {

namespace {

/// The text of a file; none where it has been complained about.
std::optional<std::string> textOf(const std::filesystem::path& path, const Place& place, Complaints& complaints) {
  std::error_code status;
  const auto refuse = [&](const char* why) {
    complaints.add(place, path.string() + why, "'mesh' is an OBJ file; it is looked for beside the scene");
    return std::nullopt;
  };
  if (!std::filesystem::exists(path, status)) return refuse(": no such file");
  if (!std::filesystem::is_regular_file(path, status)) return refuse(" is no file");
  std::ifstream file(path, std::ios::binary);
  std::string text(kMostMeshBytes + 1, '\0');
  if (file) file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!file.eof() && !file.good()) return refuse(" cannot be read");
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > kMostMeshBytes) return refuse(" is larger than 4 MiB: no crystal has so many faces");
  return text;
}

/// An OBJ that is a crystal, without all that does not matter.
std::optional<std::string> plainObj(const std::filesystem::path& path, const Place& place, Complaints& complaints) {
  const auto text = textOf(path, place, complaints);
  if (!text) return std::nullopt;
  try {
    const ObjMesh mesh = readObj(*text);
    static_cast<void>(meshFromObj(mesh));
    return objText(mesh);
  } catch (const ObjError& error) {
    complaints.add(place, path.string() + (error.line() > 0 ? ", line " + std::to_string(error.line()) : "") + ": " +
                              error.what());
  } catch (const std::invalid_argument& error) {
    complaints.add(place, path.string() + ": " + error.what());
  }
  return std::nullopt;
}

}  // namespace

bool readMeshFiles(toml::table& root, const std::filesystem::path& folder, Complaints& complaints) {
  std::size_t bytes = 0;
  const auto isName = [](const std::string& text) { return !text.empty() && text.find('\n') == std::string::npos; };
  const auto contents = [&](const std::string& name, const Place& place) -> std::optional<std::string> {
    auto text = plainObj(folder / name, place, complaints);
    if (!text) return std::nullopt;
    bytes += text->size();
    // What is made of a scene carries its meshes with it.
    if (bytes <= kMostMeshesInScene) return text;
    complaints.add(place, "the meshes of this scene are too large together");
    return std::nullopt;
  };
  return putFiles(root, "mesh", isName, contents, complaints);
}

}  // namespace parhelion
