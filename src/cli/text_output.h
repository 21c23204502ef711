// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "picture/transaction.h"

namespace parhelion::cli {

/// Degrees for a table, without the last bits that come from going through radians.
double tableDegrees(double radians);

/// Writes a whole file (AtomicFile). Throws std::runtime_error with the path and the reason.
void writeText(const Output& output, std::string_view text);

}  // namespace parhelion::cli
