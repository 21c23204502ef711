// SPDX-License-Identifier: Apache-2.0
#include "rays_queries.h"

#include <map>

#include "trace/light_path.h"

namespace parhelion::bench {

Cloud randomPrisms(double aspect) {
  const SunSettings sun{.elevation = radians(20.0), .diameter = 0.0, .spectrum = MonochromaticSpectrum{550.0}};
  const PopulationSettings prisms{"prisms", 1.0, PrismSettings{FixedValue{aspect}}, RandomOrientation{}};
  return Cloud(sun, PublishedIndex{}, {{prisms}});
}

Crystal onlyCrystal(const Cloud& cloud) { return RaySource(cloud, {}, 1).ray(0).crystal; }

void forEachInteriorRay(const Cloud& cloud, std::uint64_t first, std::uint64_t last,
                        const std::function<void(const InteriorRay&)>& look) {
  const TraceSettings settings{.engine = Engine::planes};
  const Intersectors engines = makeIntersectors(cloud, settings.engine);
  std::map<int, int> indexOf;  // by crystallographic number
  const auto& faces = cloud.populations().front().mesh().faces();
  for (int i = 0; i < static_cast<int>(faces.size()); ++i) indexOf[faces[i].number] = i;

  RaySource source(cloud, settings, 256);
  LightPath path;
  path.recordEncounters = true;
  for (std::uint64_t index = first; index < last; ++index) {
    followRay(source, engines, settings, index, path);
    // The last encounter has nothing that stays.
    for (std::size_t k = 0; k + 1 < path.encounters.size(); ++k) {
      const Encounter& from = path.encounters[k];
      look({from.point, from.stayingDir, indexOf.at(from.faceNumber)});
    }
  }
}

std::vector<InteriorRay> interiorRays(const Cloud& cloud, std::size_t count) {
  std::vector<InteriorRay> all;
  constexpr std::uint64_t kStep = 256;
  for (std::uint64_t first = 0; all.size() < count; first += kStep)
    forEachInteriorRay(cloud, first, first + kStep, [&](const InteriorRay& ray) { all.push_back(ray); });
  all.resize(count);
  return all;
}

void fillPool(RayPool& pool, std::span<const InteriorRay> rays, double stretch) {
  pool.active = static_cast<int>(rays.size());
  for (int i = 0; i < pool.active; ++i) {
    for (int k = 0; k < 3; ++k) {
      pool.point[k][i] = rays[i].point[k];
      pool.lightDir[k][i] = rays[i].lightDir[k];
    }
    pool.face[i] = rays[i].leftFace;
    pool.stretch[i] = stretch;
  }
}

}  // namespace parhelion::bench
