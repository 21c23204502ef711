// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "picture/temporary_directory.h"
#include "render/composite.h"
#include "render/halo_source.h"
#include "render/scenes.h"
#include "render/sky_files.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

PhotoCamera photoCamera() {
  PhotoCamera photo;
  photo.camera.projection = Projection::rectilinear;
  photo.camera.fieldOfView = radians(70.0);
  photo.camera.elevation = radians(18.0);
  photo.camera.width = 60;
  photo.camera.height = 40;
  photo.sunElevation = radians(12.0);
  return photo;
}

Photograph greyPhotograph() {
  Photograph photograph;
  photograph.width = 60;
  photograph.height = 40;
  photograph.samples = std::vector<std::uint8_t>(3 * photograph.pixels(), 120);
  return photograph;
}

}  // namespace

TEST_CASE("the halo of a scene is seen by the photograph's camera, under the photograph's sun") {
  const PhotoCamera photo = photoCamera();
  const HaloScene scene = haloSceneFor(photo, 2, smallScene);
  CHECK(scene.coarse.scene.sun.elevation == doctest::Approx(photo.sunElevation).epsilon(1e-11));
  CHECK_FALSE(scene.coarse.scene.sun.visible);
  CHECK(scene.camera.width == 30);
  CHECK(scene.coarse.scene.camera.height == 20);
  CHECK(scene.whole.scene.camera.width == 60);
  CHECK(scene.whole.scene.trace.rays == 20'000);
}

TEST_CASE("a halo comes out the same whether it is rendered for a photograph or read from that render's picture") {
  const TemporaryDirectory folder;
  const PhotoCamera photo = photoCamera();
  const HaloScene scene = haloSceneFor(photo, 1, smallScene);
  const TracedSky traced = traceSky(scene.coarse, cloudOf(scene.coarse.scene));
  const PhotoHalo rendered = haloOf(traced, scene, photo, 0);
  ReconstructedSky sky = developSky(traced, scene.coarse, 0);
  writeSky(folder / "sky.exr", sky.image, traced.tally.info(), scene.coarse);
  CHECK(sunElevationIn(folder / "sky.exr") == doctest::Approx(photo.sunElevation).epsilon(1e-11));

  const PhotoHalo read = readHalo(folder / "sky.exr", photo);
  CHECK(read.attributes == rendered.attributes);
  double brightest = 0.0, apart = 0.0;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 60; ++x) {
      const Vec3 a = rendered.lookup.at({x + 0.5, y + 0.5}).value(), b = read.lookup.at({x + 0.5, y + 0.5}).value();
      brightest = std::max(brightest, a.y);
      apart = std::max(apart, std::abs(a.y - b.y));
    }
  CHECK(brightest > 0.0);
  CHECK(apart < 1e-9 * brightest);  // cameras in scenes agree to 15 digits

  PhotoCamera other = photo;
  other.sunElevation += radians(1.0);
  CHECK(errorOf([&] { readHalo(folder / "sky.exr", other); }).find("elevation 12.000 degrees") != std::string::npos);
}

TEST_CASE("a composite writes all its files with the halo's scene and strength, and prints nothing") {
  const TemporaryDirectory folder;
  std::filesystem::create_directory(folder / "layers");
  const PhotoCamera photo = photoCamera();
  const Photograph photograph = greyPhotograph();
  writePhotograph(folder / "photo.jpg", photograph, {});

  Printed printed;
  const HaloScene scene = haloSceneFor(photo, 2, smallScene);
  const PhotoHalo halo = haloOf(traceSky(scene.coarse, cloudOf(scene.coarse.scene)), scene, photo, 2);
  const SkyMask mask = allSky(photograph);
  const CompositeFiles files{folder / "photo.jpg", folder / "out.png", folder / "layers", folder / "mask.png"};
  const AddedHaloReport done =
      writeComposite(files, photograph, {halo.lookup, mask, Vec3(0.5)}, photo, halo.attributes, 2);
  CHECK(printed.text() == "");
  CHECK(done.touched > 0);
  const Photograph written = readPhotograph(folder / "out.png");
  CHECK(written.text.at(kSceneKey) == scene.whole.text);
  CHECK(written.text.at(kStrengthKey) == "0.5 0.5 0.5");
  CHECK(written.text.at("Software") == kSoftware);
  CHECK(readSkyMaskOf(photograph, folder / "mask.png") == mask);
  for (const std::filesystem::path& layer : editingFiles(files.editingFolder)) CHECK(std::filesystem::exists(layer));
  CHECK(editingFiles({}).empty());

  Photograph larger = greyPhotograph();
  larger.height = 41;
  CHECK(errorOf([&] { readSkyMaskOf(larger, folder / "mask.png"); }).find("60 x 41") != std::string::npos);
}
