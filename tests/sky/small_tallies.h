// SPDX-License-Identifier: Apache-2.0
#pragma once

// Small tallies as runs leave them.

#include <random>

#include "sky/tally.h"

namespace parhelion::test {

/// 400 rays of which 300 bring light to 9 x 7 pixels, or to the rings of a radial sky.
inline Tally smallTally(TallySymmetry symmetry = TallySymmetry::none, int colours = 3) {
  TallyInfo info;
  info.symmetry = symmetry;
  info.sceneHash = 0x0123456789abcdef;
  info.numerics = 1;
  info.seed = 5;
  info.rays = {{100, 300}, {1000, 100}};
  info.intercepted = LightTotal(LightTotal::Units{400 * info.images()} << 28);
  info.undeviated = LightTotal(toFixed(33.0));
  info.interceptedXyz.fill(info.intercepted);
  info.white = {0.97, 1.0, 1.05};
  info.sunElevation = radians(20.0);
  info.sunDiameter = radians(0.5);
  info.camera.width = 9;
  info.camera.height = 7;
  info.camera.shift = {0.25, 0.0};
  info.scene = "[sun]\nelevation = 20.0\n[[population]]\naspect = 1.0\n";
  info.version = "0.1.0";
  Tally tally(info, colours);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> light(0.1, 0.9);
  for (int i = 0; i < 300; ++i) {
    const Vec3 xyz = light(random) * info.white;
    if (tally.rings())
      tally.makeRings(info.toSun()).add(static_cast<int>(random() % 8192), xyz, i % 2 == 0);
    else
      tally.add(static_cast<int>(random() % 63), xyz, i % 2 == 0);
  }
  if (symmetry == TallySymmetry::mirror) tally.addMirrorImage();
  if (symmetry == TallySymmetry::radial) tally.spreadRings();
  return tally;
}

}  // namespace parhelion::test
