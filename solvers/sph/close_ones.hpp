#pragma once
/// The search among the particles of neighbouring cells, several at once where the processor can pack those that it
/// chose: half of the time of a dam break went into it, one at a time.

#if defined(__AVX2__)
#include <immintrin.h>
#endif

#include <array>
#include <cstddef>

namespace touchstone::sph {

/// How many ints `close_ones` may write beyond those that it found.
inline constexpr std::size_t close_ones_overrun = 8;

/// Writes those of `count` numbers, but `self`, whose places x, y are closer than `reach` to (at_x, at_y) to `found`,
/// in their order, and returns how many they are: one after the other.
inline std::size_t close_ones_in_turn(const double* x, const double* y, const int* numbers, int count, double at_x,
                                      double at_y, double reach, int self, int* found) {
  std::size_t close = 0;
  for (int k = 0; k < count; ++k) {
    const double dx = at_x - x[k], dy = at_y - y[k];
    found[close] = numbers[k];  // kept if it counts: no branch
    close += static_cast<std::size_t>((dx * dx + dy * dy < reach * reach) & (numbers[k] != self));
  }
  return close;
}

#if defined(__AVX2__) && !defined(__AVX512VL__)
/// By which lanes of four are chosen, the bytes that bring these to the front.
inline constexpr auto bytes_of_chosen = [] {
  std::array<std::array<signed char, 16>, 16> bytes{};
  for (int chosen = 0; chosen < 16; ++chosen)
    for (int lane = 0, to = 0; lane < 4; ++lane)
      if (chosen >> lane & 1)
        for (int byte = 0; byte < 4; ++byte) bytes[chosen][to++] = static_cast<signed char>(4 * lane + byte);
  return bytes;
}();
#endif

/// The same, eight or four at once where the processor can.
inline std::size_t close_ones(const double* x, const double* y, const int* numbers, int count, double at_x, double at_y,
                              double reach, int self, int* found) {
#if defined(__AVX512VL__)
  std::size_t close = 0;
  const __m512d all_x = _mm512_set1_pd(at_x), all_y = _mm512_set1_pd(at_y), reach2 = _mm512_set1_pd(reach * reach);
  for (int k = 0; k < count; k += 8) {
    const auto present = static_cast<__mmask8>(count - k < 8 ? (1 << (count - k)) - 1 : 0xff);
    const __m512d dx = _mm512_sub_pd(all_x, _mm512_maskz_loadu_pd(present, x + k));
    const __m512d dy = _mm512_sub_pd(all_y, _mm512_maskz_loadu_pd(present, y + k));
    const __m512d distance2 = _mm512_fmadd_pd(dx, dx, _mm512_mul_pd(dy, dy));
    const __m256i eight = _mm256_maskz_loadu_epi32(present, numbers + k);
    const __mmask8 others = _mm256_mask_cmpneq_epi32_mask(present, eight, _mm256_set1_epi32(self));
    const __mmask8 chosen = _mm512_mask_cmp_pd_mask(others, distance2, reach2, _CMP_LT_OQ);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(found + close), _mm256_maskz_compress_epi32(chosen, eight));
    close += static_cast<std::size_t>(__builtin_popcount(chosen));
  }
  return close;
#elif defined(__AVX2__)
  std::size_t close = 0;
  const __m256d all_x = _mm256_set1_pd(at_x), all_y = _mm256_set1_pd(at_y), reach2 = _mm256_set1_pd(reach * reach);
  const __m128i selves = _mm_set1_epi32(self);
  int k = 0;
  for (; k + 4 <= count; k += 4) {
    const __m256d dx = _mm256_sub_pd(all_x, _mm256_loadu_pd(x + k)), dy = _mm256_sub_pd(all_y, _mm256_loadu_pd(y + k));
    const __m256d distance2 = _mm256_add_pd(_mm256_mul_pd(dx, dx), _mm256_mul_pd(dy, dy));
    const __m128i four = _mm_loadu_si128(reinterpret_cast<const __m128i*>(numbers + k));
    const int is_self = _mm_movemask_ps(_mm_castsi128_ps(_mm_cmpeq_epi32(four, selves)));
    const int chosen = _mm256_movemask_pd(_mm256_cmp_pd(distance2, reach2, _CMP_LT_OQ)) & ~is_self;
    const __m128i order = _mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes_of_chosen[chosen].data()));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(found + close), _mm_shuffle_epi8(four, order));
    close += static_cast<std::size_t>(__builtin_popcount(chosen));
  }
  return close + close_ones_in_turn(x + k, y + k, numbers + k, count - k, at_x, at_y, reach, self, found + close);
#else
  return close_ones_in_turn(x, y, numbers, count, at_x, at_y, reach, self, found);
#endif
}

}  // namespace touchstone::sph
