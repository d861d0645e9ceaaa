// Selection: which of several renderings of one texture is the most realistic.

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "app/analyses/families.h"
#include "app/analyses/study_findings.h"
#include "app/analyses/tally.h"

namespace asperity {

namespace {

constexpr std::size_t kNoLabel = LabelColumn::kMissing;

/// The answers of a selection as choices among items.
struct Selection {
  const GatheredAnswers& gathered;
  std::vector<std::string> items{};     ///< by name
  std::vector<std::string> textures{};  ///< by name
  std::vector<std::size_t> item_of_word{};
  std::vector<std::size_t> texture_of_word{};
  std::size_t positions = 0;  ///< of the largest trial
  bool all_offered = true;    ///< every item in every trial
  bool two_offered = true;    ///< in every trial
  bool can_abstain = false;   ///< cannot_tell was an answer
  std::size_t abstained = 0;

  explicit Selection(const GatheredAnswers& answers);

  /// kNoLabel for cannot_tell, and for what was not felt.
  std::size_t chosen(const GatheredAnswer& answer) const {
    return item_of_word[gathered.reply_of(answer).answer];
  }
  std::size_t item(const FeltSurface& surface) const { return item_of_word[surface.item]; }
  /// Of the first surface: all of a trial show the same one.
  std::size_t texture(const GatheredAnswer& answer) const {
    return answer.surface_count == 0 ? kNoLabel
                                     : texture_of_word[gathered.surfaces_of(answer)[0].texture];
  }
  std::size_t position(const GatheredAnswer& answer) const {
    const auto surfaces = gathered.surfaces_of(answer);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      if (surfaces[i].item == gathered.reply_of(answer).answer) return i;
    }
    return kNoLabel;
  }
  /// What is in question: declared, or else the first.
  const std::string& target() const {
    const auto& declared = gathered.declared.target;
    const bool is_known =
        declared && std::find(items.begin(), items.end(), *declared) != items.end();
    return is_known ? *declared : items.front();
  }
  bool has_target() const { return gathered.declared.target == target(); }
};

void sort_names(const GatheredAnswers& gathered, const std::set<std::uint32_t>& words,
                std::vector<std::string>& names, std::vector<std::size_t>& place_of_word) {
  for (const std::uint32_t word : words) names.push_back(gathered.word(word));
  std::sort(names.begin(), names.end());
  place_of_word.assign(gathered.words.size(), kNoLabel);
  for (const std::uint32_t word : words) {
    place_of_word[word] = static_cast<std::size_t>(
        std::lower_bound(names.begin(), names.end(), gathered.word(word)) - names.begin());
  }
}

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
    abstained += chosen(answer) == kNoLabel ? 1 : 0;
  }
}

/// Everything that is counted, in one walk over the answers.
struct SelectionCounts {
  explicit SelectionCounts(const Selection& selection, const ChapterCells& cells);

  CountTable table_1{};
  std::vector<Tally> shares{};     ///< column × item
  std::vector<Tally> pairs{};      ///< column × item × item, the first before the second
  std::vector<Tally> textures{};   ///< texture × item
  std::vector<Tally> positions{};  ///< by position
  Tally choices{};
};

SelectionCounts::SelectionCounts(const Selection& selection, const ChapterCells& cells) {
  const std::size_t items = selection.items.size();
  std::vector<std::string> labels = selection.items;
  if (selection.can_abstain) labels.emplace_back(kCannotTell);
  table_1 = count_table(std::move(labels), cells.columns());
  shares.resize(cells.columns().size() * items);
  pairs.resize(cells.columns().size() * items * items);
  textures.resize(selection.textures.size() * items);
  positions.resize(selection.positions);
  for (const GatheredAnswer& answer : selection.gathered.answers) {
    const auto surfaces = selection.gathered.surfaces_of(answer);
    const std::size_t chosen = selection.chosen(answer);
    const std::array<std::size_t, 2> columns = cells.columns_of(answer.column);
    choices.count(answer.person, true, surfaces.size());
    for (std::size_t i = columns[0] == columns[1] ? 1 : 0; i < 2; ++i) {
      const std::size_t column = columns[i];
      if (chosen != kNoLabel || selection.can_abstain) {
        ++table_1.at(chosen == kNoLabel ? items : chosen, column);
      }
      if (chosen == kNoLabel) continue;
      for (const FeltSurface& surface : surfaces) {
        const std::size_t item = selection.item(surface);
        shares[column * items + item].count(answer.person, item == chosen, surfaces.size());
        if (item == chosen) continue;
        const std::size_t first = std::min(item, chosen);
        const std::size_t second = std::max(item, chosen);
        pairs[(column * items + first) * items + second].count(answer.person, chosen == first, 2);
      }
    }
    if (chosen == kNoLabel) continue;
    for (std::size_t place = 0; place < surfaces.size(); ++place) {
      const std::size_t item = selection.item(surfaces[place]);
      textures[selection.texture(answer) * items + item].count(answer.person, item == chosen,
                                                               surfaces.size());
      positions[place].count(answer.person, item == chosen, surfaces.size());
    }
  }
}

void add_share_tables(const Selection& selection, const SelectionCounts& counts,
                      const ChapterCells& cells, AnalysisOutcome& outcome) {
  const std::size_t items = selection.items.size();
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
  if (selection.can_abstain) {
    shares.note =
        phrase("Analysis", "%1 Answers “cannot tell” are counted above and take no part here.")
            .with(shares.note);
  }
  ShareTable pairs{"pairs",
                   phrase("Analysis", "One model against another, among the choices of either"),
                   phrase("Analysis",
                          "The chance is 1/2: a choice of a third model says nothing about the "
                          "two."),
                   {"column", "item", "against"},
                   "chosen",
                   "share_of_pair",
                   {}};
  for (std::size_t column = 0; column < cells.columns().size(); ++column) {
    for (std::size_t item = 0; item < items; ++item) {
      shares.rows.push_back(
          {{cells.columns()[column], selection.items[item]}, counts.shares[column * items + item]});
      for (std::size_t other = item + 1; other < items; ++other) {
        pairs.rows.push_back(
            {{cells.columns()[column], selection.items[item], selection.items[other]},
             counts.pairs[(column * items + item) * items + other]});
      }
    }
  }
  add_shares(shares, outcome);
  add_shares(pairs, outcome);
  ShareTable textures{"shares_by_texture",
                      phrase("Analysis", "Share of each model among the choices, by texture"),
                      {},
                      {"texture", "item"},
                      "chosen",
                      "share_chosen",
                      {}};
  for (std::size_t texture = 0; texture < selection.textures.size(); ++texture) {
    for (std::size_t item = 0; item < items; ++item) {
      textures.rows.push_back({{selection.textures[texture], selection.items[item]},
                               counts.textures[texture * items + item]});
    }
  }
  add_shares(textures, outcome);
}

void add_positions(const SelectionCounts& counts, AnalysisOutcome& outcome) {
  ShareTable positions{
      "positions",
      phrase("Analysis", "Share of each position among the choices"),
      phrase("Analysis",
             "The first, second, … surface that was felt, whatever it was. Where surfaces are "
             "felt in random order, more than chance is a habit, not a preference."),
      {"position"},
      "chosen",
      "share_of_position",
      {}};
  for (std::size_t place = 0; place < counts.positions.size(); ++place) {
    positions.rows.push_back({{std::to_string(place + 1)}, counts.positions[place]});
  }
  add_shares(positions, outcome);
}

LabelColumn labels_of_people(const GatheredAnswers& gathered) {
  LabelColumn people{};
  for (const AnsweringPerson& person : gathered.people) people.names.push_back(person.label);
  return people;
}

std::vector<std::string> numbers_up_to(std::size_t count) {
  std::vector<std::string> numbers{};
  for (std::size_t i = 1; i <= count; ++i) numbers.push_back(std::to_string(i));
  return numbers;
}

/// What is chosen by each answer: an item, a position, a texture.
using ChoiceOf = std::function<std::size_t(const GatheredAnswer&)>;

TidyInput choices_table(const Selection& selection, const std::vector<std::string>& names,
                        const ChoiceOf& choice, const std::string& target) {
  LabelColumn people = labels_of_people(selection.gathered);
  LabelColumn samples{.names = selection.textures};
  LabelColumn choices{.names = names};
  for (const GatheredAnswer& answer : selection.gathered.answers) {
    people.codes.push_back(answer.person);
    samples.codes.push_back(selection.texture(answer));
    choices.codes.push_back(choice(answer));
  }
  TidyInput input{};
  input.tables.emplace_back(std::vector<TidyTable::Column>{{"subject", std::move(people)},
                                                           {"sample", std::move(samples)},
                                                           {"choice", std::move(choices)}},
                            "the choices");
  input.options.add("renderers", json_list(names));
  input.options.add("target", json_text(target));
  return input;
}

/// A table of counted choices: of each participant, how often from which items which one.
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
    // The order in which two are felt is part of the comparison; of more it is not looked at.
    if (!selection.two_offered) std::sort(std::get<1>(key).begin(), std::get<1>(key).end());
    std::get<2>(key) = selection.chosen(answer);
    ++counted[key];
  }
  return counted;
}

/// Comparisons of two for Bradley–Terry; "cannot tell" is a tie.
TidyInput comparisons_of(const Selection& selection) {
  std::string text = "subject,first,second,winner,times\n";
  for (const auto& [key, times] : count_choices(selection)) {
    const auto& [person, offered, chosen] = key;
    text += selection.gathered.people[person].label + ',' + selection.items[offered[0]] + ',' +
            selection.items[offered[1]] + ',' +
            (chosen == kNoLabel ? "tie" : selection.items[chosen]) + ',' + std::to_string(times) +
            '\n';
  }
  TidyInput input{};
  input.tables.emplace_back(text, "the comparisons");
  input.options.add("items", json_list(selection.items));
  return input;
}

/// The best of several, as rankings of which only the first place is known.
TidyInput first_places_of(const Selection& selection) {
  std::string text = "subject,trial,item,rank,times\n";
  std::size_t trial = 0;
  for (const auto& [key, times] : count_choices(selection)) {
    const auto& [person, offered, chosen] = key;
    if (chosen == kNoLabel) continue;
    ++trial;
    for (const std::size_t item : offered) {
      text += selection.gathered.people[person].label + ',' + std::to_string(trial) + ',' +
              selection.items[item] + ',' + (item == chosen ? "1" : "") + ',' +
              std::to_string(times) + '\n';
    }
  }
  TidyInput input{};
  input.tables.emplace_back(text, "the first places");
  input.options.add("items", json_list(selection.items));
  return input;
}

void add_scale_table(const Selection& selection, const FoundNumbers& found,
                     AnalysisOutcome& outcome) {
  const bool paired = selection.two_offered;
  const char* plain = paired ? "bt.ability.sumzero" : "pl.logworth.sumzero";
  const char* clustered = paired ? "bt.ability.sumzero.cluster" : "pl.logworth.sumzero.cluster";
  const char* worth = paired ? "bt.worth" : "pl.worth";
  if (found.find(plain, selection.items.front()) == nullptr) {
    outcome.remarks.push_back(phrase(
        "Analysis",
        "There is no scale of the models: one of them was always chosen, or never, wherever it "
        "was offered, or was never offered with the others. No finite distance fits that best."));
    return;
  }
  NamedTable made{
      "scale",
      phrase("Analysis", "The models on one scale"),
      {{"item", "log_worth", "log_worth_low", "log_worth_high", "worth"}, {}},
      paired ? phrase("Analysis",
                      "Bradley and Terry: of two models, i is chosen with probability 1/(1 + "
                      "exp(l_j − l_i)). The log worths have the mean 0; their intervals are Wald's "
                      "with the persons as clusters. Worths add up to 1.")
             : phrase("Analysis",
                      "Luce and Plackett: of several models, each is chosen in proportion to its "
                      "worth. The log worths have the mean 0; their intervals are Wald's with the "
                      "persons as clusters. Worths add up to 1.")};
  for (const std::string& item : selection.items) {
    const auto [low, high] = found.interval(clustered, item);
    made.table.rows.push_back({item, found.cell(plain, item), low, high, found.cell(worth, item)});
  }
  outcome.tables.push_back(std::move(made));
}

void ask_preference(const Selection& selection, const FoundNumbers& found, const StudyTests& tests,
                    AnalysisOutcome& outcome) {
  const Finding* most = nullptr;
  std::string item{};
  for (const std::string& name : selection.items) {
    const Finding* mean = found.find("subj.mean", name);
    if (mean != nullptr && mean->value && (most == nullptr || *mean->value > *most->value)) {
      most = mean;
      item = name;
    }
  }
  const Phrase question = phrase("Analysis", "Which rendering is the most realistic?");
  const Phrase method =
      phrase("Analysis",
             "The share of each participant's own choices, averaged over the participants, with "
             "Student's interval. That all models mean the same is tested by exchanging the models "
             "within each participant's choices at random (relabelling), which holds however the "
             "choices of a participant depend on each other.");
  const StudyTests::Test* test = tests.find("preference");
  if (most == nullptr || test == nullptr) {
    add_question(outcome, "preference", question,
                 selection.all_offered
                     ? phrase("Analysis", "Nobody has chosen one yet.")
                     : phrase("Analysis",
                              "Not every trial offers every model, so that shares of all choices "
                              "would compare nothing; the scale below joins the trials."),
                 method, "shares", nullptr);
    return;
  }
  const Phrase answer =
      test->p
          ? phrase("Analysis",
                   "%1 was chosen most often: in %2 of a participant's choices on average (%3), "
                   "where chance is %4; that all are chosen equally often has %5.")
                .with(item, percent(*most->value), interval_text(*most),
                      percent(1.0 / static_cast<double>(selection.items.size())), p_text(*test))
          : phrase("Analysis",
                   "%1 was chosen most often: in %2 of a participant's choices on average "
                   "(%3), where chance is %4.")
                .with(item, percent(*most->value), interval_text(*most),
                      percent(1.0 / static_cast<double>(selection.items.size())));
  add_question(outcome, "preference", question, answer, method, "persons", most);
}

void ask_pairs(const std::string& name, const StudyTests& tests, const FoundNumbers& found,
               AnalysisOutcome& outcome) {
  Phrase differ{};
  const StudyTests::Test* least = nullptr;
  for (const StudyTests::Test& test : tests.tests()) {
    if (test.name != name || !test.p) continue;
    const double p = test.adjusted.value_or(*test.p);
    if (least == nullptr || p < least->adjusted.value_or(*least->p)) least = &test;
    if (!test.shows()) continue;
    const std::size_t bar = test.about.find('|');
    std::string more = test.about.substr(0, bar);
    std::string less = test.about.substr(bar + 1);
    if (found.value("signflip.diff", test.about).value_or(0.0) < 0.0) std::swap(more, less);
    const Phrase one = phrase("Analysis", "%1 over %2 (%3)").with(more, less, p_text(test));
    differ = differ.empty() ? one : phrase("Analysis", "%1, %2").with(differ, one);
  }
  const Phrase question = phrase("Analysis", "Is one rendering preferred to another?");
  const Phrase method = phrase(
      "Analysis",
      "For each pair the difference of both counts in every participant, against all patterns of "
      "signs (both names exchanged within a participant). Choices of a third model say nothing "
      "about the two.");
  if (least == nullptr) {
    add_question(outcome, "pairs", question,
                 phrase("Analysis", "There are no choices in which two models could be compared."),
                 method, "pairs", nullptr);
    return;
  }
  const std::string closest = least->about.substr(0, least->about.find('|')) + " / " +
                              least->about.substr(least->about.find('|') + 1);
  const Sayings sayings{
      phrase("Analysis", "Chosen more often: %1.").with(differ),
      phrase("Analysis",
             "No pair can be told apart: the smallest of all is that of %1, %2. That does not "
             "show that they are equal.")
          .with(closest, p_text(*least)),
      phrase("Analysis", "Of all pairs %1 has the smallest p (%2).").with(closest, p_text(*least))};
  add_question(outcome, "pairs", question, said_of(*least, sayings), method, "pairs",
               found.find("signflip.p.two", least->about));
}

/// The position whose mean share is the largest, with its number; of equal ones the first.
std::pair<std::string, const Finding*> most_chosen_position(std::size_t positions,
                                                            const FoundNumbers& found) {
  std::pair<std::string, const Finding*> most{};
  for (const std::string& position : numbers_up_to(positions)) {
    const Finding* mean = found.find("subj.mean", position);
    if (mean == nullptr || !mean->value) continue;
    if (most.second == nullptr || *mean->value > *most.second->value) most = {position, mean};
  }
  return most;
}

void ask_position(std::size_t positions, const FoundNumbers& found, const StudyTests& tests,
                  AnalysisOutcome& outcome) {
  const StudyTests::Test* test = tests.find("position");
  const Finding* first = found.find("subj.mean", "1");
  if (test == nullptr || !test->p || first == nullptr || !first->value) return;
  const auto [name, most] = most_chosen_position(positions, found);
  const Phrase chance = percent(1.0 / static_cast<double>(positions));
  const auto of_first = [&](const Phrase& words) {
    return words.with(percent(*first->value), interval_text(*first), chance, p_text(*test));
  };
  const auto of_most = [&, &name = name, &most = most](const Phrase& words) {
    return words.with(name, percent(*most->value), interval_text(*most), percent(*first->value),
                      interval_text(*first), chance, p_text(*test));
  };
  const Sayings sayings =
      most == first
          ? Sayings{of_first(phrase("Analysis",
                                    "The position matters: what was felt first was chosen most "
                                    "often, in %1 of a participant's choices on average (%2), "
                                    "where chance is %3; %4.")),
                    of_first(phrase("Analysis",
                                    "Nothing shows that the position matters: what was felt first "
                                    "was chosen most often, in %1 of a participant's choices on "
                                    "average (%2), where chance is %3; %4.")),
                    of_first(phrase("Analysis",
                                    "What was felt first was chosen most often, in %1 of a "
                                    "participant's choices on average (%2), where chance is %3; "
                                    "%4."))}
          : Sayings{of_most(phrase("Analysis",
                                   "The position matters: what was felt at position %1 was chosen "
                                   "most often, in %2 of a participant's choices on average (%3), "
                                   "and what was felt first in %4 (%5), where chance is %6; %7.")),
                    of_most(phrase("Analysis",
                                   "Nothing shows that the position matters: what was felt at "
                                   "position %1 was chosen most often, in %2 of a participant's "
                                   "choices on average (%3), and what was felt first in %4 (%5), "
                                   "where chance is %6; %7.")),
                    of_most(phrase("Analysis",
                                   "What was felt at position %1 was chosen most often, in %2 of "
                                   "a participant's choices on average (%3), and what was felt "
                                   "first in %4 (%5), where chance is %6; %7."))};
  add_question(
      outcome, "position", phrase("Analysis", "Does it matter what is felt first?"),
      said_of(*test, sayings),
      phrase("Analysis", "As the preference, with the positions in the place of the models."),
      "positions", most);
}

/// Whether every participant felt every texture equally often, so that textures can be exchanged.
bool is_balanced(const Selection& selection) {
  std::vector<std::size_t> trials(selection.gathered.people.size() * selection.textures.size());
  for (const GatheredAnswer& answer : selection.gathered.answers) {
    ++trials[answer.person * selection.textures.size() + selection.texture(answer)];
  }
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (trials[i] != trials[i - i % selection.textures.size()]) return false;
  }
  return true;
}

bool asks_about_textures(const Selection& selection) {
  return selection.has_target() && selection.textures.size() > 1 && selection.all_offered;
}

void test_textures(const Selection& selection, StudyTests& tests, AnalysisOutcome& outcome) {
  if (!asks_about_textures(selection) || !is_balanced(selection)) return;
  const auto target = static_cast<std::size_t>(
      std::lower_bound(selection.items.begin(), selection.items.end(), selection.target()) -
      selection.items.begin());
  const std::vector<Finding> findings = analysis_of(
      "texture", "selection",
      choices_table(
          selection, selection.textures,
          [&](const GatheredAnswer& answer) {
            return selection.chosen(answer) == target ? selection.texture(answer) : kNoLabel;
          },
          selection.textures.front()));
  tests.add("textures", "", FoundNumbers(findings).find("relabel.exact.p"));
  keep_findings(findings, outcome, [](const Finding& finding) {
    return finding.quantity == "relabel.exact.p" || finding.quantity.starts_with("signflip");
  });
}

void ask_textures(const Selection& selection, const StudyTests& tests, AnalysisOutcome& outcome) {
  if (!asks_about_textures(selection)) return;
  const std::string& target = selection.target();
  const StudyTests::Test* test = tests.find("textures");
  const Phrase question =
      phrase("Analysis", "Does the preference for %1 depend on the texture?").with(target);
  const Phrase method = phrase(
      "Analysis",
      "How often each participant chose the target with each texture, against exchanging the "
      "textures within each participant at random; where each texture was judged once, this "
      "is the exact form of Cochran's test.");
  if (test == nullptr || !test->p) {
    add_question(outcome, "textures", question,
                 phrase("Analysis",
                        "This cannot be tested: the participants have not judged every texture "
                        "equally often."),
                 method, "shares_by_texture", nullptr);
    return;
  }
  Finding finding{};
  finding.quantity = "p";
  finding.key = "test=textures";
  finding.value = test->p;
  finding.n = test->n;
  finding.method = test->method;
  finding.unit = "1";
  finding.analysis = "tests";
  const auto with_numbers = [&](const Phrase& words) { return words.with(target, p_text(*test)); };
  const Sayings sayings{
      with_numbers(phrase("Analysis",
                          "It does: that %1 is chosen equally often with every texture has %2.")),
      with_numbers(phrase("Analysis",
                          "Nothing shows that it does: that %1 is chosen equally often with every "
                          "texture has %2.")),
      with_numbers(
          phrase("Analysis", "That %1 is chosen equally often with every texture has %2."))};
  add_question(outcome, "textures", question, said_of(*test, sayings), method, "shares_by_texture",
               &finding);
}

}  // namespace

void analyze_selection(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  const Selection selection(gathered);
  if (selection.items.empty()) {
    outcome.remarks.push_back(phrase(
        "Analysis", "No surface was felt before these answers: there is nothing to compare."));
    return;
  }
  const ChapterCells cells(gathered);
  SelectionCounts counts(selection, cells);
  counts.table_1.name = "table_1";
  counts.table_1.title = phrase("Analysis", "Chosen as the most realistic (counts)");
  counts.table_1.label_column = "item";
  counts.table_1.note = chance_note(
      counts.choices, phrase("Analysis", "By chance: 1/%1 of the choices for each model."));
  add_counts(counts.table_1, outcome);
  add_share_tables(selection, counts, cells, outcome);

  StudyTests tests(gathered);
  const std::size_t people = gathered.people.size();
  std::vector<Finding> choice{};
  if (selection.all_offered && selection.items.size() > 1) {
    choice = analysis_of("choice", "selection",
                         choices_table(
                             selection, selection.items,
                             [&](const GatheredAnswer& answer) { return selection.chosen(answer); },
                             selection.target()));
  } else {
    outcome.remarks.push_back(phrase(
        "Analysis",
        "Not every trial offers every model: tests that compare all choices are left out, and the "
        "models are compared on the scale."));
  }
  const FoundNumbers found(choice);
  keep_findings(choice, outcome);
  std::vector<PersonsRow> rows{};
  for (const std::string& item : selection.items) rows.push_back({item, item});
  add_persons(found, rows, "item", "share_chosen", outcome);

  const bool only_target = tests.is_in_family("target_pairs");
  const std::string pairs = only_target ? "target_pairs" : "pairs";
  for (std::size_t a = 0; a < selection.items.size() && selection.all_offered; ++a) {
    for (std::size_t b = a + 1; b < selection.items.size(); ++b) {
      const std::string& first = selection.items[a];
      const std::string& second = selection.items[b];
      const bool of_target = first == selection.target() || second == selection.target();
      tests.add(only_target && of_target ? "target_pairs" : "pairs", first + '|' + second,
                found.find("signflip.p.two", first + '|' + second));
    }
  }
  if (!choice.empty()) tests.add("preference", "", found.find("relabel.exact.p"));

  const bool same_size = counts.choices.outcomes().has_value() && selection.positions > 1;
  std::vector<Finding> position{};
  if (same_size) {
    position = analysis_of(
        "position", "selection",
        choices_table(
            selection, numbers_up_to(selection.positions),
            [&](const GatheredAnswer& answer) { return selection.position(answer); }, "1"));
    keep_findings(position, outcome);
  }
  const FoundNumbers found_position(position);
  if (same_size) tests.add("position", "", found_position.find("relabel.exact.p"));
  test_textures(selection, tests, outcome);

  add_positions(counts, outcome);
  if (same_size) {
    std::vector<PersonsRow> places{};
    for (const std::string& place : numbers_up_to(selection.positions)) {
      places.push_back({place, place});
    }
    add_persons(found_position, places, "position", "share_of_position", outcome,
                "persons_by_position");
  }
  const std::vector<Finding> scale =
      selection.two_offered ? analysis_of("scale", "paired", comparisons_of(selection))
                            : analysis_of("scale", "ranking", first_places_of(selection));
  keep_findings(scale, outcome);
  if (selection.items.size() > 1) add_scale_table(selection, FoundNumbers(scale), outcome);
  tests.finish(outcome);

  ask_preference(selection, found, tests, outcome);
  ask_pairs(pairs, tests, found, outcome);
  ask_position(selection.positions, found_position, tests, outcome);
  ask_textures(selection, tests, outcome);
  add_texture_force(gathered, outcome);
  remark_on_pooling(gathered.answers.size(), people, outcome);
}

}  // namespace asperity
