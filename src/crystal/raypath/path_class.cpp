// SPDX-License-Identifier: Apache-2.0
#include "crystal/raypath/path_class.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

namespace parhelion {

namespace {

// Directions count as one in spite of rounding.
constexpr double kSameWay = 1e-9;

}  // namespace

PathClasses::PathClasses(const CrystalMesh& mesh, std::vector<std::vector<int>> images)
    : mesh_(&mesh), images_(std::move(images)), code_(static_cast<int>(mesh.faces().size())) {
  std::vector<int> byNumber(mesh.faces().size());
  std::iota(byNumber.begin(), byNumber.end(), 0);
  std::ranges::stable_sort(byNumber, {}, [&](int face) { return mesh.faces()[face].number; });
  rank_.resize(byNumber.size());
  for (std::size_t i = 0; i < byNumber.size(); ++i) rank_[byNumber[i]] = static_cast<int>(i);
}

PathClass PathClasses::of(const PathCode::Words& words, int count) const {
  const PathCode::Faces known = code_.faces(words, count);
  PathClass path{known.first, count > kLongest};
  path.faces.insert(path.faces.end(), known.last.begin(), known.last.end());
  if (path.isLong) path.faces = {path.faces.front(), path.faces.back()};
  const auto comesBefore = [this](const std::vector<int>& a, const std::vector<int>& b) {
    return std::ranges::lexicographical_compare(
        a, b, {}, [this](int face) { return rank_[face]; }, [this](int face) { return rank_[face]; });
  };
  std::vector<int> least = path.faces, image(path.faces.size());
  for (const std::vector<int>& images : images_) {
    std::ranges::transform(path.faces, image.begin(), [&](int face) { return images[face]; });
    if (comesBefore(image, least)) least = image;
  }
  path.faces = std::move(least);
  return path;
}

std::string PathClasses::text(const PathClass& path) const {
  const auto number = [&](int face) { return std::to_string(mesh_->faces()[face].number); };
  if (path.isLong)
    return number(path.faces[0]) + "-*-" + number(path.faces[1]) + ", hits = " + std::to_string(kLongest + 1) + "..";
  std::string text;
  for (const int face : path.faces) text += (text.empty() ? "" : "-") + number(face);
  return text;
}

std::optional<double> PathClasses::leastDeviation(const PathClass& path, double index) const {
  if (path.isLong || path.faces.size() < 2) return std::nullopt;
  // Reflections that undo each other leave the light as in the wedge of the first and the last face.
  const auto reflected = [&](Vec3 v) {
    for (std::size_t i = 1; i + 1 < path.faces.size(); ++i) {
      const Vec3& normal = mesh_->faces()[path.faces[i]].normal;
      v -= 2.0 * glm::dot(v, normal) * normal;
    }
    return v;
  };
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
    if (glm::length(reflected(axis) - axis) > kSameWay) return std::nullopt;
  const Vec3 entry = mesh_->faces()[path.faces.front()].normal, exit = mesh_->faces()[path.faces.back()].normal;
  // Light goes in against the one normal and out along the other.
  const double wedge = std::atan2(glm::length(glm::cross(entry, exit)), -glm::dot(entry, exit));
  if (wedge < kSameWay) return std::nullopt;  // goes straight on
  const double sine = index * std::sin(0.5 * wedge);
  if (!(sine <= 1.0)) return std::nullopt;
  return 2.0 * std::asin(sine) - wedge;
}

}  // namespace parhelion
