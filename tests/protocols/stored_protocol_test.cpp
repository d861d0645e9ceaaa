// What is read of a stored protocol: statements, scales, spacings, parameters and languages.

#include "protocols/file/stored_protocol.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocols/plan/groups.h"
#include "tests/support/questions.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

TEST(StoredProtocol, ReadsWhatIsSpecified) {
  const Protocol read = stored_protocol(R"({
      "format": "asperity.protocol/9", "title": "Roughness", "unknown": [1, {}],
      "factors": {"tip": {"levels": ["small", "large"], "meaning": "diameter", "unit": "m",
                          "hed": {"small": "Item", "large": 3}}, "bad": 3},
      "questions": {"hand": {"prompt": "Which hand?", "form": "choice", "options": ["left", 2, "right"],
                             "minimum": 1, "maximum": "2"}},
      "blocks": {"main": {"question": {"name": "rough", "prompt": "How rough?"}}, "rest": {}},
      "analysis": {"target": "new", "family": ["spacing", 4], "equivalence_margin": 0.1},
      "estimation": {"spacing": "texture", "condition": "tip"}})")
                            .protocol;
  EXPECT_EQ(read.title, "Roughness");
  ASSERT_EQ(read.factors.size(), 1U);
  EXPECT_EQ(read.factors.at("tip").meaning, "diameter");
  EXPECT_EQ(read.factors.at("tip").unit, "m");
  EXPECT_THAT(read.factors.at("tip").hed, ElementsAre(Pair("small", "Item")));
  const Question& hand = read.questions.at("hand");
  EXPECT_EQ(hand.prompt, "Which hand?");
  EXPECT_TRUE(hand.is_answered_by<ChoiceForm>()) << "a key of another form changes nothing";
  EXPECT_THAT(values_of(hand.options), ElementsAre("left", "right"));
  ASSERT_EQ(read.blocks.at("main").questions.size(), 1U);
  EXPECT_EQ(read.blocks.at("main").questions.front().name, "rough");
  EXPECT_EQ(read.blocks.at("main").questions.front().prompt, "How rough?");
  EXPECT_EQ(read.analysis.target, "new");
  EXPECT_EQ(read.analysis.equivalence_margin, 0.1);
  EXPECT_THAT(read.analysis.family, ElementsAre("spacing"));
  ASSERT_TRUE(read.estimation);
  EXPECT_THAT(read.estimation->conditions, ElementsAre("small", "large"));
}

TEST(StoredProtocol, DoesNotReplaceWhatItDoesNotKnowOfABlockByADefault) {
  const Protocol read = stored_protocol(R"({"kind": "selection", "blocks": {
      "ranked": {"kind": "ranking"}, "own": {}, "later": {"phase": "retention"},
      "odd": {"design": "three_down", "questions": [], "question_layout": "one_page",
              "page_prompt": "Feel {surfaces}."}}})")
                            .protocol;
  EXPECT_EQ(read.blocks.at("ranked").kind, "ranking");
  EXPECT_EQ(read.blocks.at("own").kind, "selection");
  EXPECT_NE(read.blocks.at("later").phase, Phase::main);
  EXPECT_EQ(read.blocks.at("odd").design(), nullptr);
  EXPECT_EQ(read.blocks.at("odd").page_prompt, "Feel {surfaces}.") << "their number is not known";
  EXPECT_EQ(stored_protocol(R"({"kind": "ranking"})").protocol.kind, "ranking");
  EXPECT_EQ(stored_protocol(R"({"blocks": {"main": {}}})").protocol.blocks.at("main").kind, "");
}

TEST(StoredProtocol, HasTheProcedureOfALaterVersionWithoutTracks) {
  const auto procedure = [](const std::string& stated) {
    return *stored_protocol(R"({"kind": "discrimination", "blocks": {"main": {
        "vary": {"parameter": "friction", "of": "comparison", "levels": {"lowest": 0.1, "highest": 0.5, "step": 0.1}},
        "procedure": {"start": 0.2, "steps": [0.1], "stop": {"trials": 20},
                      "catch_trials": {"level": 0.3, "every": 5}, )" +
                            stated + "}}}}")
                .protocol.blocks.at("main")
                .procedure;
  };
  EXPECT_EQ(procedure(R"("method": "transformed_up_down", "down": 2)").tracks.size(), 1U);
  const auto with_more = procedure(R"("method": "transformed_up_down", "down": 2, "later": 1)");
  EXPECT_EQ(with_more.tracks.size(), 1U);
  EXPECT_TRUE(with_more.catch_trials);
  const auto unknown = procedure(R"("method": "entropy")");
  EXPECT_TRUE(unknown.tracks.empty());
  EXPECT_TRUE(unknown.catch_trials);
}

TEST(StoredProtocol, HasNoPermutedBlocksOfGroupsThatAreNotRead) {
  const auto blocks = [](const std::string& levels, const std::string& groups) {
    return permuted_blocks_of(stored_protocol(R"({"factors": {"g": {"levels": )" + levels +
                                              R"(}}, "groups": {"factor": "g", "assigned": )"
                                              R"("permuted_blocks")" +
                                              groups + "}}")
                                  .protocol);
  };
  EXPECT_TRUE(blocks(R"(["a", "b"])", ""));
  EXPECT_FALSE(blocks("[]", ""));
  EXPECT_FALSE(blocks(R"(["a", "b", {"name": "c"}])", ""));
  EXPECT_FALSE(blocks(R"(["a", "b"])", R"(, "block_sizes": ["four"])"));
}

TEST(StoredProtocol, DoesNotReplaceWhatItDoesNotKnowOfSensesByADefault) {
  const StoredProtocol later = stored_protocol(
      R"({"environment": {"vision": "mirrored", "touch": 1, "masking_noise": {"kind": "brown"}}})");
  EXPECT_FALSE(later.senses().vision);
  EXPECT_FALSE(later.senses().noise);
  EXPECT_EQ(stored_protocol("{}").senses().vision, Vision::free);
  ASSERT_TRUE(stored_protocol("{}").senses().noise);
  EXPECT_FALSE(stored_protocol("no protocol").senses().vision);
  EXPECT_FALSE(stored_protocol("[]").senses().noise);
}

TEST(StoredProtocol, GivesAScaleTheEndsThatItHasWhereNoneAreStated) {
  const StoredProtocol read = stored_protocol(
      R"({"kind": "rating", "blocks": {"only": {"question": {"name": "rough", "scale": {}}}}})");
  const auto& asked = read.protocol.blocks.at("only").questions.front();
  EXPECT_EQ(std::get<ScaleForm>(asked.form).minimum, 0.0);
  EXPECT_EQ(std::get<ScaleForm>(asked.form).maximum, 100.0);
}

TEST(StoredProtocol, ReadsSpacingsOfTexturesAndOfNumbers) {
  const auto spacings = [](const std::string& levels) {
    return stored_protocol(R"({"estimation": {"spacing": "s"}, "factors": {"s": {"levels": )" +
                           levels +
                           R"(}}, "textures": {"fine": {"spacing_m": 0.001}, "plain": {}}})")
        .protocol.estimation.value()
        .spacing_m;
  };
  EXPECT_THAT(spacings(R"(["fine", "plain"])"), ElementsAre(Pair("fine", 0.001)));
  EXPECT_THAT(spacings("[0.002, 0.004]"), ElementsAre(Pair("0.002", 0.002), Pair("0.004", 0.004)));
}

/// A selection among two surfaces of these stimuli.
std::string selection_among(const std::string& stimuli, const std::string& presented) {
  return R"({"kind": "selection", "stimuli": )" + stimuli +
         R"(, "blocks": {"warm_up": {"phase": "practice", "presented": []}, "main": {"presented": )" +
         presented + "}}}";
}

TEST(StoredProtocol, NamesTheOneParameterThatASelectionCompares) {
  const auto compared = [](const std::string& stimuli, const std::string& presented) {
    return stored_protocol(selection_among(stimuli, presented)).compared_parameter;
  };
  const std::string of_factor = R"({"wave": {"model": "sinusoid", "texture": {"factor": "texture"},
                                             "parameters": {"amplitude_m": {"factor": "amplitude"}}}})";
  EXPECT_EQ(compared(of_factor,
                     R"([{"stimulus": "wave", "with": {"amplitude": 0.001}, "item": "standard"},
                                    {"stimulus": "wave", "with": {"amplitude": 0.002}, "item": "comparison"}])"),
            "amplitude_m");
  EXPECT_EQ(compared(R"({"a": {"model": "m", "equal_force": {"rms_N": 0.2}},
                         "b": {"model": "m", "equal_force": {"rms_N": 0.3}}})",
                     R"([{"stimulus": "a"}, {"stimulus": "b"}])"),
            "rms_N");
  // A parameter that one leaves to its default is another level.
  EXPECT_EQ(
      compared(R"({"a": {"model": "m", "parameters": {"friction": 0.2}}, "b": {"model": "m"}})",
               R"([{"stimulus": "a"}, {"stimulus": "b"}])"),
      "friction");
}

TEST(StoredProtocol, NamesNoParameterWhereMoreDiffers) {
  const auto compared = [](const std::string& stimuli) {
    return stored_protocol(selection_among(stimuli, R"([{"stimulus": "a"}, {"stimulus": "b"}])"))
        .compared_parameter;
  };
  EXPECT_FALSE(compared(R"({"a": {"model": "m"}, "b": {"model": "n"}})"));
  EXPECT_FALSE(compared(R"({"a": {"model": "m", "parameters": {"friction": 0.2}},
                            "b": {"model": "n", "parameters": {"friction": 0.3}}})"));
  EXPECT_FALSE(compared(R"({"a": {"model": "m", "parameters": {"friction": 0.2, "gain": 1}},
                            "b": {"model": "m", "parameters": {"friction": 0.3, "gain": 2}}})"));
  EXPECT_FALSE(compared(R"({"a": {"model": "m"}, "b": {"model": "m"}})")) << "nothing differs";
  EXPECT_FALSE(stored_protocol(R"({"kind": "matching", "stimuli": {"a": {"parameters": {"x": 1}},
                                   "b": {"parameters": {"x": 2}}},
                                   "blocks": {"m": {"presented": [{"stimulus": "a"}, {"stimulus": "b"}]}}})")
                   .compared_parameter);
}

TEST(StoredProtocol, ReadsNothingOfWhatHasAnotherForm) {
  for (const char* const source :
       {"", "not JSON", "[]", "3", R"({"title": 3, "factors": [], "questions": {"a": "b"}})",
        R"({"blocks": {"main": {"question": 3, "presented": 4}}, "kind": "selection"})",
        R"({"analysis": [], "estimation": "texture"})"}) {
    const Protocol read = stored_protocol(source).protocol;
    EXPECT_EQ(read.title, "") << source;
    EXPECT_THAT(read.factors, IsEmpty()) << source;
    EXPECT_THAT(read.questions, IsEmpty()) << source;
    for (const auto& [name, block] : read.blocks) {
      EXPECT_TRUE(block.questions.empty() && block.presented.empty()) << source;
    }
    EXPECT_EQ(read.analysis, AnalysisDeclaration{}) << source;
    EXPECT_FALSE(read.estimation) << source;
  }
}

TEST(StoredProtocol, WithoutTextsIsTheSameInEveryLanguageAndInNothingElse) {
  const auto rest = [](const char* language, const char* text, const char* value) {
    return without_texts(std::string(R"({"language": ")") + language + R"(", "questions": {"title":
        {"prompt": ")" + text +
                         R"(", "options": [{"value": ")" + value + R"(", "text": ")" + text +
                         R"("}]}}, "flow": [{"screen": ")" + text + R"("}, {"run": "main"}]})");
  };
  EXPECT_EQ(rest("en", "Hello", "yes"), rest("de", "Hallo", "yes"));
  EXPECT_NE(rest("en", "Hello", "yes"), rest("en", "Hello", "no"));
  EXPECT_EQ(without_texts(R"({"questions": {"a": {"options": ["x"]}}})"),
            without_texts(R"({"questions": {"a": {"options": [{"value": "x", "text": "y"}]}}})"));
  EXPECT_NE(without_texts(R"({"flow": [{"screen": "a"}]})"), without_texts(R"({"flow": []})"));
  EXPECT_NE(without_texts(R"({"textures": {"note": {"code": "A"}}})"),
            without_texts(R"({"textures": {"title": {"code": "A"}}})"))
      << "a texture of that name";
  EXPECT_EQ(without_texts("no JSON"), "no JSON");
}

TEST(StoredProtocol, IsOneInSeveralLanguagesAndTwoInOne) {
  const std::string english = R"({"language": "en", "title": "Choose."})";
  const std::string german = R"({"language": "de", "title": "Wählen."})";
  const std::string reworded = R"({"title": "Choose the rougher one."})";
  EXPECT_EQ(count_protocols({english, german}), 1U);
  EXPECT_EQ(count_protocols({english, reworded}), 2U) << "participants read something else";
  EXPECT_EQ(count_protocols({english, german, reworded}), 2U);
  EXPECT_EQ(count_protocols({english, R"({"language": "de", "sessions": 2})"}), 2U);
}

}  // namespace
}  // namespace asperity
