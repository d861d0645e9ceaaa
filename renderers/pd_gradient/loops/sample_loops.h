// What the loops over a contact's samples read and write, whatever the instructions they use.

#pragma once

#include <cstdint>

namespace asperity {

// These structs cross into sources that are compiled for other processors than the rest. They are
// plain, and this header has no inline function: what such a source emitted could be linked in
// everywhere.

/// Stands where there is no surface, in metres outwards. Far below every surface, and no further:
/// a weight of 1e-9 beside it must not matter.
inline constexpr float kNoSurface_m = -1.0F;
/// A sum of two surfaces below this has at least one of them missing.
inline constexpr float kNothing_m = -0.5F;

inline constexpr int kMostLanes = 16;
/// Samples are visited a band of rows at a time, so that what is passed on stays in the first cache.
inline constexpr int kBandRows = 32;

/// A quantity over a triangle: middle + per_column·(x − m) + per_row·(y − m), m the window's middle.
struct Ramp {
  float middle = 0.0F;
  float per_column = 0.0F;
  float per_row = 0.0F;
};

/// A line through (x, y) that moves by so many columns in a row.
struct EdgeLine {
  float x = 0.0F;
  float y = 0.0F;
  float slope = 0.0F;
};

/// A face in cells of the window, (0, 0) at its first sample. Rows and columns: first and one after
/// the last, inside the field.
struct SampledTriangle {
  EdgeLine whole{};  ///< from the lowest corner to the highest
  EdgeLine below{};  ///< from the lowest to the middle one
  EdgeLine above{};
  float middle_y = 0.0F;
  std::int32_t first_row = 0;
  std::int32_t end_row = 0;
  std::int32_t first_column = 0;
  std::int32_t end_column = 0;
  Ramp place_x{};   ///< in texels
  Ramp place_y{};   ///< in texels
  Ramp height_m{};  ///< outwards, undisplaced
  Ramp lift_m{};    ///< what 1/16384 of a count of the atlas adds, outwards
};

/// Texels two by two: a row's value in the lower 16 bits, the next row's in the upper ones. The pitch
/// is no power of two, which would map a column of texels onto few lines of the cache.
struct PairedTexels {
  const std::uint32_t* pairs = nullptr;
  std::int32_t pitch = 0;
  float last_column = 0.0F;
  float last_row = 0.0F;
};

/// Heights outwards (along n of B, against n of A) on the samples of the window and an apron around.
struct FieldSamples {
  float* height_m = nullptr;  ///< of the apron's first corner; kMostLanes more than rows · stride
  std::int32_t samples = 0;   ///< of the window, each way
  std::int32_t apron = 0;
  std::int32_t stride = 0;
};

/// Room for one band; never NaN, so that what is computed where no surface is stays a number.
struct BandRoom {
  float* place_x = nullptr;
  float* place_y = nullptr;
  float* height_m = nullptr;
  float* lift_m = nullptr;
};

struct SurfaceTask {
  const SampledTriangle* triangles = nullptr;
  std::int32_t count = 0;
  PairedTexels texels{};
  FieldSamples field{};
  BandRoom room{};
  std::int32_t first_row = 0;  ///< of the field, its apron included; the rest stays as it is
  std::int32_t end_row = 0;
};

/// The turned A is read between samples. Seen from A, a sample moves by turn·(y, −x) cells or back;
/// along y that is a whole number of cells and a weight for each column.
struct TurnTable {
  float turn_rad = 0.0F;
  const std::int32_t* forth_cells = nullptr;  ///< the same for kMostLanes columns at a time
  const float* forth_weight = nullptr;
  const std::int32_t* back_cells = nullptr;
  const float* back_weight = nullptr;
};

struct ComparisonTask {
  FieldSamples a{};  ///< apron: step_cells
  FieldSamples b{};  ///< apron: 0
  std::int32_t step_cells = 0;
  float tilt_rise_m = 0.0F;  ///< what a tilt's step lifts a cell away from the axis
  TurnTable turn{};
  float* row_most_m = nullptr;     ///< kMostLanes for each row
  float* column_most_m = nullptr;  ///< one for each column
};

/// The largest sum of both surfaces as A stands and in the ten configurations around. "tilt": what
/// moved A about u or v through the origin, without the way that takes it along the window.
struct ElevenMaxima {
  float here_m = 0.0F;
  float u_m[2]{};  ///< forth, back
  float v_m[2]{};
  float tilt_u_m[2]{};
  float tilt_v_m[2]{};
  float turn_m[2]{};
  std::int32_t row = 0;  ///< of the deepest sample; the first where several are equally deep
  std::int32_t column = 0;
  std::int32_t covered = 0;
};

struct WeighingTask {
  FieldSamples a{};  ///< apron: kSlopeApron
  FieldSamples b{};  ///< apron: 0
  float per_tau_per_m = 0.0F;
  float* row_most_m = nullptr;  ///< kMostLanes for each row
};

/// Slopes of A's samples are 8·(h₁ − h₋₁) − (h₂ − h₋₂), twelve cells' worth.
inline constexpr int kSlopeApron = 2;
inline constexpr float kSlope_cells = 12.0F;

/// Sums over the window of a weight, times what stands at a sample: its place in cells from the middle
/// (x, y), A's height along n (z) and slopes in kSlope_cells.
struct PlaceSums {
  double weight = 0.0;
  double x = 0.0;
  double y = 0.0;
  double slope_x_m = 0.0;
  double slope_y_m = 0.0;
  double z_slope_x_m2 = 0.0;
  double z_slope_y_m2 = 0.0;
  double turn_m = 0.0;  ///< x·slope_y − y·slope_x
};

/// With the weight w = exp((h_B − h_A − here)/τ), and with w·log₂ w.
struct WeightedSums {
  float here_m = 0.0F;  ///< of the deepest sample, whose weight is 1
  std::int32_t row = 0;
  std::int32_t column = 0;
  std::int32_t covered = 0;
  PlaceSums once{};
  PlaceSums by_log2{};
};

/// Kept heights are bounded by the largest of so many rows.
inline constexpr int kBoundRows = 2;
/// They are compared in blocks of kMostLanes columns and so many rows.
inline constexpr int kBlockRows = 8;

/// Heights outwards on a square lattice that stays with its body.
struct KeptHeights {
  float* height_m = nullptr;  ///< kMostLanes more than samples · stride
  std::int32_t samples = 0;   ///< each way; a multiple of kBoundRows
  std::int32_t stride = 0;
  float* most_m = nullptr;  ///< of kBoundRows rows and `span` columns from here on; same stride
  std::int32_t span = 0;    ///< 1 to 32
};

/// What bounds rows of samples that are there.
struct BoundTask {
  KeptHeights field{};
  std::int32_t first_row = 0;  ///< multiples of kBoundRows
  std::int32_t end_row = 0;
  float* room_m = nullptr;  ///< field.stride and 3 · kMostLanes
};

/// Where in A's lattice that is which stands over a sample of the window, in cells from the first
/// sample of each: (x, y) + column·(x, y)_per_column + row·(x, y)_per_row. Nearly the identity.
struct KeptPlaces {
  float x = 0.0F;
  float y = 0.0F;
  float x_per_column = 1.0F;
  float x_per_row = 0.0F;
  float y_per_column = 0.0F;
  float y_per_row = 1.0F;
};

/// What a height h at (x, y) of A's lattice is now: per_m·h + per_x_m·x + per_y_m·y + shift_m.
struct KeptLift {
  float per_m = 1.0F;
  float per_x_m = 0.0F;
  float per_y_m = 0.0F;
  float shift_m = 0.0F;
};

struct KeptTask {
  KeptHeights a{};  ///< every place that is asked for has two samples around it
  KeptHeights b{};
  std::int32_t samples = 0;   ///< of the window, each way: a multiple of kMostLanes
  std::int32_t b_column = 0;  ///< of B's lattice at the window's first sample
  std::int32_t b_row = 0;     ///< a multiple of kBoundRows
  KeptPlaces here{};
  KeptPlaces forth{};  ///< with A turned about n
  KeptPlaces back{};
  KeptLift lift{};
  std::int32_t step_cells = 0;
  float tilt_rise_m = 0.0F;
  float per_tau_per_m = 0.0F;
  bool prune = true;
  std::int32_t first_block = 0;   ///< where the deepest sample may be: saves time, changes nothing
  float* bound_m = nullptr;       ///< one for each block
  float* block_most_m = nullptr;  ///< kMostLanes for each block
};

/// The loops for one instruction set. Real-time: no allocation, no lock, no exception.
struct SampleLoops {
  /// Answers at how many samples, apron included, a sheet met another one.
  std::int32_t (*sample_surface)(const SurfaceTask& task) = nullptr;
  void (*compare)(const ComparisonTask& task, ElevenMaxima& maxima) = nullptr;
  void (*weigh)(const WeighingTask& task, WeightedSums& sums) = nullptr;
  void (*bound_rows)(const BoundTask& task) = nullptr;
  /// As `compare` and `weigh`, of kept heights; without `covered`.
  void (*compare_kept)(const KeptTask& task, ElevenMaxima& maxima) = nullptr;
  void (*weigh_kept)(const KeptTask& task, WeightedSums& sums) = nullptr;
};

extern const SampleLoops kSse2Loops;
extern const SampleLoops kAvx2Loops;
extern const SampleLoops kAvx512Loops;

}  // namespace asperity
