// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "beam/end_crossings.h"
#include "beam/prism_light.h"
#include "beam/prism_section.h"

namespace parhelion {

/// Follows all light of one direction through a hexagonal prism at once.
///
/// Height and plane part: along c light only runs to and fro between the ends, and how often it met them follows from
/// the length of its way alone (EndCrossings). In the plane it is a strip of parallel light in a hexagon. It is cut
/// where its parts go to different sides; in each part the length of the way is linear across the strip. So all
/// integrals over the entry face are exact.
class PrismTracer {
 public:
  /// Light below `cutShare` of all that the crystal intercepts is not cut up any more but follows its middle, down to a
  /// thousandth of that, where it is given up. `length` is that of the prism along c, in units of the hexagon's side.
  /// `detailed`: PrismLight tells of orders and ways, too, which takes about as long again.
  PrismTracer(const PrismSection& section, double length, double index, double cutShare, bool detailed = false);

  /// What becomes of light of a unit direction in the crystal's frame.
  void trace(const Vec3& lightDir, PrismLight& light);

  /// How light of a direction comes to the faces: only the shadows and reflectances of trace().
  void meetOutside(const Vec3& lightDir, PrismLight& light) const;

 private:
  /// What light of one direction in the plane meets in one side.
  struct Side {
    double foot, slope;  // way along the direction to the side's line at w: foot + slope * w
    double turned;       // w after reflection is this less w before
    double reflectance;  // inside
    int next;            // element after reflection
  };
  /// Light after reflections that come to one element.
  struct Direction {
    std::array<Side, 6> side;
    int firstExit, exits;          // successive sides that it runs to: three, or two where it runs along the third
    std::array<double, 6> corner;  // w of the section's corners; rising along the sides that it runs to

    /// Way from side to side at w, not negative by rounding.
    double way(int from, int to, double w) const {
      const double way = (side[to].foot - side[from].foot) + (side[to].slope - side[from].slope) * w;
      return way > 0.0 ? way : 0.0;
    }
  };

  /// Part of a strip on a side, about to leave it. w is the coordinate across the strip. Its light is between y -
  /// window and y at each of its two edges, in lengths of the prism.
  struct Part {
    double w0, w1, y0, y1, window0, window1;
    double weight;  // what reflections at sides have left
    double share;   // its light, over that of the entry
    int element, side;
    int met;  // sides so far
  };

  void begin(int entry, const Vec3& inside);
  void passStraight(double reflectance);
  void prepare(const Vec2& direction, double inPlane);
  void enterSide(int side);
  void enterEnd();
  void step(const Part& part);
  void meet(const Part& part, int side, double w0, double w1, double way0, double way1);
  void tellOrders(const Part& met, double light, double sideReflectance, bool goesOn);

  PrismSection section_;
  double length_, cutShare_;
  RelativeIndex into_, outOf_;  // ice
  std::array<Direction, kPlaneElements> directions_;
  EndCrossings ends_;
  std::vector<Part> stack_;
  bool detailed_;
  // Of the entry that is being followed.
  PrismLight::Arrivals* arrived_ = nullptr;
  double* cutOff_ = nullptr;
  int firstEnd_ = kUpperEnd;  // that light meets first
  bool fromSide_ = false;
  double perWidth_ = 0.0;  // share of the entry's light, per width of strip and unit of y
  double rate_ = 0.0;      // y per way in the plane
  double smallest_ = 0.0;  // share of the entry's light below which parts are not cut up
  PrismLight* told_ = nullptr;
  double goesIn_ = 0.0;      // light, in the units of shadows
  double lengthPerY_ = 0.0;  // inside
};

}  // namespace parhelion
