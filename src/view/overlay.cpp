// SPDX-License-Identifier: Apache-2.0
#include "view/overlay.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include <glm/geometric.hpp>

#include "math/rotation.h"
#include "optics/halo_forms.h"
#include "view/curve_labels.h"
#include "view/legend.h"
#include "view/palette.h"
#include "view/picture_lines.h"
#include "view/sky_grid.h"

namespace parhelion {
namespace {

constexpr double kFinestGrid = radians(0.1);
constexpr double kUsualGrid = radians(10), kWideGrid = radians(30);
constexpr double kRounding = 1e-9;  // relative, of a step that was once in degrees

// Letters take this share of the picture's shorter side, and are never smaller than can be read, pixels.
constexpr double kLetterShare = 1.0 / 50.0;
constexpr double kSmallestLetters = 9.0;

// All other lengths are in sizes of the letters.
constexpr double kLineWidth = 0.075;
constexpr double kShadowWidth = 0.07;  // that much more on either side of a line
constexpr double kSunRadius = 0.55;
constexpr double kSpotRadius = 0.3;
constexpr double kNamedSpot = 0.16;
constexpr double kCross = 0.45;  // half length of the zenith's arms

constexpr double kThinnestLine = 0.9;  // pixels
constexpr double kClosestGrid = 2.0;   // between lines, sizes of the letters

// Rare halos are for pictures whose shorter side is at least this many letters.
constexpr double kRoomForRare = 26.0;

// Of lines of halos that are rare, to that of the others.
constexpr double kRareWidth = 0.75;

Colour opaque(Colour c) {
  c.alpha = 1.0;
  return c;
}

void validate(const OverlaySettings& s) {
  const double step = s.gridStep.value_or(kUsualGrid);
  if (step != 0.0 && !(step >= kFinestGrid * (1.0 - kRounding) && step <= kPi))
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
  Painter(const CameraSettings& settings, double sunElevation, double size, const Palette& palette, bool below)
      : camera_(settings),
        canvas_(settings.width, settings.height),
        labels_(camera_, canvas_, size, below),
        crowd_(settings.width, settings.height, 0.5 * size),
        size_(size),
        frame_(Box{Vec2(0.0), Vec2(settings.width, settings.height)}.grownBy(size)),
        elevation_(sunElevation),
        palette_(palette),
        below_(below),
        toSun_(skyDirection(0.0, sunElevation)) {}

  double usualGridStep() const {
    return kUsualGrid * camera_.focalLength() < kClosestGrid * size_ ? kWideGrid : kUsualGrid;
  }

  void grid(double step, bool named) {
    std::vector<PixelLine> above, below;
    const int every = labelEvery(camera_, labels_, step);
    for (GridLine& line : gridLines(step)) {
      if (line.isBelow && !below_) continue;
      std::vector<PixelLine> shown = linesInPicture(camera_, line.line, frame_);
      crowd_.add(shown, 0.15);
      std::vector<PixelLine>& all = line.isBelow ? below : above;
      all.insert(all.end(), shown.begin(), shown.end());
      const bool isSecondHalf = line.isBelow && !line.isAltitude;  // of a meridian
      if (named && !isSecondHalf && line.number % every == 0 && !shown.empty())
        grid_.push_back({std::move(line), std::move(shown)});
    }
    gridStep_ = step;
    strokes_.push_back({std::move(below), {palette_.below, width(1.0)}});
    strokes_.push_back({std::move(above), {palette_.grid, width(1.0)}});
  }

  void horizon() { add({circleAbout(Vec3(0.0, 0.0, 1.0), 0.5 * kPi)}, {palette_.horizon, width(1.7)}); }

  void zenith(bool named) {
    const std::optional<Vec2> at = camera_.project(Vec3(0.0, 0.0, 1.0));
    if (!at) return;
    const Vec2 right(kCross * size_, 0.0), up(0.0, kCross * size_);
    strokes_.push_back({{{*at - right, *at + right}, {*at - up, *at + up}}, {opaque(palette_.grid), width(1.4)}});
    mark(*at, kCross, named ? "zenith" : "", palette_.grid);
  }

  void sun(bool named) {
    const std::optional<Vec2> at = placeOf(toSun_);
    if (!at) return;
    strokes_.push_back({{ringAt(*at, kSunRadius)}, {palette_.sun, width(1.5)}});
    discs_.push_back({*at, 0.16 * size_, palette_.sun});
    mark(*at, kSunRadius, named ? "sun" : "", palette_.sun);
  }

  void circles(const std::vector<double>& radii, bool named) {
    for (const double radius : radii) {
      const Vec3 below = skyDirection(0.0, elevation_ - radius);
      curve(degreeText(radius, false), {circleAbout(toSun_, radius)}, below,
            {palette_.circle, width(1.2), 0.45 * size_}, named);
    }
  }

  void halos(const HaloForms& forms, bool named) {
    const bool isSmall = std::min(camera_.width(), camera_.height()) < kRoomForRare * size_;
    for (const HaloCurve& halo : forms.curves) {
      if (halo.isRare && isSmall) continue;
      const double share = halo.isRare ? kRareWidth : 1.0;
      const bool isSeen =
          curve(halo.name, halo.lines, halo.labelAt, {palette_.of(halo.family), width(1.5 * share)}, named);
      if (isSeen) families_.insert(halo.family);
    }
    for (const HaloPoint& point : forms.points)
      if (const std::optional<Vec2> at = placeOf(point.toSky)) {
        const Colour colour = palette_.of(point.family);
        strokes_.push_back({{ringAt(*at, kSpotRadius)}, {opaque(colour), width(1.5)}});
        mark(*at, kSpotRadius, named ? point.name : "", colour);
        families_.insert(point.family);
      }
  }

  void names(const std::vector<NamedPlace>& places) {
    for (const NamedPlace& place : places) {
      discs_.push_back({place.at, kNamedSpot * size_, palette_.sun});
      mark(place.at, kNamedSpot, place.text, palette_.sun);
    }
  }

  Overlay finish(bool legend) {
    for (const auto& s : strokes_)
      canvas_.lines(s.lines, {shadowOf(s.stroke.colour), s.stroke.width + 2.0 * kShadowWidth * size_, s.stroke.dash});
    for (const auto& s : strokes_) canvas_.lines(s.lines, s.stroke);
    for (const auto& d : discs_) canvas_.disc(d.centre, d.radius, d.colour);
    if (legend) drawLegend(canvas_, labels_, crowd_, camera_, {families_.begin(), families_.end()}, palette_);
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
  struct NamedGridLine {
    GridLine line;
    std::vector<PixelLine> shown;
  };

  double width(double share) const { return std::max(kThinnestLine, share * kLineWidth * size_); }

  Colour shadowOf(const Colour& c) const {
    Colour shadow = palette_.shadow;
    shadow.alpha *= c.alpha;
    return shadow;
  }

  /// None outside the picture, and for what is not to be drawn below the horizon.
  std::optional<Vec2> placeOf(const Vec3& toSky) const {
    return below_ || toSky.z >= 0.0 ? camera_.project(toSky) : std::nullopt;
  }

  std::vector<PixelLine> add(const std::vector<SkyLine>& lines, const Stroke& stroke) {
    std::vector<PixelLine> all;
    for (const SkyLine& line : lines)
      for (const SkyLine& drawn : below_ ? std::vector<SkyLine>{line} : aboveHorizon(line))
        for (PixelLine& shown : linesInPicture(camera_, drawn, frame_)) all.push_back(std::move(shown));
    crowd_.add(all, 1.0);
    strokes_.push_back({all, stroke});
    return all;
  }

  /// Whether anything of it is in the picture.
  bool curve(const std::string& name, const std::vector<SkyLine>& lines, const Vec3& labelAt, const Stroke& stroke,
             bool named) {
    std::vector<PixelLine> shown = add(lines, stroke);
    if (shown.empty()) return false;
    if (named) curves_.push_back({name, std::move(shown), placeOf(labelAt), stroke.colour});
    return true;
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

  void name(const std::string& text, const std::vector<LabelPlace>& places, const Colour& colour) {
    const std::optional<LabelPlace> label = labels_.place(text, places);
    if (!label) return;
    canvas_.lines({{label->anchor, label->foot()}},
                  {shadowOf(opaque(colour)), width(1.2) + 2.0 * kShadowWidth * size_});
    canvas_.lines({{label->anchor, label->foot()}}, {opaque(colour), width(1.2)});
    canvas_.text(text, label->box.min, size_, opaque(colour), palette_.textShadow);
  }

  /// What has least choice comes first.
  void nameAll() {
    for (const NamedSpot& spot : spots_) name(spot.text, placesFor(spot, crowd_, labels_), spot.colour);
    for (const NamedCurve& curve : curves_) name(curve.text, placesFor(curve, crowd_, labels_, camera_), curve.colour);
    for (const auto& [line, shown] : grid_) {
      const std::string text = degreeText(line.angle, !line.isAltitude);
      if (const auto label = labels_.place(text, gridLabelPlaces(camera_, labels_, line, shown, gridStep_)))
        canvas_.text(text, label->box.min, size_, opaque(palette_.grid), palette_.textShadow);
    }
  }

  Camera camera_;
  Canvas canvas_;
  Labels labels_;
  Crowd crowd_;
  double size_;  // of the letters, pixels
  Box frame_;    // the picture and a little more, so that lines do not thin out at its border
  double elevation_;
  const Palette& palette_;
  bool below_;  // whether there are lines below the horizon
  Vec3 toSun_;
  double gridStep_ = 0.0;
  std::vector<Strokes> strokes_;
  std::vector<Disc> discs_;
  std::vector<NamedSpot> spots_;
  std::vector<NamedCurve> curves_;
  std::vector<NamedGridLine> grid_;
  std::set<HaloFamily> families_;  // of which something is in the picture
};

}  // namespace

Overlay overlay(const CameraSettings& camera, double sunElevation, double index, const OverlaySettings& settings) {
  validate(settings);
  Painter painter(camera, sunElevation, letterSize(camera, settings.scale), settings.onPaper ? kOnPaper : kOnSky,
                  settings.belowHorizon);
  const double step = settings.gridStep.value_or(painter.usualGridStep());
  if (step > 0.0) painter.grid(step, settings.labels);
  if (settings.horizon) painter.horizon();
  painter.circles(settings.circles, settings.labels);
  painter.sun(settings.labels);
  if (settings.zenith) painter.zenith(settings.labels);
  const bool namesHalos = settings.labels && settings.names.empty();
  if (settings.halos) painter.halos(haloForms(sunElevation, index, settings.makers), namesHalos);
  if (settings.labels) painter.names(settings.names);
  return painter.finish(settings.labels);
}

}  // namespace parhelion
