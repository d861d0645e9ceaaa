// Warnings about the sessions of a study, where there is one and where it cannot be read.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/tasks/warnings/session_warnings.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(SessionWarnings, AreNoneWithoutAStudyAndStateThatOneCannotBeRead) {
  const TemporaryFolder folder{};
  const ModelRegistry models = built_in_models();
  const Protocol protocol = read_small_protocol(models, small_protocol());
  const auto warnings = [&] {
    return warnings_about_sessions({protocol, "small.json"}, folder.path(), models);
  };
  EXPECT_THAT(warnings(), IsEmpty());
  write_file(folder / "study.sqlite",
             "this is a letter, not a database, and it is long enough to look like one",
             Overwrite::refuse);
  const std::vector<Diagnostic> found = warnings();
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].pointer, "/version");
  EXPECT_GT(found[0].line, 1);
  EXPECT_THAT(found[0].message.english(), HasSubstr("could not be determined: "));
}

}  // namespace
}  // namespace asperity
