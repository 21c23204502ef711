// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>

#include "scene/scene_keys.h"

namespace parhelion {

namespace kinds {

namespace {

constexpr Range kSide{-100.0, 100.0};
constexpr Range kHeight{0.0, 1.0};
constexpr Range kSlopeDegrees{0.0, 90.0, true, true};
constexpr int kLargestMiller = 99;

/// Whether a table is a distribution by its only key.
bool isDistribution(const toml::table& table) {
  return table.size() == 1 && (table.contains(Normal::kWords.name) || table.contains(UniformRange::kWords.name) ||
                               table.contains(Laplace::kWords.name) || table.contains(LogNormal::kWords.name));
}

}  // namespace

namespace {

using SideMask = std::array<bool, 6>;

/// Sets sides of the shapes that have some.
void setSides(const SideMask& which, const LengthDistribution& distribution, PopulationShape& shape) {
  const auto set = [&](auto& own) {
    if constexpr (requires { own.sides; }) setLength(own, {ShapeLength::sides, which, distribution});
  };
  std::visit(set, shape);
}

/// Every `period`-th side is drawn with the first.
void tieSides(std::size_t period, const LengthDistribution& distribution, PopulationShape& shape) {
  for (std::size_t first = 0; first < period; ++first) {
    SideMask which{};
    for (std::size_t k = first; k < which.size(); k += period) which[k] = true;
    setSides(which, distribution, shape);
  }
}

// What a table of sides may begin with.
constexpr std::array<std::string_view, 7> kSideWords{Normal::kWords.name,
                                                     UniformRange::kWords.name,
                                                     Laplace::kWords.name,
                                                     LogNormal::kWords.name,
                                                     "twofold",
                                                     "threefold",
                                                     "sixfold"};

constexpr const char* kSidesHint =
    "distances of faces 3 to 8 from the axis, 1 those of a regular prism: [1, 2, 1, 2, 1, 2] is a triangle";

}  // namespace

bool SideDistances::read(const Value& in, PopulationShape& out) const {
  const toml::table* table = in.node.as_table();
  if (table && !isDistribution(*table)) {
    for (const auto& [key, value] : *table) {
      if (std::ranges::find(kSideWords, key.str()) != kSideWords.end()) continue;
      in.complaints.add(placeOf(key.source(), in.complaints), "unknown key of the sides",
                        didYouMean(key.str(), kSideWords));
      return false;
    }
    TiedSideKeys keys;
    TableReader reader(*table, "the table of sides", in.complaints);
    visitKeys(reader, keys);
    if (!reader.rejectUnknown()) return false;
    if (table->size() > 1) return in.reject("sides are tied in one way only", "leave one of the keys out");
    if (keys.twofold) tieSides(3, *keys.twofold, out);
    if (keys.threefold) tieSides(2, *keys.threefold, out);
    if (keys.sixfold) tieSides(1, *keys.sixfold, out);
    return keys.twofold || keys.threefold || keys.sixfold;
  }
  LengthDistribution one;
  if (table) {
    if (!Length{kSide}.read(in, one)) return false;
    tieSides(6, one, out);
    return true;
  }
  const toml::array* list = in.node.as_array();
  if (!list || list->size() != std::tuple_size_v<Sides>)
    return in.mustBe("six numbers or distributions, or one distribution for all", kSidesHint);
  bool good = true;
  for (std::size_t k = 0; k < list->size(); ++k) {
    SideMask which{};
    which[k] = true;
    if (Length{kSide}.read({(*list)[k], in.key, in.complaints}, one))
      setSides(which, one, out);
    else
      good = false;
  }
  return good;
}

Json SideDistances::schema() const {
  const Json side = Length{kSide}.schema();
  return {{"anyOf",
           {listSchema(side, std::tuple_size_v<Sides>, std::tuple_size_v<Sides>), side["anyOf"][1],
            tableSchema<TiedSideKeys>()}}};
}

bool Miller::read(const Value& in, std::array<int, 2>& out) const {
  const auto numbers = in.numbersIn(4, 4, {-kLargestMiller, kLargestMiller});
  const auto isIndex = [](double x) { return x >= 1.0 && x == std::floor(x); };
  if (!numbers || !isIndex((*numbers)[0]) || (*numbers)[1] != 0.0 || (*numbers)[2] != -(*numbers)[0] ||
      !isIndex((*numbers)[3]))
    return in.mustBe("the Miller indices [h, 0, -h, l] with h and l integers from 1 to 99",
                     "the usual pyramid is [1, 0, -1, 1]");
  out = {static_cast<int>((*numbers)[0]), static_cast<int>((*numbers)[3])};
  return true;
}

Json Miller::schema() const { return listSchema({{"type", "integer"}}, 4, 4); }

bool PyramidEnd::read(const Value& in, PopulationShape& out) const {
  using What = ShapeLength;
  PyramidEndKeys keys;
  const toml::table* table = in.node.as_table();
  if (table && !isDistribution(*table)) {
    TableReader reader(*table, std::string("the pyramid's '").append(in.key) + "'", in.complaints);
    visitKeys(reader, keys);
    if (!reader.rejectUnknown() || reader.rejected("height") || reader.rejected("slope") || reader.rejected("miller"))
      return false;
    if (keys.slope && keys.miller) {
      reader.reject("miller", "'miller' says what 'slope' says, too", "leave one of them out");
      return false;
    }
    if (keys.miller) keys.slope = FixedValue{slopeOfMiller((*keys.miller)[0], (*keys.miller)[1])};
  } else if (in.isNumber() || table) {
    if (!Length{kHeight}.read(in, keys.height)) return false;
  } else {
    return in.mustBe("a number " + kHeight.text() + ", a distribution or a table",
                     "its height as a share of its full height: 0.5, or { miller = [1, 0, -1, 1], height = 0.5 }");
  }
  if (auto* pyramid = std::get_if<PyramidSettings>(&out)) {
    setLength(*pyramid, {isUpper ? What::upper : What::lower, {}, keys.height});
    if (keys.slope) setLength(*pyramid, {isUpper ? What::upperSlope : What::lowerSlope, {}, *keys.slope});
  }
  return true;
}

Json PyramidEnd::schema() const {
  const Json height = Length{kHeight}.schema();
  return {{"anyOf", {height["anyOf"][0], height["anyOf"][1], tableSchema<PyramidEndKeys>()}}};
}

bool PyramidSlope::read(const Value& in, PopulationShape& out) const {
  if (auto* rosette = std::get_if<RosetteSettings>(&out)) return Angle{kSlopeDegrees}.read(in, rosette->slope);
  LengthDistribution slope;
  if (!Length{kSlopeDegrees, "degrees"}.read(in, slope)) return false;
  if (auto* pyramid = std::get_if<PyramidSettings>(&out)) setLength(*pyramid, {ShapeLength::slope, {}, slope});
  return true;
}

Json PyramidSlope::schema() const { return Length{kSlopeDegrees, "degrees"}.schema(); }

namespace {

/// Reads a table of which a key must be there and all must be good.
template <class Keys>
bool readTable(const Value& in, std::string_view needed, std::string_view hint, Keys& keys) {
  const toml::table* table = in.node.as_table();
  if (!table) return in.mustBe("a table", std::string(hint));
  TableReader reader(*table, std::string("the prism's '").append(in.key) + "'", in.complaints);
  visitKeys(reader, keys);
  bool good = reader.rejectUnknown();
  for (const auto& [key, value] : *table) good &= !reader.rejected(key.str());
  if (good && !reader.has(needed))
    return in.reject(std::string("'").append(in.key) + "' needs a '" + std::string(needed) + "'", std::string(hint));
  return good;
}

}  // namespace

template <class Part>
bool PrismEndTable<Part>::read(const Value& in, PopulationShape& out) const {
  Part own;
  if (!readTable(in, needed, hint, own)) return false;
  if (auto* prism = std::get_if<PrismSettings>(&out)) {
    if (upper) prism->upper.*part = own;
    if (lower) prism->lower.*part = own;
  }
  return true;
}

template struct PrismEndTable<Cavity>;
template struct PrismEndTable<Cap>;

bool NotchTable::read(const Value& in, PopulationShape& out) const {
  Notch notch;
  if (!readTable(in, "depth", "a notch in each side of a prism: { depth = 0.6, width = 0.4 }", notch)) return false;
  if (auto* prism = std::get_if<PrismSettings>(&out)) prism->notch = notch;
  return true;
}

bool Mesh::read(const Value& in, PopulationShape& out) const {
  const auto text = in.string();
  if (!text || text->find('\n') == std::string::npos)
    return in.mustBe("the name of an OBJ file", "mesh = \"crystal.obj\"; it is looked for beside the scene");
  try {
    const ObjMesh obj = readObj(*text);
    auto crystal = std::make_shared<const CrystalMesh>(meshFromObj(obj));
    if (auto* mesh = std::get_if<MeshSettings>(&out)) *mesh = {objText(obj), std::move(crystal)};
    return true;
  } catch (const ObjError& error) {
    return in.reject((error.line() > 0 ? "line " + std::to_string(error.line()) + " of the OBJ: " : "the OBJ: ") +
                     error.what());
  } catch (const std::invalid_argument& error) {
    return in.reject(std::string("the OBJ: ") + error.what());
  }
}

bool Direction::read(const Value& in, Vec3& out) const {
  const auto numbers = in.numbersIn(3, 3, {-1e6, 1e6});
  const double length = numbers ? std::hypot((*numbers)[0], (*numbers)[1], (*numbers)[2]) : 0.0;
  if (!(length > 0.0))
    return in.mustBe("a direction [x, y, z], three numbers of which one at least is not 0",
                     "z is along the c axis, x through the middle of face 3");
  out = Vec3((*numbers)[0] / length, (*numbers)[1] / length, (*numbers)[2] / length);
  return true;
}

Json Direction::schema() const { return listSchema({{"type", "number"}}, 3, 3); }

bool PlaneList::read(const Value& in, std::vector<FacePlane>& out) const {
  const toml::array* list = in.node.as_array();
  if (!list || list->empty())
    return in.mustBe("a list of planes", "each is a table: { normal = [0, 0, 1], distance = 1, face = 1 }");
  out.clear();
  std::set<int> faces;
  bool good = true;
  for (const toml::node& node : *list) {
    const Value one{node, in.key, in.complaints};
    const toml::table* table = node.as_table();
    if (!table) return one.mustBe("a list of tables", "{ normal = [0, 0, 1], distance = 1, face = 1 }");
    TableReader reader(*table, "a plane", in.complaints);
    PlaneKeys keys;
    visitKeys(reader, keys);
    good &= reader.rejectUnknown() && !reader.rejected("distance") && !reader.rejected("face");
    if (!keys.normal) {
      if (!reader.has("normal")) one.reject("a plane needs a 'normal', the direction that it faces");
      good = false;
      continue;
    }
    const int number = keys.face.value_or(static_cast<int>(out.size()) + 1);
    if (!faces.insert(number).second) {
      const std::string message = "two planes are face " + std::to_string(number);
      good = false;
      if (reader.has("face"))
        reader.reject("face", message);
      else
        one.reject(message, "planes without a 'face' are counted from 1");
    }
    out.push_back({number, *keys.normal, keys.distance});
  }
  return good;
}

Json PlaneList::schema() const {
  Json plane = tableSchema<PlaneKeys>();
  plane["required"] = {"normal"};
  return {{"type", "array"}, {"minItems", 1}, {"items", plane}};
}

}  // namespace kinds

}  // namespace parhelion
