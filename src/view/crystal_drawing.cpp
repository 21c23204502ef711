// SPDX-License-Identifier: Apache-2.0
#include "view/crystal_drawing.h"

#include <cairo-svg.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

#include <glm/geometric.hpp>

#include "picture/atomic_file.h"

namespace parhelion {

namespace {

// Points of SVG.
constexpr double kSide = 420.0, kMargin = 30.0, kCaption = 26.0;
constexpr double kWidest = 5.0, kThinnest = 0.6;  // of light
constexpr double kArrow = 9.0;

/// A way to look at the world: what is to the right, what is up, and what is toward the viewer.
struct View {
  Vec3 right, up, toViewer;
  const char* title;
};

View viewFrom(const Vec3& toViewer, const Vec3& right, const char* title) {
  const Vec3 viewer = glm::normalize(toViewer), side = glm::normalize(right - glm::dot(right, viewer) * viewer);
  return {side, glm::cross(viewer, side), viewer, title};
}

struct Release {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};

cairo_status_t append(void* text, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

class Drawing {
 public:
  Drawing(const CrystalDrawing& what, cairo_t* context) : what_(what), context_(context) {
    Vec3 lowest(1e300), highest(-1e300);
    for (const Vec3& vertex : what.vertices) {
      lowest = glm::min(lowest, vertex);
      highest = glm::max(highest, vertex);
    }
    centre_ = 0.5 * (lowest + highest);
    double reach = 0.0;
    for (const Vec3& vertex : what.vertices) reach = std::max(reach, glm::length(vertex - centre_));
    for (const auto& light : what.light)
      reach = std::max({reach, glm::length(light.from - centre_), glm::length(light.to - centre_)});
    scale_ = (0.5 * kSide - kMargin) / reach;
  }

  void from(const View& view, double left) {
    view_ = &view;
    left_ = left;
    edges();
    numbers();
    for (const auto& light : what_.light) beam(light);
    cairo_set_font_size(context_, 12.0);
    grey(0.35);
    text(view.title, {left + 0.5 * kSide, kSide - 8.0});
  }

 private:
  Vec2 at(const Vec3& point) const {
    const Vec3 d = scale_ * (point - centre_);
    return {left_ + 0.5 * kSide + glm::dot(d, view_->right), 0.5 * kSide - glm::dot(d, view_->up)};
  }
  bool isSeen(const CrystalDrawing::Face& face) const { return glm::dot(face.normal, view_->toViewer) > 0.0; }
  void grey(double level) { cairo_set_source_rgb(context_, level, level, level); }

  void text(const std::string& words, const Vec2& middle) {
    cairo_text_extents_t box;
    cairo_text_extents(context_, words.c_str(), &box);
    cairo_move_to(context_, middle.x - 0.5 * box.width - box.x_bearing, middle.y - 0.5 * box.height - box.y_bearing);
    cairo_show_text(context_, words.c_str());
  }

  void edges() {
    std::map<std::pair<int, int>, bool> seen;  // by the two ends
    for (const auto& face : what_.faces)
      for (std::size_t i = 0; i < face.vertices.size(); ++i) {
        const auto ends = std::minmax(face.vertices[i], face.vertices[(i + 1) % face.vertices.size()]);
        seen[ends] = seen[ends] || isSeen(face);
      }
    for (const bool front : {false, true})
      for (const auto& [ends, isFront] : seen) {
        if (isFront != front) continue;
        const double dashes[] = {4.0, 4.0};
        cairo_set_dash(context_, dashes, front ? 0 : 2, 0.0);
        cairo_set_line_width(context_, front ? 1.4 : 0.9);
        grey(front ? 0.1 : 0.55);
        const Vec2 a = at(what_.vertices[static_cast<std::size_t>(ends.first)]);
        const Vec2 b = at(what_.vertices[static_cast<std::size_t>(ends.second)]);
        cairo_move_to(context_, a.x, a.y);
        cairo_line_to(context_, b.x, b.y);
        cairo_stroke(context_);
      }
    cairo_set_dash(context_, nullptr, 0, 0.0);
  }

  void numbers() {
    for (const auto& face : what_.faces) {
      Vec3 middle(0.0);
      for (const int vertex : face.vertices) middle += what_.vertices[static_cast<std::size_t>(vertex)];
      middle /= static_cast<double>(face.vertices.size());
      cairo_set_font_size(context_, isSeen(face) ? 14.0 : 10.0);
      grey(isSeen(face) ? 0.1 : 0.6);
      text(std::to_string(face.number), at(middle));
    }
  }

  void beam(const CrystalDrawing::Light& light) {
    const Vec2 a = at(light.from), b = at(light.to);
    const double length = glm::length(b - a);
    cairo_set_source_rgba(context_, 0.85, 0.2, 0.05, 0.9);
    cairo_set_line_width(context_, std::clamp(kWidest * light.energy, kThinnest, kWidest));
    const Vec2 along = length > 0.0 ? (b - a) / length : Vec2(0.0), across(-along.y, along.x);
    const Vec2 end = light.hasArrow && length > kArrow ? b - kArrow * along : b;
    cairo_move_to(context_, a.x, a.y);
    cairo_line_to(context_, end.x, end.y);
    cairo_stroke(context_);
    if (!light.hasArrow || length <= kArrow) return;
    cairo_move_to(context_, b.x, b.y);
    for (const double side : {1.0, -1.0}) {
      const Vec2 corner = end + 0.4 * kArrow * side * across;
      cairo_line_to(context_, corner.x, corner.y);
    }
    cairo_close_path(context_);
    cairo_fill(context_);
  }

  const CrystalDrawing& what_;
  cairo_t* context_;
  Vec3 centre_{};
  double scale_ = 1.0, left_ = 0.0;
  const View* view_ = nullptr;
};

}  // namespace

void drawCrystal(const Output& svg, const CrystalDrawing& drawing, const std::string& software) {
  std::string bytes;
  {
    const std::unique_ptr<cairo_surface_t, Release> surface(
        cairo_svg_surface_create_for_stream(append, &bytes, 2.0 * kSide, kSide + kCaption));
    const std::unique_ptr<cairo_t, Release> context(cairo_create(surface.get()));
    cairo_select_font_face(context.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_line_cap(context.get(), CAIRO_LINE_CAP_ROUND);
    cairo_set_source_rgb(context.get(), 1.0, 1.0, 1.0);
    cairo_paint(context.get());
    Drawing pen(drawing, context.get());
    // Along -y, the sun, which is toward +x, is at the left; and so it is from above with -y up. Both a little tipped,
    // so that no face is a mere line.
    pen.from(viewFrom({-0.12, 1.0, 0.2}, {-1.0, 0.0, 0.0}, "from the side, the sun at the left"), 0.0);
    pen.from(viewFrom({-0.05, 0.15, 1.0}, {-1.0, 0.0, 0.0}, "from above, the sun at the left"), kSide);
    cairo_set_font_size(context.get(), 13.0);
    cairo_set_source_rgb(context.get(), 0.0, 0.0, 0.0);
    cairo_move_to(context.get(), 12.0, kSide + 0.6 * kCaption);
    cairo_show_text(context.get(), drawing.caption.c_str());
    cairo_surface_finish(surface.get());
    const cairo_status_t status = std::max(cairo_status(context.get()), cairo_surface_status(surface.get()));
    if (status != CAIRO_STATUS_SUCCESS)
      throw std::runtime_error(svg.path.string() + ": " + cairo_status_to_string(status));
  }
  bytes.insert(bytes.find('\n') + 1, "<!-- " + software + " -->\n");  // behind the declaration, as in charts
  AtomicFile file(svg);
  file.write(bytes);
  file.commit();
}

}  // namespace parhelion
