// SPDX-License-Identifier: Apache-2.0
#include "recon/published/filter_size.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "math/portable.h"

namespace parhelion {

double sizeByHits(const HitMap& map, const SizeRule& rule) {
  double hits = 0.0, pixels = 0.0;
  for (std::size_t i = 0; i < map.omega.size(); ++i) {
    hits += map.hits()[i];
    pixels += map.omega[i] > 0.0 ? 1.0 : 0.0;
  }
  const double decline = portable::exp(-rule.exponent * portable::log(std::max(hits, 1.0)));
  return std::max(rule.factor * std::sqrt(pixels) * decline, rule.least);
}

std::string sizeRemark(const std::string& name, double pixels) {
  std::ostringstream text;
  text.precision(3);
  text << name << ' ' << pixels << " px";
  return text.str();
}

}  // namespace parhelion
