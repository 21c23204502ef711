// SPDX-License-Identifier: Apache-2.0
#include "picture/jpeg.h"

#include <turbojpeg.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <memory>

#include "picture/atomic_file.h"
#include "picture/file_reason.h"
#include "picture/icc_profile.h"
#include "picture/jpeg_segments.h"
#include "picture/limits.h"

namespace parhelion {
namespace {

struct Destroy {
  void operator()(void* handle) const { tjDestroy(handle); }
};
struct Free {
  void operator()(unsigned char* bytes) const { tjFree(bytes); }
};
using Handle = std::unique_ptr<void, Destroy>;
using LibraryBytes = std::unique_ptr<unsigned char, Free>;

std::runtime_error jpegError(const std::filesystem::path& path, const Handle& handle) {
  return pictureError(path, std::string("JPEG: ") + tjGetErrorStr2(handle.get()));
}

std::vector<std::uint8_t> fileBytes(const std::filesystem::path& path) {
  const std::uintmax_t size = std::filesystem::file_size(path);
  if (size > kMostJpegBytes) throw pictureError(path, "the file is too large for a JPEG");
  std::vector<std::uint8_t> bytes(size);
  std::ifstream stream(path, std::ios::binary);
  if (!stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size))) {
    throw pictureError(path, reasonFor(path, errno));
  }
  return bytes;
}

/// Throws unless it is a picture we read, of a size that the file can hold. Takes no memory for it.
void requireReadable(const std::filesystem::path& path, const Handle& handle, const std::vector<std::uint8_t>& bytes,
                     const JpegSegments& segments) {
  const std::optional<JpegFrame>& frame = segments.frame;
  int width = 0, height = 0, subsampling = 0, colours = 0;
  const int result =
      tjDecompressHeader3(handle.get(), bytes.data(), bytes.size(), &width, &height, &subsampling, &colours);
  // Unusual subsampling counts as an error here only, and comes with the size.
  if (result != 0 && width == 0) throw jpegError(path, handle);
  if (!frame || frame->width != width || frame->height != height) throw pictureError(path, "the JPEG is damaged");
  constexpr int kBaseline = 0xC0, kProgressive = 0xC2;
  if (frame->marker < kBaseline || frame->marker > kProgressive) {
    throw pictureError(path, "JPEGs with arithmetic coding are not read");
  }
  if (frame->components.size() == 4) throw pictureError(path, "its colours are CMYK; only grey and RGB are read");
  if (frame->components.size() != 1 && frame->components.size() != 3) {
    throw pictureError(path, "JPEGs of " + std::to_string(frame->components.size()) + " components are not read");
  }
  if (segments.scans > kMostJpegScans)
    throw pictureError(path, "JPEGs of more than " + std::to_string(kMostJpegScans) + " scans are not read");
  requireReadableSize(path, width, height);
  requireFileBytes(path, bytes.size(), leastJpegBytes(*frame));
}

std::vector<std::uint8_t> decompressed(const std::filesystem::path& path, const Handle& handle,
                                       const std::vector<std::uint8_t>& bytes, const JpegSegments& segments) {
  const int width = segments.frame->width, height = segments.frame->height;
  std::vector<std::uint8_t> rgb(std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  if (tjDecompress2(handle.get(), bytes.data(), bytes.size(), rgb.data(), width, 0, height, TJPF_RGB,
                    TJFLAG_ACCURATEDCT | TJFLAG_LIMITSCANS) == 0) {
    return rgb;
  }
  // The library tells its first warning only; that the file ends early could hide behind a harmless one.
  const std::string message = tjGetErrorStr2(handle.get());
  const bool harmless = tjGetErrorCode(handle.get()) == TJERR_WARNING && segments.complete &&
                        message.find("extraneous bytes before marker") != std::string::npos;
  if (!harmless) throw pictureError(path, "the JPEG is damaged or cut short: " + message);
  return rgb;
}

class JpegReader {
 public:
  explicit JpegReader(const std::filesystem::path& path)
      : path_(path), bytes_(fileBytes(path)), segments_(walkJpeg(bytes_)), handle_(tjInitDecompress()) {
    if (!handle_) throw std::bad_alloc();
    requireReadable(path, handle_, bytes_, segments_);
  }

  /// All but the samples.
  StoredPicture frame() const {
    StoredPicture stored;
    stored.picture.width = segments_.frame->width;
    stored.picture.height = segments_.frame->height;
    stored.exif = segments_.exif;
    if (segments_.damagedProfile || !segments_.profile.empty())
      stored.objection = profileObjection(segments_.profile, segments_.frame->components.size() == 1);
    return stored;
  }

  /// What samples() and the use of each pixel take. A picture in several scans is kept as coefficients first.
  std::uint64_t memory(int bytesForUse) const {
    constexpr std::uint64_t kRgb = 3, kCoefficients = 3 * sizeof(std::int16_t);
    const auto pixels =
        static_cast<std::uint64_t>(segments_.frame->width) * static_cast<std::uint64_t>(segments_.frame->height);
    const std::uint64_t coefficients = segments_.scans > 1 ? kCoefficients : 0;
    return bytes_.size() + pixels * (kRgb + coefficients + static_cast<std::uint64_t>(bytesForUse));
  }

  std::vector<std::uint8_t> samples() const { return decompressed(path_, handle_, bytes_, segments_); }

 private:
  const std::filesystem::path& path_;
  std::vector<std::uint8_t> bytes_;
  JpegSegments segments_;
  Handle handle_;
};

/// A marker segment of an APPn or COM.
void writeSegment(AtomicFile& file, int marker, std::string_view start, std::string_view payload) {
  const std::size_t length = 2 + start.size() + payload.size();
  const std::array<char, 4> head{'\xff', static_cast<char>(marker), static_cast<char>(length >> 8),
                                 static_cast<char>(length & 0xff)};
  file.write(head.data(), head.size());
  file.write(start);
  file.write(payload);
}

}  // namespace

StoredPicture readJpeg(const std::filesystem::path& path, int bytesForUse) {
  JpegReader reader(path);
  StoredPicture stored = reader.frame();
  requireMemoryFor(path, reader.memory(bytesForUse));
  stored.picture.samples = reader.samples();
  return stored;
}

StoredPicture readJpegFrame(const std::filesystem::path& path) { return JpegReader(path).frame(); }

std::string readJpegComments(const std::filesystem::path& path) {
  std::string all;
  for (const std::string& comment : walkJpeg(fileBytes(path)).comments) all += (all.empty() ? "" : "\n") + comment;
  return all;
}

void writeJpeg(const Output& output, int width, int height, const std::vector<std::uint8_t>& rgb,
               std::string_view comment) {
  constexpr int kQuality = 95;
  AtomicFile file(output);
  const Handle handle(tjInitCompress());
  if (!handle) throw std::bad_alloc();
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  const int result = tjCompress2(handle.get(), rgb.data(), width, 0, height, TJPF_RGB, &buffer, &size, TJSAMP_444,
                                 kQuality, TJFLAG_ACCURATEDCT);
  const LibraryBytes owner(buffer);
  if (result != 0) throw jpegError(output.path, handle);

  // The library's file starts with SOI and the JFIF segment, which must come first; ours follow.
  const std::string_view jpeg(reinterpret_cast<const char*>(buffer), size);
  const std::size_t start = 4 + static_cast<std::size_t>(buffer[4] << 8 | buffer[5]);
  constexpr int kApp2 = 0xE2, kComment = 0xFE;
  constexpr std::size_t kLongest = 65533;
  const std::vector<std::uint8_t> profile = srgbProfile();
  file.write(jpeg.substr(0, start));
  writeSegment(file, kApp2, std::string_view("ICC_PROFILE\0\1\1", 14),
               {reinterpret_cast<const char*>(profile.data()), profile.size()});
  if (!comment.empty()) writeSegment(file, kComment, "", comment.substr(0, kLongest));
  file.write(jpeg.substr(start));
  file.commit();
}

}  // namespace parhelion
