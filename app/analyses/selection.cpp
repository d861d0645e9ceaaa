// Selection: which of several renderings of one texture is the most realistic.

#include <algorithm>
#include <functional>

#include "app/analyses/families.h"
#include "app/analyses/tally.h"

namespace asperity {

namespace {

using Filter = std::function<bool(const GatheredAnswer&)>;

std::set<std::string> items_of(const GatheredAnswers& gathered) {
  std::set<std::string> items{};
  for (const GatheredAnswer& answer : gathered.answers) {
    for (const FeltSurface& surface : answer.surfaces) items.insert(surface.item);
  }
  return items;
}

bool offers(const GatheredAnswer& answer, const std::string& item) {
  return std::any_of(answer.surfaces.begin(), answer.surfaces.end(),
                     [&item](const FeltSurface& surface) { return surface.item == item; });
}

/// Of the choices among surfaces of which `item` was one, those of `item`.
Tally chosen(const GatheredAnswers& gathered, const std::string& item, const Filter& counts) {
  Tally tally{};
  for (const GatheredAnswer& answer : gathered.answers) {
    const std::string& choice = answer.answers.front();
    if (!counts(answer) || choice == kCannotTell || !offers(answer, item)) continue;
    tally.count(answer.participant, choice == item, answer.surfaces.size());
  }
  return tally;
}

/// Of the choices of one of two, those of the first.
Tally preferred(const GatheredAnswers& gathered, const std::string& first,
                const std::string& second, const Filter& counts) {
  Tally tally{};
  for (const GatheredAnswer& answer : gathered.answers) {
    const std::string& choice = answer.answers.front();
    if (!counts(answer) || !offers(answer, first) || !offers(answer, second)) continue;
    if (choice == first || choice == second) tally.count(answer.participant, choice == first, 2);
  }
  return tally;
}

Filter in_column(const std::string& column) {
  return [column](const GatheredAnswer& answer) { return stands_in(answer, column); };
}

void add_shares_by_texture(const GatheredAnswers& gathered, const std::set<std::string>& items,
                           AnalysisOutcome& outcome) {
  std::set<std::string> textures{};
  for (const GatheredAnswer& answer : gathered.answers) {
    if (!answer.surfaces.empty()) textures.insert(answer.surfaces.front().texture);
  }
  ShareTable shares{"shares_by_texture",
                    phrase("Analysis", "Share of each model among the choices, by texture"),
                    {},
                    {"texture", "item"},
                    "chosen",
                    "share_chosen",
                    {}};
  for (const std::string& texture : textures) {
    for (const std::string& item : items) {
      shares.rows.push_back(
          {{texture, item}, chosen(gathered, item, [&texture](const GatheredAnswer& answer) {
             return !answer.surfaces.empty() && answer.surfaces.front().texture == texture;
           })});
    }
  }
  add_shares(shares, outcome);
}

}  // namespace

void analyze_selection(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  const std::vector<std::string> columns = columns_of(gathered);
  const std::set<std::string> items = items_of(gathered);
  const bool cannot_tell = std::any_of(
      gathered.answers.begin(), gathered.answers.end(), [](const GatheredAnswer& answer) {
        return std::count(answer.options.begin(), answer.options.end(), kCannotTell) > 0;
      });

  CountTable counts{
      "table_1", phrase("Analysis", "Chosen as the most realistic (counts)"), {}, "item", {}};
  Tally choices{};
  for (const GatheredAnswer& answer : gathered.answers) {
    choices.count(answer.participant, true, answer.surfaces.size());
  }
  counts.note =
      chance_note(choices, phrase("Analysis", "By chance: 1/%1 of the choices for each model."));
  counts.labels.assign(items.begin(), items.end());
  if (cannot_tell) counts.labels.emplace_back(kCannotTell);
  const auto count_of = [&](std::size_t label, const std::string& column) {
    return static_cast<std::size_t>(std::count_if(
        gathered.answers.begin(), gathered.answers.end(), [&](const GatheredAnswer& answer) {
          return stands_in(answer, column) && answer.answers.front() == counts.labels[label];
        }));
  };
  add_counts(counts, columns, count_of, outcome);

  ShareTable shares{
      "shares",
      phrase("Analysis", "Share of each model among the choices"),
      phrase("Analysis",
             "Chance is 1 in the number of surfaces felt. p: exact binomial test, two-sided, not "
             "corrected for the number of rows; the shares of one column depend on each other."),
      {"column", "item"},
      "chosen",
      "share_chosen",
      {}};
  ShareTable pairs{"pairs",
                   phrase("Analysis", "One model against another, among the choices of either"),
                   phrase("Analysis",
                          "The chance is 1/2: a choice of a third model says nothing about the "
                          "two."),
                   {"column", "item", "against"},
                   "chosen",
                   "share_of_pair",
                   {}};
  for (const std::string& column : columns) {
    for (auto item = items.begin(); item != items.end(); ++item) {
      shares.rows.push_back({{column, *item}, chosen(gathered, *item, in_column(column))});
      for (auto other = std::next(item); other != items.end(); ++other) {
        pairs.rows.push_back(
            {{column, *item, *other}, preferred(gathered, *item, *other, in_column(column))});
      }
    }
  }
  if (cannot_tell) {
    shares.note =
        phrase("Analysis", "%1 Answers \"cannot_tell\" are counted above and take no part here.")
            .with(shares.note);
  }
  add_shares(shares, outcome);
  add_shares(pairs, outcome);
  add_shares_by_texture(gathered, items, outcome);

  std::vector<PersonShares> people{};
  std::set<std::string> persons{};
  for (const std::string& item : items) {
    PersonShares& own = people.emplace_back(PersonShares{item, {}});
    for (const GatheredAnswer& answer : gathered.answers) {
      const std::string& choice = answer.answers.front();
      if (choice == kCannotTell || !offers(answer, item)) continue;
      own.people[answer.participant].count(answer.participant, choice == item,
                                           answer.surfaces.size());
      persons.insert(answer.participant);
    }
  }
  add_person_shares(people, "item", "share_chosen", outcome);
  add_texture_force(gathered, outcome);
  remark_on_pooling(gathered.answers.size(), persons.size(), outcome);
}

}  // namespace asperity
