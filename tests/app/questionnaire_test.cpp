// A questionnaire with conditions in a session: what is asked and stored, resumed, verified and exported.

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/exports/export_study.h"
#include "app/session/respondents/virtual_participant.h"
#include "app/session/response_rows.h"
#include "app/tasks/verify/verify_questionnaire.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/tables/table.h"
#include "tests/app/scripted_session.h"
#include "tests/support/questions.h"

namespace asperity {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::string questioned_protocol() {
  nlohmann::json protocol = nlohmann::json::parse(small_protocol());
  protocol["factors"]["go"]["levels"] = {1};
  protocol["questions"] = nlohmann::json::parse(R"({
    "pain": {"prompt": "Does your hand hurt?", "form": "choice", "options": ["yes", "no"]},
    "strength": {"prompt": "How strong is the pain?", "form": "scale", "optional": true,
                 "scale": {"minimum": 0, "maximum": 10, "points": 11},
                 "if": {"question": "pain", "is": "yes"}},
    "kinds": {"prompt": "What kind of pain?", "form": "multiple_choice",
              "options": ["sharp", "dull", "burning"], "if": {"question": "strength", "at_least": 5}},
    "since": {"prompt": "Since when?", "form": "number", "unit": "min",
              "if": {"question": "kinds", "includes": "burning"}}
  })");
  protocol["flow"] = nlohmann::json::parse(R"([
    {"ask": ["pain", "strength", "kinds", "since"]},
    {"screen": "Please tell the experimenter.", "if": {"question": "strength", "at_least": 8}},
    {"run": "main"}, {"screen": "Thank you."}])");
  return protocol.dump();
}

class Questionnaire : public SessionTest {
 protected:
  /// Gives these answers, by question.
  void answer(std::map<std::string, FormAnswer> answers) {
    person_.at_form = [answers = std::move(answers)](const Question& question, const Wait&) {
      return answers.at(question.name);
    };
  }
  /// "kinds 1 sharp keyboard"
  std::vector<std::string> stored() const {
    std::vector<std::string> rows{};
    for (const ResponseRow& row : study_->session_answers(session_.row.id)) {
      rows.push_back(row.question + ' ' + std::to_string(row.item) + ' ' + row.answer + ' ' +
                     row.source);
    }
    return rows;
  }
  std::vector<std::string> problems() const {
    return questionnaire_problems(session_.row, protocol_,
                                  study_->session_answers(session_.row.id));
  }
};

TEST_F(Questionnaire, AsksAllWhoseConditionsAreMet) {
  begin(questioned_protocol());
  answer(
      {{"pain", {"yes"}}, {"strength", {"8"}}, {"kinds", {"sharp", "burning"}}, {"since", {"20"}}});
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_THAT(stored(),
              ElementsAre("pain 1 yes keyboard", "strength 1 8 keyboard", "kinds 1 sharp keyboard",
                          "kinds 3 burning keyboard", "since 1 20 keyboard"));
  EXPECT_EQ(study_->session_answers(session_.row.id)[1].answer_number, 8.0);
  EXPECT_EQ(study_->session_answers(session_.row.id)[4].answer_number, 20.0);
  EXPECT_THAT(person_.texts, ElementsAre("Please tell the experimenter.", "Thank you."));
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_F(Questionnaire, StoresWhatWasNotAskedOtherwiseThanWhatWasLeftEmpty) {
  begin(questioned_protocol());
  answer({{"pain", {"yes"}}, {"strength", {}}});
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_THAT(person_.forms, ElementsAre("pain", "strength"));
  EXPECT_THAT(stored(), ElementsAre("pain 1 yes keyboard", "strength 1  keyboard",
                                    "kinds 1  not_asked", "since 1  not_asked"));
  EXPECT_THAT(person_.texts, ElementsAre("Thank you."));
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_F(Questionnaire, AsksNothingThatDependsOnWhatWasNotAsked) {
  begin(questioned_protocol());
  answer({{"pain", {"no"}}});
  run();
  EXPECT_THAT(person_.forms, ElementsAre("pain"));
  EXPECT_THAT(stored(), ElementsAre("pain 1 no keyboard", "strength 1  not_asked",
                                    "kinds 1  not_asked", "since 1  not_asked"));
}

TEST_F(Questionnaire, GoesOnAfterAnInterruptionWithTheAnswersFromBefore) {
  begin(questioned_protocol());
  person_.at_form = [this](const Question& question, const Wait&) -> FormAnswer {
    if (question.name == "kinds") throw RespondentGone(Phrase("the window was closed"));
    return {question.name == "pain" ? "yes" : "9"};
  };
  EXPECT_EQ(run().state, SessionState::stopped);
  person_.forms.clear();
  answer({{"kinds", {"dull"}}});
  reopen_session();
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_THAT(person_.forms, ElementsAre("kinds"));
  EXPECT_THAT(stored(), ElementsAre("pain 1 yes keyboard", "strength 1 9 keyboard",
                                    "kinds 2 dull keyboard", "since 1  not_asked"));
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_F(Questionnaire, IsVerified) {
  begin(questioned_protocol());
  const auto row = [](const char* question, const char* answer, const char* source) {
    return ResponseRow{.question = question,
                       .answer = answer,
                       .answer_number = number_in(answer),
                       .source = source};
  };
  const auto found = [&](const std::vector<ResponseRow>& rows) {
    return questionnaire_problems(session_.row, protocol_, rows);
  };
  EXPECT_THAT(found({row("pain", "yes", "keyboard")}), IsEmpty()) << "interrupted";
  EXPECT_THAT(found({row("pain", "no", "keyboard"), row("strength", "3", "keyboard")}),
              ElementsAre(HasSubstr("question strength: it was asked, but the condition")));
  EXPECT_THAT(found({row("pain", "yes", "keyboard"), row("strength", "", "not_asked")}),
              ElementsAre(HasSubstr("it was not asked, but the answer to \"pain\" was \"yes\"")));
  EXPECT_THAT(found({row("pain", "maybe", "keyboard")}),
              ElementsAre(HasSubstr("not among the options")));
  EXPECT_THAT(found({row("pain", "", "keyboard")}), ElementsAre(HasSubstr("left empty")));
  EXPECT_THAT(found({row("hunger", "yes", "keyboard")}),
              ElementsAre(HasSubstr("no such question")));
}

class ExportedQuestionnaire : public Questionnaire {
 protected:
  std::string exported(ExportAudience audience, const std::string& table) {
    const std::filesystem::path to = folder_.path() / ("export_" + std::to_string(++exports_));
    export_study(*study_, models_, to, {.audience = audience});
    for (const auto& entry : std::filesystem::recursive_directory_iterator(to)) {
      if (entry.path().filename() == table) return read_file(entry.path());
    }
    return {};
  }

 private:
  int exports_ = 0;
};

TEST_F(ExportedQuestionnaire, HasAColumnPerOptionAndStatesWhatWasNotAsked) {
  begin(questioned_protocol());
  answer(
      {{"pain", {"yes"}}, {"strength", {"8"}}, {"kinds", {"sharp", "burning"}}, {"since", {"20"}}});
  run();
  start("p2", 8);
  answer({{"pain", {"yes"}}, {"strength", {}}});
  run();
  const std::string responses = exported(ExportAudience::own, "responses.tsv");
  EXPECT_THAT(responses, HasSubstr("not_asked"));
  const std::string codebook = exported(ExportAudience::own, "codebook.tsv");
  EXPECT_THAT(codebook, HasSubstr("session_kinds_3"));
  EXPECT_THAT(codebook, HasSubstr("session_since_asked"));
  EXPECT_THAT(codebook, HasSubstr("the option \"burning\" was chosen"));
}

TEST_F(ExportedQuestionnaire, GivesNothingAwayInPublic) {
  begin(questioned_protocol());
  answer(
      {{"pain", {"yes"}}, {"strength", {"8"}}, {"kinds", {"sharp", "burning"}}, {"since", {"20"}}});
  run();
  start("p2", 8);
  answer({{"pain", {"no"}}});
  run();
  const std::string responses = exported(ExportAudience::published, "responses.tsv");
  EXPECT_THAT(responses, Not(HasSubstr("not_asked")));
  EXPECT_THAT(responses, Not(HasSubstr("burning\t")));
  std::map<std::string, int> rows{};
  for (std::size_t at = responses.find("\tkinds\t"); at != std::string::npos;
       at = responses.find("\tkinds\t", at + 1)) {
    ++rows["kinds"];
  }
  EXPECT_EQ(rows["kinds"], 2) << "one row per participant";
}

/// All answers of 100 virtual participants, each of whom gives the same one again.
std::set<FormAnswer> virtual_answers(const Question& question) {
  const Protocol protocol{};
  std::set<FormAnswer> answers{};
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    VirtualParticipant participant(protocol, {}, {}, Random(seed));
    VirtualParticipant again(protocol, {}, {}, Random(seed));
    const std::optional<Answer> answer = participant.answer(question, [](double) {});
    const std::vector<AnsweredItem> items = items_of(question, answer.value());
    EXPECT_EQ(stored(question, again.answer(question, [](double) {})), texts_of(items));
    EXPECT_TRUE(problems_with(question, items).empty());
    answers.insert(texts_of(items));
  }
  return answers;
}

TEST(VirtualAnswers, AreRandomAndReproducible) {
  const auto of = [](Question question) {
    question.name = "asked";
    question.options = in_words({"a", "b", "c"});
    return virtual_answers(question);
  };
  EXPECT_EQ(of({.form = ChoiceForm{}}).size(), 3U);
  EXPECT_EQ(of({.form = MultipleChoiceForm{}}).size(), 7U) << "every subset but the empty one";
  EXPECT_EQ(virtual_answers({.name = "age", .form = NumberForm{.minimum = 18, .maximum = 20}}),
            (std::set<FormAnswer>{{"18"}, {"19"}, {"20"}}));
  EXPECT_EQ(virtual_answers({.name = "share", .form = NumberForm{.minimum = 0.2, .maximum = 0.4}}),
            (std::set<FormAnswer>{{"0.3"}}));
  EXPECT_EQ(virtual_answers(
                {.name = "tired", .form = ScaleForm{.minimum = 1, .maximum = 4, .points = 4}}),
            (std::set<FormAnswer>{{"1"}, {"2"}, {"3"}, {"4"}}));
}

}  // namespace
}  // namespace asperity
