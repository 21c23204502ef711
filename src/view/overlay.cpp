// SPDX-License-Identifier: Apache-2.0
#include "view/overlay.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <glm/geometric.hpp>

#include "math/rotation.h"
#include "optics/halo_forms.h"
#include "view/picture_lines.h"
#include "view/sky_grid.h"

namespace parhelion {
namespace {

constexpr double kFinestGrid = radians(0.1);
constexpr double kRounding = 1e-9;  // relative, of a step that was once in degrees

// Letters take this share of the picture's shorter side, and are never smaller than can be read, pixels.
constexpr double kLetterShare = 1.0 / 50.0;
constexpr double kSmallestLetters = 9.0;

// All other lengths are in sizes of the letters.
constexpr double kLineWidth = 0.075;
constexpr double kShadowWidth = 0.07;  // that much more on either side of a line
constexpr double kGap = 0.45;          // between a label and what it names
constexpr double kBeside = 0.7;        // a curve that near a label seems to be meant by it
constexpr double kSunRadius = 0.55;
constexpr double kSpotRadius = 0.3;
constexpr double kCross = 0.45;  // half length of the zenith's arms

constexpr Colour kShadow{0.0, 0.02, 0.06, 0.45};  // its alpha times that of the line
constexpr Colour kTextShadow{0.0, 0.02, 0.06, 0.72};
constexpr Colour kGridColour{1.0, 1.0, 1.0, 0.42};
constexpr Colour kBelowColour{1.0, 1.0, 1.0, 0.24};
constexpr Colour kHorizonColour{1.0, 0.66, 0.32, 0.9};
constexpr Colour kCircleColour{1.0, 0.89, 0.45, 0.8};
constexpr Colour kHaloColour{0.47, 0.90, 1.0, 0.85};
constexpr Colour kSunColour{1.0, 0.95, 0.75, 1.0};

// Names of halos look for places along this many points of their curve.
constexpr std::size_t kLabelTries = 96;

// A label moves by this share of the picture's shorter side to keep off one line.
constexpr double kWorthOfLine = 0.4;

Colour opaque(Colour c) {
  c.alpha = 1.0;
  return c;
}

Colour shadowOf(const Colour& c) {
  Colour shadow = kShadow;
  shadow.alpha *= c.alpha;
  return shadow;
}

void validate(const OverlaySettings& s) {
  if (s.gridStep != 0.0 && !(s.gridStep >= kFinestGrid * (1.0 - kRounding) && s.gridStep <= kPi))
    throw std::invalid_argument("overlay: grid lines are from 0.1 to 180 degrees apart");
  for (const double radius : s.circles)
    if (!(radius > 0.0 && radius < kPi))
      throw std::invalid_argument("overlay: circles about the sun have radii between 0 and 180 degrees");
  if (!(s.scale >= 0.1 && s.scale <= 20.0)) throw std::invalid_argument("overlay: the scale is from 0.1 to 20");
}

double letterSize(const CameraSettings& camera, double scale) {
  return scale * std::max(kSmallestLetters, kLetterShare * std::min(camera.width, camera.height));
}

/// One drawing: lines are gathered first, so that their shadows lie below all of them.
class Painter {
 public:
  Painter(const CameraSettings& settings, double sunElevation, double size)
      : camera_(settings),
        canvas_(settings.width, settings.height),
        labels_(camera_, canvas_, size),
        crowd_(settings.width, settings.height, 0.5 * size),
        size_(size),
        frame_(Box{Vec2(0.0), Vec2(settings.width, settings.height)}.grownBy(size)),
        elevation_(sunElevation),
        toSun_(skyDirection(0.0, sunElevation)) {}

  void grid(double step, bool named) {
    std::vector<PixelLine> above, below;
    const int every = labelEvery(camera_, labels_, step);
    for (GridLine& line : gridLines(step)) {
      std::vector<PixelLine> shown = linesInPicture(camera_, line.line, frame_);
      crowd_.add(shown, 0.15);
      std::vector<PixelLine>& all = line.isBelow ? below : above;
      all.insert(all.end(), shown.begin(), shown.end());
      const bool isSecondHalf = line.isBelow && !line.isAltitude;  // of a meridian
      if (named && !isSecondHalf && line.number % every == 0 && !shown.empty())
        grid_.push_back({std::move(line), std::move(shown)});
    }
    gridStep_ = step;
    strokes_.push_back({std::move(below), {kBelowColour, kLineWidth * size_}});
    strokes_.push_back({std::move(above), {kGridColour, kLineWidth * size_}});
  }

  void horizon() { add({circleAbout(Vec3(0.0, 0.0, 1.0), 0.5 * kPi)}, {kHorizonColour, 1.7 * kLineWidth * size_}); }

  void zenith(bool named) {
    const std::optional<Vec2> at = camera_.project(Vec3(0.0, 0.0, 1.0));
    if (!at) return;
    const Vec2 right(kCross * size_, 0.0), up(0.0, kCross * size_);
    strokes_.push_back(
        {{{*at - right, *at + right}, {*at - up, *at + up}}, {opaque(kGridColour), 1.4 * kLineWidth * size_}});
    mark(*at, kCross, named ? "zenith" : "", kGridColour);
  }

  void sun(bool named) {
    const std::optional<Vec2> at = camera_.project(toSun_);
    if (!at) return;
    strokes_.push_back({{ringAt(*at, kSunRadius)}, {kSunColour, 1.5 * kLineWidth * size_}});
    discs_.push_back({*at, 0.16 * size_, kSunColour});
    mark(*at, kSunRadius, named ? "sun" : "", kSunColour);
  }

  void circles(const std::vector<double>& radii, bool named) {
    for (const double radius : radii) {
      const Vec3 below = skyDirection(0.0, elevation_ - radius);
      curve({degreeText(radius, false), {circleAbout(toSun_, radius)}, below},
            {kCircleColour, 1.2 * kLineWidth * size_, 0.45 * size_}, named);
    }
  }

  void halos(const std::vector<HaloCurve>& curves, bool named) {
    for (const HaloCurve& halo : curves) curve(halo, {kHaloColour, 1.3 * kLineWidth * size_}, named);
  }

  void spots(const std::vector<HaloPoint>& points, bool named) {
    for (const HaloPoint& point : points)
      if (const std::optional<Vec2> at = camera_.project(point.toSky)) {
        strokes_.push_back({{ringAt(*at, kSpotRadius)}, {opaque(kHaloColour), 1.3 * kLineWidth * size_}});
        mark(*at, kSpotRadius, named ? point.name : "", kHaloColour);
      }
  }

  Overlay finish() {
    for (const auto& s : strokes_)
      canvas_.lines(s.lines, {shadowOf(s.stroke.colour), s.stroke.width + 2.0 * kShadowWidth * size_, s.stroke.dash});
    for (const auto& s : strokes_) canvas_.lines(s.lines, s.stroke);
    for (const auto& d : discs_) canvas_.disc(d.centre, d.radius, d.colour);
    nameAll();
    return {canvas_.lineArt(), labels_.placed()};
  }

 private:
  struct Strokes {
    std::vector<PixelLine> lines;
    Stroke stroke;
  };
  struct Disc {
    Vec2 centre;
    double radius;
    Colour colour;
  };
  struct NamedSpot {
    std::string text;
    Vec2 at;
    double radius;  // pixels
    Colour colour;
  };
  struct NamedCurve {
    std::string text;
    std::vector<PixelLine> lines;
    std::optional<Vec2> preferred;
    Colour colour;
  };
  struct NamedGridLine {
    GridLine line;
    std::vector<PixelLine> shown;
  };

  std::vector<PixelLine> add(const std::vector<SkyLine>& lines, const Stroke& stroke) {
    std::vector<PixelLine> all;
    for (const SkyLine& line : lines)
      for (PixelLine& shown : linesInPicture(camera_, line, frame_)) all.push_back(std::move(shown));
    crowd_.add(all, 1.0);
    strokes_.push_back({all, stroke});
    return all;
  }

  void curve(const HaloCurve& halo, const Stroke& stroke, bool named) {
    std::vector<PixelLine> shown = add(halo.lines, stroke);
    if (named) curves_.push_back({halo.name, std::move(shown), camera_.project(halo.labelAt), stroke.colour});
  }

  void mark(const Vec2& at, double radius, const std::string& text, const Colour& colour) {
    labels_.keepOff({at - Vec2(radius * size_), at + Vec2(radius * size_)});
    if (!text.empty()) spots_.push_back({text, at, radius * size_, colour});
  }

  PixelLine ringAt(const Vec2& centre, double radius) const {
    PixelLine ring;
    for (const Vec3& p : circleAbout(Vec3(0.0, 0.0, 1.0), 0.5 * kPi))
      ring.push_back(centre + radius * size_ * Vec2(p.x, p.y));
    return ring;
  }

  /// Fewest lines under the label, other curves not beside it either, and near the place the curve asks for.
  double cost(const NamedCurve& curve, const Crowd& own, const Box& box, const Vec2& point) const {
    const Box wide = box.grownBy(kBeside * size_);
    const double lines = (crowd_.in(wide)-own.in(wide) + own.in(box)) / box.size().y;
    if (!curve.preferred) return lines;
    const double side = std::min(camera_.width(), camera_.height());
    return lines + glm::length(point - *curve.preferred) / (kWorthOfLine * side);
  }

  std::vector<Box> placesFor(const NamedCurve& curve) const {
    struct Candidate {
      double cost;
      Box box;
    };
    Crowd own(camera_.width(), camera_.height(), 0.5 * size_);
    own.add(curve.lines, 1.0);
    std::size_t points = 0;
    for (const PixelLine& line : curve.lines) points += line.size();
    const std::size_t stride = points / kLabelTries + 1;
    std::vector<Candidate> candidates;
    for (const PixelLine& line : curve.lines)
      for (std::size_t i = line.size() > stride ? stride / 2 : 0; i < line.size(); i += stride)
        for (const Box& box : labels_.beside(curve.text, line[i], kGap * size_))
          candidates.push_back({cost(curve, own, box, line[i]), box});
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    std::vector<Box> boxes;
    for (const Candidate& candidate : candidates) boxes.push_back(candidate.box);
    return boxes;
  }

  void name(const std::string& text, const std::vector<Box>& places, const Colour& colour) {
    if (const std::optional<PlacedLabel> label = labels_.place(text, places))
      canvas_.text(label->text, label->box.min, size_, opaque(colour), kTextShadow);
  }

  /// What has least choice comes first.
  void nameAll() {
    for (const NamedSpot& spot : spots_) {
      std::vector<Box> sides = labels_.beside(spot.text, spot.at, spot.radius + kGap * size_);
      std::stable_sort(sides.begin(), sides.end(),
                       [&](const Box& a, const Box& b) { return crowd_.in(a) < crowd_.in(b); });
      name(spot.text, sides, spot.colour);
    }
    for (const NamedCurve& curve : curves_) name(curve.text, placesFor(curve), curve.colour);
    for (const auto& [line, shown] : grid_)
      name(degreeText(line.angle, !line.isAltitude), gridLabelPlaces(camera_, labels_, line, shown, gridStep_),
           kGridColour);
  }

  Camera camera_;
  Canvas canvas_;
  Labels labels_;
  Crowd crowd_;
  double size_;  // of the letters, pixels
  Box frame_;    // the picture and a little more, so that lines do not thin out at its border
  double elevation_;
  Vec3 toSun_;
  double gridStep_ = 0.0;
  std::vector<Strokes> strokes_;
  std::vector<Disc> discs_;
  std::vector<NamedSpot> spots_;
  std::vector<NamedCurve> curves_;
  std::vector<NamedGridLine> grid_;
};

}  // namespace

Overlay overlay(const CameraSettings& camera, double sunElevation, double index, const OverlaySettings& settings) {
  validate(settings);
  Painter painter(camera, sunElevation, letterSize(camera, settings.scale));
  if (settings.gridStep > 0.0) painter.grid(settings.gridStep, settings.labels);
  if (settings.horizon) painter.horizon();
  painter.circles(settings.circles, settings.labels);
  if (settings.pyramids) painter.halos(pyramidRings(sunElevation, index), settings.labels);
  painter.sun(settings.labels);
  if (settings.zenith) painter.zenith(settings.labels);
  if (settings.halos) {
    const HaloForms forms = haloForms(sunElevation, index);
    painter.halos(forms.curves, settings.labels);
    painter.spots(forms.points, settings.labels);
  }
  return painter.finish();
}

}  // namespace parhelion
