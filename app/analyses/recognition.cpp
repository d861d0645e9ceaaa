// Recognition: which of several pictures shows what was felt.

#include <algorithm>
#include <utility>

#include "app/analyses/families.h"
#include "app/analyses/tally.h"

namespace asperity {

namespace {

/// Chance is 1 of these: who will not choose has not guessed, but is not right either.
std::size_t pictures(const GatheredAnswer& answer) {
  return answer.options.size() - static_cast<std::size_t>(std::count(
                                     answer.options.begin(), answer.options.end(), kCannotTell));
}

/// Answers of which it is known whether they are right.
std::vector<const GatheredAnswer*> judged(const GatheredAnswers& gathered,
                                          AnalysisOutcome& outcome) {
  std::vector<const GatheredAnswer*> answers{};
  for (const GatheredAnswer& answer : gathered.answers) {
    if (answer.correct.front() && !answer.surfaces.empty()) answers.push_back(&answer);
  }
  const std::size_t left_out = gathered.answers.size() - answers.size();
  if (left_out > 0) {
    outcome.remarks.push_back(
        phrase("Analysis",
               "Answers to trials without a declared right answer, which are left out: %1.")
            .with(std::to_string(left_out)));
  }
  return answers;
}

}  // namespace

void analyze_recognition(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  const std::vector<std::string> columns = columns_of(gathered);
  const std::vector<const GatheredAnswer*> answers = judged(gathered, outcome);

  CountTable counts{"table_3",
                    phrase("Analysis", "Recognised: right answers (counts)"),
                    {},
                    "person",
                    sex_labels(gathered)};
  const auto count_of = [&](std::size_t label, const std::string& column) {
    std::size_t right = 0;
    for (const GatheredAnswer* answer : answers) {
      if (stands_in(*answer, column) && is_of(*answer, counts.labels[label]) &&
          *answer->correct.front()) {
        ++right;
      }
    }
    return right;
  };
  Tally all{};
  for (const GatheredAnswer* answer : answers) {
    all.count(answer->participant, *answer->correct.front(), pictures(*answer));
  }
  counts.note = chance_note(all, phrase("Analysis", "By chance: 1/%1 of the answers right."));
  add_counts(counts, columns, count_of, outcome);

  ShareTable shares{
      "shares",
      phrase("Analysis", "Share of right answers"),
      phrase("Analysis",
             "Chance is 1 in the number of pictures shown; \"cannot_tell\" is not right. p: exact "
             "binomial test, two-sided, not corrected for the number of rows."),
      {"column", "person"},
      "correct",
      "share_correct",
      {}};
  for (const std::string& column : columns) {
    for (const std::string& label : counts.labels) {
      ShareRow& row = shares.rows.emplace_back(ShareRow{{column, label}, {}});
      for (const GatheredAnswer* answer : answers) {
        if (!stands_in(*answer, column) || !is_of(*answer, label)) continue;
        row.tally.count(answer->participant, *answer->correct.front(), pictures(*answer));
      }
    }
  }
  add_shares(shares, outcome);

  std::map<std::string, Tally> by_texture{};
  PersonShares people{"all", {}};
  std::vector<std::pair<std::string, std::string>> pairs{};
  std::set<std::string> options{};
  for (const GatheredAnswer* answer : answers) {
    const bool right = *answer->correct.front();
    const std::string& felt = answer->surfaces.front().item;
    by_texture[felt].count(answer->participant, right, pictures(*answer));
    people.people[answer->participant].count(answer->participant, right, pictures(*answer));
    pairs.emplace_back(felt, answer->answers.front());
    options.insert(answer->options.begin(), answer->options.end());
  }
  ShareTable textures{"shares_by_texture",
                      phrase("Analysis", "Share of right answers, by felt texture"),
                      {},
                      {"felt"},
                      "correct",
                      "share_correct",
                      {}};
  for (const auto& [texture, tally] : by_texture) textures.rows.push_back({{texture}, tally});
  add_shares(textures, outcome);
  add_confusion(pairs, options, outcome);
  add_person_shares(std::span(&people, 1), "answers", "share_correct", outcome);
  add_texture_force(gathered, outcome);
  remark_on_pooling(answers.size(), people.people.size(), outcome);
}

}  // namespace asperity
