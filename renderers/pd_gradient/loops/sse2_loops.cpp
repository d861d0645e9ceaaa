// Implements the loops with four lanes (SSE2), for every x86-64 processor.

#include <cstdint>

#include <emmintrin.h>

#include "renderers/pd_gradient/loops/sample_loops.h"
#include "renderers/pd_gradient/loops/triangle_loops.h"

namespace asperity {
namespace {

struct Lanes {
  static constexpr int kWidth = 4;
  using Floats = __m128;
  using Ints = __m128i;
  using Mask = __m128;

  static Floats load(const float* from) { return _mm_loadu_ps(from); }
  static void store(float* to, Floats a) { _mm_storeu_ps(to, a); }
  static void store(std::int32_t* to, Ints a) {
    _mm_storeu_si128(reinterpret_cast<__m128i*>(to), a);
  }
  static Floats all(float a) { return _mm_set1_ps(a); }
  static Ints counted_from(int first) {
    return _mm_add_epi32(_mm_set1_epi32(first), _mm_setr_epi32(0, 1, 2, 3));
  }
  static Floats add(Floats a, Floats b) { return _mm_add_ps(a, b); }
  static Floats sub(Floats a, Floats b) { return _mm_sub_ps(a, b); }
  static Floats mul(Floats a, Floats b) { return _mm_mul_ps(a, b); }
  static Floats div(Floats a, Floats b) { return _mm_div_ps(a, b); }
  static Floats sqrt(Floats a) { return _mm_sqrt_ps(a); }
  static Floats max(Floats a, Floats b) { return _mm_max_ps(a, b); }
  static Floats min(Floats a, Floats b) { return _mm_min_ps(a, b); }
  static Floats as_float(Ints a) { return _mm_cvtepi32_ps(a); }
  static Ints ceiling(Floats a) {
    const Ints cut = _mm_cvttps_epi32(a);
    return _mm_sub_epi32(cut, _mm_castps_si128(_mm_cmplt_ps(_mm_cvtepi32_ps(cut), a)));
  }
  // a·2ⁿ, by adding to the exponent's bits: neither a nor the result may be 0 or out of range.
  static Floats times_power_of_two(Floats a, Ints n) {
    return _mm_castsi128_ps(_mm_add_epi32(_mm_castps_si128(a), _mm_slli_epi32(n, 23)));
  }
  static Mask less(Floats a, Floats b) { return _mm_cmplt_ps(a, b); }
  static Mask both(Mask a, Mask b) { return _mm_and_ps(a, b); }
  static Mask within(Ints at, std::int32_t first, std::int32_t end) {
    return _mm_castsi128_ps(_mm_andnot_si128(_mm_cmplt_epi32(at, _mm_set1_epi32(first)),
                                             _mm_cmplt_epi32(at, _mm_set1_epi32(end))));
  }
  static Floats choose(Mask where, Floats yes, Floats no) {
    return _mm_or_ps(_mm_and_ps(where, yes), _mm_andnot_ps(where, no));
  }
  static void store_where(float* to, Mask where, Floats a) {
    store(to, choose(where, a, load(to)));
  }
  static Mask mask(unsigned bits) {
    const Ints of_lane = _mm_setr_epi32(1, 2, 4, 8);
    const Ints own = _mm_and_si128(_mm_set1_epi32(static_cast<int>(bits)), of_lane);
    return _mm_castsi128_ps(_mm_cmpeq_epi32(own, of_lane));
  }
  static unsigned bits(Mask a) { return static_cast<unsigned>(_mm_movemask_ps(a)); }
  static float largest(Floats a) {
    const Floats two = max(a, _mm_movehl_ps(a, a));
    return _mm_cvtss_f32(max(two, _mm_shuffle_ps(two, two, 1)));
  }

  // 16384 times the texture at non-negative positions.
  static Floats texture(const PairedTexels& texels, Floats x, Floats y) {
    const Ints column = _mm_cvttps_epi32(x);
    const Ints row = _mm_cvttps_epi32(y);
    const Floats right = _mm_sub_ps(x, _mm_cvtepi32_ps(column));
    const Floats down = _mm_sub_ps(y, _mm_cvtepi32_ps(row));
    // Rows and pitch are below 2¹⁵, so that one product of 16-bit numbers is exact.
    const Ints index = _mm_add_epi32(_mm_madd_epi16(row, _mm_set1_epi32(texels.pitch)), column);
    alignas(16) std::int32_t at[kWidth];
    _mm_store_si128(reinterpret_cast<__m128i*>(at), index);
    const auto two = [&texels](std::int32_t first, std::int32_t second) {
      const auto* p = reinterpret_cast<const __m128i*>(texels.pairs + first);
      const auto* q = reinterpret_cast<const __m128i*>(texels.pairs + second);
      return _mm_unpacklo_epi64(_mm_loadl_epi64(p), _mm_loadl_epi64(q));
    };
    const Ints lower =
        _mm_cvttps_epi32(_mm_add_ps(_mm_mul_ps(down, _mm_set1_ps(16384.0F)), _mm_set1_ps(0.5F)));
    const Ints weights =
        _mm_or_si128(_mm_slli_epi32(lower, 16), _mm_sub_epi32(_mm_set1_epi32(16384), lower));
    const Floats first =
        _mm_castsi128_ps(_mm_madd_epi16(two(at[0], at[1]), _mm_unpacklo_epi32(weights, weights)));
    const Floats second =
        _mm_castsi128_ps(_mm_madd_epi16(two(at[2], at[3]), _mm_unpackhi_epi32(weights, weights)));
    const Floats here = _mm_cvtepi32_ps(_mm_castps_si128(_mm_shuffle_ps(first, second, 0x88)));
    const Floats next = _mm_cvtepi32_ps(_mm_castps_si128(_mm_shuffle_ps(first, second, 0xdd)));
    return _mm_add_ps(here, _mm_mul_ps(right, _mm_sub_ps(next, here)));
  }
};

struct DoubleLanes {
  static constexpr int kWidth = 2;
  using Doubles = __m128d;
  using Mask = __m128d;

  static Doubles load(const double* from) { return _mm_load_pd(from); }
  static void store(double* to, Doubles a) { _mm_store_pd(to, a); }
  static Doubles all(double a) { return _mm_set1_pd(a); }
  static Doubles add(Doubles a, Doubles b) { return _mm_add_pd(a, b); }
  static Doubles sub(Doubles a, Doubles b) { return _mm_sub_pd(a, b); }
  static Doubles mul(Doubles a, Doubles b) { return _mm_mul_pd(a, b); }
  static Doubles div(Doubles a, Doubles b) { return _mm_div_pd(a, b); }
  static Doubles sqrt(Doubles a) { return _mm_sqrt_pd(a); }
  static Mask less(Doubles a, Doubles b) { return _mm_cmplt_pd(a, b); }
  static Mask both(Mask a, Mask b) { return _mm_and_pd(a, b); }
  static Mask either(Mask a, Mask b) { return _mm_or_pd(a, b); }
  static Mask differ(Mask a, Mask b) { return _mm_xor_pd(a, b); }
  static Doubles choose(Mask where, Doubles yes, Doubles no) {
    return _mm_or_pd(_mm_and_pd(where, yes), _mm_andnot_pd(where, no));
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
const SampleLoops kSse2Loops{sample_surface_by_lanes, compare_by_lanes,      weigh_by_lanes,
                             bound_rows_by_lanes,     compare_kept_by_lanes, weigh_kept_by_lanes};
const TriangleLoops kSse2TriangleLoops{find_candidates_by_lanes, judge_pairs_by_lanes,
                                       use_slack_by_lanes, find_in_box_by_lanes,
                                       cut_pairs_by_lanes};
}  // namespace asperity
