// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

#include "memory_taken.h"
#include "picture/photograph.h"
#include "picture_files.h"
#include "temporary_directory.h"

namespace parhelion {
namespace {

/// Reading must end in a picture or in one line with the path, never in anything else. Returns the reason, or "".
std::string reasonOf(const std::filesystem::path& path, const std::string& bytes) {
  std::filesystem::remove(path);  // some file systems take long to write into a file that is there
  put(path, bytes);
  const std::string error = errorOf([&] { readPhotograph(path); });
  CAPTURE(error);
  if (error.empty()) return {};
  CHECK(error.find(path.string() + ": ") == 0);
  CHECK(error.find_first_of("\n\r") == std::string::npos);
  CHECK(error.size() > path.string().size() + 5);
  return error.substr(path.string().size() + 2);
}

/// Deflated spaces, made without ever having them all.
std::string deflatedSpaces(std::size_t count) {
  std::string spaces(std::size_t{1} << 16, ' '), packed(count / 100 + 1000, '\0');
  z_stream stream{};
  deflateInit(&stream, 1);
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  for (std::size_t left = count; left > 0; left -= std::min(left, spaces.size())) {
    stream.next_in = reinterpret_cast<Bytef*>(spaces.data());
    stream.avail_in = static_cast<uInt>(std::min(left, spaces.size()));
    deflate(&stream, left <= spaces.size() ? Z_FINISH : Z_NO_FLUSH);
  }
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

std::string soundJpeg(int flags = 0) {
  return jpegFile(noiseSamples<std::uint8_t>(3 * 50 * 40), 50, 40, TJPF_RGB, TJSAMP_420, flags);
}

std::string soundPng() {
  return pngFile({20, 30}, scanLines(asText(noiseSamples<std::uint8_t>(3 * 20 * 30)), 60),
                 pngChunk("iCCP", std::string("profile\0\0", 9) + deflated(profileBytes(cmsCreate_sRGBProfile()))) +
                     pngChunk("eXIf", exifBlock(3)) + pngChunk("tEXt", std::string("Title\0sky", 9)));
}

std::string soundExr(const TemporaryDirectory& directory) {
  Photograph photograph{16, 20, 3, noiseSamples<std::uint8_t>(3 * 16 * 20), {}, {}};
  writePhotograph(directory / "sound.exr", photograph, {{"parhelion:scene", "[sun]"}});
  return contents(directory / "sound.exr");
}

/// The bytes of a picture are refused when they are cut short at any percent or by their last, and only then.
void checkCuts(const std::filesystem::path& path, const std::string& whole) {
  for (std::size_t percent = 0; percent < 100; ++percent) {
    CAPTURE(percent);
    CHECK(reasonOf(path, whole.substr(0, whole.size() * percent / 100)) != "");
  }
  CHECK(reasonOf(path, whole.substr(0, whole.size() - 1)) != "");
  CHECK(reasonOf(path, whole) == "");
}

}  // namespace

TEST_CASE("a JPEG cut short at every percent is refused in one line") {
  const TemporaryDirectory directory;
  for (const int flags : {0, TJFLAG_PROGRESSIVE}) checkCuts(directory / "cut.jpg", soundJpeg(flags));
}

TEST_CASE("a PNG and an EXR cut short at every percent are refused in one line") {
  const TemporaryDirectory directory;
  for (const std::string& whole : {soundPng(), soundExr(directory)}) checkCuts(directory / "cut", whole);
}

TEST_CASE("pictures damaged anywhere end in an error or a picture, never in a crash") {
  const TemporaryDirectory directory;
  const std::vector<std::string> sound{soundJpeg(), soundJpeg(TJFLAG_PROGRESSIVE), soundPng(), soundExr(directory)};
  std::mt19937 random(11);
  int refused = 0;
  constexpr int kRounds = 2000;
  for (int i = 0; i < kRounds; ++i) {
    std::string bytes = sound[static_cast<std::size_t>(i) % sound.size()];
    const std::size_t range = i % 3 == 0 ? bytes.size() : std::min<std::size_t>(bytes.size(), 700);  // lies are here
    for (int k = 0; k <= i % 5; ++k) bytes[random() % range] = static_cast<char>(i % 7 == 0 ? 0xff : random());
    refused += reasonOf(directory / "bad", bytes).empty() ? 0 : 1;
  }
  CHECK(refused > kRounds / 4);
  CHECK(refused < kRounds);
}

TEST_CASE("headers that lie about the size are refused before memory is taken") {
  const TemporaryDirectory directory;
  const auto path = directory / "bad";
  const auto png = [](std::uint32_t width, std::uint32_t height) { return pngFile({width, height}, "x"); };
  const auto jpeg = [](int width, int height) { return withJpegSize(soundJpeg(), width, height); };
  const std::string progressive = withJpegSize(soundJpeg(TJFLAG_PROGRESSIVE), 11000, 11000);
  const std::string tooLarge = "the picture is too large: ", tooFew = "the header promises more pixels";

  CHECK(png(30000, 30000).size() < 100);
  CHECK(reasonOf(path, png(30000, 30000)) ==
        tooLarge + "30000 x 30000 pixels; at most 32768 a side and 134217728 in all");
  CHECK(reasonOf(path, png(10000, 10000)).find(tooFew) == 0);
  CHECK(reasonOf(path, png(40000, 1)).find(tooLarge) == 0);
  CHECK(reasonOf(path, png(0x7fffffff, 0x7fffffff)).find(tooLarge) == 0);
  CHECK(reasonOf(path, png(0, 5)) != "");
  CHECK(reasonOf(path, png(0xffffffff, 5)) != "");

  CHECK(reasonOf(path, jpeg(30000, 30000)).find(tooLarge) == 0);
  CHECK(reasonOf(path, jpeg(40000, 10)).find(tooLarge) == 0);
  CHECK(reasonOf(path, jpeg(65535, 65535)) != "");
  CHECK(reasonOf(path, jpeg(11000, 11000)).find(tooFew) == 0);
  CHECK(reasonOf(path, progressive).find(tooFew) == 0);
  CHECK(reasonOf(path, jpeg(0, 10)) != "");
  CHECK(reasonOf(path, jpeg(10, 0)) != "");

  constexpr int kSlack = 16;  // MB; each of these pictures would take 300 or more
  for (const std::string& bytes : {png(10000, 10000), jpeg(11000, 11000), progressive}) {
    put(path, bytes);
    CHECK(megabytesOf([&] { errorOf([&] { readPhotograph(path); }); }) < kSlack);
  }
}

TEST_CASE("chunks that unpack to far more than they are do not take the memory") {
  const TemporaryDirectory directory;
  const auto path = directory / "bad";
  const std::string lines = scanLines("abc", 3), huge = deflatedSpaces(300 << 20), large = deflatedSpaces(4'000'000);
  const std::string before("Comment\0\0", 9);
  std::string largeTexts;
  for (int i = 0; i < 60; ++i) largeTexts += pngChunk("zTXt", before + large);
  const std::string hugeText = pngFile({1, 1}, lines, pngChunk("zTXt", before + huge));
  const std::string manyTexts = pngFile({1, 1}, lines, largeTexts);
  const std::string hugeProfile = pngFile({1, 1}, lines, pngChunk("iCCP", before + huge));
  CHECK(reasonOf(path, hugeText) == "");
  CHECK(reasonOf(path, manyTexts) == "");
  CHECK(readPhotograph(path).text.at("Comment").size() == 4'000'000);
  CHECK(reasonOf(path, hugeProfile).find("damaged profile") != std::string::npos);

  constexpr int kSlack = 100;  // MB, of 300, 240 and 300; 16 chunks of 4 MB may be kept
  for (const std::string& bytes : {hugeText, manyTexts, hugeProfile}) {
    put(path, bytes);
    CHECK(megabytesOf([&] { errorOf([&] { readPhotograph(path); }); }) < kSlack);
  }
}

TEST_CASE("what is no picture is refused by name, and so are directories, pipes and missing files") {
  const TemporaryDirectory directory;
  for (const std::string& bytes :
       {std::string(), std::string("\xff"), std::string("GIF89a"), std::string(5000, '\0')}) {
    CHECK(reasonOf(directory / "bad", bytes) == "not a JPEG, PNG or EXR file");
  }
  CHECK(reasonOf(directory / "bad", "\xff\xd8\xff") != "");
  CHECK(reasonOf(directory / "bad", "\xff\xd8\xff\xd9") != "");
  CHECK(reasonOf(directory / "bad", "\x89PNG\r\n\x1a\n") != "");
  CHECK(errorOf([&] { readPhotograph(directory / "none.jpg"); }) ==
        (directory / "none.jpg").string() + ": No such file or directory");
  CHECK(errorOf([&] { readPhotograph(directory / "."); }).find("not a regular file") != std::string::npos);
  REQUIRE(::mkfifo((directory / "pipe").c_str(), 0600) == 0);
  CHECK(errorOf([&] { readPhotograph(directory / "pipe"); }).find("not a regular file") != std::string::npos);
}

}  // namespace parhelion
