// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <type_traits>
#include <utility>

#include "render/measured_tally.h"
#include "render/run_sums.h"

namespace parhelion {

template <class Tally>
Tally readTally(const std::filesystem::path& path) {
  if constexpr (std::is_same_v<Tally, MapTally>)
    return readMapTally(path);
  else
    return readProfileTally(path);
}

inline Measurement measurementOf(const MapTally& tally) { return MapMeasurement{tally.sums.binsPerHalfTurn()}; }
inline Measurement measurementOf(const ProfileTally& tally) {
  return ProfileMeasurement{tally.sums.sums().size(), tally.sums.from(), tally.sums.to()};
}

/// The tally of a map or a profile as the sums of a run.
template <class Tally>
class MeasuredSums : public RunSums {
 public:
  /// `makeEmpty` makes the tally of a run before its first ray. What it refers to must outlive this.
  explicit MeasuredSums(std::function<Tally()> makeEmpty) : makeEmpty_(std::move(makeEmpty)), tally_(makeEmpty_()) {}

  Film& film() override { return tally_.sums; }
  Measurement measurement() const override { return measurementOf(tally_); }
  TallyOrigin& origin() override { return tally_.origin; }
  TallyKind kind() const override { return kindOf(tally_); }
  void read(const std::filesystem::path& path) override {
    tally_ = makeEmpty_();
    const Tally held = readTally<Tally>(path);
    try {
      mergeTally(tally_, held);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(path.string() + " is of another run: " + error.what());
    }
  }
  void write(const Output& file) const override { writeTally(file, tally_); }
  std::unique_ptr<RunSums> empty() const override { return std::make_unique<MeasuredSums>(makeEmpty_); }
  void subtract(RunSums& other) override { subtractTally(tally_, dynamic_cast<MeasuredSums&>(other).tally_); }

  const Tally& tally() const { return tally_; }

 private:
  std::function<Tally()> makeEmpty_;
  Tally tally_;
};

}  // namespace parhelion
