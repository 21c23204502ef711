// SPDX-License-Identifier: Apache-2.0
// What a fuzzer asks of the Exif reader: to return whatever the bytes are, without a step outside them, and with an
// orientation and texts that its callers can trust. Built and run by scripts/fuzz.
#include <cstdint>
#include <cstdlib>

#include "picture/exif.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const parhelion::Exif exif = parhelion::readExif({data, size});
  if (exif.orientation < 1 || exif.orientation > 8) std::abort();
  if (exif.make.size() > 64 || exif.model.size() > 64) std::abort();
  if (!(exif == exif)) std::abort();  // no NaN
  return 0;
}
