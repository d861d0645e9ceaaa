// The registry of the analyses of tidy tables: a family maps a table and options to findings.

#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/numbers/finding.h"
#include "app/findings/tidy/family_options.h"
#include "results_schema/tables/tidy_table.h"

namespace asperity {

/// The input of a family: its tables, in the order that it declares, and its options.
struct TidyInput {
  std::vector<TidyTable> tables{};
  FamilyOptions options{};
  /// The keys of labels that stand for several names.
  std::map<std::string, FindingKey> keys{};

  /// The label of a key in a table; the findings about it have the key.
  std::string label_of(const FindingKey& key);

  /// Throws std::runtime_error where there are fewer.
  const TidyTable& table(std::size_t index = 0) const;
};

/// One way to analyse tables of one form. There is one per reference family, and all such data are
/// analysed by it: `analyze --case`, `analyze --table`, and the responses of a study once they are
/// converted to such a table. Each number thus has one implementation.
///
/// To add a family NAME:
/// 1. In analysis/, under headers named after the subject: pure functions with typed input (structs,
///    spans, Eigen) and typed results, without tables, JSON or names of quantities. Input without an
///    answer is std::invalid_argument; an answer that good data can lack is a std::optional, NaN (a
///    number undefined for these data), ±infinity, or an enum for the reasons.
/// 2. `app/findings/tidy/families/NAME.cpp` with `std::vector<Finding> NAME_findings(const TidyInput&)`:
///    requests its columns from TidyTable and its options from FamilyOptions (both report problems
///    in sentences), calls 1., and writes one finding per number with FindingList: `quantity` and
///    `key` are the fixed names on which scripts depend, a key has the names of its parts; `n` counts
///    independent units (participants, where there are any), `method` states what was computed in
///    words; the main estimate has its interval as well. Word and status where there is no number.
///    A quantity that anything reads by name is added to quantity_name.h.
/// 3. Its declaration below, its line in the table of tidy_families.cpp, its file in CMakeLists.txt.
/// 4. Cases of our own in tests/analysis/reference/NAME_NN/: gen.R, case.json, tables, expected.csv.
///    tests/app/reference_cases_test.cpp runs all cases that it finds there.
struct TidyFamily {
  std::string_view name{};
  std::string_view tables{};   ///< which, with their columns; for users
  std::string_view options{};  ///< with their values; for users
  std::vector<Finding> (*findings)(const TidyInput&) = nullptr;
  std::string_view option_names{};  ///< the names alone, separated by commas
  std::size_t most_tables = 1;
};

/// Throws std::runtime_error naming an option that the family does not have, and similar valid
/// names.
void refuse_unknown_options(const TidyFamily& family, const FamilyOptions& options);
/// Throws std::runtime_error naming the first table in excess of those that the family uses.
void refuse_further_tables(const TidyFamily& family, const TidyInput& input);

std::span<const TidyFamily> tidy_families();

/// "proportion, selection, …"
std::string family_names();

/// Throws std::runtime_error with the list of families for an unknown name.
const TidyFamily& tidy_family(const std::string& name);

std::vector<Finding> components_findings(const TidyInput& input);
std::vector<Finding> description_findings(const TidyInput& input);
std::vector<Finding> dprime_findings(const TidyInput& input);
std::vector<Finding> equivalence_findings(const TidyInput& input);
std::vector<Finding> glmm_findings(const TidyInput& input);
std::vector<Finding> group_findings(const TidyInput& input);
std::vector<Finding> group_values_findings(const TidyInput& input);
std::vector<Finding> icc_findings(const TidyInput& input);
std::vector<Finding> learning_findings(const TidyInput& input);
std::vector<Finding> lmm_findings(const TidyInput& input);
std::vector<Finding> magnitude_findings(const TidyInput& input);
std::vector<Finding> matching_findings(const TidyInput& input);
std::vector<Finding> mds_findings(const TidyInput& input);
std::vector<Finding> ordinal_findings(const TidyInput& input);
std::vector<Finding> paired_findings(const TidyInput& input);
std::vector<Finding> power_findings(const TidyInput& input);
std::vector<Finding> proportion_findings(const TidyInput& input);
std::vector<Finding> psi_findings(const TidyInput& input);
std::vector<Finding> psyfit_findings(const TidyInput& input);
std::vector<Finding> questplus_findings(const TidyInput& input);
std::vector<Finding> ranking_findings(const TidyInput& input);
std::vector<Finding> rating_findings(const TidyInput& input);
std::vector<Finding> recognition_findings(const TidyInput& input);
std::vector<Finding> response_times_findings(const TidyInput& input);
std::vector<Finding> rmanova_findings(const TidyInput& input);
std::vector<Finding> roc_findings(const TidyInput& input);
std::vector<Finding> seedpaper_findings(const TidyInput& input);
std::vector<Finding> selection_findings(const TidyInput& input);
std::vector<Finding> similarity_findings(const TidyInput& input);
std::vector<Finding> staircase_findings(const TidyInput& input);

}  // namespace asperity
