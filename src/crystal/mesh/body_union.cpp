// SPDX-License-Identifier: Apache-2.0
#include "crystal/mesh/body_union.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <glm/geometric.hpp>

#include "crystal/mesh/surface_checks.h"

namespace parhelion {

namespace {

// A corner this near to a plane lies in it, and corners this near to each other are one, as shares of the crystal's
// size. Rounding leaves a thousandth of the first; the second is below what requireNoCrossing() takes for touching.
constexpr double kOnPlane = 1e-11;
constexpr double kOneCorner = 5e-10;

using Polygon = std::vector<Vec3>;  // convex, planar

/// Which of its faces a polygon is part of: `face` of body `body`.
struct Owner {
  int body, face;
};

struct Part {
  Owner owner;
  Polygon polygon;
};

/// What of a polygon lies on one side of a plane, `side` 1 for above and -1 for below; nothing where that is no more
/// than an edge.
Polygon clipped(const Polygon& polygon, const Face& plane, double side, double slack) {
  Polygon kept;
  bool any = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double atA = side * (glm::dot(plane.normal, a) - plane.offset),
                 atB = side * (glm::dot(plane.normal, b) - plane.offset);
    if (atA >= -slack) kept.push_back(a);
    any |= atA > slack;
    if ((atA > slack && atB < -slack) || (atA < -slack && atB > slack)) kept.push_back(a + atA / (atA - atB) * (b - a));
  }
  return any && kept.size() >= 3 ? kept : Polygon();
}

/// Bodies whose faces are cut at each other.
class Pieces {
 public:
  explicit Pieces(const std::vector<CrystalMesh>& bodies) : bodies_(bodies) {
    std::vector<Vec3> all;
    for (const CrystalMesh& body : bodies) all.insert(all.end(), body.vertices().begin(), body.vertices().end());
    size_ = sizeOf(all);
    for (int b = 0; b < static_cast<int>(bodies.size()); ++b)
      for (int f = 0; f < static_cast<int>(bodies[b].faces().size()); ++f) add({b, f});
  }

  double size() const { return size_; }
  bool anyCut() const { return anyCut_; }
  const std::vector<Part>& parts() const { return parts_; }

 private:
  /// What other bodies leave of a face.
  void add(const Owner& owner) {
    const CrystalMesh& body = bodies_[static_cast<std::size_t>(owner.body)];
    Polygon whole;
    for (const int v : body.faces()[owner.face].vertices) whole.push_back(body.vertices()[v]);
    std::vector<Polygon> left{whole};
    for (int other = 0; other < static_cast<int>(bodies_.size()); ++other) {
      if (other == owner.body) continue;
      std::vector<Polygon> next;
      for (const Polygon& polygon : left) cutOut(polygon, owner, other, next);
      left = std::move(next);
    }
    for (Polygon& polygon : left) parts_.push_back({owner, std::move(polygon)});
  }

  /// Adds what of a polygon lies outside another body, in convex parts.
  void cutOut(const Polygon& polygon, const Owner& owner, int other, std::vector<Polygon>& out) {
    const double slack = kOnPlane * size_;
    const std::vector<Face>& planes = bodies_[static_cast<std::size_t>(other)].faces();
    const Vec3& normal = bodies_[static_cast<std::size_t>(owner.body)].faces()[owner.face].normal;
    std::vector<const Face*> cutting;
    Polygon inside = polygon;
    for (const Face& plane : planes) {
      const bool isIn = std::ranges::all_of(
          polygon, [&](const Vec3& v) { return std::abs(glm::dot(plane.normal, v) - plane.offset) <= slack; });
      if (!isIn) {
        cutting.push_back(&plane);
        inside = clipped(inside, plane, -1.0, slack);
        if (inside.empty()) return out.push_back(polygon);
      } else if (owner.body < other && glm::dot(plane.normal, normal) > 0.0) {
        return out.push_back(polygon);  // the later body gives way
      }
    }
    anyCut_ = true;
    Polygon rest = polygon;
    for (const Face* plane : cutting) {
      Polygon outside = clipped(rest, *plane, 1.0, slack);
      if (!outside.empty()) out.push_back(std::move(outside));
      rest = clipped(rest, *plane, -1.0, slack);
    }
  }

  const std::vector<CrystalMesh>& bodies_;
  double size_;
  bool anyCut_ = false;
  std::vector<Part> parts_;
};

/// Parts of faces whose corners and edges are shared.
class Stitched {
 public:
  explicit Stitched(const Pieces& pieces) : slack_(kOneCorner * pieces.size()) {
    for (const Part& part : pieces.parts()) {
      std::vector<int> ring;
      for (const Vec3& corner : part.polygon)
        if (const int v = vertexAt(corner); ring.empty() || ring.back() != v) ring.push_back(v);
      if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
      add(part.owner, std::move(ring));
    }
    const auto corners = static_cast<int>(mesh_.vertices.size());
    for (int p = 0; p < static_cast<int>(mesh_.polygons.size()); ++p) {
      std::vector<int>& ring = mesh_.polygons[static_cast<std::size_t>(p)].corners;
      std::vector<int> all = withCornersBetween(ring, corners);
      addTriangles(p, all, all.size() > ring.size());
      ring = std::move(all);
    }
  }

  const ObjMesh& mesh() const { return mesh_; }
  const std::vector<Owner>& owners() const { return owners_; }  // by polygon
  const std::vector<MeshTriangle>& triangles() const { return triangles_; }

 private:
  int vertexAt(const Vec3& place) {
    const auto found =
        std::ranges::find_if(mesh_.vertices, [&](const Vec3& v) { return glm::length(v - place) <= slack_; });
    const auto index = static_cast<int>(found - mesh_.vertices.begin());
    if (found == mesh_.vertices.end()) mesh_.vertices.push_back(place);
    return index;
  }

  /// Parts that are but lines are dropped: their neighbours share the corners between.
  void add(const Owner& owner, std::vector<int> ring) {
    if (ring.size() < 3) return;
    const Vec3 a = place(ring[0]);
    double widest = 0.0, longest = 0.0;
    for (const int v : ring) longest = std::max(longest, glm::length(place(v) - a));
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
      widest = std::max(widest, glm::length(glm::cross(place(ring[i]) - a, place(ring[i + 1]) - a)));
    if (widest <= slack_ * longest) return;
    mesh_.polygons.push_back({std::move(ring), 0, std::nullopt});
    owners_.push_back(owner);
  }

  const Vec3& place(int vertex) const { return mesh_.vertices[static_cast<std::size_t>(vertex)]; }

  /// A ring with all corners of other parts that lie on its edges.
  std::vector<int> withCornersBetween(const std::vector<int>& ring, int corners) const {
    std::vector<int> all;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const int from = ring[i], to = ring[(i + 1) % ring.size()];
      const Vec3 along = place(to) - place(from);
      std::vector<std::pair<double, int>> between;
      for (int v = 0; v < corners; ++v) {
        if (v == from || v == to) continue;
        const double share = glm::dot(place(v) - place(from), along) / glm::dot(along, along);
        if (share > 0.0 && share < 1.0 && glm::length(place(v) - place(from) - share * along) <= slack_)
          between.emplace_back(share, v);
      }
      std::ranges::sort(between);
      all.push_back(from);
      for (const auto& [share, v] : between) all.push_back(v);
    }
    return all;
  }

  /// Around a vertex in its middle where corners lie in one line, else around the first.
  void addTriangles(int polygon, const std::vector<int>& ring, bool aroundMiddle) {
    const std::size_t n = ring.size();
    if (!aroundMiddle) {
      for (std::size_t i = 1; i + 1 < n; ++i) triangles_.push_back({{ring[0], ring[i], ring[i + 1]}, polygon});
      return;
    }
    Vec3 sum(0.0);
    for (const int v : ring) sum += place(v);
    const auto middle = static_cast<int>(mesh_.vertices.size());
    mesh_.vertices.push_back(sum / static_cast<double>(n));
    for (std::size_t i = 0; i < n; ++i) triangles_.push_back({{middle, ring[i], ring[(i + 1) % n]}, polygon});
  }

  double slack_;
  ObjMesh mesh_;
  std::vector<Owner> owners_;
  std::vector<MeshTriangle> triangles_;
};

/// The faces of the bodies as triangles of some vertices, those without any left out.
class Triangles {
 public:
  explicit Triangles(const std::vector<CrystalMesh>& bodies) : bodies_(bodies) {
    for (const CrystalMesh& body : bodies) {
      faces_.emplace_back();
      for (const Face& face : body.faces()) faces_.back().push_back({face.number, face.normal, face.offset, {}});
    }
  }

  void add(const Owner& owner, const std::array<int, 3>& corners) {
    faces_[static_cast<std::size_t>(owner.body)][static_cast<std::size_t>(owner.face)].triangles.push_back(corners);
  }

  CrystalMesh mesh(std::vector<Vec3> vertices) const {
    std::vector<FaceTriangles> all;
    for (const auto& body : faces_)
      for (const FaceTriangles& face : body)
        if (!face.triangles.empty()) all.push_back(face);
    return CrystalMesh(std::move(vertices), all);
  }

 private:
  const std::vector<CrystalMesh>& bodies_;
  std::vector<std::vector<FaceTriangles>> faces_;
};

/// Bodies that have no volume in common. Corners at the same place are one.
CrystalMesh sideBySide(const std::vector<CrystalMesh>& bodies, const Pieces& pieces) {
  Triangles triangles(bodies);
  std::vector<Vec3> vertices;
  for (int b = 0; b < static_cast<int>(bodies.size()); ++b) {
    const CrystalMesh& body = bodies[static_cast<std::size_t>(b)];
    std::vector<int> places;
    for (const Vec3& v : body.vertices()) {
      const auto found = std::ranges::find_if(
          vertices, [&](const Vec3& other) { return glm::length(v - other) <= kOneCorner * pieces.size(); });
      places.push_back(static_cast<int>(found - vertices.begin()));
      if (found == vertices.end()) vertices.push_back(v);
    }
    for (int f = 0; f < static_cast<int>(body.faces().size()); ++f) {
      const std::vector<int>& ring = body.faces()[f].vertices;
      for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        triangles.add({b, f}, {places[ring[0]], places[ring[i]], places[ring[i + 1]]});
    }
  }
  return triangles.mesh(std::move(vertices));
}

CrystalMesh joined(const std::vector<CrystalMesh>& bodies, const Pieces& pieces) {
  const Stitched stitched(pieces);
  Triangles triangles(bodies);
  try {
    requireClosed(stitched.mesh());
    requireNoCrossing(stitched.mesh(), stitched.triangles());
    requireOutward(stitched.mesh(), stitched.triangles());
    for (const auto& [corner, polygon] : stitched.triangles())
      triangles.add(stitched.owners()[static_cast<std::size_t>(polygon)], {corner[0], corner[1], corner[2]});
  } catch (const ObjError&) {
    throw std::invalid_argument("parts of the crystal meet in a corner or an edge alone, or nearly so");
  }
  return triangles.mesh(stitched.mesh().vertices);
}

}  // namespace

CrystalMesh unionOf(std::span<const std::vector<FacePlane>> bodies) {
  std::vector<CrystalMesh> all;
  for (const std::vector<FacePlane>& planes : bodies) all.push_back(convexBody(planes));
  if (all.size() == 1) return all.front();
  const Pieces pieces(all);
  return pieces.anyCut() ? joined(all, pieces) : sideBySide(all, pieces);
}

}  // namespace parhelion
