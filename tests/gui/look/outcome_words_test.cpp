// One table of words for outcomes, wherever they are shown.

#include "app/gui/look/outcome_words.h"

#include <array>
#include <optional>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "app/gui/base/settings.h"
#include "app/words/coded_phrases.h"
#include "app/words/reason.h"
#include "results_schema/rows.h"

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

// A point of a line from -100 to 100 is computed: 25.8 is stored as 25.799999999999997.
TEST(OutcomeWords, ShowResponsesWithoutRoundingErrors) {
  EXPECT_EQ(OutcomeWords::of_response("25.799999999999997"), "25.8");
  EXPECT_EQ(OutcomeWords::of_response("-8.400000000000006"), "−8.4");
  EXPECT_EQ(OutcomeWords::of_response("0.16666666666666666 (weak)"), "0.166667 (weak)");
  EXPECT_EQ(OutcomeWords::of_response("1234567"), "1234567") << "as it was entered";
  EXPECT_EQ(OutcomeWords::of_response("007"), "007") << "a name";
  EXPECT_EQ(OutcomeWords::of_response("brick"), "brick");
  EXPECT_EQ(OutcomeWords::of_response(""), "");
  apply_language("de");
  EXPECT_EQ(OutcomeWords::of_response("59.80000000000001"), "59,8");
  apply_language("en");
}

TEST(OutcomeWords, NumberTheResponsesOfSeveralItems) {
  ResponseRow brick{};
  brick.item = 1;
  brick.answer = "brick";
  ResponseRow wood = brick;
  wood.item = 2;
  wood.answer = "59.80000000000001";
  EXPECT_EQ(OutcomeWords::of_responses({brick}), "brick");
  EXPECT_EQ(OutcomeWords::of_responses({brick, wood}), "1 brick, 2 59.8");
  EXPECT_EQ(OutcomeWords::of_responses({}), "");
}

}  // namespace
}  // namespace asperity
