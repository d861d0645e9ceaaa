// The constructs that a protocol declares for its ratings.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocols/file/protocol_reader.h"
#include "protocols/file/stored_protocol.h"
#include "tests/protocols/example.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string rating_with(const std::string& construct) {
  std::string text = test::library_text("attributes_of_textures");
  const std::string declared = R"("analysis": {)";
  return text.insert(text.rfind(declared) + declared.size(),
                     R"("constructs": {"roughness": )" + construct + "}, ");
}

std::string problems_of_construct(const std::string& construct) {
  try {
    (void)read_protocol(rating_with(construct), "p.json", test::example_models());
  } catch (const ProtocolError& error) {
    return error.what();
  }
  return {};
}

TEST(Constructs, AreReadWithTheirReversedScales) {
  const std::string text =
      rating_with(R"({"scales": ["rough", "coarse"], "reverse_keyed": ["coarse"]})");
  const Protocol protocol = read_protocol(text, "p.json", test::example_models());
  const ConstructDeclaration& construct = protocol.analysis.constructs.at("roughness");
  EXPECT_THAT(construct.scales, ElementsAre("rough", "coarse"));
  EXPECT_TRUE(construct.is_reversed("coarse"));
  EXPECT_FALSE(construct.is_reversed("rough"));
  EXPECT_EQ(stored_protocol(text).protocol.analysis, protocol.analysis);
}

TEST(Constructs, ConsistOfScalesOfOneRange) {
  EXPECT_THAT(problems_of_construct(R"({"scales": ["rough", "course"]})"),
              HasSubstr("no main block of ratings has a scale \"course\""));
  EXPECT_THAT(problems_of_construct(R"({"scales": ["rough", "rough"]})"),
              HasSubstr("\"rough\" occurs twice in this list"));
  EXPECT_THAT(problems_of_construct(R"({"scales": ["rough"]})"),
              HasSubstr("(/analysis/constructs/roughness"));
  EXPECT_THAT(
      problems_of_construct(R"({"scales": ["rough", "hard"], "reverse_keyed": ["coarse"]})"),
      HasSubstr("\"coarse\" is not one of the scales of this construct; use \"rough\""));
  std::string text = rating_with(R"({"scales": ["rough", "hard"]})");
  const std::size_t main = text.find(R"("ratings": {)");
  const std::size_t hard = text.find(R"("name": "hard")", main);
  const std::size_t range = text.find(R"("maximum": 3)", hard);
  text.replace(range, 12, R"("maximum": 4)");
  EXPECT_THAT([&] { (void)read_protocol(text, "p.json", test::example_models()); },
              testing::ThrowsMessage<ProtocolError>(
                  HasSubstr("\"hard\" has -3 to 4, \"rough\" has -3 to 3")));
}

}  // namespace
}  // namespace asperity
