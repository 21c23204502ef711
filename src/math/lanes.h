// SPDX-License-Identifier: Apache-2.0
#pragma once

// SIMD by the compiler's own vector types: several doubles side by side, one in each lane of a register. The same
// operation is done to all lanes at once.
//
// Every lane is computed in IEEE double precision by the same operations in the same order. So a result does not depend
// on the number of lanes. The templates of a number type T run on single doubles and on vectors of doubles alike.

#include <cmath>
#include <cstdint>
#include <cstring>

#include "math/inline.h"

// The header of all registers takes half a second to compile, that of the registers which every machine has none.
#if defined(__AVX2__)
#include <immintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace parhelion {

template <int W>
struct Lanes {
  using Real [[gnu::vector_size(W * sizeof(double))]] = double;
  using Mask [[gnu::vector_size(W * sizeof(double))]] = std::int64_t;  // all bits of a lane set or none
  using Words [[gnu::vector_size(W * sizeof(double))]] = std::uint64_t;
};

/// The types that go with a number type: Mask holds a truth value for each lane, Words an unsigned 64-bit integer.
template <class T>
struct LaneType {
  static constexpr int lanes = sizeof(T) / sizeof(double);
  using Mask = typename Lanes<lanes>::Mask;
  using Words = typename Lanes<lanes>::Words;
};
template <>
struct LaneType<double> {
  static constexpr int lanes = 1;
  using Mask = bool;
  using Words = std::uint64_t;
};
template <class T>
using MaskOf = typename LaneType<T>::Mask;
template <class T>
using WordsOf = typename LaneType<T>::Words;

/// The same bits, taken as another type of the same size.
template <class To, class From>
PARHELION_INLINE To bitsAs(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  std::memcpy(&to, &from, sizeof(To));
  return to;
}

/// a where `which` is true, else b, lane by lane.
PARHELION_INLINE double select(bool which, double a, double b) { return which ? a : b; }
PARHELION_INLINE double select(int which, double a, double b) { return which ? a : b; }  // bool | bool is an int
template <class Mask, class T>
PARHELION_INLINE T select(const Mask& which, const T& a, const T& b) {
#if defined(__AVX2__)
  if constexpr (sizeof(T) == 32) return _mm256_blendv_pd(b, a, bitsAs<__m256d>(which));
#endif
  return bitsAs<T>((which & bitsAs<Mask>(a)) | (~which & bitsAs<Mask>(b)));
}

PARHELION_INLINE double squareRoot(double x) { return std::sqrt(x); }
template <class T>
PARHELION_INLINE T squareRoot(const T& x) {
#if defined(__AVX512F__)
  if constexpr (sizeof(T) == 64) return _mm512_sqrt_pd(x);
#endif
#if defined(__AVX2__)
  if constexpr (sizeof(T) == 32) return _mm256_sqrt_pd(x);
#endif
#if defined(__SSE2__)
  if constexpr (sizeof(T) == 16) return _mm_sqrt_pd(x);
#endif
  T root;
  for (int k = 0; k < LaneType<T>::lanes; ++k) root[k] = __builtin_sqrt(x[k]);
  return root;
}

/// `value` in every lane.
template <class T>
PARHELION_INLINE T all(double value) {
  return T{} + value;
}
template <>
PARHELION_INLINE double all<double>(double value) {
  return value;
}

/// Reads the lanes that start at an address, and writes them back. The address need not be aligned.
template <class T>
PARHELION_INLINE T load(const void* from) {
  T lanes;
  std::memcpy(&lanes, from, sizeof(T));
  return lanes;
}
template <class T>
PARHELION_INLINE void store(void* to, const T& lanes) {
  std::memcpy(to, &lanes, sizeof(T));
}

/// The lower and the higher of two numbers, lane by lane. Where a is not a number, both are b.
template <class T>
PARHELION_INLINE T lower(const T& a, const T& b) {
  return select(a < b, a, b);
}
template <class T>
PARHELION_INLINE T higher(const T& a, const T& b) {
  return select(a > b, a, b);
}

/// The nearest whole number, for |x| < 2^51. Adding 1.5 * 2^52 leaves no digits behind the point.
template <class T>
PARHELION_INLINE T nearest(const T& x) {
  constexpr double kShift = 0x1.8p52;
  return (x + kShift) - kShift;
}

/// The largest whole number not above x, for |x| < 2^51. Of a zero, the sign has no meaning.
template <class T>
PARHELION_INLINE T wholePart(const T& x) {
#if defined(__AVX512F__)
  if constexpr (sizeof(T) == 64) return _mm512_floor_pd(x);
#endif
#if defined(__AVX2__)
  if constexpr (sizeof(T) == 32) return _mm256_floor_pd(x);
#endif
  const T whole = nearest(x);
  return select(whole > x, whole - 1.0, whole);
}

/// table[index], lane by lane. The indices are whole numbers from 0 to 2^51, held as doubles.
PARHELION_INLINE double lookUp(const double* table, double index) { return table[static_cast<std::int64_t>(index)]; }
template <class T>
PARHELION_INLINE T lookUp(const double* table, const T& index) {
  // In 2^52 + index the last bits are the index itself.
  constexpr std::int64_t kDigits = (std::int64_t{1} << 52) - 1;
  const MaskOf<T> place = bitsAs<MaskOf<T>>(index + 0x1p52) & kDigits;
  T found;
  for (int k = 0; k < LaneType<T>::lanes; ++k) found[k] = table[place[k]];
  return found;
}

/// Whether the mask is true in any lane.
PARHELION_INLINE bool anyOf(bool which) { return which; }

/// The mask as one bit for each lane; the first lane is the lowest bit.
template <class Mask>
PARHELION_INLINE unsigned bitsOf(const Mask& which) {
#if defined(__AVX512DQ__)
  if constexpr (sizeof(Mask) == 64) return _mm512_movepi64_mask(bitsAs<__m512i>(which));
#endif
#if defined(__AVX2__)
  if constexpr (sizeof(Mask) == 32) return static_cast<unsigned>(_mm256_movemask_pd(bitsAs<__m256d>(which)));
#endif
#if defined(__SSE2__)
  if constexpr (sizeof(Mask) == 16) return static_cast<unsigned>(_mm_movemask_pd(bitsAs<__m128d>(which)));
#endif
  unsigned bits = 0;
  for (std::size_t k = 0; k < sizeof(Mask) / sizeof(double); ++k) bits |= static_cast<unsigned>(which[k] & 1) << k;
  return bits;
}
template <class Mask>
PARHELION_INLINE bool anyOf(const Mask& which) {
  return bitsOf(which) != 0;
}

/// The low 32 bits of each lane times a number of 32 bits, as a product of 64 bits.
template <class Words>
PARHELION_INLINE Words product32(const Words& a, std::uint32_t b) {
#if defined(__AVX512F__)
  if constexpr (sizeof(Words) == 64) return bitsAs<Words>(_mm512_mul_epu32(bitsAs<__m512i>(a), _mm512_set1_epi64(b)));
#endif
#if defined(__AVX2__)
  if constexpr (sizeof(Words) == 32) return bitsAs<Words>(_mm256_mul_epu32(bitsAs<__m256i>(a), _mm256_set1_epi64x(b)));
#endif
#if defined(__SSE2__)
  if constexpr (sizeof(Words) == 16) return bitsAs<Words>(_mm_mul_epu32(bitsAs<__m128i>(a), _mm_set1_epi64x(b)));
#endif
  return (a & 0xFFFFFFFF) * std::uint64_t{b};
}

/// Packs the lanes where a mask is true side by side. Made once for a mask, it serves any number of vectors.
template <class T>
class Compress {
 public:
  explicit PARHELION_INLINE Compress(const MaskOf<T>& which) : bits_(bitsOf(which)) {
#if defined(__AVX2__)
    if constexpr (sizeof(T) == 32) order_ = load<__m256i>(kOrders[bits_]);
#endif
  }

  int count() const { return __builtin_popcount(bits_); }

  /// Writes the numbers of the mask's true lanes from `to` on, count() of them in their order. There must be room for
  /// all lanes of T; what is written behind the first count() has no meaning.
  PARHELION_INLINE void store(void* to, const T& numbers) const {
#if defined(__AVX512F__)
    if constexpr (sizeof(T) == 64) {
      parhelion::store(to, _mm512_maskz_compress_pd(static_cast<__mmask8>(bits_), numbers));
      return;
    }
#endif
#if defined(__AVX2__)
    if constexpr (sizeof(T) == 32) {
      parhelion::store(to, _mm256_permutevar8x32_epi32(bitsAs<__m256i>(numbers), order_));
      return;
    }
#endif
    auto* out = static_cast<unsigned char*>(to);
    for (int k = 0; k < LaneType<T>::lanes; ++k) {
      const double number = numbers[k];
      parhelion::store(out, number);
      out += (bits_ >> k & 1) * sizeof(double);
    }
  }

 private:
  unsigned bits_;
#if defined(__AVX2__)
  __m256i order_;
  // For each of the 16 masks of four lanes: the true lanes, each as its two halves of 32 bits.
  alignas(32) static constexpr std::int32_t kOrders[16][8] = {
      {0, 0, 0, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0, 0, 0}, {2, 3, 0, 0, 0, 0, 0, 0}, {0, 1, 2, 3, 0, 0, 0, 0},
      {4, 5, 0, 0, 0, 0, 0, 0}, {0, 1, 4, 5, 0, 0, 0, 0}, {2, 3, 4, 5, 0, 0, 0, 0}, {0, 1, 2, 3, 4, 5, 0, 0},
      {6, 7, 0, 0, 0, 0, 0, 0}, {0, 1, 6, 7, 0, 0, 0, 0}, {2, 3, 6, 7, 0, 0, 0, 0}, {0, 1, 2, 3, 6, 7, 0, 0},
      {4, 5, 6, 7, 0, 0, 0, 0}, {0, 1, 4, 5, 6, 7, 0, 0}, {2, 3, 4, 5, 6, 7, 0, 0}, {0, 1, 2, 3, 4, 5, 6, 7}};
#endif
};

/// A vector of three coordinates whose number type may be lanes; GLM's vectors serve single numbers.
template <class T>
struct Triple {
  T x, y, z;
};
template <class T>
PARHELION_INLINE Triple<T> operator+(const Triple<T>& a, const Triple<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
PARHELION_INLINE Triple<T> operator-(const Triple<T>& a, const Triple<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
PARHELION_INLINE Triple<T> operator-(const Triple<T>& v) {
  return {-v.x, -v.y, -v.z};
}
template <class T>
PARHELION_INLINE Triple<T> operator*(const T& s, const Triple<T>& v) {
  return {s * v.x, s * v.y, s * v.z};
}
template <class T>
PARHELION_INLINE T dot(const Triple<T>& a, const Triple<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
PARHELION_INLINE Triple<T> cross(const Triple<T>& a, const Triple<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
PARHELION_INLINE Triple<T> select(const MaskOf<T>& which, const Triple<T>& a, const Triple<T>& b) {
  return {select(which, a.x, b.x), select(which, a.y, b.y), select(which, a.z, b.z)};
}

/// rows[0 ... 2][index], lane by lane.
template <class T, class Row>
PARHELION_INLINE Triple<T> lookUpTriple(const Row* rows, const T& index) {
  return {lookUp(rows[0].data(), index), lookUp(rows[1].data(), index), lookUp(rows[2].data(), index)};
}

}  // namespace parhelion
