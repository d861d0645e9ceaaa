// How the form words problems: labels for keys, its own units, and the language of the windows.

#include "app/gui/base/form_words.h"

#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "app/gui/base/settings.h"
#include "protocols/file/diagnostic.h"
#include "protocols/file/protocol_problems.h"
#include "protocols/keys/form_sentences.h"
#include "renderers/built_in_models.h"
#include "renderers/force/force_model.h"
#include "tests/gui/editor/library_text.h"
#include "tests/support/replaced.h"

namespace asperity {
namespace {

using testing::HasSubstr;

class WordsOfForm : public testing::Test {
 protected:
  ~WordsOfForm() override { apply_language("en"); }

  /// The problem at the place of a text, as the form words it.
  static std::string problem_at(const std::string& text, std::string_view pointer) {
    const ProtocolReading reading =
        read_protocol_with_problems(text, "p.json", declarations_of(built_in_models()));
    for (const Diagnostic& problem : reading.problems) {
      if (problem.pointer != pointer) continue;
      return sentence_in_form(nlohmann::json::parse(text), problem).toStdString();
    }
    ADD_FAILURE() << "no problem at " << pointer;
    return {};
  }
  static std::string jnd_with(const std::string& from, const std::string& to) {
    return replaced(library_text("amplitude_jnd"), from, to);
  }
};

TEST_F(WordsOfForm, ShowNumbersInTheUnitOfTheForm) {
  const std::string text = jnd_with("\"edge_width_m\": 0.005", "\"edge_width_m\": -2.5");
  EXPECT_EQ(problem_at(text, "/surface/edge_width_m"),
            "−2500\u00a0mm is too small: it must be at least 0\u00a0mm")
      << "the form shows the meaning elsewhere";
  apply_language("de");
  EXPECT_EQ(problem_at(text, "/surface/edge_width_m"),
            "−2500\u00a0mm ist zu klein: Der Wert muss mindestens 0\u00a0mm sein");
}

TEST_F(WordsOfForm, StateThePermittedNumbersForAText) {
  EXPECT_THAT(
      problem_at(jnd_with("\"edge_width_m\": 0.005", "\"edge_width_m\": \"wide\""),
                 "/surface/edge_width_m"),
      testing::StartsWith("\"wide\" is not permitted here: write a number from 0\u00a0mm to "));
  EXPECT_EQ(problem_at(jnd_with("\"edge_width_m\": 0.005", "\"edge_width_m\": \"0.005\""),
                       "/surface/edge_width_m"),
            "\"0.005\" is not permitted here: write a number, without quotation marks");
}

TEST_F(WordsOfForm, ShowANumberThatIsOneOfSeveralFormsWithItsUnit) {
  nlohmann::json file = nlohmann::json::parse(library_text("amplitude_jnd"));
  file["blocks"]["main"]["arrangement"]["interval_s"] = -1;
  EXPECT_THAT(problem_at(file.dump(1), "/blocks/main/arrangement/interval_s"),
              testing::StartsWith("−1\u00a0s is too small: it must be at least 0\u00a0s"));
}

TEST_F(WordsOfForm, LeaveOutTheUnitsOfTheFile) {
  const std::string text = jnd_with("\"edge_width_m\": 0.005", "\"edge_width_m\": 5");
  const std::string sentence = problem_at(text, "/surface/edge_width_m");
  EXPECT_THAT(sentence, HasSubstr("5000\u00a0mm is too large"));
  EXPECT_THAT(sentence, testing::Not(HasSubstr("metres")));
}

TEST_F(WordsOfForm, NameKeysByTheirLabelsInGerman) {
  apply_language("de");
  const std::string text = jnd_with("\"edge_width_m\"", "\"edge_with_m\"");
  EXPECT_THAT(problem_at(text, "/surface/edge_with_m"),
              HasSubstr("es gibt hier keine Einstellung \"edge_with_m\"; gemeint ist vielleicht "));
  const std::string without = jnd_with("\"model\": \"sinusoid\", ", "");
  EXPECT_THAT(problem_at(without, "/stimuli/grating/model"),
              HasSubstr("die Einstellung „Kraftmodell“ fehlt"));
}

TEST_F(WordsOfForm, NameWordsOfChoicesAsChoicesShowThem) {
  const std::string text =
      jnd_with("\"on_failure\": \"flag\"", "\"on_failure\": \"flag\", \"maximum_repeats\": 2");
  EXPECT_THAT(problem_at(text, "/explorations/stroking/maximum_repeats"),
              testing::EndsWith("is “flag”; choose “repeat now” or “requeue at end of block”"));
  apply_language("de");
  EXPECT_THAT(problem_at(text, "/explorations/stroking/maximum_repeats"),
              AllOf(HasSubstr("„markieren“"), HasSubstr("„sofort wiederholen“"),
                    HasSubstr("„am Blockende wiederholen“")));
}

TEST_F(WordsOfForm, StateTheMeaningOnlyWhereNoFieldIsNextToIt) {
  const nlohmann::json file = nlohmann::json::parse(library_text("amplitude_jnd"));
  const Diagnostic missing{.pointer = "/stimuli/grating/model",
                           .message = missing_key("model", "The force model.")};
  EXPECT_EQ(sentence_in_form(file, missing).toStdString(),
            "the setting “Force model” is missing; add it");
  EXPECT_THAT(remark_in_form(file, missing).toStdString(),
              testing::EndsWith("is missing; add it. Expected here: The force model."));
  const Diagnostic wrong{.pointer = "/stimuli/grating/model",
                         .message = wrong_pattern("a b", "A name of letters.")};
  EXPECT_EQ(
      sentence_in_form(file, wrong).toStdString(),
      "\"a b\" does not have the required form; correct it. Expected here: A name of letters.");
}

TEST_F(WordsOfForm, NameTheKeysAndWordsOfAMeaningByTheirLabels) {
  EXPECT_EQ(meaning_in_form("At least `correct` of the last `of_last`."),
            "At least “Correct responses” of the last “Responses considered”.");
  EXPECT_EQ(meaning_in_form("only with the judgement `comparison`"),
            "only with the judgement “comparison”");
  EXPECT_EQ(meaning_in_form("A mesh made by `asperity bake`."), "A mesh made by `asperity bake`.");
}

}  // namespace
}  // namespace asperity
