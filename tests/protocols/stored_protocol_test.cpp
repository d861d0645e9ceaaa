#include "protocols/stored_protocol.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

TEST(StoredProtocol, ReadsWhatIsSpecified) {
  const StoredProtocol read = stored_protocol(R"({
      "format": "asperity.protocol/9", "title": "Roughness", "unknown": [1, {}],
      "factors": {"tip": {"levels": ["small", "large"], "meaning": "diameter", "unit": "m"}, "bad": 3},
      "questions": {"hand": {"prompt": "Which hand?", "form": "choice", "options": ["left", 2, "right"],
                             "minimum": 1, "maximum": "2"}},
      "blocks": {"main": {"question": {"name": "rough", "prompt": "How rough?"}}, "rest": {}},
      "analysis": {"target": "new", "family": ["spacing", 4]},
      "estimation": {"spacing": "texture", "condition": "tip"}})");
  EXPECT_EQ(read.title, "Roughness");
  ASSERT_EQ(read.factors.size(), 1U);
  EXPECT_EQ(read.factors.at("tip").meaning, "diameter");
  EXPECT_EQ(read.factors.at("tip").unit, "m");
  const StoredProtocol::Question& hand = read.questions.at("hand");
  EXPECT_EQ(hand.prompt, "Which hand?");
  EXPECT_EQ(hand.form, "choice");
  EXPECT_EQ(hand.minimum, 1.0);
  EXPECT_FALSE(hand.maximum);
  EXPECT_THAT(hand.options, ElementsAre("left", "right"));
  ASSERT_EQ(read.trial_questions.size(), 1U);
  EXPECT_EQ(read.trial_questions.at("main").name, "rough");
  EXPECT_EQ(read.trial_questions.at("main").prompt, "How rough?");
  EXPECT_EQ(read.analysis.target, "new");
  EXPECT_THAT(read.analysis.family, ElementsAre("spacing"));
  ASSERT_TRUE(read.estimation);
  EXPECT_THAT(read.estimation->conditions, ElementsAre("small", "large"));
}

TEST(StoredProtocol, ReadsSpacingsOfTexturesAndOfNumbers) {
  const auto spacings = [](const std::string& levels) {
    return stored_protocol(R"({"estimation": {"spacing": "s"}, "factors": {"s": {"levels": )" +
                           levels +
                           R"(}}, "textures": {"fine": {"spacing_m": 0.001}, "plain": {}}})")
        .estimation.value()
        .spacing_m;
  };
  EXPECT_THAT(spacings(R"(["fine", "plain"])"), ElementsAre(Pair("fine", 0.001)));
  EXPECT_THAT(spacings("[0.002, 0.004]"), ElementsAre(Pair("0.002", 0.002), Pair("0.004", 0.004)));
}

TEST(StoredProtocol, ReadsNothingOfWhatHasAnotherForm) {
  for (const char* const source :
       {"", "not JSON", "[]", "3", R"({"title": 3, "factors": [], "questions": {"a": "b"}})",
        R"({"blocks": {"main": {"question": 3, "presented": 4}}, "kind": "selection"})",
        R"({"analysis": [], "estimation": "texture"})"}) {
    const StoredProtocol read = stored_protocol(source);
    EXPECT_EQ(read.title, "") << source;
    EXPECT_THAT(read.factors, IsEmpty()) << source;
    EXPECT_THAT(read.questions, IsEmpty()) << source;
    EXPECT_THAT(read.trial_questions, IsEmpty()) << source;
    EXPECT_EQ(read.analysis, AnalysisDeclaration{}) << source;
    EXPECT_FALSE(read.estimation) << source;
  }
}

}  // namespace
}  // namespace asperity
