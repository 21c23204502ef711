// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "math/tabulated_density.h"
#include "optics/light_settings.h"

namespace parhelion {

/// One wavelength drawn from a spectrum, with the colour that a ray of unit light carries.
struct SpectralSample {
  double wavelength = 550.0;  // nm
  Vec3 xyz{1.0};              // CIE XYZ; the mean over the spectrum is Spectrum::white(), whose Y is 1
  double light = 1.0;         // what the ray counts for in sums of light without colour; its mean is 1
};

/// The light of the sun as a density to draw wavelengths from.
///
/// Continuous light is drawn in proportion to sunlight times the length of the observer's response in linear Rec.709,
/// which gives the picture's channels the least summed variance; `light` is then luminance. Of lines each is drawn as
/// often, and `light` is its energy: 1 for each where all are alike.
class Spectrum {
 public:
  /// Throws std::invalid_argument when lines carry no light that the observer sees, or their weights are not as many or
  /// not positive.
  explicit Spectrum(const SpectrumSettings& settings);

  /// The wavelength at quantile `u` in [0, 1), with its weights.
  SpectralSample sample(double u) const;

  /// XYZ of all the light together, Y = 1.
  const Vec3& white() const { return white_; }

  /// How many rays share everything but their wavelength, so that their colours nearly add up to white wherever
  /// dispersion does not part them: every line of a list, a complementary pair of continuous light. A pair costs no
  /// more luminance noise for the time it takes than single rays would, and has a fifth of their colour noise.
  int bundleSize() const { return lines_.empty() ? 2 : static_cast<int>(lines_.size()); }

  /// 1 for monochromatic light, which has luminance only; else 3.
  int colours() const { return lines_.size() == 1 ? 1 : 3; }

  /// Wavelengths (nm) when the spectrum is a list of lines; empty for continuous light.
  const std::vector<SpectralSample>& lines() const { return lines_; }

 private:
  void buildContinuous(const std::function<double(double)>& power);
  void buildLines(const LineSpectrum& settings);

  std::vector<SpectralSample> lines_;
  std::unique_ptr<const TabulatedDensity> density_;
  std::vector<Vec3> lightPerNm_;  // XYZ of the light at each node, normalised to unit luminance
  Vec3 white_{1.0};
};

/// What sunlight of a spectrum brings to a surface that faces the sun above the atmosphere, lx: of "sun-am1.5" what it
/// brings to the ground. Spectra that are not sunlight count as the sun's own light, which they stand for. Of 683.002
/// lm/W at the observer's peak.
double solarIlluminance(const SpectrumSettings& settings);

/// The 1931 observer's response to `wavelength` (nm), linear between the nanometres; 0 outside 360-830 nm.
Vec3 observer1931(double wavelength);

}  // namespace parhelion
