// A column is made where the responses of any participant need it.

#include "app/exports/wide_columns.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "results_schema/tables/sav_file.h"

namespace asperity {

namespace {

constexpr std::size_t kSourceDigits = 8;

using Asked = WideAnswers::Asked;
using Chosen = WideAnswers::Chosen;
using Condition = WideAnswers::Condition;
using Level = WideAnswers::Level;
using Person = WideAnswers::Person;
using Tally = WideAnswers::Tally;

template <typename Value>
const Value* found_in(const std::map<Asked, Value>& all, const Asked& asked) {
  const auto found = all.find(asked);
  return found == all.end() ? nullptr : &found->second;
}

Cell yes_or_no(bool yes) { return Cell{std::int64_t{yes ? 1 : 0}}; }

Cell proportion(std::int64_t part, std::int64_t all) {
  return all == 0 ? Cell{} : Cell{static_cast<double>(part) / static_cast<double>(all)};
}

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

ExportColumn count_column(std::string name, std::string description) {
  return number_column(std::move(name), "integer", std::move(description), 0.0, std::nullopt,
                       "never");
}

ExportColumn proportion_column(std::string name, std::string description) {
  return number_column(std::move(name), "number", std::move(description), 0.0, 1.0,
                       "no such response");
}

/// The names of the protocols of all columns: with the version only where there is more than one,
/// with the file only where one version has two.
class ProtocolNames final {
 public:
  void add(const Asked& asked) {
    sources_[asked.protocol][asked.version].insert(asked.source_sha256);
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

class WideColumnMaker final {
 public:
  WideColumnMaker(const WideAnswers& answers, std::vector<ExportColumn> about,
                  const StudyVocabulary& vocabulary)
      : answers_(answers), vocabulary_(vocabulary), made_{.columns = std::move(about)} {
    for (const Person& person : answers.people) {
      made_.rows.push_back(person.about);
      for (const auto& [asked, tallies] : person.tallies) {
        for (const auto& [condition, tally] : tallies) of_all_[asked][condition].add(tally);
      }
      for (const auto& [asked, cell] : person.said) {
        Forms& forms = said_[asked];
        if (std::holds_alternative<double>(cell)) forms.has_numbers = true;
        if (std::holds_alternative<std::string>(cell)) forms.has_texts = true;
      }
      for (const auto& asked_and_options : person.chosen) chosen_.insert(asked_and_options.first);
      for (const auto& asked_and_whether : person.was_asked) {
        conditional_.insert(asked_and_whether.first);
      }
      for (const auto& asked_and_decision : person.excluded) {
        with_rule_.insert(asked_and_decision.first);
      }
    }
    for (const auto& asked_and_conditions : of_all_) take(asked_and_conditions.first);
    for (const auto& asked_and_forms : said_) take(asked_and_forms.first);
    for (const auto& asked_and_columns : answers.discriminations) take(asked_and_columns.first);
    for (const Asked& asked : chosen_) take(asked);
    for (const Asked& asked : conditional_) take(asked);
    for (const Asked& protocol : with_rule_) names_.add(protocol);
  }

  WideColumns made() && {
    add_counts();
    add_session_answers();
    add_options_chosen();
    add_conditions_met();
    add_exclusions();
    add_thresholds();
    for (const auto& [asked, conditions] : of_all_) add_averages(asked, conditions);
    std::vector<std::string> names{};
    for (const ExportColumn& column : made_.columns) names.push_back(column.name);
    names = sav_names(names);
    for (std::size_t i = 0; i < names.size(); ++i) made_.columns[i].name = names[i];
    return std::move(made_);
  }

 private:
  struct Forms {
    bool has_numbers = false;
    bool has_texts = false;
    bool are_numbers() const noexcept { return has_numbers && !has_texts; }
  };

  void take(const Asked& asked) {
    names_.add(asked);
    protocols_asking_[asked.question].insert(asked);
  }

  template <typename CellOf>
  void add(ExportColumn column, const CellOf& cell_of) {
    made_.columns.push_back(std::move(column));
    for (std::size_t i = 0; i < made_.rows.size(); ++i) {
      made_.rows[i].push_back(cell_of(answers_.people[i]));
    }
  }

  void add_count(const char* name, const char* description, std::int64_t Person::*count) {
    add(count_column(name, description),
        [count](const Person& person) { return Cell{person.*count}; });
  }

  void add_counts() {
    add_count("answers", "responses that are counted in the columns of conditions",
              &Person::answers);
    add_count("answers_flagged", "counted responses from flagged attempts", &Person::flagged);
    add_count("answers_left_out",
              "responses in trials of the main phase, without anchors and catch trials, that are "
              "not counted because the attempt is invalid or was excluded",
              &Person::left_out);
    const auto has_numbers = [](const auto& condition) { return condition.second.numbers > 0; };
    if (std::any_of(of_all_.begin(), of_all_.end(), [&](const auto& asked) {
          return std::any_of(asked.second.begin(), asked.second.end(), has_numbers);
        })) {
      add_count("answers_doubted",
                "counted estimates that were re-elicited because they were at least ten times, or "
                "at most a tenth of, an earlier one for the same stimulus",
                &Person::doubted);
    }
    if (std::any_of(answers_.people.begin(), answers_.people.end(),
                    [](const Person& person) { return person.of_procedures > 0; })) {
      add_count("answers_at_levels_of_procedures",
                "responses that are numbers in trials whose level was chosen from earlier "
                "responses; they are not counted, because their means would depend on the levels",
                &Person::of_procedures);
    }
    add_count("sessions_unfinished",
              "sessions that were not completed; their counted responses are in the columns of "
              "conditions but not in fit.tsv",
              &Person::unfinished);
  }

  const StudyVocabulary::AnswerMeaning* meaning_of(const Asked& asked) const {
    return vocabulary_.meaning_of(asked.source_sha256, asked.question);
  }

  ExportColumn session_column(const Asked& asked, const std::string& what, const char* type,
                              const char* missing) const {
    ExportColumn column{};
    const bool is_asked_elsewhere = protocols_asking_.at(asked.question).size() > 1;
    column.name =
        "session_" + (is_asked_elsewhere ? names_.in_names(asked) + "_" : "") + asked.question;
    column.description =
        what + " " + asked.question + " of the last session with " + names_.in_words(asked);
    if (const auto* const meaning = meaning_of(asked)) {
      column.description += ": " + meaning->prompt;
      if (!meaning->condition.empty()) column.description += "; asked if " + meaning->condition;
      column.source = meaning->source;
    }
    column.type = type;
    column.missing = missing;
    return column;
  }

  void add_session_answers() {
    for (const auto& [asked, forms] : said_) {
      ExportColumn column =
          session_column(asked, "answer to the question", forms.are_numbers() ? "number" : "text",
                         "not asked or not answered");
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
        const Cell* const said = found_in(person.said, asked);
        return said == nullptr ? Cell{} : *said;
      });
    }
  }

  void add_options_chosen() {
    for (const Asked& asked : chosen_) {
      const std::vector<std::string>& options = meaning_of(asked)->options;
      for (std::size_t i = 0; i < options.size(); ++i) {
        ExportColumn column =
            session_column(asked, "1: the option \"" + options[i] + "\" was chosen in the question",
                           "boolean", "not asked or not answered");
        column.name += "_" + std::to_string(i + 1);
        add(std::move(column), [&asked, option = static_cast<int>(i) + 1](const Person& person) {
          const Chosen* const chosen = found_in(person.chosen, asked);
          if (chosen == nullptr || !chosen->is_answered) return Cell{};
          return yes_or_no(chosen->options.contains(option));
        });
      }
    }
  }

  void add_conditions_met() {
    for (const Asked& asked : conditional_) {
      ExportColumn column =
          session_column(asked, "1: the condition was met and the question was asked;", "boolean",
                         "no session reached the question");
      column.name += "_asked";
      add(std::move(column), [&asked](const Person& person) {
        const bool* const was_asked = found_in(person.was_asked, asked);
        return was_asked == nullptr ? Cell{} : yes_or_no(*was_asked);
      });
    }
  }

  void add_exclusions() {
    for (const Asked& protocol : with_rule_) {
      ExportColumn column{};
      column.name = names_.in_names(protocol) + "_excluded";
      column.description =
          "1: the rule for errors in catch trials that " + names_.in_words(protocol) +
          " declares excludes the participant from the results of the discrimination; the columns "
          "of this participant contain all responses nevertheless";
      column.type = "boolean";
      column.missing = "no catch trial";
      add(std::move(column), [&protocol](const Person& person) {
        const bool* const excluded = found_in(person.excluded, protocol);
        return excluded == nullptr ? Cell{} : yes_or_no(*excluded);
      });
    }
  }

  std::string prompt_of(const Asked& asked) const {
    const auto meaning = vocabulary_.questions.find(asked.question);
    return meaning == vocabulary_.questions.end() ? asked.question
                                                  : "\"" + meaning->second.prompt + "\"";
  }
  std::string name_of(const Asked& asked) const {
    return names_.in_names(asked) + "_" + asked.question;
  }
  std::string words_of(const Asked& asked) const {
    return " of " + names_.in_words(asked) + ", " + prompt_of(asked);
  }

  void add_thresholds() {
    for (const auto& [asked, discrimination] : answers_.discriminations) {
      for (ThresholdColumns::Column& made : discrimination.make(name_of(asked), words_of(asked))) {
        made_.columns.push_back(std::move(made.column));
        const bool is_count = made_.columns.back().type == "integer";
        for (std::size_t i = 0; i < made_.rows.size(); ++i) {
          const auto cell = made.cells.find(i);
          made_.rows[i].push_back(cell != made.cells.end() ? cell->second
                                  : is_count               ? Cell{std::int64_t{0}}
                                                           : Cell{});
        }
      }
    }
  }

  void add_averages(const Asked& asked, const std::map<Condition, Tally>& conditions) {
    std::map<std::string, std::set<Level>> levels{};
    bool are_numbers = true;
    Tally all{};
    for (const auto& [condition, tally] : conditions) {
      for (const auto& [factor, level] : condition) levels[factor].insert(level);
      are_numbers = are_numbers && tally.numbers == tally.answers;
      all.add(tally);
    }
    if (all.judged > 0 && !are_numbers && conditions.size() > 1) add_total(asked);
    for (const auto& condition_and_tally : conditions) {
      const Condition& condition = condition_and_tally.first;
      std::string name = name_of(asked);
      std::string when{};
      for (const auto& [factor, level] : condition) {
        if (levels.at(factor).size() < 2) continue;
        name += "_" + level.second;
        when += (when.empty() ? " where " : ", ") + factor + " = " + level.second;
      }
      const std::string of = words_of(asked) + when;
      static const Tally kNone{};
      const auto tally_of = [&](const Person& person) -> const Tally& {
        const auto* const tallies = found_in(person.tallies, asked);
        if (tallies == nullptr) return kNone;
        const auto found = tallies->find(condition);
        return found == tallies->end() ? kNone : found->second;
      };
      if (are_numbers) {
        add(number_column(name + "_mean", "number", "mean response" + of, std::nullopt,
                          std::nullopt, "no such response"),
            [&](const Person& person) {
              const Tally& tally = tally_of(person);
              return tally.numbers == 0 ? Cell{}
                                        : Cell{tally.sum / static_cast<double>(tally.numbers)};
            });
      } else if (all.judged > 0) {
        add(proportion_column(name + "_correct", "proportion correct" + of),
            [&](const Person& person) {
              const Tally& tally = tally_of(person);
              return proportion(tally.right, tally.judged);
            });
      } else {
        for (const auto& option_and_times : all.chosen) {
          const std::string& option = option_and_times.first;
          add(proportion_column(name + "_" + option,
                                "proportion of responses \"" + option + "\"" + of),
              [&](const Person& person) {
                const Tally& tally = tally_of(person);
                const auto times = tally.chosen.find(option);
                return proportion(times == tally.chosen.end() ? 0 : times->second, tally.answers);
              });
        }
      }
      add(count_column(name + "_n", "number of responses" + of),
          [&](const Person& person) { return Cell{tally_of(person).answers}; });
    }
  }

  void add_total(const Asked& asked) {
    const std::string name = name_of(asked);
    const std::string of = words_of(asked) + ", all conditions together";
    const auto total_of = [&asked](const Person& person) {
      Tally total{};
      if (const auto* const tallies = found_in(person.tallies, asked)) {
        for (const auto& condition_and_tally : *tallies) total.add(condition_and_tally.second);
      }
      return total;
    };
    add(proportion_column(name + "_correct", "proportion correct" + of), [&](const Person& person) {
      const Tally total = total_of(person);
      return proportion(total.right, total.judged);
    });
    add(count_column(name + "_n", "number of responses" + of),
        [&](const Person& person) { return Cell{total_of(person).answers}; });
  }

  const WideAnswers& answers_;
  const StudyVocabulary& vocabulary_;
  WideColumns made_{};
  std::map<Asked, std::map<Condition, Tally>> of_all_{};  ///< the conditions of all participants
  std::map<Asked, Forms> said_{};
  std::set<Asked> chosen_{};
  std::set<Asked> conditional_{};
  std::set<Asked> with_rule_{};
  ProtocolNames names_{};
  std::map<std::string, std::set<Asked>> protocols_asking_{};  ///< by question
};

}  // namespace

WideColumns wide_columns(const WideAnswers& answers, std::vector<ExportColumn> about,
                         const StudyVocabulary& vocabulary) {
  return WideColumnMaker(answers, std::move(about), vocabulary).made();
}

}  // namespace asperity
