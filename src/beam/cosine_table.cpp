// SPDX-License-Identifier: Apache-2.0
#include "beam/cosine_table.h"

#include <algorithm>
#include <cmath>

#include "math/conventions.h"
#include "math/portable.h"

namespace parhelion {

namespace {

constexpr int kGroup = 8;

int groupsOf(int count) { return (count + kGroup - 1) / kGroup; }

}  // namespace

CosineTable::CosineTable(int cells) : cells_(cells), most_(groupsOf(cells / 2) * kGroup) {
  // A wave has four times as many steps as half a ring has cells.
  std::vector<float> wave;
  for (int k = 0; k < 4 * cells; ++k) wave.push_back(static_cast<float>(portable::cos(0.5 * kPi * k / cells)));
  const auto cosine = [&](int order, int cell) {
    return order < cells_ ? wave[static_cast<std::size_t>(static_cast<long>(order) * (2 * cell + 1) % (4 * cells))]
                          : 0.0F;
  };
  const int half = cells / 2;
  for (int parity = 0; parity < 2; ++parity)
    for (int group = 0; group < most_ / kGroup; ++group)
      for (int cell = 0; cell < half; ++cell) {
        EightFloats eight{};
        for (int k = 0; k < kGroup; ++k) eight[k] = cosine(2 * (group * kGroup + k) + parity, cell);
        byCell_.push_back(eight);
      }
  for (int parity = 0; parity < 2; ++parity)
    for (int group = 0; group < groupsOf(half); ++group)
      for (int order = 0; order < most_; ++order) {
        EightFloats eight{};
        for (int k = 0; k < kGroup; ++k)
          if (const int cell = group * kGroup + k; cell < half) eight[k] = cosine(2 * order + parity, cell);
        byOrder_.push_back(eight);
      }
}

int CosineTable::room(double orders) const {
  return std::clamp(groupsOf(static_cast<int>(std::min(0.5 * orders, 1e8)) + 1) * kGroup, kGroup, most_);
}

template <int C>
PARHELION_ALSO_AVX2 void CosineTable::analyse(const std::vector<CellPair<C>>& pairs, int room, float* orders) const {
  for (int parity = 0; parity < 2; ++parity)
    for (int group = 0; group < room / kGroup; ++group) {
      const EightFloats* cosines =
          byCell_.data() + static_cast<std::ptrdiff_t>(parity * (most_ / kGroup) + group) * (cells_ / 2);
      EightFloats sum[C] = {};
      for (const CellPair<C>& pair : pairs) {
        const EightFloats& cosine = cosines[pair.cell];
        const std::array<float, C>& light = parity ? pair.difference : pair.sum;
        for (int c = 0; c < C; ++c) sum[c] += light[static_cast<std::size_t>(c)] * cosine;
      }
      for (int c = 0; c < C; ++c) {
        float* const to = orders + (c * 2 + parity) * room + group * kGroup;
        for (int k = 0; k < kGroup; ++k) to[k] += sum[c][k];
      }
    }
}

template void CosineTable::analyse<2>(const std::vector<CellPair<2>>&, int, float*) const;
template void CosineTable::analyse<4>(const std::vector<CellPair<4>>&, int, float*) const;

template <int C>
PARHELION_ALSO_AVX2 void CosineTable::synthesise(const float* orders, int room, float* cells) const {
  // Two groups of cells at a time, so that additions need not wait for one another.
  constexpr int kTogether = 2;
  const int half = cells_ / 2, groups = groupsOf(half);
  for (int first = 0; first < groups; first += kTogether) {
    EightFloats sum[2][kTogether][C] = {};
    for (int parity = 0; parity < 2; ++parity) {
      const EightFloats* cosines[kTogether];
      for (int g = 0; g < kTogether; ++g)
        cosines[g] =
            byOrder_.data() + static_cast<std::ptrdiff_t>(parity * groups + std::min(first + g, groups - 1)) * most_;
      EightFloats own[kTogether][C] = {};
      for (int order = 0; order < room; ++order) {
        float light[C];
        for (int c = 0; c < C; ++c) light[c] = orders[(c * 2 + parity) * room + order];
        for (int g = 0; g < kTogether; ++g) {
          const EightFloats cosine = cosines[g][order];
          for (int c = 0; c < C; ++c) own[g][c] += light[c] * cosine;
        }
      }
      for (int g = 0; g < kTogether; ++g)
        for (int c = 0; c < C; ++c) sum[parity][g][c] = own[g][c];
    }
    for (int k = 0; k < kTogether * kGroup; ++k) {
      const int cell = first * kGroup + k;
      if (cell >= half) break;
      for (int c = 0; c < C; ++c) {
        const float even = sum[0][k / kGroup][c][k % kGroup], odd = sum[1][k / kGroup][c][k % kGroup];
        cells[4 * cell + c] = even + odd;
        cells[4 * (cells_ - 1 - cell) + c] = even - odd;
      }
    }
  }
}

template void CosineTable::synthesise<2>(const float*, int, float*) const;
template void CosineTable::synthesise<4>(const float*, int, float*) const;

}  // namespace parhelion
