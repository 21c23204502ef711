// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sky/tally.h"

namespace parhelion {

/// The layer of what is in no layer that has a name.
inline constexpr std::string_view kRestLayer = "rest";

/// The tally of a sky in parts, each of which is reconstructed by itself, with its own noise: by layers of light, and
/// by what a ray counts for, which depends on the symmetry of its population. All parts have the same rays, and the
/// intercepted light of all populations.
///
/// Layers are exact: their sums, with `shared` of each symmetry, are to the bit what one tally without layers has.
class SkyTally {
 public:
  struct Part {
    std::string layer;  // empty if there are no layers
    Tally tally;        // its info says what its rays count for
  };

  /// Where a bundle of rays brought light of several layers to one place, what the sum of squares and the hits of a
  /// tally without layers differ by: squares to be added (Tally::kSquares), and hits that are one (Tally::kHits), to be
  /// taken away. All else is 0. Of the symmetry of the same place in the list of symmetries.
  using Shared = Tally;

  /// An empty tally; `info` is that of its parts but for the symmetry. `layers` are names, to which kRestLayer is added
  /// if there are any. Throws as Tally does, and std::invalid_argument without symmetries or where one is there twice.
  SkyTally(TallyInfo info, int colours, std::vector<TallySymmetry> symmetries,
           const std::vector<std::string>& layers = {});

  /// Of one part.
  explicit SkyTally(Tally whole);

  /// By layer, and in each by symmetry.
  const std::vector<Part>& parts() const { return parts_; }
  std::vector<Part>& parts() { return parts_; }
  Tally& part(std::size_t layer, std::size_t symmetry) { return parts_[layer * symmetries_.size() + symmetry].tally; }

  /// Empty if there are no layers.
  const std::vector<Shared>& shared() const { return shared_; }
  std::vector<Shared>& shared() { return shared_; }

  /// Names, the rest last; empty if there are none.
  const std::vector<std::string>& layers() const { return layers_; }
  const std::vector<TallySymmetry>& symmetries() const { return symmetries_; }

  /// What holds for all parts: rays, scene, camera. Totals of light are those of the first part's images.
  const TallyInfo& info() const { return parts_.front().tally.info; }

  /// The same to be changed; what is changed reaches the other parts by shareOrigin().
  TallyInfo& info() { return parts_.front().tally.info; }
  void shareOrigin();

  int width() const { return parts_.front().tally.width(); }
  int height() const { return parts_.front().tally.height(); }
  int pixels() const { return parts_.front().tally.pixels(); }
  int colours() const { return parts_.front().tally.colours(); }

  /// All light of one symmetry, as if there were no layers.
  Tally withoutLayers(std::size_t symmetry) const;

  /// All light in one plain tally, for those who look at hits and light as they are: exact, and what each ray counts
  /// for is what it counts for in the part where it counts most.
  Tally flattened() const;

  /// How full the fullest of all sums is.
  double fullness() const;

  // As the functions of Tally.
  void merge(const SkyTally& other);
  void addSums(const SkyTally& other);
  void spreadRings();
  void subtract(const SkyTally& other);
  bool operator==(const SkyTally& other) const;

 private:
  /// Throws std::invalid_argument unless the parts of another are the same.
  void requireSameParts(const SkyTally& other) const;

  /// All tallies, those of shared() last.
  std::vector<Tally*> all();
  std::vector<const Tally*> all() const;

  std::vector<std::string> layers_;
  std::vector<TallySymmetry> symmetries_;
  std::vector<Part> parts_;
  std::vector<Shared> shared_;
};

}  // namespace parhelion
