// SPDX-License-Identifier: Apache-2.0
#include "picture/png_chunks.h"

#include <array>
#include <cstdint>

#include "picture/limits.h"

namespace parhelion {

PngChunks walkPng(std::FILE* file) {
  constexpr long kSignature = 8, kHead = 8, kSum = 4;  // bytes; PNG specification, 3rd edition, 5.2 and 5.3
  PngChunks found;
  std::fseek(file, 0, SEEK_END);
  const long size = std::ftell(file);
  long at = kSignature;
  while (!found.whole && at + kHead <= size) {
    std::array<unsigned char, kHead> head{};
    std::fseek(file, at, SEEK_SET);
    if (std::fread(head.data(), 1, head.size(), file) != head.size()) break;
    const std::uint32_t length = static_cast<std::uint32_t>(head[0]) << 24 | head[1] << 16 | head[2] << 8 | head[3];
    const std::string kind(head.begin() + 4, head.end());
    const bool fits = static_cast<std::int64_t>(length) <= size - at - kHead - kSum;
    if ((!fits || length > kMostPngChunk) && kind != "IDAT") found.large.insert(kind);
    if (!fits) break;
    at += kHead + static_cast<long>(length) + kSum;
    found.whole = kind == "IEND";
  }
  std::rewind(file);
  return found;
}

}  // namespace parhelion
