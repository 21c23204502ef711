// SPDX-License-Identifier: Apache-2.0
#include "picture/exr_checksum.h"

#include <ImfChannelList.h>
#include <ImfEnvmapAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfInputPart.h>
#include <ImfStandardAttributes.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <vector>

#include "math/checksum.h"
#include "math/range.h"
#include "picture/exr_stream.h"
#include "picture/limits.h"
#include "picture/meaning.h"

namespace parhelion {
namespace {

std::string lineOf(const char* name, const Imath::Box2i& window) {
  std::string line = name;
  for (const int x : {window.min.x, window.min.y, window.max.x, window.max.y}) {
    line += ' ';
    line += std::to_string(x);
  }
  line += '\n';
  return line;
}

std::string lineOf(const Imf::Chromaticities& chromaticities) {
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

void addSamples(Checksum& checksum, const float* samples, std::size_t count) {
  static_assert(std::endian::native == std::endian::little, "the bytes of samples must be turned round here");
  checksum.add(samples, count * sizeof(float));
}

/// Those of the samples in a file, as floats.
ChannelChecksums checksumsIn(const std::filesystem::path& path, Imf::MultiPartInputFile& file) {
  const Imf::Header& header = file.header(0);
  requireSaneSize(path, header);
  const Imath::Box2i window = header.dataWindow();
  const int width = window.max.x - window.min.x + 1, most = rowsTogether(header);
  std::vector<std::string> names;
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c) names.emplace_back(c.name());
  const std::size_t planeSize = static_cast<std::size_t>(width) * static_cast<std::size_t>(most);
  requireMemoryFor(path, names.size() * planeSize * sizeof(float) + rowMemory(header));
  std::vector<std::vector<float>> planes(names.size(), std::vector<float>(planeSize));
  std::vector<Checksum> checksums(names.size());
  Imf::InputPart part(file, 0);
  for (int top = window.min.y; top <= window.max.y; top += most) {
    const int bottom = std::min(top + most - 1, window.max.y);
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < names.size(); ++c)
      buffer.insert(names[c], Imf::Slice::Make(Imf::FLOAT, planes[c].data(),
                                               Imath::Box2i({window.min.x, top}, {window.max.x, bottom})));
    part.setFrameBuffer(buffer);
    part.readPixels(top, bottom);
    const std::size_t samples = static_cast<std::size_t>(width) * static_cast<std::size_t>(bottom - top + 1);
    for (std::size_t c = 0; c < names.size(); ++c) addSamples(checksums[c], planes[c].data(), samples);
  }
  ChannelChecksums channels;
  for (std::size_t c = 0; c < names.size(); ++c) channels[names[c]] = checksums[c].value();
  return channels;
}

}  // namespace

ChannelChecksums checksumsOf(const Image& image) {
  ChannelChecksums channels;
  for (const Channel& channel : image.channels) {
    Checksum checksum;
    addSamples(checksum, channel.samples.data(), channel.samples.size());
    channels[channel.name] = checksum.value();
  }
  return channels;
}

std::string pictureChecksum(const Imf::Header& header, const ChannelChecksums& channels) {
  Checksum all;
  addMeaning(all, textOf(header));
  all.add(lineOf("dataWindow", header.dataWindow()));
  all.add(lineOf("displayWindow", header.displayWindow()));
  if (Imf::hasChromaticities(header)) all.add(lineOf(Imf::chromaticities(header)));
  if (Imf::hasEnvmap(header)) all.add("envmap " + std::to_string(Imf::envmap(header)) + "\n");
  if (Imf::hasWhiteLuminance(header)) all.add("whiteLuminance " + formatNumber(Imf::whiteLuminance(header)) + "\n");
  for (const auto& [name, checksum] : channels) all.add("channel " + name + " " + hexOf(checksum) + "\n");
  return hexOf(all.value());
}

void requireUnchanged(const std::filesystem::path& path, Imf::MultiPartInputFile& file) {
  const ExrAttributes attributes = textOf(file.header(0));
  const auto stored = attributes.find(kChecksumKey);
  // That of a tally is another one, and pictures of before have none.
  const bool isMarked = attributes.contains(kPictureKey) || stored != attributes.end();
  if (!isMarked || attributes.contains("parhelion:tally")) return;
  const std::string found = pictureChecksum(file.header(0), checksumsIn(path, file));
  const std::string expected = stored == attributes.end() ? "missing" : stored->second.substr(0, 16);
  if (found == expected) return;
  throw exrError(path, "damaged, or changed by another program: its checksum is " + expected + ", and should be " +
                           found + "; --edited takes it as it is");
}

}  // namespace parhelion
