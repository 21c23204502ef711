// SPDX-License-Identifier: Apache-2.0
#include "crystal/mesh/mesh_from_obj.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>

#include <glm/geometric.hpp>

#include "crystal/convex_body.h"
#include "crystal/mesh/triangulation.h"

namespace parhelion {

namespace {

// Polygons in one plane look to the same side within this angle, rad: small ones have few digits left for it.
constexpr double kSameSide = 2e-3;
// Faces this near to parallel, rad, are meant to be.
constexpr double kParallel = 2e-6;

/// Polygons in one plane.
struct Plane {
  Vec3 normal;
  double offset;
  std::vector<int> polygons;  // in the order of the file
  int number = 0;
};

class Faces {
 public:
  Faces(const ObjMesh& mesh, OneFace rule) : mesh_(mesh), rule_(rule), size_(sizeOf(mesh.vertices)) {
    requireClosed(mesh_);
    const std::vector<MeshTriangle> given = triangulate(mesh_);
    requireNoCrossing(mesh_, given);
    requireOutward(mesh_, given);
    rule == OneFace::byPlane ? group() : groupByNumber();
    for (Plane& plane : planes_) fit(plane);
    makeParallel();
    if (rule == OneFace::byPlane) number();
    flatten();
    triangles_ = triangulate(mesh_);
  }

  CrystalMesh mesh() const {
    if (isConvex() && planes_.size() <= kMaxFaces) {
      std::vector<FacePlane> planes;
      for (const Plane& plane : planes_) planes.push_back({plane.number, plane.normal, plane.offset});
      return convexBody(planes);
    }
    std::vector<FaceTriangles> faces;
    std::vector<int> planeOf(mesh_.polygons.size());
    for (std::size_t f = 0; f < planes_.size(); ++f) {
      faces.push_back({planes_[f].number, planes_[f].normal, planes_[f].offset, {}});
      for (const int polygon : planes_[f].polygons) planeOf[polygon] = static_cast<int>(f);
    }
    for (const MeshTriangle& triangle : triangles_)
      faces[planeOf[triangle.polygon]].triangles.push_back(
          {triangle.corner[0], triangle.corner[1], triangle.corner[2]});
    return CrystalMesh(mesh_.vertices, faces);
  }

 private:
  /// Sorts the polygons into planes; those with most area say where these are.
  void group() {
    std::vector<Vec3> areas;
    for (const ObjPolygon& polygon : mesh_.polygons) areas.push_back(areaVector(mesh_, polygon));
    std::vector<int> order(areas.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::greater<>(), [&](int p) { return glm::length(areas[p]); });
    for (const int p : order) {
      const Vec3 normal = glm::normalize(areas[p]);
      const auto has = [&](const Plane& plane) {
        return glm::length(normal - plane.normal) < kSameSide && isIn(plane, p);
      };
      auto plane = std::ranges::find_if(planes_, has);
      if (plane == planes_.end())
        plane = planes_.insert(plane, {normal, glm::dot(normal, place(mesh_.polygons[p].corners[0])), {}});
      plane->polygons.push_back(p);
    }
    for (Plane& plane : planes_) std::ranges::sort(plane.polygons);
    std::ranges::sort(planes_, {}, [](const Plane& plane) { return plane.polygons.front(); });
  }

  void groupByNumber() {
    for (int p = 0; p < static_cast<int>(mesh_.polygons.size()); ++p) {
      const int number = mesh_.polygons[static_cast<std::size_t>(p)].number.value();
      auto plane = std::ranges::find(planes_, number, &Plane::number);
      if (plane == planes_.end()) plane = planes_.insert(plane, {Vec3(0.0), 0.0, {}, number});
      plane->polygons.push_back(p);
    }
  }

  Vec3 place(int vertex) const { return mesh_.vertices[vertex]; }

  bool isIn(const Plane& plane, int polygon) const {
    return std::ranges::all_of(mesh_.polygons[polygon].corners, [&](int v) {
      return std::abs(glm::dot(plane.normal, place(v)) - plane.offset) <= kFlat * size_;
    });
  }

  /// The plane of all its polygons together.
  void fit(Plane& plane) const {
    Vec3 area(0.0);
    for (const int p : plane.polygons) area += areaVector(mesh_, mesh_.polygons[p]);
    plane.normal = glm::normalize(area);
    setOffset(plane);
  }

  void setOffset(Plane& plane) const {
    double sum = 0.0, corners = 0.0;
    for (const int p : plane.polygons)
      for (const int v : mesh_.polygons[p].corners) {
        sum += glm::dot(plane.normal, place(v));
        ++corners;
      }
    plane.offset = sum / corners;
  }

  void makeParallel() {
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      Vec3& normal = planes_[i].normal;
      if (std::abs(normal.z) < kParallel) normal = glm::normalize(Vec3(normal.x, normal.y, 0.0));
      if (std::hypot(normal.x, normal.y) < kParallel) normal = Vec3(0.0, 0.0, std::copysign(1.0, normal.z));
      for (std::size_t j = 0; j < i; ++j) {
        const double side = glm::dot(normal, planes_[j].normal) > 0.0 ? 1.0 : -1.0;
        if (glm::length(normal - side * planes_[j].normal) < kParallel) normal = side * planes_[j].normal;
      }
      setOffset(planes_[i]);
    }
  }

  void number() {
    std::map<int, int> taken;  // numbers, and a polygon that has each
    for (Plane& plane : planes_) {
      int named = -1;
      for (const int p : plane.polygons) {
        const auto& own = mesh_.polygons[p].number;
        if (!own) continue;
        if (plane.number != 0 && plane.number != *own)
          throw ObjError(mesh_.polygons[p].line, "this face is number " + std::to_string(*own) +
                                                     " and in one plane with number " + std::to_string(plane.number) +
                                                     " of line " + std::to_string(mesh_.polygons[named].line));
        plane.number = *own;
        named = p;
      }
      if (named < 0) continue;
      const auto [other, isNew] = taken.try_emplace(plane.number, named);
      if (!isNew)
        throw ObjError(mesh_.polygons[named].line,
                       "this face is number " + std::to_string(plane.number) + ", as is that of line " +
                           std::to_string(mesh_.polygons[other->second].line) + " in another plane");
    }
    int next = 1;
    for (Plane& plane : planes_) {
      if (plane.number != 0) continue;
      while (taken.contains(next)) ++next;
      plane.number = next++;
    }
  }

  /// Brings the vertices into all planes that meet in them, by projection on one after another (Kaczmarz).
  void flatten() {
    constexpr int kMostRounds = 200;
    std::vector<std::set<int>> planesAt(mesh_.vertices.size());
    for (std::size_t f = 0; f < planes_.size(); ++f)
      for (const int p : planes_[f].polygons)
        for (const int v : mesh_.polygons[p].corners) planesAt[v].insert(static_cast<int>(f));
    for (std::size_t v = 0; v < planesAt.size(); ++v) {
      double worst = 1.0;
      for (int round = 0; round < kMostRounds && worst > 1e-16 * size_; ++round) {
        worst = 0.0;
        for (const int f : planesAt[v]) {
          const double above = glm::dot(planes_[f].normal, mesh_.vertices[v]) - planes_[f].offset;
          mesh_.vertices[v] -= above * planes_[f].normal;
          worst = std::max(worst, std::abs(above));
        }
      }
    }
  }

  bool isConvex() const {
    const double slack = rule_ == OneFace::byPlane ? 2.0 * kFlat : 1e-12;
    return std::ranges::all_of(planes_, [&](const Plane& plane) {
      return std::ranges::all_of(
          mesh_.vertices, [&](const Vec3& v) { return glm::dot(plane.normal, v) - plane.offset <= slack * size_; });
    });
  }

  ObjMesh mesh_;
  OneFace rule_;
  double size_;
  std::vector<Plane> planes_;
  std::vector<MeshTriangle> triangles_;
};

}  // namespace

CrystalMesh meshFromObj(const ObjMesh& mesh, OneFace rule) { return Faces(mesh, rule).mesh(); }

}  // namespace parhelion
