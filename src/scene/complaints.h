// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene_error.h"
#include "scene/scene_override.h"

namespace parhelion {

/// A stretch of one of the texts, from 1 in code points; line 0 means the text as a whole. `endColumn` is exclusive.
struct Place {
  std::size_t text = 0;  // as addText() numbered it
  int line = 0;
  int column = 0;
  int endLine = 0;
  int endColumn = 0;
};

/// All that is wrong with a scene, collected so that it is told at once.
class Complaints {
 public:
  /// A text that places refer to: the scene file or an override. Returns its number; errors sort in this order.
  std::size_t addText(std::string_view name, std::string_view text);

  /// The same for an override, by its name. Of one that an option stands for, complaints show the user's word, in which
  /// they count columns, and do not name the key.
  void addOverride(const SceneOverride& override);

  /// The number of the text last added under this name.
  std::size_t textNamed(std::string_view name) const;

  void add(const Place& place, std::string_view message, std::string_view hint = "");

  /// Where `part` of a string stands that begins at `value`: a byte range of the string's text. The place of the whole
  /// string where its text is written in another way, with escapes or over several lines.
  Place placeIn(const Place& value, std::string_view text, std::size_t at, std::size_t length) const;

  /// Throws SceneError where there is anything to complain about.
  void throwIfAny();

 private:
  struct Text {
    std::string name;
    std::vector<std::string> lines;
    SceneOverride override = {};
  };
  struct Complaint {
    Place place;
    Diagnostic diagnostic;
  };

  /// What a complaint shows.
  struct Words {
    Place place;
    std::string_view message;
    std::vector<std::string> lines;
  };

  std::string excerpt(const Place& place, const std::vector<std::string>& lines) const;
  /// A complaint about an override is told in the words of who typed the option that stands for it.
  Words wordsFor(const Place& place, std::string_view message) const;

  std::vector<Text> texts_;
  std::vector<Complaint> complaints_;
};

}  // namespace parhelion
