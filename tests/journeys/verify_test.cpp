// verify and replay: a study says itself when it is no longer what was measured.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sqlite3.h>

#include "app/session/rig/recording_columns.h"
#include "results_schema/tables/table.h"
#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"

namespace asperity::test {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

class Verify : public testing::Test {
 protected:
  /// Simulated once; each test has a copy.
  static const SmallStudy& simulated() {
    static const SmallStudy made = simulated_study(1, 3, {"--recordings", "all"});
    return made;
  }

  Outcome verify(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"verify", study_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return asperity(arguments);
  }

  /// Names `word` after a byte in the middle has changed.
  void expect_found(const fs::path& file, const std::string& word) const {
    std::string content = text_of(file);
    content[content.size() / 2] = static_cast<char>(content[content.size() / 2] ^ 1);
    write_text(file, content);
    const Outcome outcome = verify();
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
  }

  fs::path database() const { return study_ / "study.sqlite"; }

  /// A digit of the file becomes another, past SQLite and every constraint; no page is broken by it.
  void change_a_number() const {
    std::string content = text_of(database());
    const std::size_t place = content.rfind("\"repetition\":1");
    if (place == std::string::npos) throw std::runtime_error("the plan has no repetition");
    content[place + 13] = '3';
    write_text(database(), content);
  }

  /// From the second page on, every page that is `word`'s becomes noise.
  void break_the_page_with(const std::string& word) const {
    constexpr std::size_t kPage = 4096;
    std::string content = text_of(database());
    const std::size_t place = content.find(word, kPage);
    if (place == std::string::npos) throw std::runtime_error("no page has " + word);
    std::fill_n(content.begin() + static_cast<std::ptrdiff_t>(place / kPage * kPage), kPage,
                '\x5a');
    write_text(database(), content);
  }

  /// What reads a study and gives numbers, each with what it writes.
  std::map<std::string, std::vector<std::string>> readers() const {
    return {{"analyze", {"analyze", study_, "--json"}},
            {"export", {"export", study_, "--out", small_.place() / "tables"}},
#ifdef ASPERITY_WITH_REPORT
            {"report", {"report", study_, "--out", small_.place() / "report.html"}},
#endif
            {"simulate", simulate_arguments(small_, study_, 1, 4)}};
  }

  fs::path first_recording() const {
    return study_ / "recordings/virtual0001/session-01/trial-0001_attempt-1.rec";
  }

  SmallStudy small_{simulated()};
  fs::path study_ = small_.study();
};

TEST_F(Verify, FindsEverythingAsItWasAndWritesNothing) {
  const auto before = contents_of(study_);
  const Outcome outcome = verify({"--replay"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(outcome.err.ends_with("verifying: 100 %\n")) << outcome.err;
  EXPECT_NE(outcome.out.find("bit for bit"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("4 recordings replayed\n"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("no problems found"), std::string::npos) << outcome.out;
  EXPECT_EQ(asperity({"analyze", study_}).status, 0);
  EXPECT_TRUE(contents_of(study_) == before);
}

TEST_F(Verify, StatesHowManyAttemptsHaveNoRecording) {
  std::vector<std::string> more = simulate_arguments(small_, study_, 1, 9);
  more.insert(more.end(), {"--recordings", "none"});
  ASSERT_EQ(asperity(more).status, 0);
  const Outcome outcome = verify({"--replay"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("4 recordings replayed; attempts without a recording, which cannot be "
                             "replayed: 4 (simulate keeps"),
            std::string::npos)
      << outcome.out;
}

TEST_F(Verify, FindsAChangedByteOfARecording) {
  expect_found(first_recording(), "trial-0001_attempt-1.rec");
  for (const Outcome& outcome : {verify(), verify({"--replay"})}) {
    EXPECT_NE(outcome.err.find("is damaged in chunk "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.out.find("1 problem found\n"), std::string::npos)
        << outcome.out << outcome.err;
  }
}

TEST_F(Verify, FindsAChangedByteOfAStimulus) {
  expect_found(study_ / "stimuli/walnut.png", "stimuli/walnut.png");
}

TEST_F(Verify, FindsAChangedByteOfEveryFileOfTheStudy) {
  std::uint64_t place = 7;  // another part of each file
  for (const auto& [name, content] : contents_of(study_)) {
    if (content.empty() || name.rfind("recordings/", 0) == 0) continue;  // locks; see above
    SCOPED_TRACE(name);
    place = place * 6364136223846793005U + 1442695040888963407U;
    std::string changed = content;
    changed[place % content.size()] ^= 4;
    write_text(study_ / name, changed);
    const Outcome outcome = verify();
    EXPECT_EQ(outcome.status, 1) << "byte " << place % content.size();
    EXPECT_GT(outcome.err.size(), 20U);
    write_text(study_ / name, content);
  }
  EXPECT_EQ(verify().status, 0);
}

TEST_F(Verify, WhoeverReadsAChangedStudyIsToldAndWhatTheyReadSaysSo) {
  for (const auto& [name, arguments] : readers()) {
    if (name != "simulate") {
      const std::string err = asperity(arguments).err;
      EXPECT_EQ(err.find("asperity verify"), std::string::npos) << name << err;
    }
  }
  fs::remove_all(small_.place() / "tables");
  fs::remove(small_.place() / "report.html");
  change_a_number();
  ASSERT_EQ(verify().status, 1);
  for (const auto& [name, arguments] : readers()) {
    const Outcome outcome = asperity(arguments);
    EXPECT_EQ(outcome.status, 0) << name << outcome.err;
    const std::size_t said = outcome.err.find("Run \"asperity verify\" to list the errors");
    EXPECT_NE(said, std::string::npos) << name << outcome.err;
    EXPECT_EQ(outcome.err.find("asperity verify", said + 6), std::string::npos) << name;  // once
    if (name == "analyze") {
      EXPECT_EQ(nlohmann::json::parse(outcome.out)
                    .at("outcomes")
                    .at(0)
                    .at("remarks")
                    .at(0)
                    .get<std::string>()
                    .find("The file study.sqlite has changed since"),
                0U)
          << outcome.out.substr(0, 400);
    }
  }
  EXPECT_NE(text_of(small_.place() / "tables/README.txt").find("asperity verify"),
            std::string::npos);
#ifdef ASPERITY_WITH_REPORT
  EXPECT_NE(text_of(small_.place() / "report.html").find("asperity verify"), std::string::npos);
#endif
  EXPECT_EQ(verify().status, 1);  // and whoever wrote did not vouch for it
}

// As one of a million attempts is; here it is a hole at the end.
TEST_F(Verify, WhoeverReadsAStudyTooLargeToLookAtIsToldToVerifyIt) {
  fs::resize_file(database(), (std::uintmax_t{1} << 30) + 4096);
  const Outcome outcome = asperity({"analyze", study_});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("its checksum was not compared. Run \"asperity verify\""),
            std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.out.find("larger than 1 GiB"), std::string::npos) << outcome.out;
}

TEST_F(Verify, NobodyGivesNumbersOfAStudyWithABrokenPage) {
  break_the_page_with("rendered_");
  // Also without the checksum, as a program leaves it that died.
  for (const bool sealed : {true, false}) {
    if (!sealed) fs::remove(study_ / "study.sqlite.sha256");
    const auto before = contents_of(study_);
    EXPECT_EQ(verify({"--replay"}).status, 1);
    for (const auto& [name, arguments] : readers()) {
      const Outcome outcome = asperity(arguments);
      EXPECT_EQ(outcome.status, 1) << name;
      EXPECT_EQ(outcome.signal, std::nullopt) << name;
      EXPECT_NE(outcome.err.find("\"asperity verify " + study_.string() + '"'), std::string::npos)
          << name << outcome.err;
    }
    EXPECT_FALSE(fs::exists(small_.place() / "tables"));
    EXPECT_FALSE(fs::exists(small_.place() / "report.html"));
    EXPECT_TRUE(contents_of(study_) == before);
  }
}

TEST_F(Verify, FindsAMissingRecording) {
  fs::remove(first_recording());
  const Outcome outcome = verify();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("trial-0001_attempt-1.rec"), std::string::npos) << outcome.err;
}

TEST_F(Verify, FindsAChangedByteOfAStoredProtocol) {
  // In the file itself, past SQLite and every constraint.
  std::string content = text_of(study_ / "study.sqlite");
  const std::size_t place = content.find("A small one");
  ASSERT_NE(place, std::string::npos);
  content[place + 2] = 'S';
  write_text(study_ / "study.sqlite", content);
  const Outcome outcome = verify();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("protocol"), std::string::npos) << outcome.err;
}

// Analyses read the columns, not the plan that stands beside them.
TEST_F(Verify, FindsAColumnThatIsNotAsThePlanHasIt) {
  const std::string before = text_of(database());
  const auto expect_found_after = [&](const std::string& sql, const std::string& words) {
    SCOPED_TRACE(sql);
    sqlite3* changed = nullptr;
    ASSERT_EQ(sqlite3_open(database().c_str(), &changed), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(changed, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
        << sqlite3_errmsg(changed);
    sqlite3_close(changed);
    const Outcome outcome = verify();
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    write_text(database(), before);
  };
  for (const char* change : {"block = 'other'", "block_ordinal = 7", "phase = 'practice'",
                             "repetition = 9", "factors_json = '{}'", "plan_json = '{}'"}) {
    expect_found_after(
        "DROP TRIGGER trial_no_update; UPDATE trial SET " + std::string(change) +
            " WHERE session_id = 1 AND trial = 2",
        "session 1 of participant virtual0001, trial 2: its stored plan differs from the one");
  }
  for (const char* change : {"item = 'other'", "model = 'other'", "texture = 'other'"}) {
    expect_found_after(
        "DROP TRIGGER presentation_no_update; UPDATE presentation SET " + std::string(change) +
            " WHERE attempt_id = 2 AND position = 1",
        "attempt virtual0001/1/2/1: its surfaces differ from those of the planned trial");
  }
  for (const char* options : {"[]", "{}", "[\"other\"]"}) {
    expect_found_after("DROP TRIGGER response_no_update; UPDATE response SET options_json = '" +
                           std::string(options) + "' WHERE attempt_id = 2",
                       "the options stored with the response "
                       "differ from those of the planned trial");
  }
  expect_found_after(
      "DROP TRIGGER session_only_changes_state; DROP TRIGGER session_completed_stays; UPDATE "
      "session SET seed = "
      "'99999999999999999999' WHERE id = 1",
      "its seed \"99999999999999999999\" is not a number from 0 to 2^64 - 1; restore the study "
      "from a copy");
  EXPECT_EQ(verify().status, 0);
}

// An older copy would bring back whom the study no longer contains.
TEST(VerifyAfterADeletion, AdvisesACopyThatWasMadeLater) {
  const SmallStudy small = simulated_study(2, 1, {"--recordings", "all"});
  const fs::path recording =
      small.study() / "recordings/virtual0001/session-01/trial-0001_attempt-1.rec";
  ASSERT_TRUE(fs::exists(recording));
  const std::string whole = text_of(recording);
  write_text(recording, whole.substr(1));
  const Outcome before = asperity({"verify", small.study()});
  EXPECT_EQ(before.status, 1);
  EXPECT_THAT(before.out, HasSubstr("Restore damaged data from a copy of the study, unless"));

  write_text(recording, whole);
  ASSERT_EQ(
      asperity({"withdraw", small.study(), "virtual0002", "--delete", "--confirm", "virtual0002"})
          .status,
      0);
  write_text(recording, whole.substr(1));
  const Outcome after = asperity({"verify", small.study()});
  EXPECT_EQ(after.status, 1);
  EXPECT_THAT(after.out,
              AllOf(ContainsRegex("Restore damaged data from a copy of the study that was made "
                                  "after [0-9-]+ [0-9:]+"),
                    HasSubstr("earlier copies contain data that participants have had deleted"),
                    Not(HasSubstr("from a copy of the study, unless"))));
}

TEST_F(Verify, FindsAnAnswerWhoseAttemptIsGone) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open((study_ / "study.sqlite").c_str(), &database), SQLITE_OK);
  // Only somebody who takes the locks off can do so at all.
  EXPECT_NE(sqlite3_exec(database, "DELETE FROM attempt WHERE id = 1", nullptr, nullptr, nullptr),
            SQLITE_OK);
  sqlite3_close(database);
  EXPECT_EQ(verify().status, 0);
}

TEST_F(Verify, ReplayReproducesTheRecordedForces) {
  std::size_t surfaces = 0;
  for (int surface = 1; surface <= 2; ++surface) {
    const fs::path out = small_.place() / ("replayed_" + std::to_string(surface) + ".tsv");
    const Outcome outcome = asperity({"replay", study_, "--attempt", "virtual0001/1/1/1",
                                      "--surface", std::to_string(surface), "--out", out});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const Tsv replayed = tsv(text_of(out));
    const std::vector<std::string> normal = replayed.column("fz_N");
    std::size_t row = 0;
    double largest_N = 0.0;
    for (const TickRecord& record : records_of(read_recording(first_recording()))) {
      if (record.presentation != static_cast<std::uint64_t>(surface) ||
          !record.has(TickFlag::presenting)) {
        continue;
      }
      ASSERT_LT(row, normal.size());
      const auto again = static_cast<float>(number_in(normal[row]).value());
      EXPECT_EQ(again, static_cast<float>(record.rendered.force_N.z)) << "row " << row;
      largest_N = std::max(largest_N, record.rendered.force_N.z);
      ++row;
    }
    EXPECT_EQ(row, normal.size());
    EXPECT_GT(largest_N, 0.1);  // it was touched
    ++surfaces;
  }
  EXPECT_EQ(surfaces, 2U);
}

TEST_F(Verify, ReplayPutsTheSameHandThroughAnotherModel) {
  const fs::path out = small_.place() / "other.tsv";
  ASSERT_EQ(asperity({"replay", study_, "--attempt", "1", "--model", "stochastic", "--param",
                      "noise_sd_N=0", "--out", out})
                .status,
            0);
  EXPECT_GT(tsv(text_of(out)).rows.size(), 100U);
  const auto refused = [&](const std::string& attempt, const std::string& word) {
    const Outcome outcome =
        asperity({"replay", study_, "--attempt", attempt, "--out", small_.place() / "none.tsv"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(small_.place() / "none.tsv"));
  };
  refused("99", "1 to 4");
  refused("virtual0001/9/1/1", "PARTICIPANT/SESSION/TRIAL/ATTEMPT");
  const auto refused_model = [&](const std::string& model) {
    const Outcome outcome = asperity({"replay", study_, "--attempt", "1", "--model", model, "--out",
                                      small_.place() / "none.tsv"});
    EXPECT_EQ(outcome.status, 1);
    return outcome.err;
  };
  EXPECT_THAT(refused_model("stochastik"), testing::HasSubstr("did you mean \"stochastic\"?"));
  EXPECT_THAT(refused_model("pd_gradient"),
              testing::AllOf(testing::HasSubstr("needs a tool and a surface as bodies"),
                             testing::HasSubstr("--model takes \"height_map\", ")));
}

}  // namespace
}  // namespace asperity::test
