// Declares the columns of responses.tsv, and lists all questions with their options in a description.

#include <string>
#include <utility>

#include "app/exports/columns/column_making.h"
#include "app/exports/columns/table_columns.h"

namespace asperity::export_columns {
namespace {

using Place = ExportPlace;

}  // namespace

Columns response_columns(const StudyVocabulary& vocabulary) {
  Columns columns = keys_to(Key::attempt);
  for (ExportColumn& made : columns) {
    if (made.name == "trial" || made.name == "attempt") {
      made.missing = "the question belongs to the session, not to a trial";
    }
  }
  const auto add = [&columns](ExportColumn made) { columns.push_back(std::move(made)); };
  add(column("question", "text", "", "name of the question",
             [](const Place& at) { return at.response->question; }));
  add(at_least(1,
               column("item", "integer", "",
                      "1; the position of the surface for an assignment; the number of the chosen "
                      "option for a multiple choice, which has one row per chosen option",
                      [](const Place& at) { return integer(at.response->item); })));
  columns.back().publication = Publication::without_questionnaires;
  columns.back().missing = "the response is an answer to a questionnaire in a public export";
  std::string questions{};
  for (const auto& [name, question] : vocabulary.questions) {
    questions += (questions.empty() ? "; " : " · ") + name + ": " + question.prompt;
    if (!question.unit.empty()) questions += " in " + question.unit;
    if (!question.condition.empty()) questions += ", asked if " + question.condition;
    std::string options{};
    for (const std::string& option : question.options) {
      options += (options.empty() ? " (" : " | ") + option;
    }
    if (!options.empty()) questions += options + ")";
  }
  add(column("answer", "text", "", "the response, by its name in the protocol" + questions,
             [](const Place& at) { return at.response->answer; }));
  columns.back().publication = Publication::without_questionnaires;
  columns.back().missing =
      "a question of a questionnaire was left empty, or a question was not asked (see source), or "
      "the response is an answer to a questionnaire, or free text, in a public export";
  add(missing("the response is not a number, or is an answer to a questionnaire in a public export",
              column("answer_number", "number", "",
                     "the response as a number: an estimate, a point of a scale, or a number in "
                     "a questionnaire",
                     [](const Place& at) { return optional_cell(at.response->answer_number); })));
  columns.back().publication = Publication::without_questionnaires;
  add(missing("the protocol declares no correct response",
              column("correct", "boolean", "", "1: correct response",
                     [](const Place& at) { return optional_boolean(at.response->correct); })));
  add(column("options_json", "json", "", "the options in the order in which they were shown",
             [](const Place& at) { return at.response->options_json; }));
  add(column("time_s", "number", "s", "time of the response, since the session began",
             [](const Place& at) { return seconds_in_session(at, at.response->time_ns); }));
  columns.back().publication = Publication::without_questionnaires;
  columns.back().missing = "the response is an answer to a questionnaire in a public export";
  add(missing("there was no contact before the response",
              at_least(0, column("from_contact_s", "number", "s",
                                 "time from the first contact of the attempt to the response",
                                 [](const Place& at) {
                                   return optional_cell(at.response->from_contact_s);
                                 }))));
  add(missing(
      "not measured, not asked, or an answer to a questionnaire in a public export",
      at_least(0, column("from_cue_s", "number", "s",
                         "time from the cue, when the question was first asked, to the response",
                         [](const Place& at) { return optional_cell(at.response->from_cue_s); }))));
  columns.back().publication = Publication::without_questionnaires;
  add(column("source", "text", "",
             "how the response was given: keyboard; virtual, by a virtual participant; "
             "virtual_guess, by one that ignores the surface or has no expectation; not_asked, a "
             "question whose condition was not met",
             [](const Place& at) { return at.response->source; }));
  // That a question was not asked states something about the answer on which it depends.
  columns.back().publication = Publication::without_questionnaires;
  columns.back().missing = "the response is an answer to a questionnaire in a public export";
  add(missing(
      "the estimate was not re-elicited",
      column(
          "doubted_estimate", "number", "",
          "the first estimate, which was re-elicited because it was at least ten times, or at most "
          "a tenth of, an earlier one for the same stimulus; the response is the second estimate",
          [](const Place& at) { return optional_cell(at.doubted_estimate); })));
  add(missing(
      "the response is not a magnitude estimate, or the participant has a cell without estimates",
      column("normalised_estimate", "number", "",
             "the magnitude estimate with the participant's own scale removed: multiplied by the "
             "geometric mean of all participants and divided by that of the participant; both of "
             "this protocol, version and kind of session, over valid attempts of the main "
             "phase, without excluded attempts, anchors and catch trials",
             [](const Place& at) -> Cell {
               if (!at.own_scale || !at.response->answer_number) return {};
               return *at.own_scale * *at.response->answer_number;
             })));
  return columns;
}

}  // namespace asperity::export_columns
