// What is stored by a code, and what is made of it when it is shown.

#include "app/words/coded_phrases.h"

#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/words/device_remarks.h"
#include "app/words/offered_reasons.h"
#include "app/words/reason.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/made_up_study.h"

namespace asperity {
namespace {

/// Everything that can be translated is shouted.
std::string loud(const Phrase& phrase) {
  return phrase.translated([](const char* context, const char* words) {
    std::string upper = words;
    if (context == nullptr) return upper;  // of people: the same in every language
    for (char& c : upper) {
      if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    return upper;
  });
}

/// With something in each place.
Phrase with_arguments(const Phrase& phrase) {
  return phrase.with("1", phrase_of(Fault::device_lost), "typed %1; and so on");
}

TEST(CodedPhrases, HaveCodesOfTheirOwn) {
  const std::size_t lists = 2;
  EXPECT_EQ(coded_phrases().size(),
            coded_reasons().size() + coded_remarks().size() + coded_offers().size() + lists);
  for (const auto& [code, phrase] : coded_phrases()) {
    EXPECT_EQ(code.find_first_not_of("abcdefghijklmnopqrstuvwxyz_NWms"), std::string::npos) << code;
  }
}

// A reader of the file looks them up there.
TEST(CodedPhrases, AreDocumented) {
  const std::filesystem::path formats = std::filesystem::path(ASPERITY_SOURCE_DIR) / "docs/formats";
  const std::string documents =
      read_file(formats / "study.md") + read_file(formats / "device_profile.md");
  for (const auto& [code, phrase] : coded_phrases()) {
    EXPECT_NE(documents.find('`' + code + '`'), std::string::npos) << code;
  }
}

TEST(CodedPhrases, AreStoredWithoutTheirWords) {
  for (const auto& [code, phrase] : coded_phrases()) {
    if (!phrase.can_be_translated()) continue;  // a list
    const Phrase filled = with_arguments(phrase);
    const StoredWords words = stored(filled);
    EXPECT_EQ(loud(phrase_of(words)), loud(filled)) << code;
    const bool has_words = phrase.english().find(' ') != std::string::npos;
    EXPECT_FALSE(has_words && words.json.find(phrase.english()) != std::string::npos) << code;
  }
}

// The wording is of the day of the viewer; the sentence beside the codes is for other tools.
TEST(CodedPhrases, AreShownInTheWordsOfToday) {
  const StoredWords of_another_wording{"surface no. 2: no contact",
                                       R"({"code":"surface_not_touched","arguments":["2"]})"};
  EXPECT_EQ(phrase_of(of_another_wording).english(), "surface 2 was not touched");
  EXPECT_EQ(loud(phrase_of(of_another_wording)), "SURFACE 2 WAS NOT TOUCHED");
  EXPECT_EQ(codes_of(of_another_wording), "surface_not_touched");
}

TEST(CodedPhrases, StandInsideOthers) {
  const Phrase nested =
      with_semicolon(phrase_of(Reason::failed_between_trials)
                         .with(phrase_of(Reason::not_ready).with(phrase_of(Reason::does_not_tick))),
                     phrase_of(Reason::every_trial_stored));
  const StoredWords words = stored(nested);
  EXPECT_EQ(
      loud(phrase_of(words)),
      "A FAULT OCCURRED BETWEEN TRIALS: THE DEVICE IS NOT READY: ITS SERVO LOOP IS NOT RUNNING; "
      "EVERY COMPLETED TRIAL IS STORED; RESUME WITH --RESUME");
  EXPECT_EQ(codes_of(words), "device_failed_between_trials; finished_trials_stored");
}

TEST(CodedPhrases, AreListedInTheirOrder) {
  Phrase failures{};
  for (int surface = 1; surface <= 12; ++surface) {
    failures = with_comma(failures, failed_measure("speed_m_per_s", surface));
  }
  const Phrase flags = with_semicolon(phrase_of(Reason::force_limited).with("7"),
                                      phrase_of(Reason::not_explored_as_asked).with(failures));
  const StoredWords words = stored(flags);
  EXPECT_THAT(words.text,
              testing::StartsWith("ticks with limited force: 7; not explored as instructed: "
                                  "speed of surface 1, speed of surface 2, "));
  EXPECT_THAT(words.text, testing::EndsWith(", speed of surface 12"));
  EXPECT_EQ(phrase_of(words).english(), words.text);
  EXPECT_EQ(codes_of(words), "force_limited; exploration_not_compliant");
  const auto item = nlohmann::json::parse(words.json);
  EXPECT_EQ(item.at("arguments").size(), 2U);
  EXPECT_EQ(item.at("arguments").at(1).at("arguments").at(0).at("arguments").size(), 12U);
}

TEST(CodedPhrases, LeaveTheWordsOfPeopleAlone) {
  for (const char* typed : {"the fire alarm rang", "aborted", "as asked", "Technical problem",
                            "5 % of %1", "cold hands; aborted", "{\"code\":\"aborted\"}"}) {
    const StoredWords words = stored(Phrase(typed));
    EXPECT_EQ(words, StoredWords(typed));
    EXPECT_EQ(loud(phrase_of(words)), typed);
    EXPECT_EQ(codes_of(words), "typed");
    EXPECT_EQ(loud(phrase_of(set_aside_because(words))),
              std::string("REPEATED BY THE EXPERIMENTER: ") + typed);
  }
}

// The store has the English of the codes that it puts together by itself; other tools read it next to the codes.
TEST(CodedPhrases, OfTheStoreHaveTheSameWordsThere) {
  const StoredWords repeated = set_aside_because("a sneeze");
  EXPECT_EQ(phrase_of(repeated).english(), repeated.text);
  for (const WithdrawalReason reason : {WithdrawalReason::consent_withdrawn,
                                        WithdrawalReason::not_eligible, WithdrawalReason::other}) {
    MadeUpStudy made{};
    made.add_person("P1", "F");
    made.add_session("P1", made.add_protocol("sorting", "selection"), {});
    made.study().withdraw("P1", {.reason = reason, .decided_by = "R. Hook"});
    const StoredWords excluded = made.study().sessions().front().excluded.value();
    EXPECT_EQ(phrase_of(excluded).english(), excluded.text) << text_of(reason);
    EXPECT_TRUE(phrase_of(excluded).can_be_translated()) << text_of(reason);
  }
}

TEST(CodedPhrases, OfAnEventAreThoseOfItsKind) {
  const EventRow stopped = event_row(7, "session_stopped", phrase_of(Reason::as_asked));
  EXPECT_EQ(stopped.text, "on request");
  EXPECT_EQ(loud(phrase_of(stopped)), "ON REQUEST");
  const EventRow input = event_row(7, "input", "aborted");  // a name, not words
  EXPECT_TRUE(input.text_json.empty());
  EXPECT_EQ(loud(phrase_of(input)), "aborted");
  const EventRow failed =
      event_row(7, "session_failed", phrase("Troubles", "a phrase without code"));
  EXPECT_EQ(phrase_of(failed).english(), "a phrase without code");
  EXPECT_EQ(codes_of(failed.words()), "english");
}

TEST(CodedPhrases, TellThePublicNothingThatAnExperimenterChose) {
  const Phrase chosen = offered_reasons(ReasonFor::aborting).at(1);
  const StoredWords words =
      stored(with_semicolon(phrase_of(Reason::force_limited).with("7"), chosen));
  EXPECT_EQ(codes_of(words), "force_limited; participant_unwell");
  EXPECT_EQ(published_codes_of(words), "force_limited; typed");
}

TEST(CodedPhrases, OfALaterVersionAreShownByTheirCodes) {
  const StoredWords later{"x", R"({"code":"of_tomorrow","arguments":["3",{"code":"aborted"}]})"};
  EXPECT_EQ(phrase_of(later).english(), "of_tomorrow (3, aborted)");
  EXPECT_EQ(codes_of(later), "of_tomorrow");
}

TEST(CodedPhrases, OfADamagedRowAreItsText) {
  for (const char* json : {"{", "7", "null", R"({"code":7})", R"({"code":"list","arguments":7})"}) {
    if (std::string(json).find("list") == std::string::npos) {
      EXPECT_EQ(phrase_of(StoredWords{"as it was", json}).english(), "as it was") << json;
    }
    EXPECT_NO_THROW((void)phrase_of(StoredWords{"as it was", json}).english()) << json;
    EXPECT_NO_THROW((void)codes_of(StoredWords{"as it was", json})) << json;
    EXPECT_NO_THROW((void)joined(StoredWords{"as it was", json}, "more")) << json;
  }
}

TEST(Reasons, AllHaveWords) {
  for (int i = 0; i <= static_cast<int>(Reason::agreement_witnessed); ++i) {
    const Phrase words = phrase_of(static_cast<Reason>(i));
    EXPECT_TRUE(words.can_be_translated()) << i;
    EXPECT_NE(words.code(), nullptr) << i;
  }
}

TEST(Reasons, SayFaultsAndQuantitiesInWords) {
  for (const Fault fault : kFaults) {
    EXPECT_STREQ(phrase_of(fault).code(), name_of(fault));
    EXPECT_EQ(codes_of(stored(phrase_of(fault))), name_of(fault));
  }
  for (const char* quantity :
       {"normal_force_N", "speed_m_per_s", "contact_s", "strokes", "stroke_length_m"}) {
    const std::string words = loud(failed_measure(quantity, 2));
    EXPECT_EQ(words.find_first_of("abcdefghijklmnopqrstuvwxyz_"), std::string::npos) << words;
  }
}

TEST(OfferedReasons, AreThereForEverythingThatNeedsOne) {
  for (int i = 0; i <= static_cast<int>(ReasonFor::noting); ++i) {
    EXPECT_GE(offered_reasons(static_cast<ReasonFor>(i)).size(), 2U) << i;
  }
}

}  // namespace
}  // namespace asperity
