// SPDX-License-Identifier: Apache-2.0
#include "cli/stats.h"

#include <cmath>
#include <thread>

#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include "cli/progress.h"
#include "cli/say.h"
#include "cli/text_output.h"
#include "math/names.h"

namespace parhelion::cli {

namespace {

double seconds(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

}  // namespace

void printLedger(const TraceReport& report, bool timeIsOver) {
  const EnergyLedger& energy = report.energy;
  const double in = energy.in.value(), per = in > 0.0 ? 1.0 / in : 0.0;
  const double rays = static_cast<double>(report.rays);
  const Readable count = readable(rays), speed = readable(report.seconds > 0.0 ? rays / report.seconds : 0.0);
  if (report.rays == 0) return say("no rays were traced");
  say("%.6g%s rays in %.2f s, %.3g%s rays/s, %.2f hits and %.2f deposits a ray", count.value, count.suffix,
      report.seconds, speed.value, speed.suffix, static_cast<double>(report.hits) / rays,
      static_cast<double>(report.deposits) / rays);
  if (report.interrupted)
    say(timeIsOver ? "the time is over: not all rays were traced" : "interrupted: stopped before all rays were traced");
  char filtered[40] = "";
  if (energy.filtered.units() != 0)
    std::snprintf(filtered, sizeof filtered, " + filtered %.9f", energy.filtered.value() * per);
  say("energy: in 1 = out %.9f%s + absorbed %g + cut off %.3g + lost %.3g, open by %.1e", energy.out.value() * per,
      filtered, energy.absorbed.value() * per, energy.cutOff.value() * per, energy.lost.value() * per,
      std::abs(energy.imbalance()));
}

nlohmann::ordered_json statsJson(const RunFigures& figures) {
  const auto& [settings, report, threads, cpuSeconds] = figures;
  const double rays = static_cast<double>(report.rays);
  nlohmann::ordered_json json;
  json["rays"] = report.rays;
  json["hits"] = report.hits;
  json["deposits"] = report.deposits;
  json["rescued_hits"] = report.rescued;
  json["mean_chain_length"] = rays > 0.0 ? static_cast<double>(report.hits) / rays : 0.0;
  json["seconds"] = report.seconds;
  json["cpu_seconds"] = cpuSeconds;
  json["rays_per_second"] = report.seconds > 0.0 ? rays / report.seconds : 0.0;
  json["deposits_placed"] = report.placed;
  json["engine"] = nameOf(settings.engine);
  json["path"] = nameOf(settings.path);
  json["sampler"] = nameOf(settings.sampler);
  json["symmetry"] = nameOf(settings.symmetry);
  json["simd_lanes"] = report.simdLanes;
  json["seed"] = settings.seed;
  json["threads"] = threadCount(threads);
  json["peak_memory_bytes"] = processUsage().peakMemory;
  json["energy"] = {{"in", report.energy.in.value()},
                    {"out", report.energy.out.value()},
                    {"filtered", report.energy.filtered.value()},
                    {"absorbed", report.energy.absorbed.value()},
                    {"cut_off", report.energy.cutOff.value()},
                    {"lost", report.energy.lost.value()}};
  json["interrupted"] = report.interrupted;
  return json;
}

nlohmann::ordered_json ordersJson(const OrderReport& report) {
  const OrderLedger& energy = report.energy;
  const double in = energy.in.value(), per = in > 0.0 ? 1.0 / in : 0.0;
  const auto row = [&](std::size_t place) {
    return nlohmann::ordered_json{{"above", energy.above[place].value() * per},
                                  {"below", energy.below[place].value() * per}};
  };
  nlohmann::ordered_json json;
  json["walks"] = report.walks;
  json["interrupted"] = report.interrupted;
  json["hits"] = report.hits;
  json["seconds"] = report.seconds;
  json["direct"] = energy.direct.value() * per;
  json["by_order"] = nlohmann::ordered_json::array();
  std::size_t last = OrderLedger::kTold;
  while (last > 0 && energy.above[last - 1].units() == 0 && energy.below[last - 1].units() == 0) --last;
  for (std::size_t place = 0; place < last; ++place) json["by_order"].push_back(row(place));
  json["higher_orders"] = row(OrderLedger::kTold);
  json["absorbed"] = energy.absorbed.value() * per;
  json["left_out"] = energy.leftOut.value() * per;
  json["cut_off"] = energy.cutOff.value() * per;
  json["imbalance"] = energy.imbalance();
  return json;
}

void printOrders(const OrderReport& report) {
  const OrderLedger& energy = report.energy;
  const double per = energy.in.value() > 0.0 ? 1.0 / energy.in.value() : 0.0;
  const Readable count = readable(static_cast<double>(report.walks));
  say("%.4g%s walks through the cloud in %.2f s%s: out above %.4f, below %.4f, of it direct %.4f, left out %.2g, open "
      "by "
      "%.1e",
      count.value, count.suffix, report.seconds, report.interrupted ? ", stopped before all were done" : "",
      energy.reflected(), energy.transmitted(), energy.direct.value() * per, energy.leftOut.value() * per,
      std::abs(energy.imbalance()));
}

ProcessUsage processUsage() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return {seconds(usage.ru_utime) + seconds(usage.ru_stime), static_cast<std::uint64_t>(usage.ru_maxrss) * 1024};
}

int threadCount(int asked) { return asked > 0 ? asked : static_cast<int>(std::thread::hardware_concurrency()); }

void writeJson(const Output& output, const nlohmann::ordered_json& json) { writeText(output, json.dump(2) + "\n"); }

}  // namespace parhelion::cli
