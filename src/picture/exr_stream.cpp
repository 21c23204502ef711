// SPDX-License-Identifier: Apache-2.0
#include "picture/exr_stream.h"

#include <ImfBoxAttribute.h>
#include <ImfChannelList.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>

#include "math/range.h"
#include "picture/file_reason.h"
#include "picture/limits.h"

namespace parhelion {
namespace {

/// Scan lines that a codec packs as one block.
int rowsTogether(Imf::Compression codec) {
  switch (codec) {
    case Imf::ZIP_COMPRESSION:
    case Imf::PXR24_COMPRESSION:
      return 16;
    case Imf::PIZ_COMPRESSION:
    case Imf::B44_COMPRESSION:
    case Imf::B44A_COMPRESSION:
    case Imf::DWAA_COMPRESSION:
      return 32;
    case Imf::DWAB_COMPRESSION:
      return 256;
    default:
      return 1;
  }
}

/// Bytes of a value, by the attribute's type. OpenEXR reads so many, whatever size the file states.
struct TypeSize {
  std::string_view type;
  std::uint32_t bytes;
};
constexpr std::array kTypeSizes{
    TypeSize{"box2f", 16},      TypeSize{"box2i", 16},   TypeSize{"chromaticities", 32},
    TypeSize{"compression", 1}, TypeSize{"double", 8},   TypeSize{"deepImageState", 1},
    TypeSize{"envmap", 1},      TypeSize{"float", 4},    TypeSize{"int", 4},
    TypeSize{"keycode", 28},    TypeSize{"m33d", 72},    TypeSize{"m33f", 36},
    TypeSize{"lineOrder", 1},   TypeSize{"m44d", 128},   TypeSize{"m44f", 64},
    TypeSize{"rational", 8},    TypeSize{"timecode", 8}, TypeSize{"v2d", 16},
    TypeSize{"v2f", 8},         TypeSize{"v2i", 8},      TypeSize{"v3d", 24},
    TypeSize{"v3f", 12},        TypeSize{"v3i", 12},
};

/// Walks through the headers of an EXR file. OpenEXR file layout, "Header": attributes are name, type, size, value;
/// an empty name ends a header, in a multi-part file another empty name ends the list of headers.
class HeaderWalk {
 public:
  explicit HeaderWalk(const std::filesystem::path& path) : path_(path), stream_(path, std::ios::binary) {
    if (!stream_) throw exrError(path, reasonFor(path, errno));
    size_ = std::filesystem::file_size(path);
  }

  void run() {
    constexpr std::uint32_t kMagic = 20000630, kTiled = 0x200, kDeep = 0x800, kMultiPart = 0x1000;
    if (number() != kMagic || !stream_) throw exrError(path_, "not an EXR file");
    const std::uint32_t flags = number();
    if ((flags & (kTiled | kDeep)) != 0) notFlat();
    int parts = 0;
    std::uint64_t tables = 0;
    do {
      part_ = {};
      while (attribute()) continue;
      // OpenEXR makes room for a part's table before it sees whether the file has one.
      tables += part_.bytesOfTable();
      if (tables > size_) throw exrError(path_, "the headers promise more scan lines than the file can hold");
      if (++parts > kMostExrParts)
        throw exrError(path_, "more than " + std::to_string(kMostExrParts) + " parts are not read");
    } while ((flags & kMultiPart) != 0 && stream_.peek() != 0);
  }

 private:
  /// What a header says of its part's table, which has eight bytes for each block of scan lines.
  struct Part {
    std::int64_t rows = 0, rowsTogether = 1, blocks = 0;

    std::uint64_t bytesOfTable() const {
      return 8 * static_cast<std::uint64_t>(std::max({std::int64_t{0}, blocks, (rows - 1) / rowsTogether + 1}));
    }
  };

  /// Of an attribute that Part is about.
  void note(const std::string& name, const std::string& type) {
    if (name == "dataWindow" && type == "box2i") {
      number();
      const auto top = static_cast<std::int32_t>(number());
      number();
      part_.rows = std::int64_t{static_cast<std::int32_t>(number())} - top + 1;
    } else if (name == "compression" && type == "compression") {
      part_.rowsTogether = rowsTogether(static_cast<Imf::Compression>(stream_.get()));
    } else if (name == "chunkCount" && type == "int") {
      part_.blocks = static_cast<std::int32_t>(number());
    }
  }

  std::uint32_t number() {  // little endian
    std::array<unsigned char, 4> b{};
    stream_.read(reinterpret_cast<char*>(b.data()), b.size());
    return b[0] | b[1] << 8 | b[2] << 16 | static_cast<std::uint32_t>(b[3]) << 24;
  }

  std::string name() {
    constexpr std::size_t kLongest = 255;
    std::string text;
    for (int c = stream_.get(); c != 0; c = stream_.get()) {
      if (!stream_ || text.size() == kLongest) damaged();
      text.push_back(static_cast<char>(c));
    }
    return text;
  }

  /// Steps over an attribute; false at the end of a header.
  bool attribute() {
    const std::string attribute = name();
    if (attribute.empty()) return false;
    const std::string type = name();
    const std::uint32_t bytes = number();
    if (!stream_ || bytes > size_ - static_cast<std::uint64_t>(stream_.tellg())) damaged();
    // These carry sizes of their own inside, which OpenEXR trusts.
    if (type == "stringvector" || type == "idmanifest")
      throw exrError(path_, "attributes of type " + type + " are not read");
    if (type == "tiledesc") notFlat();
    const std::streamoff end = stream_.tellg() + static_cast<std::streamoff>(bytes);
    if (!fits(type, bytes)) damaged();
    stream_.seekg(end - static_cast<std::streamoff>(bytes));
    note(attribute, type);
    stream_.seekg(end);
    return true;
  }

  /// Whether OpenEXR will read as many bytes of a value as the file states. Else it would go on with the next attribute
  /// at another place than this walk, and find sizes there that nobody has looked at.
  bool fits(const std::string& type, std::uint32_t bytes) {
    const auto* const fixed = std::ranges::find(kTypeSizes, type, &TypeSize::type);
    if (fixed != kTypeSizes.end()) return bytes == fixed->bytes;
    if (type == "floatvector") return bytes % sizeof(float) == 0;
    if (type == "chlist") return channelBytes() == bytes;
    if (type != "preview") return true;
    const std::uint64_t width = number(), height = number();
    constexpr std::uint64_t kOfPixel = 4, kSides = 8;
    return stream_ && width <= bytes && height <= bytes && kSides + kOfPixel * width * height == bytes;
  }

  /// Bytes of the list of channels that comes next: names with what is known of each, up to an empty name.
  std::uint64_t channelBytes() {
    constexpr std::streamoff kOfChannel = 16;  // type, linearity, sampling
    const std::streamoff start = stream_.tellg();
    while (!name().empty()) stream_.seekg(kOfChannel, std::ios::cur);
    return static_cast<std::uint64_t>(stream_.tellg() - start);
  }

  [[noreturn]] void notFlat() const { throw exrError(path_, "only flat EXR files of scan lines are read"); }
  [[noreturn]] void damaged() const { throw exrError(path_, "the EXR header is damaged or cut off"); }

  const std::filesystem::path& path_;
  std::ifstream stream_;
  std::uint64_t size_ = 0;
  Part part_;
};

}  // namespace

std::runtime_error exrError(const std::filesystem::path& path, std::string reason) {
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  return std::runtime_error(path.string() + ": " + reason);
}

void requireSaneHeaders(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (error) throw exrError(path, reasonFor(path, error.value()));
  if (!std::filesystem::is_regular_file(status)) throw exrError(path, "not a regular file");
  HeaderWalk(path).run();
  Imf::Header::setMaxImageSize(kMaxImageSide, kMaxImageSide);
}

void requireSaneSize(const std::filesystem::path& path, const Imf::Header& header) {
  if ((header.hasType() && header.type() != Imf::SCANLINEIMAGE) || header.hasTileDescription()) {
    throw exrError(path, "only flat EXR files of scan lines are read");
  }
  const Imath::Box2i& window = header.dataWindow();
  const auto width = static_cast<std::uint64_t>(window.max.x - window.min.x) + 1;
  const auto height = static_cast<std::uint64_t>(window.max.y - window.min.y) + 1;
  if (width * height > static_cast<std::uint64_t>(kMaxImagePixels)) throw exrError(path, "the picture is too large");

  std::uint64_t sampleBytes = 0;
  int channels = 0;
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
    if (c.channel().xSampling != 1 || c.channel().ySampling != 1) {
      throw exrError(path, "subsampled channels are not read");
    }
    sampleBytes += 4;
    if (++channels > kMostExrChannels)
      throw exrError(path, "more than " + std::to_string(kMostExrChannels) + " channels are not read");
  }
  const Imf::Compression codec = header.compression();
  const bool byBlocks = codec == Imf::DWAA_COMPRESSION || codec == Imf::DWAB_COMPRESSION;
  const std::uint64_t mostCompressed = kMostExrDeflated * (byBlocks ? kDwaBlock : 1);
  if (width * height * sampleBytes / mostCompressed > std::filesystem::file_size(path)) {
    throw exrError(path, "the header promises more pixels than the file can hold");
  }
}

int rowsTogether(const Imf::Header& header) { return rowsTogether(header.compression()); }

std::uint64_t rowMemory(const Imf::Header& header) {
  const Imath::Box2i& window = header.dataWindow();
  const auto width = static_cast<std::uint64_t>(window.max.x - window.min.x) + 1;
  std::uint64_t channels = 0;
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c) ++channels;
  return 2 * sizeof(float) * width * channels * static_cast<std::uint64_t>(rowsTogether(header));
}

void insertText(Imf::Header& header, const ExrAttributes& attributes) {
  for (const auto& [name, value] : attributes)
    if (name != kWhiteLuminanceKey) header.insert(name, Imf::StringAttribute(value));
  if (const std::optional<double> white = whiteLuminanceOf(attributes))
    Imf::addWhiteLuminance(header, static_cast<float>(*white));
}

ExrAttributes textOf(const Imf::Header& header) {
  ExrAttributes attributes;
  for (auto a = header.begin(); a != header.end(); ++a) {
    const std::string name = a.name();
    if (name == "type" || name == "name") continue;  // EXR's own, of the part
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute())) attributes[name] = text->value();
  }
  if (Imf::hasWhiteLuminance(header)) attributes[kWhiteLuminanceKey] = formatNumber(Imf::whiteLuminance(header));
  return attributes;
}

}  // namespace parhelion
