// SPDX-License-Identifier: Apache-2.0
// All that is read of a JPEG, and the copy of it that has some pixels changed.
#include "input_file.h"
#include "picture/jpeg_patch.h"
#include "picture/picture_text.h"
#include "picture_use.h"

namespace {

/// A copy with another colour in the upper left corner.
void patch(const std::filesystem::path& path, parhelion::Photograph photograph) {
  using namespace parhelion;
  static const MemoryFile copy;
  auto* const samples = std::get_if<std::vector<std::uint8_t>>(&photograph.samples);
  if (!samples || photograph.channels != 3 || photograph.pixels() > kMostDeveloped) return;
  for (std::size_t i = 0; i < 3; ++i) (*samples)[i] ^= 0x80;
  const Output output(copy.emptied());
  mayRefuse([&] {
    if (writePatchedJpeg(output, path, photograph, "changed")) readPhotograph(output.path, {true});
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace parhelion;
  const Limits limits;
  const std::filesystem::path& path = inputFile(data, size);
  mayRefuse([&] { usePhotograph(readPhotograph(path)); });
  mayRefuse([&] {
    const Photograph photograph = readPhotograph(path, {true});
    usePhotograph(photograph);
    patch(path, photograph);
  });
  mayRefuse([&] { useLens(readPhotographHeader(path)); });
  mayRefuse([&] { readPictureText(path); });
  return 0;
}
