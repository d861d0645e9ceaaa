// The offline roughness experiment: a force model over many textures, with a level for each curve.

#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "analysis/magnitude.h"
#include "renderers/offline/roughness_stroke.h"
#include "results_schema/atomic_file.h"
#include "results_schema/table.h"

namespace asperity {

/// What is declared of a sweep. Two with equal declarations have equal rows.
struct SweepOrder {
  /// Model, parameters, hand and fixed levels; what is varied is replaced level by level.
  RoughnessStroke stroke{};
  VariedQuantity varied = VariedQuantity::probe_diameter;
  std::vector<double> values{};
  std::vector<double> spacings_m{};
  SpacedTexture texture{};
  std::string relief_sha256{};  ///< of the texture's relief, where it is one
  std::string tool_sha256{};    ///< of the stroke's tool, where it is a mesh
};

/// The status of a row whose level the model cannot depend on.
inline constexpr const char* kNoEffectByConstruction = "no_effect_by_construction";

/// One cell: a level of what is varied over one spacing.
struct SweepRow {
  double value = 0.0;
  double spacing_m = 0.0;
  std::optional<HeldToolRoughness> roughness{};
  std::string status{};  ///< of drag.h, or `no_effect_by_construction`
};

struct Sweep {
  SweepOrder order{};
  std::vector<SweepRow> rows{};  ///< level by level, each in the order of the spacings
  bool is_complete = false;

  const SweepRow* find(double value, double spacing_m) const noexcept;
};

/// Which of the measures of a row is looked at.
enum class SweepMeasure { max_accel, rms_accel, fa1, fa2, pacinian };
/// As in the name of its column, without the unit.
const char* text_of(SweepMeasure measure) noexcept;
/// Its decimal logarithm, of the Pacinian power that of P_w, a tenth of the decibels; nothing where
/// nothing moved the tool, or not in that band.
std::optional<double> log10_of(const SweepRow& row, SweepMeasure measure);

/// One curve, of a level of what is varied, as the source's figures have it: a parabola of log₁₀
/// roughness over log₁₀ texture frequency (1/spacing), through the rows whose status is `ok` or
/// `no_effect_by_construction` and that have a logarithm.
struct SweepCurve {
  double value = 0.0;
  std::vector<SweepRow> fitted{};
  std::optional<CurveFit> fit{};  ///< over log₁₀ of the frequency in 1/m; of three rows or more
  /// The row with the greatest value; nothing where that is the first or the last spacing.
  std::optional<double> greatest_at_m{};
};
std::vector<SweepCurve> curves_of(const Sweep& sweep,
                                  SweepMeasure measure = SweepMeasure::max_accel);

/// The levels that are used where none are given, in SI units.
std::vector<double> usual_values(VariedQuantity varied);
/// From one spacing to another in equal ratios. Errors: std::invalid_argument for what is not positive
/// and fewer than two.
std::vector<double> logarithmic_spacings(double from_m, double to_m, int count);

/// What is written: the columns of a sweep, a row for each that is there.
Table table_of(const Sweep& sweep);
/// What the file beside the table says of how it was made, JSON, `asperity.sweep/1`.
std::string declaration_of(const SweepOrder& order);
std::filesystem::path declaration_beside(const std::filesystem::path& table);

struct SweepFile {
  std::filesystem::path out{};
  Overwrite overwrite = Overwrite::refuse;
  int jobs = 1;
};

/// Computes the rows that are missing in the file and writes it, with the declaration beside it, at
/// least once a second while there is something new. A file with the same declaration is gone on with,
/// also a whole one; where it is another, it is refused or, with Overwrite::allow, replaced.
///
/// A level that the model cannot depend on by its declaration (`depends_on`) is not computed again for
/// every value: the rows of a spacing are the same, and say `no_effect_by_construction`; where their
/// one stroke was not `ok` they have no measures.
///
/// The same bytes whatever `jobs`. Stopped, it leaves the rows that are whole; `is_complete` says so.
/// `progress` is told fractions, from any thread.
///
/// Errors: std::invalid_argument, ResultsError (the file), std::runtime_error for a file of another
/// sweep.
Sweep sweep_into_file(const SweepOrder& order, const SweepFile& file, const std::stop_token& stop,
                      const std::function<void(double)>& progress);

/// What `sweep_into_file` refuses of an order before it begins.
///
/// Errors: std::invalid_argument.
void require_sweep(const SweepOrder& order);

/// The rows without a file.
Sweep sweep_of(const SweepOrder& order, int jobs);

}  // namespace asperity
