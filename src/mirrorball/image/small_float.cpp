#include "mirrorball/image/small_float.h"

#include <cassert>
#include <cstddef>
#include <limits>

#if defined(__x86_64__)
#include <immintrin.h>

#include "mirrorball/base/bit_cast.h"
#endif

namespace mirrorball {
namespace {

constexpr float kLargest = kLargestSmallFloat<10>;
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::uint16_t kHalfOne = 0x3c00;

bool fits(float value) {
  const float size = bitCast<float>(bitCast<std::uint32_t>(value) & 0x7fffffffu);
  return !(size > kLargest && size < kInfinity);
}

bool portableHalves(const float* floats, std::size_t count, std::uint16_t* halves) {
  bool all_fit = true;
  for (std::size_t i = 0; i < count; ++i) {
    halves[i] = halfFromFloat(floats[i]);
    all_fit &= fits(floats[i]);
  }
  return all_fit;
}

bool portableRgba(const float* rgb, std::size_t texels, std::uint16_t* rgba) {
  bool all_fit = true;
  for (std::size_t i = 0; i < texels; ++i) {
    all_fit &= portableHalves(rgb + 3 * i, 3, rgba + 4 * i);
    rgba[4 * i + 3] = kHalfOne;
  }
  return all_fit;
}

void portableFloats(const std::uint16_t* halves, std::size_t count, float* floats) {
  for (std::size_t i = 0; i < count; ++i) floats[i] = floatFromHalf(halves[i]);
}

#if defined(__x86_64__)

/// Every processor with AVX2 has F16C, which clang 14 cannot ask for.
bool hasF16c() {
  static const bool has = __builtin_cpu_supports("avx2");
  return has;
}

/// Lanes of all ones where a finite value is beyond the largest half.
__attribute__((target("avx,f16c"))) inline __m256 beyondHalf(__m256 values) {
  const __m256 sizes = _mm256_andnot_ps(_mm256_set1_ps(-0.0f), values);
  return _mm256_and_ps(_mm256_cmp_ps(sizes, _mm256_set1_ps(kLargest), _CMP_GT_OQ),
                       _mm256_cmp_ps(sizes, _mm256_set1_ps(kInfinity), _CMP_LT_OQ));
}

__attribute__((target("avx,f16c"))) bool f16cHalves(const float* floats, std::size_t count, std::uint16_t* halves) {
  __m256 beyond = _mm256_setzero_ps();
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8) {
    const __m256 values = _mm256_loadu_ps(floats + i);
    beyond = _mm256_or_ps(beyond, beyondHalf(values));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(halves + i), _mm256_cvtps_ph(values, _MM_FROUND_TO_NEAREST_INT));
  }
  const bool all_fit = _mm256_movemask_ps(beyond) == 0;
  return portableHalves(floats + i, count - i, halves + i) && all_fit;
}

__attribute__((target("avx,f16c"))) bool f16cRgba(const float* rgb, std::size_t texels, std::uint16_t* rgba) {
  const __m256 one = _mm256_set1_ps(1.0f);
  __m256 beyond = _mm256_setzero_ps();
  std::size_t i = 0;
  // Two texels a step, each read with the sample behind it, which alpha replaces: the last texel has none behind it.
  for (; i + 3 <= texels; i += 2) {
    const __m128 first = _mm_loadu_ps(rgb + 3 * i);
    const __m128 second = _mm_loadu_ps(rgb + 3 * i + 3);
    const __m256 both = _mm256_insertf128_ps(_mm256_castps128_ps256(first), second, 1);
    const __m256 values = _mm256_blend_ps(both, one, 0x88);
    beyond = _mm256_or_ps(beyond, beyondHalf(values));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(rgba + 4 * i), _mm256_cvtps_ph(values, _MM_FROUND_TO_NEAREST_INT));
  }
  const bool all_fit = _mm256_movemask_ps(beyond) == 0;
  return portableRgba(rgb + 3 * i, texels - i, rgba + 4 * i) && all_fit;
}

__attribute__((target("avx,f16c"))) void f16cFloats(const std::uint16_t* halves, std::size_t count, float* floats) {
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8)
    _mm256_storeu_ps(floats + i, _mm256_cvtph_ps(_mm_loadu_si128(reinterpret_cast<const __m128i*>(halves + i))));
  portableFloats(halves + i, count - i, floats + i);
}

#endif

}  // namespace

bool halvesFromFloats(std::span<const float> floats, std::span<std::uint16_t> halves) {
  assert(floats.size() == halves.size());
#if defined(__x86_64__)
  if (hasF16c()) return f16cHalves(floats.data(), floats.size(), halves.data());
#endif
  return portableHalves(floats.data(), floats.size(), halves.data());
}

bool rgbaHalvesFromRgb(std::span<const float> rgb, std::span<std::uint16_t> rgba) {
  assert(rgb.size() % 3 == 0 && rgba.size() == rgb.size() / 3 * 4);
#if defined(__x86_64__)
  if (hasF16c()) return f16cRgba(rgb.data(), rgb.size() / 3, rgba.data());
#endif
  return portableRgba(rgb.data(), rgb.size() / 3, rgba.data());
}

void floatsFromHalves(std::span<const std::uint16_t> halves, std::span<float> floats) {
  assert(halves.size() == floats.size());
#if defined(__x86_64__)
  if (hasF16c()) return f16cFloats(halves.data(), halves.size(), floats.data());
#endif
  portableFloats(halves.data(), halves.size(), floats.data());
}

}  // namespace mirrorball
