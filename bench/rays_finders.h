// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <variant>

#include "math/overloaded.h"
#include "trace/engine.h"

namespace parhelion::bench {

/// Half-spaces in single precision, four at a time: the counterpart of nextFaceByPlanes() that rounds the ray and the
/// crystal to floats.
class FloatPlanes {
 public:
  explicit FloatPlanes(const Crystal& crystal);

  /// As the engines' nextFace(), of the crystal that was given before.
  std::optional<FaceHit> nextFace(const Crystal&, const Vec3& point, const Vec3& lightDir, int leftFace) const {
    const glm::vec3 p(point), d(lightDir);
    Lanes face = Lanes{} + kNoFace, nearest = Lanes{} + kNowhere, cosine{};
    for (int i = 0; i < count_; ++i) {
      const Four& f = faces_[i];
      const Lanes approach = f.x * d.x + f.y * d.y + f.z * d.z;
      const Lanes distance = (f.offset - (f.x * p.x + f.y * p.y + f.z * p.z)) / approach;
      const Bits nearer = (approach > 0.0f) & (distance < nearest) & (f.index != static_cast<float>(leftFace));
      nearest = nearer ? distance : nearest;
      cosine = nearer ? approach : cosine;
      face = nearer ? f.index : face;
    }
    int lane = 0;
    for (int k = 1; k < kLanes; ++k) lane = nearest[k] < nearest[lane] ? k : lane;
    if (face[lane] == kNoFace) return std::nullopt;
    return FaceHit{static_cast<int>(face[lane]), nearest[lane], cosine[lane], false};
  }

 private:
  static constexpr float kNowhere = std::numeric_limits<float>::infinity();
  static constexpr int kLanes = 4;
  using Lanes = float __attribute__((vector_size(kLanes * sizeof(float))));
  using Bits = std::int32_t __attribute__((vector_size(kLanes * sizeof(float))));

  /// Planes side by side; those that are none have a zero normal and are never met.
  struct Four {
    Lanes x{}, y{}, z{}, offset{}, index{};
  };
  std::array<Four, kMaxFaces / kLanes> faces_;
  int count_;  // of faces_ in use
};

/// An engine's own intersector, or one that no engine has.
using Finder = std::variant<Intersector, FloatPlanes>;

/// A way to find the next face, and the engine of whole renders that does it so, if there is one.
struct FinderKind {
  std::string id, label;
  std::optional<Engine> engine;
};

/// All that are compared; the charts take labels from here and colours by the id (bench/rays_style.gp).
std::span<const FinderKind> finderKinds();

/// A finder for a cloud's only crystal; valid as long as the cloud.
Finder makeFinder(const FinderKind& kind, const Cloud& cloud);

/// Calls `use` with the intersector in a finder, so that the kind is looked up once for many rays.
template <class Use>
auto withFinder(const Finder& finder, const Use& use) {
  return std::visit(Overloaded{[&](const Intersector& engine) { return std::visit(use, engine); },
                               [&](const FloatPlanes& planes) { return use(planes); }},
                    finder);
}

/// The next face by half-spaces in long double, with 64 bits of mantissa where the processor has them.
int exactNextFace(const Crystal& crystal, const Vec3& point, const Vec3& lightDir, int leftFace);

/// How far from the plane of `face` the exact next encounter lies, crystal units: how near to its edge, where a finder
/// names a neighbour of the exact face.
double edgeDistance(const Crystal& crystal, const Vec3& point, const Vec3& lightDir, int exactFace, int face);

}  // namespace parhelion::bench
