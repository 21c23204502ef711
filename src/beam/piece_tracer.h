// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "beam/prism_light.h"
#include "beam/prism_section.h"
#include "beam/wanted_paths.h"
#include "crystal/raypath/path_code.h"

namespace parhelion {

/// Light that meets a face from inside, told apart by all that it met before.
struct LightChain {
  PrismClass of;
  double light;           // in the units of shadows
  int state;              // of WantedPaths
  PathCode::Words faces;  // from the first on, so many
  int count;
};

/// Chains of one direction, and by what numbers they know faces.
struct LightChains {
  std::array<int, kPrismFaces> numberOf;
  std::vector<LightChain> all;
};

/// Follows light of one direction through a prism face by face, as far as it may take a path that is wanted.
///
/// Light that met the same faces is a beam with a polygon for its cross-section. Where its parts go to different faces
/// it is cut. That takes longer than a PrismTracer's strips, in which lengths between the ends are all one, but it
/// tells which faces were met in which order. Of short paths few pieces are made, and none is given up.
class PieceTracer {
 public:
  /// As PrismTracer has them. `wanted` must outlive this.
  PieceTracer(const PrismSection& section, double length, double index, double cutShare, bool detailed,
              const WantedPaths& wanted);

  /// Makes `arrived`, `cutOff` and, if detailed, `byOrder` of light whose shadows and reflectances are known those of
  /// the light that is wanted.
  /// `chains`: the same light is added to them, too.
  void trace(const Vec3& lightDir, PrismLight& light, LightChains* chains = nullptr);

 private:
  static constexpr int kMostCorners = 24;

  /// A place on a face, and the ways from there to the planes of the faces that light runs to.
  struct Corner {
    Vec3 at;
    std::array<double, 4> way;
  };
  /// What light of a piece has in common.
  struct Beam {
    Vec3 direction;
    double share;   // of the light that entered
    double weight;  // what reflections have left of a unit of it
    int element, state, met;
    PathCode::Words faces;  // where chains are told
  };
  /// Its corners lie on the face that it is about to leave.
  struct Piece : Beam {
    std::array<Corner, kMostCorners> corners;
    int count = 0;

    /// Of corners no more are copied than there are.
    void take(const Piece& other) {
      static_cast<Beam&>(*this) = other;
      count = other.count;
      std::copy_n(other.corners.begin(), count, corners.begin());
    }
  };
  /// Faces that light runs to: three sides at most, and an end.
  struct Ahead {
    std::array<int, 4> face;
    std::array<double, 4> cosine;
    int count;
  };

  void begin(int entry, const Vec3& inside);
  void step();
  bool cutTo(const Ahead& ahead, int which);
  void meet(const Ahead& ahead, int which);
  void followMiddle();
  bool goesOnFrom(Beam& beam, int face, double cosine);
  Ahead aheadOf(const Vec3& direction) const;
  double wayTo(int face, double cosine, const Vec3& at) const;
  double across(const Piece& piece) const;

  PrismSection section_;
  double length_, cutShare_;
  RelativeIndex into_, outOf_;  // ice
  bool detailed_;
  const WantedPaths& wanted_;
  PathCode code_{kPrismFaces};
  std::vector<Piece> stack_;
  std::size_t waiting_ = 0;  // on the stack
  Piece from_, part_;        // that are being worked on
  std::array<Corner, kMostCorners> kept_;
  // Of the entry that is being followed.
  PrismLight::Arrivals* arrived_ = nullptr;
  double* cutOff_ = nullptr;
  int entry_ = 0;
  PrismLight* told_ = nullptr;
  LightChains* chains_ = nullptr;
  double goesIn_ = 0.0;  // light, in the units of shadows
  double smallest_ = 0.0, perAcross_ = 0.0;
};

}  // namespace parhelion
