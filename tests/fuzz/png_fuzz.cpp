// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include "input_file.h"
#include "picture/photograph.h"
#include "picture/picture_text.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace parhelion;
  const std::filesystem::path& path = inputFile(data, size);
  mayRefuse([&] { readPhotograph(path, {true}); });
  mayRefuse([&] { readPhotographHeader(path); });
  mayRefuse([&] { readPictureText(path); });
  return 0;
}
