// One table of words for outcomes, wherever they are shown.

#include "app/gui/look/outcome_words.h"

#include <array>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "app/gui/study/settings.h"

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

TEST(OutcomeWords, SayFaultsInWordsAndLeaveOtherReasonsAlone) {
  for (const Fault fault : kFaults) {
    const QString words = OutcomeWords::of_reason(name_of(fault));
    EXPECT_NE(words, name_of(fault));
    EXPECT_FALSE(words.contains('_')) << words.toStdString();
    EXPECT_EQ(words, OutcomeWords::of_fault(fault));
  }
  EXPECT_EQ(OutcomeWords::of_reason("3 missed deadlines, at most 0 are allowed"),
            "3 missed deadlines, at most 0 are allowed");
}

TEST(OutcomeWords, SayReasonsInTheLanguageOfTheWindows) {
  apply_language("de");
  for (const char* stored :
       {"as asked, after the block", "surface 2 was not touched",
        "3 missed deadlines, at most 0 allowed",
        "force limited in 12 ticks; not explored as asked: speed_m_per_s of surface 1",
        "trial 4 failed 3 times in a row (surface 1 was not touched)",
        "the device failed in trial 4: device_lost"}) {
    const QString words = OutcomeWords::of_reason(stored);
    for (const char* english : {"asked", "surface", "missed", "force", "trial", "device"}) {
      EXPECT_FALSE(words.contains(english)) << words.toStdString();
    }
  }
  EXPECT_EQ(OutcomeWords::of_reason("not explored as asked: contact_s of surface 3"),
            "nicht wie verlangt erkundet: Kontaktdauer bei Oberfläche 3");
  EXPECT_EQ(OutcomeWords::of_reason("the fire alarm rang"), "the fire alarm rang");
  apply_language("en");
}

}  // namespace
}  // namespace asperity
