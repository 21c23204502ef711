// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "cli/photo_options.h"
#include "cli/view_input.h"
#include "cli/view_options.h"
#include "picture/transaction.h"

namespace parhelion::cli {

/// A picture of the sky and who looked at it.
struct Observed {
  ViewInput input;
  PhotoCamera camera;
};

/// Writes the profile of the first picture as CSV, beside it that of the second if there is one, and draws their chart
/// if that is asked for. Of two pictures both are taken over the part of the sky that both show; `mask` is the first
/// one's, or empty.
void writeProfile(const ViewOptions& options, std::vector<Observed> pictures, const std::vector<std::uint8_t>& mask,
                  Transaction& outputs);

}  // namespace parhelion::cli
