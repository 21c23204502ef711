// SPDX-License-Identifier: Apache-2.0
#include <span>

#include "input_file.h"
#include "picture/icc_profile.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const parhelion::Limits limits;
  for (const bool grey : {false, true}) parhelion::profileObjection(std::span(data, size), grey);
  return 0;
}
