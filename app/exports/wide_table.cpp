// Builds the table with one row for each participant.

#include "app/exports/wide_table.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/exports/columns/export_tables.h"
#include "app/exports/detection_table.h"
#include "results_schema/analysis_use.h"

namespace asperity {

namespace {

/// Excludes columns of the table of participants that are not needed next to responses.
bool is_about_the_person(const ExportColumn& column) { return column.type != "utc_time"; }

}  // namespace

WideTable::WideTable(const StudyVocabulary& vocabulary, ExportAudience audience)
    : audience_(audience), vocabulary_(vocabulary) {
  std::vector<ExportColumn> all = export_files(vocabulary).front().columns;
  about_ = columns_for(audience, std::move(all), left_out_);
  std::erase_if(about_, [](const ExportColumn& column) { return !is_about_the_person(column); });
}

WideAnswers::Asked WideTable::protocol_of(const ExportPlace& at) const {
  return {at.protocol->name,
          at.protocol->version,
          vocabulary_.first_wording.at(at.protocol->source_sha256),
          {}};
}

WideAnswers::Asked WideTable::asked_of(const ExportPlace& at) const {
  Asked asked = protocol_of(at);
  asked.question = at.response->question;
  return asked;
}

void WideTable::begin_participant(const ExportPlace& at) {
  Person& person = gathered_.people.emplace_back();
  for (const ExportColumn& column : about_) {
    person.about.push_back(cell_for(audience_, column, at));
  }
}

void WideTable::begin_session(const ExportPlace& at) {
  if (at.session->state != SessionState::completed) ++gathered_.people.back().unfinished;
  if (at.is_excluded_by_catch)
    gathered_.people.back().excluded[protocol_of(at)] = *at.is_excluded_by_catch;
}

void WideTable::add_answer(const ExportPlace& at) {
  if (at.response->source == kNotAsked || vocabulary_.is_free_text(at.response->question)) return;
  const AnalysisUse use = use_in_analyses(*at.trial, *at.attempt);
  if (use == AnalysisUse::practice || use == AnalysisUse::anchor ||
      use == AnalysisUse::catch_trial) {
    return;
  }
  Person& person = gathered_.people.back();
  if (use != AnalysisUse::counted) {
    ++person.left_out;
    return;
  }
  if (is_level_of_procedure(at)) {
    ++person.of_procedures;
    return;
  }
  // The proportions are of the trials in which an option was among those chosen.
  const Counted counted{at.session->id, at.attempt->trial, at.attempt->attempt,
                        at.response->question};
  const bool is_further_option = vocabulary_.has_several_answers(at.response->question) &&
                                 std::exchange(last_counted_, counted) == counted;
  if (!is_further_option) {
    ++person.answers;
    if (at.attempt->flagged) ++person.flagged;
    if (at.doubted_estimate) ++person.doubted;
  }
  Condition condition{};
  const auto group_factor = vocabulary_.group_factors.find(at.protocol->source_sha256);
  for (const auto& [name, level] : at.factors->items()) {
    // It tells participants apart, not the responses of one: it is the column "group".
    if (group_factor != vocabulary_.group_factors.end() && group_factor->second == name) continue;
    const bool is_number = level.is_number();
    const double value = is_number ? level.get<double>() : 0.0;
    condition.emplace_back(name, Level{value, is_number           ? text_of_number(value)
                                              : level.is_string() ? level.get<std::string>()
                                                                  : level.dump()});
  }
  if (add_discrimination(at, condition)) return;
  mark_signal(at, condition);
  const ResponseRow& response = *at.response;
  Tally& tally = person.tallies[asked_of(at)][condition];
  if (!is_further_option) ++tally.answers;
  ++tally.chosen[response.answer];
  if (response.answer_number) {
    ++tally.numbers;
    tally.sum += *response.answer_number;
  }
  if (response.correct) {
    ++tally.judged;
    tally.right += *response.correct ? 1 : 0;
  }
}

void WideTable::mark_signal(const ExportPlace& at, Condition& condition) const {
  const auto block =
      vocabulary_.discriminations.find({at.protocol->source_sha256, at.trial->block});
  if (block == vocabulary_.discriminations.end()) return;
  const DiscriminationTask& task = block->second.task;
  if (!task.design->has_noise()) return;
  const bool is_signal = task.design->is_signal(comparisons_in(*at.attempt));
  if (!is_signal) {  // the levels of the others are those of trials with a signal
    std::erase_if(condition,
                  [&task](const auto& each) { return each.first == task.varied.factor; });
  }
  const bool is_pair = task.design->surfaces() > 1;
  condition.insert(condition.begin(), {"trials", Level{is_signal ? 1.0 : 0.0,
                                                       is_signal ? is_pair ? "different" : "signal"
                                                       : is_pair ? "same"
                                                                 : "noise"}});
}

bool WideTable::is_level_of_procedure(const ExportPlace& at) const {
  if (!at.trial->track) return false;
  const std::string& wording = vocabulary_.first_wording.at(at.protocol->source_sha256);
  const auto block = vocabulary_.discriminations.find({wording, at.trial->block});
  return block != vocabulary_.discriminations.end() && block->second.task.has_levels_of_procedure &&
         block->second.task.question != at.response->question;
}

bool WideTable::add_discrimination(const ExportPlace& at, const Condition& condition) {
  // A task includes the prompt, which depends on the language of the file.
  const std::string& wording = vocabulary_.first_wording.at(at.protocol->source_sha256);
  const auto block = vocabulary_.discriminations.find({wording, at.trial->block});
  // A block can also ask for ratings, and have additional questions.
  if (block == vocabulary_.discriminations.end() ||
      at.response->question != block->second.task.question) {
    return false;
  }
  const DiscriminationTask& task = block->second.task;
  const std::vector<std::string>& drawn = block->second.drawn;
  ThresholdColumns::Condition others{};
  std::optional<double> value{};
  for (const auto& each : condition) {
    if (each.first == task.varied.factor) {
      value = each.second.first;
    } else if (std::find(drawn.begin(), drawn.end(), each.first) == drawn.end()) {
      others.push_back(each);
    }
  }
  if (!value) return false;
  const std::size_t comparisons = comparisons_in(*at.attempt);
  if (task.design->has_noise() && !task.design->is_signal(comparisons)) value = task.standard();
  gathered_.discriminations[asked_of(at)].add(
      gathered_.people.size() - 1, block->second, at.trial->block, others,
      {.value = *value,
       .chose_comparison = is_hit_response(task, comparisons, at.response->answer),
       .is_unsure = at.response->answer == kCannotTell,
       .by_procedure = at.trial->track && task.has_levels_of_procedure,
       .session = at.session->session,
       .block_ordinal = at.trial->block_ordinal,
       .track = at.trial->track.value_or(0),
       .step = at.trial->step.value_or(0),
       .session_is_unfinished = at.session->state != SessionState::completed});
  return true;
}

void WideTable::add_session_answer(const ExportPlace& at) {
  const ResponseRow& response = *at.response;
  if (is_public(audience_) && at.response_is_withheld) {
    withheld_.insert(response.question);
    return;
  }
  Person& person = gathered_.people.back();
  const Asked asked = asked_of(at);
  const StudyVocabulary::AnswerMeaning* const meaning =
      vocabulary_.meaning_of(asked.source_sha256, asked.question);
  if (meaning != nullptr && !meaning->condition.empty()) {
    person.was_asked[asked] = response.source != kNotAsked;
  }
  if (meaning != nullptr && meaning->has_several) {
    WideAnswers::Chosen& chosen = person.chosen[asked];
    if (chosen.session_id != at.session->id) chosen = {.session_id = at.session->id};
    chosen.is_answered = !response.answer.empty();
    if (chosen.is_answered) chosen.options.insert(response.item);
    return;
  }
  // An earlier session may have had an answer.
  person.said[asked] = response.answer_number    ? Cell{*response.answer_number}
                       : response.answer.empty() ? Cell{}
                                                 : Cell{response.answer};
}

WideTable::Made WideTable::make() const {
  Made made{.table = wide_columns(gathered_, about_, vocabulary_), .left_out = left_out_};
  for (const std::string& question : withheld_) made.left_out.push_back("session_" + question);
  return made;
}

}  // namespace asperity
