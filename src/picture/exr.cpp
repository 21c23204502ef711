// SPDX-License-Identifier: Apache-2.0
#include "picture/exr.h"

#include <ImfChannelList.h>
#include <ImfEnvmapAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <span>

#include "math/number_text.h"
#include "picture/colour_space.h"
#include "picture/exr_checksum.h"
#include "picture/exr_stream.h"
#include "picture/limits.h"
#include "picture/meaning.h"

namespace parhelion {
namespace {

// Of integrated skies: a seventh less time than OpenEXR's own 4 takes, for files larger by 1.4 %.
constexpr int kZipLevel = 2;

/// SOURCE_DATE_EPOCH as EXR's capDate, "2024:01:31 12:00:00" (UTC); empty if it is not set.
std::string captureDate() {
  const char* text = std::getenv("SOURCE_DATE_EPOCH");
  if (!text) return {};
  std::int64_t seconds = 0;
  const char* end = text + std::strlen(text);
  const auto [stop, error] = std::from_chars(text, end, seconds);
  constexpr std::int64_t kYear10000 = 253402300800;
  if (error != std::errc{} || stop != end || seconds < 0 || seconds >= kYear10000) {
    throw std::runtime_error("SOURCE_DATE_EPOCH is no number of seconds since 1970, with a year before 10000: '" +
                             std::string(text) + "'");
  }
  const std::time_t time = seconds;
  std::tm utc{};
  gmtime_r(&time, &utc);
  std::array<char, 32> date{};
  std::strftime(date.data(), date.size(), "%Y:%m:%d %H:%M:%S", &utc);
  return date.data();
}

Imf::Chromaticities stored(const Chromaticities& space) {
  const auto v2f = [](const Vec2& c) { return Imath::V2f(static_cast<float>(c.x), static_cast<float>(c.y)); };
  return {v2f(space.red), v2f(space.green), v2f(space.blue), v2f(space.white)};
}

Imf::Header beautyHeader(const Image& image, ExrAttributes attributes, Envmap envmap, const Chromaticities& space) {
  Imf::Header header(image.width, image.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  header.zipCompressionLevel() = kZipLevel;
  for (const Channel& channel : image.channels) header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
  Imf::addChromaticities(header, stored(space));
  if (envmap == Envmap::latLong) Imf::addEnvmap(header, Imf::ENVMAP_LATLONG);
  if (const std::string date = captureDate(); !date.empty()) attributes["capDate"] = date;
  insertText(header, attributes);
  return header;
}

Imf::Slice sliceOf(const std::vector<float>& samples, const Imath::Box2i& window) {
  // OpenEXR takes a pointer to non-const for writing too, and only reads from it then.
  return Imf::Slice::Make(Imf::FLOAT, samples.data(), window);
}

/// Adds samples to a range, whose mean is still their sum.
void include(ChannelRange& range, std::span<const float> samples) {
  for (const float sample : samples) {
    range.least = std::min(range.least, sample);
    range.greatest = std::max(range.greatest, sample);
    range.mean += sample;
  }
}

bool isColour(std::string_view name) { return name == "R" || name == "G" || name == "B" || name == "A" || name == "Y"; }

Image readPart(const std::filesystem::path& path, Imf::MultiPartInputFile& file, const ExrWanted& wanted) {
  const Imf::Header& header = file.header(0);
  requireSaneSize(path, header);
  const Imath::Box2i window = header.dataWindow();
  Image image{window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, {}};
  std::vector<std::string> names;
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c)
    if (!wanted.coloursOnly || isColour(c.name())) names.emplace_back(c.name());
  const std::uint64_t pixelBytes = names.size() * sizeof(float) + static_cast<unsigned>(wanted.bytesForUse);
  requireMemoryFor(path, image.pixels() * pixelBytes + rowMemory(header));
  for (const std::string& name : names) image.add(name);
  Imf::FrameBuffer buffer;
  for (const Channel& channel : image.channels) buffer.insert(channel.name, sliceOf(channel.samples, window));
  Imf::InputPart part(file, 0);
  part.setFrameBuffer(buffer);
  part.readPixels(window.min.y, window.max.y);
  return image;
}

/// The channels' rows a few at a time, as many as compression takes together.
std::vector<ChannelRange> rangesOf(const std::filesystem::path& path, Imf::MultiPartInputFile& file) {
  const Imf::Header& header = file.header(0);
  requireSaneSize(path, header);
  const Imath::Box2i window = header.dataWindow();
  const int width = window.max.x - window.min.x + 1, most = rowsTogether(header);
  std::vector<ChannelRange> ranges;
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c)
    ranges.push_back({c.name(), INFINITY, -INFINITY, 0.0});
  const std::size_t planeSize = static_cast<std::size_t>(width) * static_cast<std::size_t>(most);
  requireMemoryFor(path, ranges.size() * planeSize * sizeof(float) + rowMemory(header));
  std::vector<std::vector<float>> planes(ranges.size(), std::vector<float>(planeSize));
  Imf::InputPart part(file, 0);
  for (int top = window.min.y; top <= window.max.y; top += most) {
    const int bottom = std::min(top + most - 1, window.max.y);
    const Imath::Box2i rows({window.min.x, top}, {window.max.x, bottom});
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < ranges.size(); ++c) buffer.insert(ranges[c].name, sliceOf(planes[c], rows));
    part.setFrameBuffer(buffer);
    part.readPixels(top, bottom);
    const std::size_t samples = static_cast<std::size_t>(width) * static_cast<std::size_t>(bottom - top + 1);
    for (std::size_t c = 0; c < ranges.size(); ++c) include(ranges[c], std::span(planes[c]).first(samples));
  }
  const double pixels = static_cast<double>(width) * (window.max.y - window.min.y + 1);
  for (ChannelRange& range : ranges) range.mean /= pixels;
  return ranges;
}

DisplayWindow displayOf(const Imf::Header& header) {
  const Imath::Box2i &data = header.dataWindow(), &display = header.displayWindow();
  return {display.min.x - data.min.x, display.min.y - data.min.y, display.max.x - display.min.x + 1,
          display.max.y - display.min.y + 1};
}

std::optional<Chromaticities> chromaticitiesOf(const Imf::Header& header) {
  if (!Imf::hasChromaticities(header)) return {};
  const Imf::Chromaticities& c = Imf::chromaticities(header);
  const auto vec2 = [](const Imath::V2f& v) { return Vec2{v.x, v.y}; };
  return Chromaticities{vec2(c.red), vec2(c.green), vec2(c.blue), vec2(c.white)};
}

/// Takes the colours of a file to Rec.709.
void convertToRec709(const std::filesystem::path& path, ExrFile& file) {
  if (!file.chromaticities || !file.image.find("R") || !file.image.find("G") || !file.image.find("B")) return;
  const std::string objection = chromaticitiesObjection(*file.chromaticities);
  if (objection.empty()) return;
  const std::optional<Mat3> toRec709 = rgbToRec709(*file.chromaticities);
  if (!toRec709)
    throw std::runtime_error(path.string() + ": " + objection +
                             ", and these make no colour space; --assume-srgb takes them as they are");
  file.image.changeColoursOfAll(
      [&](const Vec3& stored) { return std::isfinite(stored.x + stored.y + stored.z) ? *toRec709 * stored : stored; });
}

}  // namespace

std::optional<double> whiteLuminanceOf(const ExrAttributes& attributes) {
  const auto white = attributes.find(kWhiteLuminanceKey);
  const std::optional<double> value = white == attributes.end() ? std::nullopt : numberIn(white->second);
  return value && *value > 0.0 ? value : std::nullopt;
}

void requireSourceDate() { captureDate(); }

void writeBeautyExr(const Output& output, const Image& rec709, ExrAttributes attributes, Envmap envmap,
                    const Chromaticities& space) {
  const bool isConverted = !chromaticitiesObjection(space).empty();
  Image converted;
  if (isConverted) {
    converted = rec709;
    const Mat3 fromRec709 = inverse(*rgbToRec709(space));
    converted.changeColoursOfAll([&](const Vec3& colour) { return fromRec709 * colour; });
  }
  const Image& image = isConverted ? converted : rec709;
  withExrErrors(output.path, [&] {
    attributes.insert_or_assign(kPictureKey, std::string(1, kPictureFormat));
    attributes.erase(kChecksumKey);  // of the picture that this one was made from
    Imf::Header header = beautyHeader(image, attributes, envmap, space);
    header.insert(kChecksumKey, Imf::StringAttribute(pictureChecksum(header, checksumsOf(image))));
    AtomicFile file(output);
    {
      ExrOutput stream(output.path, file);
      Imf::OutputFile writer(stream, header);
      Imf::FrameBuffer buffer;
      for (const Channel& c : image.channels) buffer.insert(c.name, sliceOf(c.samples, header.dataWindow()));
      writer.setFrameBuffer(buffer);
      writer.writePixels(image.height);
    }  // here OpenEXR writes its table of scan lines
    file.commit();
  });
}

bool isExr(const std::filesystem::path& path) {
  constexpr std::array<char, 4> kMagic{0x76, 0x2f, 0x31, 0x01};
  std::array<char, 4> start{};
  std::ifstream(path, std::ios::binary).read(start.data(), start.size());
  return start == kMagic;
}

ExrFile readExr(const std::filesystem::path& path, ExrColours colours, ExrWanted wanted) {
  requireSaneHeaders(path);
  return withExrErrors(path, [&] {
    Imf::MultiPartInputFile file(path.c_str(), 0, false);  // no threads, no guessing at missing scan lines
    if (wanted.edited == EditedPictures::refused) requireUnchanged(path, file);
    Image image = readPart(path, file, wanted);
    const Imf::Header& header = file.header(0);
    ExrFile read{std::move(image), withoutMarks(textOf(header)), displayOf(header), chromaticitiesOf(header)};
    if (colours == ExrColours::rec709) convertToRec709(path, read);
    return read;
  });
}

ExrFrame readExrFrame(const std::filesystem::path& path) {
  requireSaneHeaders(path);
  return withExrErrors(path, [&] {
    Imf::MultiPartInputFile file(path.c_str(), 0, false);
    const Imf::Header& header = file.header(0);
    requireSaneSize(path, header);
    const Imath::Box2i& window = header.dataWindow();
    ExrFrame frame{
        window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, displayOf(header), {}, textOf(header)};
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c) frame.channels.emplace_back(c.name());
    frame.attributes = withoutMarks(std::move(frame.attributes));
    return frame;
  });
}

std::vector<ChannelRange> readExrRanges(const std::filesystem::path& path, EditedPictures edited) {
  requireSaneHeaders(path);
  return withExrErrors(path, [&] {
    Imf::MultiPartInputFile file(path.c_str(), 0, false);
    if (edited == EditedPictures::refused) requireUnchanged(path, file);
    return rangesOf(path, file);
  });
}

ExrAttributes readExrAttributes(const std::filesystem::path& path) {
  requireSaneHeaders(path);
  return withExrErrors(path, [&] {
    Imf::MultiPartInputFile file(path.c_str(), 0, false);
    return withoutMarks(textOf(file.header(0)));
  });
}

}  // namespace parhelion
