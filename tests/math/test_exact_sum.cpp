// SPDX-License-Identifier: Apache-2.0
#include "math/exact_sum.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <doctest/doctest.h>

#include "random_stream.h"

using namespace parhelion;

namespace {

/// Terms of both signs over twelve decades.
std::vector<double> someTerms(int count) {
  RandomStream random(1, 0, RandomPurpose::path);
  std::vector<double> terms;
  for (int i = 0; i < count; ++i) {
    const double magnitude = std::pow(10.0, -6.0 + 12.0 * random.next());
    terms.push_back(random.next() < 0.5 ? magnitude : -magnitude);
  }
  return terms;
}

ExactSum sumOf(const std::vector<double>& terms) {
  ExactSum sum;
  for (const double x : terms) sum.add(x);
  return sum;
}

}  // namespace

TEST_CASE("an exact sum is the same in any order") {
  auto terms = someTerms(10000);
  const ExactSum forward = sumOf(terms);
  std::reverse(terms.begin(), terms.end());
  CHECK(sumOf(terms) == forward);
  std::sort(terms.begin(), terms.end());
  CHECK(sumOf(terms) == forward);
}

TEST_CASE("an exact sum is the same however its parts are merged") {
  const auto terms = someTerms(9000);
  const auto part = [&](int from, int to) {
    return sumOf(std::vector<double>(terms.begin() + from, terms.begin() + to));
  };
  ExactSum left = part(0, 10), right = part(5000, 9000), middle = part(10, 5000);
  left.merge(middle);
  left.merge(right);
  middle.merge(right);
  ExactSum other = middle;
  other.merge(part(0, 10));
  CHECK(left == other);
  CHECK(left == sumOf(terms));
}

TEST_CASE("an exact sum is off by no more than 2^-41 a term") {
  const auto terms = someTerms(10000);
  long double truth = 0.0L;
  for (const double x : terms) truth += x;
  CHECK(std::abs(static_cast<double>(sumOf(terms).value() - truth)) <= 10000 * 0x1p-41);
}

TEST_CASE("small terms do not vanish beside a large sum") {
  ExactSum sum;
  for (int i = 0; i < 1 << 20; ++i) sum.add(0x1p22);  // 2^42 together
  for (int i = 0; i < 1000; ++i) sum.add(0x1p-10);
  for (int i = 0; i < 1 << 20; ++i) sum.add(-0x1p22);
  CHECK(sum.value() == 1000 * 0x1p-10);
}

TEST_CASE("an exact sum takes terms far beyond 64 bits of its unit") {
  // Of a path some thousand times as long as the crystal's side, the square; and what would be it, were it longer.
  for (const double term : {0x1p23, 1e9, 4e10, 1e20, 0x1p86}) {
    ExactSum sum, negative;
    sum.add(term);
    negative.add(-term);
    CHECK(sum.value() == term);
    CHECK(negative.value() == -term);
    sum.add(0x1p-40);
    sum.merge(negative);
    CHECK(sum.value() == 0x1p-40);
  }
}

TEST_CASE("an exact sum says so when it cannot hold a term, their sum, or what is no number") {
  ExactSum sum;
  for (const double term : {0x1p87, -1e300, HUGE_VAL, std::nan("")})
    CHECK_THROWS_AS(sum.add(term), std::overflow_error);
  CHECK(sum == ExactSum{});
  sum.add(0x1p86);
  const ExactSum half = sum;
  CHECK_THROWS_AS(sum.add(0x1p86), std::overflow_error);
  sum = half;
  CHECK_THROWS_AS(sum.merge(half), std::overflow_error);
  sum = half;
  CHECK_THROWS_AS(sum.addUnits(ExactSum::Units{1} << 126), std::overflow_error);
}
