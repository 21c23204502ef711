// SPDX-License-Identifier: Apache-2.0
#include "picture/exr_checksum.h"

#include <ImfEnvmapAttribute.h>
#include <ImfStandardAttributes.h>

#include <array>
#include <bit>
#include <charconv>
#include <map>

#include "math/checksum.h"
#include "picture/exr_stream.h"
#include "picture/meaning.h"

namespace parhelion {
namespace {

std::string textOf(const char* name, const Imath::Box2i& window) {
  std::string line = name;
  for (const int x : {window.min.x, window.min.y, window.max.x, window.max.y}) {
    line += ' ';
    line += std::to_string(x);
  }
  line += '\n';
  return line;
}

std::string textOf(const Imf::Chromaticities& chromaticities) {
  std::string line = "chromaticities";
  for (const Imath::V2f* point :
       {&chromaticities.red, &chromaticities.green, &chromaticities.blue, &chromaticities.white})
    for (const float x : {point->x, point->y}) {
      std::array<char, 32> digits{};
      const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), x);
      line += ' ';
      line.append(digits.data(), static_cast<std::size_t>(end - digits.data()));
    }
  line += '\n';
  return line;
}

}  // namespace

std::string pictureChecksum(const Imf::Header& header, const ExrAttributes& attributes, const Image& image) {
  static_assert(std::endian::native == std::endian::little, "the bytes of samples must be turned round here");
  Checksum all;
  addMeaning(all, attributes);
  all.add(textOf("dataWindow", header.dataWindow()));
  all.add(textOf("displayWindow", header.displayWindow()));
  if (Imf::hasChromaticities(header)) all.add(textOf(Imf::chromaticities(header)));
  if (Imf::hasEnvmap(header)) all.add("envmap " + std::to_string(Imf::envmap(header)) + "\n");
  std::map<std::string, std::string> byName;
  for (const Channel& channel : image.channels) {
    Checksum samples;
    samples.add(channel.samples.data(), channel.samples.size() * sizeof(float));
    byName[channel.name] = hexOf(samples.value());
  }
  for (const auto& [name, checksum] : byName) all.add("channel " + name + " " + checksum + "\n");
  return hexOf(all.value());
}

void requireUnchanged(const std::filesystem::path& path, const Imf::Header& header, const ExrAttributes& attributes,
                      const Image& image) {
  const auto stored = attributes.find(kChecksumKey);
  if (stored == attributes.end()) return;
  const std::string found = pictureChecksum(header, attributes, image);
  if (found == stored->second) return;
  throw exrError(path, "damaged, or changed by another program: its checksum is " + found + ", and should be " +
                           stored->second.substr(0, 16) + "; --edited takes it as it is");
}

}  // namespace parhelion
