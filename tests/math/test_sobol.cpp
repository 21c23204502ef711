// SPDX-License-Identifier: Apache-2.0
#include "math/sobol.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "random_stream.h"
#include "statistics.h"

using namespace parhelion;

namespace {

constexpr std::uint64_t kSecondBlock = std::uint64_t{1} << 32;

// Without scramble, in [0, 1).
double plainCoordinate(std::uint32_t index, int dimension) {
  const std::uint32_t digits = sobolDigits(index, dimension);
  double x = 0.0;
  for (int k = 0; k < 32; ++k)
    if (digits >> k & 1) x += std::ldexp(1.0, -k - 1);
  return x;
}

// Which bits of the index the digit of weight 2^-(k + 1) adds up.
std::uint32_t digitRow(int dimension, int k) {
  std::uint32_t row = 0;
  for (int bit = 0; bit < 32; ++bit) row |= (sobolDigits(std::uint32_t{1} << bit, dimension) >> k & 1) << bit;
  return row;
}

// Over the field of two elements, by elimination.
bool independent(const std::vector<std::uint32_t>& rows) {
  std::vector<std::uint32_t> pivots;
  for (std::uint32_t row : rows) {
    for (const std::uint32_t pivot : pivots) row = std::min(row, row ^ pivot);
    if (row == 0) return false;
    pivots.push_back(row);
  }
  return true;
}

std::vector<double> coordinates(const SobolPoints& points, std::uint64_t first, int count, int dimension) {
  std::vector<std::uint64_t> indices(count);
  std::iota(indices.begin(), indices.end(), first);
  std::vector<double> x(count);
  points.fill(indices.data(), count, dimension, x.data());
  return x;
}

int cellOf(double x, int cells) { return static_cast<int>(x * cells); }

// Chi-square, in sigmas, of `pairAt(0)`, `pairAt(1)`, ... against an even spread over the unit square.
double squareSigma(const std::function<std::pair<double, double>(int)>& pairAt) {
  constexpr int kPairs = 100000, kGrid = 16;
  std::vector<double> counts(kGrid * kGrid, 0.0);
  for (int i = 0; i < kPairs; ++i) {
    const auto [x, y] = pairAt(i);
    ++counts[cellOf(x, kGrid) * kGrid + cellOf(y, kGrid)];
  }
  return chiSquareSigma(counts, std::vector<double>(kGrid * kGrid, kPairs / double(kGrid * kGrid)));
}

// One number of each of 2^k equal cells?
bool onePerCell(const std::vector<double>& x) {
  std::set<int> cells;
  for (const double value : x) cells.insert(cellOf(value, static_cast<int>(x.size())));
  return cells.size() == x.size();
}

// Points whose cells of width 2^-a by 2^-b, a + b = k, each hold one of 2^k points.
bool isPlaneNet(const std::vector<double>& x, const std::vector<double>& y) {
  const int count = static_cast<int>(x.size());
  for (int columns = 1; columns <= count; columns *= 2) {
    std::set<int> cells;
    for (int i = 0; i < count; ++i)
      cells.insert(cellOf(x[i], columns) * (count / columns) + cellOf(y[i], count / columns));
    if (cells.size() != x.size()) return false;
  }
  return true;
}

}  // namespace

// The first ten points that Joe & Kuo print for three dimensions; their Gray code order visits index i ^ i / 2 as i-th.
TEST_CASE("Sobol points without scramble begin as published") {
  constexpr double kPublished[10][3] = {{0.0, 0.0, 0.0},         {0.5, 0.5, 0.5},       {0.75, 0.25, 0.25},
                                        {0.25, 0.75, 0.75},      {0.375, 0.375, 0.625}, {0.875, 0.875, 0.125},
                                        {0.625, 0.125, 0.875},   {0.125, 0.625, 0.375}, {0.1875, 0.3125, 0.9375},
                                        {0.6875, 0.8125, 0.4375}};
  for (std::uint32_t i = 0; i < 10; ++i)
    for (int dimension = 0; dimension < 3; ++dimension)
      CHECK(plainCoordinate(i ^ i / 2, dimension) == kPublished[i][dimension]);
}

// Sobol's property A: the first 2^d points fall one in each of the 2^d parts that halving all d axes makes. Joe & Kuo's
// table has it in all dimensions.
TEST_CASE("Sobol points have property A in any number of leading dimensions") {
  for (int d = 1; d <= kSobolDimensions; ++d) {
    std::vector<std::uint32_t> rows;
    for (int dimension = 0; dimension < d; ++dimension) rows.push_back(digitRow(dimension, 0) << (32 - d));
    CAPTURE(d);
    CHECK(independent(rows));
  }
}

// Distinct primitive polynomials of degrees r and s make 2^32 points of two dimensions a net of quality t = r + s - 2:
// any 32 - t leading digits of the two are independent. Sobol' 1967.
TEST_CASE("any two Sobol dimensions have the net quality of primitive polynomials") {
  std::vector<int> degrees{1};
  constexpr int kPolynomials[] = {1, 1, 2, 2, 6, 6, 13};
  for (int degree = 1; degree <= 7; ++degree) degrees.insert(degrees.end(), kPolynomials[degree - 1], degree);
  REQUIRE(degrees.size() == kSobolDimensions);
  for (int j = 1; j < kSobolDimensions; ++j)
    for (int i = 0; i < j; ++i)
      for (int ofFirst = 0, digits = 34 - degrees[i] - degrees[j]; ofFirst <= digits; ++ofFirst) {
        std::vector<std::uint32_t> rows;
        for (int k = 0; k < digits; ++k) rows.push_back(k < ofFirst ? digitRow(i, k) : digitRow(j, k - ofFirst));
        CAPTURE(i);
        CAPTURE(j);
        CHECK(independent(rows));
      }
}

TEST_CASE("every aligned block of scrambled Sobol points is stratified in every dimension") {
  const SobolPoints points(5);
  for (int dimension = 0; dimension < kSobolDimensions; ++dimension)
    for (const int count : {2, 64, 1024, 8192})
      for (const std::uint64_t block : {0, 1, 5, 1000}) {
        CAPTURE(dimension);
        CHECK(onePerCell(coordinates(points, block * count, count, dimension)));
        CHECK(onePerCell(coordinates(points, 7 * kSecondBlock + block * count, count, dimension)));
      }
}

TEST_CASE("every aligned block of the first two scrambled dimensions is a net of the square") {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const SobolPoints points(seed);
    for (const int count : {4, 128, 4096})
      for (const std::uint64_t start : {std::uint64_t{0}, std::uint64_t{77} * count, kSecondBlock + 3 * count})
        CHECK(isPlaneNet(coordinates(points, start, count, 0), coordinates(points, start, count, 1)));
  }
}

TEST_CASE("over the seeds a fixed point is uniform, and so are its digits below 2^-32") {
  const auto uniform = [](double x) { return x; };
  for (const std::uint64_t index : {std::uint64_t{0}, std::uint64_t{12345}, 3 * kSecondBlock + 6}) {
    std::vector<double> whole, tail;
    for (std::uint64_t seed = 0; seed < 20000; ++seed) {
      const double x = SobolPoints(seed).at(index, 4);
      whole.push_back(x);
      tail.push_back(std::fmod(x * 0x1p32, 1.0));
    }
    CHECK(chiSquareSigma(whole, uniform, 0.0, 1.0, 128) < kSigmas);
    CHECK(chiSquareSigma(tail, uniform, 0.0, 1.0, 128) < kSigmas);
  }
}

// What decides the variance of an estimate: two points that first differ at digit k still do, and the digits after it
// are uniform, independent of each other and of the first point.
TEST_CASE("over the seeds a pair of points is distributed as Owen's scramble has it") {
  constexpr int kSeeds = 20000, kDimension = 2;
  for (const std::uint32_t other : {1u, 2u, 4u, 6u, 9u, 16u, 40u}) {
    const int same = std::countr_zero(sobolDigits(8, kDimension) ^ sobolDigits(8 ^ other, kDimension));
    std::vector<double> counts(256, 0.0);
    bool keptDigit = true;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const SobolPoints points(seed);
      const double a = points.at(8, kDimension), b = points.at(8 ^ other, kDimension);
      const int cells = 1 << (same + 5);
      const int differing = cellOf(a, cells) ^ cellOf(b, cells);
      keptDigit = keptDigit && differing >> 4 == 1;
      ++counts[(differing & 15) * 16 + cellOf(a, 16)];
    }
    CAPTURE(other);
    CHECK(keptDigit);
    CHECK(chiSquareSigma(counts, std::vector<double>(256, kSeeds / 256.0)) < kSigmas);
  }
}

TEST_CASE("scrambles of different seeds, dimensions and blocks of 2^32 points are independent") {
  const auto at = [](std::uint64_t seed, std::uint64_t index, int dimension) {
    return SobolPoints(seed).at(index, dimension);
  };
  CHECK(squareSigma([&](int i) { return std::pair(at(2 * i, 3, 1), at(2 * i + 1, 3, 1)); }) < kSigmas);
  CHECK(squareSigma([&](int i) { return std::pair(at(i, 3, 1), at(i * kSecondBlock, 3, 1)); }) < kSigmas);
  CHECK(squareSigma([&](int i) { return std::pair(at(i, 3, 0), at(i, 3, 1)); }) < kSigmas);
  CHECK(squareSigma([&](int i) { return std::pair(at(i, 3, 1), at(i, 3 + kSecondBlock, 1)); }) < kSigmas);
}

TEST_CASE("a coordinate has the same bits alone and in any batch, and is the centre of one of 2^52 cells") {
  const SobolPoints points(9);
  RandomStream random(1, 2, RandomPurpose::path);
  std::vector<std::uint64_t> indices;
  for (std::uint64_t i = 0; i < 150; ++i) indices.push_back(1000005 + i);
  for (std::uint64_t i = 0; i < 100; ++i) indices.push_back(kSecondBlock - 50 + i);
  for (std::uint64_t i = 0; i < 100; ++i) indices.push_back((std::uint64_t{1} << 40) - i * i);
  for (int i = 0; i < 300; ++i) indices.push_back(static_cast<std::uint64_t>(random.next() * 0x1p64));
  for (const int count : {1, 63, 64, 65, 650})
    for (int dimension = 0; dimension < kSobolDimensions; ++dimension) {
      std::vector<double> batch(count);
      points.fill(indices.data(), count, dimension, batch.data());
      for (int i = 0; i < count; ++i) {
        const double x = points.at(indices[i], dimension);
        CHECK(batch[i] == x);
        CHECK(x == toUnitInterval(static_cast<std::uint64_t>(x * 0x1p52) << 12));
      }
    }
}

// The integral is 1. Random points have slope -1; the smooth function's limit for scrambled nets is -3 up to
// logarithms.
TEST_CASE("the variance of a smooth integral in four dimensions falls faster than the square of the number of points") {
  constexpr int kReplicates = 64, kDimensions = 4, kFewest = 5, kMost = 12;
  std::vector<SampleMean> estimates(kMost + 1);
  for (std::uint64_t seed = 0; seed < kReplicates; ++seed) {
    const SobolPoints points(seed);
    std::vector<double> product(1 << kMost, 1.0);
    for (int dimension = 0; dimension < kDimensions; ++dimension) {
      const auto x = coordinates(points, 0, 1 << kMost, dimension);
      for (std::size_t i = 0; i < x.size(); ++i) product[i] *= std::exp(x[i] / 2.0) * 0.5 / std::expm1(0.5);
    }
    for (int k = kFewest; k <= kMost; ++k)
      estimates[k].add(std::accumulate(product.begin(), product.begin() + (1 << k), 0.0) / (1 << k));
  }
  double slope = 0.0, squares = 0.0;
  for (int k = kFewest; k <= kMost; ++k) {
    const double step = k - (kFewest + kMost) / 2.0;
    slope += step * std::log2(estimates[k].variance());
    squares += step * step;
    CAPTURE(k);
    CHECK(estimates[k].sigmasFrom(1.0) < 4.0);
  }
  CHECK(slope / squares < -2.3);
}
