// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "render/measured_tally.h"
#include "render/run_sums.h"

namespace parhelion {

inline void readTally(const std::filesystem::path& path, MapTally& tally) { tally = readMapTally(path); }
inline void readTally(const std::filesystem::path& path, ProfileTally& tally) { tally = readProfileTally(path); }

inline Measurement measurementOf(const MapTally& tally) { return MapMeasurement{tally.sums.binsPerHalfTurn()}; }
inline Measurement measurementOf(const ProfileTally& tally) {
  return ProfileMeasurement{tally.sums.sums().size(), tally.sums.from(), tally.sums.to()};
}

/// The tally of a map or a profile as the sums of a run.
template <class Tally>
class MeasuredSums : public RunSums {
 public:
  explicit MeasuredSums(Tally empty) : empty_(std::move(empty)), tally_(empty_) {}

  Film& film() override { return tally_.sums; }
  Measurement measurement() const override { return measurementOf(tally_); }
  TallyOrigin& origin() override { return tally_.origin; }
  TallyKind kind() const override { return kindOf(tally_); }
  void read(const std::filesystem::path& path) override {
    Tally held = empty_, sum = empty_;
    readTally(path, held);
    try {
      mergeTally(sum, held);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(path.string() + " is of another run: " + error.what());
    }
    tally_ = std::move(sum);
  }
  void write(const Output& file) const override { writeTally(file, tally_); }
  std::unique_ptr<RunSums> empty() const override { return std::make_unique<MeasuredSums>(empty_); }
  void subtract(RunSums& other) override { subtractTally(tally_, dynamic_cast<MeasuredSums&>(other).tally_); }

  const Tally& tally() const { return tally_; }

 private:
  Tally empty_, tally_;
};

}  // namespace parhelion
