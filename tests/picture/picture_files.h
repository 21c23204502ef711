// SPDX-License-Identifier: Apache-2.0
#pragma once

// Picture files made by hand, so that they can be of any kind and can lie.

#include <lcms2.h>
#include <turbojpeg.h>
#include <zlib.h>

#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace parhelion {

inline std::string bigEndian(std::uint32_t number, int bytes = 4) {
  std::string text;
  for (int i = bytes - 1; i >= 0; --i) text.push_back(static_cast<char>(number >> 8 * i));
  return text;
}

template <typename Sample>
std::vector<Sample> noiseSamples(std::size_t count, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::vector<Sample> samples(count);
  for (Sample& s : samples) s = static_cast<Sample>(random());
  return samples;
}

/// An Exif block of nothing but an orientation: big-endian TIFF with one short in its directory.
inline std::string exifBlock(int orientation) {
  return std::string("MM\0*\0\0\0\10\0\1\1\22\0\3\0\0\0\1", 18) +
         bigEndian(static_cast<std::uint32_t>(orientation), 2) + std::string(6, '\0');
}

/// A JPEG of interleaved samples; grey for TJPF_GRAY, CMYK for TJPF_CMYK.
inline std::string jpegFile(const std::vector<std::uint8_t>& samples, int width, int height, int pixelFormat = TJPF_RGB,
                            int subsampling = TJSAMP_444, int flags = 0, int quality = 95) {
  tjhandle handle = tjInitCompress();
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  const int result =
      tjCompress2(handle, samples.data(), width, 0, height, pixelFormat, &buffer, &size, subsampling, quality, flags);
  std::string file(reinterpret_cast<const char*>(buffer), size);
  tjFree(buffer);
  tjDestroy(handle);
  if (result != 0) throw std::logic_error("the test cannot make its JPEG");
  return file;
}

inline std::string jpegSegment(int marker, const std::string& payload) {
  return std::string{'\xff', static_cast<char>(marker)} + bigEndian(static_cast<std::uint32_t>(payload.size() + 2), 2) +
         payload;
}

/// The JPEG with segments put in after its start.
inline std::string withSegments(std::string jpeg, const std::string& segments) { return jpeg.insert(2, segments); }

/// The JPEG with other numbers in its frame header, whose marker is 0xC0 or 0xC2.
inline std::string withJpegSize(std::string jpeg, int width, int height) {
  std::size_t at = jpeg.find(std::string("\xff\xc0\x00\x11\x08", 5));
  if (at == std::string::npos) at = jpeg.find(std::string("\xff\xc2\x00\x11\x08", 5));
  jpeg.replace(at + 5, 2, bigEndian(static_cast<std::uint32_t>(height), 2));
  return jpeg.replace(at + 7, 2, bigEndian(static_cast<std::uint32_t>(width), 2));
}

inline std::string deflated(const std::string& bytes) {
  std::string packed(compressBound(bytes.size()), '\0');
  uLongf size = packed.size();
  compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(),
            9);
  packed.resize(size);
  return packed;
}

inline std::string pngChunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  const auto crc = crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return bigEndian(static_cast<std::uint32_t>(data.size())) + body + bigEndian(static_cast<std::uint32_t>(crc));
}

struct PngKind {
  std::uint32_t width = 0, height = 0;
  int bits = 8;
  int colourType = 2;  // 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
  bool interlaced = false;
};

/// A PNG from its scan lines, each with its filter byte before it; `chunks` come before the picture.
inline std::string pngFile(const PngKind& kind, const std::string& scanLines, const std::string& chunks = "") {
  const std::string header = bigEndian(kind.width) + bigEndian(kind.height) + static_cast<char>(kind.bits) +
                             static_cast<char>(kind.colourType) + std::string(2, '\0') +
                             static_cast<char>(kind.interlaced);
  return "\x89PNG\r\n\x1a\n" + pngChunk("IHDR", header) + chunks + pngChunk("IDAT", deflated(scanLines)) +
         pngChunk("IEND", "");
}

/// Rows of bytes as unfiltered scan lines.
inline std::string scanLines(std::string_view samples, std::size_t rowBytes) {
  std::string lines;
  for (std::size_t at = 0; at < samples.size(); at += rowBytes) {
    lines += std::string(1, '\0') + std::string(samples.substr(at, rowBytes));
  }
  return lines;
}

inline std::string_view asText(const std::vector<std::uint8_t>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The bytes of a profile, which it closes.
inline std::string profileBytes(cmsHPROFILE profile) {
  cmsUInt32Number size = 0;
  cmsSaveProfileToMem(profile, nullptr, &size);
  std::string bytes(size, '\0');
  cmsSaveProfileToMem(profile, bytes.data(), &size);
  cmsCloseProfile(profile);
  return bytes;
}

/// Primaries and curve of a profile of RGB, under a name.
inline std::string rgbProfile(const cmsCIExyYTRIPLE& primaries, cmsToneCurve* curve, const char* name) {
  const cmsCIExyY d65{0.3127, 0.3290, 1.0};
  cmsToneCurve* curves[3] = {curve, curve, curve};
  cmsHPROFILE profile = cmsCreateRGBProfile(&d65, &primaries, curves);
  cmsFreeToneCurve(curve);
  cmsMLU* text = cmsMLUalloc(nullptr, 1);
  cmsMLUsetASCII(text, "en", "US", name);
  cmsWriteTag(profile, cmsSigProfileDescriptionTag, text);
  cmsMLUfree(text);
  return profileBytes(profile);
}

inline std::string adobeRgbProfile() {
  return rgbProfile({{0.64, 0.33, 1.0}, {0.21, 0.71, 1.0}, {0.15, 0.06, 1.0}}, cmsBuildGamma(nullptr, 2.19921875),
                    "Adobe RGB (1998)");
}

}  // namespace parhelion
