// SPDX-License-Identifier: Apache-2.0
#include "view/labels.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace parhelion {
namespace {

// Room kept between labels and to the picture's border, in sizes of the letters.
constexpr double kRoom = 0.35;

}  // namespace

Crowd::Crowd(int width, int height, double cell)
    : cell_(cell),
      columns_(static_cast<int>(width / cell) + 1),
      rows_(static_cast<int>(height / cell) + 1),
      length_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

void Crowd::add(const std::vector<PixelLine>& lines, double weight) {
  for (const PixelLine& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i) {
      // Long pieces are spread over the cells they cross.
      const double length = glm::length(line[i] - line[i - 1]);
      const int parts = static_cast<int>(length / cell_) + 1;
      for (int part = 0; part < parts; ++part) {
        const Vec2 at = line[i - 1] + (part + 0.5) / parts * (line[i] - line[i - 1]);
        const int x = static_cast<int>(std::floor(at.x / cell_)), y = static_cast<int>(std::floor(at.y / cell_));
        if (x >= 0 && x < columns_ && y >= 0 && y < rows_)
          length_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x)] +=
              weight * length / parts;
      }
    }
}

double Crowd::in(const Box& box) const {
  const auto cellOf = [&](double place, int count) {
    return std::clamp(static_cast<int>(place / cell_), 0, count - 1);
  };
  double sum = 0.0;
  for (int y = cellOf(box.min.y, rows_); y <= cellOf(box.max.y, rows_); ++y)
    for (int x = cellOf(box.min.x, columns_); x <= cellOf(box.max.x, columns_); ++x)
      sum += length_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x)];
  return sum;
}

Labels::Labels(const Camera& camera, const Canvas& canvas, double size, bool below)
    : camera_(camera), canvas_(canvas), size_(size), below_(below) {}

Box Labels::around(const std::string& text, const Vec2& centre) const {
  const Vec2 half = 0.5 * canvas_.textBox(text, size_).size();
  return {centre - half, centre + half};
}

std::vector<Box> Labels::beside(const std::string& text, const Vec2& point, double gap) const {
  const Vec2 half = 0.5 * canvas_.textBox(text, size_).size();
  std::vector<Box> boxes;
  for (const Vec2& side :
       {Vec2(1, 0), Vec2(-1, 0), Vec2(0, -1), Vec2(0, 1), Vec2(1, -1), Vec2(-1, -1), Vec2(1, 1), Vec2(-1, 1)}) {
    const Vec2 centre = point + side * (half + gap / glm::length(side));
    boxes.push_back({centre - half, centre + half});
  }
  return boxes;
}

bool Labels::fits(const Box& box) const {
  const double room = kRoom * size_;
  const Box wide = box.grownBy(room);
  for (const Vec2& corner : {wide.min, wide.max, Vec2(wide.min.x, wide.max.y), Vec2(wide.max.x, wide.min.y)}) {
    const std::optional<Vec3> toSky = camera_.toSky(corner);
    if (!toSky || (!below_ && toSky->z < 0.0)) return false;
  }
  return !crossesSeam(wide) && !isTaken(wide);
}

bool Labels::crossesSeam(const Box& box) const { return box.min.x < camera_.seam() && box.max.x > camera_.seam(); }

bool Labels::isTaken(const Box& box) const {
  return std::any_of(taken_.begin(), taken_.end(), [&](const Box& other) { return box.overlaps(other); });
}

std::optional<PlacedLabel> Labels::place(const std::string& text, const std::vector<Box>& candidates) {
  const auto found = std::find_if(candidates.begin(), candidates.end(), [&](const Box& box) { return fits(box); });
  if (found == candidates.end()) return std::nullopt;
  taken_.push_back(*found);
  placed_.push_back({text, *found});
  return placed_.back();
}

std::optional<LabelPlace> Labels::place(const std::string& text, const std::vector<LabelPlace>& candidates) {
  const auto leader = [](const LabelPlace& at) {
    return Box{glm::min(at.anchor, at.foot()), glm::max(at.anchor, at.foot())};
  };
  const auto found = std::find_if(candidates.begin(), candidates.end(), [&](const LabelPlace& at) {
    return fits(at.box) && !isTaken(leader(at)) && !crossesSeam(leader(at));
  });
  if (found == candidates.end()) return std::nullopt;
  taken_.push_back(found->box);
  taken_.push_back(leader(*found));
  placed_.push_back({text, found->box});
  return *found;
}

}  // namespace parhelion
