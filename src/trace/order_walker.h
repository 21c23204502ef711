// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "sky/fixed_point.h"
#include "sky/tally_info.h"
#include "trace/film.h"
#include "trace/many_orders.h"
#include "trace/order_ledger.h"
#include "trace/wave.h"

namespace parhelion {

/// What walks leave in pictures.
struct OrderDeposits {
  int first = 2;                            // order that is deposited, and all above it
  double scale = 1.0;                       // of what is deposited
  std::function<int(int order)> layerOf;    // of an order's light, where the film has layers; may be empty
  bool fromBelow = true, fromAbove = true;  // where the slab is seen from
};

/// The light that walks began with, as TallyInfo keeps it.
struct WalkedLight {
  LightTotal light;
  std::array<LightTotal, 3> xyz;  // over the white's

  void merge(const WalkedLight& other);
  void addTo(TallyInfo& info) const;
};

class WalkNumbers;

/// Follows sunlight from crystal to crystal through a slab, many walks at a time. For one thread.
///
/// Where light is scattered next is drawn within the slab (FlightPlaces): what would leave it counts as out, and the
/// walk weighs less by that. There a crystal is drawn in proportion to what it intercepts of light from that direction.
/// It is taken with the probability of the light's being deviated in it, and another one is drawn else: light that
/// passes undeviated goes on. Of all crystals drawn, taken or not, each deviated exit deposits what leaves the slab
/// without being scattered again, over the sine of its elevation: for each that is taken there are 1 / (1 - undeviated
/// share) on average, so that the mean is right (Wald 1944). What leaves is the mean over all places of the layer where
/// the walk might have found the crystal: from any one place either next to nothing leaves along the horizon, or a lot
/// over a small sine. The walk goes on along one exit of the crystal taken, in proportion to what is scattered again.
/// It ends by chance where little light is left.
class OrderWalker {
 public:
  /// All must outlive it.
  OrderWalker(const ManyOrders& slab, const TraceSettings& settings, const OrderDeposits& deposits, Film& film,
              const LaneSteps& steps);

  /// Walks first ... first + count - 1.
  void follow(std::uint64_t first, std::uint64_t count);

  const OrderLedger& ledger() const { return ledger_; }
  const WalkedLight& light() const { return light_; }
  const TraceCounts& counts() const;

 private:
  struct Walk {
    std::uint64_t number;
    SpectralSample light;
    double iceIndex;
    Vec3 sunlight, direction;  // unit, of light
    SlabPlace place;           // of the next crystal
    SlabWay way;               // on which that place was drawn
    double weight;
    double inLayer = 1.0, atPlace = 1.0;  // what a draw of its layer and of the place stand for (FlightPlaces)
    double importance = 1.0;              // least weight of walks around the place, over what it is elsewhere
    int order = 0;                        // deviations so far
    int step = 0;                         // crystals drawn so far
    bool ended = false;
  };

  /// Crystals of one kind, the light that leaves them, and whose they are.
  struct Group {
    RayQueue queue{1};
    std::vector<std::size_t> walks;  // by place in the queue
  };

  /// What leaves a crystal: an exit's number in the list, the share that leaves the slab, and the rest.
  struct Way {
    int exit;
    double energy, out, on;
  };

  void begin(std::uint64_t number);
  void drawCrystal(std::size_t walk);
  bool proposeCrystal(const ManyOrders::Kind& kind, std::size_t walk, WalkNumbers& numbers);
  void putLight(Group& group);
  void scatterByCrystals(int population);
  void scatterByHaze(int haze);
  void settle(Walk& walk, ExitList& exits, double absorbed, WalkNumbers& numbers);
  void deposit(const Walk& walk, ExitList& exits, const Way& way, const SlabCrossing& crossing);
  void scatter(Walk& walk, const ExitList& exits, double deviated, WalkNumbers& numbers);
  void countOut(const Walk& walk, const ExitList& exits, double light);
  void goOn(Walk& walk, const Vec3& direction, double depth, double u);

  const ManyOrders& slab_;
  const OrderDeposits& deposits_;
  Film& film_;
  const LaneSteps& steps_;
  std::uint64_t seed_;
  double least_;  // weight of a walk that may end by chance
  std::unique_ptr<Wave> wave_;
  std::vector<Walk> walks_;
  std::vector<Group> crystals_, hazes_;
  ExitList hazeExits_;
  ByBundle byBundle_;
  std::vector<Way> ways_;  // of the walk that is settled
  Vec3 perWhite_;
  WalkedLight light_;
  OrderLedger ledger_;
};

}  // namespace parhelion
