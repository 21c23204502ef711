// SPDX-License-Identifier: Apache-2.0
#include "recon/published/low_pass.h"

#include <algorithm>
#include <cmath>

#include "parallel/loops.h"
#include "recon/published/fourier.h"
#include "recon/published/sinc_kernel.h"

namespace parhelion {

namespace {

using Complex = std::complex<double>;

// Zeros of the sinc inside the kernel. With one it is positive; with two it rings, and errors grow by a third.
constexpr double kLobes = 1.0;

// Pixels from the kernel's centre to its end along one axis. No two pixels are as far apart as the side.
int kernelReach(double period, int side) { return static_cast<int>(std::min(std::ceil(kLobes * period), side - 1.0)); }

Raster<double> sincTransfer(int width, int height, int reachX, int reachY, double period) {
  Raster<Complex> kernel(width, height);
  double sum = 0.0;
  for (int dy = -reachY; dy <= reachY; ++dy) {
    for (int dx = -reachX; dx <= reachX; ++dx) {
      const double weight = windowedSinc(std::sqrt(dx * dx + dy * dy), period, kLobes);
      kernel.at(((dx % width) + width) % width, ((dy % height) + height) % height) += weight;
      sum += weight;
    }
  }
  fourier(kernel, false);
  Raster<double> transfer(width, height);
  for (std::size_t i = 0; i < transfer.size(); ++i) transfer[i] = kernel[i].real() / sum;
  return transfer;
}

}  // namespace

void LowPass::filterPair(const std::vector<Raster<double>>& pictures, std::size_t first,
                         std::vector<Raster<double>>& out) const {
  // An even kernel has a real transfer function, so two pictures pass as one of complex values.
  const bool two = first + 1 < pictures.size();
  Raster<Complex> values(transfer_.width(), transfer_.height());
  const int width = pictures[first].width(), height = pictures[first].height();
  forRows(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      values.at(x, y) = {pictures[first].at(x, y), two ? pictures[first + 1].at(x, y) : 0.0};
    }
  });
  fourier(values, false);
  const double scale = 1.0 / static_cast<double>(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] *= transfer_[i] * scale;
  fourier(values, true);
  for (std::size_t k = first; k < first + (two ? 2 : 1); ++k) {
    out.emplace_back(width, height);
    forRows(height, [&](int y) {
      for (int x = 0; x < width; ++x) out[k].at(x, y) = k == first ? values.at(x, y).real() : values.at(x, y).imag();
    });
  }
}

std::vector<Raster<double>> LowPass::operator()(const std::vector<Raster<double>>& pictures) const {
  std::vector<Raster<double>> out;
  for (std::size_t first = 0; first < pictures.size(); first += 2) filterPair(pictures, first, out);
  return out;
}

bool passes(int kx, int periodX, int ky, int periodY, double period) {
  const double fx = 2.0 * period * kx / periodX, fy = 2.0 * period * ky / periodY;
  constexpr double kRounding = 1e-12;  // frequencies on the circle are inside it
  return fx * fx + fy * fy <= 1.0 + kRounding;
}

LowPass idealLowPass(int width, int height, double period) {
  Raster<double> transfer(width, height);
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      const bool pass = passes(signedFrequency(i, width), width, signedFrequency(j, height), height, period);
      transfer.at(i, j) = pass ? 1.0 : 0.0;
    }
  }
  return LowPass(std::move(transfer));
}

LowPass sincLowPass(int width, int height, double period, bool wrapX, bool wrapY) {
  const int reachX = kernelReach(period, width), reachY = kernelReach(period, height);
  return LowPass(sincTransfer(wrapX ? width : fastLength(width + reachX), wrapY ? height : fastLength(height + reachY),
                              reachX, reachY, period));
}

SkyLowPass::SkyLowPass(const HitMap& map, double period)
    : filter_(sincLowPass(map.width(), map.height(), period, map.wrapX, map.wrapY)) {
  gain_ = filter_({map.omega})[0];
  for (std::size_t i = 0; i < gain_.size(); ++i) gain_[i] = map.omega[i] > 0.0 ? 1.0 / gain_[i] : 0.0;
}

std::vector<Raster<double>> SkyLowPass::operator()(const std::vector<Raster<double>>& light) const {
  std::vector<Raster<double>> out = filter_(light);
  for (Raster<double>& picture : out) {
    for (std::size_t i = 0; i < picture.size(); ++i) picture[i] *= gain_[i];
  }
  return out;
}

}  // namespace parhelion
