// SPDX-License-Identifier: Apache-2.0
#pragma once

// What reading and writing EXR files have in common: the way to the disk, and OpenEXR's errors.

#include <Iex.h>
#include <ImfHeader.h>
#include <ImfIO.h>

#include <cstdint>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>

#include "picture/atomic_file.h"
#include "picture/exr.h"

namespace parhelion {

/// Lets OpenEXR write into an AtomicFile.
class ExrOutput : public Imf::OStream {
 public:
  ExrOutput(const std::filesystem::path& path, AtomicFile& file) : OStream(path.c_str()), file_(file) {}
  void write(const char bytes[], int count) override { file_.write(bytes, static_cast<std::size_t>(count)); }
  std::uint64_t tellp() override { return file_.tell(); }
  void seekp(std::uint64_t position) override { file_.seek(position); }

 private:
  AtomicFile& file_;
};

/// "path: reason" on one line.
std::runtime_error exrError(const std::filesystem::path& path, std::string reason);

/// Calls `work` and turns OpenEXR's exceptions, and an exhausted memory, into exrError.
template <typename Work>
auto withExrErrors(const std::filesystem::path& path, Work work) {
  try {
    return work();
  } catch (const Iex::BaseExc& e) {
    throw exrError(path, e.what());
  } catch (const std::bad_alloc&) {
    throw exrError(path, "not enough memory");
  } catch (const std::logic_error& e) {  // settings and sizes that make no sense
    throw exrError(path, e.what());
  }
}

/// Throws exrError unless the file is an EXR of flat scan lines whose headers hold only attributes that fit into the
/// file, and no more parts than limits.h has. OpenEXR itself would allocate what a lying attribute promises, and tables
/// for all tiles that a header makes up.
void requireSaneHeaders(const std::filesystem::path& path);

/// Throws exrError unless the part is a flat scan-line picture of a size we accept that the file can hold.
void requireSaneSize(const std::filesystem::path& path, const Imf::Header& header);

/// Rows that the compression of a part packs together.
int rowsTogether(const Imf::Header& header);

/// Bytes that OpenEXR takes for such rows, packed and not, of all channels: also of those that nobody asks for.
std::uint64_t rowMemory(const Imf::Header& header);

/// Text attributes to and from a header; a part's name and type are not among them.
void insertText(Imf::Header& header, const ExrAttributes& attributes);
ExrAttributes textOf(const Imf::Header& header);

}  // namespace parhelion
