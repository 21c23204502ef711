// SPDX-License-Identifier: Apache-2.0
#include "sky/tally_exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>

#include <array>
#include <vector>

#include "picture/exr_stream.h"
#include "picture/limits.h"
#include "sky/tally_info_text.h"

namespace parhelion {
namespace {

constexpr std::array<const char*, 6> kPartNames = {"Y", "Y.firstHalf", "Y.squares", "hits", "X", "Z"};
constexpr int kBlockRows = 16;  // ZIP compresses so many scan lines together

/// Some rows of one number of a tally, split into the halves that EXR can hold.
struct Rows {
  std::vector<std::uint32_t> hi, lo;
  int width, first;

  Rows(int pictureWidth, int rows)
      : hi(static_cast<std::size_t>(pictureWidth) * static_cast<std::size_t>(rows)),
        lo(hi.size()),
        width(pictureWidth) {}

  Imf::FrameBuffer at(int row, int rows) {
    first = row;
    const Imath::Box2i window({0, row}, {width - 1, row + rows - 1});
    Imf::FrameBuffer buffer;
    buffer.insert("hi", Imf::Slice::Make(Imf::UINT, hi.data(), window));
    buffer.insert("lo", Imf::Slice::Make(Imf::UINT, lo.data(), window));
    return buffer;
  }
};

Imf::Header partHeader(const Tally& tally, int slot) {
  Imf::Header header(tally.width(), tally.height());
  header.compression() = Imf::ZIP_COMPRESSION;
  header.setName(kPartNames[static_cast<std::size_t>(slot)]);
  header.setType(Imf::SCANLINEIMAGE);
  for (const char* half : {"hi", "lo"}) header.channels().insert(half, Imf::Channel(Imf::UINT));
  if (slot == 0) insertText(header, textFromInfo(tally.info));
  return header;
}

void writeSlot(Imf::OutputPart part, const Tally& tally, int slot) {
  Rows block(tally.width(), kBlockRows);
  for (int row = 0; row < tally.height(); row += kBlockRows) {
    const int rows = std::min(kBlockRows, tally.height() - row);
    for (int i = 0; i < rows * tally.width(); ++i) {
      const auto bits = static_cast<std::uint64_t>(tally.raw(row * tally.width() + i, slot));
      block.hi[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(bits >> 32);
      block.lo[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(bits);
    }
    part.setFrameBuffer(block.at(row, rows));
    part.writePixels(rows);
  }
}

void readSlot(Imf::InputPart part, Tally& tally, int slot) {
  Rows block(tally.width(), kBlockRows);
  for (int row = 0; row < tally.height(); row += kBlockRows) {
    const int rows = std::min(kBlockRows, tally.height() - row);
    part.setFrameBuffer(block.at(row, rows));
    part.readPixels(row, row + rows - 1);
    for (int i = 0; i < rows * tally.width(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      const std::uint64_t bits = static_cast<std::uint64_t>(block.hi[k]) << 32 | block.lo[k];
      tally.setRaw(row * tally.width() + i, slot, static_cast<std::int64_t>(bits));
    }
  }
}

/// Throws exrError unless the parts are those that writeTallyExr makes, all of the first one's size.
void requireTallyParts(const std::filesystem::path& path, const Imf::MultiPartInputFile& file) {
  const auto fits = [&file](int slot) {
    const Imf::Header& header = file.header(slot);
    const Imf::ChannelList& channels = header.channels();
    const Imf::Channel *hi = channels.findChannel("hi"), *lo = channels.findChannel("lo");
    return header.hasName() && header.name() == kPartNames[static_cast<std::size_t>(slot)] && hi && lo &&
           hi->type == Imf::UINT && lo->type == Imf::UINT && header.dataWindow() == file.header(0).dataWindow();
  };
  bool good = (file.parts() == 4 || file.parts() == 6) && file.header(0).dataWindow().min == Imath::V2i(0, 0);
  for (int slot = 0; good && slot < file.parts(); ++slot) {
    good = fits(slot);
    if (good) requireSaneSize(path, file.header(slot));
  }
  if (!good) throw exrError(path, "not a tally of Parhelion");
}

}  // namespace

void writeTallyExr(const std::filesystem::path& path, const Tally& tally) {
  withExrErrors(path, [&] {
    std::vector<Imf::Header> headers;
    for (int slot = 0; slot < tally.slots(); ++slot) headers.push_back(partHeader(tally, slot));
    AtomicFile file(path);
    {
      ExrOutput stream(path, file);
      Imf::MultiPartOutputFile output(stream, headers.data(), tally.slots());
      for (int slot = 0; slot < tally.slots(); ++slot) writeSlot(Imf::OutputPart(output, slot), tally, slot);
    }  // here OpenEXR writes its tables of scan lines
    file.commit();
  });
}

Tally readTallyExr(const std::filesystem::path& path) {
  requireSaneHeaders(path);
  return withExrErrors(path, [&] {
    Imf::MultiPartInputFile file(path.c_str(), 0, false);  // no threads, no guessing at missing scan lines
    requireTallyParts(path, file);
    TallyInfo info = infoFromText(textOf(file.header(0)));
    info.camera.width = file.header(0).dataWindow().max.x + 1;
    info.camera.height = file.header(0).dataWindow().max.y + 1;
    const auto pixels = static_cast<std::uint64_t>(info.camera.width) * static_cast<std::uint64_t>(info.camera.height);
    requireMemoryFor(path, pixels * sizeof(std::int64_t) * static_cast<unsigned>(file.parts()));
    Tally tally(std::move(info), file.parts() == 4 ? 1 : 3);
    for (int slot = 0; slot < tally.slots(); ++slot) readSlot(Imf::InputPart(file, slot), tally, slot);
    return tally;
  });
}

}  // namespace parhelion
