// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "math/number_text.h"
#include "scene/parse_scene.h"

namespace parhelion {

std::uint64_t parseRayCount(std::string_view text) {
  const std::string expected = std::string("a whole number of rays from 1 to ").append(std::to_string(kMaxRays)) +
                               ", such as 100000, 2e6, \"1.5k\" or \"10M\"";

  // The suffix becomes an exponent, so that "2.3M" is rounded once, to exactly 2300000.
  std::string number(text);
  constexpr std::string_view kSuffixes = "kKmMgGtT";
  const std::size_t suffix = number.empty() ? std::string_view::npos : kSuffixes.find(number.back());
  if (suffix != std::string_view::npos)
    number.replace(number.size() - 1, 1, std::string("e").append(std::to_string(3 * (suffix / 2 + 1))));

  const bool plain = !number.starts_with('+');  // as the schema has it
  const std::optional<double> rays = plain ? numberIn(number) : std::nullopt;
  if (!rays || !(*rays >= 1.0 && *rays <= static_cast<double>(kMaxRays)) || *rays != std::floor(*rays)) {
    throw std::invalid_argument(expected);
  }
  return static_cast<std::uint64_t>(*rays);
}

}  // namespace parhelion
