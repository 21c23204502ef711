// SPDX-License-Identifier: Apache-2.0
#include "cli/text_output.h"

#include <cmath>

#include "math/conventions.h"
#include "picture/atomic_file.h"

namespace parhelion::cli {

double tableDegrees(double radians) { return std::round(degrees(radians) * 1e9) / 1e9; }

void writeText(const Output& output, std::string_view text) {
  AtomicFile file(output);
  file.write(text);
  file.commit();
}

}  // namespace parhelion::cli
