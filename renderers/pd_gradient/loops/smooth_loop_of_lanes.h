// Defines the loop of the smooth maximum in terms of Lanes; included once by each instruction set.

#pragma once

#include <cstdint>

#include "renderers/pd_gradient/loops/sample_loops.h"
#include "renderers/pd_gradient/loops/sample_loops_of_lanes.h"

namespace asperity {
namespace {

// Samples with less than this weight relative to the deepest one are left out: 256 × 256 of them amount to 10⁻⁴.
constexpr float kLightest_log2 = -30.0F;
constexpr float kLog2OfE = 1.44269504F;

// kMostLanes sums, in as many variables as the lanes require. For all widths the same samples are added to the same
// sum, in the same order.
struct LaneSums {
  Floats part[kMostLanes / Lanes::kWidth];
};

inline LaneSums no_sums() {
  LaneSums sums;
  for (Floats& part : sums.part) part = Lanes::all(0.0F);
  return sums;
}

inline double total(const LaneSums& sums) {
  double sum = 0.0;
  for (const Floats part : sums.part) {
    float lanes[Lanes::kWidth];
    Lanes::store(lanes, part);
    for (const float lane : lanes) sum += static_cast<double>(lane);
  }
  return sum;
}

// 2ˣ for x ≤ 0 down to approximately −100, accurate to 2·10⁻⁷: the Taylor series of the fraction, times a power of two.
inline Floats power_of_two(Floats x) {
  const Lanes::Ints whole = Lanes::ceiling(Lanes::sub(x, Lanes::all(0.5F)));
  const Floats rest = Lanes::sub(x, Lanes::as_float(whole));
  constexpr float kSeries[] = {1.5403530e-4F, 1.3333558e-3F, 9.6181291e-3F, 5.5504109e-2F,
                               2.4022651e-1F, 6.9314718e-1F, 1.0F};  // (ln 2)ᵏ/k!
  Floats sum = Lanes::all(kSeries[0]);
  for (int i = 1; i < 7; ++i) sum = Lanes::add(Lanes::mul(sum, rest), Lanes::all(kSeries[i]));
  return Lanes::times_power_of_two(sum, whole);
}

// The slope of heights that are `step` apart in memory. Next to a position without a surface the one-sided difference
// is used; with no surface on either side the slope is zero.
inline Floats slope_of(const float* at, std::int32_t step) {
  const Floats nothing = Lanes::all(kNothing_m);
  const Floats here = Lanes::load(at);
  const Floats forth = Lanes::load(at + step);
  const Floats back = Lanes::load(at - step);
  const Floats far_forth = Lanes::load(at + 2 * step);
  const Floats far_back = Lanes::load(at - 2 * step);
  const Floats wide = Lanes::sub(Lanes::mul(Lanes::all(8.0F), Lanes::sub(forth, back)),
                                 Lanes::sub(far_forth, far_back));
  const Lanes::Mask has_forth = Lanes::less(nothing, forth);
  const Lanes::Mask has_back = Lanes::less(nothing, back);
  const Lanes::Mask has_all =
      Lanes::both(Lanes::both(has_forth, has_back),
                  Lanes::both(Lanes::less(nothing, far_forth), Lanes::less(nothing, far_back)));
  if (Lanes::bits(has_all) == (1U << Lanes::kWidth) - 1U) return wide;
  const Floats zero = Lanes::all(0.0F);
  const Floats side = Lanes::all(0.5F * kSlope_cells);
  const Floats forwards = Lanes::sub(forth, here);
  const Floats backwards = Lanes::sub(here, back);
  const Floats near = Lanes::mul(
      side,
      Lanes::add(Lanes::choose(has_forth, forwards, Lanes::choose(has_back, backwards, zero)),
                 Lanes::choose(has_back, backwards, Lanes::choose(has_forth, forwards, zero))));
  return Lanes::choose(has_all, wide, near);
}

inline void find_rows_most(const WeighingTask& task, WeightedSums& sums) {
  Floats most = Lanes::all(kFarBelow_m);
  Floats covered = Lanes::all(0.0F);
  for (std::int32_t row = 0; row < task.b.samples; ++row) {
    const float* const a = task.a.height_m + (row + task.a.apron) * task.a.stride + task.a.apron;
    const float* const b = task.b.height_m + row * task.b.stride;
    Floats row_most = Lanes::all(kFarBelow_m);
    for (std::int32_t column = 0; column < task.b.samples; column += Lanes::kWidth) {
      const Floats here = Lanes::add(Lanes::load(a + column), Lanes::load(b + column));
      row_most = Lanes::max(row_most, here);
      covered = Lanes::add(covered, Lanes::choose(Lanes::less(Lanes::all(kNothing_m), here),
                                                  Lanes::all(1.0F), Lanes::all(0.0F)));
    }
    Lanes::store(task.row_most_m + row * kMostLanes, row_most);
    most = Lanes::max(most, row_most);
  }
  float lanes[Lanes::kWidth];
  Lanes::store(lanes, covered);
  sums.covered = 0;
  for (const float lane : lanes) sums.covered += static_cast<std::int32_t>(lane);
  sums.here_m = largest(most);
}

// Which samples count, and their weights.
struct Weighing {
  Floats deepest_m;
  Floats lightest_m;
  Floats per_m;
};

inline Weighing weighing_from(float here_m, float per_tau_per_m) {
  const float per_m = per_tau_per_m * kLog2OfE;
  return {Lanes::all(here_m), Lanes::all(here_m + kLightest_log2 / per_m), Lanes::all(per_m)};
}

struct GatheredSums {
  LaneSums weight;
  LaneSums x;
  LaneSums y;
  LaneSums slope_x;
  LaneSums slope_y;
  LaneSums z_slope_x;
  LaneSums z_slope_y;
  LaneSums turn;
};

inline GatheredSums none_of_each() {
  return {no_sums(), no_sums(), no_sums(), no_sums(), no_sums(), no_sums(), no_sums(), no_sums()};
}

struct GatheredTwice {
  GatheredSums once;
  GatheredSums by_log2;
};

inline GatheredTwice nothing_gathered() { return {none_of_each(), none_of_each()}; }

// The samples from `a`, with their neighbours at a distance of `stride`; `part` is a part of kMostLanes.
inline void gather_samples(const Weighing& weighing, const float* a, std::int32_t stride,
                           const float* b, Floats x, Floats y, int part, GatheredTwice& sums) {
  const Floats outwards_m = Lanes::load(a);
  const Floats here_m = Lanes::add(outwards_m, Lanes::load(b));
  const Lanes::Mask heavy = Lanes::less(weighing.lightest_m, here_m);
  if (Lanes::bits(heavy) == 0) return;
  const Floats zero = Lanes::all(0.0F);
  const Floats log2 = Lanes::max(Lanes::mul(Lanes::sub(here_m, weighing.deepest_m), weighing.per_m),
                                 Lanes::all(kLightest_log2));
  const Floats weight = Lanes::choose(heavy, power_of_two(log2), zero);
  const Floats weight_log2 = Lanes::mul(weight, log2);
  // A's height along n is the negative of its height against n; the same applies to its slopes.
  const Floats z_m = Lanes::sub(zero, outwards_m);
  const Floats slope_x = Lanes::sub(zero, slope_of(a, 1));
  const Floats slope_y = Lanes::sub(zero, slope_of(a, stride));
  const auto add = [part](LaneSums& into, Floats more) {
    into.part[part] = Lanes::add(into.part[part], more);
  };
  const auto gather = [&](LaneSums GatheredSums::*into, Floats what) {
    add(sums.once.*into, Lanes::mul(weight, what));
    add(sums.by_log2.*into, Lanes::mul(weight_log2, what));
  };
  add(sums.once.weight, weight);
  add(sums.by_log2.weight, weight_log2);
  gather(&GatheredSums::x, x);
  gather(&GatheredSums::y, y);
  gather(&GatheredSums::slope_x, slope_x);
  gather(&GatheredSums::slope_y, slope_y);
  gather(&GatheredSums::z_slope_x, Lanes::mul(z_m, slope_x));
  gather(&GatheredSums::z_slope_y, Lanes::mul(z_m, slope_y));
  gather(&GatheredSums::turn, Lanes::sub(Lanes::mul(x, slope_y), Lanes::mul(y, slope_x)));
}

inline void add_up(const GatheredSums& gathered, PlaceSums& sums) {
  sums.weight = total(gathered.weight);
  sums.x = total(gathered.x);
  sums.y = total(gathered.y);
  sums.slope_x_m = total(gathered.slope_x);
  sums.slope_y_m = total(gathered.slope_y);
  sums.z_slope_x_m2 = total(gathered.z_slope_x);
  sums.z_slope_y_m2 = total(gathered.z_slope_y);
  sums.turn_m = total(gathered.turn);
}

inline void add_up(const GatheredTwice& gathered, WeightedSums& sums) {
  add_up(gathered.once, sums.once);
  add_up(gathered.by_log2, sums.by_log2);
}

void weigh_by_lanes(const WeighingTask& whole_task, WeightedSums& sums) {
  const WeighingTask task = whole_task;
  find_rows_most(task, sums);
  find_deepest(task.a, task.b, task.row_most_m, sums.here_m, sums.row, sums.column);
  const Weighing weighing = weighing_from(sums.here_m, task.per_tau_per_m);
  const Floats middle = Lanes::all(middle_of(task.b));
  GatheredTwice gathered = nothing_gathered();
  for (std::int32_t row = 0; row < task.b.samples; ++row) {
    if (Lanes::bits(Lanes::less(weighing.lightest_m,
                                Lanes::load(task.row_most_m + row * kMostLanes))) == 0) {
      continue;
    }
    const float* const a_row =
        task.a.height_m + (row + task.a.apron) * task.a.stride + task.a.apron;
    const float* const b_row = task.b.height_m + row * task.b.stride;
    const Floats y = Lanes::sub(Lanes::all(static_cast<float>(row)), middle);
    for (std::int32_t column = 0; column < task.b.samples; column += Lanes::kWidth) {
      const Floats x = Lanes::sub(Lanes::as_float(Lanes::counted_from(column)), middle);
      const int part = column / Lanes::kWidth % (kMostLanes / Lanes::kWidth);
      gather_samples(weighing, a_row + column, task.a.stride, b_row + column, x, y, part, gathered);
    }
  }
  add_up(gathered, sums);
}

}  // namespace
}  // namespace asperity
