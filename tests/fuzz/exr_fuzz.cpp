// SPDX-License-Identifier: Apache-2.0
// All that is read of an EXR picture, and what is shown of it. A picture of ours with another checksum is read, too.
#include "input_file.h"
#include "picture/exr.h"
#include "picture/picture_text.h"
#include "picture_use.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace parhelion;
  const Limits limits;
  const std::filesystem::path& path = inputFile(data, size);
  for (const EditedPictures edited : {EditedPictures::refused, EditedPictures::read}) {
    mayRefuse([&] { useLight(readExr(path, ExrColours::rec709, {.edited = edited}).image); });
    mayRefuse([&] { usePhotograph(readPhotograph(path, {false, 0, edited == EditedPictures::read})); });
  }
  mayRefuse([&] { useLight(readExr(path, ExrColours::asStored, {true, 0, EditedPictures::read}).image); });
  mayRefuse([&] { readExrRanges(path, EditedPictures::read); });
  mayRefuse([&] { readExrFrame(path); });
  mayRefuse([&] { readPictureText(path); });
  return 0;
}
