// Counts of answers, and the tables that are made of them in every family.

#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "analysis/proportion.h"
#include "app/analyses/analysis_outcome.h"

namespace asperity {

/// How often something was so, for how many people, and out of how many equally likely outcomes.
class Tally final {
 public:
  /// `outcomes`: chance is 1 of so many.
  void count(const std::string& person, bool hit, std::uint64_t outcomes);

  HitCount hits() const noexcept { return hits_; }
  std::size_t persons() const noexcept { return persons_.size(); }
  /// The one number of outcomes that all counts share; nothing when they differ.
  std::optional<std::uint64_t> outcomes() const;

 private:
  HitCount hits_{};
  std::set<std::string> persons_{};
  std::set<std::uint64_t> outcomes_{};
};

/// A row of a table of shares: its keys, in the order of the key columns, and its count.
struct ShareRow {
  std::vector<std::string> keys{};
  Tally tally{};
};

struct ShareTable {
  std::string name{};
  Phrase title{};
  Phrase note{};
  std::vector<std::string> key_columns{};
  std::string hits_column{};  ///< "chosen", "correct"
  std::string quantity{};     ///< of the findings: "share_chosen"
  std::vector<ShareRow> rows{};
};

/// Appends the table (count, share, Wilson and Clopper–Pearson 95 % intervals, chance, exact
/// two-sided binomial test) and the same as findings.
void add_shares(const ShareTable& shares, AnalysisOutcome& outcome);

/// `at_chance` with the number of outcomes in its place: "By chance: 1/%1 of the answers right." — or
/// that it differs between the trials.
Phrase chance_note(const Tally& tally, const Phrase& at_chance);

/// What one person's share is, over all of the person's answers.
struct PersonShares {
  std::string key{};                      ///< "item=sinusoid", or empty
  std::map<std::string, Tally> people{};  ///< by participant
};

/// Appends the table in which the unit is the person: mean, spread and range of the persons' own
/// shares.
void add_person_shares(std::span<const PersonShares> shares, const std::string& key_column,
                       const std::string& quantity, AnalysisOutcome& outcome);

/// A table of counts as the chapter prints it: labels down, the levels of the factor `column` and
/// `all` across.
struct CountTable {
  std::string name{};
  Phrase title{};
  Phrase note{};
  std::string label_column{};
  std::vector<std::string> labels{};
};
void add_counts(const CountTable& counts, std::span<const std::string> columns,
                const std::function<std::size_t(std::size_t label, const std::string& column)>& at,
                AnalysisOutcome& outcome);

/// Felt down, chosen across. `pairs` are (felt, chosen); `options` are columns even if nobody chose
/// them.
void add_confusion(std::span<const std::pair<std::string, std::string>> pairs,
                   const std::set<std::string>& options, AnalysisOutcome& outcome);

/// Texture force per model: what was aimed at, and what the hands made of it. No table where
/// nothing was measured.
void add_texture_force(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

/// The remark that pooled answers of the same persons are not independent, where it is so.
void remark_on_pooling(std::size_t answers, std::size_t persons, AnalysisOutcome& outcome);

/// Levels of the factor `column`, numbers by size, then `all`.
std::vector<std::string> columns_of(const GatheredAnswers& gathered);
/// Whether an answer counts in a column; every answer counts in `all`.
bool stands_in(const GatheredAnswer& answer, const std::string& column);
inline constexpr const char* kAllColumns = "all";

/// The rows of the chapter's tables by sex: Female, Male and, where there are any, the others.
std::vector<std::string> sex_labels(const GatheredAnswers& gathered);
/// Whether an answer counts in a row of those.
bool is_of(const GatheredAnswer& answer, const std::string& sex_label);

}  // namespace asperity
