// What a protocol file may say, and what the reader answers when it says something else.

#include "protocols/protocol_reader.h"

#include "protocols/plan.h"
#include "tests/protocols/example.h"

namespace asperity {
namespace {

TEST(ProtocolReader, ReadsAMinimalSelection) {
  try {
    const Protocol protocol =
        read_protocol(test::example_selection(), "example.json", test::example_models());
    EXPECT_EQ(protocol.name, "example_selection");
    EXPECT_EQ(protocol.textures.at("stone").height_field, "stimuli/stone.png");
    EXPECT_EQ(protocol.blocks.at("main").presented.size(), 3U);
    const Plan plan = make_plan(protocol, {.seed = 1, .counterbalance_row = 0});
    EXPECT_EQ(plan.trials.size(), 6U);
  } catch (const ProtocolError& error) {
    FAIL() << error.what();
  }
}

}  // namespace
}  // namespace asperity
