// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/camera.h"
#include "sky/deposit_buffer.h"
#include "sky/sky_view.h"
#include "sky/tally.h"
#include "trace/bundle_bins.h"
#include "trace/film.h"
#include "trace/layered_deposits.h"

namespace parhelion {

/// Exposes tallies through a camera, one for each layer. All threads share them and add by a buffer of their own: the
/// tallies are complete once all are merged and finish() has made up for mirror images. Undeviated light lands in no
/// pixel. Totals of light are not kept here (trace/intercepted_light.h).
class SkyFilm : public Film {
 public:
  /// The tallies must outlive the film; all have the camera that is looked through. Where their symmetry is `mirror`,
  /// every ray counts as its mirror image in the sun's vertical plane, too: for clouds that are their own mirror
  /// images. `shared` is SkyTally::Shared, null for a single layer.
  SkyFilm(std::vector<Tally*> layers, Tally* shared)
      : SkyFilm(std::move(layers), shared, std::make_shared<DepositBuffer::Locks>()) {}

  int add(const TracedRays& traced) override;
  std::unique_ptr<Film> forThread() override { return std::unique_ptr<SkyFilm>(new SkyFilm(layers_, shared_, locks_)); }
  void merge(Film& fromThread) override;
  void visitSums(SumVisitor& visitor) override;
  void finish() override;
  void reopen() override;
  double fullness() const override;
  double fullnessAtMost() const override;

 private:
  /// The pixels in which an exit and its mirror image are seen.
  struct Pixels {
    int own, mirrored;  // kNowhere: not in the picture
    static constexpr int kNowhere = -1;
    static_assert(kNowhere == SeenLight::kNowhere);

    bool operator==(const Pixels&) const = default;
    int count() const { return (own != kNowhere) + (mirrored != kNowhere); }
    template <class Do>
    void forEach(const Do& act) const {
      if (own != kNowhere) act(own);
      if (mirrored != kNowhere) act(mirrored);
    }
  };

  /// Deposits what `seen_` holds. Light that is in no layers is spared their sorting. Returns how many views that were.
  template <class Deposits>
  int deposit(const TracedRays& traced, Deposits& deposits);

  SkyFilm(std::vector<Tally*> layers, Tally* shared, std::shared_ptr<DepositBuffer::Locks> locks);

  /// Through a camera that is its own mirror image, the finished picture makes up for a second view of every exit.
  bool foldsPicture() const { return mirrored_ && camera_.isMirrorSymmetric(); }
  bool showsBothViews() const { return mirrored_ && !camera_.isMirrorSymmetric(); }

  /// The tallies of all layers, and the shared one if there is one.
  template <class Do>
  void forAll(const Do& act) const {
    for (Tally* tally : layers_) act(*tally);
    if (shared_) act(*shared_);
  }

  std::vector<Tally*> layers_;
  Tally* shared_;
  bool mirrored_;
  Camera camera_;
  SkyView view_;
  std::shared_ptr<DepositBuffer::Locks> locks_;
  DepositBuffer buffer_;
  LayeredDeposits layeredDeposits_;
  BundleDeposits<FixedLight, Pixels> plainDeposits_;
  ByBundle byBundle_;
  SeenLight seen_;
  bool folded_;  // the tallies' pictures, by finish(), until reopen()
};

}  // namespace parhelion
