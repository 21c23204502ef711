// SPDX-License-Identifier: Apache-2.0
#pragma once

/// For functions that lane code calls: a copy of one that is compiled for special registers must not be shared with
/// code for all machines, so none is ever left outside its caller.
#define PARHELION_INLINE inline __attribute__((always_inline))
