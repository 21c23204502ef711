// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "math/exact_sum.h"
#include "math/random.h"
#include "trace/crystal_optics.h"
#include "trace/exit_list.h"
#include "trace/incidence.h"
#include "trace/path_record.h"
#include "trace/path_rule.h"
#include "trace/ray_pool.h"
#include "trace/ray_queue.h"
#include "trace/slab_table.h"
#include "trace/trace_settings.h"

namespace parhelion {

struct SkyView;

/// Bundles of rays whose start is to be drawn, and how it went.
struct Proposals {
  const std::uint64_t* bundle;
  int count;                // at most IncidenceNumbers::kRoom
  std::uint64_t* rejected;  // room for count + RayQueue::kSpare
  int rejectedCount;        // grows
};

/// Sums over exits and lost paths, in units of which `perLight` make the light of one ray. A ray may bring up to 2^51
/// of them.
struct EnergyUnits {
  double perLight = ExactSum::kScale;
  ExactSum::Units out = 0, lost = 0;
  int lostPaths = 0;
};

/// Exits in pixels of a picture, as arrays with room for all there are and RayQueue::kSpare more.
struct SeenLight {
  static constexpr double kNowhere = -1.0;

  int count = 0;
  AlignedVector<double> exit, ray;      // index into the list of exits, and RayQueue::ray()
  AlignedVector<double> pixel;          // row-major
  AlignedVector<double> mirroredPixel;  // of the mirror image; where that is asked for, one of the two may be kNowhere
};

/// Steps by what is kept of paths, of ideal crystals and of others.
template <class Step>
struct ByPath {
  std::array<Step, kPathRecords> ideal, real;

  Step of(PathRecord record, const CrystalOptics& optics) const {
    return (optics.isIdeal() ? ideal : real)[static_cast<std::size_t>(record)];
  }
};

/// The steps that are taken by many rays at a time, compiled once for each set of vector registers.
struct LaneSteps {
  int lanes;  // doubles side by side

  // How light comes to crystals: lane_incidence.h.

  /// Philox numbers from `firstBlock` on, two a block, into `blocks` pairs of rows.
  void (*draw)(std::uint64_t seed, RandomPurpose purpose, const std::uint64_t* bundle, int count,
               std::uint32_t firstBlock, int blocks, IncidenceNumbers& numbers);

  /// Crystals, light and entry points from numbers; the rays taken go to the queue's end.
  void (*propose)(const IncidenceTable& table, const IncidenceNumbers& numbers, Proposals& proposals, RayQueue& queue);

  // How it gets through them: lane_paths.h.

  /// The outside of the entry faces for all rays of a member of the bundles.
  using Enter = void (*)(const FaceTable& faces, const CrystalOptics& optics, const PathTable& paths,
                         std::uint64_t seed, PathRule rule, int member, RayQueue& queue, ExitList& exits,
                         EnergyUnits& energy);
  ByPath<Enter> enter;

  /// The next face of each ray in the pool, by planes.
  void (*findFaces)(const SlabTable& slabs, RayPool& pool);

  /// How far it is to the faces that are named as next; takes the name back where the ray does not run toward its face.
  void (*measureFaces)(const FaceTable& faces, RayPool& pool);

  /// What the faces found make of the light.
  using MeetFaces = void (*)(const FaceTable& faces, const CrystalOptics& optics, const PathTable& paths, RayPool& pool,
                             ExitList& exits, EnergyUnits& energy);
  ByPath<MeetFaces> meetFaces;

  // What becomes of the light that leaves: lane_exits.h.

  /// World directions of the exits, and whether light goes on as if there were no crystal.
  void (*turnToWorld)(const RayQueue& queue, ExitList& exits);

  /// The exits that the observer sees, without undeviated light. With `bothViews` they are those of which he sees the
  /// exit itself, or its mirror image in the sun's vertical plane, or both.
  void (*see)(const SkyView& view, bool bothViews, const ExitList& exits, SeenLight& seen);
};

/// The steps for the machine's widest registers, or for those named. Throws std::invalid_argument where the machine
/// does not have them.
const LaneSteps& laneSteps(Simd simd = Simd::automatic);

/// What this machine has of baseline, avx2, avx512.
std::vector<Simd> simdHere();

}  // namespace parhelion
