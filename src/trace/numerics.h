// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace parhelion {

/// Version of the tracing's arithmetic. Tallies of the same version may be added: in all of them the same ray of the
/// same scene and seed is the same to the bit. CONTRIBUTING.md says when to raise it, and a test that holds the sums of
/// small tallies (tests/render/test_numerics.cpp) fails when it is forgotten.
inline constexpr int kNumericsVersion = 2;

}  // namespace parhelion
