// asperity stimulus: what the Stimuli page does with the stimuli of a study, and what it refuses.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"

namespace asperity::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class StimulusCommand : public testing::Test {
 protected:
  fs::path stimulus(const std::string& name) const { return small_.study() / "stimuli" / name; }
  void expect_refused(const std::vector<std::string>& arguments, int status,
                      const std::string& sentence) const {
    const auto before = contents_of(small_.study());
    const Outcome outcome = asperity(arguments);
    EXPECT_EQ(outcome.status, status);
    EXPECT_THAT(outcome.err, HasSubstr(sentence));
    EXPECT_EQ(contents_of(small_.study()), before);
  }

  const SmallStudy small_{};
};

TEST_F(StimulusCommand, RenamesWithAllReferences) {
  const Outcome outcome = asperity({"stimulus", stimulus("walnut.png"), "--rename", "oak"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "stimuli/walnut.png: renamed to stimuli/oak.png\n"
            "references changed in: small_recognition.json, small_selection.json\n");
  EXPECT_THAT(text_of(small_.selection()), HasSubstr("stimuli/oak.png"));
  EXPECT_TRUE(fs::exists(stimulus("oak.png.json")));
  EXPECT_FALSE(fs::exists(stimulus("walnut.png")));
  EXPECT_EQ(asperity({"check", small_.selection(), "--study", small_.study()}).status, 0);
}

TEST_F(StimulusCommand, DeletesAndCopiesWithoutReplacingAnything) {
  const fs::path other = small_.place() / "other";
  ASSERT_EQ(asperity({"new", other}).status, 0);
  const Outcome copied =
      asperity({"stimulus", stimulus("walnut.png"), stimulus("slate.png"), "--copy-to", other});
  ASSERT_EQ(copied.status, 0) << copied.err;
  EXPECT_EQ(text_of(other / "stimuli" / "slate.png"), text_of(stimulus("slate.png")));
  EXPECT_EQ(asperity({"stimulus", stimulus("walnut.png"), "--copy-to", other}).status, 0)
      << "the same file";
  write_text(other / "stimuli" / "slate.png", "another");
  expect_refused({"stimulus", stimulus("slate.png"), "--copy-to", other}, 1, "already exists");

  expect_refused({"stimulus", stimulus("walnut.png"), "--delete"}, 1,
                 "walnut.png is used by small_recognition.json, small_selection.json");
  const Outcome deleted = asperity({"stimulus", other / "stimuli" / "walnut.png", "--delete"});
  EXPECT_EQ(deleted.status, 0) << deleted.err;
  EXPECT_EQ(deleted.out, "deleted: stimuli/walnut.png.json, stimuli/walnut.png\n");
  EXPECT_FALSE(fs::exists(other / "stimuli" / "walnut.png.json"));
}

TEST_F(StimulusCommand, CopiesTheValuesOfARendering) {
  const std::string sha256(64, '0');
  write_text(stimulus("stiff.rendering.json"),
             R"({"format": "asperity.rendering/1", "model": "height_map", "version": "0", )"
             R"("texture": {"height_field": "stimuli/slate.png", "sha256": ")" +
                 sha256 +
                 R"("}, "parameters": {"height_scale": 2.5}, )"
                 R"("material": {"stiffness_N_per_m": 700, "friction": 0.3}})");
  const fs::path out = small_.study() / "protocols" / "stiff.json";
  const Outcome outcome = asperity(
      {"stimulus", stimulus("stiff.rendering.json"), "--use-in", small_.selection(), "--out", out});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("/stimuli/stiff/x-rendering: none → stiff\n"),
                                 HasSubstr("stiff.json: ")));
  EXPECT_THAT(outcome.err, HasSubstr("asperity: warning: "));
  EXPECT_THAT(text_of(out), HasSubstr("\"x-rendering\": \"stiff\""));

  const std::vector<std::string> again{
      "stimulus", stimulus("stiff.rendering.json"), "--use-in", out, "--out", out};
  expect_refused(again, 1, "already exists");
  std::vector<std::string> elsewhere = again;
  elsewhere.insert(elsewhere.end(), {"--replace", "nowhere", "--force"});
  expect_refused(elsewhere, 1, "there is no surface \"nowhere\"");
  expect_refused({"stimulus", stimulus("slate.png"), "--use-in", out, "--out", out}, 1,
                 "is not a rendering");
}

TEST_F(StimulusCommand, StatesWhatIsNoStimulusAndWhatToDo) {
  expect_refused({"stimulus", stimulus("slate.png")}, 2, "stimulus needs one of --rename");
  expect_refused({"stimulus", stimulus("slate.png"), "--delete", "--rename", "x"}, 2,
                 "exclude each other");
  expect_refused({"stimulus", stimulus("slate.png"), stimulus("walnut.png"), "--rename", "x"}, 2,
                 "--rename takes one file");
  expect_refused({"stimulus", stimulus("slate.png.json"), "--delete"}, 1, "belongs to slate.png");
  expect_refused({"stimulus", stimulus("none.png"), "--delete"}, 1, "is not a stimulus");
  expect_refused({"stimulus", small_.selection(), "--delete"}, 1, "is not a stimulus");
  expect_refused({"stimulus", stimulus("slate.png"), "--rename", "a/b"}, 1,
                 "cannot be the name of a stimulus");
}

}  // namespace
}  // namespace asperity::test
