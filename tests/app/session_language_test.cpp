// The language of sessions: translations next to a protocol, and what a participant keeps.

#include "app/tasks/session_language.h"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/study_files/protocol_languages.h"
#include "app/study_files/study_protocols.h"
#include "app/tasks/check_protocol.h"
#include "app/tasks/protocol_files.h"
#include "app/tasks/run_session.h"
#include "app/tasks/study_overview.h"
#include "app/tasks/warnings/session_warnings.h"
#include "app/words/phrase_of_error.h"
#include "protocols/file/stored_protocol.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/scripted_session.h"
#include "tests/support/marked_translation.h"
#include "tests/support/refusal.h"
#include "tests/support/replaced.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class SessionLanguage : public testing::Test {
 protected:
  SessionLanguage() {
    make_small_study(study_folder_);
    std::string text = small_protocol();
    text.replace(text.find("[1, 2, 3]"), 9, "[1]");
    text.insert(text.find("\"textures\""), R"("participants": {"sessions": 3}, )");
    write_file(file_, text, Overwrite::refuse);
    write_file(german_, marked_translation(text, "DE"), Overwrite::refuse);
  }

  Study study() const { return Study::open(study_folder_, Access::read_only); }
  std::filesystem::path file_for(const std::string& participant,
                                 const std::optional<std::string>& stated = {},
                                 std::optional<SessionMode> mode = SessionMode::pilot) const {
    return protocol_for_participant(study(), file_, participant, mode, stated);
  }
  SessionEnd run(const std::string& participant, const std::filesystem::path& file) {
    const RunInputs inputs{.protocol = file,
                           .study = study_folder_,
                           .participant = participant,
                           .seed = 5,
                           .mode = SessionMode::pilot,
                           .pacing = RunPacing::stepped};
    SessionRequests requests{};
    ScriptedPerson person{};
    return run_session(inputs, models_, &person, {}, {}, {.requests = &requests});
  }
  std::string stored_text(std::size_t session) const {
    return study().protocol(study().sessions().at(session).protocol_id).source;
  }

  TemporaryFolder folder_{};
  std::filesystem::path study_folder_ = folder_.path() / "study";
  std::filesystem::path file_ = study_folder_ / "protocols" / "small.json";
  std::filesystem::path german_ = study_folder_ / "protocols" / "small.de.json";
  ModelRegistry models_ = built_in_models();
};

TEST_F(SessionLanguage, IsStatedOrThatOfTheEarlierSessionsOrOfTheProtocol) {
  EXPECT_EQ(file_for("p1"), file_);
  EXPECT_EQ(file_for("p1", "de"), german_);
  EXPECT_EQ(file_for("p1", "en"), file_);
  ASSERT_EQ(run("p1", german_).state, SessionState::completed);
  EXPECT_EQ(file_for("p1"), german_);
  EXPECT_EQ(file_for("p1", {}, SessionMode::run), file_) << "of a pilot only";
  EXPECT_EQ(file_for("p2"), file_);
  EXPECT_THAT(refusal_of<PhrasedError>([this] { run("p1", file_); }),
              HasSubstr("were in the language \"de\" and this one would be in \"en\"; all sessions "
                        "of a participant are in one language: choose \"de\""));
  EXPECT_EQ(study().sessions().size(), 1U);
  EXPECT_EQ(run("p1", german_).state, SessionState::completed);
  EXPECT_EQ(run("p2", file_).state, SessionState::completed);
  EXPECT_THAT(refusal_of<std::invalid_argument>([this] { file_for("p1", "fr"); }),
              HasSubstr("is not available in the language \"fr\"; choose \"en\" or \"de\""));
}

TEST_F(SessionLanguage, OfAResumedSessionIsThatOfTheUnfinishedOne) {
  ASSERT_EQ(run("p1", file_).state, SessionState::completed);
  EXPECT_EQ(file_for("p1", {}, std::nullopt), file_);
  {
    Study opened = Study::open(study_folder_, Access::read_write);
    const Protocol german = load_protocol(german_, models_, study_folder_);
    const OpenSession session = begin_session(opened, german, "p1",
                                              {.mode = SessionMode::run,
                                               .seed = 5,
                                               .pacing = "real_time",
                                               .scheduling = "none",
                                               .started_utc = "2026-01-01T00:00:00.000Z",
                                               .clock_zero_ns = 1},
                                              this_program());
    opened.end_session(session.row.id, SessionState::stopped, "2026-01-01T00:10:00.000Z");
  }
  EXPECT_EQ(file_for("p1", {}, std::nullopt), german_) << "in any mode";
  EXPECT_EQ(file_for("p1"), file_) << "in its own mode";
}

TEST_F(SessionLanguage, IsStoredWithTheTextsThatTheParticipantRead) {
  ASSERT_EQ(run("p1", german_).state, SessionState::completed);
  ASSERT_EQ(run("p2", file_).state, SessionState::completed);
  const nlohmann::json stored = nlohmann::json::parse(stored_text(0));
  EXPECT_EQ(stored["language"], "de");
  EXPECT_EQ(stored["flow"][0]["screen"], "DE Welcome.");
  EXPECT_EQ(stored["name"], "small");
  EXPECT_EQ(without_texts(stored_text(0)), without_texts(stored_text(1)));
  EXPECT_EQ(stored_text(1), read_file(file_)) << "its own language: byte for byte";
  EXPECT_EQ(session_overviews(study(), {})[0].protocol_file, german_);
}

TEST_F(SessionLanguage, IsNotAnotherTextButAChangedTranslationIs) {
  ASSERT_EQ(run("p1", german_).state, SessionState::completed);
  const auto use_of = [this](const std::filesystem::path& file) {
    return other_text_of_version(study(), protocol_source(file).text);
  };
  EXPECT_FALSE(use_of(file_));
  EXPECT_FALSE(use_of(german_));
  write_file(german_, marked_translation(read_file(file_), "Deutsch"), Overwrite::allow);
  ASSERT_TRUE(use_of(german_));
  EXPECT_EQ(use_of(german_)->sessions, 1);
  EXPECT_FALSE(use_of(file_));
}

TEST_F(SessionLanguage, IsNoProtocolOfItsOwn) {
  EXPECT_THAT(protocol_files(study_folder_), ElementsAre(file_));
  const std::vector<ProtocolInLanguage> languages = languages_of_protocol(german_);
  ASSERT_EQ(languages.size(), 2U);
  EXPECT_EQ(languages[0].language, "en");
  EXPECT_EQ(languages[0].file, file_);
  EXPECT_EQ(languages[1].language, "de");
  EXPECT_EQ(languages[1].file, german_);
  const std::filesystem::path other = study_folder_ / "protocols" / "other.v2.json";
  write_file(other, read_file(file_), Overwrite::refuse);
  EXPECT_THAT(protocol_files(study_folder_), ElementsAre(other, file_)) << "not a translation";
}

TEST_F(SessionLanguage, IsThatOfAFileWithAnyMistakeNextToItsProtocol) {
  const std::string whole = read_file(german_);
  for (const std::string& broken :
       {whole.substr(0, whole.size() / 2), std::string("\xff"),
        R"({"format": "asperity.translatoin/1", "texts": {}})" + std::string()}) {
    write_file(german_, broken, Overwrite::allow);
    EXPECT_THAT(protocol_files(study_folder_), ElementsAre(file_)) << broken;
    EXPECT_EQ(protocol_in_language(file_, "de"), german_);
    try {
      protocol_source(german_);
      ADD_FAILURE() << broken;
    } catch (const ProtocolError& error) {
      EXPECT_EQ(error.diagnostics().front().file, german_.string());
    }
  }
  write_file(german_, small_protocol(), Overwrite::allow);
  EXPECT_THAT(protocol_files(study_folder_), testing::UnorderedElementsAre(file_, german_))
      << "a protocol of its own";
  const std::filesystem::path upper = german_.parent_path() / (file_.stem().string() + ".DE.json");
  write_file(upper, whole, Overwrite::refuse);
  EXPECT_THAT(refusal_of<ProtocolError>([&] { protocol_source(upper); }),
              HasSubstr("is not a language"));
}

TEST_F(SessionLanguage, CannotBeThatOfATranslationWithAProblem) {
  std::string text = read_file(german_);
  text.replace(text.find("/flow/screen"), 12, "/flow/scream");
  write_file(german_, text, Overwrite::allow);
  EXPECT_THROW(run("p1", german_), ProtocolError);
  const ProtocolCheck own = check_protocol(file_, models_, study_folder_, {});
  EXPECT_TRUE(own.is_valid());
  ASSERT_EQ(own.warnings.size(), 1U);
  EXPECT_THAT(own.warnings[0].message.english(),
              HasSubstr("no session can run in the language \"de\": "
                        "small.de.json has 3 problems"));
  const ProtocolCheck translation = check_protocol(german_, models_, study_folder_, {});
  EXPECT_FALSE(translation.is_valid());
  ASSERT_EQ(translation.diagnostics.size(), 3U);
  for (const Diagnostic& problem : translation.diagnostics) {
    EXPECT_EQ(problem.file, german_.string());
    EXPECT_GT(problem.line, 1);
  }
  EXPECT_EQ(check_protocol("small", models_, study_folder_, {}).file, file_.string());
}

TEST_F(SessionLanguage, IsExaminedWithTheTranslatedTexts) {
  const std::string whole = read_file(german_);
  const auto warnings_with = [&](const std::string& text) {
    write_file(german_, replaced(whole, "DE Welcome.", text), Overwrite::allow);
    const ProtocolCheck check = check_protocol(file_, models_, study_folder_, {});
    EXPECT_TRUE(check.is_valid());
    std::vector<std::string> messages{};
    for (const Diagnostic& warning : check.warnings) messages.push_back(warning.message.english());
    return messages;
  };
  EXPECT_THAT(warnings_with("Willkommen."), IsEmpty());
  EXPECT_THAT(
      warnings_with("{trails} Durchgänge"),
      ElementsAre(testing::AllOf(HasSubstr("no session can run in the language \"de\": with "
                                           "small.de.json the protocol has a problem"),
                                 HasSubstr("did you mean \"trials\"?"))));
  EXPECT_THAT(warnings_with("Sie fühlen fünf Oberflächen."),
              ElementsAre(HasSubstr("small.de.json: the text states \"fünf Oberflächen\"")));
}

TEST_F(SessionLanguage, NeedsTheProtocolInAnotherLanguage) {
  const std::filesystem::path english = study_folder_ / "protocols" / "small.en.json";
  std::filesystem::rename(german_, english);
  EXPECT_THAT(refusal_of<ProtocolError>([&] { protocol_source(english); }),
              HasSubstr("is in the language \"en\" itself"));
  std::filesystem::remove(file_);
  EXPECT_THAT(refusal_of<ProtocolError>([&] { protocol_source(english); }),
              HasSubstr("belongs to the protocol small.json, which is not in the same folder"));
}

TEST_F(SessionLanguage, FollowsTheProtocolThatIsCopiedRenamedOrDeleted) {
  const auto is_there = [this](const std::string& name) {
    return std::filesystem::exists(study_folder_ / "protocols" / name);
  };
  const std::filesystem::path copy = duplicate_protocol(study(), file_);
  EXPECT_TRUE(is_there("small_2.de.json"));
  EXPECT_EQ(protocol_source(protocol_in_language(copy, "de")).file, copy);
  const std::filesystem::path renamed = rename_protocol(study(), copy, "felt");
  EXPECT_FALSE(is_there("small_2.de.json"));
  EXPECT_TRUE(is_there("felt.de.json"));
  const std::filesystem::path other = study_folder_ / "protocols" / "other.de.json";
  write_file(other, "theirs", Overwrite::refuse);
  EXPECT_THROW(rename_protocol(study(), renamed, "other"), PhrasedError);
  EXPECT_EQ(read_file(other, kProtocolFile), "theirs");
  EXPECT_TRUE(is_there("felt.json"));
  EXPECT_FALSE(is_there("other.json"));
  delete_protocol(study(), renamed);
  EXPECT_FALSE(is_there("felt.de.json"));
  EXPECT_TRUE(is_there("small.de.json"));
}

}  // namespace
}  // namespace asperity
