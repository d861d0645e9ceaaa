// Sentences that earlier versions stored.

#include "app/words/earlier_wordings.h"

#include <string>

#include <gtest/gtest.h>

#include "app/words/coded_phrases.h"

namespace asperity {
namespace {

/// The codes of what it meant: "device_failed_in_trial(3, device_lost)".
std::string meaning(const Phrase& phrase) {
  if (phrase.code() == nullptr) return phrase.english();
  std::string told = phrase.code();
  for (std::size_t i = 0; i < phrase.arguments().size(); ++i) {
    told += (i == 0 ? "(" : ", ") + meaning(phrase.arguments()[i]);
  }
  return told + (phrase.arguments().empty() ? "" : ")");
}

std::string meaning_of(const std::string& sentence) { return meaning(phrase_of_earlier(sentence)); }

TEST(EarlierWordings, AreFoundAgain) {
  EXPECT_EQ(meaning_of("as asked"), "stop_requested");
  EXPECT_EQ(meaning_of("as asked, after the trial"), "stop_requested_after_trial");
  EXPECT_EQ(meaning_of("surface 2 was not touched"), "surface_not_touched(2)");
  EXPECT_EQ(meaning_of("3 missed deadlines, at most 0 allowed"), "deadlines_missed(3, 0)");
  EXPECT_EQ(meaning_of("standstill"), "standstill");
  EXPECT_EQ(meaning_of("agreement seen by AB"), "agreement_witnessed(AB)");
  EXPECT_EQ(meaning_of("the criterion of the block \"aborted\" was not met"),
            "criterion_not_met(aborted)");
}

TEST(EarlierWordings, StandInsideOthers) {
  EXPECT_EQ(meaning_of("trial 2 failed 3 times in a row (5 lost records, at most 0 allowed)"),
            "trial_failed_repeatedly(2, 3, records_lost(5, 0))");
  EXPECT_EQ(meaning_of("the device failed in trial 3: device_lost"),
            "device_failed_in_trial(3, device_lost)");
  EXPECT_EQ(meaning_of("the device failed between trials: it rang"),
            "device_failed_between_trials(it rang)");
  EXPECT_EQ(
      meaning_of("the device failed between trials: the device is not ready: it does not tick; "
                 "every finished trial is stored, go on with --resume"),
      "list(device_failed_between_trials(device_not_ready(device_does_not_tick)), "
      "finished_trials_stored)");
}

TEST(EarlierWordings, AreSeveralOfOneAttempt) {
  EXPECT_EQ(meaning_of("force limited in 7 ticks; not explored as asked: speed_m_per_s of surface "
                       "1, contact_s of surface 3"),
            "list(force_limited(7), exploration_not_compliant(comma_list("
            "quantity_of_surface(speed_m_per_s, 1), quantity_of_surface(contact_s, 3))))");
  EXPECT_EQ(codes_of({"force limited in 7 ticks; aborted", ""}), "force_limited; aborted");
}

// Their codes have other words since version 0.2.0.
TEST(EarlierWordings, AreFoundThoughTheirCodesWereReworded) {
  EXPECT_EQ(meaning_of("Somebody came in"), "person_came_in");
  EXPECT_EQ(meaning_of("The participant does not want to go on"), "participant_declines");
  EXPECT_EQ(meaning_of("The participant asks for it"), "participant_asked");
  EXPECT_EQ(meaning_of("agreement seen by AB"), "agreement_witnessed(AB)");
  EXPECT_EQ(phrase_of_earlier("Jemand kam herein").english(), "A person entered the room");
  EXPECT_EQ(phrase_of_earlier("every finished trial is stored, go on with --resume").english(),
            "every completed trial is stored; resume with --resume");
  const Phrase ran_away =
      remark_of_earlier("the handle ran farther than 30 mm away, and the force was let go of");
  EXPECT_EQ(meaning(ran_away), "device_test_handle_ran_away(30)");
  EXPECT_EQ(ran_away.english(),
            "the handle moved away by more than 30 mm, and the force was switched off");
}

// The windows of then stored what was chosen in their own language.
TEST(EarlierWordings, AreOfBothLanguagesWhereAWindowOfferedThem) {
  EXPECT_EQ(meaning_of("The participant was distracted"), "participant_distracted");
  EXPECT_EQ(meaning_of("Die Versuchsperson war abgelenkt"), "participant_distracted");
  EXPECT_EQ(meaning_of("Technisches Problem"), "technical_problem");
  EXPECT_EQ(meaning_of("Hatte Frage"), "note_question");
}

TEST(EarlierWordings, LeaveTheWordsOfPeopleAlone) {
  for (const char* typed : {"the fire alarm rang", "the hand slid off of surface 2", "",
                            "cold hands; the fire alarm rang", "cold hands; aborted", "Standstill",
                            "along x nothing"}) {
    EXPECT_EQ(meaning_of(typed), typed);
  }
}

TEST(EarlierWordings, OfDevicesAreThoseOfTheirItems) {
  EXPECT_EQ(meaning(remark_of_earlier(
                "Not measured: along x the handle did not move; along z the servo loop took the "
                "force away (the device does not answer).")),
            "device_test_not_measured(list(device_test_along_axis(x, device_test_did_not_move), "
            "device_test_along_axis(z, device_test_force_removed(device_lost))))");
  EXPECT_EQ(meaning(remark_of_earlier("aborted")), "aborted");
  EXPECT_EQ(remark_of_earlier("aborted").code(), nullptr) << "a reason, and none of a device";
}

}  // namespace
}  // namespace asperity
