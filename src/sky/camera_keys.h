// SPDX-License-Identifier: Apache-2.0
#pragma once

// Every key of a camera, said once: its name in scene files, its attribute in a tally's file, what it accepts, what it
// means and the setting it stands for. Whoever reads, writes, describes or compares cameras is a visitor of this table,
// with a function for each kind of row:
//
//   projection(key)                      the others' defaults depend on it, so it comes first
//   number(key, unit, member)
//   numberOrNone(key, unit, member)      0 stands for none
//   numbers(key, unit, member, parts)    a struct of numbers, in scene files a list; all 0 when left out
//   choice(key, member)                  one of the names of an enumeration
//   fieldOfView(attributes, unit)        the angle and the axis it is along: one key of kFieldOfViewKeys for each axis
//   resolution(key)                      no attribute: a picture has its size already

#include <array>
#include <string_view>

#include "math/range.h"
#include "sky/camera_settings.h"

namespace parhelion {

struct CameraKey {
  std::string_view name;       // in scene files
  std::string_view attribute;  // in a tally's file, after "camera."
  std::string_view documentation;
  bool isNewer = false;  // left out of a tally's file where it has its default, as in files from before there was it
};

/// A number with what it accepts in scene files and the unit it has there and wherever people see it.
struct InDegrees {  // radians in settings and attributes
  Range range;
  static double shown(double value) { return degrees(value); }
};
struct Unitless {
  Range range;
  static double shown(double value) { return value; }
};

/// One of the numbers of a struct, with its attribute.
template <class Struct>
struct NumberPart {
  std::string_view name;
  double Struct::*member;
};

struct FieldOfViewKey {
  std::string_view name;
  std::string_view axisName;  // in attributes and descriptions
  FieldOfViewAxis axis;
  std::string_view documentation;
};

/// In the enumeration's order.
inline constexpr auto kFieldOfViewKeys = std::to_array<FieldOfViewKey>({
    {"fov_horizontal", "horizontal", FieldOfViewAxis::horizontal,
     "Field of view from left to right, degrees; one fov_… at most. Left out: 180 for a fisheye, 360 for "
     "equirectangular, 60 for rectilinear. Dual fisheyes and a globe always show whole hemispheres."},
    {"fov_vertical", "vertical", FieldOfViewAxis::vertical, "Field of view from bottom to top, degrees."},
    {"fov_diagonal", "diagonal", FieldOfViewAxis::diagonal, "Field of view from corner to corner, degrees."},
});

constexpr const FieldOfViewKey& keyOf(FieldOfViewAxis axis) { return kFieldOfViewKeys[static_cast<std::size_t>(axis)]; }
static_assert(keyOf(FieldOfViewAxis::horizontal).axis == FieldOfViewAxis::horizontal &&
              keyOf(FieldOfViewAxis::vertical).axis == FieldOfViewAxis::vertical &&
              keyOf(FieldOfViewAxis::diagonal).axis == FieldOfViewAxis::diagonal);

struct FieldOfViewAttributes {
  std::string_view axis, angle;
};

template <class Visitor>
void visitCameraKeys(Visitor& v) {
  v.projection(CameraKey{"projection", "projection", "How directions become places in the image."});
  v.number(CameraKey{"azimuth", "azimuth", "Azimuth of the optical axis from the sun, degrees."},
           InDegrees{{-360, 360}}, &CameraSettings::azimuth);
  v.number(CameraKey{"elevation", "elevation",
                     "Elevation of the optical axis, degrees. Left out: 90 for a fisheye or two, 0 for the others."},
           InDegrees{{-90, 90}}, &CameraSettings::elevation);
  v.number(CameraKey{"roll", "roll", "Clockwise turn of the camera as its user sees it, degrees."},
           InDegrees{{-360, 360}}, &CameraSettings::roll);
  v.fieldOfView(FieldOfViewAttributes{"fovAxis", "fov"}, InDegrees{{0, 360, true}});
  v.numberOrNone(
      CameraKey{"image_circle", "circle",
                "Full angle that a fisheye lens covers, degrees. Left out: the larger of 180 and the field of view."},
      InDegrees{{0, 360, true}}, &CameraSettings::imageCircle);
  v.numbers(
      CameraKey{"distortion", "",
                "[k1, k2, k3]: the lens moves what is r focal lengths from the centre to r (1 + k1 r^2 + k2 r^4 + "
                "k3 r^6). The field of view stays that of the ideal lens."},
      Unitless{{-1000, 1000}}, &CameraSettings::distortion,
      std::to_array<NumberPart<Distortion>>(
          {{"k1", &Distortion::k1}, {"k2", &Distortion::k2}, {"k3", &Distortion::k3}}));
  v.numbers(
      CameraKey{
          "shift", "",
          "[x, y]: how many focal lengths the picture lies to the right of the optical axis and above it, as behind "
          "a lens for perspective control. The field of view stays that of the centred picture.",
          true},
      Unitless{{-10, 10}}, &CameraSettings::shift,
      std::to_array<NumberPart<Shift>>({{"shiftX", &Shift::x}, {"shiftY", &Shift::y}}));
  v.choice(
      CameraKey{"horizon", "horizon",
                "\"cut\" leaves out what lies below the horizon: there the picture is black, and pixels on the horizon "
                "show the sky above it alone.",
                true},
      &CameraSettings::horizon);
  v.resolution(CameraKey{"resolution", "",
                         "[width, height] in pixels. Left out: [1024, 1024], [2048, 1024] for equirectangular "
                         "and dual fisheyes."});
}

}  // namespace parhelion
