// Findings of the families put beside each other: found again by name, tested together, said in words.

#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/analyses/analysis_outcome.h"
#include "app/analyses/found_numbers.h"
#include "app/analyses/tidy/tidy_families.h"

namespace asperity {

/// Runs a family on a table and gives its findings the name `analysis`. What the family refuses is a
/// finding `status` with the word not_applicable.
std::vector<Finding> analysis_of(const char* analysis, const char* family, TidyInput input);

/// A text, and a list of them, as FamilyOptions::add reads them.
std::string json_text(const std::string& text);
std::string json_list(std::span<const std::string> texts);

/// Which findings to keep.
using KeepFinding = std::function<bool(const Finding&)>;
/// Appends them to those of the outcome.
void keep_findings(
    std::span<const Finding> findings, AnalysisOutcome& outcome,
    const KeepFinding& keep = [](const Finding&) { return true; });

/// The tests of a study, and Holm's correction over those that are its family.
class StudyTests final {
 public:
  /// The table of them all, and the analysis that its findings are of.
  static constexpr const char* kTable = "tests";

  /// The family that the protocol declares, or the first test of its kind.
  explicit StudyTests(const GatheredAnswers& gathered);

  struct Test {
    std::string name{};   ///< one of test_names()
    std::string about{};  ///< what of several is tested; may be empty
    std::string method{};
    std::size_t n = 0;   ///< of the units
    std::string unit{};  ///< "participants"; "answers", "goes" where those are pooled
    std::optional<double> p{};
    FindingName source{};              ///< whose p it is
    std::optional<double> adjusted{};  ///< within the family
    std::size_t family_size = 0;       ///< of those that it was adjusted with
    std::optional<double> smallest_p{};  ///< that could be attained, where that exceeds 5 %
    std::string status = "ok";

    /// Only a test of the family can show something; adjusted within it, at 5 %.
    bool shows() const noexcept { return adjusted && *adjusted < 0.05; }
  };
  /// The status of a test of several participants' answers where there is one participant.
  static constexpr const char* kOneParticipantAlone = "cannot be tested with one participant";

  /// A p of the family of analyses; what is no number is why there is no test. Of the study's own
  /// family such a test counts as p = 1.
  /// `unit`: what the finding's n counts. `smallest`: the smallest p that could be attained; a single participant
  /// whose smallest p is 1 cannot be tested.
  void add(const std::string& name, const std::string& about, const Finding* finding,
           const char* unit = "participants", const Finding* smallest = nullptr);
  /// Adjusts, and appends the table `kTable` with its findings. What the protocol declares and nobody
  /// has added is a row without a p.
  void finish(AnalysisOutcome& outcome);

  const Test* find(std::string_view name, std::string_view about = {}) const;
  std::span<const Test> tests() const noexcept { return tests_; }
  bool is_in_family(std::string_view name) const;
  const std::string& family() const noexcept { return name_; }
  bool is_declared() const noexcept { return is_declared_; }

 private:
  /// What stands below the table: of how many tests the family is.
  Phrase note_on_family(std::size_t tests) const;

  std::vector<std::string> family_{};
  std::string name_{};
  bool is_declared_ = false;
  std::vector<Test> tests_{};
};

/// "75 %"
Phrase percent(double share);
/// "p = .031, uncorrected"; of a test of the family "p = .062, Holm-corrected", or "p = .031, the only confirmatory
/// test". Where no p of 5 % could be attained, with the smallest one.
Phrase p_text(const StudyTests::Test& test);
/// What is said of a test that was made: `claim` if it shows something, `nothing` if it does not, and
/// of a test outside the family `told`, with the sentence that it claims nothing.
struct Sayings {
  Phrase claim{};
  Phrase nothing{};
  Phrase told{};
};
Phrase said_of(const StudyTests::Test& test, const Sayings& sayings);
/// "(95 % interval 40 % to 71 %)" of a share, or why there is none.
Phrase interval_text(const Finding& share);

/// What the n of a finding counts.
enum class CountedUnit { participants, answers, goes };
/// The answer of a question: `finding` is what the sentence rests on.
void add_question(AnalysisOutcome& outcome, const char* name, Phrase question, Phrase answer,
                  Phrase method, const char* table, const Finding* finding,
                  CountedUnit unit = CountedUnit::participants);

/// In what the results of women and men are told.
enum class SexesScale { shares_of_answers, shares_of_items, items };
/// Means of the participants of each sex with their intervals, and the first less the second.
struct SexesComparison {
  std::optional<Finding> women{};
  std::optional<Finding> men{};
  std::optional<Finding> difference{};
  SexesScale scale = SexesScale::shares_of_answers;
};
/// Whether women and men differ; nothing where there are not both.
void ask_sexes(const SexesComparison& sexes, const StudyTests& tests, AnalysisOutcome& outcome);

/// The table `name` from subj.mean, subj.sd, subj.minimum, subj.median and subj.maximum of these
/// keys, with the same as findings `mean_of_persons_QUANTITY`.
struct PersonsRow {
  std::string name{};  ///< in the table
  std::string key{};   ///< of the findings
};
void add_persons(const FoundNumbers& found, std::span<const PersonsRow> rows,
                 const std::string& key_column, const std::string& quantity,
                 AnalysisOutcome& outcome, const char* name = "persons");

/// A row per measure: value and interval, where they are numbers.
struct Measure {
  enum class Form { number, count };
  const char* name = nullptr;  ///< fixed, for programs; words: cell_words.h
  const char* quantity = nullptr;
  Form form = Form::number;
};
void add_measures(const FoundNumbers& found, std::span<const Measure> measures,
                  AnalysisOutcome& outcome);

}  // namespace asperity
