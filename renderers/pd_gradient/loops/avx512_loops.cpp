// Implements the loops with sixteen lanes; requires AVX-512 F and BW.

#include <cstdint>

#include <immintrin.h>

#include "renderers/pd_gradient/loops/sample_loops.h"
#include "renderers/pd_gradient/loops/triangle_loops.h"

namespace asperity {
namespace {

struct Lanes {
  static constexpr int kWidth = 16;
  using Floats = __m512;
  using Ints = __m512i;
  using Mask = __mmask16;

  static Floats load(const float* from) { return _mm512_loadu_ps(from); }
  static void store(float* to, Floats a) { _mm512_storeu_ps(to, a); }
  static void store(std::int32_t* to, Ints a) { _mm512_storeu_si512(to, a); }
  static Floats all(float a) { return _mm512_set1_ps(a); }
  static Ints counted_from(int first) {
    return _mm512_add_epi32(_mm512_set1_epi32(first), _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8,
                                                                        9, 10, 11, 12, 13, 14, 15));
  }
  static Floats add(Floats a, Floats b) { return _mm512_add_ps(a, b); }
  static Floats sub(Floats a, Floats b) { return _mm512_sub_ps(a, b); }
  static Floats mul(Floats a, Floats b) { return _mm512_mul_ps(a, b); }
  static Floats div(Floats a, Floats b) { return _mm512_div_ps(a, b); }
  static Floats sqrt(Floats a) { return _mm512_sqrt_ps(a); }
  static Floats max(Floats a, Floats b) { return _mm512_max_ps(a, b); }
  static Floats min(Floats a, Floats b) { return _mm512_min_ps(a, b); }
  static Floats as_float(Ints a) { return _mm512_cvtepi32_ps(a); }
  static Ints ceiling(Floats a) {
    const Ints cut = _mm512_cvttps_epi32(a);
    return _mm512_mask_add_epi32(cut, less(_mm512_cvtepi32_ps(cut), a), cut, _mm512_set1_epi32(1));
  }
  // a·2ⁿ, by adding to the exponent's bits: neither a nor the result may be 0 or out of range.
  static Floats times_power_of_two(Floats a, Ints n) {
    return _mm512_castsi512_ps(_mm512_add_epi32(_mm512_castps_si512(a), _mm512_slli_epi32(n, 23)));
  }
  static Mask less(Floats a, Floats b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }
  static Mask both(Mask a, Mask b) { return static_cast<Mask>(a & b); }
  static Mask within(Ints at, std::int32_t first, std::int32_t end) {
    return _mm512_mask_cmplt_epi32_mask(_mm512_cmple_epi32_mask(_mm512_set1_epi32(first), at), at,
                                        _mm512_set1_epi32(end));
  }
  static Floats choose(Mask where, Floats yes, Floats no) {
    return _mm512_mask_blend_ps(where, no, yes);
  }
  static void store_where(float* to, Mask where, Floats a) { _mm512_mask_storeu_ps(to, where, a); }
  static Mask mask(unsigned bits) { return static_cast<Mask>(bits); }
  static unsigned bits(Mask a) { return a; }
  static float largest(Floats a) { return _mm512_reduce_max_ps(a); }

  // 16384 times the texture at non-negative positions.
  static Floats texture(const PairedTexels& texels, Floats x, Floats y) {
    const Ints column = _mm512_cvttps_epi32(x);
    const Ints row = _mm512_cvttps_epi32(y);
    const Floats right = _mm512_sub_ps(x, _mm512_cvtepi32_ps(column));
    const Floats down = _mm512_sub_ps(y, _mm512_cvtepi32_ps(row));
    const Ints index =
        _mm512_add_epi32(_mm512_madd_epi16(row, _mm512_set1_epi32(texels.pitch)), column);
    alignas(64) std::uint64_t at[kWidth / 2];
    _mm512_store_si512(at, index);
    asm("" : "+m"(at));  // through memory: extracting the indices lane by lane takes longer
    const auto two = [&texels, &at](int i) {
      const auto* p =
          reinterpret_cast<const __m128i*>(texels.pairs + static_cast<std::uint32_t>(at[i]));
      const auto* q = reinterpret_cast<const __m64*>(texels.pairs + (at[i] >> 32));
      return _mm_castps_si128(_mm_loadh_pi(_mm_castsi128_ps(_mm_loadl_epi64(p)), q));
    };
    const auto four = [&two](int i) {
      const __m256i low = _mm256_set_m128i(two(i + 2), two(i));
      const __m256i high = _mm256_set_m128i(two(i + 6), two(i + 4));
      return _mm512_inserti64x4(_mm512_castsi256_si512(low), high, 1);
    };
    const Ints lower = _mm512_cvttps_epi32(
        _mm512_add_ps(_mm512_mul_ps(down, _mm512_set1_ps(16384.0F)), _mm512_set1_ps(0.5F)));
    const Ints weights = _mm512_or_si512(_mm512_slli_epi32(lower, 16),
                                         _mm512_sub_epi32(_mm512_set1_epi32(16384), lower));
    const Floats first =
        _mm512_castsi512_ps(_mm512_madd_epi16(four(0), _mm512_unpacklo_epi32(weights, weights)));
    const Floats second =
        _mm512_castsi512_ps(_mm512_madd_epi16(four(1), _mm512_unpackhi_epi32(weights, weights)));
    const Floats here =
        _mm512_cvtepi32_ps(_mm512_castps_si512(_mm512_shuffle_ps(first, second, 0x88)));
    const Floats next =
        _mm512_cvtepi32_ps(_mm512_castps_si512(_mm512_shuffle_ps(first, second, 0xdd)));
    return _mm512_add_ps(here, _mm512_mul_ps(right, _mm512_sub_ps(next, here)));
  }
};

struct DoubleLanes {
  static constexpr int kWidth = 8;
  using Doubles = __m512d;
  using Mask = __mmask8;

  static Doubles load(const double* from) { return _mm512_load_pd(from); }
  static void store(double* to, Doubles a) { _mm512_store_pd(to, a); }
  static Doubles all(double a) { return _mm512_set1_pd(a); }
  static Doubles add(Doubles a, Doubles b) { return _mm512_add_pd(a, b); }
  static Doubles sub(Doubles a, Doubles b) { return _mm512_sub_pd(a, b); }
  static Doubles mul(Doubles a, Doubles b) { return _mm512_mul_pd(a, b); }
  static Doubles div(Doubles a, Doubles b) { return _mm512_div_pd(a, b); }
  static Doubles sqrt(Doubles a) { return _mm512_sqrt_pd(a); }
  static Mask less(Doubles a, Doubles b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
  static Mask both(Mask a, Mask b) { return static_cast<Mask>(a & b); }
  static Mask either(Mask a, Mask b) { return static_cast<Mask>(a | b); }
  static Mask differ(Mask a, Mask b) { return static_cast<Mask>(a ^ b); }
  static Doubles choose(Mask where, Doubles yes, Doubles no) {
    return _mm512_mask_blend_pd(where, no, yes);
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
const SampleLoops kAvx512Loops{sample_surface_by_lanes, compare_by_lanes,      weigh_by_lanes,
                               bound_rows_by_lanes,     compare_kept_by_lanes, weigh_kept_by_lanes};
const TriangleLoops kAvx512TriangleLoops{find_candidates_by_lanes, judge_pairs_by_lanes,
                                         use_slack_by_lanes, find_in_box_by_lanes,
                                         cut_pairs_by_lanes};
}  // namespace asperity
