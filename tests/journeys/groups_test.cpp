// Groups of participants at the command line: check names them, run takes or refuses one, verify agrees.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "results_schema/study.h"
#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"

namespace asperity::test {
namespace {

using testing::HasSubstr;

/// The small selection with two groups that the experimenter assigns.
void assign_groups(const SmallStudy& small) {
  nlohmann::ordered_json protocol = small_selection(1);
  protocol["factors"]["training"] = {{"levels", {"haptic", "visual"}}};
  protocol["groups"] = {{"factor", "training"}, {"assigned", "by_experimenter"}};
  write_text(small.selection(), protocol.dump(2));
}

std::vector<std::string> run_of(const SmallStudy& small, const std::string& participant,
                                const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"run",           small.selection().string(),
                                     "--study",       small.study().string(),
                                     "--participant", participant,
                                     "--virtual"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(Groups, AreNamedByCheck) {
  const SmallStudy small(1);
  assign_groups(small);
  EXPECT_THAT(asperity({"check", small.selection().string()}).out,
              HasSubstr("groups: training (haptic, visual), assigned by the experimenter\n"));
  const auto json =
      nlohmann::json::parse(asperity({"check", small.selection().string(), "--json"}).out);
  EXPECT_EQ(json.at("protocols").at(0).at("groups").dump(),
            R"({"assigned":"by_experimenter","factor":"training","levels":["haptic","visual"]})");
}

TEST(Groups, AreStatedForRunAndKept) {
  const SmallStudy small(1);
  assign_groups(small);
  const Outcome missing = asperity(run_of(small, "virtual0001"));
  EXPECT_EQ(missing.status, 1);
  EXPECT_THAT(missing.err, HasSubstr("with --group: \"haptic\" or \"visual\""));
  const Outcome unknown = asperity(run_of(small, "virtual0001", {"--group", "olfactory"}));
  EXPECT_EQ(unknown.status, 1);
  EXPECT_THAT(unknown.err, HasSubstr("has no group \"olfactory\""));
  const Outcome stated = asperity(run_of(small, "virtual0001", {"--group", "visual"}));
  EXPECT_EQ(stated.status, 0) << stated.err;
  const Outcome other = asperity(run_of(small, "virtual0001", {"--group", "haptic"}));
  EXPECT_EQ(other.status, 1);
  EXPECT_THAT(other.err, HasSubstr("is in the group \"visual\""));
  EXPECT_EQ(asperity(run_of(small, "virtual0001", {"--resume", "--group", "visual"})).status, 2);
  const Study study = Study::open(small.study(), Access::read_only);
  ASSERT_EQ(study.sessions().size(), 1U);
  EXPECT_EQ(study.sessions().at(0).group_level, "visual");
  EXPECT_EQ(asperity({"verify", small.study().string()}).status, 0);
}

}  // namespace
}  // namespace asperity::test
