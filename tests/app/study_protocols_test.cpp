// Tests that protocol files are copied, renamed and deleted, unless a session has run them.

#include "app/study_files/study_protocols.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/session_setup.h"
#include "app/study_files/program.h"
#include "app/words/phrase_of_error.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"
#include "tests/app/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::HasSubstr;

class StudyProtocols : public testing::Test {
 protected:
  StudyProtocols() {
    make_small_study(folder_.path() / "study");
    write_file(file_, small_protocol(), Overwrite::refuse);
  }
  std::filesystem::path beside(const char* name) const { return file_.parent_path() / name; }
  Study study() const { return Study::open(folder_.path() / "study", Access::read_only); }
  void run_it() {
    Study own = Study::open(folder_.path() / "study", Access::read_write);
    own.add_participant({.label = "p1", .created_utc = "2026-01-01T00:00:00.000Z"});
    SessionConditions conditions{};
    conditions.seed = 7;
    conditions.pacing = "stepped";
    conditions.started_utc = "2026-01-01T00:00:00.000Z";
    begin_session(own, read_small_protocol(built_in_models(), read_file(file_)), "p1", conditions,
                  this_program());
  }

  TemporaryFolder folder_{};
  std::filesystem::path file_ = folder_.path() / "study" / "protocols" / "small.json";
};

TEST_F(StudyProtocols, AreDuplicatedUnderTheNextFreeName) {
  EXPECT_EQ(duplicate_protocol(study(), file_), beside("small_2.json"));
  EXPECT_EQ(duplicate_protocol(study(), beside("small_2.json")), beside("small_3.json"));
  std::string expected = small_protocol();
  expected.replace(expected.find("\"small\""), 7, "\"small_3\"");
  EXPECT_EQ(read_file(beside("small_3.json")), expected) << "nothing but the name is another";
  EXPECT_EQ(read_file(file_), small_protocol());
}

TEST_F(StudyProtocols, AreRenamedInTheTextAndAsAFile) {
  EXPECT_EQ(rename_protocol(study(), file_, "mine"), beside("mine.json"));
  EXPECT_FALSE(std::filesystem::exists(file_));
  EXPECT_EQ(protocol_name(read_file(beside("mine.json"))), "mine");
  EXPECT_EQ(with_protocol_name(read_file(beside("mine.json")), "small"), small_protocol());
}

TEST_F(StudyProtocols, GetNoNameThatNoProtocolMayHaveOrThatAnotherHas) {
  write_file(beside("other.json"), "{}", Overwrite::refuse);
  for (const char* const name : {"", "Mine", "1st", "a-b", "../mine", "other"}) {
    EXPECT_THROW(rename_protocol(study(), file_, name), PhrasedError) << name;
  }
  write_file(beside("small.de.json"), R"({"format": "asperity.translation/1", "texts": {}})",
             Overwrite::refuse);
  write_file(beside("free.de.json"), "somebody's", Overwrite::refuse);
  EXPECT_THROW(rename_protocol(study(), file_, "free"), PhrasedError) << "its translation";
  EXPECT_EQ(read_file(beside("free.de.json")), "somebody's");
  EXPECT_EQ(read_file(file_), small_protocol());
  EXPECT_EQ(rename_protocol(study(), file_, "small"), file_);
}

TEST_F(StudyProtocols, AreDeletedUnlessTheyWereRun) {
  delete_protocol(study(), file_);
  EXPECT_FALSE(std::filesystem::exists(file_));
  write_file(file_, small_protocol(), Overwrite::refuse);
  run_it();
  EXPECT_EQ(sessions_of_protocol(study(), file_), 1);
  try {
    delete_protocol(study(), file_);
    ADD_FAILURE() << "the protocol of a session was deleted";
  } catch (const PhrasedError& error) {
    EXPECT_THAT(error.what(), HasSubstr("small.json"));
    EXPECT_THAT(error.what(), HasSubstr("(number: 1)"));
  }
  EXPECT_THROW(rename_protocol(study(), file_, "mine"), PhrasedError);
  EXPECT_TRUE(std::filesystem::exists(file_));
}

TEST_F(StudyProtocols, CountAsRunByTheirNameOrTheirText) {
  run_it();
  std::string other = small_protocol();
  other.replace(other.find("1.0.0"), 5, "1.1.0");
  write_file(beside("other_text.json"), other, Overwrite::refuse);
  EXPECT_EQ(sessions_of_protocol(study(), beside("other_text.json")), 1);
  write_file(beside("copy.json"), with_protocol_name(other, "copy"), Overwrite::refuse);
  EXPECT_EQ(sessions_of_protocol(study(), beside("copy.json")), 0);
  EXPECT_THROW(rename_protocol(study(), beside("copy.json"), "small"), PhrasedError);
}

TEST_F(StudyProtocols, AreDeletedAlsoWhereTheyCannotBeRead) {
  write_file(beside("broken.json"), "{ \"name\": ", Overwrite::refuse);
  EXPECT_EQ(protocol_name("{ \"name\": "), std::nullopt);
  EXPECT_EQ(duplicate_protocol(study(), beside("broken.json")), beside("broken_2.json"));
  delete_protocol(study(), beside("broken.json"));
  EXPECT_FALSE(std::filesystem::exists(beside("broken.json")));
}

TEST_F(StudyProtocols, BelongInTheFileOfTheirNameWhereTheFileWasCalledAfterIt) {
  const std::string before = small_protocol();
  const std::string after = with_protocol_name(before, "mine");
  EXPECT_EQ(file_for_text(file_, before, after), beside("mine.json"));
  EXPECT_EQ(file_for_text(file_, before, before), file_);
  EXPECT_EQ(file_for_text(beside("draft.json"), before, after), beside("draft.json"));
  EXPECT_EQ(file_for_text(file_, before, with_protocol_name(before, "../mine")), file_);
  write_file(beside("mine.json"), "{}", Overwrite::refuse);
  EXPECT_EQ(file_for_text(file_, before, after), file_);
}

}  // namespace
}  // namespace asperity
