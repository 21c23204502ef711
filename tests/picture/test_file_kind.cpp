// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <sys/stat.h>

#include "picture/file_kind.h"
#include "picture/photograph.h"
#include "picture/picture_text.h"
#include "temporary_directory.h"

namespace parhelion {

namespace {

using Family = FileKind::Family;

Photograph grey() {
  Photograph picture;
  picture.width = picture.height = 4;
  picture.samples = std::vector<std::uint8_t>(48, 100);
  return picture;
}

}  // namespace

TEST_CASE("a file is known by its first bytes, and text by having no zeros") {
  const struct {
    std::string_view start;
    Family family;
  } cases[] = {
      {"", Family::empty},
      {"[sun]\nelevation = 20\n", Family::text},
      {"BM is how a text may begin", Family::text},
      {{"\xff\xfe[\0s\0", 6}, Family::text},  // UTF-16, which is to be saved as UTF-8
      {{"BM\x46\0\0\0", 6}, Family::otherPicture},
      {"\xff\xd8\xff\xe0", Family::jpeg},
      {"\x89PNG\r\n\x1a\n", Family::png},
      {"\x76\x2f\x31\x01", Family::exr},
      {{"II*\0\x10\0\0\0CR\x02", 11}, Family::otherPicture},
      {{"\0\0\0\x18"
        "ftypheic",
        12},
       Family::otherPicture},
      {"#?RADIANCE\n", Family::otherPicture},
      {{"RIFF\x10\0\0\0WEBP", 12}, Family::otherPicture},
      {"\x1f\x8b\x08", Family::otherBinary},
      {"%PDF-1.7", Family::otherBinary},
      {{"a\0b", 3}, Family::otherBinary},
  };
  for (const auto& [start, family] : cases) CHECK_MESSAGE(kindOf(start).family == family, std::string(start));
}

TEST_CASE("looking at a file takes nothing out of a pipe") {
  const TemporaryDirectory directory;
  REQUIRE(::mkfifo((directory / "pipe").c_str(), 0600) == 0);
  CHECK(startOfFile(directory / "pipe").empty());
  CHECK(startOfFile(directory / "none").empty());
  CHECK(startOfFile(directory.path()).empty());
  put(directory / "text", std::string(2000, 'x'));
  CHECK(startOfFile(directory / "text") == std::string(512, 'x'));
}

TEST_CASE("what pictures say of themselves is read of all kinds, also where they are cut short") {
  const TemporaryDirectory directory;
  for (const char* name : {"a.png", "a.exr", "a.jpg"}) {
    const auto path = directory / name;
    writePhotograph(path, grey(), {{"Software", "somebody 1.0"}});
    const std::string whole = contents(path);
    for (const std::size_t bytes : {whole.size(), whole.size() - 20}) {
      put(path, whole.substr(0, bytes));
      const auto text = readPictureText(path);
      CHECK_MESSAGE(text.at(path.extension() == ".jpg" ? "comment" : "Software") == "somebody 1.0", name);
    }
    put(path, whole.substr(0, 12));
    if (path.extension() == ".jpg")
      CHECK(readPictureText(path).empty());
    else
      CHECK_THROWS_AS(readPictureText(path), std::runtime_error);
  }
  put(directory / "text", "hello");
  CHECK_THROWS_AS(readPictureText(directory / "text"), std::runtime_error);
}

}  // namespace parhelion
