// SPDX-License-Identifier: Apache-2.0
// The lines of rare arcs against the light that the tracer sends over the faces that make them.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "halos/experiment.h"
#include "optics/halo_forms.h"

using namespace parhelion;

namespace {

/// Distance (degrees) of a point of the sky from a halo's lines.
double distance(const HaloCurve& curve, const Vec3& toSky) {
  double nearest2 = 4.0;
  for (const SkyLine& line : curve.lines)
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vec3 piece = line[i] - line[i - 1];
      const double along = std::clamp(glm::dot(toSky - line[i - 1], piece) / glm::dot(piece, piece), 0.0, 1.0);
      const Vec3 off = toSky - (line[i - 1] + along * piece);
      nearest2 = std::min(nearest2, glm::dot(off, off));
    }
  return degrees(std::sqrt(nearest2));
}

/// The faces of a path as turns about c from its first prism face, in sixths and to the side where they begin; ends are
/// 'e'. Columns may stand either way round.
std::string shapeOf(const LightPath& path, int order) {
  std::string shape;
  int first = 0;
  bool mirrored = false, turned = false;
  for (int k = 0; k <= order; ++k) {
    const int face = path.encounters[static_cast<std::size_t>(k)].faceNumber;
    if (isBasal(face)) {
      shape += 'e';
      continue;
    }
    if (first == 0) first = face;
    int turn = (face - first + 6) % 6;
    if (!turned && turn % 3 != 0) {
      turned = true;
      mirrored = turn > 3;
    }
    if (mirrored) turn = (6 - turn) % 6;
    shape += static_cast<char>('0' + turn);
  }
  return shape;
}

struct Arc {
  const char* name;
  OrientationSettings orientation;
  double sun, aspect;                                    // degrees
  std::vector<std::string> shapes;                       // of the paths that make it
  std::function<bool(const LightPath&)> only = nullptr;  // of these
};

/// Distances (degrees) of all light of an arc's paths from its line.
std::vector<double> distances(const Arc& arc, std::uint64_t rays) {
  const HaloForms forms = haloForms(radians(arc.sun), kIndex);
  const auto curve =
      std::find_if(forms.curves.begin(), forms.curves.end(), [&](const HaloCurve& c) { return c.name == arc.name; });
  REQUIRE_MESSAGE(curve != forms.curves.end(), arc.name);
  std::vector<double> found;
  const Cloud cloud = cloudUnderPointSun(radians(arc.sun), {prisms(arc.aspect, arc.orientation)});
  forEachRay(cloud, rays, [&](const LightPath& path) {
    for (const Exit& exit : path.exits)
      if (!exit.undeviated && (!arc.only || arc.only(path)) &&
          std::find(arc.shapes.begin(), arc.shapes.end(), shapeOf(path, exit.order)) != arc.shapes.end())
        found.push_back(distance(*curve, -exit.lightDirWorld));
  });
  return found;
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

TEST_CASE("all light over the faces of heliac, subhelic, Tricker, Hastings and Kern arcs lies on their lines") {
  // A line's chords of a quarter of a degree keep that near to it.
  constexpr double kChords = 2e-3;  // degrees
  const auto offSlope = [](const LightPath& path) { return path.encounters[0].faceNumber % 3 != 0; };
  // Face 6 of a Parry column is its upper one, face 3 the lower, and the others' normals point up from 5 and 7.
  const auto inByTop = [](const LightPath& path) { return path.encounters[0].faceNumber == 6; };
  const auto outByBottom = [](const LightPath& path) {
    const int in = path.encounters[0].faceNumber;
    return (in == 5 || in == 7) && path.encounters[1].faceNumber == 3;
  };
  const auto inByLower = [](const LightPath& path) {
    const int in = path.encounters[0].faceNumber;
    return (in == 4 || in == 8) && path.encounters[1].faceNumber % 2 == 0 && path.encounters[1].faceNumber != 6;
  };
  const Arc arcs[] = {
      {"heliac arc", parryOrientation(), 20, 2, {"0"}, offSlope},
      {"heliac arc", parryOrientation(), 60, 2, {"0"}, offSlope},
      {"subhelic arc", columnOrientation(), 20, 2, {"e02e", "e01e"}},
      {"subhelic arc", columnOrientation(), 50, 2, {"e02e", "e01e"}},
      {"Tricker arc", columnOrientation(), 20, 1.5, {"02e41", "0e241", "024e1", "03e15", "0e315", "031e5"}},
      {"Tricker arc", columnOrientation(), 5, 1.5, {"e0e2e", "e02ee"}},
      {"upper suncave Parry arc", parryOrientation(), 20, 2, {"02"}, inByTop},
      {"lower suncave Parry arc", parryOrientation(), 50, 2, {"02"}, outByBottom},
      {"lower sunvex Parry arc", parryOrientation(), 20, 2, {"02"}, inByLower},
      {"Hastings arc", parryOrientation(), 20, 2, {"0e2"}, inByTop},
      {"Kern arc", plateOrientation(), 20, 0.4, {"e0ee2", "e02"}},
  };
  for (const Arc& arc : arcs) {
    CAPTURE(std::string(arc.name));
    CAPTURE(arc.sun);
    const std::vector<double> off = distances(arc, 60'000);
    CHECK(off.size() > 20);
    if (!off.empty()) CHECK(quantile(off, 1.0) < kChords);
  }
}

TEST_CASE("light over the faces of Wegener and Lowitz arcs is densest on their lines, which are its edges") {
  // At a fold the density grows as the inverse root of the distance: within a twentieth of a degree it is at least
  // three times that between a half and one degree. Counts of that share scatter by a few percent: it is ten sigma
  // more.
  const Arc arcs[] = {{"Wegener arc", columnOrientation(), 20, 2, {"0e2"}},
                      {"Wegener arc", columnOrientation(), 40, 2, {"0e2"}},
                      {"Lowitz arc", LowitzOrientation{}, 20, 0.4, {"02"}},
                      {"Lowitz arc", LowitzOrientation{}, 45, 0.4, {"02"}}};
  for (const Arc& arc : arcs) {
    CAPTURE(std::string(arc.name));
    CAPTURE(arc.sun);
    const std::vector<double> off = distances(arc, 60'000);
    const auto within = [&](double from, double to) {
      return static_cast<double>(std::count_if(off.begin(), off.end(), [&](double d) { return d >= from && d < to; })) /
             (to - from);
    };
    CHECK(within(0.0, 0.05) * 0.05 > 100.0);
    CHECK(within(0.0, 0.05) > 3.0 * within(0.5, 1.0));
  }
}

TEST_CASE("light over the faces of the diffuse arcs is dense about their lines") {
  const Arc arc{"diffuse arcs", columnOrientation(), 20, 2, {"0e24", "02e4", "024e"}};
  const std::vector<double> off = distances(arc, 200'000);
  REQUIRE(off.size() > 1000);
  const auto within = [&](double from, double to) {
    return static_cast<double>(std::count_if(off.begin(), off.end(), [&](double d) { return d >= from && d < to; })) /
           (to - from);
  };
  // Counts of some hundreds scatter by a twentieth: the factor of two is ten sigma.
  CHECK(within(0.0, 0.5) > 2.0 * within(3.0, 6.0));
}
