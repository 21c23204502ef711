// SPDX-License-Identifier: Apache-2.0
#include "render/ranks/rank_task.h"

#include <limits>
#include <sstream>
#include <stdexcept>

#include "math/overloaded.h"
#include "trace/numerics.h"

namespace parhelion {

std::string textOf(const RankTask& task) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  text << kNumericsVersion << ' ' << task.threads << ' ' << static_cast<int>(task.simd) << ' '
       << task.measurement.index();
  std::visit(
      Overloaded{[](const SkyMeasurement&) {}, [&](const MapMeasurement& map) { text << ' ' << map.binsPerHalfTurn; },
                 [&](const ProfileMeasurement& profile) {
                   text << ' ' << profile.bins << ' ' << profile.from << ' ' << profile.to;
                 }},
      task.measurement);
  text << '\n' << task.scene;
  return text.str();
}

RankTask taskFromText(const std::string& text) {
  std::istringstream words(text);
  words.imbue(std::locale::classic());
  RankTask task;
  int numerics = 0, simd = 0;
  std::size_t kind = 0;
  words >> numerics >> task.threads >> simd >> kind;
  if (numerics != kNumericsVersion)
    throw std::runtime_error("its program has numerics " + std::to_string(kNumericsVersion) + ", that of rank 0 " +
                             std::to_string(numerics) + ": all ranks need the same version");
  task.simd = static_cast<Simd>(simd);
  if (kind == 1) words >> task.measurement.emplace<MapMeasurement>().binsPerHalfTurn;
  if (kind == 2) {
    auto& profile = task.measurement.emplace<ProfileMeasurement>();
    words >> profile.bins >> profile.from >> profile.to;
  }
  task.scene = text.substr(text.find('\n') + 1);
  return task;
}

}  // namespace parhelion
