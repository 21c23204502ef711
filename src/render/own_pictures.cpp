// SPDX-License-Identifier: Apache-2.0
#include "render/own_pictures.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "picture/picture_text.h"

namespace parhelion {

namespace {

/// Whether a line of a text begins with our name: tallies write it with a capital letter.
bool namesUs(std::string_view text) {
  for (const std::string_view name : {"parhelion ", "Parhelion "}) {
    for (std::size_t at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1))
      if (at == 0 || text[at - 1] == '\n') return true;
  }
  return false;
}

}  // namespace

bool saysParhelion(const std::map<std::string, std::string>& text) {
  // Who changes a picture of ours may keep its attributes, but says that it was him.
  for (const char* writer : {"software", "Software", "comment"})
    if (const auto found = text.find(writer); found != text.end()) return namesUs(found->second);
  return std::any_of(text.begin(), text.end(), [](const auto& entry) { return entry.first.starts_with("parhelion:"); });
}

bool isOwnPicture(const std::filesystem::path& path) {
  try {
    return saysParhelion(readPictureText(path));
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace parhelion
