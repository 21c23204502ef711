// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "scene/parse_scene.h"
#include "trace/trace.h"

namespace parhelion {

/// What a picture of rays alone is likely to take.
struct RaysForecast {
  double rays;     // for the error asked for, be it more than the scene has
  double seconds;  // of one thread, by factors that were measured on one machine (beam/tilt_mesh.h)
};

/// By the first few hundred thousand rays of the scene, as many on any machine, or by less of them where these are
/// enough to see that all will take more than `most` seconds, or less. None where the control stops them.
std::optional<RaysForecast> forecastRays(const LoadedScene& loaded, double error, const TraceControl& control,
                                         double most = std::numeric_limits<double>::infinity());

/// Chooses between the integral and rays, while the integral is under way: before each of its meshes the rest of its
/// work is held against the forecast of rays. Those are looked at only if the integral takes longer than two looks. A
/// function of the scene and the error, not of the machine.
class EngineChoice {
 public:
  /// Both must outlive it.
  EngineChoice(const LoadedScene& loaded, double error, const TraceControl& control);

  /// Whether the integral is to go on, with so much work left (SkyAccuracy).
  bool goOn(double work);

  /// What the integral has taken and what was left when it was asked last, by the forecast: seconds of one thread.
  double integral() const { return integral_; }
  /// What rays would, for as much of the picture; for all of it where they are quicker even so. None if they were not
  /// looked at.
  std::optional<double> rays() const { return rays_; }

 private:
  double look() const;

  const LoadedScene& loaded_;
  double error_;
  const TraceControl& control_;
  double spent_ = 0.0, integral_ = 0.0;
  std::optional<double> rays_;
};

}  // namespace parhelion
