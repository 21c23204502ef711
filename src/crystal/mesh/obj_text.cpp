// SPDX-License-Identifier: Apache-2.0
#include "crystal/mesh/obj_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <tuple>

#include "math/number_text.h"

namespace parhelion {

namespace {

// Statements that say nothing about the shape.
constexpr std::array<std::string_view, 25> kPassedOver{
    "vn",     "vt",   "vp",    "s",    "mg",       "usemtl",   "mtllib",     "usemap",    "maplib",
    "l",      "p",    "bevel", "lod",  "c_interp", "d_interp", "shadow_obj", "trace_obj", "deg",
    "cstype", "parm", "trim",  "hole", "scrv",     "sp",       "end"};

constexpr std::string_view kSpaces = " \t\r\v\f";

/// The next word of a line, taken off it; empty at its end.
std::string_view takeWord(std::string_view& line) {
  const std::size_t begin = std::min(line.find_first_not_of(kSpaces), line.size());
  const std::size_t end = std::min(line.find_first_of(kSpaces, begin), line.size());
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

/// A word for a message, cut short, without what is no printable ASCII.
std::string shown(std::string_view word) {
  constexpr std::size_t kMost = 40;
  std::string text(word.substr(0, kMost));
  std::ranges::replace_if(
      text, [](char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + text + (word.size() > kMost ? "…'" : "'");
}

class Reader {
 public:
  explicit Reader(std::string_view text) : left_(text) {}

  ObjMesh read() {
    if (left_.find('\0') != std::string_view::npos) throw ObjError(0, "this is no text and so no OBJ");
    std::string joined;
    while (!left_.empty()) {
      const int first = line_ + 1;
      statement(takeLine(joined), first);
    }
    if (mesh_.polygons.empty()) throw ObjError(0, "there are no faces ('f') in it");
    for (ObjPolygon& polygon : mesh_.polygons) {
      if (lastOf(polygon) >= static_cast<int>(places_.size()))
        throw ObjError(polygon.line, "this face names vertex " + std::to_string(lastOf(polygon) + 1) +
                                         ", but there are " + std::to_string(places_.size()));
      for (int& corner : polygon.corners) corner = places_[static_cast<std::size_t>(corner)];
    }
    return std::move(mesh_);
  }

 private:
  static int lastOf(const ObjPolygon& polygon) { return std::ranges::max(polygon.corners); }

  /// The next line with those that a backslash joins to it, without comments. `joined` is where it is put together.
  std::string_view takeLine(std::string& joined) {
    joined.clear();
    for (;;) {
      const std::size_t end = std::min(left_.find('\n'), left_.size());
      std::string_view line = left_.substr(0, end);
      left_.remove_prefix(std::min(end + 1, left_.size()));
      ++line_;
      line = line.substr(0, std::min(line.find('#'), line.size()));
      const std::size_t last = line.find_last_not_of(kSpaces);
      const bool goesOn = last != std::string_view::npos && line[last] == '\\' && !left_.empty();
      if (!goesOn && joined.empty()) return line;
      joined.append(goesOn ? line.substr(0, last) : line).push_back(' ');
      if (!goesOn) return joined;
    }
  }

  void statement(std::string_view line, int number) {
    const std::string_view word = takeWord(line);
    if (word.empty()) return;
    if (word == "v") return vertex(line, number);
    if (word == "f") return polygon(line, number);
    if (word == "g" || word == "o") return name(line, word == "g");
    if (std::ranges::find(kPassedOver, word) == kPassedOver.end())
      throw ObjError(number, shown(word) + " is no statement of an OBJ of polygons");
  }

  void vertex(std::string_view line, int number) {
    if (places_.size() == kMostObjVertices)
      throw ObjError(number, "there are more than " + std::to_string(kMostObjVertices) + " vertices");
    Vec3 v(0.0);
    for (int k = 0; k < 3; ++k) {
      const std::string_view word = takeWord(line);
      const auto x = numberIn(word);
      if (!x || !(std::abs(*x) <= kFarthest))
        throw ObjError(number, "a vertex needs three numbers between -1e9 and 1e9" +
                                   (word.empty() ? std::string() : ", not " + shown(word)));
      v[k] = *x + 0.0;  // no zero with a sign
    }
    const auto [place, isNew] = known_.try_emplace({v.x, v.y, v.z}, static_cast<int>(mesh_.vertices.size()));
    if (isNew) mesh_.vertices.push_back(v);
    places_.push_back(place->second);
  }

  void polygon(std::string_view line, int number) {
    if (mesh_.polygons.size() == kMostObjPolygons)
      throw ObjError(number, "there are more than " + std::to_string(kMostObjPolygons) + " faces");
    ObjPolygon polygon{{}, number, groupNumber_ ? groupNumber_ : objectNumber_};
    for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
      if (polygon.corners.size() == kMostObjCorners)
        throw ObjError(number, "a face has more than " + std::to_string(kMostObjCorners) + " corners");
      const auto index = wholeNumberIn(word.substr(0, std::min(word.find('/'), word.size())));
      const auto here = static_cast<std::int64_t>(places_.size());
      if (!index || *index == 0 || *index < -here || *index > kMostObjVertices)
        throw ObjError(number, shown(word) + " is no vertex: of " + std::to_string(here) +
                                   " so far, the first is 1 and the last one -1");
      polygon.corners.push_back(static_cast<int>(*index > 0 ? *index - 1 : here + *index));
    }
    if (polygon.corners.size() < 3) throw ObjError(number, "a face needs three corners at least");
    corners_ += static_cast<int>(polygon.corners.size());
    if (corners_ > kMostObjCornersInAll)
      throw ObjError(number, "the faces have more than " + std::to_string(kMostObjCornersInAll) + " corners in all");
    mesh_.polygons.push_back(std::move(polygon));
  }

  /// Of a group or of an object. A new object has no group yet.
  void name(std::string_view line, bool isGroup) {
    const auto named = wholeNumberIn(takeWord(line));
    std::optional<int> number;
    if (named && *named >= 1 && *named <= kMostObjFaceNumber) number = static_cast<int>(*named);
    if (!isGroup) objectNumber_ = number;
    groupNumber_ = isGroup ? number : std::nullopt;
  }

  static constexpr double kFarthest = 1e9;

  std::string_view left_;
  int line_ = 0, corners_ = 0;
  ObjMesh mesh_;
  std::vector<int> places_;  // of the file's vertices among those that differ
  std::map<std::tuple<double, double, double>, int> known_;
  std::optional<int> groupNumber_, objectNumber_;
};

void append(std::string& text, double x) {
  std::array<char, 32> digits{};
  text.append(" ").append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr);
}

}  // namespace

ObjMesh readObj(std::string_view text) { return Reader(text).read(); }

std::string objText(const ObjMesh& mesh) {
  std::string text;
  for (const Vec3& v : mesh.vertices) {
    text += "v";
    for (int k = 0; k < 3; ++k) append(text, v[k]);
    text += "\n";
  }
  std::optional<int> number;
  for (const ObjPolygon& polygon : mesh.polygons) {
    if (polygon.number != number) text += "g " + (polygon.number ? std::to_string(*polygon.number) : "off") + "\n";
    number = polygon.number;
    text += "f";
    for (const int corner : polygon.corners) text += " " + std::to_string(corner + 1);
    text += "\n";
  }
  return text;
}

}  // namespace parhelion
