// Defines the sample loops in terms of Lanes; included once by each instruction set.

#pragma once

#include <cstdint>

#include "renderers/pd_gradient/loops/sample_loops.h"

namespace asperity {
namespace {

// Every lane performs the same operations in the same order for all widths, and maxima do not depend on the order. The
// results of all widths therefore agree to the bit.

using Floats = Lanes::Floats;

constexpr float kFarBelow_m = -4.0F;  // below any sum of two surfaces, present or not

inline std::int32_t later(std::int32_t a, std::int32_t b) { return a < b ? b : a; }
inline std::int32_t sooner(std::int32_t a, std::int32_t b) { return a < b ? a : b; }

inline float largest(Floats a) { return Lanes::largest(a); }

inline Floats between(Floats low, Floats high, Floats weight) {
  return Lanes::add(low, Lanes::mul(weight, Lanes::sub(high, low)));
}

inline Floats along_edge(const EdgeLine& edge, Floats y) {
  return Lanes::add(Lanes::all(edge.x),
                    Lanes::mul(Lanes::all(edge.slope), Lanes::sub(y, Lanes::all(edge.y))));
}

// The state of a triangle in the rows from `row`: the columns [first, end) that it covers, and its ramps in the
// window's middle column.
struct TriangleRows {
  std::int32_t first[kBandRows];
  std::int32_t end[kBandRows];
  float place_x[kBandRows];
  float place_y[kBandRows];
  float height_m[kBandRows];
  float lift_m[kBandRows];
};

inline float middle_of(const FieldSamples& field) {
  return 0.5F * static_cast<float>(field.samples - 1);
}

inline void find_rows(const SampledTriangle& triangle, std::int32_t row, std::int32_t rows,
                      float middle, TriangleRows& found) {
  static_assert(kBandRows % Lanes::kWidth == 0);
  for (std::int32_t i = 0; i < rows; i += Lanes::kWidth) {
    const Floats y = Lanes::as_float(Lanes::counted_from(row + i));
    const Floats whole = along_edge(triangle.whole, y);
    const Floats broken =
        Lanes::choose(Lanes::less(y, Lanes::all(triangle.middle_y)), along_edge(triangle.below, y),
                      along_edge(triangle.above, y));
    Lanes::store(found.first + i, Lanes::ceiling(Lanes::min(whole, broken)));
    Lanes::store(found.end + i, Lanes::ceiling(Lanes::max(whole, broken)));
    const Floats from_middle = Lanes::sub(y, Lanes::all(middle));
    const auto down = [from_middle](const Ramp& ramp, float* to) {
      Lanes::store(to, Lanes::add(Lanes::all(ramp.middle),
                                  Lanes::mul(Lanes::all(ramp.per_row), from_middle)));
    };
    down(triangle.place_x, found.place_x + i);
    down(triangle.place_y, found.place_y + i);
    down(triangle.height_m, found.height_m + i);
    down(triangle.lift_m, found.lift_m + i);
  }
}

// Writes the triangle's samples to the band where no other surface is further out. Returns the number of samples that
// already had a surface.
inline std::int32_t put_triangle(const SampledTriangle& triangle, const FieldSamples& field,
                                 const BandRoom& room, std::int32_t band_row,
                                 std::int32_t band_rows) {
  const std::int32_t row = later(triangle.first_row, band_row);
  const std::int32_t rows = sooner(triangle.end_row, band_row + band_rows) - row;
  if (rows <= 0) return 0;
  std::int32_t folded = 0;
  const float middle = middle_of(field);
  TriangleRows found;
  find_rows(triangle, row, rows, middle, found);
  const std::int32_t first_block =
      (triangle.first_column + field.apron) / Lanes::kWidth * Lanes::kWidth;
  for (std::int32_t block = first_block; block < triangle.end_column + field.apron;
       block += Lanes::kWidth) {
    const Lanes::Ints column = Lanes::counted_from(block - field.apron);
    const Floats from_middle = Lanes::sub(Lanes::as_float(column), Lanes::all(middle));
    const auto across = [from_middle](const Ramp& ramp) {
      return Lanes::mul(Lanes::all(ramp.per_column), from_middle);
    };
    const Floats place_x = across(triangle.place_x);
    const Floats place_y = across(triangle.place_y);
    const Floats height_m = across(triangle.height_m);
    const Floats lift_m = across(triangle.lift_m);
    std::int32_t at = (row - band_row) * field.stride + block;
    for (std::int32_t i = 0; i < rows; ++i, at += field.stride) {
      const Lanes::Mask inside = Lanes::within(column, found.first[i], found.end[i]);
      if (Lanes::bits(inside) == 0) continue;
      const auto here = [i](const float* down, Floats along) {
        return Lanes::add(Lanes::all(down[i]), along);
      };
      const Floats here_m = here(found.height_m, height_m);
      const Floats before_m = Lanes::load(room.height_m + at);
      const Lanes::Mask outermost = Lanes::both(inside, Lanes::less(before_m, here_m));
      const unsigned taken =
          Lanes::bits(Lanes::both(inside, Lanes::less(Lanes::all(kNothing_m), before_m)));
      if (taken != 0) folded += __builtin_popcount(taken);
      Lanes::store_where(room.height_m + at, outermost, here_m);
      Lanes::store_where(room.place_x + at, outermost, here(found.place_x, place_x));
      Lanes::store_where(room.place_y + at, outermost, here(found.place_y, place_y));
      Lanes::store_where(room.lift_m + at, outermost, here(found.lift_m, lift_m));
    }
  }
  return folded;
}

std::int32_t sample_surface_by_lanes(const SurfaceTask& task) {
  std::int32_t folded = 0;
  // A copy: stores through the pointers cannot change it.
  const FieldSamples field = task.field;
  const BandRoom room = task.room;
  const PairedTexels texels = task.texels;
  const std::int32_t across_all = field.samples + 2 * field.apron;
  const std::int32_t end = task.end_row;
  const Floats nothing = Lanes::all(0.0F);
  const Floats last_column = Lanes::all(texels.last_column);
  const Floats last_row = Lanes::all(texels.last_row);
  for (std::int32_t band = task.first_row; band < end; band += kBandRows) {
    const std::int32_t rows = sooner(kBandRows, end - band);
    for (std::int32_t i = 0; i < rows * field.stride; i += Lanes::kWidth) {
      Lanes::store(room.height_m + i, Lanes::all(kNoSurface_m));
    }
    for (std::int32_t i = 0; i < task.count; ++i) {
      folded += put_triangle(task.triangles[i], field, room, band - field.apron, rows);
    }
    for (std::int32_t i = 0; i < rows; ++i) {
      for (std::int32_t column = 0; column < across_all; column += Lanes::kWidth) {
        const std::int32_t at = i * field.stride + column;
        float* const to = field.height_m + band * field.stride + at;
        const Floats height_m = Lanes::load(room.height_m + at);
        const Lanes::Mask covered = Lanes::less(Lanes::all(kNothing_m), height_m);
        // Reading the texels takes longer than everything else here; the other rooms of these lanes have no meaning.
        if (Lanes::bits(covered) == 0) {
          Lanes::store(to, Lanes::all(kNoSurface_m));
          continue;
        }
        const auto inside = [&](const float* place, Floats last) {
          return Lanes::min(Lanes::max(Lanes::load(place + at), nothing), last);
        };
        const Floats texture = Lanes::texture(texels, inside(room.place_x, last_column),
                                              inside(room.place_y, last_row));
        const Floats textured_m =
            Lanes::add(height_m, Lanes::mul(Lanes::load(room.lift_m + at), texture));
        Lanes::store(to, Lanes::choose(covered, textured_m, Lanes::all(kNoSurface_m)));
      }
    }
  }
  return folded;
}

struct Accumulated {
  Floats u[2];
  Floats v[2];
  Floats turn[2];
  Floats covered;
};

inline void compare_row(const ComparisonTask& whole_task, std::int32_t row, Accumulated& most) {
  const ComparisonTask task = whole_task;  // a copy: no store below changes it
  const std::int32_t stride = task.a.stride;
  const std::int32_t step = task.step_cells;
  const float* const a_row = task.a.height_m + (row + task.a.apron) * stride + task.a.apron;
  const float* const b_row = task.b.height_m + row * task.b.stride;
  // The shift of the turned samples along u, constant within the row.
  const float along = task.turn.turn_rad * (static_cast<float>(row) - middle_of(task.b));
  const std::int32_t forth_cells =
      along < 0.0F ? -static_cast<std::int32_t>(-along) - 1 : static_cast<std::int32_t>(along);
  const std::int32_t back_cells = -forth_cells - 1;
  const Floats forth = Lanes::all(along - static_cast<float>(forth_cells));
  const Floats back = Lanes::all(-along - static_cast<float>(back_cells));
  Floats row_most = Lanes::all(kFarBelow_m);
  for (std::int32_t column = 0; column < task.b.samples; column += Lanes::kWidth) {
    const float* const a = a_row + column;
    const Floats b = Lanes::load(b_row + column);
    const auto with = [&](const float* moved) { return Lanes::add(b, Lanes::load(moved)); };
    const auto raise = [](Floats& highest, Floats to) { highest = Lanes::max(highest, to); };
    const auto turned = [&](const float* from, Floats weight_u, Floats weight_v) {
      const Floats near = between(Lanes::load(from), Lanes::load(from + 1), weight_u);
      const Floats far =
          between(Lanes::load(from + stride), Lanes::load(from + stride + 1), weight_u);
      return Lanes::add(b, between(near, far, weight_v));
    };
    const Floats here = with(a);
    raise(row_most, here);
    Lanes::store(task.column_most_m + column,
                 Lanes::max(Lanes::load(task.column_most_m + column), here));
    most.covered = Lanes::add(most.covered, Lanes::choose(Lanes::less(Lanes::all(kNothing_m), here),
                                                          Lanes::all(1.0F), Lanes::all(0.0F)));
    raise(most.u[0], with(a - step));
    raise(most.u[1], with(a + step));
    raise(most.v[0], with(a - step * stride));
    raise(most.v[1], with(a + step * stride));
    const std::int32_t block = column / kMostLanes;
    raise(most.turn[0], turned(a + task.turn.forth_cells[block] * stride + forth_cells, forth,
                               Lanes::load(task.turn.forth_weight + column)));
    raise(most.turn[1], turned(a + task.turn.back_cells[block] * stride + back_cells, back,
                               Lanes::load(task.turn.back_weight + column)));
  }
  Lanes::store(task.row_most_m + row * kMostLanes, row_most);
}

// A tilt shifts whole rows or columns, so their maxima are sufficient.
inline void find_tilts(const ComparisonTask& task, ElevenMaxima& maxima) {
  const std::int32_t samples = task.b.samples;
  const float middle = middle_of(task.b);
  Floats here = Lanes::all(kFarBelow_m);
  Floats tilt_u[2] = {here, here};
  Floats tilt_v[2] = {here, here};
  for (std::int32_t row = 0; row < samples; ++row) {
    const Floats most = Lanes::load(task.row_most_m + row * kMostLanes);
    const Floats rise = Lanes::all(task.tilt_rise_m * (static_cast<float>(row) - middle));
    here = Lanes::max(here, most);
    tilt_u[0] = Lanes::max(tilt_u[0], Lanes::sub(most, rise));
    tilt_u[1] = Lanes::max(tilt_u[1], Lanes::add(most, rise));
  }
  for (std::int32_t column = 0; column < samples; column += Lanes::kWidth) {
    const Floats most = Lanes::load(task.column_most_m + column);
    const Floats rise =
        Lanes::mul(Lanes::all(task.tilt_rise_m),
                   Lanes::sub(Lanes::as_float(Lanes::counted_from(column)), Lanes::all(middle)));
    tilt_v[0] = Lanes::max(tilt_v[0], Lanes::add(most, rise));
    tilt_v[1] = Lanes::max(tilt_v[1], Lanes::sub(most, rise));
  }
  maxima.here_m = largest(here);
  for (int way = 0; way < 2; ++way) {
    maxima.tilt_u_m[way] = largest(tilt_u[way]);
    maxima.tilt_v_m[way] = largest(tilt_v[way]);
  }
}

// The first sample, row by row, at which the sum of both surfaces reaches this height.
inline void find_deepest(const FieldSamples& a, const FieldSamples& b, const float* row_most_m,
                         float here_m, std::int32_t& row, std::int32_t& column) {
  const Floats depth = Lanes::all(here_m);
  const auto reached = [depth](const float* most) {
    return Lanes::bits(Lanes::less(Lanes::load(most), depth)) != (1U << Lanes::kWidth) - 1U;
  };
  row = 0;
  while (row + 1 < b.samples && !reached(row_most_m + row * kMostLanes)) ++row;
  const float* const a_row = a.height_m + (row + a.apron) * a.stride + a.apron;
  const float* const b_row = b.height_m + row * b.stride;
  column = 0;
  while (column + 1 < b.samples && a_row[column] + b_row[column] < here_m) ++column;
}

void compare_by_lanes(const ComparisonTask& task, ElevenMaxima& maxima) {
  const Floats far_below = Lanes::all(kFarBelow_m);
  for (std::int32_t column = 0; column < task.b.samples; column += Lanes::kWidth) {
    Lanes::store(task.column_most_m + column, far_below);
  }
  Accumulated most{
      {far_below, far_below}, {far_below, far_below}, {far_below, far_below}, Lanes::all(0.0F)};
  for (std::int32_t row = 0; row < task.b.samples; ++row) compare_row(task, row, most);
  for (int way = 0; way < 2; ++way) {
    maxima.u_m[way] = largest(most.u[way]);
    maxima.v_m[way] = largest(most.v[way]);
    maxima.turn_m[way] = largest(most.turn[way]);
  }
  float covered[Lanes::kWidth];
  Lanes::store(covered, most.covered);
  maxima.covered = 0;
  for (const float lane : covered) maxima.covered += static_cast<std::int32_t>(lane);
  find_tilts(task, maxima);
  find_deepest(task.a, task.b, task.row_most_m, maxima.here_m, maxima.row, maxima.column);
}

}  // namespace
}  // namespace asperity
