// SPDX-License-Identifier: Apache-2.0
#include "render/engine_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "render/development.h"
#include "render/mixed_sky.h"
#include "render/needs.h"
#include "render/sky_sums.h"
#include "render/traced_sky.h"
#include "render/tracing_run.h"
#include "trace/tracer.h"

namespace parhelion {

namespace {

// A forecast's rays, and how much less error more of them have: as a power of their number, within these bounds; as is
// usual where there is but one number of them.
constexpr std::array<std::uint64_t, 2> kLooks{100'000, 400'000};
constexpr double kLeastPower = 0.2, kUsualPower = 0.33, kMostPower = 0.5;
// By the least power rays take less than this share of what they are asked for: there is no need for a second look.
constexpr double kClear = 0.5;
// Seconds of a ray; of a pixel to be reconstructed in colours, of one tally: plain, by our method, by one of others.
constexpr double kRay = 0.28e-6, kPlain = 0.3e-6, kAdaptive = 2.6e-6, kOther = 4e-6, kGrey = 0.65;
// Rays that the scene does not have enough of for the error are so much dearer.
constexpr double kMissing = 2.0;
// An integral that takes less than so many looks is made without one: rays would have to be traced after it.
constexpr double kWorthLooking = 2.0;
// The integral errs by so much of what is asked for: meshes come by steps.
constexpr double kOfGoal = 0.7;

double secondsToDevelop(const Scene& scene) {
  const SkySize size = skySizeOf(scene);
  const ReconSettings& recon = scene.recon;
  const double pixel = std::holds_alternative<NoSettings>(recon)         ? kPlain
                       : std::holds_alternative<AdaptiveSettings>(recon) ? kAdaptive
                                                                         : kOther;
  return pixel * (size.colours ? 1.0 : kGrey) * static_cast<double>(size.pixels) * size.tallies;
}

/// How often the error is measured on the way to so many rays, if it falls as this power of them: checks are left out
/// until it might have fallen enough as one over the rays (traceRun()).
double looksUntil(double rays, double power) {
  std::uint64_t at = 0;
  double possible = 0.0;
  int looks = 0;
  do {
    do at = nextErrorCheck(at, 1);
    while (static_cast<double>(at) < std::min(possible, rays));
    ++looks;
    const auto held = static_cast<double>(at);
    possible = held * std::pow(rays / held, power);
  } while (static_cast<double>(at) < rays && looks < 60);
  return looks;
}

}  // namespace

std::optional<RaysForecast> forecastRays(const LoadedScene& loaded, double error, const TraceControl& control,
                                         double most) {
  const Cloud cloud = cloudOf(loaded.scene);
  const TraceSettings settings = chosenSettings(cloud, loaded.scene.trace);
  SkySums sums(loaded, cloud);
  Development picture(sums, loaded, control.threads);
  RunControl quiet;
  quiet.threads = control.threads;
  quiet.simd = control.simd;
  quiet.stop = control.stop;
  Tracer tracer(cloud, settings, sums.film(), control.threads, control.simd);
  double rays = 0.0, last = 0.0, power = kUsualPower;
  std::uint64_t traced = 0;
  const auto forecast = [&](double fall) {
    const double all = last > error ? rays * std::pow(last / error, 1.0 / fall) : rays;
    const double seconds = kRay * all + secondsToDevelop(loaded.scene) * looksUntil(all, fall);
    return RaysForecast{all, all > static_cast<double>(settings.rays) ? kMissing * seconds : seconds};
  };
  for (const std::uint64_t look : kLooks) {
    const std::uint64_t next = std::min(look / cloud.bundleSize() * cloud.bundleSize(), settings.rays);
    if (next <= traced) break;
    traceRun(tracer, sums.film(), sums.origin().rays, {{traced, next - traced}}, cloud.bundleSize(), quiet);
    const std::optional<double> own = picture.error(control.stop);
    if (!own) return {};
    if (last > *own)
      power = std::clamp(std::log(last / *own) / std::log(static_cast<double>(next) / rays), kLeastPower, kMostPower);
    rays = static_cast<double>(traced = next);
    last = *own;
    if (last <= error || forecast(kMostPower).seconds > most) break;
    if (std::isfinite(most) && forecast(kLeastPower).seconds < kClear * most) break;
  }
  return forecast(power);
}

EngineChoice::EngineChoice(const LoadedScene& loaded, double error, const TraceControl& control)
    : loaded_(loaded), error_(error), control_(control) {}

bool EngineChoice::goOn(double work) {
  integral_ = spent_ + work;
  if (!rays_ && integral_ > kWorthLooking * look()) {
    LoadedScene all = loaded_;
    all.scene.trace.engine = Engine::automatic;
    const std::optional<RaysForecast> whole = forecastRays(all, error_, control_, integral_);
    rays_ = whole ? whole->seconds : 0.0;
    // Some take rays in any case; what the integral leaves of the error is theirs. That matters but where rays for all
    // take longer.
    if (const std::optional<LoadedScene> rest = onlyTraced(loaded_); whole && rest && whole->seconds >= integral_) {
      const double share = tracedShareOf(loaded_.scene);
      if (const auto forecast = forecastRays(*rest, error_ * (kOfGoal + (1.0 - kOfGoal) / share), control_))
        rays_ = std::max(whole->seconds - forecast->seconds, 0.0);
    }
  }
  if (rays_ && integral_ > *rays_) return false;
  spent_ += work;
  return true;
}

double EngineChoice::look() const {
  const double one =
      secondsToDevelop(loaded_.scene) * static_cast<double>(kLooks.size()) + kRay * static_cast<double>(kLooks.back());
  return onlyTraced(loaded_) ? 2.0 * one : one;
}

}  // namespace parhelion
