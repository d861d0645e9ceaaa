// Reasons, as they are stored and as they are said.

#include "app/conductor/reason.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

/// Everything that can be translated is shouted.
std::string loud(const std::string& stored) {
  return read_reason(stored).translated([](const char* context, const char* words) {
    std::string upper = words;
    if (context == nullptr) return upper;  // of people: the same in every language
    for (char& c : upper) {
      if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    return upper;
  });
}

TEST(Reasons, AreFoundInTheStoreAgain) {
  EXPECT_EQ(loud("as asked"), "AS ASKED");
  EXPECT_EQ(loud("as asked, after the trial"), "AS ASKED, AFTER THE TRIAL");
  EXPECT_EQ(loud("surface 2 was not touched"), "SURFACE 2 WAS NOT TOUCHED");
  EXPECT_EQ(loud("3 missed deadlines, at most 0 allowed"), "3 MISSED DEADLINES, AT MOST 0 ALLOWED");
  for (const char* stored :
       {"as asked", "force limited in 7 ticks", "the masking noise stopped",
        "the device failed between trials: it rang",
        "trial 2 failed 3 times in a row (5 lost records, at most 0 allowed)"}) {
    EXPECT_EQ(read_reason(stored).english(), stored);
  }
}

TEST(Reasons, StandInsideOthers) {
  EXPECT_EQ(loud("trial 2 failed 3 times in a row (surface 1 was not touched)"),
            "TRIAL 2 FAILED 3 TIMES IN A ROW (SURFACE 1 WAS NOT TOUCHED)");
  EXPECT_EQ(loud("the device failed between trials: the device is not ready: it does not tick; "
                 "every finished trial is stored, go on with --resume"),
            "THE DEVICE FAILED BETWEEN TRIALS: THE DEVICE IS NOT READY: IT DOES NOT TICK; "
            "EVERY FINISHED TRIAL IS STORED, GO ON WITH --RESUME");
}

TEST(Reasons, AreSeveralOfOneAttempt) {
  EXPECT_EQ(loud("force limited in 7 ticks; not explored as asked: speed_m_per_s of surface 1, "
                 "contact_s of surface 3"),
            "FORCE LIMITED IN 7 TICKS; NOT EXPLORED AS ASKED: SPEED OF SURFACE 1, "
            "TIME IN CONTACT OF SURFACE 3");
}

TEST(Reasons, SayFaultsAndQuantitiesInWords) {
  for (const Fault fault : kFaults) {
    const Phrase words = phrase_of(fault);
    EXPECT_TRUE(words.can_be_translated());
    EXPECT_EQ(read_reason(name_of(fault)).english(), words.english());
    EXPECT_EQ(read_reason(phrase_of(Reason::failed_in_trial).with("3", name_of(fault)).english())
                  .english(),
              "the device failed in trial 3: " + words.english());
  }
  for (const char* quantity :
       {"normal_force_N", "speed_m_per_s", "contact_s", "strokes", "stroke_length_m"}) {
    const std::string stored =
        phrase_of(Reason::not_explored_as_asked).with(failed_measure(quantity, 2)).english();
    EXPECT_EQ(stored, std::string("not explored as asked: ") + quantity + " of surface 2");
    EXPECT_EQ(loud(stored).find_first_of("abcdefghijklmnopqrstuvwxyz_"), std::string::npos);
  }
}

TEST(Reasons, LeaveTheWordsOfPeopleAlone) {
  EXPECT_EQ(loud("the fire alarm rang"), "the fire alarm rang");
  EXPECT_EQ(loud("the hand slid off of surface 2"), "the hand slid off of surface 2");
  EXPECT_EQ(loud("set aside: aborted"), "SET ASIDE: aborted");
  EXPECT_EQ(loud(""), "");
  EXPECT_EQ(loud("cold hands; the fire alarm rang"), "cold hands; the fire alarm rang");
}

TEST(Reasons, AllHaveWords) {
  for (int i = 0; i <= static_cast<int>(Reason::sends_force); ++i) {
    const Phrase words = phrase_of(static_cast<Reason>(i));
    EXPECT_TRUE(words.can_be_translated()) << i;
  }
}

}  // namespace
}  // namespace asperity
