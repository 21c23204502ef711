// SPDX-License-Identifier: Apache-2.0
#include "scene/overrides.h"

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>
#include <utility>

#include "scene/schema.h"
#include "scene/suggest.h"
#include "scene/text_guard.h"
#include "scene/utf8.h"
#include "scene/value.h"

namespace parhelion {

namespace {

// population.0.orientation.zenith.normal
constexpr std::size_t kMaxSegments = 5;

/// A part of the dotted path and where it is in the override.
struct Segment {
  std::string_view text;
  toml::source_region source;
};

std::string untabbed(std::string text) {
  std::replace(text.begin(), text.end(), '\t', ' ');
  return text;
}

/// Applies one override; keeps what is needed to say where something is wrong.
class Override {
 public:
  Override(const SceneOverride& override, Complaints& complaints)
      : text_(override.text), complaints_(complaints), path_(std::make_shared<const std::string>(override.name())) {
    complaints_.addOverride(override);
  }

  void applyTo(toml::table& scene) {
    if (printable(text_, text_.size()) != untabbed(text_)) {
      return complain(regionOf(0, text_.size()), "an override is one line of UTF-8 text without control characters");
    }
    const std::size_t equals = text_.find('=');
    if (equals == std::string::npos) return complain(regionOf(0, text_.size()), "an override is key.path=value");
    const std::vector<Segment> segments = split(equals);
    for (const Segment& segment : segments) {
      if (segment.text.empty()) return complain(segment.source, "a key is missing here; an override is key.path=value");
    }
    if (segments.size() > kMaxSegments) return complain(regionOf(0, equals), "no key of a scene lies so deep");
    if (const std::string hint = populationHint(scene, segments); !hint.empty())
      return complain(segments.front().source, std::string("unknown key '").append(segments.front().text) + "'", hint);

    toml::node* parent = &scene;
    for (std::size_t i = 0; parent && i + 1 < segments.size(); ++i) parent = descend(*parent, segments[i]);
    if (!parent) return;
    if (trimmed(std::string_view(text_).substr(equals + 1)).empty()) return takeOut(*parent, segments.back());
    if (segments.size() == 2 && segments.front().text == "sun") displaceSun(*parent, segments.back().text);
    set(*parent, segments.back(), parseValue(equals));
  }

 private:
  void complain(const toml::source_region& source, const std::string& message, const std::string& hint = "") {
    complaints_.add(placeOf(source, complaints_), message, hint);
  }

  /// The bytes from `begin` to `end` as line 1 of the override.
  toml::source_region regionOf(std::size_t begin, std::size_t end) const {
    const auto column = [&](std::size_t byte) {
      return static_cast<toml::source_index>(countCodePoints(std::string_view(text_).substr(0, byte)) + 1);
    };
    return {{1, column(begin)}, {1, column(end)}, path_};
  }

  std::vector<Segment> split(std::size_t equals) const {
    std::vector<Segment> segments;
    std::size_t begin = 0;
    while (begin <= equals) {
      const std::size_t end = std::min(text_.find('.', begin), equals);
      segments.push_back({trimmed(std::string_view(text_).substr(begin, end - begin)), regionOf(begin, end)});
      begin = end + 1;
    }
    return segments;
  }

  /// "did you mean 'population.plates.tilt'?" where the path begins with the name of a population, or nearly so.
  static std::string populationHint(const toml::table& scene, const std::vector<Segment>& segments) {
    const toml::array* populations = scene["population"].as_array();
    if (!populations || isTable(segments.front().text)) return {};
    std::vector<std::string> paths;
    for (const toml::node& node : *populations) {
      const toml::table* population = node.as_table();
      const auto name = population ? (*population)["name"].value<std::string>() : std::nullopt;
      if (!name || didYouMean(segments.front().text, std::vector<std::string_view>{*name}).empty()) continue;
      paths.push_back("population." + *name);
      for (auto segment = segments.begin() + 1; segment != segments.end(); ++segment)
        paths.back().append(".").append(segment->text);
    }
    return paths.empty() ? "" : "did you mean '" + paths.front() + "'?";
  }

  /// The value as a TOML document in which it has the same column as in the override.
  toml::table parseValue(std::size_t equals) const {
    const std::string margin = std::string("v").append(countCodePoints(text_.substr(0, equals)) - 1, ' ') + '=';
    const std::string value = text_.substr(equals + 1);
    try {
      if (!findTextProblem(margin + value)) {
        toml::table table = toml::parse(margin + value, *path_);
        if (table.size() == 1 && table.contains("v")) return table;
      }
    } catch (const toml::parse_error&) {
      // a bare string
    }
    std::string quoted;
    for (const char c : value) quoted += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    return toml::parse(margin + '"' + quoted + '"', *path_);
  }

  toml::node* descend(toml::node& parent, const Segment& segment) {
    if (toml::array* list = parent.as_array()) return element(*list, segment);
    toml::table* table = parent.as_table();
    if (!table) {
      complain(segment.source,
               std::string("there is no '").append(segment.text) + "' here: the scene has a plain value");
      return nullptr;
    }
    if (!table->contains(segment.text)) table->insert(toml::key(segment.text, segment.source), toml::table{});
    return table->get(segment.text);
  }

  /// An element of a list by its index or its name.
  toml::node* element(toml::array& list, const Segment& segment) {
    std::vector<std::string> names;
    for (toml::node& node : list) {
      const toml::table* table = node.as_table();
      names.push_back(table ? (*table)["name"].value_or(std::string()) : std::string());
      if (names.back() == segment.text) return &node;
    }
    std::size_t index = 0;
    const char* const end = segment.text.data() + segment.text.size();
    const auto parsed = std::from_chars(segment.text.data(), end, index);
    if (parsed.ec == std::errc{} && parsed.ptr == end && index < list.size()) return &list[index];

    const std::vector<std::string_view> views(names.begin(), names.end());
    std::string hint = didYouMean(segment.text, views);
    hint += (hint.empty() ? "" : " ") + std::string("accepted: an index from 0 to ") + std::to_string(list.size() - 1);
    for (const std::string& name : names) hint += name.empty() ? "" : ", " + name;
    complain(segment.source, std::string("no element '").append(segment.text) + "' in this list", hint);
    return nullptr;
  }

  /// A sun that is placed by its elevation stands no longer where a date has put it, and the other way about.
  static void displaceSun(toml::node& sun, std::string_view key) {
    toml::table* table = sun.as_table();
    if (!table) return;
    if (key == "elevation" && table->contains("date"))
      for (const char* other : {"date", "latitude", "longitude", "refraction"}) table->erase(other);
    if (key == "date")
      for (const char* other : {"elevation", "azimuth"}) table->erase(other);
  }

  /// Makes the scene as if it had never said this key.
  void takeOut(toml::node& parent, const Segment& segment) {
    toml::table* table = parent.as_table();
    if (!table) return complain(segment.source, "only a key can be taken out, by an override without a value");
    if (table->erase(segment.text) > 0) return;
    std::vector<std::string_view> keys;
    for (const auto& [key, value] : *table) keys.push_back(key.str());
    complain(segment.source, std::string("the scene has no '").append(segment.text) + "' to take out",
             didYouMean(segment.text, keys));
  }

  void set(toml::node& parent, const Segment& segment, toml::table value) {
    // Moved, never copied: a copy of a node forgets its place.
    std::move(*value.get("v")).visit([&](auto&& node) {
      if (toml::table* table = parent.as_table()) {
        table->insert_or_assign(toml::key(segment.text, segment.source), std::move(node));
      } else if (toml::array* list = parent.as_array()) {
        const toml::node* old = element(*list, segment);
        for (auto at = list->cbegin(); old && at != list->cend(); ++at) {
          if (&*at == old) return void(list->replace(at, std::move(node)));
        }
      } else {
        complain(segment.source,
                 std::string("there is no '").append(segment.text) + "' here: the scene has a plain value");
      }
    });
  }

  const std::string& text_;
  Complaints& complaints_;
  std::shared_ptr<const std::string> path_;
};

}  // namespace

void applyOverride(toml::table& scene, const SceneOverride& override, Complaints& complaints) {
  Override(override, complaints).applyTo(scene);
}

}  // namespace parhelion
