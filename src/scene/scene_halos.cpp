// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_halos.h"

#include <utility>
#include <variant>

#include "crystal/raypath/stance.h"

namespace parhelion {
namespace {

HaloFamily familyOf(Stance stance) {
  switch (stance) {
    case Stance::plate:
      return HaloFamily::plates;
    case Stance::column:
      return HaloFamily::columns;
    case Stance::parry:
      return HaloFamily::parry;
    case Stance::lowitz:
      return HaloFamily::lowitz;
    case Stance::random:
      break;
  }
  return HaloFamily::random;
}

/// Of a rosette, whether a face belongs to its first bullet: next to no light goes in by one bullet and out by another,
/// and all have the same wedges. Of other crystals any face does.
bool isOfFirstBullet(const ShapeSettings& shape, const Face& face) {
  constexpr int kNextBullet = 100;
  return !std::holds_alternative<RosetteSettings>(shape) || face.number < kNextBullet;
}

}  // namespace

SceneHalos halosOf(const std::vector<PopulationSettings>& populations) {
  SceneHalos halos;
  for (const PopulationSettings& settings : populations) {
    if (!(settings.weight > 0.0)) continue;
    const Population population(settings);
    const auto stance = stanceOf(population);
    if (!stance) {
      halos.nameless.push_back(settings.name);
      continue;
    }
    std::vector<Vec3> faces;
    for (const Face& face : population.mesh().faces())
      if (isOfFirstBullet(settings.shape, face)) faces.push_back(face.normal);
    halos.makers.push_back({familyOf(*stance), std::move(faces)});
  }
  return halos;
}

}  // namespace parhelion
