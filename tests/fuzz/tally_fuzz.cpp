// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include "input_file.h"
#include "sky/tally_exr.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace parhelion;
  const std::filesystem::path& path = inputFile(data, size);
  mayRefuse([&] { readTallyExr(path); });
  return 0;
}
