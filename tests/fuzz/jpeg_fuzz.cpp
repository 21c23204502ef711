// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include "input_file.h"
#include "picture/jpeg.h"
#include "picture/jpeg_coefficients.h"
#include "picture/photograph.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace parhelion;
  const std::filesystem::path& path = inputFile(data, size);
  mayRefuse([&] { readPhotograph(path, {true}); });
  mayRefuse([&] { readPhotographHeader(path); });
  mayRefuse([&] { readJpegComments(path); });
  // Coefficients are taken only of what has been read.
  mayRefuse([&] {
    readJpeg(path);
    JpegCoefficients coefficients(path);
    coefficients.row(0, 0);
  });
  return 0;
}
