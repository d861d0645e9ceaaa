// Counts responses, and makes the tables that every kind of protocol has.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/proportion.h"
#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/analysis_outcome.h"

namespace asperity {

/// Counts hits, the participants who contributed, and the number of equally likely outcomes.
class Tally final {
 public:
  /// `outcomes`: chance is 1/outcomes; `times`: how often this occurred.
  void count(std::uint32_t person, bool hit, std::uint64_t outcomes, std::uint64_t times = 1);

  HitCount hits() const noexcept { return hits_; }
  std::size_t persons() const noexcept { return persons_; }
  /// The number of outcomes that all counts have in common; nothing when they differ.
  std::optional<std::uint64_t> outcomes() const;

 private:
  HitCount hits_{};
  std::size_t persons_ = 0;
  std::vector<bool> seen_{};  ///< by participant
  std::set<std::uint64_t> outcomes_{};
  std::uint64_t last_outcomes_ = 0;
};

/// A row of a table of proportions: its keys, in the order of the key columns, and its count.
struct ShareRow {
  std::vector<std::string> keys{};
  Tally tally{};
};

struct ShareTable {
  std::string name{};
  Phrase title{};
  Phrase note{};
  std::vector<ResultColumn> key_columns{};
  ResultColumn hits_column{};  ///< kChosen, kCorrect
  std::string quantity{};      ///< of the findings: "share_chosen"
  std::vector<ShareRow> rows{};
};

/// The item with which the one before it was compared.
inline const ResultColumn kAgainst{.id = "against",
                                   .heading = phrase("AnalysisWords", "other item")};
/// The intervals of a proportion.
inline const ResultColumn kWilson = interval_of({.id = "wilson", .digits = Digits::bounded},
                                                phrase("AnalysisWords", "Wilson 95 % CI"));
inline const ResultColumn kClopperPearson =
    interval_of({.id = "clopper_pearson", .digits = Digits::bounded},
                phrase("AnalysisWords", "Clopper–Pearson 95 % CI"));

/// Appends the table (count, proportion, Wilson and Clopper–Pearson 95 % intervals, chance, exact
/// two-sided binomial test), by the family `proportion`, and the same numbers as findings.
ResultTable& add_shares(const ShareTable& shares, AnalysisOutcome& outcome);

/// `at_chance` with the number of outcomes filled in: "Chance level: 1/%1 of the responses
/// correct." — or the statement that it differs between the trials.
Phrase chance_note(const Tally& tally, const Phrase& at_chance);

/// The rows and columns of the chapter's tables: levels of the factor `column` and `all`, the sexes
/// and `Total`. A response counts in up to two of each.
class ChapterCells final {
 public:
  explicit ChapterCells(const GatheredAnswers& gathered);

  const std::vector<std::string>& columns() const noexcept { return columns_; }
  /// Female, Male, other sexes where there are any, and Total.
  const std::vector<std::string>& sexes() const noexcept { return sexes_; }
  /// The response's column and `all`; the latter twice for a response without a column.
  std::array<std::size_t, 2> columns_of(std::uint32_t column_word) const {
    return {column_of_word_[column_word], columns_.size() - 1};
  }

  /// Calls `use(column, sex)` for each cell in which a response counts.
  template <class Use>
  void for_each(std::uint32_t column_word, std::uint32_t person, const Use& use) const {
    const std::array<std::size_t, 2> in_columns = columns_of(column_word);
    for (const std::size_t sex : {sex_of_person_[person], sexes_.size() - 1}) {
      use(in_columns[1], sex);
      if (in_columns[0] != in_columns[1]) use(in_columns[0], sex);
    }
  }

 private:
  std::vector<std::string> columns_{};
  std::vector<std::size_t> column_of_word_{};
  std::vector<std::string> sexes_{};
  std::vector<std::size_t> sex_of_person_{};
};
inline constexpr const char* kAllColumns = "all";

/// A table of counts as the chapter prints it: labels in rows, the levels of the factor `column`
/// and `all` in columns.
struct CountTable {
  std::string name{};
  Phrase title{};
  Phrase note{};
  ResultColumn label_column{};
  std::vector<std::string> labels{};
  std::vector<std::string> columns{};
  std::vector<std::size_t> counts{};  ///< label × column

  std::size_t& at(std::size_t label, std::size_t column) {
    return counts[label * columns.size() + column];
  }
};
/// A table with these labels and columns and all counts 0.
CountTable count_table(std::vector<std::string> labels, std::vector<std::string> columns);
void add_counts(const CountTable& counts, AnalysisOutcome& outcome);

/// A response as the chapter's tables of matching and recognition count it.
struct ChapterAnswer {
  std::uint32_t column = 0;  ///< a word
  std::uint32_t person = 0;
  bool hit = false;
  std::uint64_t outcomes = 0;  ///< chance is 1/outcomes
  std::uint64_t times = 1;
};

/// Hits by column and sex.
class ChapterTally final {
 public:
  explicit ChapterTally(const GatheredAnswers& gathered);
  void count(const ChapterAnswer& answer);

  const ChapterCells& cells() const noexcept { return cells_; }
  /// Appends the table of hits, with sexes in rows and columns across.
  void add(const std::string& name, const Phrase& title, const Phrase& note,
           AnalysisOutcome& outcome) const;
  /// A row per column and sex.
  void add_rows(ShareTable& shares) const;

 private:
  ChapterCells cells_;
  std::vector<Tally> by_cell_{};  ///< column × sex
  CountTable hits_{};
};

/// Counts how often each response was given to each felt item.
class ConfusionTally final {
 public:
  void count(std::uint32_t felt, std::uint32_t answer, std::size_t times = 1) {
    counts_[{felt, answer}] += times;
  }
  std::size_t at(std::uint32_t felt, std::uint32_t answer) const;
  /// Stimuli in rows, responses in columns: the felt items in the protocol's order, so that correct
  /// responses are on the diagonal, then the other responses, “cannot tell” last. `options` are
  /// columns even if they were never chosen.
  ResultTable& add_table(const GatheredAnswers& gathered, const std::set<std::string>& options,
                         AnalysisOutcome& outcome) const;

 private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> counts_{};
};

/// The texture force by model: the target, and the force achieved in the sessions. No table where
/// nothing was measured.
void add_texture_force(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

/// The remark that pooled responses of the same participants are not independent, where that is the
/// case.
void remark_on_pooling(std::size_t answers, std::size_t persons, AnalysisOutcome& outcome);

}  // namespace asperity
