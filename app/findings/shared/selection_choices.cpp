// Counts equal choices of a participant before they become rows; a response “cannot tell” is a tie or left out.

#include "app/findings/shared/selection_choices.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "app/findings/gathering/answer_columns.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/tidy/finding_list.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

void sort_names(const GatheredAnswers& gathered, const std::set<std::uint32_t>& words,
                std::vector<std::string>& names, std::vector<std::size_t>& place_of_word) {
  for (const std::uint32_t word : words) names.push_back(gathered.word(word));
  std::sort(names.begin(), names.end(), precedes_by_value);
  place_of_word.assign(gathered.words.size(), kNoChoice);
  for (const std::uint32_t word : words) {
    place_of_word[word] = static_cast<std::size_t>(
        std::lower_bound(names.begin(), names.end(), gathered.word(word), precedes_by_value) -
        names.begin());
  }
}

/// Collects the rows of a table of choices.
class ChoiceRows final {
 public:
  explicit ChoiceRows(const Selection& selection)
      : selection_(selection),
        people_(labels_of_people(selection.gathered)),
        samples_{.names = selection.textures} {}

  void add(const GatheredAnswer& answer, std::size_t choice) {
    people_.codes.push_back(answer.person);
    samples_.codes.push_back(selection_.texture(answer));
    choices_.codes.push_back(choice);
  }

  TidyInput take(std::vector<std::string> names, const std::string& target) && {
    TidyInput input{};
    input.options.set("renderers", names);
    input.options.set("target", target);
    choices_.names = std::move(names);
    input.tables.emplace_back(std::vector<TidyTable::Column>{{"subject", std::move(people_)},
                                                             {"sample", std::move(samples_)},
                                                             {"choice", std::move(choices_)}},
                              "the choices");
    return input;
  }

 private:
  const Selection& selection_;
  LabelColumn people_{};
  LabelColumn samples_{};
  LabelColumn choices_{};
};

bool offers(const Selection& selection, const GatheredAnswer& answer, std::size_t item) {
  const auto surfaces = selection.gathered.surfaces_of(answer);
  return std::any_of(surfaces.begin(), surfaces.end(),
                     [&](const FeltSurface& surface) { return selection.item(surface) == item; });
}

/// Counted choices: for each participant, how often each item was chosen from each set.
using CountedChoices =
    std::map<std::tuple<std::size_t, std::vector<std::size_t>, std::size_t>, std::uint64_t>;

CountedChoices count_choices(const Selection& selection) {
  CountedChoices counted{};
  std::tuple<std::size_t, std::vector<std::size_t>, std::size_t> key{};
  for (const GatheredAnswer& answer : selection.gathered.answers) {
    std::get<0>(key) = answer.person;
    std::get<1>(key).clear();
    for (const FeltSurface& surface : selection.gathered.surfaces_of(answer)) {
      std::get<1>(key).push_back(selection.item(surface));
    }
    // The order of two surfaces is part of the comparison; of more it is not considered.
    if (!selection.two_offered) std::sort(std::get<1>(key).begin(), std::get<1>(key).end());
    std::get<2>(key) = selection.chosen(answer);
    ++counted[key];
  }
  return counted;
}

}  // namespace

Selection::Selection(const GatheredAnswers& answers) : gathered(answers) {
  std::set<std::uint32_t> item_words{};
  std::set<std::uint32_t> texture_words{};
  for (const FeltSurface& surface : gathered.surfaces) {
    item_words.insert(surface.item);
    texture_words.insert(surface.texture);
  }
  sort_names(gathered, item_words, items, item_of_word);
  sort_names(gathered, texture_words, textures, texture_of_word);
  for (const std::vector<std::string>& options : gathered.option_lists) {
    can_abstain = can_abstain || std::count(options.begin(), options.end(), kCannotTell) > 0;
  }
  for (const GatheredAnswer& answer : gathered.answers) {
    positions = std::max<std::size_t>(positions, answer.surface_count);
    all_offered = all_offered && answer.surface_count == items.size();
    two_offered = two_offered && answer.surface_count == 2;
    abstained += chosen(answer) == kNoChoice ? 1 : 0;
  }
}

std::vector<std::string> numbers_up_to(std::size_t count) {
  std::vector<std::string> numbers{};
  for (std::size_t i = 1; i <= count; ++i) numbers.push_back(std::to_string(i));
  return numbers;
}

TidyInput choices_table(const Selection& selection, const std::vector<std::string>& names,
                        const ChoiceOf& choice, const std::string& target) {
  ChoiceRows rows(selection);
  for (const GatheredAnswer& answer : selection.gathered.answers) rows.add(answer, choice(answer));
  return std::move(rows).take(names, target);
}

std::vector<ItemPair> pairs_offered(const Selection& selection) {
  std::set<std::pair<std::size_t, std::size_t>> together{};
  for (const GatheredAnswer& answer : selection.gathered.answers) {
    for (const FeltSurface& one : selection.gathered.surfaces_of(answer)) {
      for (const FeltSurface& other : selection.gathered.surfaces_of(answer)) {
        const std::size_t first = selection.item(one);
        const std::size_t second = selection.item(other);
        if (first < second) together.emplace(first, second);
      }
    }
  }
  std::vector<ItemPair> pairs{};
  for (const auto& [first, second] : together) pairs.push_back({first, second});
  return pairs;
}

TidyInput choices_between(const Selection& selection, const ItemPair& pair) {
  ChoiceRows rows(selection);
  for (const GatheredAnswer& answer : selection.gathered.answers) {
    if (!offers(selection, answer, pair.first) || !offers(selection, answer, pair.second)) continue;
    const std::size_t chosen = selection.chosen(answer);
    rows.add(answer, chosen == pair.first ? 0 : chosen == pair.second ? 1 : kNoChoice);
  }
  return std::move(rows).take({selection.items[pair.first], selection.items[pair.second]},
                              selection.items[pair.first]);
}

std::vector<Finding> pair_findings(const char* analysis, const Selection& selection,
                                   const char* parts) {
  std::vector<Finding> of_pairs{};
  for (const ItemPair& pair : pairs_offered(selection)) {
    const std::string& first = selection.items[pair.first];
    const std::string& second = selection.items[pair.second];
    TidyInput choices = choices_between(selection, pair);
    choices.options.set("parts", std::string(parts));
    for (Finding& finding : analysis_of(analysis, "selection", std::move(choices))) {
      const std::string& quantity = finding.quantity;
      const bool is_of_pair =
          quantity.starts_with("signflip.") || quantity.starts_with("pairwise.");
      const bool is_of_one = quantity.starts_with("subj.") && !finding.key.empty();
      if (!is_of_one && !is_of_pair) continue;
      // over one pair; the table of tests has the correction over all
      if (quantity.ends_with(".holm")) continue;
      if (is_of_one)
        finding.key = finding.key == first ? FindingKey{first, second} : FindingKey{second, first};
      finding.method += "; of the trials in which both were presented";
      of_pairs.push_back(std::move(finding));
    }
  }
  return of_pairs;
}

TidyInput comparisons_of(const Selection& selection) {
  LabelColumn subjects = labels_of_people(selection.gathered);
  LabelColumn first{.names = selection.items};
  LabelColumn second{.names = selection.items};
  LabelColumn winner{.names = selection.items};
  winner.names.emplace_back("tie");
  NumberColumn times_chosen{};
  for (const auto& [key, times] : count_choices(selection)) {
    const auto& [person, offered, chosen] = key;
    subjects.codes.push_back(person);
    first.codes.push_back(offered[0]);
    second.codes.push_back(offered[1]);
    winner.codes.push_back(chosen == kNoChoice ? selection.items.size() : chosen);
    times_chosen.push_back(static_cast<double>(times));
  }
  TidyInput input{};
  input.tables.emplace_back(std::vector<TidyTable::Column>{{"subject", std::move(subjects)},
                                                           {"first", std::move(first)},
                                                           {"second", std::move(second)},
                                                           {"winner", std::move(winner)},
                                                           {"times", std::move(times_chosen)}},
                            "the comparisons");
  input.options.set("items", selection.items);
  return input;
}

TidyInput first_places_of(const Selection& selection) {
  LabelColumn subjects = labels_of_people(selection.gathered);
  LabelRows trials{};
  LabelColumn items{.names = selection.items};
  NumberColumn ranks{};
  NumberColumn times_chosen{};
  std::size_t trial = 0;
  for (const auto& [key, times] : count_choices(selection)) {
    const auto& [person, offered, chosen] = key;
    if (chosen == kNoChoice) continue;
    ++trial;
    for (const std::size_t item : offered) {
      subjects.codes.push_back(person);
      trials.add(std::to_string(trial));
      items.codes.push_back(item);
      ranks.push_back(item == chosen ? std::optional(1.0) : std::nullopt);
      times_chosen.push_back(static_cast<double>(times));
    }
  }
  TidyInput input{};
  input.tables.emplace_back(std::vector<TidyTable::Column>{{"subject", std::move(subjects)},
                                                           {"trial", std::move(trials).take()},
                                                           {"item", std::move(items)},
                                                           {"rank", std::move(ranks)},
                                                           {"times", std::move(times_chosen)}},
                            "the choices");
  input.options.set("items", selection.items);
  return input;
}

}  // namespace asperity
