// SPDX-License-Identifier: Apache-2.0
// A picture of ours is read as it was written, or refused.
#include <doctest/doctest.h>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>

#include <random>

#include "damage.h"
#include "picture/exr.h"
#include "picture/meaning.h"
#include "picture/photograph.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

Image smallPicture() {
  Image image{9, 7, {}};
  std::mt19937 random(6);
  std::normal_distribution<float> normal;
  for (const char* name : {"R", "G", "B", "Variance.Y"})
    for (float& sample : image.add(name)) sample = normal(random);
  return image;
}

const ExrAttributes kAttributes{
    {"software", "parhelion 0.1.0"}, {"parhelion:seed", "1"}, {"parhelion:scene", "[sun]\nelevation = 20\n"}};

bool sameSamples(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height || a.channels.size() != b.channels.size()) return false;
  for (const Channel& channel : a.channels) {
    const auto* other = b.find(channel.name);
    if (!other || *other != channel.samples) return false;
  }
  return true;
}

/// Our attributes, which mean something.
ExrAttributes ours(const ExrAttributes& attributes) {
  ExrAttributes all;
  for (const auto& [name, value] : attributes)
    if (name.starts_with(kOurPrefix)) all[name] = value;
  return all;
}

/// A copy as another program makes it: all attributes stay, and samples are changed.
void editSamples(const std::filesystem::path& from, const std::filesystem::path& to) {
  Imf::InputFile input(from.c_str());
  const Imf::Header header = input.header();
  const Imath::Box2i window = header.dataWindow();
  Image image = smallPicture();
  Imf::FrameBuffer buffer;
  for (Channel& channel : image.channels)
    buffer.insert(channel.name, Imf::Slice::Make(Imf::FLOAT, channel.samples.data(), window));
  input.setFrameBuffer(buffer);
  input.readPixels(window.min.y, window.max.y);
  image.channels[1].samples[5] += 0.25F;
  Imf::OutputFile output(to.c_str(), header);
  output.setFrameBuffer(buffer);
  output.writePixels(image.height);
}

}  // namespace

TEST_CASE("a flipped bit or a cut in a picture is refused, or changes nothing that is read") {
  const TemporaryDirectory directory;
  const auto path = directory / "p.exr";
  writeBeautyExr(path, smallPicture(), kAttributes);
  const ExrFile whole = readExr(path);
  CHECK(sameSamples(whole.image, smallPicture()));
  CHECK(whole.attributes == kAttributes);
  const Survived survived = damaged(path, [&] {
    const ExrFile read = readExr(path);
    return sameSamples(read.image, whole.image) && ours(read.attributes) == ours(whole.attributes) &&
           read.display.left == 0 && read.display.top == 0 && read.display.width == 9 && read.display.height == 7;
  });
  CHECK(survived.readWrong == 0);
  CHECK(survived.refused > 100);
}

TEST_CASE("a picture that another program has changed is refused, and read where that is asked for") {
  const TemporaryDirectory directory;
  const auto path = directory / "p.exr", edited = directory / "e.exr";
  writeBeautyExr(path, smallPicture(), kAttributes);
  editSamples(path, edited);
  const std::string error = errorOf([&] { readExr(edited); });
  CHECK(error.find(edited.string() + ": damaged, or changed by another program") == 0);
  CHECK(error.find("--edited") != std::string::npos);
  const ExrFile read = readExr(edited, ExrColours::rec709, {.edited = EditedPictures::read});
  CHECK((*read.image.find("G"))[5] == (*smallPicture().find("G"))[5] + 0.25F);
  CHECK_THROWS_AS(readPhotograph(edited), std::runtime_error);
  CHECK_NOTHROW(readPhotograph(edited, {.edited = true}));
  // Written again by us, it is ours again.
  writeBeautyExr(path, read.image, read.attributes);
  CHECK_NOTHROW(readExr(path));
}
