// Declares the input and output of the sample loops, for all instruction sets.

#pragma once

#include <cstdint>

namespace asperity {

// These structs are used in sources that are compiled for different processors. They are plain, and this header has no
// inline functions: such a source could emit an inline function that is then linked into code for every processor.

/// The height of a missing surface, in metres outwards. It is far below every surface, but close enough that a weight
/// of 1e-9 next to it has no influence.
inline constexpr float kNoSurface_m = -1.0F;
/// If a sum of two surfaces is below this, at least one of them is missing.
inline constexpr float kNothing_m = -0.5F;

inline constexpr int kMostLanes = 16;
/// The number of rows of a band; samples are processed band by band, so that intermediate results stay in the
/// first-level cache.
inline constexpr int kBandRows = 32;

/// A quantity over a triangle: middle + per_column·(x − m) + per_row·(y − m), with m the window's middle.
struct Ramp {
  float middle = 0.0F;
  float per_column = 0.0F;
  float per_row = 0.0F;
};

/// A line through (x, y) and its change in columns per row.
struct EdgeLine {
  float x = 0.0F;
  float y = 0.0F;
  float slope = 0.0F;
};

/// A face in cells of the window, (0, 0) at its first sample. Rows and columns: the first, and one after the last,
/// inside the field.
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
  Ramp lift_m{};    ///< per 1/16384 of a count of the atlas, outwards
};

/// Texels in pairs: a row's value in the lower 16 bits, the next row's in the upper ones. The pitch is not a power of
/// two, which would map a column of texels to few cache lines.
struct PairedTexels {
  const std::uint32_t* pairs = nullptr;
  std::int32_t pitch = 0;
  float last_column = 0.0F;
  float last_row = 0.0F;
};

/// Heights outwards (along n for B, against n for A) on the samples of the window and an apron around it.
struct FieldSamples {
  float* height_m = nullptr;  ///< of the apron's first corner; kMostLanes more than rows · stride
  std::int32_t samples = 0;   ///< of the window, in each direction
  std::int32_t apron = 0;
  std::int32_t stride = 0;
};

/// Memory for one band; never NaN, so that results without a surface are numbers.
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
  std::int32_t first_row = 0;  ///< of the field, its apron included; other rows are unchanged
  std::int32_t end_row = 0;
};

/// The interpolation of the turned A. Relative to A, a sample moves by turn·(y, −x) cells or back; along y this is a
/// whole number of cells and a weight for each column.
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
  float tilt_rise_m = 0.0F;  ///< the rise per step of a tilt, one cell from the axis
  TurnTable turn{};
  float* row_most_m = nullptr;     ///< kMostLanes for each row
  float* column_most_m = nullptr;  ///< one for each column
};

/// The largest sum of both surfaces for A at its pose and in the ten configurations around it. "tilt" is a rotation of
/// A about u or v through the origin, without its translation along the window.
struct ElevenMaxima {
  float here_m = 0.0F;
  float u_m[2]{};  ///< forth, back
  float v_m[2]{};
  float tilt_u_m[2]{};
  float tilt_v_m[2]{};
  float turn_m[2]{};
  std::int32_t row = 0;  ///< of the deepest sample; the first one if several are equally deep
  std::int32_t column = 0;
  std::int32_t covered = 0;
};

struct WeighingTask {
  FieldSamples a{};  ///< apron: kSlopeApron
  FieldSamples b{};  ///< apron: 0
  float per_tau_per_m = 0.0F;
  float* row_most_m = nullptr;  ///< kMostLanes for each row
};

/// Slopes of A's samples are 8·(h₁ − h₋₁) − (h₂ − h₋₂), twelve times the slope per cell.
inline constexpr int kSlopeApron = 2;
inline constexpr float kSlope_cells = 12.0F;

/// Sums over the window of a weight times a quantity of the sample: its position in cells from the middle (x, y), A's
/// height along n (z) and slopes in kSlope_cells.
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

/// Sums with the weight w = exp((h_B − h_A − here)/τ), and with w·log₂ w.
struct WeightedSums {
  float here_m = 0.0F;  ///< of the deepest sample, with weight 1
  std::int32_t row = 0;
  std::int32_t column = 0;
  std::int32_t covered = 0;
  PlaceSums once{};
  PlaceSums by_log2{};
};

/// The number of rows in a bound of kept heights.
inline constexpr int kBoundRows = 2;
/// The number of rows of a block; blocks of kMostLanes columns are compared.
inline constexpr int kBlockRows = 8;

/// Heights outwards on a square lattice that is fixed to its body.
struct KeptHeights {
  float* height_m = nullptr;  ///< kMostLanes more than samples · stride
  std::int32_t samples = 0;   ///< in each direction; a multiple of kBoundRows
  std::int32_t stride = 0;
  float* most_m = nullptr;  ///< over kBoundRows rows and `span` columns from here; same stride
  std::int32_t span = 0;    ///< 1 to 32
};

/// The task of computing the bounds of existing rows.
struct BoundTask {
  KeptHeights field{};
  std::int32_t first_row = 0;  ///< multiples of kBoundRows
  std::int32_t end_row = 0;
  float* room_m = nullptr;  ///< field.stride and 3 · kMostLanes
};

/// The position in A's lattice that lies over a sample of the window, in cells from the first sample of each: (x, y) +
/// column·(x, y)_per_column + row·(x, y)_per_row. Nearly the identity.
struct KeptPositions {
  float x = 0.0F;
  float y = 0.0F;
  float x_per_column = 1.0F;
  float x_per_row = 0.0F;
  float y_per_column = 0.0F;
  float y_per_row = 1.0F;
};

/// The current value of a height h at (x, y) of A's lattice: per_m·h + per_x_m·x + per_y_m·y + shift_m.
struct KeptLift {
  float per_m = 1.0F;
  float per_x_m = 0.0F;
  float per_y_m = 0.0F;
  float shift_m = 0.0F;
};

struct KeptTask {
  KeptHeights a{};  ///< every requested position has two samples around it
  KeptHeights b{};
  std::int32_t samples = 0;   ///< of the window, in each direction: a multiple of kMostLanes
  std::int32_t b_column = 0;  ///< of B's lattice at the window's first sample
  std::int32_t b_row = 0;     ///< a multiple of kBoundRows
  KeptPositions here{};
  KeptPositions forth{};  ///< with A turned about n
  KeptPositions back{};
  KeptLift lift{};
  std::int32_t step_cells = 0;
  float tilt_rise_m = 0.0F;
  float per_tau_per_m = 0.0F;
  bool prune = true;
  std::int32_t first_block = 0;   ///< where the deepest sample may be: only saves time
  float* bound_m = nullptr;       ///< one for each block
  float* block_most_m = nullptr;  ///< kMostLanes for each block
};

/// The loops for one instruction set. Real-time: no allocation, no lock, no exception.
struct SampleLoops {
  /// Returns the number of samples, apron included, at which several sheets overlap.
  std::int32_t (*sample_surface)(const SurfaceTask& task) = nullptr;
  void (*compare)(const ComparisonTask& task, ElevenMaxima& maxima) = nullptr;
  void (*weigh)(const WeighingTask& task, WeightedSums& sums) = nullptr;
  void (*bound_rows)(const BoundTask& task) = nullptr;
  /// As `compare` and `weigh`, for kept heights; without `covered`.
  void (*compare_kept)(const KeptTask& task, ElevenMaxima& maxima) = nullptr;
  void (*weigh_kept)(const KeptTask& task, WeightedSums& sums) = nullptr;
};

extern const SampleLoops kSse2Loops;
extern const SampleLoops kAvx2Loops;
extern const SampleLoops kAvx512Loops;

}  // namespace asperity
