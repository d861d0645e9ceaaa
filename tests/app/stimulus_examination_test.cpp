// What an examination of the stimuli of a protocol consists of, and where it ends.

#include "app/tasks/warnings/stimulus_examination.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderers/built_in_models.h"
#include "tests/app/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Two surfaces that exert at most 1.5 N at rest, under an exploration that requests 2 N.
constexpr const char* kTooStrong = R"(, "normal_force_N": {"minimum": 2.0, "maximum": 2.5})";

class StimulusExaminations : public testing::Test {
 protected:
  StimulusExaminations() { make_small_study(study_); }

  Protocol read(const std::string& text) const { return read_small_protocol(models_, text); }
  StimulusExamination examined(const Protocol& protocol, const std::stop_token& stop = {}) const {
    StimulusBuilder builder(models_, study_);
    return examine_stimuli({protocol, "small.json"}, study_, builder, {.stop = stop});
  }
  /// How many of them say so.
  static std::ptrdiff_t count(const std::vector<Diagnostic>& diagnostics, const std::string& what) {
    return std::count_if(diagnostics.begin(), diagnostics.end(), [&what](const auto& one) {
      return one.message.english().find(what) != std::string::npos;
    });
  }

  TemporaryFolder folder_{};
  std::filesystem::path study_ = folder_ / "study";
  ModelRegistry models_ = built_in_models();
};

TEST_F(StimulusExaminations, NameWhatTheStimuliCannotDo) {
  const StimulusExamination found = examined(read(small_protocol("", kTooStrong)));
  EXPECT_THAT(found.problems, IsEmpty());
  EXPECT_EQ(count(found.warnings, "exerts at most 1.50 N at rest"), 1);
}

TEST_F(StimulusExaminations, EndWhenTheyAreStopped) {
  std::stop_source stop{};
  stop.request_stop();
  const StimulusExamination found =
      examined(read(small_protocol("", kTooStrong)), stop.get_token());
  EXPECT_THAT(found.problems, IsEmpty());
  EXPECT_THAT(found.warnings, IsEmpty());
}

TEST_F(StimulusExaminations, AreAddedToACheckInTheOrderOfLines) {
  ProtocolCheck check{};
  check.diagnostics = {{.line = 9, .message = "ninth"}};
  check.warnings = {{.line = 3, .message = "third"}};
  add_examination(
      check, {.problems = {{.line = 5, .message = "fifth"}},
              .warnings = {{.line = 7, .message = "seventh"}, {.line = 1, .message = "first"}}});
  const auto messages_of = [](const std::vector<Diagnostic>& diagnostics) {
    std::vector<std::string> messages{};
    for (const Diagnostic& one : diagnostics) messages.push_back(one.message.english());
    return messages;
  };
  EXPECT_THAT(messages_of(check.warnings), ElementsAre("first", "third", "seventh"));
  EXPECT_THAT(messages_of(check.diagnostics), ElementsAre("fifth", "ninth"));
}

}  // namespace
}  // namespace asperity
