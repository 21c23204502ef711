// SPDX-License-Identifier: Apache-2.0
#include "sky/radial_footprint.h"

#include <algorithm>
#include <utility>

#include "sky/projections.h"

namespace parhelion {
namespace {

// A cell of the picture is spread as if the place among the rings changed evenly across it, with corrections for how
// its second differences and the density of solid angle shift the shares. Where those are larger than this (the second
// differences relative to the first; the change of the density from side to side, relative), the cell is split into
// four. With these bounds an edge across a pixel is off by up to about 5e-4 of the pixel.
constexpr double kLargestBend = 0.03;
constexpr double kSteepest = 0.1;
// Splitting ends at 1/32 of a pixel: at the centre, at its antipode, and on the border of the sky.
constexpr int kDeepest = 5;

constexpr double kSlack = 1e-12;  // of the picture, for rounding at the border of the sky

/// How x gx + y gy is distributed over a unit square about the origin: a trapezoid, with a > b >= 0 or a = b > 0 the
/// larger and the smaller of |gx| and |gy|. The density grows with x gx + y gy, so that the mean is shifted.
class Trapezoid {
 public:
  Trapezoid(double a, double b, double shift)
      : reach_(0.5 * (a + b)),
        flat_(0.5 * (a - b)),
        perA_(1.0 / a),
        perTwiceAB_(b > 0.0 ? 0.5 / (a * b) : 0.0),
        slope_(12.0 * shift / (a * a + b * b)),
        lowering_(b * perA_ * (reach_ + 2.0 * flat_) / 6.0) {}

  /// Share below t.
  double below(double t) const {
    const double s = std::abs(t), corner = reach_ - s;
    if (corner <= 0.0) return t < 0.0 ? 0.0 : 1.0;
    // The slope lowers the share below t by as much as below -t.
    if (s < flat_) return 0.5 + t * perA_ - slope_ * (lowering_ + 0.5 * perA_ * (flat_ - s) * (flat_ + s));
    const double beyond = corner * corner * perTwiceAB_, lowered = slope_ * beyond * (reach_ + 2.0 * s) / 3.0;
    return (t < 0.0 ? beyond : 1.0 - beyond) - lowered;
  }

 private:
  double reach_, flat_, perA_, perTwiceAB_;
  double slope_;     // of the density
  double lowering_;  // of the share below flat_, per slope
};

/// Solid angle of a small triangle.
double triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 0.5 * std::abs(glm::dot(glm::cross(b - a, c - a), a));
}

Camera withoutHorizon(const Camera& camera) {
  CameraSettings settings = camera.settings();
  settings.horizon = Horizon::keep;
  return Camera(settings);
}

/// The point of the horizon above a unit vector; for the nadir any.
Vec3 onHorizon(const Vec3& toSky) {
  const double sine = std::sqrt(toSky.x * toSky.x + toSky.y * toSky.y);
  return sine > 0.0 ? Vec3(toSky.x / sine, toSky.y / sine, 0.0) : Vec3(1.0, 0.0, 0.0);
}

/// Change from pixel to pixel, given the values of the pixel before, the pixel and the one after, as far as the picture
/// has them: the lesser of the two, because a neighbour cut by the image circle tells nothing.
double lesserChange(const double* before, double here, const double* after) {
  const double down = before ? here - *before : 0.0, up = after ? *after - here : 0.0;
  if (!before || !after) return down + up;
  return std::abs(down) < std::abs(up) ? down : up;
}

}  // namespace

SkyBorder::SkyBorder(const Camera& camera)
    : fisheye_(isFisheye(camera.settings().projection)),
      centre_(camera.axis()),
      reach_(camera.focalLength() * Vec2(kPi, 0.5 * kPi)) {
  if (!fisheye_) return;
  // Bisection between the axis and a corner: the camera knows its circle as an angle.
  const Vec2 corner = camera.farthestCorner();
  double inside = 0.0, outside = 1.0;
  while (outside - inside > kSlack) {
    const double middle = 0.5 * (inside + outside);
    (camera.directionAt(middle * corner + centre_ * (1.0 - middle)) ? inside : outside) = middle;
  }
  reach_ = Vec2(inside * glm::length(corner - centre_));
}

Vec2 SkyBorder::moved(Vec2 pixel) const {
  const Vec2 d = pixel - centre_;
  if (fisheye_) return centre_ + d * (reach_.x * (1.0 - kSlack) / glm::length(d));
  return centre_ + (1.0 - kSlack) * glm::clamp(d, -reach_, reach_);
}

Vec2 SkyBorder::innermost(Vec2 lo, double size) const { return glm::clamp(centre_, lo, lo + size); }

RadialFootprint::RadialFootprint(const Camera& camera, const RadialSky& sky, int columns)
    : camera_(withoutHorizon(camera)),
      sky_(sky),
      border_(camera_),
      cutsHorizon_(camera.cutsHorizon()),
      columns_(columns),
      solidAngles_(camera.solidAngles()),
      share_(static_cast<std::size_t>(sky.bins()), 0.0) {
  visitProjection(camera_.settings().projection, [this](auto facts) {
    if (facts.isPanorama) grid_.emplace(camera_);
    if (facts.isFlat && camera_.settings().distortion.none()) flatGrid_.emplace(camera_);
  });
}

void RadialFootprint::setRow(int y) {
  upper_ = y == row_ + 1 && y > 0 ? std::move(lower_) : cornersAt(y);
  lower_ = cornersAt(y + 1);
  row_ = y;
}

void RadialFootprint::setPixel(int x) {
  for (int bin = first_; bin <= last_; ++bin) share_[static_cast<std::size_t>(bin)] = 0.0;
  first_ = sky_.bins();
  last_ = -1;
  total_ = 0.0;
  const double solidAngle = solidAngles_[static_cast<std::size_t>(row_) * camera_.width() + x];
  if (solidAngle == 0.0) return;
  slope_ = slopeAt(x);
  bendX_ = bendAt(x);
  const Cell cell{{x, row_}, 1.0, {{upper_[x], upper_[x + 1]}, {lower_[x], lower_[x + 1]}}};
  cover(cell, pointOnGrid(2 * x + 1, 2 * row_ + 1), 0);
  if (total_ == 0.0) spread(pointAt(border_.innermost(cell.lo, cell.size)).place, 0.0, 0.0, 0.0, 1.0);
  perShare_ = solidAngle / total_;
}

RadialFootprint::Point RadialFootprint::pointToward(const std::optional<Vec3>& seen, Vec2 pixel) const {
  Vec3 toSky = seen ? *seen : camera_.directionAt(border_.moved(pixel)).value();
  const bool isBelow = cutsHorizon_ && toSky.z < 0.0;
  if (isBelow) toSky = onHorizon(toSky);
  return {toSky, sky_.place(toSky), !seen || isBelow};
}

/// A corner or a centre of a pixel, at half of these coordinates.
RadialFootprint::Point RadialFootprint::pointOnGrid(int twiceX, int twiceY) const {
  const Vec2 pixel = 0.5 * Vec2(twiceX, twiceY);
  if (flatGrid_) return pointToward(flatGrid_->toSky(twiceX, twiceY), pixel);
  return grid_ ? pointToward(grid_->toSky(twiceX, twiceY), pixel) : pointAt(pixel);
}

/// The corners of the pixels on a horizontal line of the picture.
std::vector<RadialFootprint::Point> RadialFootprint::cornersAt(int y) const {
  const int last = std::min(columns_ + 1, camera_.width());  // one more than pixels have: bendAt() looks beyond
  std::vector<Point> corners;
  corners.reserve(static_cast<std::size_t>(last) + 1);
  for (int x = 0; x <= last; ++x) corners.push_back(pointOnGrid(2 * x, 2 * y));
  return corners;
}

Vec2 RadialFootprint::slopeAt(int x) const {
  const int width = camera_.width(), height = camera_.height();
  const double* here = &solidAngles_[static_cast<std::size_t>(row_) * width + x];
  const double alongX = lesserChange(x > 0 ? here - 1 : nullptr, *here, x + 1 < width ? here + 1 : nullptr);
  const double alongY =
      lesserChange(row_ > 0 ? here - width : nullptr, *here, row_ + 1 < height ? here + width : nullptr);
  return Vec2{alongX, alongY} / *here;
}

double RadialFootprint::bendAt(int x) const {
  if (camera_.width() < 3) return 0.0;
  const int first = std::clamp(x, 1, camera_.width() - 2) - 1;  // at the sides, the neighbour's
  const Point* at = &upper_[static_cast<std::size_t>(first)];
  return 0.5 * ((at[3].place - at[2].place) - (at[1].place - at[0].place));
}

double RadialFootprint::area(const Cell& cell, const Point& centre) {
  const Vec3 &a = cell.at[0][0].toSky, &b = cell.at[0][1].toSky, &c = cell.at[1][1].toSky, &d = cell.at[1][0].toSky;
  return triangle(centre.toSky, a, b) + triangle(centre.toSky, b, c) + triangle(centre.toSky, c, d) +
         triangle(centre.toSky, d, a);
}

/// By how much the density's change across a cell would lead its shares astray.
double RadialFootprint::steepness(const Vec2& slope, double gx, double gy) const {
  if (!grid_) return std::abs(slope.x) + std::abs(slope.y);
  // A panorama's density changes with latitude alone, and as evenly as can be down to the poles. The less the place
  // among the rings changes with longitude, the less a steep change harms.
  const double across = std::abs(gx), along = std::abs(gy);
  return std::abs(slope.y) * (across < along ? across / along : 1.0);
}

void RadialFootprint::cover(const Cell& cell, const Point& centre, int depth) {
  const auto& at = cell.at;
  const bool cut = centre.moved || at[0][0].moved || at[0][1].moved || at[1][0].moved || at[1][1].moved;
  if (cut && !camera_.directionAt(border_.innermost(cell.lo, cell.size))) return;
  const auto isAbove = [](const Point& point) { return point.toSky.z > 0.0; };
  const bool above =
      isAbove(centre) || isAbove(at[0][0]) || isAbove(at[0][1]) || isAbove(at[1][0]) || isAbove(at[1][1]);
  if (cutsHorizon_ && cut && !above) return;
  const double p00 = at[0][0].place, p10 = at[0][1].place, p01 = at[1][0].place, p11 = at[1][1].place;
  const double gx = 0.5 * ((p10 - p00) + (p11 - p01)), gy = 0.5 * ((p01 - p00) + (p11 - p10));
  const double rise = 0.25 * (p00 + p10 + p01 + p11) - centre.place;  // 1/8 of the Laplacian
  const double xx = cell.size * cell.size * bendX_, yy = 8.0 * rise - xx, xy = p00 - p10 - p01 + p11;
  const double bend = std::abs(xx) + std::abs(yy) + std::abs(xy);
  const Vec2 slope = cell.size * (grid_ && depth > 0 ? Vec2(0.0, grid_->slopeAt(centre.toSky)) : slope_);
  const bool linear = cell.size * bend <= kLargestBend * (std::abs(gx) + std::abs(gy)) &&
                      cell.size * steepness(slope, gx, gy) <= kSteepest;
  if ((cut || !linear) && depth < kDeepest) return split(cell, centre, depth);
  // Second order along the gradient: the corners are where the linear form has them, what lies between is shifted.
  // Across it, the rings are curved: that moves the mean alone.
  const double g2 = gx * gx + gy * gy;
  const double along = g2 > 0.0 ? (gx * gx * xx + 2.0 * gx * gy * xy + gy * gy * yy) / g2 : 0.0;
  const double across = xx + yy - along;
  // The weights of a pixel's cells are relative: one that is alone needs none.
  spread(centre.place + along / 8.0 + across / 24.0, gx, gy, (slope.x * gx + slope.y * gy - along) / 12.0,
         depth == 0 ? 1.0 : area(cell, centre));
}

void RadialFootprint::split(const Cell& cell, const Point& centre, int depth) {
  const double half = 0.5 * cell.size;
  Point grid[3][3];
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      const bool corner = i != 1 && j != 1;
      grid[j][i] = corner ? cell.at[j / 2][i / 2] : pointAt(cell.lo + half * Vec2(i, j));
    }
  }
  grid[1][1] = centre;
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < 2; ++i) {
      const Vec2 lo = cell.lo + half * Vec2(i, j);
      cover({lo, half, {{grid[j][i], grid[j][i + 1]}, {grid[j + 1][i], grid[j + 1][i + 1]}}}, pointAt(lo + 0.5 * half),
            depth + 1);
    }
  }
}

/// Adds a cell about `place` with these differences of place from side to side and this shift of its mean.
void RadialFootprint::spread(double place, double gx, double gy, double shift, double weight) {
  const double a = std::max(std::abs(gx), std::abs(gy)), smaller = std::min(std::abs(gx), std::abs(gy));
  constexpr double kNarrow = 1e-12;  // of a; a trapezoid's side this narrow is upright, and 1 / (a b) stays finite
  const double b = smaller > kNarrow * a ? smaller : 0.0;
  const double reach = 0.5 * (a + b);
  const auto binAt = [this](double p) { return std::clamp(static_cast<int>(p), 0, sky_.bins() - 1); };
  const int from = binAt(place - reach), to = binAt(place + reach);
  double below = 0.0;
  if (from < to) {
    // Beyond this shift a share would be negative. Only cells that cannot be split further come close.
    const double most = (a * a + b * b) / (12.0 * reach);
    const Trapezoid shape(a, b, std::clamp(shift, -most, most));
    for (int bin = from; bin < to; ++bin) {
      const double next = shape.below(bin + 1 - place);
      share_[static_cast<std::size_t>(bin)] += weight * (next - below);
      below = next;
    }
  }
  share_[static_cast<std::size_t>(to)] += weight * (1.0 - below);
  first_ = std::min(first_, from);
  last_ = std::max(last_, to);
  total_ += weight;
}

}  // namespace parhelion
