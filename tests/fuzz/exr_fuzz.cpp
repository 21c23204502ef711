// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include "input_file.h"
#include "picture/exr.h"
#include "picture/photograph.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace parhelion;
  const std::filesystem::path& path = inputFile(data, size);
  mayRefuse([&] { readExr(path); });
  mayRefuse([&] { readExrRanges(path); });
  mayRefuse([&] { readExrFrame(path); });
  mayRefuse([&] { readExrAttributes(path); });
  mayRefuse([&] { readPhotograph(path); });
  return 0;
}
