// SPDX-License-Identifier: Apache-2.0
#include "crystal/mesh/surface_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

namespace parhelion {

namespace {

// Parts of a mesh closer than this share of its size touch.
constexpr double kTouching = 1e-9;
// Bodies and bubbles that a mesh may consist of, each of which is compared with all triangles.
constexpr int kMostParts = 64;

std::string lineOf(const ObjMesh& mesh, int polygon) {
  return "line " + std::to_string(mesh.polygons[static_cast<std::size_t>(polygon)].line);
}

[[noreturn]] void refuse(const ObjMesh& mesh, int polygon, const std::string& why) {
  throw ObjError(mesh.polygons[static_cast<std::size_t>(polygon)].line, why);
}

using Edges = std::map<std::pair<int, int>, int>;  // an edge in one sense, and the polygon that has it

Edges edgesOf(const ObjMesh& mesh) {
  Edges edges;
  for (int p = 0; p < static_cast<int>(mesh.polygons.size()); ++p) {
    const auto& ring = mesh.polygons[static_cast<std::size_t>(p)].corners;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const int a = ring[i], b = ring[(i + 1) % ring.size()];
      if (a == b) refuse(mesh, p, "this face has the same corner twice in a row");
      const auto [other, isNew] = edges.try_emplace({a, b}, p);
      if (!isNew)
        refuse(mesh, p,
               "this face and that of " + lineOf(mesh, other->second) +
                   " run along an edge in the same sense: one of them is turned around, or more than two faces "
                   "share the edge");
    }
  }
  return edges;
}

/// Number k of a union of sets.
int rootOf(std::vector<int>& parents, int k) {
  while (parents[static_cast<std::size_t>(k)] != k) {
    int& parent = parents[static_cast<std::size_t>(k)];
    k = parent = parents[static_cast<std::size_t>(parent)];
  }
  return k;
}

/// For each polygon, the first polygon of its part of the surface.
std::vector<int> partsOf(const ObjMesh& mesh) {
  std::vector<int> parents(mesh.polygons.size());
  std::iota(parents.begin(), parents.end(), 0);
  const Edges edges = edgesOf(mesh);
  for (const auto& [edge, polygon] : edges) {
    const int a = rootOf(parents, polygon), b = rootOf(parents, edges.at({edge.second, edge.first}));
    parents[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }
  for (int k = 0; k < static_cast<int>(parents.size()); ++k) parents[static_cast<std::size_t>(k)] = rootOf(parents, k);
  return parents;
}

/// Whether triangles in one plane overlap by more than `slack`, by the axes across their edges.
bool overlapInPlane(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b, const Vec3& normal, double slack) {
  for (const auto* own : {&a, &b})
    for (int k = 0; k < 3; ++k) {
      const Vec3 across = glm::cross(normal, (*own)[(k + 1) % 3] - (*own)[k]);
      const double length = glm::length(across);
      double highest[2] = {-1e300, -1e300}, lowest[2] = {1e300, 1e300};
      for (int of = 0; of < 2; ++of)
        for (const Vec3& v : of == 0 ? a : b) {
          const double x = glm::dot(across, v - (*own)[k]) / length;
          highest[of] = std::max(highest[of], x);
          lowest[of] = std::min(lowest[of], x);
        }
      if (lowest[0] >= highest[1] - slack || lowest[1] >= highest[0] - slack) return false;
    }
  return true;
}

/// Whether the stretch from p to q meets a triangle, or comes closer than `slack`; not where it lies in its plane.
bool meets(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& t, const Vec3& normal, double slack) {
  const double above = glm::dot(normal, p - t[0]), below = glm::dot(normal, q - t[0]);
  if (std::min(above, below) > slack || std::max(above, below) < -slack) return false;
  if (std::abs(above - below) <= slack) return false;
  const Vec3 at = p + std::clamp(above / (above - below), 0.0, 1.0) * (q - p);
  for (int k = 0; k < 3; ++k) {
    const Vec3 along = t[(k + 1) % 3] - t[k];
    if (glm::dot(glm::cross(along, at - t[k]), normal) < -slack * glm::length(along)) return false;
  }
  return true;
}

/// The triangles of a mesh, and whether two of them cross.
class Crossings {
 public:
  Crossings(const ObjMesh& mesh, std::span<const MeshTriangle> triangles)
      : triangles_(triangles), slack_(kTouching * sizeOf(mesh.vertices)) {
    for (const MeshTriangle& triangle : triangles) {
      std::array<Vec3, 3> corners;
      for (int k = 0; k < 3; ++k) corners[k] = mesh.vertices[static_cast<std::size_t>(triangle.corner[k])];
      corners_.push_back(corners);
      normals_.push_back(glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0])));
      lowest_.push_back(glm::min(glm::min(corners[0], corners[1]), corners[2]) - slack_);
      highest_.push_back(glm::max(glm::max(corners[0], corners[1]), corners[2]) + slack_);
    }
  }

  double begin(int i) const { return lowest_[i].x; }
  double end(int i) const { return highest_[i].x; }

  bool cross(int i, int j) const {
    for (int k = 1; k < 3; ++k)
      if (lowest_[i][k] > highest_[j][k] || lowest_[j][k] > highest_[i][k]) return false;
    std::array<bool, 3> sharedI{}, sharedJ{};
    int shared = 0;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        if (triangles_[i].corner[a] == triangles_[j].corner[b]) {
          sharedI[a] = sharedJ[b] = true;
          ++shared;
        }
    if (isInPlane(i, j)) return overlapInPlane(corners_[i], corners_[j], normals_[i], slack_);
    return shared < 2 && (pierces(i, sharedI, j) || pierces(j, sharedJ, i));
  }

 private:
  bool isInPlane(int i, int j) const {
    return std::ranges::all_of(
        corners_[j], [&](const Vec3& v) { return std::abs(glm::dot(normals_[i], v - corners_[i][0])) <= slack_; });
  }

  /// Whether an edge of triangle i without shared ends meets triangle j.
  bool pierces(int i, const std::array<bool, 3>& isShared, int j) const {
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      if (isShared[k] || isShared[next]) continue;
      if (meets(corners_[i][k], corners_[i][next], corners_[j], normals_[j], slack_)) return true;
    }
    return false;
  }

  std::span<const MeshTriangle> triangles_;
  double slack_;
  std::vector<std::array<Vec3, 3>> corners_;
  std::vector<Vec3> normals_, lowest_, highest_;
};

/// How often closed surfaces wind around a point, by the solid angles of their triangles (van Oosterom and Strackee
/// 1983).
double windingAround(const Vec3& point, const ObjMesh& mesh, std::span<const MeshTriangle> triangles,
                     const std::vector<int>& parts, int withoutPart) {
  double angle = 0.0;
  for (const MeshTriangle& triangle : triangles) {
    if (parts[static_cast<std::size_t>(triangle.polygon)] == withoutPart) continue;
    Vec3 to[3];
    double length[3];
    for (int k = 0; k < 3; ++k) {
      to[k] = mesh.vertices[static_cast<std::size_t>(triangle.corner[k])] - point;
      length[k] = glm::length(to[k]);
    }
    const double volume = glm::dot(to[0], glm::cross(to[1], to[2]));
    const double base = length[0] * length[1] * length[2] + glm::dot(to[0], to[1]) * length[2] +
                        glm::dot(to[1], to[2]) * length[0] + glm::dot(to[2], to[0]) * length[1];
    angle += 2.0 * std::atan2(volume, base);
  }
  return angle / (4.0 * kPi);
}

}  // namespace

double sizeOf(std::span<const Vec3> vertices) {
  Vec3 lowest = vertices.front(), highest = lowest;
  for (const Vec3& v : vertices) {
    lowest = glm::min(lowest, v);
    highest = glm::max(highest, v);
  }
  return 0.5 * glm::length(highest - lowest);
}

void requireClosed(const ObjMesh& mesh) {
  const Edges edges = edgesOf(mesh);
  // Around a vertex, the polygon behind each edge that leaves it has one more such edge: one ring of them, if all is
  // well.
  std::vector<std::map<int, int>> around(mesh.vertices.size());
  for (const auto& [edge, polygon] : edges)
    if (!edges.contains({edge.second, edge.first}))
      refuse(mesh, polygon, "the surface is open: no other face has an edge of this one");
  for (const ObjPolygon& polygon : mesh.polygons)
    for (std::size_t i = 0, n = polygon.corners.size(); i < n; ++i)
      around[static_cast<std::size_t>(polygon.corners[i])][polygon.corners[(i + 1) % n]] =
          polygon.corners[(i + n - 1) % n];
  for (std::size_t v = 0; v < around.size(); ++v) {
    if (around[v].empty()) continue;
    std::size_t seen = 0;
    const int first = around[v].begin()->first;
    for (int at = first; seen == 0 || at != first; at = around[v].at(at)) ++seen;
    if (seen != around[v].size())
      refuse(mesh, edges.at({static_cast<int>(v), first}),
             "parts of the surface touch in a corner of this face, and in nothing more");
  }
}

void requireNoCrossing(const ObjMesh& mesh, std::span<const MeshTriangle> triangles) {
  const Crossings crossings(mesh, triangles);
  std::vector<int> order(triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](int i) { return crossings.begin(i); });
  for (std::size_t a = 0; a < order.size(); ++a)
    for (std::size_t b = a + 1; b < order.size() && crossings.begin(order[b]) <= crossings.end(order[a]); ++b)
      if (crossings.cross(order[a], order[b])) {
        const auto [first, last] = std::minmax(triangles[order[a]].polygon, triangles[order[b]].polygon);
        if (first == last) refuse(mesh, first, "this face crosses itself");
        refuse(mesh, last, "this face crosses or touches that of " + lineOf(mesh, first));
      }
}

void requireOutward(const ObjMesh& mesh, std::span<const MeshTriangle> triangles) {
  const std::vector<int> parts = partsOf(mesh);
  std::map<int, double> volumes;
  const Vec3 origin = mesh.vertices.front();
  for (const MeshTriangle& triangle : triangles) {
    Vec3 to[3];
    for (int k = 0; k < 3; ++k) to[k] = mesh.vertices[static_cast<std::size_t>(triangle.corner[k])] - origin;
    volumes[parts[static_cast<std::size_t>(triangle.polygon)]] += glm::dot(to[0], glm::cross(to[1], to[2])) / 6.0;
  }
  if (volumes.size() > kMostParts)
    throw ObjError(0, "there are more than " + std::to_string(kMostParts) + " bodies in it");
  for (const auto& [part, volume] : volumes) {
    const Vec3 corner =
        mesh.vertices[static_cast<std::size_t>(mesh.polygons[static_cast<std::size_t>(part)].corners.front())];
    const bool isInside = volumes.size() > 1 && windingAround(corner, mesh, triangles, parts, part) > 0.5;
    if (volume < 0.0 && !isInside) refuse(mesh, part, "the body of this face is turned inside out");
    if (volume > 0.0 && isInside) refuse(mesh, part, "the body of this face lies inside another one");
  }
}

}  // namespace parhelion
