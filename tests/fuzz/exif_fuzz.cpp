// SPDX-License-Identifier: Apache-2.0
// The Exif reader returns whatever the bytes are, with an orientation and texts that its callers can trust. The lens is
// what it makes of them, or an invalid_argument.
#include <array>

#include "input_file.h"
#include "photo/lens_from_exif.h"
#include "photo/photo_camera.h"
#include "picture/exif.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace parhelion;
  const Limits limits;
  Photograph photograph;
  Exif& exif = photograph.exif = readExif({data, size});
  require(exif.orientation >= 1 && exif.orientation <= 8);
  require(exif.make.size() <= 64 && exif.model.size() <= 64);
  require(exif == exif);  // no NaN
  for (const auto& [width, height] : {std::array{64, 48}, std::array{3, 4000}}) {
    photograph.width = width;
    photograph.height = height;
    try {
      findLens(photograph, {});
    } catch (const std::invalid_argument&) {
    }
  }
  return 0;
}
