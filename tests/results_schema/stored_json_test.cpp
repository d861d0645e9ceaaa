// JSON that the store keeps is refused by the name of its column where it is damaged.

#include "results_schema/stored_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "results_schema/study.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(StoredJson, NamesTheColumnThatIsDamaged) {
  EXPECT_EQ(stored_json(R"({"deaf": true})", "session.observer_json")["deaf"], true);
  EXPECT_THAT(refusal_of<ResultsError>([] { stored_json("{\"deaf\"", "session.observer_json"); }),
              AllOf(HasSubstr("session.observer_json"), HasSubstr("asperity verify")));
}

}  // namespace
}  // namespace asperity
