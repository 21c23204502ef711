// SPDX-License-Identifier: Apache-2.0
#include "optics/spectrum.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include <glm/geometric.hpp>

#include "math/overloaded.h"
#include "optics/illuminants.h"
#include "optics/tables.h"

namespace parhelion {

namespace {

/// Linear Rec.709 of an XYZ colour (IEC 61966-2-1); here only to say how much a wavelength matters to the picture.
Vec3 rec709(const Vec3& xyz) {
  return {3.2406 * xyz.x - 1.5372 * xyz.y - 0.4986 * xyz.z, -0.9689 * xyz.x + 1.8758 * xyz.y + 0.0415 * xyz.z,
          0.0557 * xyz.x - 0.2040 * xyz.y + 1.0570 * xyz.z};
}

template <class Table>
auto interpolate(const Table& table, double wavelength) {
  const double x = std::clamp(wavelength - kVisibleFirst, 0.0, double(kVisibleNodes - 1));
  const int node = std::min(static_cast<int>(x), kVisibleNodes - 2);
  return table[node] + (x - node) * (table[node + 1] - table[node]);
}

/// Spectral power over wavelength (nm), of any norm.
std::function<double(double)> powerOf(ContinuousSpectrum::Source source) {
  using Source = ContinuousSpectrum::Source;
  switch (source) {
    case Source::extraterrestrial:
      return [](double w) { return interpolate(kSunExtraterrestrial, w); };
    case Source::airMass1_5:
      return [](double w) { return interpolate(kSunAirMass1_5, w); };
    case Source::a:
      return illuminantA;
    case Source::d50:
      return illuminantD(5000.0);
    case Source::d55:
      return illuminantD(5500.0);
    case Source::d65:
      return illuminantD(6500.0);
    case Source::d75:
      return illuminantD(7500.0);
    case Source::equal:
    case Source::e:
      break;
  }
  return [](double) { return 1.0; };
}

/// The same of what is left of it.
std::function<double(double)> powerOf(const ContinuousSpectrum& settings) {
  std::function<double(double)> whole = powerOf(settings.source);
  if (settings.transmittance.empty()) return whole;
  if (settings.transmittance.size() != static_cast<std::size_t>(kVisibleNodes))
    throw std::invalid_argument("a transmittance has a number for each visible nanometre");
  return [whole, &settings](double w) { return whole(w) * interpolate(settings.transmittance, w); };
}

}  // namespace

Vec3 observer1931(double wavelength) {
  if (wavelength < kVisibleFirst || wavelength > kVisibleLast) return Vec3(0.0);
  return interpolate(kObserver1931, wavelength);
}

Spectrum::Spectrum(const SpectrumSettings& settings) {
  std::visit(Overloaded{
                 [&](const ContinuousSpectrum& s) { buildContinuous(powerOf(s)); },
                 [&](const MonochromaticSpectrum& s) {
                   lines_ = {{s.wavelength, Vec3(1.0), 1.0}};
                 },
                 [&](const LineSpectrum& s) { buildLines(s); },
                 [&](const BlackBody& s) { buildContinuous([&](double w) { return blackBody(s.temperature, w); }); },
             },
             settings);
}

void Spectrum::buildContinuous(const std::function<double(double)>& power) {
  // The trapezoidal rule over the nodes is exact for the linear pieces that sample() interpolates.
  Vec3 total(0.0);
  for (int i = 0; i < kVisibleNodes; ++i) {
    lightPerNm_.push_back(power(kVisibleFirst + i) * kObserver1931[i]);
    total += (i == 0 || i == kVisibleNodes - 1 ? 0.5 : 1.0) * lightPerNm_.back();
  }
  for (Vec3& light : lightPerNm_) light /= total.y;
  white_ = total / total.y;
  density_ =
      std::make_unique<TabulatedDensity>([this](double w) { return glm::length(rec709(interpolate(lightPerNm_, w))); },
                                         kVisibleFirst, kVisibleLast, kVisibleNodes - 1);
}

void Spectrum::buildLines(const LineSpectrum& settings) {
  const std::vector<double>& wavelengths = settings.wavelengths;
  const double count = static_cast<double>(wavelengths.size());
  std::vector<double> energy = settings.weights;  // of a line, over the mean of all
  if (energy.empty()) energy.assign(wavelengths.size(), 1.0);
  const double mean = std::accumulate(energy.begin(), energy.end(), 0.0) / count;
  for (double& e : energy) e /= mean;
  const bool positive = std::ranges::all_of(energy, [](double e) { return e > 0.0 && std::isfinite(e); });
  if (energy.size() != wavelengths.size() || !positive)
    throw std::invalid_argument("a spectrum of lines needs a weight above 0 for each");

  Vec3 total(0.0);
  for (std::size_t i = 0; i < wavelengths.size(); ++i) total += energy[i] * observer1931(wavelengths[i]) / count;
  if (!(total.y > 0.0)) throw std::invalid_argument("a spectrum of lines needs one from 360 to 830 nm");
  for (std::size_t i = 0; i < wavelengths.size(); ++i)
    lines_.push_back({wavelengths[i], energy[i] * observer1931(wavelengths[i]) / total.y, energy[i]});
  white_ = lines_.size() == 1 ? Vec3(1.0) : total / total.y;
  if (lines_.size() == 1) lines_.front().xyz = Vec3(1.0);
}

SpectralSample Spectrum::sample(double u) const {
  if (!lines_.empty()) return lines_[std::min(lines_.size() - 1, static_cast<std::size_t>(u * lines_.size()))];
  const double wavelength = density_->sample(u);
  const Vec3 xyz = interpolate(lightPerNm_, wavelength) / density_->density(wavelength);
  return {wavelength, xyz, xyz.y};
}

double solarIlluminance(const SpectrumSettings& settings) {
  constexpr double kLumensPerWatt = 683.002;
  const auto* continuous = std::get_if<ContinuousSpectrum>(&settings);
  const bool isAtGround = continuous && continuous->source == ContinuousSpectrum::Source::airMass1_5;
  const auto& power = isAtGround ? kSunAirMass1_5 : kSunExtraterrestrial;
  double sum = 0.0;
  for (std::size_t k = 0; k < power.size(); ++k) sum += power[k] * kObserver1931[k].y;
  return kLumensPerWatt * sum;
}

}  // namespace parhelion
