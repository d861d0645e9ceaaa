// Scales that rate the confidence of the response of a discrimination: what is read, stored and refused.

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/file/stored_protocol.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using ConfidenceJson = nlohmann::json;
using ::testing::HasSubstr;

ConfidenceJson& rated_block(ConfidenceJson& protocol) { return protocol["blocks"]["comparisons"]; }

/// amplitude_jnd with constant stimuli, and a scale for the confidence of its response.
ConfidenceJson with_confidence(const std::string& design) {
  ConfidenceJson file = test::library_file("amplitude_jnd");
  ConfidenceJson& block = rated_block(file);
  block["design"] = design;
  block.erase("procedure");
  block["vary"]["levels_percent"] = {5, 10, 20, 30, 50};
  block["repetitions"] = 6;
  block["positions"] = "balanced";
  block["questions"] = {block["question"],
                        {{"name", "sure"},
                         {"prompt", "How sure?"},
                         {"confidence_of", block["question"]["name"]},
                         {"scale", {{"minimum", 1}, {"maximum", 4}, {"points", 4}}}}};
  block.erase("question");
  return file;
}

TEST(ConfidenceOfAResponse, IsReadAndStored) {
  const ConfidenceJson file = with_confidence("two_alternatives");
  const Protocol protocol = test::valid(file);
  const auto& questions = protocol.blocks.at("comparisons").questions;
  EXPECT_EQ(questions.at(1).confidence_of(), questions.at(0).name);
  EXPECT_EQ(stored_protocol(file.dump())
                .protocol.blocks.at("comparisons")
                .questions.at(1)
                .confidence_of(),
            questions.at(0).name);
}

TEST(ConfidenceOfAResponse, IsRatedOnAScaleThatStatesItsForm) {
  ConfidenceJson file = with_confidence("two_alternatives");
  rated_block(file)["questions"][1]["form"] = "scale";
  const auto of = [](const Protocol& protocol) {
    return protocol.blocks.at("comparisons").questions.at(1).confidence_of();
  };
  EXPECT_EQ(of(test::valid(file)), "rougher");
  EXPECT_EQ(of(stored_protocol(file.dump()).protocol), "rougher");
}

// The default of another kind's key is equivalent to its absence, also where it is stated after what it would replace.
TEST(ConfidenceOfAResponse, IsKeptNextToADefaultOfAnotherKind) {
  ConfidenceJson file = with_confidence("two_alternatives");
  for (ConfidenceJson& question : rated_block(file)["questions"]) {
    question["rates"] = "dissimilarity";
  }
  for (const Protocol& protocol : {test::valid(file), stored_protocol(file.dump()).protocol}) {
    const auto& questions = protocol.blocks.at("comparisons").questions;
    EXPECT_TRUE(questions.at(0).judgement());
    EXPECT_EQ(questions.at(1).confidence_of(), "rougher");
  }
}

TEST(ConfidenceOfAResponse, IsRefusedWhereItGivesNoRoc) {
  const std::string scale = "/blocks/comparisons/questions/1";
  struct FaultOfConfidence {
    const char* design = "two_alternatives";
    std::string pointer{};
    const char* message = "";
    std::function<void(ConfidenceJson& block)> change{};
  };
  const std::vector<FaultOfConfidence> faults{
      {"oddity", scale + "/confidence_of", "gives no ROC", [](ConfidenceJson&) {}},
      {"two_alternatives", scale + "/confidence_of", "write this name",
       [](ConfidenceJson& block) { block["questions"][1]["confidence_of"] = "other"; }},
      {"two_alternatives", scale, "with 2 to 10 \"points\"",
       [](ConfidenceJson& block) { block["questions"][1]["scale"].erase("points"); }},
      {"two_alternatives", scale + "/confidence_of", "no response is correct",
       [](ConfidenceJson& block) {
         block["questions"][0]["judgement"] = "comparison";
         block["vary"]["levels_percent"] = {-10, 10};
       }},
      {"two_alternatives", "/blocks/comparisons/questions/0", "is rated after it",
       [](ConfidenceJson& block) { std::swap(block["questions"][0], block["questions"][1]); }},
      {"two_alternatives", "/blocks/comparisons/questions/2/confidence_of",
       "rates the same confidence", [](ConfidenceJson& block) {
         ConfidenceJson second = block["questions"][1];
         second["name"] = "surer";
         block["questions"].push_back(second);
       }}};
  for (const FaultOfConfidence& fault : faults) {
    SCOPED_TRACE(fault.message);
    ConfidenceJson file = with_confidence(fault.design);
    fault.change(rated_block(file));
    EXPECT_THAT(test::problems_at(file, fault.pointer), HasSubstr(fault.message));
  }
}

}  // namespace
}  // namespace asperity
