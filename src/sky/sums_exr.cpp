// SPDX-License-Identifier: Apache-2.0
#include "sky/sums_exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStdIO.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "math/checksum.h"
#include "picture/exr_stream.h"
#include "picture/image.h"
#include "picture/meaning.h"

namespace parhelion {
namespace {

constexpr const char* kFormatKey = "parhelion:tally";
constexpr std::string_view kFormat = "3";
constexpr std::string_view kPartPrefix = "parhelion:part.";
constexpr int kBlockRows = 16;  // ZIP compresses so many scan lines together

/// Some rows of a part, also split into the halves that EXR can hold.
struct Rows {
  std::vector<std::int64_t> values;
  std::vector<std::uint32_t> hi, lo;
  int width;

  explicit Rows(const SumsPart& part)
      : values(static_cast<std::size_t>(part.width) * static_cast<std::size_t>(std::min(kBlockRows, part.height))),
        hi(values.size()),
        lo(values.size()),
        width(part.width) {}

  std::size_t sizeOf(int rows) const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(rows); }

  Imf::FrameBuffer at(int row, int rows) {
    const Imath::Box2i window({0, row}, {width - 1, row + rows - 1});
    Imf::FrameBuffer buffer;
    buffer.insert("hi", Imf::Slice::Make(Imf::UINT, hi.data(), window));
    buffer.insert("lo", Imf::Slice::Make(Imf::UINT, lo.data(), window));
    return buffer;
  }
};

/// Calls work(row, rows) for one block of a part after the other.
template <class Work>
void forBlocks(const SumsPart& part, const Work& work) {
  for (int row = 0; row < part.height; row += kBlockRows) work(row, std::min(kBlockRows, part.height - row));
}

/// Adds integers to a checksum, the lowest byte of each first.
void addIntegers(Checksum& checksum, std::span<const std::int64_t> values) {
  static_assert(std::endian::native == std::endian::little, "the bytes of integers must be turned round here");
  checksum.add(values.data(), values.size_bytes());
}

/// What is known of a part's numbers before they are written.
struct Digest {
  std::uint64_t checksum = 0;
  std::size_t zeros = 0;
};

/// Of a part that holds nothing but zeros.
Digest digestOfZeros(std::size_t numbers) {
  Checksum checksum;
  const std::vector<std::int64_t> zeros(std::min<std::size_t>(numbers, 4096));
  for (std::size_t left = numbers; left > 0; left -= std::min(left, zeros.size()))
    addIntegers(checksum, {zeros.data(), std::min(left, zeros.size())});
  return {checksum.value(), numbers};
}

/// All parts take turns with each block of rows: those that are numbers of the same pixels find them in the cache.
std::vector<Digest> digestsOf(std::span<const SumsPart> parts, const SumsSource& source) {
  std::vector<Digest> digests(parts.size());
  std::vector<Checksum> checksums(parts.size());
  std::vector<std::int64_t> room;
  int tallest = 0;
  for (const SumsPart& part : parts)
    if (!part.blank) tallest = std::max(tallest, part.height);
  for (int row = 0; row < tallest; row += kBlockRows)
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const int rows = std::min(kBlockRows, parts[i].height - row);
      if (rows <= 0 || parts[i].blank) continue;
      const std::size_t width = static_cast<std::size_t>(parts[i].width);
      room.resize(std::max(room.size(), width * static_cast<std::size_t>(rows)));
      const std::span<std::int64_t> values(room.data(), width * static_cast<std::size_t>(rows));
      source(i, width * static_cast<std::size_t>(row), values);
      addIntegers(checksums[i], values);
      digests[i].zeros += static_cast<std::size_t>(std::ranges::count(values, std::int64_t{0}));
    }
  std::map<std::size_t, Digest> ofZeros;  // by size
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (!parts[i].blank)
      digests[i].checksum = checksums[i].value();
    else if (const std::size_t size = parts[i].size(); ofZeros.contains(size))
      digests[i] = ofZeros[size];
    else
      digests[i] = ofZeros[size] = digestOfZeros(size);
  return digests;
}

/// Whether runs of equal bytes are enough to make a part small: they take a small part of the work that ZIP does, but
/// find little in a part that is full. One without anything is packed only once, so that ZIP's work is none.
bool isNearlyEmpty(const SumsPart& part, const Digest& digest) {
  return digest.zeros > part.size() / 16 * 15 && digest.zeros < part.size();
}

void writePart(Imf::OutputPart output, const SumsPart& part, std::size_t index, const SumsSource& source) {
  Rows block(part);
  forBlocks(part, [&](int row, int rows) {
    const std::size_t count = block.sizeOf(rows);
    source(index, block.sizeOf(row), {block.values.data(), count});
    for (std::size_t i = 0; i < count; ++i) {
      const auto bits = static_cast<std::uint64_t>(block.values[i]);
      block.hi[i] = static_cast<std::uint32_t>(bits >> 32);
      block.lo[i] = static_cast<std::uint32_t>(bits);
    }
    output.setFrameBuffer(block.at(row, rows));
    output.writePixels(rows);
  });
}

/// The header of a part of a file whose first part is `first`: the display window of all must be the same.
Imf::Header headerOf(const SumsPart& part, const Digest& digest, const SumsPart& first) {
  const Imath::Box2i display({0, 0}, {first.width - 1, first.height - 1});
  Imf::Header header(display, Imath::Box2i({0, 0}, {part.width - 1, part.height - 1}));
  header.compression() = isNearlyEmpty(part, digest) ? Imf::RLE_COMPRESSION : Imf::ZIP_COMPRESSION;
  header.zipCompressionLevel() = 1;  // 0.6 times the work of the usual level; a file of many hits grows by 1 %
  header.setName(part.name);
  header.setType(Imf::SCANLINEIMAGE);
  for (const char* half : {"hi", "lo"}) header.channels().insert(half, Imf::Channel(Imf::UINT));
  return header;
}

/// A part of nothing but zeros, as it stands in a file. Others of its size are copied from it: packing the same zeros
/// again is what takes long.
class ZeroPart {
 public:
  explicit ZeroPart(const SumsPart& part) {
    const Imf::Header header = headerOf(part, {.zeros = part.size()}, part);
    Imf::StdOSStream packed;
    {
      Imf::MultiPartOutputFile writer(packed, &header, 1);
      writePart(Imf::OutputPart(writer, 0), part, 0,
                [](std::size_t, std::size_t, std::span<std::int64_t> values) { std::ranges::fill(values, 0); });
    }
    packed_.str(packed.str());
    file_.emplace(packed_);
  }

  void copyTo(Imf::OutputPart output) {
    Imf::InputPart input(*file_, 0);
    output.copyPixels(input);
  }

 private:
  Imf::StdISStream packed_;
  std::optional<Imf::MultiPartInputFile> file_;
};

void writeParts(Imf::MultiPartOutputFile& writer, std::span<const SumsPart> parts, std::span<const Digest> digests,
                const SumsSource& source) {
  std::map<std::pair<int, int>, ZeroPart> zeros;  // by size
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const SumsPart& part = parts[i];
    const Imf::OutputPart output(writer, static_cast<int>(i));
    if (digests[i].zeros == part.size())
      zeros.try_emplace({part.width, part.height}, part).first->second.copyTo(output);
    else
      writePart(output, part, i, source);
  }
}

/// All attributes of a file.
ExrAttributes completed(const ExrAttributes& attributes, std::span<const SumsPart> parts,
                        std::span<const Digest> digests) {
  ExrAttributes all{{kFormatKey, std::string(kFormat)}};
  for (const auto& [name, value] : attributes)
    all[name == "software" ? name : std::string(kOurPrefix).append(name)] = value;
  for (std::size_t i = 0; i < parts.size(); ++i)
    all[std::string(kPartPrefix).append(parts[i].name)] =
        std::to_string(parts[i].width) + "x" + std::to_string(parts[i].height) + " " + hexOf(digests[i].checksum);
  Checksum checksum;
  addMeaning(checksum, all);
  all[kChecksumKey] = hexOf(checksum.value());
  return all;
}

/// "300x200 0123456789abcdef" as a part and its checksum.
std::optional<std::pair<SumsPart, std::uint64_t>> partFrom(std::string name, std::string_view text) {
  SumsPart part{std::move(name)};
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, part.width);
  if (width.ec != std::errc{} || width.ptr == end || *width.ptr != 'x') return {};
  const auto height = std::from_chars(width.ptr + 1, end, part.height);
  if (height.ec != std::errc{} || height.ptr == end || *height.ptr != ' ') return {};
  const auto checksum = fromHex({height.ptr + 1, end});
  const auto fits = [](int side) { return side >= 1 && side <= kMaxImageSide; };
  if (!checksum || !fits(part.width) || !fits(part.height)) return {};
  return std::pair{std::move(part), *checksum};
}

bool isSumsHeader(const Imf::Header& header, const SumsPart& part) {
  const Imf::ChannelList& channels = header.channels();
  const Imf::Channel *hi = channels.findChannel("hi"), *lo = channels.findChannel("lo");
  return hi && lo && hi->type == Imf::UINT && lo->type == Imf::UINT && hi->xSampling == 1 && hi->ySampling == 1 &&
         lo->xSampling == 1 && lo->ySampling == 1 &&
         header.dataWindow() == Imath::Box2i({0, 0}, {part.width - 1, part.height - 1});
}

std::string checksumObjection(const std::string& what, std::uint64_t found, std::uint64_t stored) {
  return "damaged, or changed by another program: the checksum of " + what + " is " + hexOf(found) +
         ", and should be " + hexOf(stored);
}

}  // namespace

struct SumsExr::File {
  explicit File(const std::filesystem::path& path)
      : input(path.c_str(), 0, false) {}  // no threads, no guessing at missing scan lines

  Imf::MultiPartInputFile input;
  std::vector<int> numbers;  // in the file, by our parts
};

SumsPart listPart(std::string name, std::size_t numbers) {
  constexpr std::size_t kRow = 4096, kManyNumbers = kRow * kRow;
  const std::size_t width = numbers > kManyNumbers ? kMaxImageSide : std::clamp<std::size_t>(numbers, 1, kRow);
  return {std::move(name), static_cast<int>(width), std::max(1, static_cast<int>((numbers + width - 1) / width))};
}

void writeSumsExr(const Output& output, const ExrAttributes& attributes, std::span<const SumsPart> parts,
                  const SumsSource& source) {
  withExrErrors(output.path, [&] {
    const std::vector<Digest> digests = digestsOf(parts, source);
    std::vector<Imf::Header> headers;
    for (std::size_t i = 0; i < parts.size(); ++i) headers.push_back(headerOf(parts[i], digests[i], parts.front()));
    insertText(headers.front(), completed(attributes, parts, digests));
    AtomicFile file(output);
    {
      ExrOutput stream(output.path, file);
      Imf::MultiPartOutputFile writer(stream, headers.data(), static_cast<int>(headers.size()));
      writeParts(writer, parts, digests, source);
    }  // here OpenEXR writes its tables of scan lines
    file.commit();
  });
}

SumsExr::SumsExr(const std::filesystem::path& path) : path_(path) {
  requireSaneHeaders(path);
  withExrErrors(path, [&] {
    file_ = std::make_unique<File>(path);
    readHeader();
    requireParts();
  });
}

SumsExr::~SumsExr() = default;

void SumsExr::readHeader() {
  const ExrAttributes all = textOf(file_->input.header(0));
  const auto format = all.find(kFormatKey);
  if (format == all.end()) throw exrError(path_, "not a tally of Parhelion");
  if (format->second != kFormat)
    throw exrError(path_, "a tally of format " + format->second.substr(0, 20) + ", and this version reads format " +
                              std::string(kFormat) +
                              ": trace it again, with the scene that parhelion info --scene prints");
  const auto stored = all.find(kChecksumKey);
  const auto expected = stored == all.end() ? std::nullopt : fromHex(stored->second);
  if (!expected)
    throw exrError(path_, std::string("damaged: attribute ") + kChecksumKey + " is missing or no checksum");
  Checksum checksum;
  addMeaning(checksum, all);
  if (checksum.value() != *expected)
    throw exrError(path_, checksumObjection("its header", checksum.value(), *expected));
  for (const auto& [name, value] : all) {
    if (!name.starts_with(kOurPrefix) || name == kFormatKey || name == kChecksumKey) continue;
    if (!name.starts_with(kPartPrefix)) {
      attributes_[name.substr(kOurPrefix.size())] = value;
      continue;
    }
    auto part = partFrom(name.substr(kPartPrefix.size()), value);
    if (!part)
      throw exrError(path_,
                     "attribute " + name + " is '" + value.substr(0, 60) + "', and should be a size and a checksum");
    parts_.push_back(std::move(part->first));
    checksums_.push_back(part->second);
  }
}

void SumsExr::requireParts() {
  const Imf::MultiPartInputFile& file = file_->input;
  if (file.parts() != static_cast<int>(parts_.size()))
    throw exrError(path_, "damaged: it has " + std::to_string(file.parts()) + " parts, and its header names " +
                              std::to_string(parts_.size()));
  for (const SumsPart& part : parts_) {
    int number = 0;
    while (number < file.parts() && !(file.header(number).hasName() && file.header(number).name() == part.name))
      ++number;
    if (number == file.parts() || !isSumsHeader(file.header(number), part))
      throw exrError(path_, "damaged: part " + part.name + " is not as its header says");
    requireSaneSize(path_, file.header(number));
    file_->numbers.push_back(number);
  }
}

void SumsExr::read(std::size_t part, const std::function<void(std::size_t, std::span<const std::int64_t>)>& take) {
  withExrErrors(path_, [&] {
    Imf::InputPart input(file_->input, file_->numbers[part]);
    Checksum checksum;
    Rows block(parts_[part]);
    forBlocks(parts_[part], [&](int row, int rows) {
      input.setFrameBuffer(block.at(row, rows));
      input.readPixels(row, row + rows - 1);
      const std::size_t count = block.sizeOf(rows);
      for (std::size_t i = 0; i < count; ++i)
        block.values[i] = static_cast<std::int64_t>(static_cast<std::uint64_t>(block.hi[i]) << 32 | block.lo[i]);
      const std::span<const std::int64_t> values(block.values.data(), count);
      addIntegers(checksum, values);
      take(block.sizeOf(row), values);
    });
    if (checksum.value() != checksums_[part])
      throw exrError(path_, checksumObjection("part " + parts_[part].name, checksum.value(), checksums_[part]));
  });
}

}  // namespace parhelion
