// Defines the loops over kept heights in terms of Lanes; included once by each instruction set.

#pragma once

#include <cstdint>

#include "renderers/pd_gradient/loops/sample_loops.h"
#include "renderers/pd_gradient/loops/sample_loops_of_lanes.h"
#include "renderers/pd_gradient/loops/smooth_loop_of_lanes.h"

namespace asperity {
namespace {

constexpr std::int32_t kParts = kMostLanes / Lanes::kWidth;
constexpr std::int32_t kMostStep = 8;
// The size of the room for A's heights of one block: twice kMostLanes columns contain it and the step on either side.
constexpr std::int32_t kRoomColumns = 2 * kMostLanes;
constexpr std::int32_t kRoomRows = 2 * kMostLanes;  // at least kBlockRows + 2 * kMostStep
constexpr float kMiddleLane = 0.5F * (kMostLanes - 1);
// Rounding error of bounds and heights; heights are below 0.2 m and missing ones at 1 m.
constexpr float kRounding_m = 1e-6F;
// The maxima increase little after the first blocks; the levels for pruning are updated after this number of blocks.
constexpr std::int32_t kBlocksBetween = 6;

void bound_rows_by_lanes(const BoundTask& whole_task) {
  const BoundTask task = whole_task;
  const KeptHeights field = task.field;
  const std::int32_t end = (field.samples + Lanes::kWidth - 1) / Lanes::kWidth * Lanes::kWidth;
  for (std::int32_t i = end; i < end + 2 * kMostLanes; i += Lanes::kWidth) {
    Lanes::store(task.room_m + i, Lanes::all(kNoSurface_m));
  }
  for (std::int32_t row = task.first_row; row < task.end_row; row += kBoundRows) {
    const float* const rows = field.height_m + row * field.stride;
    for (std::int32_t column = 0; column < end; column += Lanes::kWidth) {
      Floats most = Lanes::load(rows + column);
      for (std::int32_t i = 1; i < kBoundRows; ++i) {
        most = Lanes::max(most, Lanes::load(rows + i * field.stride + column));
      }
      Lanes::store(task.room_m + column, most);
    }
    // Each pass doubles the number of columns of the maximum.
    for (std::int32_t span = 1; span < field.span;) {
      const std::int32_t more = sooner(span, field.span - span);
      for (std::int32_t column = 0; column < end; column += Lanes::kWidth) {
        Lanes::store(task.room_m + column, Lanes::max(Lanes::load(task.room_m + column),
                                                      Lanes::load(task.room_m + column + more)));
      }
      span += more;
    }
    float* const to = field.most_m + row / kBoundRows * field.stride;
    for (std::int32_t column = 0; column < end; column += Lanes::kWidth) {
      Lanes::store(to + column, Lanes::load(task.room_m + column));
    }
  }
}

// The deviation of positions along kMostLanes columns from those for parallel lattices.
struct Drift {
  Floats right[kParts];
  Floats down[kParts];
  Floats lift_m[kParts];
  float most_down = 0.0F;  // half the distance from the first to the last
  std::int32_t rows =
      0;  // of A's lattice, from the first above to the last below a row of the window
};

inline float magnitude_of(float a) { return a < 0.0F ? -a : a; }

inline Drift drift_along(const KeptPositions& places, const KeptLift& lift) {
  Drift drift;
  const float lift_m = lift.per_x_m * places.x_per_column + lift.per_y_m * places.y_per_column;
  for (std::int32_t part = 0; part < kParts; ++part) {
    const Floats lane = Lanes::sub(Lanes::as_float(Lanes::counted_from(part * Lanes::kWidth)),
                                   Lanes::all(kMiddleLane));
    drift.right[part] = Lanes::mul(lane, Lanes::all(places.x_per_column - 1.0F));
    drift.down[part] = Lanes::mul(lane, Lanes::all(places.y_per_column));
    drift.lift_m[part] = Lanes::mul(lane, Lanes::all(lift_m));
  }
  drift.most_down = kMiddleLane * magnitude_of(places.y_per_column);
  drift.rows = 3 + static_cast<std::int32_t>(2.0F * drift.most_down);
  return drift;
}

// The positions in A's lattice at which kMostLanes samples of each row of the window begin.
struct RowPlaces {
  std::int32_t column[kRoomRows];  // before the position
  std::int32_t row[kRoomRows];
  float right[kRoomRows];
  float down[kRoomRows];
  float lift_m[kRoomRows];
};

inline void find_row_places(const KeptLift& lift, const KeptPositions& places, const Drift& drift,
                            std::int32_t row, std::int32_t column, std::int32_t rows,
                            RowPlaces& found) {
  const float along = static_cast<float>(column) + kMiddleLane;
  const Floats first_x = Lanes::all(places.x + places.x_per_column * along);
  const Floats first_y = Lanes::all(places.y + places.y_per_column * along);
  const Floats one = Lanes::all(1.0F);
  for (std::int32_t i = 0; i < rows; i += Lanes::kWidth) {
    const Floats across = Lanes::as_float(Lanes::counted_from(row + i));
    const Floats x = Lanes::add(first_x, Lanes::mul(Lanes::all(places.x_per_row), across));
    const Floats y = Lanes::add(first_y, Lanes::mul(Lanes::all(places.y_per_row), across));
    const Floats from_x = Lanes::sub(x, Lanes::all(kMiddleLane));
    const Lanes::Ints next_column = Lanes::ceiling(from_x);
    const Lanes::Ints next_row = Lanes::ceiling(Lanes::sub(y, Lanes::all(drift.most_down)));
    Lanes::store(found.column + i, next_column);
    Lanes::store(found.row + i, next_row);
    Lanes::store(found.right + i,
                 Lanes::add(Lanes::sub(from_x, Lanes::as_float(next_column)), one));
    Lanes::store(found.down + i, Lanes::add(Lanes::sub(y, Lanes::as_float(next_row)), one));
    Lanes::store(found.lift_m + i, Lanes::add(Lanes::add(Lanes::mul(Lanes::all(lift.per_x_m), x),
                                                         Lanes::mul(Lanes::all(lift.per_y_m), y)),
                                              Lanes::all(lift.shift_m)));
  }
}

// A's rows of heights for reading; a copy, so that no store changes it.
struct KeptRows {
  const float* height_m = nullptr;
  std::int32_t stride = 0;
  std::int32_t rows = 0;  // between the first and the last of which a row of the window lies
  Floats per_m;
};

inline KeptRows rows_of(const KeptTask& task, const Drift& drift) {
  return {task.a.height_m, task.a.stride, drift.rows, Lanes::all(task.lift.per_m)};
}

// A's current height at the lanes of a part, in row i of the rows found. A position next to one without a surface
// counts as having none.
[[gnu::always_inline]] inline Floats kept_height(const KeptRows& kept, const RowPlaces& places,
                                                 std::int32_t i, std::int32_t part, Floats right,
                                                 Floats down, Floats lift_m) {
  const Floats zero = Lanes::all(0.0F);
  const Floats one = Lanes::all(1.0F);
  const auto share = [&](Floats of) { return Lanes::min(Lanes::max(of, zero), one); };
  const float* from = kept.height_m + (places.row[i] - 1) * kept.stride + places.column[i] - 1 +
                      part * Lanes::kWidth;
  right = share(Lanes::add(Lanes::all(places.right[i]), right));
  down = Lanes::add(Lanes::all(places.down[i]), down);
  Floats least = Lanes::min(Lanes::load(from), Lanes::load(from + 1));
  Floats height = between(Lanes::load(from), Lanes::load(from + 1), right);
  const auto go_down = [&] {
    from += kept.stride;
    const Floats left = Lanes::load(from);
    const Floats next = Lanes::load(from + 1);
    least = Lanes::min(least, Lanes::min(left, next));
    height = between(height, between(left, next, right), share(down));
    down = Lanes::sub(down, one);
  };
  go_down();
  go_down();
  for (std::int32_t row = 3; row < kept.rows; ++row) go_down();
  const Floats now =
      Lanes::add(Lanes::mul(kept.per_m, height), Lanes::add(Lanes::all(places.lift_m[i]), lift_m));
  return Lanes::choose(Lanes::less(least, Lanes::all(kNothing_m)), Lanes::all(kNoSurface_m), now);
}

// Finds A's heights over a block and `around` samples on either side, in kRoomColumns columns and in `rows` rows from
// `first`.
inline void find_rows_of_a(const KeptTask& task, const Drift& drift, std::int32_t row,
                           std::int32_t column, std::int32_t around, std::int32_t first,
                           std::int32_t rows, float* room) {
  const KeptRows kept = rows_of(task, drift);
  for (std::int32_t half = 0; half < (around > 0 ? 2 : 1); ++half) {
    RowPlaces places;
    find_row_places(task.lift, task.here, drift, row - around + first,
                    column - around + half * kMostLanes, rows, places);
    const std::int32_t parts =
        half == 0 ? kParts : (2 * around + Lanes::kWidth - 1) / Lanes::kWidth;
    for (std::int32_t part = 0; part < parts; ++part) {
      const Floats right = drift.right[part];
      const Floats down = drift.down[part];
      const Floats lift_m = drift.lift_m[part];
      float* to = room + first * kRoomColumns + half * kMostLanes + part * Lanes::kWidth;
      for (std::int32_t i = 0; i < rows; ++i, to += kRoomColumns) {
        Lanes::store(to, kept_height(kept, places, i, part, right, down, lift_m));
      }
    }
  }
}

inline void find_a(const KeptTask& task, const Drift& drift, std::int32_t row, std::int32_t column,
                   std::int32_t around, float* room) {
  find_rows_of_a(task, drift, row, column, around, 0, kBlockRows + 2 * around, room);
}

inline std::int32_t blocks_across(const KeptTask& task) { return task.samples / kMostLanes; }
inline std::int32_t blocks_down(const KeptTask& task) { return task.samples / kBlockRows; }
inline std::int32_t row_of(const KeptTask& task, std::int32_t block) {
  return block / blocks_across(task) * kBlockRows;
}
inline std::int32_t column_of(const KeptTask& task, std::int32_t block) {
  return block % blocks_across(task) * kMostLanes;
}

inline const float* b_at(const KeptTask& task, std::int32_t row, std::int32_t column) {
  return task.b.height_m + (task.b_row + row) * task.b.stride + task.b_column + column;
}

// The largest of a field's bounds from (row, column) to row `end_row`.
inline float most_of(const KeptHeights& field, std::int32_t row, std::int32_t end_row,
                     std::int32_t column) {
  const float* from = field.most_m + row / kBoundRows * field.stride + column;
  const float* const last = field.most_m + (end_row - 1) / kBoundRows * field.stride + column;
  float most = *from;
  while (from != last) {
    from += field.stride;
    most = *from > most ? *from : most;
  }
  return most;
}

// Computes for each block an upper bound of the sum of both surfaces, in all configurations except the tilted ones.
// Returns the block with the highest bound.
inline std::int32_t find_bounds(const KeptTask& task) {
  // A sample moves by a step, and slightly more if the lattices are not parallel; it lies between samples at a distance
  // below 1.2.
  const float around = 1.05F * static_cast<float>(task.step_cells);
  const float columns = kMiddleLane + around;
  const float rows = 0.5F * (kBlockRows - 1) + around;
  const KeptPositions& here = task.here;
  const float reach_x =
      columns * magnitude_of(here.x_per_column) + rows * magnitude_of(here.x_per_row) + 1.2F;
  const float reach_y =
      columns * magnitude_of(here.y_per_column) + rows * magnitude_of(here.y_per_row) + 1.2F;
  const float uneven_m = reach_x * magnitude_of(task.lift.per_x_m) +
                         reach_y * magnitude_of(task.lift.per_y_m) + kRounding_m;
  std::int32_t highest = 0;
  std::int32_t block = 0;
  for (std::int32_t row = 0; row < task.samples; row += kBlockRows) {
    for (std::int32_t column = 0; column < task.samples; column += kMostLanes, ++block) {
      const float along = static_cast<float>(column) + kMiddleLane;
      const float across = static_cast<float>(row) + 0.5F * (kBlockRows - 1);
      const float x = here.x + here.x_per_column * along + here.x_per_row * across;
      const float y = here.y + here.y_per_column * along + here.y_per_row * across;
      const auto from_begin = [](float at) {  // the lattice may end within the reach
        return at > 0.0F ? static_cast<std::int32_t>(at) : 0;
      };
      const std::int32_t end_row = sooner(from_begin(y + reach_y) + 1, task.a.samples);
      const float a_m = most_of(task.a, from_begin(y - reach_y), end_row, from_begin(x - reach_x)) *
                            task.lift.per_m +
                        (task.lift.per_x_m * x + task.lift.per_y_m * y + task.lift.shift_m) +
                        uneven_m;
      const float b_m =
          most_of(task.b, task.b_row + row, task.b_row + row + kBlockRows, task.b_column + column);
      task.bound_m[block] = a_m + b_m;
      if (task.bound_m[block] > task.bound_m[highest]) highest = block;
    }
  }
  return highest;
}

struct KeptMaxima {
  Floats here;
  Floats u[2];
  Floats v[2];
  Floats tilt_u[2];
  Floats tilt_v[2];
  Floats turn[2];
};

inline void raise(Floats& highest, Floats to) { highest = Lanes::max(highest, to); }

struct Drifts {
  Drift here;
  Drift forth;
  Drift back;
};

inline void compare_block(const KeptTask& task, const Drifts& drifts, std::int32_t block,
                          KeptMaxima& most) {
  const std::int32_t row = row_of(task, block);
  const std::int32_t column = column_of(task, block);
  const std::int32_t step = task.step_cells;
  const float middle = 0.5F * static_cast<float>(task.samples - 1);
  float room[kRoomRows * kRoomColumns];
  find_a(task, drifts.here, row, column, step, room);
  RowPlaces forth_places;
  RowPlaces back_places;
  find_row_places(task.lift, task.forth, drifts.forth, row, column, kBlockRows, forth_places);
  find_row_places(task.lift, task.back, drifts.back, row, column, kBlockRows, back_places);
  const KeptRows forth = rows_of(task, drifts.forth);
  const KeptRows back = rows_of(task, drifts.back);
  for (std::int32_t part = 0; part < kParts; ++part) {
    const Floats rise_v =
        Lanes::mul(Lanes::all(task.tilt_rise_m),
                   Lanes::sub(Lanes::as_float(Lanes::counted_from(column + part * Lanes::kWidth)),
                              Lanes::all(middle)));
    const Drift& ahead = drifts.forth;
    const Drift& behind = drifts.back;
    Floats block_most = Lanes::all(kFarBelow_m);
    KeptMaxima found = most;
    for (std::int32_t i = 0; i < kBlockRows; ++i) {
      const Floats rise_u = Lanes::all(task.tilt_rise_m * (static_cast<float>(row + i) - middle));
      const float* const a = room + (step + i) * kRoomColumns + step + part * Lanes::kWidth;
      const Floats b = Lanes::load(b_at(task, row + i, column + part * Lanes::kWidth));
      const auto with = [&](const float* moved) { return Lanes::add(b, Lanes::load(moved)); };
      const Floats here = with(a);
      raise(block_most, here);
      raise(found.u[0], with(a - step));
      raise(found.u[1], with(a + step));
      raise(found.v[0], with(a - step * kRoomColumns));
      raise(found.v[1], with(a + step * kRoomColumns));
      raise(found.tilt_u[0], Lanes::sub(here, rise_u));
      raise(found.tilt_u[1], Lanes::add(here, rise_u));
      raise(found.tilt_v[0], Lanes::add(here, rise_v));
      raise(found.tilt_v[1], Lanes::sub(here, rise_v));
      raise(found.turn[0],
            Lanes::add(b, kept_height(forth, forth_places, i, part, ahead.right[part],
                                      ahead.down[part], ahead.lift_m[part])));
      raise(found.turn[1], Lanes::add(b, kept_height(back, back_places, i, part, behind.right[part],
                                                     behind.down[part], behind.lift_m[part])));
    }
    raise(found.here, block_most);
    most = found;
    Lanes::store(task.block_most_m + block * kMostLanes + part * Lanes::kWidth, block_most);
  }
}

// The same comparison for a block that can be the highest in tilted configurations only.
inline void compare_block_tilted(const KeptTask& task, const Drift& drift, std::int32_t block,
                                 KeptMaxima& most) {
  const std::int32_t row = row_of(task, block);
  const std::int32_t column = column_of(task, block);
  const std::int32_t step = task.step_cells;
  const float middle = 0.5F * static_cast<float>(task.samples - 1);
  float room[kRoomRows * kRoomColumns];
  find_rows_of_a(task, drift, row, column, step, step, kBlockRows, room);  // for the same bits
  for (std::int32_t part = 0; part < kParts; ++part) {
    const Floats rise_v =
        Lanes::mul(Lanes::all(task.tilt_rise_m),
                   Lanes::sub(Lanes::as_float(Lanes::counted_from(column + part * Lanes::kWidth)),
                              Lanes::all(middle)));
    for (std::int32_t i = 0; i < kBlockRows; ++i) {
      const Floats rise_u = Lanes::all(task.tilt_rise_m * (static_cast<float>(row + i) - middle));
      const float* const a = room + (step + i) * kRoomColumns + step + part * Lanes::kWidth;
      const Floats here = Lanes::add(
          Lanes::load(b_at(task, row + i, column + part * Lanes::kWidth)), Lanes::load(a));
      raise(most.tilt_u[0], Lanes::sub(here, rise_u));
      raise(most.tilt_u[1], Lanes::add(here, rise_u));
      raise(most.tilt_v[0], Lanes::add(here, rise_v));
      raise(most.tilt_v[1], Lanes::sub(here, rise_v));
    }
  }
}

inline float lower(float a, float b) { return a < b ? a : b; }
inline float lowest_of(const Floats (&both)[2]) {
  return lower(largest(both[0]), largest(both[1]));
}

// The levels that a block's bound must exceed.
struct Reached {
  float level_m = kFarBelow_m;  // the lowest of the configurations without a tilt
  float tilt_u_m[2] = {kFarBelow_m, kFarBelow_m};
  float tilt_v_m[2] = {kFarBelow_m, kFarBelow_m};
};

inline Reached reached_by(const KeptMaxima& most) {
  return {lower(lower(largest(most.here), lowest_of(most.turn)),
                lower(lowest_of(most.u), lowest_of(most.v))),
          {largest(most.tilt_u[0]), largest(most.tilt_u[1])},
          {largest(most.tilt_v[0]), largest(most.tilt_v[1])}};
}

// Whether a block can be the highest in a tilted configuration.
inline bool matters_tilted(const KeptTask& task, std::int32_t block, const Reached& reached) {
  const float middle = 0.5F * static_cast<float>(task.samples);
  const float bound_m = task.bound_m[block];
  // The signed distance from the middle to the farthest sample in each direction.
  const auto beyond = [&](std::int32_t first, std::int32_t samples) {
    return bound_m + task.tilt_rise_m * (static_cast<float>(first + samples) - middle);
  };
  const auto before = [&](std::int32_t first) {
    return bound_m - task.tilt_rise_m * (static_cast<float>(first) - middle);
  };
  const std::int32_t row = row_of(task, block);
  const std::int32_t column = column_of(task, block);
  return before(row) >= reached.tilt_u_m[0] || beyond(row, kBlockRows) >= reached.tilt_u_m[1] ||
         beyond(column, kMostLanes) >= reached.tilt_v_m[0] || before(column) >= reached.tilt_v_m[1];
}

// The first sample, row by row, at which the sum of both surfaces reaches this height, among the blocks with known
// maxima; those of the others are lower. `around` must be the same as in the search for the maxima, so that the results
// agree to the bit.
inline void find_deepest_kept(const KeptTask& task, const Drift& drift, std::int32_t around,
                              float here_m, std::int32_t& row, std::int32_t& column) {
  const Floats depth = Lanes::all(here_m);
  std::int32_t first = task.samples * task.samples - 1;
  for (std::int32_t block = 0; block < blocks_across(task) * blocks_down(task); ++block) {
    if (!(task.bound_m[block] >= here_m) || row_of(task, block) * task.samples > first) continue;
    bool is_here = false;
    for (std::int32_t part = 0; part < kParts; ++part) {
      const Floats most =
          Lanes::load(task.block_most_m + block * kMostLanes + part * Lanes::kWidth);
      is_here = is_here || Lanes::bits(Lanes::less(most, depth)) != (1U << Lanes::kWidth) - 1U;
    }
    if (!is_here) continue;
    float room[kRoomRows * kRoomColumns];
    find_a(task, drift, row_of(task, block), column_of(task, block), around, room);
    for (std::int32_t i = 0; i < kBlockRows * kMostLanes; ++i) {
      const std::int32_t r = row_of(task, block) + i / kMostLanes;
      const std::int32_t c = column_of(task, block) + i % kMostLanes;
      const float a = room[(around + i / kMostLanes) * kRoomColumns + around + i % kMostLanes];
      if (a + *b_at(task, r, c) >= here_m) {
        first = sooner(first, r * task.samples + c);
        break;
      }
    }
  }
  row = first / task.samples;
  column = first % task.samples;
}

void compare_kept_by_lanes(const KeptTask& whole_task, ElevenMaxima& maxima) {
  const KeptTask task = whole_task;
  const Drifts drifts{drift_along(task.here, task.lift), drift_along(task.forth, task.lift),
                      drift_along(task.back, task.lift)};
  const std::int32_t highest = find_bounds(task);
  const Floats far_below = Lanes::all(kFarBelow_m);
  KeptMaxima most{far_below,
                  {far_below, far_below},
                  {far_below, far_below},
                  {far_below, far_below},
                  {far_below, far_below},
                  {far_below, far_below}};
  compare_block(task, drifts, highest, most);
  if (task.first_block != highest) compare_block(task, drifts, task.first_block, most);
  Reached reached;
  if (task.prune) reached = reached_by(most);
  std::int32_t since = 0;
  for (std::int32_t block = 0; block < blocks_across(task) * blocks_down(task); ++block) {
    if (block == highest || block == task.first_block) continue;
    if (task.bound_m[block] >= reached.level_m) {
      compare_block(task, drifts, block, most);
    } else {
      for (std::int32_t i = 0; i < kMostLanes; i += Lanes::kWidth) {
        Lanes::store(task.block_most_m + block * kMostLanes + i, far_below);
      }
      if (!matters_tilted(task, block, reached)) continue;
      compare_block_tilted(task, drifts.here, block, most);
    }
    if (task.prune && ++since % kBlocksBetween == 1) reached = reached_by(most);
  }
  maxima.here_m = largest(most.here);
  for (int way = 0; way < 2; ++way) {
    maxima.u_m[way] = largest(most.u[way]);
    maxima.v_m[way] = largest(most.v[way]);
    maxima.tilt_u_m[way] = largest(most.tilt_u[way]);
    maxima.tilt_v_m[way] = largest(most.tilt_v[way]);
    maxima.turn_m[way] = largest(most.turn[way]);
  }
  find_deepest_kept(task, drifts.here, task.step_cells, maxima.here_m, maxima.row, maxima.column);
}

// A block's largest sums, for A at its current pose.
inline Floats find_block_most(const KeptTask& task, const Drift& drift, std::int32_t block) {
  const std::int32_t row = row_of(task, block);
  const std::int32_t column = column_of(task, block);
  RowPlaces places;
  find_row_places(task.lift, task.here, drift, row, column, kBlockRows, places);
  const KeptRows kept = rows_of(task, drift);
  Floats most = Lanes::all(kFarBelow_m);
  for (std::int32_t part = 0; part < kParts; ++part) {
    Floats part_most = Lanes::all(kFarBelow_m);
    for (std::int32_t i = 0; i < kBlockRows; ++i) {
      raise(part_most, Lanes::add(Lanes::load(b_at(task, row + i, column + part * Lanes::kWidth)),
                                  kept_height(kept, places, i, part, drift.right[part],
                                              drift.down[part], drift.lift_m[part])));
    }
    Lanes::store(task.block_most_m + block * kMostLanes + part * Lanes::kWidth, part_most);
    raise(most, part_most);
  }
  return most;
}

void weigh_kept_by_lanes(const KeptTask& whole_task, WeightedSums& sums) {
  const KeptTask task = whole_task;
  const std::int32_t blocks = blocks_across(task) * blocks_down(task);
  const Drift drift = drift_along(task.here, task.lift);
  const std::int32_t highest = find_bounds(task);
  Floats most = find_block_most(task, drift, highest);
  float here_m = largest(most);
  for (std::int32_t block = 0; block < blocks; ++block) {
    if (block == highest || (task.prune && task.bound_m[block] < here_m)) continue;
    raise(most, find_block_most(task, drift, block));
    here_m = largest(most);
  }
  sums.here_m = here_m;
  sums.covered = 0;
  for (std::int32_t block = 0; block < blocks; ++block) {
    // Blocks that were skipped are lower.
    if (task.bound_m[block] < here_m) {
      for (std::int32_t i = 0; i < kMostLanes; i += Lanes::kWidth) {
        Lanes::store(task.block_most_m + block * kMostLanes + i, Lanes::all(kFarBelow_m));
      }
    }
  }
  find_deepest_kept(task, drift, 0, here_m, sums.row, sums.column);
  const Weighing weighing = weighing_from(here_m, task.per_tau_per_m);
  const float lightest_m = largest(weighing.lightest_m);
  const Floats middle = Lanes::all(0.5F * static_cast<float>(task.samples - 1));
  GatheredTwice gathered = nothing_gathered();
  float room[kRoomRows * kRoomColumns];
  for (std::int32_t block = 0; block < blocks; ++block) {
    if (task.prune && task.bound_m[block] < lightest_m) continue;
    const std::int32_t row = row_of(task, block);
    const std::int32_t column = column_of(task, block);
    find_a(task, drift, row, column, kSlopeApron, room);
    for (std::int32_t i = 0; i < kBlockRows; ++i) {
      const Floats y = Lanes::sub(Lanes::all(static_cast<float>(row + i)), middle);
      for (std::int32_t part = 0; part < kParts; ++part) {
        const std::int32_t first = column + part * Lanes::kWidth;
        const Floats x = Lanes::sub(Lanes::as_float(Lanes::counted_from(first)), middle);
        gather_samples(weighing,
                       room + (kSlopeApron + i) * kRoomColumns + kSlopeApron + part * Lanes::kWidth,
                       kRoomColumns, b_at(task, row + i, first), x, y, part, gathered);
      }
    }
  }
  add_up(gathered, sums);
}

}  // namespace
}  // namespace asperity
