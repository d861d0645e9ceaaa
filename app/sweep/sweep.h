// Runs the offline roughness experiment: a force model over many textures, with a level for each
// curve.

#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "analysis/scales/magnitude.h"
#include "app/shards/shard.h"
#include "app/sweep/sweep_measure.h"
#include "renderers/offline/roughness_stroke.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/tables/table.h"

namespace asperity {

/// The declaration of a sweep. Two sweeps with equal declarations have equal rows.
struct SweepOrder {
  /// Model, parameters, hand and fixed levels; the varied quantity is replaced level by level.
  RoughnessStroke stroke{};
  VariedQuantity varied = VariedQuantity::probe_diameter;
  std::vector<double> values{};
  std::vector<double> spacings_m{};
  SpacedTexture texture{};
  std::string relief_sha256{};                        ///< of the texture's relief, if it has one
  std::string tool_sha256{};                          ///< of the stroke's tool, if it is a mesh
  std::map<std::string, std::string> asset_sha256{};  ///< of the given files of the model, by role
  std::string body{};                                 ///< the stroked body as it was given
  std::string body_sha256{};                          ///< of its mesh
};

/// Whether the texture of the model is that of the spacing. It is not where a file is given to a model without a height
/// field: the file is the same at every spacing, and a curve over spacing has no meaning.
bool spacing_has_effect(const SweepOrder& order);

/// The status of a row where the model cannot depend on the level.
inline constexpr const char* kNoEffectByConstruction = "no_effect_by_construction";

struct Sweep {
  SweepOrder order{};
  std::vector<SweepRow> rows{};  ///< level by level, each in the order of the spacings
  bool is_complete = false;

  const SweepRow* find(double value, double spacing_m) const noexcept;
};

/// The curve of one level of the varied quantity, as in the figures of the source: a parabola of
/// log₁₀ roughness over log₁₀ texture frequency (1/spacing), through the rows whose status is `ok`
/// or `no_effect_by_construction` and that have a logarithm.
struct SweepCurve {
  double value = 0.0;
  std::vector<SweepRow> fitted{};
  std::optional<CurveFit> fit{};  ///< over log₁₀ of the frequency in 1/m; of at least three rows
  /// The spacing of the row with the greatest value; nothing where that is the first or the last
  /// spacing.
  std::optional<double> greatest_at_m{};
};
/// Without fits and greatest values where `spacing_has_effect` is false.
std::vector<SweepCurve> curves_of(const Sweep& sweep,
                                  SweepMeasure measure = SweepMeasure::max_accel);

/// The drop point of the tip (renderers/offline/drop_point.h) at a level of the varied quantity, in metres; nullopt where
/// the model has no bodies, where a mesh takes the place of the tip, and where tip or texture have no drop point.
std::optional<double> drop_point_at(const SweepOrder& order, double value);

/// The default levels, in SI units.
std::vector<double> usual_values(VariedQuantity varied);
/// From one spacing to another in equal ratios. Errors: std::invalid_argument for spacings that are
/// not positive and for fewer than two.
std::vector<double> logarithmic_spacings(double from_m, double to_m, int count);

/// The table to be written: the columns of a sweep, a row for each computed row. The measures of turning are absent where
/// the tool does not turn.
Table table_of(const Sweep& sweep);
/// The content of the file next to the table that declares how it was made, JSON,
/// `asperity.sweep/1`.
std::string declaration_of(const SweepOrder& order);
std::filesystem::path declaration_beside(const std::filesystem::path& table);

struct SweepFile {
  std::filesystem::path out{};
  Overwrite overwrite = Overwrite::refuse;
  int jobs = 1;
};

/// Computes the rows that are missing in the file and writes it, with the declaration next to it,
/// at least once a second while there are new rows. A file with the same declaration is continued,
/// even if complete; a file with another declaration is rejected or, with Overwrite::allow,
/// replaced.
///
/// A level that the model does not depend on according to its declaration (`depends_on`) is not
/// computed again for every value: the rows of a spacing are equal, with the status
/// `no_effect_by_construction`; where their single stroke was not `ok` they have no measures.
///
/// The bytes do not depend on `jobs`. After a stop request, the complete rows are kept;
/// `is_complete` reports this. `progress` receives fractions, from any thread.
///
/// Errors: std::invalid_argument, ResultsError (the file), std::runtime_error for a file of another
/// sweep.
Sweep sweep_into_file(const SweepOrder& order, const SweepFile& file, const std::stop_token& stop,
                      const std::function<void(double)>& progress);

/// Checked before hours of work, whose result could not be written. Errors: std::invalid_argument for a folder that does not
/// exist.
void require_folder_of(const std::filesystem::path& file);

/// Checks an order as `sweep_into_file` does before it begins.
///
/// Errors: std::invalid_argument.
void require_sweep(const SweepOrder& order);

/// Computes the rows without a file.
Sweep sweep_of(const SweepOrder& order, int jobs);

/// Computes the rows of one shard without a file; the items are the spacings, each with all levels. `is_complete` is that of
/// the shard.
///
/// Errors: std::invalid_argument, also for more shards than spacings.
Sweep sweep_of_shard(const SweepOrder& order, const Shard& shard, int jobs,
                     const std::stop_token& stop, const std::function<void(double)>& progress);

}  // namespace asperity
