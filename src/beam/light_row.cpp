// SPDX-License-Identifier: Apache-2.0
#include "beam/light_row.h"

#include <algorithm>

#include "beam/wanted_tracer.h"

namespace parhelion {

namespace {

// Classes with less than this share of a row's light are left out.
constexpr double kFaintest = 1e-9;

}  // namespace

LightRow::LightRow(const TracedPrisms& of, std::span<const RowDirection> directions, std::size_t room)
    : room_(room), slot_(kLightClasses, -1), totals_(of.indices.size()) {
  const std::size_t indices = of.indices.size();
  PrismLight light;
  for (const PrismShare& prism : of.prisms) {
    const double share = prism.share / of.section.surface(prism.length);
    for (std::size_t n = 0; n < indices; ++n) {
      WantedTracer tracer(of.section, prism.length, of.indices[n], of.cutShare, false, of.wanted);
      for (std::size_t column = 0; column < directions.size(); ++column) {
        const RowDirection& at = directions[column];
        traceAt(tracer, at.phi, at.zeta, at.towards, light);
        const double mean = share * at.weight;
        for (std::size_t e = 0; e < kPrismFaces; ++e) {
          totals_[n].intercepted += mean * light.shadow[e];
          totals_[n].cutOff += mean * light.shadow[e] * (1.0 - light.reflectance[e]) * light.cutOff[e];
        }
        forEachClass(light, [&](int number, double met) {
          short& slot = slot_[static_cast<std::size_t>(number)];
          if (slot < 0) {
            slot = static_cast<short>(light_.size() / (indices * room_));
            light_.resize(light_.size() + indices * room_);
          }
          light_[(static_cast<std::size_t>(slot) * indices + n) * room_ + column] += static_cast<float>(share * met);
        });
      }
    }
  }
  findClasses();
}

void LightRow::findClasses() {
  std::vector<double> light(kLightClasses, 0.0);
  const std::size_t size = totals_.size() * room_;
  for (std::size_t number = 0; number < light.size(); ++number) {
    if (slot_[number] < 0) continue;
    const float* from = light_.data() + static_cast<std::size_t>(slot_[number]) * size;
    for (std::size_t k = 0; k < size; ++k) light[number] += static_cast<double>(from[k]);
    met_ += light[number];
  }
  for (std::size_t number = 0; number < light.size(); ++number)
    if (light[number] > kFaintest * met_) classes_.push_back(static_cast<int>(number));
}

double LightRow::intercepted() const {
  double sum = 0.0;
  for (const Totals& totals : totals_) sum += totals.intercepted;
  return sum;
}

LightRow::Totals LightRow::totals(const std::vector<double>& parts) const {
  Totals sum;
  for (std::size_t n = 0; n < parts.size(); ++n) {
    sum.intercepted += parts[n] * totals_[n].intercepted;
    sum.cutOff += parts[n] * totals_[n].cutOff;
  }
  return sum;
}

std::vector<int> classesOf(std::span<const LightRow> rows) {
  std::vector<int> all;
  for (const LightRow& row : rows) all.insert(all.end(), row.classes().begin(), row.classes().end());
  std::ranges::sort(all);
  all.erase(std::ranges::unique(all).begin(), all.end());
  return all;
}

}  // namespace parhelion
