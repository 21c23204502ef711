// SPDX-License-Identifier: Apache-2.0
// A PNG as it is, and with checksums that fit: a mutated chunk hardly ever has one, and would never be looked into.
#include <algorithm>
#include <array>
#include <vector>

#include "input_file.h"
#include "picture/picture_text.h"
#include "picture_use.h"

namespace {

/// CRC-32 of ISO 3309, bit by bit.
std::uint32_t crcOf(const std::uint8_t* data, std::size_t size) {
  std::uint32_t crc = ~0U;
  for (std::size_t i = 0; i < size; ++i) {
    crc ^= data[i];
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

/// With the right checksum behind each chunk.
std::vector<std::uint8_t> repaired(std::vector<std::uint8_t> png) {
  constexpr std::size_t kSignature = 8, kWord = 4, kFrame = 3 * kWord;  // of a chunk: length, kind, checksum
  for (std::size_t at = kSignature; at <= png.size() && png.size() - at >= kFrame;) {
    std::size_t length = 0;
    for (std::size_t k = 0; k < kWord; ++k) length = length << 8 | png[at + k];
    if (length > png.size() - at - kFrame) break;
    std::uint8_t* const kind = &png[at + kWord];
    const std::uint32_t crc = crcOf(kind, kWord + length);
    for (std::size_t k = 0; k < kWord; ++k) kind[kWord + length + k] = static_cast<std::uint8_t>(crc >> (24 - 8 * k));
    at += kFrame + length;
  }
  return png;
}

void read(const std::filesystem::path& path) {
  using namespace parhelion;
  mayRefuse([&] { usePhotograph(readPhotograph(path)); });
  mayRefuse([&] { usePhotograph(readPhotograph(path, {true})); });
  mayRefuse([&] { useLens(readPhotographHeader(path)); });
  mayRefuse([&] { readPictureText(path); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const parhelion::Limits limits;
  const std::vector<std::uint8_t> asIs(data, data + size), fitting = repaired(asIs);
  read(parhelion::inputFile(asIs.data(), size));
  if (fitting != asIs) read(parhelion::inputFile(fitting.data(), size));
  return 0;
}
