// SPDX-License-Identifier: Apache-2.0
#pragma once

// All that a file, a scene included, can ask for: how large it may be, and how much memory and time reading it may
// take. Whoever makes a reader looks here first. Memory is the limit that users can move, by the option --memory; the
// others are far beyond what honest files have.

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace parhelion {

// Pictures of any kind.
inline constexpr int kMaxImageSide = 32768;                                  // pixels
inline constexpr int kMaxImagePixels = 1 << 28;                              // of a tally or an EXR
inline constexpr std::int64_t kMaxPhotographPixels = std::int64_t{1} << 27;  // of a photograph: cameras have 2^27.2
inline constexpr std::int64_t kMostDisplayTimesData = 256;  // pixels of an EXR's display window for each one it holds

// Memory for reading one file and for what is made of it. A header of a few bytes can promise a picture of gigabytes;
// so a file gets this much, or more where its own size makes a large picture likely.
inline constexpr std::uint64_t kUnaskedMemory = 1'000'000'000;  // bytes: a photograph of 50 megapixels in any command
inline constexpr std::uint64_t kUnaskedTimesFile = 200;         // lossless pictures of the sky are packed 2 to 100 to 1
inline constexpr std::uint64_t kSmallMemory = 1 << 24;          // bytes, for which nobody is asked

// ICC profiles, in whatever they are embedded.
inline constexpr std::uint64_t kMostProfileMemory = 1 << 26;  // bytes; a table of 33^3 colours takes one million

// JPEG.
inline constexpr std::uintmax_t kMostJpegBytes = std::uintmax_t{1}
                                                 << 30;  // the largest picture in best quality is less
inline constexpr int kMostJpegScans = 100;               // each goes over the whole picture; encoders make about ten

// PNG. A chunk may take this much, unpacked, and so many of them are kept: profiles and texts are far smaller and
// fewer.
inline constexpr std::uint32_t kMostPngChunk = 1 << 22;  // bytes
inline constexpr std::uint32_t kMostPngChunks = 16;
inline constexpr std::uint64_t kMostDeflated = 1032;  // deflate packs no tighter: 258 bytes by two codes of one bit

// EXR.
// A part costs some kilobytes in memory, and its table of scan lines must be in the file. A tally has one for each
// number of a pixel and of a ring: 24 where its populations have all three symmetries, and as many for each of 65
// layers.
inline constexpr int kMostExrParts = 2048;
inline constexpr int kMostExrChannels = 4096;
inline constexpr std::uint64_t kMostExrDeflated = 1100;  // deflate, the tightest of the lossless codecs, with a reserve
inline constexpr std::uint64_t kDwaBlock = 64;  // samples, of which DWA deflates what is left, which is two or more

// Scenes and other texts.
inline constexpr std::size_t kMostSceneBytes = 1 << 20;       // no scene comes near; a wrong file often does
inline constexpr std::size_t kMostMeshBytes = 1 << 22;        // the OBJ of a crystal; 10,000 vertices take a tenth
inline constexpr std::size_t kMostMeshesInScene = 900'000;    // bytes of all OBJs, which become part of the scene
inline constexpr std::size_t kMostNesting = 16;               // brackets and dots; a scene needs four
inline constexpr std::uintmax_t kMostOwnJsonBytes = 1 << 20;  // JSON that commands write stays far below

/// Throws std::runtime_error "path: reason" in one line where reading a file and what is made of it would take so many
/// bytes of memory, and that is more than a file of its size gets unasked or than there is (picture/memory_limit.h).
/// With --memory, that alone counts. For readers, before they allocate anything.
void requireMemoryFor(const std::filesystem::path& path, std::uint64_t bytes);

}  // namespace parhelion
