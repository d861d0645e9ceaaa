// Implements the loops with eight lanes (AVX2).

#include <cstdint>

#include <immintrin.h>

#include "renderers/pd_gradient/loops/sample_loops.h"
#include "renderers/pd_gradient/loops/triangle_loops.h"

namespace asperity {
namespace {

struct Lanes {
  static constexpr int kWidth = 8;
  using Floats = __m256;
  using Ints = __m256i;
  using Mask = __m256;

  static Floats load(const float* from) { return _mm256_loadu_ps(from); }
  static void store(float* to, Floats a) { _mm256_storeu_ps(to, a); }
  static void store(std::int32_t* to, Ints a) {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), a);
  }
  static Floats all(float a) { return _mm256_set1_ps(a); }
  static Ints counted_from(int first) {
    return _mm256_add_epi32(_mm256_set1_epi32(first), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
  }
  static Floats add(Floats a, Floats b) { return _mm256_add_ps(a, b); }
  static Floats sub(Floats a, Floats b) { return _mm256_sub_ps(a, b); }
  static Floats mul(Floats a, Floats b) { return _mm256_mul_ps(a, b); }
  static Floats div(Floats a, Floats b) { return _mm256_div_ps(a, b); }
  static Floats sqrt(Floats a) { return _mm256_sqrt_ps(a); }
  static Floats max(Floats a, Floats b) { return _mm256_max_ps(a, b); }
  static Floats min(Floats a, Floats b) { return _mm256_min_ps(a, b); }
  static Floats as_float(Ints a) { return _mm256_cvtepi32_ps(a); }
  static Ints ceiling(Floats a) {
    const Ints cut = _mm256_cvttps_epi32(a);
    const Mask short_of_it = _mm256_cmp_ps(_mm256_cvtepi32_ps(cut), a, _CMP_LT_OQ);
    return _mm256_sub_epi32(cut, _mm256_castps_si256(short_of_it));
  }
  // a·2ⁿ, by adding to the exponent's bits: neither a nor the result may be 0 or out of range.
  static Floats times_power_of_two(Floats a, Ints n) {
    return _mm256_castsi256_ps(_mm256_add_epi32(_mm256_castps_si256(a), _mm256_slli_epi32(n, 23)));
  }
  static Mask less(Floats a, Floats b) { return _mm256_cmp_ps(a, b, _CMP_LT_OQ); }
  static Mask both(Mask a, Mask b) { return _mm256_and_ps(a, b); }
  static Mask within(Ints at, std::int32_t first, std::int32_t end) {
    return _mm256_castsi256_ps(_mm256_andnot_si256(_mm256_cmpgt_epi32(_mm256_set1_epi32(first), at),
                                                   _mm256_cmpgt_epi32(_mm256_set1_epi32(end), at)));
  }
  static Floats choose(Mask where, Floats yes, Floats no) {
    return _mm256_blendv_ps(no, yes, where);
  }
  static void store_where(float* to, Mask where, Floats a) {
    store(to, choose(where, a, load(to)));
  }
  static Mask mask(unsigned bits) {
    const Ints of_lane = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    const Ints own = _mm256_and_si256(_mm256_set1_epi32(static_cast<int>(bits)), of_lane);
    return _mm256_castsi256_ps(_mm256_cmpeq_epi32(own, of_lane));
  }
  static unsigned bits(Mask a) { return static_cast<unsigned>(_mm256_movemask_ps(a)); }
  static float largest(Floats a) {
    const __m128 four = _mm_max_ps(_mm256_castps256_ps128(a), _mm256_extractf128_ps(a, 1));
    const __m128 two = _mm_max_ps(four, _mm_movehl_ps(four, four));
    return _mm_cvtss_f32(_mm_max_ps(two, _mm_shuffle_ps(two, two, 1)));
  }

  // 16384 times the texture at non-negative positions.
  static Floats texture(const PairedTexels& texels, Floats x, Floats y) {
    const Ints column = _mm256_cvttps_epi32(x);
    const Ints row = _mm256_cvttps_epi32(y);
    const Floats right = _mm256_sub_ps(x, _mm256_cvtepi32_ps(column));
    const Floats down = _mm256_sub_ps(y, _mm256_cvtepi32_ps(row));
    const Ints index =
        _mm256_add_epi32(_mm256_madd_epi16(row, _mm256_set1_epi32(texels.pitch)), column);
    alignas(32) std::uint64_t at[kWidth / 2];
    _mm256_store_si256(reinterpret_cast<__m256i*>(at), index);
    asm("" : "+m"(at));  // through memory: extracting the indices lane by lane takes longer
    const auto two = [&texels, &at](int i) {
      const auto* p =
          reinterpret_cast<const __m128i*>(texels.pairs + static_cast<std::uint32_t>(at[i]));
      const auto* q = reinterpret_cast<const __m64*>(texels.pairs + (at[i] >> 32));
      return _mm_castps_si128(_mm_loadh_pi(_mm_castsi128_ps(_mm_loadl_epi64(p)), q));
    };
    const Ints evens = _mm256_set_m128i(two(2), two(0));
    const Ints odds = _mm256_set_m128i(two(3), two(1));
    const Ints lower = _mm256_cvttps_epi32(
        _mm256_add_ps(_mm256_mul_ps(down, _mm256_set1_ps(16384.0F)), _mm256_set1_ps(0.5F)));
    const Ints weights = _mm256_or_si256(_mm256_slli_epi32(lower, 16),
                                         _mm256_sub_epi32(_mm256_set1_epi32(16384), lower));
    const Floats first =
        _mm256_castsi256_ps(_mm256_madd_epi16(evens, _mm256_unpacklo_epi32(weights, weights)));
    const Floats second =
        _mm256_castsi256_ps(_mm256_madd_epi16(odds, _mm256_unpackhi_epi32(weights, weights)));
    const Floats here =
        _mm256_cvtepi32_ps(_mm256_castps_si256(_mm256_shuffle_ps(first, second, 0x88)));
    const Floats next =
        _mm256_cvtepi32_ps(_mm256_castps_si256(_mm256_shuffle_ps(first, second, 0xdd)));
    return _mm256_add_ps(here, _mm256_mul_ps(right, _mm256_sub_ps(next, here)));
  }
};

struct DoubleLanes {
  static constexpr int kWidth = 4;
  using Doubles = __m256d;
  using Mask = __m256d;

  static Doubles load(const double* from) { return _mm256_load_pd(from); }
  static void store(double* to, Doubles a) { _mm256_store_pd(to, a); }
  static Doubles all(double a) { return _mm256_set1_pd(a); }
  static Doubles add(Doubles a, Doubles b) { return _mm256_add_pd(a, b); }
  static Doubles sub(Doubles a, Doubles b) { return _mm256_sub_pd(a, b); }
  static Doubles mul(Doubles a, Doubles b) { return _mm256_mul_pd(a, b); }
  static Doubles div(Doubles a, Doubles b) { return _mm256_div_pd(a, b); }
  static Doubles sqrt(Doubles a) { return _mm256_sqrt_pd(a); }
  static Mask less(Doubles a, Doubles b) { return _mm256_cmp_pd(a, b, _CMP_LT_OQ); }
  static Mask both(Mask a, Mask b) { return _mm256_and_pd(a, b); }
  static Mask either(Mask a, Mask b) { return _mm256_or_pd(a, b); }
  static Mask differ(Mask a, Mask b) { return _mm256_xor_pd(a, b); }
  static Doubles choose(Mask where, Doubles yes, Doubles no) {
    return _mm256_blendv_pd(no, yes, where);
  }
};

}  // namespace
}  // namespace asperity

#include "renderers/pd_gradient/loops/kept_loops_of_lanes.h"
#include "renderers/pd_gradient/loops/sample_loops_of_lanes.h"
#include "renderers/pd_gradient/loops/segment_loop_of_lanes.h"
#include "renderers/pd_gradient/loops/smooth_loop_of_lanes.h"
#include "renderers/pd_gradient/loops/triangle_loops_of_lanes.h"

namespace asperity {
const SampleLoops kAvx2Loops{sample_surface_by_lanes, compare_by_lanes,      weigh_by_lanes,
                             bound_rows_by_lanes,     compare_kept_by_lanes, weigh_kept_by_lanes};
const TriangleLoops kAvx2TriangleLoops{find_candidates_by_lanes, judge_pairs_by_lanes,
                                       use_slack_by_lanes, find_in_box_by_lanes,
                                       cut_pairs_by_lanes};
}  // namespace asperity
