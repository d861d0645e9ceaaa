// One table of words for outcomes, wherever they are shown.

#include "app/gui/look/outcome_words.h"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "app/gui/base/settings.h"
#include "app/words/coded_phrases.h"
#include "app/words/event_kinds.h"
#include "app/words/reason.h"
#include "results_schema/study.h"

namespace asperity {
namespace {

constexpr std::array kOutcomes{AttemptOutcome::answered,      AttemptOutcome::timed_out,
                               AttemptOutcome::not_compliant, AttemptOutcome::aborted,
                               AttemptOutcome::device_fault,  AttemptOutcome::emergency_stop,
                               AttemptOutcome::skipped};

TEST(OutcomeWords, CallAnEmergencyStopByItsName) {
  EXPECT_EQ(OutcomeWords::of(AttemptOutcome::emergency_stop), "emergency stop");
}

// The computer may have stood still, or a renderer given a number that is none.
TEST(OutcomeWords, CallNoFaultOneOfTheDevice) {
  EXPECT_EQ(OutcomeWords::of(AttemptOutcome::device_fault), "fault");
}

TEST(OutcomeWords, TellEveryOutcomeFromTheOthers) {
  std::set<std::string> words{};
  for (const AttemptOutcome outcome : kOutcomes) {
    words.insert(OutcomeWords::of(outcome).toStdString());
  }
  EXPECT_EQ(words.size(), kOutcomes.size());
}

TEST(OutcomeWords, SayFaultsInWords) {
  for (const Fault fault : kFaults) {
    const QString words = OutcomeWords::of_fault(std::string(name_of(fault)));
    EXPECT_NE(words, name_of(fault));
    EXPECT_FALSE(words.contains('_')) << words.toStdString();
    EXPECT_EQ(words, OutcomeWords::of_fault(fault));
  }
  EXPECT_EQ(OutcomeWords::of_fault(std::string("of_tomorrow")), "of_tomorrow");
}

TEST(OutcomeWords, SayReasonsInTheLanguageOfTheWindows) {
  const StoredWords explored =
      stored(phrase_of(Reason::not_explored_as_asked).with(failed_measure("contact_s", 3)));
  EXPECT_EQ(OutcomeWords::of_reason(explored),
            "not explored as instructed: time in contact of surface 3");
  apply_language("de");
  EXPECT_EQ(OutcomeWords::of_reason(explored),
            "nicht wie angewiesen exploriert: Kontaktdauer bei Oberfläche 3");
  EXPECT_EQ(OutcomeWords::of_reason(StoredWords("aborted")), "aborted") << "as it was typed";
  EXPECT_EQ(OutcomeWords::of_reason(std::nullopt), "–");
  apply_language("en");
}

/// Everything that the studies of 0.1.0 store in words, as windows show it.
std::map<std::string, std::string> shown_of_earlier_studies() {
  std::map<std::string, std::string> shown{};
  const auto add = [&shown](const std::string& sentence, const QString& words) {
    shown[sentence] = words.toStdString();
  };
  const auto add_reason = [&add](const std::optional<StoredWords>& reason) {
    if (reason) add(reason->text, OutcomeWords::of_reason(reason));
  };
  const auto add_event = [&add](const EventRow& event) {
    const EventKind* const kind = event_kind(event.kind);
    ASSERT_NE(kind, nullptr) << event.kind;
    if (kind->text_is_words && !event.text.empty()) add(event.text, OutcomeWords::of_event(event));
  };
  const std::filesystem::path folder =
      std::filesystem::path(ASPERITY_SOURCE_DIR) / "tests/earlier_studies";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().filename() != "study.sqlite") continue;
    const Study study = Study::open(entry.path().parent_path(), Access::read_only);
    for (const SessionRow& session : study.sessions()) {
      for (const DecisionRow& decision : study.decisions(session.id)) add_reason(decision.reason);
      for (const EventRow& event : study.events(session.id)) add_event(event);
      for (const AttemptRow& attempt : study.attempts(session.id)) {
        // One that was repeated has the reason of that, which is among the decisions.
        if (attempt.invalid_reason &&
            !attempt.invalid_reason->text.starts_with("repeated by the experimenter: ")) {
          add_reason(attempt.invalid_reason);
        }
        add_reason(attempt.flag_reason);
        for (const EventRow& event : attempt.events) add_event(event);
      }
    }
  }
  return shown;
}

TEST(OutcomeWords, ShowWhatEarlierStudiesStoredInBothLanguages) {
  const std::string typed[] = {"hesitated for long", "interrupted by a fire alarm",
                               "was run to try things out", "looked away, 2 s", "Hörte kurz auf"};
  std::map<std::string, std::string> english{
      {"agreement seen by AB", "consent witnessed by AB"},
      {"as asked, after the trial", "on request, after the trial"},
      {"the emergency stop was pressed", "the emergency stop was pressed"},
      {"not explored as asked: normal_force_N of surface 1, normal_force_N of surface 2, "
       "normal_force_N of surface 3",
       "not explored as instructed: normal force of surface 1, normal force of surface 2, normal "
       "force of surface 3"},
      {"The participant was distracted", "The participant was distracted"},
      {"Die Versuchsperson war abgelenkt", "The participant was distracted"},
      {"Die Versuchsperson möchte aufhören", "The participant wishes to stop"},
      {"Safety of the participant", "Safety of the participant"},
      {"Sicherheit der Versuchsperson", "Safety of the participant"}};
  std::map<std::string, std::string> german{
      {"agreement seen by AB", "Einwilligung bezeugt von AB"},
      {"as asked, after the trial", "auf Wunsch, nach dem Durchgang"},
      {"the emergency stop was pressed", "der NOT-HALT wurde gedrückt"},
      {"not explored as asked: normal_force_N of surface 1, normal_force_N of surface 2, "
       "normal_force_N of surface 3",
       "nicht wie angewiesen exploriert: Normalkraft bei Oberfläche 1, Normalkraft bei Oberfläche "
       "2, Normalkraft bei Oberfläche 3"},
      {"The participant was distracted", "Die Versuchsperson war abgelenkt"},
      {"Die Versuchsperson war abgelenkt", "Die Versuchsperson war abgelenkt"},
      {"Die Versuchsperson möchte aufhören", "Die Versuchsperson möchte aufhören"},
      {"Safety of the participant", "Sicherheit der Versuchsperson"},
      {"Sicherheit der Versuchsperson", "Sicherheit der Versuchsperson"}};
  for (const std::string& words : typed) english[words] = german[words] = words;
  EXPECT_EQ(shown_of_earlier_studies(), english);
  apply_language("de");
  EXPECT_EQ(shown_of_earlier_studies(), german);
  apply_language("en");
}

}  // namespace
}  // namespace asperity
