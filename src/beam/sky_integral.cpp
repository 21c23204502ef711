// SPDX-License-Identifier: Apache-2.0
#include "beam/sky_integral.h"

#include <memory>

#include "beam/azimuth_integral.h"
#include "beam/orientation_sheet.h"
#include "beam/sheet_integration.h"
#include "beam/tilt_integral.h"
#include "parallel/loops.h"

namespace parhelion {

namespace {

// The first mesh: cells for 30 degrees of azimuth, and for 90 of the angle from -c.
constexpr int kColumns = 40, kRows = 120, kMostLevel = 4;

/// Of all azimuths and rolls: sheets for tilts, points of the sun and indices.
class OrientationIntegration : public SheetIntegration {
 public:
  OrientationIntegration(const AxisScene& scene, const SkyAccuracy& accuracy, const Camera& camera)
      : SheetIntegration(scene, accuracy, camera, isOneSheet(scene) ? Sheets::one : Sheets::groups, kMostLevel) {}

 private:
  static bool isOneSheet(const AxisScene& scene) {
    return scene.oneTilt && scene.sun.radius == 0.0 && scene.lines.size() == 1;
  }

  void start(int level) override {
    table_ = std::make_unique<LightTable>(scene_.prisms, scene_.indices, kColumns << level, kRows << level,
                                          accuracy_.cutShare, scene_.wanted);
  }

  long add(int first, int last, bool coarse) override {
    std::vector<std::vector<SheetPoint>> sheets(films_.size());
    for (std::size_t group = 0; group < films_.size(); ++group) {
      const EvenPoints even(accuracy_.seed, static_cast<int>(group));
      for (int k = first; k < last; ++k) {
        SheetPoint point;
        point.tilt = scene_.tilt(even.at(k, 0));
        point.toSun = scene_.toSun(even.at(k, 1), even.at(k, 2));
        const IndexColour light = scene_.light(even.at(k, 3));
        point.index = light.index;
        point.xyz = light.xyz;
        point.offset = even.at(k, 4);
        prepare(point);
        sheets[group].push_back(point);
      }
    }
    const SheetMesh mesh{{faintest(), accuracy_.hasEdge, accuracy_.widest},
                         kPi / 6.0 / table_->columns(),
                         accuracy_.folds,
                         coarse,
                         scene_.side};
    forEach(films_.size(), [&](std::size_t group) {
      OrientationSheet sheet(*table_, lens_, mesh);
      for (const SheetPoint& point : sheets[group]) totals_[group].add(sheet.add(point, films_[group]), 1.0);
    });
    return static_cast<long>(films_.size()) * (last - first);
  }

  long directions() const override { return table_->directions(); }
  double wantedShare() const override { return table_->wantedShare(); }

  /// Traces what a sheet needs.
  void prepare(const SheetPoint& point) {
    const auto [least, most] = OrientationSheet::anglesAt(point.tilt, point.toSun);
    table_->prepare(least, most);
  }

  std::unique_ptr<LightTable> table_;
};

}  // namespace

SkyIntegral integrateSky(const AxisScene& scene, const SkyAccuracy& accuracy, const Camera& camera, BandStore& store) {
  if (scene.rest) return integrateAzimuths(scene, accuracy, camera);
  if (isForTilts(scene, camera)) return integrateTilts(scene, accuracy, camera, store);
  return OrientationIntegration(scene, accuracy, camera).run();
}

}  // namespace parhelion
