// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include "math/rotation.h"
#include "photo/halo_camera.h"
#include "photo/halo_lookup.h"
#include "sky/camera.h"
#include "sky/look_at.h"

using namespace parhelion;

namespace {

CameraSettings camera(Projection projection, double fieldOfView, int width, int height) {
  return test::lookAt(projection, 0.0, 0.0, 0.0, fieldOfView, width, height);
}

/// A smooth light of the sky, waves a few degrees long.
Vec3 light(const Vec3& toSky) {
  const SkyPoint point = skyPoint(toSky);
  return {2.0 + std::cos(20.0 * point.elevation) * std::cos(16.0 * point.azimuth), 1.0 + 0.5 * std::sin(12.0 * toSky.y),
          3.0};
}

Image picture(const CameraSettings& settings) {
  const Camera view(settings);
  Image image{settings.width, settings.height, {}};
  for (const char* name : {"R", "G", "B"}) image.add(name);
  for (int y = 0; y < settings.height; ++y) {
    for (int x = 0; x < settings.width; ++x) {
      const auto toSky = view.toSky({x + 0.5, y + 0.5});
      const Vec3 rgb = toSky ? light(*toSky) : Vec3(0.0);
      for (int c = 0; c < 3; ++c)
        image.channels[static_cast<std::size_t>(c)].samples[static_cast<std::size_t>(y) * settings.width + x] =
            static_cast<float>(rgb[c]);
    }
  }
  return image;
}

/// The largest difference between what is looked up and the light itself, over pixels of the photograph that lie at
/// least two of the halo's pixels inside its picture.
double worst(const CameraSettings& halo, const CameraSettings& photo) {
  const HaloLookup lookup(picture(halo), halo, photo);
  const Camera view(photo), haloView(halo);
  double largest = 0.0;
  for (double y = 0.5; y < photo.height; y += 2.0) {
    for (double x = 0.5; x < photo.width; x += 1.0) {
      const auto toSky = view.toSky({x, y});
      if (!toSky) continue;
      const auto place = haloView.project(*toSky);
      if (!place || glm::any(glm::lessThan(*place, Vec2(2.0))) ||
          glm::any(glm::greaterThan(*place, Vec2(halo.width - 2.0, halo.height - 2.0))))
        continue;
      const auto found = lookup.at({x, y});
      REQUIRE(found);
      largest = std::max(largest, glm::length(*found - light(*toSky)));
    }
  }
  return largest;
}

}  // namespace

TEST_CASE("a halo is looked up where the photograph sees it") {
  const CameraSettings photo = camera(Projection::rectilinear, 60.0, 200, 150);
  // Bilinear: an eighth of the squared pixel times the second derivatives, which add up to 656 here: 0.0016 for pixels
  // of 0.25 degrees. The mean over the photograph's own pixels of 0.3 degrees bends it by another 0.0008.
  CHECK(worst(camera(Projection::equirectangular, 360.0, 1440, 720), photo) < 3e-3);
  CHECK(worst(camera(Projection::equirectangular, 360.0, 720, 360), photo) < 8e-3);
  CHECK(worst(camera(Projection::fisheyeEqualArea, 180.0, 700, 700), photo) < 6e-3);
}

TEST_CASE("larger pixels of the same camera keep the halo in its place") {
  CameraSettings photo = camera(Projection::rectilinear, 60.0, 403, 305);
  photo.roll = 0.3;
  photo.distortion = {-0.05, 0.01, 0.0};
  CHECK(worst(photo, photo) < 1e-3);
  for (const int coarseness : {2, 3}) {
    const CameraSettings halo = haloCamera(photo, coarseness);
    CHECK(halo.width == (403 + coarseness - 1) / coarseness);
    CHECK(Camera(halo).focalLength() == doctest::Approx(Camera(photo).focalLength() / coarseness).epsilon(1e-12));
    CHECK(worst(halo, photo) < 8e-4 * coarseness * coarseness);  // as above, pixels of 0.15 degrees times that
  }
}

TEST_CASE("a finer picture of the halo is averaged over the photograph's pixels") {
  const CameraSettings photo = camera(Projection::rectilinear, 60.0, 60, 45);
  const CameraSettings fine = camera(Projection::rectilinear, 60.0, 240, 180);
  Image noisy = picture(fine);
  for (std::size_t i = 0; i < noisy.pixels(); ++i) {
    for (Channel& channel : noisy.channels) channel.samples[i] *= (i / 240 + i) % 2 == 0 ? 2.0f : 0.0f;
  }
  const HaloLookup lookup(noisy, fine, photo);
  const Camera view(photo);
  for (int x = 4; x < 56; ++x)
    CHECK(glm::length(*lookup.at({x + 0.5, 20.5}) - light(*view.toSky({x + 0.5, 20.5}))) < 0.03);
}

TEST_CASE("a point of light keeps its light through any picture of the halo") {
  const CameraSettings photo = camera(Projection::rectilinear, 60.0, 240, 180);
  const Camera view(photo);
  // Pixels twelve times as large as the photograph's, of about its size, and a third of it.
  for (const int width : {180, 1440, 2200, 3300}) {
    const CameraSettings panorama = camera(Projection::equirectangular, 360.0, width, width / 2);
    const Camera halo(panorama);
    Image image{panorama.width, panorama.height, {}};
    for (const char* name : {"R", "G", "B"}) image.add(name);
    double given = 0.0, found = 0.0;
    for (int dot = 0; dot < 40; ++dot) {
      const int pixel = *halo.pixelAt(skyDirection(0.017 * (dot % 8) - 0.11, 0.031 * (dot / 8) - 0.05));
      const double before = image.channels[1].samples[static_cast<std::size_t>(pixel)];
      const double omega = halo.solidAngle(pixel % width, pixel / width);
      image.channels[1].samples[static_cast<std::size_t>(pixel)] = static_cast<float>(before + 1.0 / omega);
      given += 1.0;
    }
    const HaloLookup lookup(image, panorama, photo);
    for (int y = 0; y < photo.height; ++y) {
      for (int x = 0; x < photo.width; ++x)
        if (const auto light = lookup.at({x + 0.5, y + 0.5})) found += light->y * view.solidAngle(x, y);
    }
    INFO("panorama of width " << width);
    // Forty points on grids that do not fit: each is off by up to a fifth where the pixels are of like size.
    CHECK(std::abs(found / given - 1.0) < 0.03);
  }
}

TEST_CASE("the photograph's own pixels come back as they are") {
  const CameraSettings photo = camera(Projection::fisheyeEquidistant, 100.0, 50, 40);
  Image image{photo.width, photo.height, {}};
  for (const char* name : {"R", "G", "B"}) image.add(name);
  image.channels[2].samples[20 * 50 + 17] = 3.0F;
  const HaloLookup lookup(image, photo, photo);
  CHECK(lookup.at({17.5, 20.5})->z == doctest::Approx(3.0).epsilon(1e-9));
  CHECK(std::abs(lookup.at({18.5, 20.5})->z) < 1e-9);
}

TEST_CASE("a panorama has no seam") {
  const CameraSettings panorama = camera(Projection::equirectangular, 360.0, 720, 360);
  CameraSettings photo = camera(Projection::rectilinear, 40.0, 200, 100);
  photo.azimuth = kPi;
  const HaloLookup lookup(picture(panorama), panorama, photo);
  const Camera view(photo);
  for (double x = 90.0; x < 110.0; x += 0.37)
    CHECK(glm::length(*lookup.at({x, 50.0}) - light(*view.toSky({x, 50.0}))) < 8e-3);
}

TEST_CASE("a halo is not looked up beyond its picture, and samples that are no numbers are no light") {
  const CameraSettings halo = camera(Projection::rectilinear, 30.0, 90, 60),
                       photo = camera(Projection::rectilinear, 60.0, 100, 70);
  Image image = picture(halo);
  image.channels[0].samples[45 + 90 * 30] = std::numeric_limits<float>::quiet_NaN();
  const HaloLookup lookup(image, halo, photo);
  CHECK_FALSE(lookup.at({1.0, 35.0}));
  REQUIRE(lookup.at({50.0, 35.0}));
  CHECK(std::isfinite(lookup.at({50.0, 35.0})->x));
  CHECK_THROWS_AS(HaloLookup(image, photo, photo), std::invalid_argument);
}

TEST_CASE("an even halo is even up to the seam of two discs, to image circles and to a horizon that is cut") {
  CameraSettings cut = camera(Projection::rectilinear, 70.0, 120, 80);
  cut.roll = radians(20.0);
  cut.horizon = Horizon::cut;
  CameraSettings up = camera(Projection::fisheyeEquidistant, 180.0, 90, 90);
  up.elevation = radians(90.0);
  for (const CameraSettings& halo : {camera(Projection::dualFisheyeEqualArea, 180.0, 180, 90),
                                     camera(Projection::dualFisheyeStereographic, 180.0, 1200, 600), up, cut}) {
    CAPTURE(std::string(nameOf(halo.projection)));
    const std::vector<double> solidAngles = Camera(halo).solidAngles();
    Image image{halo.width, halo.height, {}};
    for (const char* name : {"R", "G", "B"}) image.add(name);
    for (Channel& channel : image.channels)
      for (std::size_t i = 0; i < solidAngles.size(); ++i) channel.samples[i] = solidAngles[i] > 0.0 ? 1.0F : 0.0F;
    CameraSettings photo = camera(Projection::rectilinear, 60.0, 100, 70);
    photo.azimuth = radians(80.0);  // across the seam of a level dual fisheye, and of the horizon
    if (halo.horizon == Horizon::cut) photo.azimuth = 0.0;
    const HaloLookup lookup(image, halo, photo);
    int seen = 0;
    for (double y = 0.5; y < photo.height; ++y) {
      for (double x = 0.5; x < photo.width; ++x) {
        const auto found = lookup.at({x, y});
        if (!found) continue;
        ++seen;
        CHECK(found->y == doctest::Approx(1.0).epsilon(1e-12));
      }
    }
    CHECK(seen > 2500);
  }
}
