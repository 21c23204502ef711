// SPDX-License-Identifier: Apache-2.0
#include "crystal/convex_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace parhelion {

namespace {

// Half the edge of the cube that the half-spaces are cut out of, over the planes' largest distance: even a wedge of
// 0.01 degrees ends within it.
constexpr double kCube = 1e4;
constexpr int kCubeFaces = 6;

// A corner this near to a plane lies in it, as a share of the planes' largest distance.
constexpr double kOnPlane = 1e-11;

/// A closed convex surface of planes and the corners between them, of which planes cut away more and more.
class Cutting {
 public:
  explicit Cutting(std::span<const FacePlane> planes) : planes_(planes.begin(), planes.end()) {
    for (const FacePlane& plane : planes) size_ = std::max(size_, std::abs(plane.distance));
    if (!(size_ > 0.0)) throw std::invalid_argument("the crystal's faces enclose nothing");
    addCube();
  }

  /// Cuts off what lies outside plane i.
  void cut(int plane) {
    const auto& [number, normal, distance] = planes_[plane];
    std::vector<double> outside;
    for (const Vec3& corner : corners_) outside.push_back(glm::dot(normal, corner) - distance);
    const double slack = kOnPlane * size_;
    bool anyIn = false, anyOut = false;
    for (const Outline& face : faces_)
      for (const int corner : face.corners) {
        anyIn |= outside[corner] < -slack;
        anyOut |= outside[corner] > slack;
      }
    if (!anyOut) return;
    if (!anyIn) throw std::invalid_argument("the crystal's faces enclose nothing");

    std::map<std::pair<int, int>, int> cuts;  // corners by the edges they are on
    std::vector<Outline> left;
    for (const Outline& face : faces_) {
      left.push_back({face.plane, cutOutline(face, plane, outside, slack, cuts)});
      if (left.back().corners.size() < 3) left.pop_back();
    }
    faces_ = std::move(left);
    faces_.push_back({plane, openRim()});
  }

  CrystalMesh mesh(bool keepAll) const {
    std::map<int, FaceOutline> byPlane;  // whatever was cut last
    std::vector<Vec3> vertices;
    std::map<int, int> places;
    for (const Outline& face : faces_) {
      if (isOfCube(face.plane)) throw std::invalid_argument("the crystal's faces do not close: it goes on without end");
      FaceOutline outline{planes_[face.plane].number, {}, planes_[face.plane].normal};
      for (const int corner : face.corners) {
        const auto [place, isNew] = places.try_emplace(corner, static_cast<int>(vertices.size()));
        if (isNew) vertices.push_back(sharpened(corner));
        outline.vertices.push_back(place->second);
      }
      byPlane.emplace(face.plane, std::move(outline));
    }
    std::vector<FaceOutline> outlines;
    for (int plane = 0; !isOfCube(plane); ++plane) {
      if (const auto face = byPlane.find(plane); face != byPlane.end())
        outlines.push_back(std::move(face->second));
      else if (keepAll)
        outlines.push_back({planes_[plane].number, {}, planes_[plane].normal, planes_[plane].distance});
    }
    return CrystalMesh(std::move(vertices), outlines);
  }

 private:
  struct Outline {
    int plane;
    std::vector<int> corners;  // counter-clockwise seen from outside
  };

  bool isOfCube(int plane) const { return plane >= static_cast<int>(planes_.size()) - kCubeFaces; }

  void addCube() {
    const double half = kCube * size_;
    for (int i = 0; i < 8; ++i) corners_.emplace_back(i & 1 ? half : -half, i & 2 ? half : -half, i & 4 ? half : -half);
    const std::array<std::array<int, 4>, kCubeFaces> rings{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (int i = 0; i < kCubeFaces; ++i) {
      Vec3 normal(0.0);
      normal[i / 2] = i % 2 == 0 ? -1.0 : 1.0;
      faces_.push_back({static_cast<int>(planes_.size()), {rings[i].begin(), rings[i].end()}});
      planes_.push_back({0, normal, half});
    }
  }

  /// A face without what lies outside the plane.
  std::vector<int> cutOutline(const Outline& face, int plane, const std::vector<double>& outside, double slack,
                              std::map<std::pair<int, int>, int>& cuts) {
    std::vector<int> kept;
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const int a = face.corners[i], b = face.corners[(i + 1) % face.corners.size()];
      if (outside[a] <= slack) kept.push_back(a);
      const bool leaves = outside[a] < -slack && outside[b] > slack;
      const bool enters = outside[a] > slack && outside[b] < -slack;
      if (!leaves && !enters) continue;
      const auto [corner, isNew] = cuts.try_emplace(std::minmax(a, b), static_cast<int>(corners_.size()));
      if (isNew) {
        const double share = outside[a] / (outside[a] - outside[b]);
        corners_.push_back(cornerOf(face.plane, neighbour(face.plane, b, a), plane)
                               .value_or(corners_[a] + share * (corners_[b] - corners_[a])));
      }
      kept.push_back(corner->second);
    }
    return kept;
  }

  /// The plane on the other side of an edge that runs from corner a to b there.
  int neighbour(int plane, int a, int b) const {
    for (const Outline& face : faces_)
      for (std::size_t i = 0; i < face.corners.size(); ++i)
        if (face.plane != plane && face.corners[i] == a && face.corners[(i + 1) % face.corners.size()] == b)
          return face.plane;
    return plane;
  }

  /// Where three planes meet, if they do so well enough for double precision.
  std::optional<Vec3> cornerOf(int p, int q, int r) const {
    const Vec3 a = planes_[p].normal, b = planes_[q].normal, c = planes_[r].normal;
    const double volume = glm::dot(a, glm::cross(b, c));
    if (!(std::abs(volume) > 1e-12)) return std::nullopt;
    return (planes_[p].distance * glm::cross(b, c) + planes_[q].distance * glm::cross(c, a) +
            planes_[r].distance * glm::cross(a, b)) /
           volume;
  }

  /// A corner from those three of its planes that meet most squarely.
  Vec3 sharpened(int corner) const {
    std::vector<int> meeting;
    for (const Outline& face : faces_)
      if (std::ranges::find(face.corners, corner) != face.corners.end()) meeting.push_back(face.plane);
    double most = 0.0;
    Vec3 best = corners_[corner];
    for (std::size_t i = 0; i < meeting.size(); ++i)
      for (std::size_t j = i + 1; j < meeting.size(); ++j)
        for (std::size_t k = j + 1; k < meeting.size(); ++k) {
          const double volume = std::abs(
              glm::dot(planes_[meeting[i]].normal, glm::cross(planes_[meeting[j]].normal, planes_[meeting[k]].normal)));
          if (volume <= most) continue;
          const auto found = cornerOf(meeting[i], meeting[j], meeting[k]);
          if (!found) continue;
          most = volume;
          best = *found;
        }
    return best;
  }

  /// The edges that have a face on one side only, as the outline of the face that is to close them.
  std::vector<int> openRim() const {
    std::set<std::pair<int, int>> edges;
    for (const Outline& face : faces_)
      for (std::size_t i = 0; i < face.corners.size(); ++i)
        edges.emplace(face.corners[i], face.corners[(i + 1) % face.corners.size()]);
    std::vector<std::vector<int>> rings = openRings(edges);
    if (rings.empty()) throw std::invalid_argument("the crystal's faces enclose nothing");
    std::vector<int>& rim = rings.front();
    const bool isSimple = std::set<int>(rim.begin(), rim.end()).size() == rim.size();
    if (rings.size() > 1 || rim.size() < 3 || !isSimple)
      throw std::invalid_argument("the crystal's faces nearly coincide, so that it cannot be cut out of them");
    std::reverse(rim.begin() + 1, rim.end());
    return rim;
  }

  std::vector<FacePlane> planes_;  // those of the cube are last
  std::vector<Vec3> corners_;
  std::vector<Outline> faces_;
  double size_ = 0.0;
};

}  // namespace

CrystalMesh convexBody(std::span<const FacePlane> planes, bool keepAll) {
  Cutting cutting(planes);
  for (int i = 0; i < static_cast<int>(planes.size()); ++i) cutting.cut(i);
  return cutting.mesh(keepAll);
}

}  // namespace parhelion
