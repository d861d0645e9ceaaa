// The analyses of tidy tables: a family's table and options in, findings out.

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/finding.h"
#include "app/findings/tidy/family_options.h"
#include "results_schema/tidy_table.h"

namespace asperity {

/// What a family analyses: its tables, in the order that it declares, and its options.
struct TidyInput {
  std::vector<TidyTable> tables{};
  FamilyOptions options{};

  /// Throws std::runtime_error where there are fewer.
  const TidyTable& table(std::size_t index = 0) const;
};

/// One way to analyse tables of one form. There is one per reference family, and whoever has such
/// data goes through it: `analyze --case`, `analyze --table`, and the answers of a study once they
/// are such a table. So each number has one home.
///
/// To add a family NAME:
/// 1. In analysis/, under headers named after the subject: pure functions with typed input (structs,
///    spans, Eigen) and typed results. They know no table, no JSON and no name of a quantity. Input
///    without an answer is std::invalid_argument; an answer that good data can lack is a
///    std::optional, NaN (a number undefined for these data), ±infinity, or an enum for the reasons.
/// 2. `app/findings/tidy/NAME.cpp` with `std::vector<Finding> NAME_findings(const TidyInput&)`: asks
///    TidyTable for its columns and FamilyOptions for its options (both refuse in sentences), calls
///    1., and writes one finding per number with FindingList: `quantity` and `key` are the fixed
///    names that scripts rest on, parts of a key joined by `|`; `n` counts independent units
///    (participants, where there are any), `method` says what was computed in words; the main
///    estimate has its interval as well. Word and status for what cannot be answered.
/// 3. Its declaration below, its line in the table of tidy_families.cpp, its file in CMakeLists.txt.
/// 4. Cases of our own in tests/analysis/reference/NAME_NN/: gen.R, case.json, tables, expected.csv.
///    tests/app/reference_cases_test.cpp walks over all that it finds there.
struct TidyFamily {
  std::string_view name{};
  std::string_view tables{};   ///< which, with their columns; for people
  std::string_view options{};  ///< with what they take; for people
  std::vector<Finding> (*findings)(const TidyInput&) = nullptr;
  std::string_view option_names{};  ///< those names alone, a comma between
  std::size_t most_tables = 1;
};

/// Throws std::runtime_error naming an option that the family does not have, and what may be meant.
void refuse_unknown_options(const TidyFamily& family, const FamilyOptions& options);
/// Throws std::runtime_error naming the first of more tables than the family takes: nothing would come of it.
void refuse_further_tables(const TidyFamily& family, const TidyInput& input);

std::span<const TidyFamily> tidy_families();

/// "proportion, selection, …"
std::string family_names();

/// Throws std::runtime_error with the families that there are.
const TidyFamily& tidy_family(const std::string& name);

std::vector<Finding> equivalence_findings(const TidyInput& input);
std::vector<Finding> glmm_findings(const TidyInput& input);
std::vector<Finding> group_findings(const TidyInput& input);
std::vector<Finding> icc_findings(const TidyInput& input);
std::vector<Finding> learning_findings(const TidyInput& input);
std::vector<Finding> magnitude_findings(const TidyInput& input);
std::vector<Finding> matching_findings(const TidyInput& input);
std::vector<Finding> paired_findings(const TidyInput& input);
std::vector<Finding> power_findings(const TidyInput& input);
std::vector<Finding> proportion_findings(const TidyInput& input);
std::vector<Finding> psyfit_findings(const TidyInput& input);
std::vector<Finding> ranking_findings(const TidyInput& input);
std::vector<Finding> rating_findings(const TidyInput& input);
std::vector<Finding> recognition_findings(const TidyInput& input);
std::vector<Finding> response_times_findings(const TidyInput& input);
std::vector<Finding> rmanova_findings(const TidyInput& input);
std::vector<Finding> seedpaper_findings(const TidyInput& input);
std::vector<Finding> selection_findings(const TidyInput& input);

}  // namespace asperity
