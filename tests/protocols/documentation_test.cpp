// What the guide shows is accepted, and the reference leaves no key out.

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/plan/plan.h"
#include "protocols/texts/design_numbers.h"
#include "renderers/built_in_models.h"
#include "tests/protocols/example.h"

namespace asperity {
namespace {

std::string contents(const std::string& path) {
  std::ifstream stream(std::string(ASPERITY_SOURCE_DIR) + "/" + path, std::ios::binary);
  EXPECT_TRUE(stream) << path;
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> json_blocks(const std::string& text) {
  std::vector<std::string> blocks{};
  const std::string fence = "```json\n";
  for (std::size_t at = text.find(fence); at != std::string::npos; at = text.find(fence, at)) {
    at += fence.size();
    blocks.push_back(text.substr(at, text.find("```", at) - at));
  }
  return blocks;
}

Protocol read_or_fail(const std::string& text) {
  try {
    return read_protocol(text, "docs/authoring-protocols.md", test::example_models());
  } catch (const ProtocolError& error) {
    ADD_FAILURE() << error.what();
    return {};
  }
}

TEST(AuthoringGuide, ShowsAFirstProtocolThatIsAccepted) {
  const auto blocks = json_blocks(contents("docs/authoring-protocols.md"));
  ASSERT_FALSE(blocks.empty());
  const Protocol protocol = read_or_fail(blocks.front());
  EXPECT_EQ(protocol.name, "first_steps");
  EXPECT_EQ(make_plan(protocol, {1, 0}).trials.size(), 8U);
}

TEST(AuthoringGuide, ShowsFragmentsThatFitTheFirstProtocol) {
  const auto blocks = json_blocks(contents("docs/authoring-protocols.md"));
  ASSERT_GE(blocks.size(), 8U);
  for (std::size_t i = 1; i < blocks.size(); ++i) {
    if (blocks[i].starts_with("{")) continue;  // a protocol of its own
    auto whole = nlohmann::json::parse(blocks.front());
    whole.merge_patch(nlohmann::json::parse("{" + blocks[i] + "}"));
    SCOPED_TRACE(blocks[i]);
    (void)read_or_fail(whole.dump(1));
  }
}

TEST(AuthoringGuide, ShowsACompleteProtocolWithBlocksOfTwoKindsThatIsAccepted) {
  std::vector<Protocol> complete{};
  for (const std::string& block : json_blocks(contents("docs/authoring-protocols.md"))) {
    if (block.starts_with("{")) complete.push_back(read_or_fail(block));
  }
  ASSERT_EQ(complete.size(), 2U);
  const Protocol& protocol = complete.back();
  EXPECT_EQ(protocol.blocks.at("attributes").kind, "rating");
  EXPECT_EQ(protocol.blocks.at("recognition").kind, "recognition");
  EXPECT_EQ(protocol.blocks.at("attributes").questions.size(), 2U);
  // 3 textures, twice in each block.
  EXPECT_EQ(make_plan(protocol, {1, 0}).trials.size(), 12U);
}

/// The indented fragments of a document, each as an object.
std::vector<nlohmann::json> indented_fragments(const std::string& text) {
  std::vector<nlohmann::json> fragments{};
  std::string fragment{};
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("    ")) {
      fragment += line;
      continue;
    }
    const auto read = nlohmann::json::parse('{' + fragment + '}', nullptr, false);
    if (!fragment.empty() && !read.is_discarded()) fragments.push_back(read);
    fragment.clear();
  }
  return fragments;
}

TEST(ProceduresGuide, ShowsProceduresThatAreAccepted) {
  std::vector<std::string> methods{};
  nlohmann::json vary{};
  for (const nlohmann::json& fragment : indented_fragments(contents("docs/procedures.md"))) {
    if (fragment.contains("vary")) vary = fragment.at("vary");
    if (!fragment.contains("procedure")) continue;
    auto whole = nlohmann::json::parse(contents("protocols/library/amplitude_jnd.json"));
    whole["blocks"]["comparisons"]["vary"] = vary;
    whole["blocks"]["comparisons"]["procedure"] = fragment.at("procedure");
    methods.push_back(fragment.at("procedure").at("method"));
    SCOPED_TRACE(methods.back());
    try {
      (void)read_protocol(whole.dump(1), "docs/procedures.md", declarations_of(built_in_models()));
    } catch (const ProtocolError& error) {
      ADD_FAILURE() << error.what();
    }
  }
  EXPECT_EQ(methods, (std::vector<std::string>{"transformed_up_down", "weighted_up_down", "psi",
                                               "external"}));
}

void expect_keys(const nlohmann::json& node, const std::string& reference) {
  if (node.is_array()) {
    for (const auto& member : node) expect_keys(member, reference);
  }
  if (!node.is_object()) return;
  if (const auto properties = node.find("properties"); properties != node.end()) {
    for (const auto& [key, member] : properties->items()) {
      EXPECT_NE(reference.find("`" + key + "`"), std::string::npos) << key;
      if (member.contains("description")) {
        EXPECT_NE(reference.find(member.at("description").get<std::string>().substr(0, 30)),
                  std::string::npos)
            << key << ": the reference says something else than the schema";
      }
    }
  }
  for (const auto& [key, member] : node.items()) expect_keys(member, reference);
}

TEST(FormatReference, NamesEveryKeyOfTheSchemaAsTheSchemaDoes) {
  nlohmann::json schema = protocol_schema();
  // Bands are described once, in the text.
  const auto drop_bands = [](const auto& self, nlohmann::json& node) -> void {
    if (node.is_object() && node.contains("properties") &&
        node.at("properties").contains("target")) {
      node.erase("properties");
    }
    if (node.is_structured()) {
      for (auto& member : node) self(self, member);
    }
  };
  drop_bands(drop_bands, schema);
  expect_keys(schema, contents("docs/formats/protocol.md"));
}

TEST(FormatPage, ListsTheNumbersOfTheDesign) {
  const std::string page = contents("docs/formats/protocol.md");
  for (const DesignNumber& number : kDesignNumbers) {
    const std::string row = "| `{" + std::string(number.name) + "}` | " +
                            (number.scope == NumberScope::block ? "block" : "session") + " | " +
                            std::string(number.meaning) + " |";
    EXPECT_NE(page.find(row), std::string::npos) << row;
  }
}

}  // namespace
}  // namespace asperity
