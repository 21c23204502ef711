// SPDX-License-Identifier: Apache-2.0
#include "picture/png_read.h"

#include <png.h>

#include <array>
#include <bit>
#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>
#include <span>

#include "picture/chromaticities.h"
#include "picture/file_reason.h"
#include "picture/icc_profile.h"
#include "picture/limits.h"
#include "picture/png_chunks.h"

namespace parhelion {
namespace {

// Chunks of which we make nothing: names of kinds, each with its zero, one behind the other.
constexpr std::size_t kNameBytes = 5;
constexpr png_byte kUnused[] = "sPLT\0pCAL\0sCAL\0hIST\0bKGD\0sBIT\0oFFs\0pHYs\0tIME";

/// What libpng's callbacks share with us. They record; nothing is thrown through C.
struct Source {
  std::FILE* file = nullptr;
  bool badProfile = false;
  std::array<char, 256> message{};
};

void onError(png_structp png, png_const_charp message) {
  auto* source = static_cast<Source*>(png_get_error_ptr(png));
  if (source->message[0] == '\0') std::strncpy(source->message.data(), message, source->message.size() - 1);
  png_longjmp(png, 1);
}

void onWarning(png_structp png, png_const_charp message) {
  // libpng leaves a profile out that it finds fault with.
  if (std::strncmp(message, "iCCP", 4) == 0) static_cast<Source*>(png_get_error_ptr(png))->badProfile = true;
}

void onRead(png_structp png, png_bytep data, std::size_t bytes) {
  if (std::fread(data, 1, bytes, static_cast<Source*>(png_get_io_ptr(png))->file) != bytes) {
    png_error(png, "the file is cut short");
  }
}

// A jump from an error lands in one of the next functions and passes over C frames only: nothing in them has a
// destructor.

bool readInfo(png_structp png, png_infop info, Source* source, const std::string& large) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_read_fn(png, source, onRead);
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // we say what is too large
  png_set_chunk_malloc_max(png, kMostPngChunk);
  png_set_chunk_cache_max(png, kMostPngChunks);
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, kUnused, sizeof kUnused / kNameBytes);
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, reinterpret_cast<png_const_bytep>(large.data()),
                              static_cast<int>(large.size() / kNameBytes));
  png_read_info(png, info);
  return true;
}

/// Asks for RGB or RGBA of 8 bits or 16 in this machine's order. Returns how often the rows come, 0 after an error.
int startRows(png_structp png, png_infop info) {
  if (setjmp(png_jmpbuf(png))) return 0;
  png_set_expand(png);
  png_set_gray_to_rgb(png);
  if constexpr (std::endian::native == std::endian::little) png_set_swap(png);
  const int passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  return passes;
}

/// Goes over the rows to what stands behind them.
bool skipRows(png_structp png, png_infop info, int passes) {
  if (setjmp(png_jmpbuf(png))) return false;
  const png_uint_32 rows = png_get_image_height(png, info) * static_cast<png_uint_32>(passes);
  for (png_uint_32 row = 0; row < rows; ++row) png_read_row(png, nullptr, nullptr);
  png_read_end(png, info);
  return true;
}

bool readRows(png_structp png, png_infop info, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_read_image(png, rows);
  png_read_end(png, info);
  return true;
}

class PngReader {
 public:
  explicit PngReader(const std::filesystem::path& path) : path_(path), file_(std::fopen(path.c_str(), "rbe")) {
    if (!file_) throw pictureError(path, reasonFor(path, errno));
    source_.file = file_.get();
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source_, onError, onWarning);
    if (png_) info_ = png_create_info_struct(png_);
    if (!info_) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::bad_alloc();
    }
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  std::map<std::string, std::string> readText() {
    readHeader();
    return text();
  }

  StoredPicture read(int bytesForUse) {
    startPicture();
    const std::uint64_t bytes = isDeep() ? 2 : 1, pixelBytes = bytes * png_get_channels(png_, info_);
    requireMemoryFor(path_, pixels() * (pixelBytes + static_cast<unsigned>(bytesForUse)));
    Samples all = isDeep() ? samples<std::uint16_t>() : samples<std::uint8_t>();
    StoredPicture stored = frame();
    stored.picture.samples = std::move(all);
    return stored;
  }

  /// All but the samples, of which there is only the kind.
  StoredPicture readFrame() {
    startPicture();
    if (!skipRows(png_, info_, passes_)) fail();
    StoredPicture stored = frame();
    if (isDeep()) stored.picture.samples = std::vector<std::uint16_t>();
    return stored;
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void startPicture() {
    if (!readHeader()) throw pictureError(path_, "PNG: the file is damaged or cut short");
    requirePlausible();
    grey_ = (png_get_color_type(png_, info_) & PNG_COLOR_MASK_COLOR) == 0;
    passes_ = startRows(png_, info_);
    if (passes_ == 0) fail();
  }

  /// What stands around the pixels, before them or behind.
  StoredPicture frame() const {
    StoredPicture stored;
    stored.picture.width = static_cast<int>(png_get_image_width(png_, info_));
    stored.picture.height = static_cast<int>(png_get_image_height(png_, info_));
    stored.picture.channels = png_get_channels(png_, info_);
    stored.picture.text = text();
    stored.exif = exif();
    stored.objection = objection();
    return stored;
  }

  std::uint64_t pixels() const {
    return std::uint64_t{png_get_image_width(png_, info_)} * png_get_image_height(png_, info_);
  }

  /// Whether all chunks are there.
  bool readHeader() {
    const PngChunks chunks = walkPng(source_.file);
    if (chunks.large.contains("eXIf")) throw pictureError(path_, "PNG: its Exif block is larger than any camera's");
    source_.badProfile = chunks.large.contains("iCCP");
    std::string large;
    for (const std::string& kind : chunks.large) large.append(kind).push_back('\0');
    if (!readInfo(png_, info_, &source_, large)) fail();
    return chunks.whole;
  }

  bool isDeep() const { return png_get_bit_depth(png_, info_) == 16; }

  [[noreturn]] void fail() const { throw pictureError(path_, std::string("PNG: ") + source_.message.data()); }

  void requirePlausible() const {
    const std::uint64_t width = png_get_image_width(png_, info_), height = png_get_image_height(png_, info_);
    requireReadableSize(path_, static_cast<std::int64_t>(width), static_cast<std::int64_t>(height));
    const std::uint64_t pixelBits =
        static_cast<std::uint64_t>(png_get_bit_depth(png_, info_)) * png_get_channels(png_, info_);
    const std::uint64_t rawBytes = ((width * pixelBits + 7) / 8 + 1) * height;
    requireFileBytes(path_, std::filesystem::file_size(path_), rawBytes / kMostDeflated);
  }

  template <typename Sample>
  Samples samples() {
    const std::size_t rowSamples =
        static_cast<std::size_t>(png_get_image_width(png_, info_)) * png_get_channels(png_, info_);
    const std::size_t height = png_get_image_height(png_, info_);
    std::vector<Sample> all(rowSamples * height);
    std::vector<png_bytep> rows(height);
    for (std::size_t y = 0; y < height; ++y) rows[y] = reinterpret_cast<png_bytep>(all.data() + rowSamples * y);
    if (!readRows(png_, info_, rows.data())) fail();
    return all;
  }

  std::map<std::string, std::string> text() const {
    std::map<std::string, std::string> all;
    png_textp chunks = nullptr;
    int count = 0;
    png_get_text(png_, info_, &chunks, &count);
    for (int i = 0; i < count; ++i) all.emplace(chunks[i].key, chunks[i].text ? chunks[i].text : "");
    return all;
  }

  std::vector<std::uint8_t> exif() const {
    png_bytep data = nullptr;
    png_uint_32 size = 0;
    if (png_get_eXIf_1(png_, info_, &size, &data) == 0) return {};
    return {data, data + size};
  }

  /// A profile counts first, then the sRGB chunk, then gAMA and cHRM (PNG specification, 3rd edition, 4.3).
  std::string objection() const {
    png_charp name = nullptr;
    png_bytep profile = nullptr;
    png_uint_32 size = 0;
    int ignored = 0;
    if (png_get_iCCP(png_, info_, &name, &ignored, &profile, &size) != 0) {
      return profileObjection(std::span(profile, size), grey_);
    }
    if (png_get_sRGB(png_, info_, &ignored) != 0) return {};
    if (source_.badProfile) return profileObjection({}, grey_);

    double gamma = 0.0;
    if (png_get_gAMA(png_, info_, &gamma) != 0) {
      if (std::string objection = gammaObjection(gamma); !objection.empty()) return objection;
    }
    std::array<double, 8> c{};
    if (grey_ || png_get_cHRM(png_, info_, &c[6], &c[7], &c[0], &c[1], &c[2], &c[3], &c[4], &c[5]) == 0) return {};
    return chromaticitiesObjection({{c[0], c[1]}, {c[2], c[3]}, {c[4], c[5]}, {c[6], c[7]}});
  }

  const std::filesystem::path& path_;
  std::unique_ptr<std::FILE, Close> file_;
  Source source_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  bool grey_ = false;
  int passes_ = 0;  // over the rows
};

}  // namespace

StoredPicture readPng(const std::filesystem::path& path, int bytesForUse) { return PngReader(path).read(bytesForUse); }

StoredPicture readPngFrame(const std::filesystem::path& path) { return PngReader(path).readFrame(); }

std::map<std::string, std::string> readPngText(const std::filesystem::path& path) { return PngReader(path).readText(); }

}  // namespace parhelion
