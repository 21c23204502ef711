// SPDX-License-Identifier: Apache-2.0
// A file in the place of an output: whether it is ours, and may be replaced.
#include "cli/own_files.h"
#include "input_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace parhelion;
  const Limits limits;
  const std::filesystem::path& path = inputFile(data, size);
  mayRefuse([&] { cli::isOwnFile(path); });
  return 0;
}
