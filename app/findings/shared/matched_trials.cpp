// Represents the responses of a matching as assignments of pictures to textures.

#include "app/findings/shared/matched_trials.h"

#include <algorithm>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

namespace asperity {

namespace {

// The largest number for which the chance distribution is computed.
constexpr std::size_t kMostItems = 12;

bool is_permutation_of_pictures(const GatheredAnswers& gathered, const GatheredAnswer& answer) {
  const auto surfaces = gathered.surfaces_of(answer);
  const auto replies = gathered.replies_of(answer);
  const std::size_t items = surfaces.size();
  if (items == 0 || items > kMostItems || replies.size() != items ||
      gathered.option_lists[answer.options].size() != items) {
    return false;
  }
  for (std::size_t i = 0; i < items; ++i) {
    if (!replies[i].correct) return false;
    for (std::size_t j = 0; j < i; ++j) {
      if (surfaces[i].item == surfaces[j].item || replies[i].answer == replies[j].answer) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

std::vector<RepeatedScore> repeated_scores(const GatheredAnswers& gathered) {
  std::vector<RepeatedScore> scores{};
  for (const GatheredAnswer& answer : gathered.answers) {
    if (!is_permutation_of_pictures(gathered, answer)) continue;
    const auto replies = gathered.replies_of(answer);
    const auto right = std::count_if(replies.begin(), replies.end(),
                                     [](const GatheredReply& reply) { return *reply.correct; });
    scores.push_back({.person = answer.person,
                      .column = gathered.column_of(answer),
                      .repetition = answer.repetition,
                      .score = static_cast<double>(right) / static_cast<double>(replies.size())});
  }
  return scores;
}

std::vector<TextureResponse> responses_to_textures(const GatheredAnswers& gathered) {
  std::vector<TextureResponse> responses{};
  for (const GatheredAnswer& answer : gathered.answers) {
    if (!is_permutation_of_pictures(gathered, answer)) continue;
    const auto surfaces = gathered.surfaces_of(answer);
    const auto replies = gathered.replies_of(answer);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      responses.push_back(
          {.person = answer.person, .texture = surfaces[i].item, .is_hit = *replies[i].correct});
    }
  }
  return responses;
}

std::vector<MatchedTrial> matched_trials(const GatheredAnswers& gathered,
                                         AnalysisOutcome& outcome) {
  std::vector<MatchedTrial> assignments{};
  std::unordered_map<std::u32string, std::size_t> places{};
  std::size_t left_out = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs{};
  std::u32string name{};
  for (const GatheredAnswer& answer : gathered.answers) {
    if (!is_permutation_of_pictures(gathered, answer)) {
      ++left_out;
      continue;
    }
    const auto surfaces = gathered.surfaces_of(answer);
    const auto replies = gathered.replies_of(answer);
    pairs.clear();
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      pairs.emplace_back(surfaces[i].item, replies[i].answer);
    }
    std::sort(pairs.begin(), pairs.end());
    name.clear();
    for (const std::uint32_t part : {answer.person, gathered.column_of(answer), answer.options})
      name += part;
    for (const auto& [felt, chosen] : pairs) {
      name += felt;
      name += chosen;
    }
    const auto [found, is_new] = places.try_emplace(name, assignments.size());
    if (is_new) {
      MatchedTrial& made = assignments.emplace_back();
      made.person = answer.person;
      made.column = gathered.column_of(answer);
      made.options = answer.options;
      for (const auto& [felt, chosen] : pairs) {
        made.felt.push_back(felt);
        made.chosen.push_back(chosen);
      }
      made.right = static_cast<std::size_t>(std::count_if(
          replies.begin(), replies.end(), [](const GatheredReply& r) { return *r.correct; }));
    }
    ++assignments[found->second].times;
  }
  if (left_out > 0) {
    outcome.remarks.push_back(
        phrase("Analysis",
               "Responses left out because they do not assign each picture to exactly one surface, "
               "so that the chance level of a permutation does not apply: %1.")
            .with(std::to_string(left_out)));
  }
  return assignments;
}

std::uint64_t permutations(std::size_t items) {
  std::uint64_t product = 1;
  for (std::uint64_t i = 2; i <= items; ++i) product *= i;
  return product;
}

TidyInput matched_trials_table(const GatheredAnswers& gathered, MatchedTrials assignments,
                               const char* parts) {
  NumberColumn times{};
  LabelColumn people{};
  LabelColumn trials{};
  LabelColumn felt{};
  LabelColumn chosen{};
  LabelColumn groups{.names = {"F", "M"}};
  bool sexes[2] = {false, false};
  for (const AnsweringPerson& person : gathered.people) {
    people.names.push_back(person.label);
    sexes[0] = sexes[0] || person.sex == "F";
    sexes[1] = sexes[1] || person.sex == "M";
  }
  for (std::size_t word = 0; word < gathered.words.size(); ++word) {
    felt.names.push_back(gathered.word(static_cast<std::uint32_t>(word)));
  }
  chosen.names = felt.names;
  std::vector<std::size_t> trials_of(gathered.people.size());
  for (const MatchedTrial* assignment : assignments) {
    const std::size_t trial = trials_of[assignment->person]++;
    if (trial == trials.names.size()) trials.names.push_back(std::to_string(trial + 1));
    const std::optional<std::string>& sex = gathered.people[assignment->person].sex;
    for (std::size_t i = 0; i < assignment->items(); ++i) {
      people.codes.push_back(assignment->person);
      trials.codes.push_back(trial);
      felt.codes.push_back(assignment->felt[i]);
      chosen.codes.push_back(assignment->chosen[i]);
      times.push_back(static_cast<double>(assignment->times));
      if (sexes[0] && sexes[1]) {
        groups.codes.push_back(sex == "F" ? 0 : sex == "M" ? 1 : LabelColumn::kMissing);
      }
    }
  }
  std::vector<TidyTable::Column> columns{{"subject", std::move(people)},
                                         {"trial", std::move(trials)},
                                         {"stimulus", std::move(felt)},
                                         {"response", std::move(chosen)},
                                         {"times", std::move(times)}};
  if (sexes[0] && sexes[1]) columns.push_back({"group", std::move(groups)});
  TidyInput input{};
  input.tables.emplace_back(std::move(columns), "the assignments");
  input.options.set("parts", std::string(parts));
  return input;
}

}  // namespace asperity
