// Compares the groups to which a protocol assigns participants in a number of each participant, or in profiles over items.

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/study_tests.h"
#include "app/findings/shared/participant_pairs.h"

namespace asperity {

/// The table of the means of the groups, and that of the profiles.
inline constexpr const char* kGroupMeans = "group_means";
inline constexpr const char* kGroupProfiles = "group_profiles";

/// A number of each participant.
struct GroupMeasure {
  std::string name{};  ///< which of several: "wood"; empty: the only one
  Phrase words{};      ///< its mean in a sentence: "the geometric mean of the detection thresholds"
  bool is_ratio = false;  ///< positive numbers, compared by the ratio of the geometric means
  std::string unit = "1";
  /// Of the participants who responded, by index of the gathered people; nothing where the number could not be estimated.
  std::map<std::uint32_t, std::optional<double>> values{};
};

/// Numbers of each participant for several items.
struct GroupProfile {
  std::string name{};  ///< which of several; empty: the only one
  Phrase words{};      ///< the numbers in a sentence: "the ratings of the items"
  std::vector<std::string> items{};
  std::map<std::pair<std::uint32_t, std::string>, double> values{};  ///< by participant and item
};

/// All comparisons of the groups of a study, pair by pair. The unit is the participant. Adds nothing without several groups.
///
/// The findings of a pair have the name of its analysis ("groups", with more than two groups "groups:FIRST|SECOND"), of several
/// measures followed by ":NAME"; those of profiles begin with "group_profiles" instead. They are those of the family
/// `group_values`.
class GroupComparisons final {
 public:
  explicit GroupComparisons(const GatheredAnswers& gathered);
  GroupComparisons(GroupComparisons&&) = default;
  GroupComparisons(const GroupComparisons&) = delete;

  /// Whether there are two groups; otherwise nothing needs to be computed for them.
  bool has_pairs() const noexcept { return !pairs_.empty(); }
  void add(const GroupMeasure& measure);
  void add(const GroupProfile& profile);
  /// Keeps the findings, and adds a test for each pair and measure or profile.
  void add_tests(StudyTests& tests, AnalysisOutcome& outcome) const;
  /// Once the tests are finished: a question for each of them, and the tables.
  void report(const StudyTests& tests, AnalysisOutcome& outcome) const;

 private:
  struct Compared {
    const ParticipantPair& pair;
    std::string name{};
    Phrase words{};
    std::string unit{};
    bool is_profile = false;
    std::vector<std::string> items{};
    std::vector<Finding> findings{};

    const char* test() const { return is_profile ? kGroupProfilesTest : kGroupsTest; }
    TestSubject about() const { return {pair.first, pair.second, name}; }
    std::string analysis() const;
  };
  void ask_measure(const Compared& one, const StudyTests& tests, AnalysisOutcome& outcome) const;
  void ask_profile(const Compared& one, const StudyTests& tests, AnalysisOutcome& outcome) const;
  void add_table_of_means(AnalysisOutcome& outcome) const;
  void add_table_of_profiles(AnalysisOutcome& outcome) const;

  const GatheredAnswers& gathered_;
  std::vector<ParticipantPair> pairs_{};
  std::vector<Compared> compared_{};
  /// By test: the code of the reason why no pair could be compared, where there are groups.
  std::map<std::string, std::string> missing_{};
};

}  // namespace asperity
