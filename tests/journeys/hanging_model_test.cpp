// A force model in an endless loop, in the program as people start it.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

using testing::HasSubstr;

constexpr const char* kEndless = ASPERITY_FAULTY_PLUGINS "/faulty_endless.so";

TEST(HangingModel, StopsARealTimeSessionWithZeroForceAndAWordAndCanBeResumed) {
  const TemporaryFolder place{};
  const fs::path study = place / "study";
  ASSERT_EQ(asperity({"new", study}).status, 0);
  write_text(place / "endless.json", faulty_discrimination().dump());
  const std::vector<std::string> session{"run",
                                         place / "endless.json",
                                         "--study",
                                         study,
                                         "--participant",
                                         "v1",
                                         "--virtual",
                                         "--seed",
                                         "1",
                                         "--realtime",
                                         "--plugin",
                                         kEndless};
  const Outcome stopped = asperity(session);
  EXPECT_EQ(stopped.status, 1) << stopped.err;
  EXPECT_THAT(stopped.err,
              HasSubstr("The servo loop stalled for more than 50 ms: the force was set to zero."));
  EXPECT_THAT(stopped.err, HasSubstr("a tick of the force model faulty did not return; end this "
                                     "program and start it again"));
  const auto tables = exported(study, place / "out");
  const Tsv attempts = tsv(tables.at("attempts.tsv"));
  ASSERT_FALSE(attempts.rows.empty());
  EXPECT_EQ(attempts.column("outcome").back(), "device_fault");
  EXPECT_EQ(attempts.column("valid").back(), "0");
  EXPECT_EQ(attempts.column("invalid_code").back(), "model_does_not_return");
  EXPECT_EQ(asperity({"verify", study, "--plugin", kEndless}).status, 0);

  std::vector<std::string> again = session;
  again.emplace_back("--resume");
  EXPECT_THAT(asperity(again).err, HasSubstr("a tick of the force model faulty did not return"));
}

}  // namespace
}  // namespace asperity::test
