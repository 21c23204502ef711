// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "math/conventions.h"
#include "sky/camera_settings.h"
#include "sky/fixed_point.h"

namespace parhelion {

/// Rays first, first + 1, ..., first + count - 1.
struct RayRange {
  std::uint64_t first = 0;
  std::uint64_t count = 0;

  bool operator==(const RayRange&) const = default;
};

/// What a tally's sums were made of. With it, a reconstruction needs neither the scene nor the tracer.
struct TallyInfo {
  std::uint64_t seed = 0;
  std::vector<RayRange> rays;    // traced so far; ascending, not touching, none empty
  std::int64_t intercepted = 0;  // fixed point; light taken from the beam: per ray 1 on average, 2 if mirrored
  std::int64_t undeviated = 0;   // fixed point; the part of it that goes on in the sun's direction, in no pixel
  Vec3 white{1.0, 1.0, 1.0};     // CIE XYZ of the undeviated sunlight, Y = 1
  double sunElevation = 0.0;     // rad
  double sunDiameter = 0.0;      // rad, 0 is a point
  CameraSettings camera;         // its width and height are the tally's
  std::string scene;             // the whole scene file, overrides applied
  std::string version;           // of the program that traced

  bool operator==(const TallyInfo&) const = default;

  /// The number of rays in all ranges together.
  std::uint64_t rayCount() const;

  double interceptedLight() const { return fromFixed(intercepted); }

  /// Undeviated over intercepted light, 0 before the first ray.
  double undeviatedFraction() const;
};

/// The ranges in ascending order. Ranges that touch are joined, empty ones dropped. Throws std::invalid_argument if two
/// overlap.
std::vector<RayRange> joined(std::vector<RayRange> ranges);

/// What each pixel of the camera received, as exact integers. It is the contract between tracing and reconstruction.
/// The unit of light is what a ray brings on average.
class Tally {
 public:
  TallyInfo info;  // camera and white stay as they were constructed; the rest is the tracer's to fill in

  /// An empty tally. `colours` is 3 (CIE XYZ) or 1 (luminance only, for monochromatic light).
  /// Throws std::invalid_argument for other numbers, a camera out of range, or a white that is negative, not finite or
  /// has Y other than 1.
  explicit Tally(TallyInfo tallyInfo, int colours = 3);

  int width() const { return width_; }
  int height() const { return height_; }
  int colours() const { return colours_; }
  int pixels() const { return width_ * height_; }

  /// Adds the light (CIE XYZ) of one bundle of rays to a pixel, given by its row-major index. Safe to call from any
  /// number of threads at once.
  ///
  /// `firstHalf` is true for bundles of even number. The two halves are independent estimates of the same picture.
  ///
  /// A bundle may bring light to one pixel more than once. That light should be summed before and added once, else the
  /// sum of squares is too small.
  ///
  /// Throws std::overflow_error where the pixel cannot hold it.
  void add(int pixel, const Vec3& xyz, bool firstHalf) {
    deposit(pixel, xyz, firstHalf, [](std::int64_t& sum, std::int64_t amount) {
      std::int64_t before = std::atomic_ref<std::int64_t>(sum).fetch_add(amount, std::memory_order_relaxed);
      addFixed(before, amount);
    });
  }

  /// Does the same, several times faster. The caller must see to it that nobody else adds to the pixel at the same
  /// time.
  void addExclusively(int pixel, const Vec3& xyz, bool firstHalf) { deposit(pixel, xyz, firstHalf, addFixed); }

  /// Tells the processor to fetch a pixel into the cache, because light will be added to it soon.
  void prefetch(int pixel) const { __builtin_prefetch(&at(static_cast<std::size_t>(pixel) * stride_), 1); }

  /// The light of a pixel in CIE XYZ. With one colour it is the luminance in the sun's white.
  Vec3 xyz(int pixel) const;

  /// Sums of a pixel: the luminance of all bundles, that of the bundles of even number, and the square of the luminance
  /// that each bundle brought.
  double luminance(int pixel) const { return fromFixed(raw(pixel, kY)); }
  double firstHalf(int pixel) const { return fromFixed(raw(pixel, kFirstHalf)); }
  double squares(int pixel) const { return fromFixed(raw(pixel, kSquares), kSquareScale); }

  /// How many times light was added to a pixel.
  std::int64_t hits(int pixel) const { return raw(pixel, kHits); }

  /// The standard error of luminance(pixel). Divided by the intercepted light and the solid angle, it is the standard
  /// error of the radiance.
  double luminanceError(int pixel) const;

  /// Adds the rays of another tally of the same scene. Gaps between the ranges of rays are allowed. Throws
  /// std::invalid_argument, and changes nothing, if scene, seed, camera or colours differ or if a ray is in both.
  /// Throws std::overflow_error, and is good for nothing more, where one of the two is too full for the other.
  void merge(const Tally& other);

  bool operator==(const Tally& other) const;

  /// Adds to every pixel what its mirror image, left for right, holds. Each ray then counts for two. If the width is
  /// odd, both land in the same pixel of the middle column. Throws std::overflow_error where a pixel cannot hold it.
  void addMirrorImage();

  /// For a tally after addMirrorImage(): takes away what is right of the middle and half of the middle's light, so that
  /// addMirrorImage() makes the same again.
  void removeMirrorImage();

  /// The numbers that are stored for each pixel, for files. X and Z are relative to the white, so that none can
  /// overflow.
  enum Slot : int { kY, kFirstHalf, kSquares, kHits, kX, kZ };
  int slots() const { return colours_ == 1 ? 4 : 6; }
  std::int64_t raw(int pixel, int slot) const {
    return at(static_cast<std::size_t>(pixel) * stride_ + static_cast<std::size_t>(slot));
  }
  void setRaw(int pixel, int slot, std::int64_t value) {
    at(static_cast<std::size_t>(pixel) * stride_ + static_cast<std::size_t>(slot)) = value;
  }

 private:
  // A pixel has 8 integers (colour) or 4 (luminance only), so that all of them lie in one cache line.
  struct alignas(64) CacheLine {
    std::array<std::int64_t, 8> place{};
    bool operator==(const CacheLine&) const = default;
  };

  std::int64_t& at(std::size_t i) { return lines_[i / 8].place[i % 8]; }
  const std::int64_t& at(std::size_t i) const { return lines_[i / 8].place[i % 8]; }

  template <class AddTo>
  void deposit(int pixel, const Vec3& xyz, bool firstHalf, AddTo addTo) {
    std::int64_t* sums = &at(static_cast<std::size_t>(pixel) * stride_);
    const std::int64_t luminance = toFixed(xyz.y);
    addTo(sums[kY], luminance);
    addTo(sums[kSquares], toFixed(xyz.y * xyz.y, kSquareScale));
    addTo(sums[kHits], 1);
    if (firstHalf) addTo(sums[kFirstHalf], luminance);
    if (colours_ == 1) return;
    addTo(sums[kX], toFixed(xyz.x * perWhite_.x));
    addTo(sums[kZ], toFixed(xyz.z * perWhite_.z));
  }

  int width_, height_, colours_;
  std::size_t stride_;
  Vec3 perWhite_;  // 1 / white, 0 where the white has none
  std::vector<CacheLine> lines_;
};

}  // namespace parhelion
