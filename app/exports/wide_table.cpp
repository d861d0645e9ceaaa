#include "app/exports/wide_table.h"

#include <algorithm>
#include <optional>
#include <set>

#include <nlohmann/json.hpp>

#include "app/exports/columns/export_tables.h"
#include "app/exports/detection_table.h"
#include "results_schema/analysis_use.h"
#include "results_schema/tables/sav_file.h"

namespace asperity {

namespace {

constexpr std::size_t kSourceDigits = 8;

/// Excludes columns of the table of participants that are not needed next to responses.
bool is_about_the_person(const ExportColumn& column) { return column.type != "utc_time"; }

ExportColumn number_column(std::string name, std::string type, std::string description,
                           std::optional<double> minimum, std::optional<double> maximum,
                           std::string missing) {
  ExportColumn made{};
  made.name = std::move(name);
  made.type = std::move(type);
  made.unit = "1";
  made.description = std::move(description);
  made.minimum = minimum;
  made.maximum = maximum;
  made.missing = std::move(missing);
  return made;
}

}  // namespace

/// The names of the protocols of all columns: with the version only where there is more than one,
/// with the file only where one version has two.
class WideTable::ProtocolNames final {
 public:
  explicit ProtocolNames(const std::set<Asked>& all) {
    for (const Asked& asked : all) {
      sources_[asked.protocol][asked.version].insert(asked.source_sha256);
    }
  }

  std::string in_names(const Asked& asked) const {
    const bool has_versions = sources_.at(asked.protocol).size() > 1 || has_sources(asked);
    return asked.protocol + (has_versions ? "_" + asked.version : "") +
           (has_sources(asked) ? "_" + source_of(asked) : "");
  }
  std::string in_words(const Asked& asked) const {
    return asked.protocol + " " + asked.version +
           (has_sources(asked) ? " (source " + source_of(asked) + ")" : "");
  }

 private:
  bool has_sources(const Asked& asked) const {
    return sources_.at(asked.protocol).at(asked.version).size() > 1;
  }
  static std::string source_of(const Asked& asked) {
    return asked.source_sha256.substr(0, kSourceDigits);
  }

  std::map<std::string, std::map<std::string, std::set<std::string>>> sources_{};
};

WideTable::WideTable(const StudyVocabulary& vocabulary, ExportAudience audience)
    : audience_(audience), vocabulary_(vocabulary) {
  std::vector<ExportColumn> all = export_files(vocabulary).front().columns;
  about_ = columns_for(audience, std::move(all), left_out_);
  std::erase_if(about_, [](const ExportColumn& column) { return !is_about_the_person(column); });
}

WideTable::Asked WideTable::protocol_of(const ExportPlace& at) const {
  return {at.protocol->name,
          at.protocol->version,
          vocabulary_.first_wording.at(at.protocol->source_sha256),
          {}};
}

WideTable::Asked WideTable::asked_of(const ExportPlace& at) const {
  Asked asked = protocol_of(at);
  asked.question = at.response->question;
  return asked;
}

void WideTable::begin_participant(const ExportPlace& at) {
  Person& person = people_.emplace_back();
  for (const ExportColumn& column : about_) {
    person.about.push_back(cell_for(audience_, column, at));
  }
}

void WideTable::begin_session(const ExportPlace& at) {
  if (at.session->state != SessionState::completed) ++people_.back().unfinished;
  if (at.is_excluded_by_catch) people_.back().excluded[protocol_of(at)] = *at.is_excluded_by_catch;
}

void WideTable::add_answer(const ExportPlace& at) {
  const AnalysisUse use = use_in_analyses(*at.trial, *at.attempt);
  if (use == AnalysisUse::practice || use == AnalysisUse::anchor ||
      use == AnalysisUse::catch_trial) {
    return;
  }
  Person& person = people_.back();
  if (use != AnalysisUse::counted) {
    ++person.left_out;
    return;
  }
  if (at.response->answer_number && is_level_of_procedure(at)) {
    ++person.of_procedures;
    return;
  }
  ++person.answers;
  if (at.attempt->flagged) ++person.flagged;
  if (at.doubted_estimate) ++person.doubted;
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
  ++tally.answers;
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
  return block != vocabulary_.discriminations.end() && block->second.task.has_levels_of_procedure;
}

bool WideTable::add_discrimination(const ExportPlace& at, const Condition& condition) {
  // A task includes the prompt, which depends on the language of the file.
  const std::string& wording = vocabulary_.first_wording.at(at.protocol->source_sha256);
  const auto block = vocabulary_.discriminations.find({wording, at.trial->block});
  // A block can also ask for ratings.
  if (block == vocabulary_.discriminations.end() || at.response->answer_number) return false;
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
  discriminations_[asked_of(at)].add(
      people_.size() - 1, block->second, at.trial->block, others,
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
  Person& person = people_.back();
  const Asked asked = asked_of(at);
  const StudyVocabulary::AnswerMeaning* const meaning = meaning_of(asked);
  if (meaning != nullptr && !meaning->condition.empty()) {
    person.was_asked[asked] = response.source != kNotAsked;
  }
  if (meaning != nullptr && meaning->has_several) {
    Person::Chosen& chosen = person.chosen[asked];
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

const StudyVocabulary::AnswerMeaning* WideTable::meaning_of(const Asked& asked) const {
  const auto found = vocabulary_.questions_of_source.find({asked.source_sha256, asked.question});
  return found == vocabulary_.questions_of_source.end() ? nullptr : &found->second;
}

WideTable::Made WideTable::make() const {
  Made made{};
  made.columns = about_;
  made.left_out = left_out_;
  for (const std::string& question : withheld_) made.left_out.push_back("session_" + question);
  for (const Person& person : people_) made.rows.push_back(person.about);
  const auto add = [&](ExportColumn column, const auto& cell_of) {
    made.columns.push_back(std::move(column));
    for (std::size_t i = 0; i < people_.size(); ++i) made.rows[i].push_back(cell_of(people_[i]));
  };
  const auto count = [&](const char* name, const char* description, std::int64_t Person::*member) {
    add(number_column(name, "integer", description, 0.0, std::nullopt, "never"),
        [member](const Person& person) { return Cell{person.*member}; });
  };
  count("answers", "responses that are counted in the columns of conditions", &Person::answers);
  count("answers_flagged", "counted responses from flagged attempts", &Person::flagged);
  count("answers_left_out",
        "responses in trials of the main phase, without anchors and catch trials, that are not "
        "counted because the "
        "attempt is invalid or was excluded",
        &Person::left_out);

  const bool gives_numbers = std::any_of(people_.begin(), people_.end(), [](const Person& person) {
    return std::any_of(person.tallies.begin(), person.tallies.end(), [](const auto& asked) {
      return std::any_of(asked.second.begin(), asked.second.end(),
                         [](const auto& condition) { return condition.second.numbers > 0; });
    });
  });
  if (gives_numbers) {
    count("answers_doubted",
          "counted estimates that were re-elicited because they were at least ten times, or at "
          "most a tenth of, an earlier one for the same stimulus",
          &Person::doubted);
  }

  if (std::any_of(people_.begin(), people_.end(),
                  [](const Person& person) { return person.of_procedures > 0; })) {
    count(
        "answers_at_levels_of_procedures",
        "responses that are numbers in trials whose level was chosen from earlier responses; they "
        "are not counted, because their means would depend on the levels",
        &Person::of_procedures);
  }

  count("sessions_unfinished",
        "sessions that were not completed; their counted responses are in the columns of "
        "conditions but not in fit.tsv",
        &Person::unfinished);

  // All conditions that occurred, with their responses.
  std::map<Asked, std::map<Condition, Tally>> met{};
  struct Forms {
    bool has_numbers = false;
    bool has_texts = false;
    bool are_numbers() const noexcept { return has_numbers && !has_texts; }
  };
  std::map<Asked, Forms> said{};
  std::set<Asked> chosen_from{};
  std::set<Asked> conditional{};
  for (const Person& person : people_) {
    for (const auto& [asked, tallies] : person.tallies) {
      for (const auto& [condition, tally] : tallies) {
        Tally& all = met[asked][condition];
        all.answers += tally.answers;
        all.numbers += tally.numbers;
        all.judged += tally.judged;
        for (const auto& [option, times] : tally.chosen) all.chosen[option] += times;
      }
    }
    for (const auto& asked_and_options : person.chosen) chosen_from.insert(asked_and_options.first);
    for (const auto& asked_and_whether : person.was_asked) {
      conditional.insert(asked_and_whether.first);
    }
    for (const auto& [asked, cell] : person.said) {
      Forms& forms = said[asked];
      if (std::holds_alternative<double>(cell)) forms.has_numbers = true;
      if (std::holds_alternative<std::string>(cell)) forms.has_texts = true;
    }
  }
  std::set<Asked> all_asked{};
  for (const auto& asked_and_conditions : met) all_asked.insert(asked_and_conditions.first);
  for (const auto& asked_and_forms : said) all_asked.insert(asked_and_forms.first);
  all_asked.insert(chosen_from.begin(), chosen_from.end());
  all_asked.insert(conditional.begin(), conditional.end());
  for (const auto& asked_and_columns : discriminations_) all_asked.insert(asked_and_columns.first);
  std::set<Asked> with_rule{};
  for (const Person& person : people_) {
    for (const auto& protocol_and_decision : person.excluded) {
      with_rule.insert(protocol_and_decision.first);
    }
  }
  std::set<Asked> all_protocols = all_asked;
  all_protocols.insert(with_rule.begin(), with_rule.end());
  const ProtocolNames names_of(all_protocols);
  const auto is_asked_elsewhere = [&all_asked](const Asked& asked) {
    return std::any_of(all_asked.begin(), all_asked.end(), [&asked](const Asked& other) {
      return other != asked && other.question == asked.question;
    });
  };
  const auto column_of = [&](const Asked& asked, const std::string& what) {
    ExportColumn column{};
    column.name = "session_" + (is_asked_elsewhere(asked) ? names_of.in_names(asked) + "_" : "") +
                  asked.question;
    column.description =
        what + " " + asked.question + " of the last session with " + names_of.in_words(asked);
    if (const auto* const meaning = meaning_of(asked)) {
      column.description += ": " + meaning->prompt;
      if (!meaning->condition.empty()) column.description += "; asked if " + meaning->condition;
      column.source = meaning->source;
    }
    return column;
  };
  for (const auto& [asked, forms] : said) {
    ExportColumn column = column_of(asked, "answer to the question");
    column.type = forms.are_numbers() ? "number" : "text";
    column.missing = "not asked or not answered";
    if (const auto* const meaning = meaning_of(asked)) {
      if (forms.are_numbers()) {
        column.unit = meaning->unit;
      } else {
        column.levels = meaning->options;
        column.level_meanings = meaning->option_meanings;
      }
      column.minimum = meaning->minimum;
      column.maximum = meaning->maximum;
    }
    add(std::move(column), [&asked = asked](const Person& person) {
      const auto found = person.said.find(asked);
      return found == person.said.end() ? Cell{} : found->second;
    });
  }
  for (const Asked& asked : chosen_from) {
    const std::vector<std::string>& options = meaning_of(asked)->options;
    for (std::size_t i = 0; i < options.size(); ++i) {
      ExportColumn column =
          column_of(asked, "1: the option \"" + options[i] + "\" was chosen in the question");
      column.name += "_" + std::to_string(i + 1);
      column.type = "boolean";
      column.missing = "not asked or not answered";
      add(std::move(column), [&asked, option = static_cast<int>(i) + 1](const Person& person) {
        const auto found = person.chosen.find(asked);
        if (found == person.chosen.end() || !found->second.is_answered) return Cell{};
        return Cell{std::int64_t{found->second.options.contains(option) ? 1 : 0}};
      });
    }
  }
  for (const Asked& asked : conditional) {
    ExportColumn column = column_of(asked, "1: the condition was met and the question was asked;");
    column.name += "_asked";
    column.type = "boolean";
    column.missing = "no session reached the question";
    add(std::move(column), [&asked](const Person& person) {
      const auto found = person.was_asked.find(asked);
      if (found == person.was_asked.end()) return Cell{};
      return Cell{std::int64_t{found->second ? 1 : 0}};
    });
  }
  for (const Asked& protocol : with_rule) {
    ExportColumn column{};
    column.name = names_of.in_names(protocol) + "_excluded";
    column.description =
        "1: the rule for errors in catch trials that " + names_of.in_words(protocol) +
        " declares excludes the participant from the results of the discrimination; the columns of "
        "this participant contain all responses nevertheless";
    column.type = "boolean";
    column.missing = "no catch trial";
    add(std::move(column), [&protocol](const Person& person) {
      const auto found = person.excluded.find(protocol);
      if (found == person.excluded.end()) return Cell{};
      return Cell{std::int64_t{found->second ? 1 : 0}};
    });
  }
  for (const auto& [asked, discrimination] : discriminations_) {
    const auto meaning = vocabulary_.questions.find(asked.question);
    const std::string prompt = meaning == vocabulary_.questions.end()
                                   ? asked.question
                                   : "\"" + meaning->second.prompt + "\"";
    for (ThresholdColumns::Column& made_column :
         discrimination.make(names_of.in_names(asked) + "_" + asked.question,
                             " of " + names_of.in_words(asked) + ", " + prompt)) {
      made.columns.push_back(std::move(made_column.column));
      const bool is_count = made.columns.back().type == "integer";
      for (std::size_t i = 0; i < people_.size(); ++i) {
        const auto cell = made_column.cells.find(i);
        made.rows[i].push_back(cell != made_column.cells.end() ? cell->second
                               : is_count                      ? Cell{std::int64_t{0}}
                                                               : Cell{});
      }
    }
  }
  for (const auto& [asked, conditions] : met) {
    const std::string protocol_in_name = names_of.in_names(asked);
    const std::string protocol_in_words = names_of.in_words(asked);
    std::map<std::string, std::set<Level>> levels{};
    std::set<std::string> options{};
    bool numbers = true;
    bool judged = false;
    for (const auto& [condition, tally] : conditions) {
      for (const auto& [factor, level] : condition) levels[factor].insert(level);
      for (const auto& [option, times] : tally.chosen) options.insert(option);
      numbers = numbers && tally.numbers == tally.answers;
      judged = judged || tally.judged > 0;
    }
    const auto meaning = vocabulary_.questions.find(asked.question);
    const std::string prompt = meaning == vocabulary_.questions.end()
                                   ? asked.question
                                   : "\"" + meaning->second.prompt + "\"";
    if (judged && !numbers && conditions.size() > 1) {
      const std::string name = protocol_in_name + "_" + asked.question;
      const std::string of =
          " of " + protocol_in_words + ", " + prompt + ", all conditions together";
      const auto total_of = [asked = asked](const Person& person) {
        Tally total{};
        const auto of_question = person.tallies.find(asked);
        if (of_question == person.tallies.end()) return total;
        for (const auto& [condition, tally] : of_question->second) {
          total.answers += tally.answers;
          total.judged += tally.judged;
          total.right += tally.right;
        }
        return total;
      };
      add(number_column(name + "_correct", "number", "proportion correct" + of, 0.0, 1.0,
                        "no such response"),
          [&](const Person& person) {
            const Tally total = total_of(person);
            if (total.judged == 0) return Cell{};
            return Cell{static_cast<double>(total.right) / static_cast<double>(total.judged)};
          });
      add(number_column(name + "_n", "integer", "number of responses" + of, 0.0, std::nullopt,
                        "never"),
          [&](const Person& person) { return Cell{total_of(person).answers}; });
    }
    for (const auto& condition_and_tally : conditions) {
      const Condition& condition = condition_and_tally.first;
      std::string name = protocol_in_name + "_" + asked.question;
      std::string when{};
      for (const auto& [factor, level] : condition) {
        if (levels.at(factor).size() < 2) continue;
        name += "_" + level.second;
        when += (when.empty() ? " where " : ", ") + factor + " = " + level.second;
      }
      const std::string of = " of " + protocol_in_words + ", " + prompt + when;
      const auto tally_of = [asked = asked, condition](const Person& person) -> const Tally* {
        const auto of_question = person.tallies.find(asked);
        if (of_question == person.tallies.end()) return nullptr;
        const auto found = of_question->second.find(condition);
        return found == of_question->second.end() ? nullptr : &found->second;
      };
      const auto share = [&](std::string column, std::string description, const auto& part) {
        add(number_column(std::move(column), "number", std::move(description), 0.0, 1.0,
                          "no such response"),
            [&](const Person& person) {
              const Tally* const tally = tally_of(person);
              if (tally == nullptr) return Cell{};
              const auto [hits, all] = part(*tally);
              return all == 0 ? Cell{} : Cell{static_cast<double>(hits) / static_cast<double>(all)};
            });
      };
      if (numbers) {
        add(number_column(name + "_mean", "number", "mean response" + of, std::nullopt,
                          std::nullopt, "no such response"),
            [&](const Person& person) {
              const Tally* const tally = tally_of(person);
              if (tally == nullptr) return Cell{};
              return Cell{tally->sum / static_cast<double>(tally->numbers)};
            });
      } else if (judged) {
        share(name + "_correct", "proportion correct" + of,
              [](const Tally& tally) { return std::pair(tally.right, tally.judged); });
      } else {
        for (const std::string& option : options) {
          share(name + "_" + option, "proportion of responses \"" + option + "\"" + of,
                [&option](const Tally& tally) {
                  const auto found = tally.chosen.find(option);
                  return std::pair(found == tally.chosen.end() ? 0 : found->second, tally.answers);
                });
        }
      }
      add(number_column(name + "_n", "integer", "number of responses" + of, 0.0, std::nullopt,
                        "never"),
          [&](const Person& person) {
            const Tally* const tally = tally_of(person);
            return Cell{tally == nullptr ? std::int64_t{0} : tally->answers};
          });
    }
  }
  std::vector<std::string> names{};
  for (const ExportColumn& column : made.columns) names.push_back(column.name);
  names = sav_names(names);
  for (std::size_t i = 0; i < names.size(); ++i) made.columns[i].name = names[i];
  return made;
}

}  // namespace asperity
