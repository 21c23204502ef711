// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <glm/geometric.hpp>

#include "air/many_scatterings.h"
#include "random_stream.h"

namespace parhelion::test {

/// Radiance of the sky for unit irradiance above the air by chance: paths are followed from the eye backwards through
/// the spherical air, with free flights by null collisions, and at each scattering and on the ground the sun's light is
/// added. It shares densities, depths and phase functions with the air under test, and nothing else but the sun's
/// transmittance.
class LightWalk {
 public:
  LightWalk(const SkySettings& settings, double wavelength, double sunElevation)
      : air_(settings),
        wavelength_(wavelength),
        depths_(air_.depths(wavelength)),
        toSun_(std::cos(sunElevation), 0.0, std::sin(sunElevation)) {
    const OfAir density = air_.densities(0.0);
    most_ = depths_.rayleigh * density.rayleigh + depths_.aerosol * density.aerosol + depths_.ozone / 15.0;
  }

  struct Orders {
    double first, all;
  };

  /// What one path brings.
  Orders path(double altitude, Vec3 direction, RandomStream& random) const {
    Vec3 place(0.0, 0.0, kGroundRadius + altitude);
    Orders light{0.0, 0.0};
    double weight = 1.0;
    for (int order = 0; order < 200; ++order) {
      bool onGround = false;
      if (!fly(place, direction, onGround, random)) break;
      const Vec3 up = glm::normalize(place);
      const double radius = glm::length(place), sine = glm::dot(up, toSun_);
      const double sun = air_.sunTransmittance(wavelength_, radius - kGroundRadius, std::asin(std::min(1.0, sine)));
      double added;
      if (onGround) {
        const double albedo = air_.settings().ground;
        added = weight * albedo / kPi * std::max(0.0, sine) * sun;
        weight *= albedo;
        const double s = std::sqrt(random.next());
        direction = around(up, s, random.next());
      } else {
        const AerosolSettings& aerosol = air_.settings().aerosol;
        const OfAir density = air_.densities(radius - kGroundRadius);
        const double rayleigh = depths_.rayleigh * density.rayleigh;
        const double particles = depths_.aerosol * density.aerosol, ozone = depths_.ozone * density.ozone;
        const double scattered = rayleigh + particles * aerosol.albedo;
        weight *= scattered / (rayleigh + particles + ozone);
        const double cosine = glm::dot(direction, toSun_);
        const double share = rayleigh / scattered;
        added = weight * sun * (share * rayleighPhase(cosine) + (1.0 - share) * aerosolPhase(aerosol.g, cosine));
        direction = around(direction, deflection(random.next() < share, aerosol.g, random), random.next());
      }
      if (order == 0) light.first = added;
      light.all += added;
      if (weight < 1e-3) break;
    }
    return light;
  }

 private:
  /// Moves to the next collision or to the ground; false where the path leaves the air.
  bool fly(Vec3& place, const Vec3& direction, bool& onGround, RandomStream& random) const {
    const double radius = glm::length(place);
    const RayPlace ray{radius, glm::dot(place, direction) / radius};
    const double ground = ray.distanceToGround();
    const double end = ground >= 0.0 ? ground : ray.distanceUpTo(kAirTop);
    double distance = 0.0;
    for (;;) {
      distance -= std::log(random.next()) / most_;
      if (distance >= end) break;
      const OfAir density = air_.densities(ray.after(distance).altitude());
      const double extinction =
          depths_.rayleigh * density.rayleigh + depths_.aerosol * density.aerosol + depths_.ozone * density.ozone;
      if (random.next() * most_ >= extinction) continue;
      place += distance * direction;
      return true;
    }
    onGround = ground >= 0.0;
    if (onGround) place = glm::normalize(place + ground * direction) * kGroundRadius;
    return onGround;
  }

  static double deflection(bool isRayleigh, double g, RandomStream& random) {
    if (!isRayleigh) {
      const double s = (1.0 - g * g) / (1.0 - g + 2.0 * g * random.next());
      return (1.0 + g * g - s * s) / (2.0 * g);
    }
    for (;;) {
      const double cosine = 2.0 * random.next() - 1.0;
      if (2.0 * random.next() <= 1.0 + cosine * cosine) return cosine;
    }
  }

  static Vec3 around(const Vec3& axis, double cosine, double turn) {
    const Vec3 side = glm::normalize(glm::cross(axis, std::abs(axis.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0)));
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine)), angle = 2.0 * kPi * turn;
    return glm::normalize(cosine * axis + sine * (std::cos(angle) * side + std::sin(angle) * glm::cross(axis, side)));
  }

  Atmosphere air_;
  double wavelength_;
  OfAir depths_;
  Vec3 toSun_;
  double most_;  // extinction anywhere, 1/km
};

}  // namespace parhelion::test
