// SPDX-License-Identifier: Apache-2.0
#include "recon_summary.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>

#include "csv.h"
#include "recon_scenes.h"

namespace parhelion::bench {
namespace {

Summary meanOf(const std::vector<Trial>& trials, const Contender& contender, std::uint64_t rays) {
  Summary sum{.scene = {}, .contender = &contender, .rays = rays, .timing = {}};
  int count = 0;
  for (const Trial& trial : trials) {
    if (trial.contender != &contender || trial.rays != rays) continue;
    ++count;
    sum.relMse += trial.error.relMse;
    sum.logMse += trial.error.logMse;
    sum.ssim += trial.error.ssim;
    sum.energyError += std::abs(trial.error.energyError);
    // The least disturbed one.
    if (count == 1 || trial.timing.seconds < sum.timing.seconds) sum.timing = trial.timing;
  }
  for (double* value : {&sum.relMse, &sum.logMse, &sum.ssim, &sum.energyError}) *value /= count;
  return sum;
}

std::string formatted(const char* format, double value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// Three digits, without an exponent.
std::string threeDigits(double value) {
  if (!(value > 0.0)) return "0";
  const int decimals = 2 - static_cast<int>(std::floor(std::log10(value)));
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", std::max(decimals, 0), value);
  return text;
}

std::string power(std::uint64_t rays) {
  static constexpr const char* kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  return std::string("10") + kDigits[static_cast<int>(std::lround(std::log10(static_cast<double>(rays))))];
}

/// One row a method: relMSE and seconds of the reconstruction for each number of rays.
void writeTable(std::ofstream& out, const Plan& plan, const std::vector<Summary>& summaries, const BenchScene& scene) {
  const std::vector<std::uint64_t> counts = plan.rayCounts();
  out << "\n| method |";
  for (const std::uint64_t rays : counts) out << " relMSE at " << power(rays) << " |";
  for (const std::uint64_t rays : counts) out << " s at " << power(rays) << " |";
  out << "\n|---|";
  for (std::size_t i = 0; i < 2 * counts.size(); ++i) out << "---|";
  for (const Contender& contender : contenders()) {
    std::string errors, seconds;
    for (const Summary& s : summaries) {
      if (s.scene != scene.name || s.contender != &contender) continue;
      errors += " " + threeDigits(s.relMse) + " |";
      seconds += " " + formatted("%.2f", s.timing.seconds) + " |";
    }
    out << "\n| " << contender.label << " |" << errors << seconds;
  }
  out << "\n";
}

}  // namespace

std::vector<Summary> summarise(const std::string& scene, const std::vector<Trial>& trials,
                               const std::vector<std::uint64_t>& rayCounts, double tracingSpeed) {
  std::vector<Summary> all;
  for (const Contender& contender : contenders()) {
    for (const std::uint64_t rays : rayCounts) {
      Summary& s = all.emplace_back(meanOf(trials, contender, rays));
      s.scene = scene;
      s.tracingSeconds = static_cast<double>(rays) / tracingSpeed;
      const double plain = meanOf(trials, contenders().front(), rays).relMse;
      // The error of a method may come out below what the reference can tell from 0.
      s.raysSaved = s.relMse > 0.0 ? plain / s.relMse : std::numeric_limits<double>::quiet_NaN();
    }
  }
  return all;
}

void writeSummaries(const Plan& plan, const std::vector<Summary>& summaries) {
  Csv csv(plan.results / "recon_summary.csv",
          "Means over tallies, of the seconds the least. tracing_seconds: of the rays. rays_saved: how many times as "
          "many rays the plain\n"
          "radiance needs for the same relMSE.",
          "scene,rays,method,label,relMSE,logMSE,SSIM,energy_error,seconds,cpu_seconds,tracing_seconds,rays_saved");
  for (const Summary& s : summaries)
    csv.row(s.scene, s.rays, s.contender->id, s.contender->label, s.relMse, s.logMse, s.ssim, s.energyError,
            s.timing.seconds, s.timing.cpuSeconds, s.tracingSeconds, s.raysSaved);

  std::ofstream table(plan.results / "recon_table.md");
  table << "Measured with " << machine() << ".\n";
  writeTable(table, plan, summaries, benchScenes(plan).front());
}

}  // namespace parhelion::bench
