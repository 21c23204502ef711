// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "picture/image.h"

namespace parhelion {

// The star that a lens makes of the sun: light that the straight edges of its aperture diffract. At angles of many
// times wavelength over width an edge of length L sends the share wavelength * L / (2 pi^2 * area) / t of the light
// that goes through the aperture further than t (rad), half of it to either side, square to the edge: the same law of
// which a round aperture sends 2 / (pi x) out of the rings within x (Born & Wolf, Principles of Optics, 8.5.2).

/// A lens stopped down.
struct LensAperture {
  int blades = 6;         // edges of a regular polygon, 3 or more; the lowest is level
  double diameter = 2.0;  // of the circle through its corners, mm
};

/// Share of light of a wavelength (nm) that is diffracted further than an angle (rad), in all directions together.
double starShare(const LensAperture& lens, double wavelength, double angle);

/// Directions in a picture, right and down, in which its rays go: as many as edges, or, of an odd number, twice that.
std::vector<Vec2> starRays(const LensAperture& lens);

/// A picture of linear light as a lens draws it, of which pixels that are at least a thousand times as bright as half
/// of the lit ones make stars; the others' are too faint to be seen. `pixel` is the size of a pixel on the optical
/// axis, rad. All light is kept, but what leaves the picture. Channels other than R, G and B stay. Returns how many
/// pixels shine. Throws std::invalid_argument if R, G or B is missing.
std::size_t addLensStar(Image& image, double pixel, const LensAperture& lens = {});

}  // namespace parhelion
