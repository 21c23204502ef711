// SPDX-License-Identifier: Apache-2.0
#include "sky/projection.h"

#include "sky/projections.h"

namespace parhelion {

bool isFisheye(Projection projection) {
  return visitProjection(projection, [](auto p) { return p.isFisheye; });
}

bool isPanorama(Projection projection) {
  return visitProjection(projection, [](auto p) { return p.isPanorama; });
}

bool showsHemispheres(Projection projection) {
  return visitProjection(projection, [](auto p) { return p.showsHemispheres; });
}

int discs(Projection projection) {
  return visitProjection(projection, [](auto p) { return p.discs; });
}

bool isMirrored(Projection projection) {
  return visitProjection(projection, [](auto p) { return p.isMirrored; });
}

}  // namespace parhelion
