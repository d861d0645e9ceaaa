// Reasons as codes: stored, read and put together.

#include "results_schema/stored_words.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/results_schema/rows_for_tests.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

const StoredWords kLimited{"force limited in 7 ticks",
                           R"({"code":"force_limited","arguments":["7"]})"};

/// A study with one attempt that is open.
struct OneSession {
  TemporaryFolder folder{};
  Study study = Study::create(folder / "s", "s");
  std::int64_t id = 0;
  OneSession() {
    study.add_participant(some_participant("P01"));
    id = study.add_session(some_session(study.add_protocol(some_protocol())), some_plan(2));
    study.begin_segment(id, 0);
  }
};

TEST(StoredWords, ThatWereTypedAreAString) {
  EXPECT_EQ(StoredWords("a \"cough\"").json, R"("a \"cough\"")");
  EXPECT_NO_THROW(StoredWords("\xff"));
}

/// As events without codes have them.
TEST(StoredWords, WithoutACodeAreTheirText) {
  const StoredWords plain{"iti", ""};
  EXPECT_EQ(plain.item(), nlohmann::ordered_json("iti"));
  EXPECT_EQ(joined(joined(plain, "a cough"), kLimited).json,
            R"({"code":"list","arguments":["iti","a cough",)" + kLimited.json + "]}");
  EXPECT_EQ(joined(std::nullopt, plain), plain);
}

TEST(StoredWords, AreReadAsTheyWereStored) {
  OneSession session;
  AttemptRow attempt = some_attempt(1);
  attempt.flagged = true;
  attempt.flag_reason = kLimited;
  EventRow stopped{.kind = "session_stopped", .text = "as asked"};
  stopped.text_json = R"({"code":"stop_requested"})";
  attempt.events.push_back(stopped);
  session.study.add_attempt(session.id, attempt);
  session.study.add_event(session.id, stopped);
  session.study.add_event(session.id, {.kind = "phase", .text = "iti"});
  session.study.add_decision(session.id, {.reason = "fell asleep"});
  const AttemptRow read = session.study.attempts(session.id).at(0);
  EXPECT_EQ(read.flag_reason, kLimited);
  EXPECT_EQ(read.invalid_reason, std::nullopt);
  EXPECT_EQ(read.events.back().text_json, stopped.text_json);
  EXPECT_EQ(session.study.events(session.id).at(0).text_json, stopped.text_json);
  EXPECT_EQ(session.study.events(session.id).at(1).text_json, "");
  EXPECT_EQ(session.study.decisions(session.id).at(0).reason, StoredWords("fell asleep"));
  EXPECT_EQ(session.study.session(session.id).excluded, StoredWords("fell asleep"));
}

TEST(StoredWords, ArePutTogetherByTheirCodes) {
  OneSession session;
  AttemptRow attempt = some_attempt(1);
  attempt.flagged = true;
  attempt.flag_reason = kLimited;
  session.study.add_attempt(session.id, attempt);
  session.study.add_decision(
      session.id, {.trial = 1, .attempt = 1, .verdict = Verdict::flag, .reason = "a cough"});
  session.study.set_aside(session.id, 1, 1, "a sneeze");
  const AttemptRow read = session.study.attempts(session.id).at(0);
  EXPECT_EQ(read.flag_reason->text, "force limited in 7 ticks; a cough");
  EXPECT_EQ(
      read.flag_reason->json,
      R"({"code":"list","arguments":[{"code":"force_limited","arguments":["7"]},"a cough"]})");
  EXPECT_EQ(read.invalid_reason->text, "repeated by the experimenter: a sneeze");
  EXPECT_EQ(read.invalid_reason->json, R"({"code":"trial_repeated","arguments":["a sneeze"]})");
}

}  // namespace
}  // namespace asperity
