// Answers by the greatest mean proportion and by the smallest p, with equal ones named together.

#include "app/findings/shared/selection_questions.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <utility>

#include "analysis/choices/conditional_logit.h"
#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/test_sentences.h"
#include "app/findings/shared/choice_tables.h"

namespace asperity {

namespace {

/// "a, b, c"
Phrase listed_names(std::span<const std::string> names) {
  Phrase all{};
  for (std::size_t i = 0; i < names.size(); ++i) {
    all = i == 0 ? Phrase(names[i])
                 : (i + 1 == names.size() ? phrase("Analysis", "%1 and %2")
                                          : phrase("Analysis", "%1, %2"))
                       .with(all, names[i]);
  }
  return all;
}

bool is_of_one_participant(const StudyTests::Test& test) {
  return test.status == StudyTests::kOneParticipantAlone;
}

/// The chance level of either of two.
constexpr double kShareOfPair = 0.5;

/// The greatest of the participants' mean proportions: several names where means are equal.
struct GreatestMean {
  std::vector<std::string> names{};
  const Finding* mean = nullptr;  ///< of the first of them; null where there is none
};

GreatestMean greatest_mean(std::span<const std::string> names, const FoundNumbers& found) {
  constexpr double kRounding = 1e-12;  // of sums of the same proportions in a different order
  GreatestMean greatest{};
  for (const std::string& name : names) {
    const Finding* mean = found.find("subj.mean", name);
    if (mean == nullptr || !mean->value) continue;
    const double more = greatest.mean == nullptr ? 1.0 : *mean->value - *greatest.mean->value;
    if (more > kRounding) greatest = {.mean = mean};
    if (more >= -kRounding) greatest.names.push_back(name);
  }
  return greatest;
}

/// "height_map was chosen most often: in 60 % of a participant's choices on average (…), where
/// chance is 33 %"
Phrase most_often(const GreatestMean& most, std::size_t items) {
  constexpr std::size_t kBoth = 2;
  const Phrase share = percent(*most.mean->value);
  const Phrase chance = percent(1.0 / static_cast<double>(items));
  if (most.names.size() == items && items > 1) {
    return (items == kBoth ? phrase("Analysis",
                                    "Both were chosen equally often: each in %1 of a participant's "
                                    "choices on average, compared with a chance level of %2")
                           : phrase("Analysis",
                                    "All were chosen equally often: each in %1 of a participant's "
                                    "choices on average, compared with a chance level of %2"))
        .with(share, chance);
  }
  if (most.names.size() > 1) {
    return phrase("Analysis",
                  "%1 were chosen equally often, and most often: each in %2 of a participant's "
                  "choices on average, compared with a chance level of %3")
        .with(listed_names(most.names), share, chance);
  }
  return phrase("Analysis",
                "%1 was chosen most often: in %2 of a participant's choices on average (%3), "
                "compared with a chance level of %4")
      .with(most.names.front(), share, interval_text(*most.mean), chance);
}

/// With the question that the participants were asked, where it was the same in every trial.
Phrase with_prompt(const Phrase& question, const GatheredAnswers& gathered) {
  std::set<std::string> prompts{};
  for (const Protocol::TrialQuestionTemplate& asked : gathered.questions) {
    prompts.insert(asked.prompt);
  }
  if (prompts.size() != 1 || prompts.begin()->empty()) return question;
  return phrase("Analysis", "%1 Participants were asked: “%2”").with(question, *prompts.begin());
}

std::string log_worth(double value) { return display_signed(value, 2); }

/// The log worths of all items, in descending order; none where there is no scale.
std::vector<std::pair<std::string, const Finding*>> worths_in_order(const Selection& selection,
                                                                    const FoundNumbers& scale) {
  std::vector<std::pair<std::string, const Finding*>> order{};
  for (const std::string& item : selection.items) {
    const Finding* worth = scale.find(scale_quantity(selection), item);
    if (worth == nullptr || !worth->value) return {};
    order.emplace_back(item, worth);
  }
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
    return *a.second->value > *b.second->value;
  });
  return order;
}

/// "a 0.52, 95 % CI [0.10, 0.94]; b …"
Phrase scale_text(std::span<const std::pair<std::string, const Finding*>> order) {
  Phrase all{};
  for (const auto& [item, worth] : order) {
    Phrase one = phrase("Analysis", "%1 %2").with(item, log_worth(*worth->value));
    if (worth->low && worth->high) {
      one = phrase("Analysis", "%1, 95 % CI [%2, %3]")
                .with(one, log_worth(*worth->low), log_worth(*worth->high));
    }
    all = all.empty() ? one : phrase("Analysis", "%1; %2").with(all, one);
  }
  return all;
}

void ask_scale(const Selection& selection, const FoundNumbers& scale, const Phrase& question,
               AnalysisOutcome& outcome) {
  const Phrase method =
      selection.two_offered
          ? phrase("Analysis",
                   "Bradley–Terry model of all choices: log-worths with a mean of 0; CIs with the "
                   "participants as clusters (CR2, at least %1 participants).")
                .with(std::to_string(kFewestClusters))
          : phrase("Analysis",
                   "Plackett–Luce model of all choices: log-worths with a mean of 0; CIs with the "
                   "participants as clusters (CR2, at least %1 participants).")
                .with(std::to_string(kFewestClusters));
  const auto order = worths_in_order(selection, scale);
  if (order.empty()) {
    add_question(outcome, "preference", question,
                 phrase("Analysis",
                        "The scale cannot be estimated: a model was always or never chosen, or the "
                        "trials do not link all models. Collect more choices."),
                 method, kAllShares, nullptr);
    return;
  }
  add_question(outcome, "preference", question,
               phrase("Analysis", "Log-worths, in decreasing order: %1.").with(scale_text(order)),
               method, kWorthScale, order.front().second);
}

/// The reported p: adjusted within the family.
double reported_p(const StudyTests::Test& test) {
  return test.adjusted.value_or(test.p.value_or(1.0));
}

/// The tests of a name with the smallest p: several where p is equal.
std::vector<const StudyTests::Test*> smallest_p(const std::string& name, const StudyTests& tests) {
  std::vector<const StudyTests::Test*> smallest{};
  for (const StudyTests::Test& test : tests.tests()) {
    if (test.name != name || !test.p) continue;
    if (!smallest.empty() && reported_p(test) > reported_p(*smallest.front())) continue;
    if (!smallest.empty() && reported_p(test) < reported_p(*smallest.front())) smallest.clear();
    smallest.push_back(&test);
  }
  return smallest;
}

/// "a / b"
std::string pair_text(const StudyTests::Test& test) {
  return test.about.first + " / " + test.about.second;
}

/// "the smallest p is that of a / b (p = .012, Holm-corrected)"
Phrase smallest_text(const std::vector<const StudyTests::Test*>& smallest) {
  constexpr std::size_t kMostNamed = 3;  // the table lists further pairs
  StudyTests::Test shared = *smallest.front();
  const bool is_same_attainable =
      std::all_of(smallest.begin(), smallest.end(), [&shared](const StudyTests::Test* test) {
        return test->unattainable_p() == shared.unattainable_p() &&
               test->differing == shared.differing;
      });
  if (!is_same_attainable) shared.smallest_p.reset();  // the table of tests contains that of each
  const Phrase p = p_text(shared);
  if (smallest.size() > kMostNamed) {
    return phrase("Analysis", "the smallest p is shared by %1 pairs (each %2)")
        .with(std::to_string(smallest.size()), p);
  }
  std::vector<std::string> names{};
  for (const StudyTests::Test* test : smallest) names.push_back(pair_text(*test));
  return (names.size() == 1 ? phrase("Analysis", "the smallest p is that of %1 (%2)")
                            : phrase("Analysis", "the smallest p is shared by %1 (each %2)"))
      .with(listed_names(names), p);
}

/// "a over b (p = .012, Holm-corrected)"; with the proportion among the choices between the two,
/// where `found` has it.
Phrase preference_in(const StudyTests::Test& test, const FoundNumbers& found) {
  auto [of, more, less] = test.about;
  if (found.value("signflip.diff", {more, less}).value_or(0.0) < 0.0) std::swap(more, less);
  const Finding* mean = found.find("subj.mean", {more, less});
  if (mean == nullptr || !mean->value) {
    return phrase("Analysis", "%1 over %2 (%3)").with(more, less, p_text(test));
  }
  return phrase("Analysis", "%1 over %2 (in %3 of a participant's choices on average, %4; %5)")
      .with(more, less, percent(*mean->value), interval_text(*mean), p_text(test));
}

/// Where the numbers do not contain p.
Phrase not_established() {
  return phrase("Analysis",
                "Not established: %1 (%2). The test is significant, but %3; more participants are "
                "needed.");
}

/// The proportions of choices by position: "what was felt first was chosen in 33 % of …".
Phrase positions_text(const GreatestMean& most, std::size_t positions, const Finding& first) {
  const Phrase share = percent(*most.mean->value);
  const Phrase chance = percent(1.0 / static_cast<double>(positions));
  const bool is_first = most.names.front() == "1";
  if (most.names.size() == positions && positions > 1) {
    return phrase("Analysis",
                  "all positions were chosen equally often, each in %1 of a participant's choices "
                  "on average")
        .with(share);
  }
  if (most.names.size() > 1 && is_first) {
    return phrase("Analysis",
                  "the positions %1 were chosen equally often, each in %2 of a participant's "
                  "choices on average, compared with a chance level of %3")
        .with(listed_names(most.names), share, chance);
  }
  if (most.names.size() > 1) {
    return phrase(
               "Analysis",
               "the positions %1 were chosen equally often, each in %2 of a participant's choices "
               "on average, and the first position in %3 (%4), compared with a chance level of %5")
        .with(listed_names(most.names), share, percent(*first.value), interval_text(first), chance);
  }
  if (is_first) {
    return phrase("Analysis",
                  "the first position was chosen in %1 of a participant's choices on average (%2), "
                  "compared with a chance level of %3")
        .with(share, interval_text(first), chance);
  }
  return phrase("Analysis",
                "position %1 was chosen in %2 of a participant's choices on average (%3), and the "
                "first position in %4 (%5), compared with a chance level of %6")
      .with(most.names.front(), share, interval_text(*most.mean), percent(*first.value),
            interval_text(first), chance);
}

/// The number of participants who responded, and of those who chose the target at least once.
struct TargetChoosers {
  std::size_t participants = 0;
  std::size_t choosers = 0;
};

TargetChoosers target_choosers(const Selection& selection) {
  std::set<std::uint32_t> participants{};
  std::set<std::uint32_t> choosers{};
  for (const GatheredAnswer& answer : selection.gathered.answers) {
    participants.insert(answer.person);
    const std::size_t chosen = selection.chosen(answer);
    if (chosen != kNoChoice && selection.items[chosen] == selection.target()) {
      choosers.insert(answer.person);
    }
  }
  return {.participants = participants.size(), .choosers = choosers.size()};
}

}  // namespace

void state_share_of_pair(const FoundNumbers& found, const FindingKey& of_first, StudyTests& tests) {
  const Finding* const mean = found.find("subj.mean", of_first);
  const TestMethod* const method = tests.tests().back().made_by;
  if (mean == nullptr || !mean->value || method == nullptr) return;
  if (method->sides == TestSides::two_sided) tests.state_direction(*mean->value - kShareOfPair);
  tests.state_mean_share(mean, kShareOfPair);
}

QuantityName scale_quantity(const Selection& selection) {
  return selection.two_offered ? QuantityName("bt.ability.sumzero.cluster")
                               : "pl.logworth.sumzero.cluster";
}

void ask_preference(const Selection& selection, const FoundNumbers& choice,
                    const FoundNumbers& scale, const StudyTests& tests, AnalysisOutcome& outcome) {
  const std::optional<std::string>& parameter = selection.gathered.compared_parameter;
  const Phrase question =
      with_prompt(parameter ? phrase("Analysis", "Which level of %1 is chosen most often?")
                                  .with(words_of_parameter(*parameter))
                            : phrase("Analysis", "Which rendering is chosen most often?"),
                  selection.gathered);
  if (!selection.all_offered) {
    ask_scale(selection, scale, question, outcome);
    return;
  }
  const GreatestMean most = greatest_mean(selection.items, choice);
  const Phrase proportion =
      averaged(phrase("Analysis", "Each participant's proportion of choices"), most.mean);
  const Phrase method =
      phrase("Analysis",
             "%1 Equal choice probabilities are tested by a within-participant permutation test: "
             "the models are exchanged within each participant's choices, so that the test is "
             "valid however the choices of a participant depend on each other.")
          .with(proportion);
  const StudyTests::Test* test = tests.find("preference");
  if (most.mean == nullptr || test == nullptr) {
    add_question(outcome, "preference", question,
                 phrase("Analysis", "There are no choices yet; run a session first."), method,
                 kAllShares, nullptr);
    return;
  }
  const Phrase shares = most_often(most, selection.items.size());
  const Phrase answer =
      is_of_one_participant(*test)
          ? phrase("Analysis", "%1. This cannot be tested with one participant.").with(shares)
      : !test->p
          ? phrase("Analysis", "%1.").with(shares)
          : said_of(*test,
                    statements_of(
                        *test,
                        {.numbers = shares,
                         .significant = phrase(
                             "Analysis",
                             "%1. The choices differ significantly from equal proportions (%2)."),
                         .not_significant = phrase(
                             "Analysis",
                             "%1. The choices do not differ significantly from equal proportions "
                             "(%2)."),
                         .not_established = not_established(),
                         .exploratory = phrase("Analysis", "%1. Test of equal proportions: %2.")}));
  add_question(outcome, "preference", question, answer, test->p ? method : proportion, kPersonMeans,
               most.mean);
}

PairWords words_of_pairs(const Selection& selection, const std::string& test) {
  const std::optional<std::string>& parameter = selection.gathered.compared_parameter;
  const Phrase question =
      parameter ? phrase("Analysis", "Is one level of %1 chosen more often than another?")
                      .with(words_of_parameter(*parameter))
                : phrase("Analysis", "Is one rendering chosen more often than another?");
  const Phrase method =
      selection.all_offered
          ? phrase("Analysis",
                   "For each pair, exact sign-flip (randomisation) test of each participant's "
                   "difference between the two counts (both labels exchanged within a "
                   "participant). Choices of a third model are not counted.")
          : phrase("Analysis",
                   "For each pair, exact sign-flip (randomisation) test of each participant's "
                   "difference between the two counts (both labels exchanged within a "
                   "participant), on the trials in which both were presented.");
  return {.question = question,
          .method = method,
          .nothing_chosen =
              phrase("Analysis", "No choice was made between two models; collect responses first."),
          .test = test};
}

/// "Chosen more often: a over b (…). Not established: …", or empty.
Phrase with_unestablished(const Phrase& answer, const Phrase& unestablished) {
  if (unestablished.empty()) return answer;
  const Phrase text = phrase("Analysis", "Not established: %1.").with(unestablished);
  return answer.empty() ? text : phrase("Analysis", "%1 %2").with(answer, text);
}

/// Which item of each significant pair was chosen more often; of many pairs, how many they are, and the others.
Phrase preferences_text(const std::string& name, const StudyTests& tests,
                        const FoundNumbers& found) {
  constexpr std::size_t kMostNamed = 6;
  Phrase differ{};
  Phrase unestablished{};
  std::size_t differing = 0;
  double largest_p = 0.0;
  std::vector<std::string> others{};
  for (const StudyTests::Test& test : tests.tests()) {
    if (test.name != name) continue;
    if (!test.shows()) {
      others.push_back(pair_text(test));
      continue;
    }
    ++differing;
    largest_p = std::max(largest_p, *test.adjusted);
    const bool is_established = !test.contradicts_interval();
    const Phrase preference = preference_in(test, found);
    const Phrase one =
        is_established
            ? preference
            : phrase("Analysis", "%1, but %2").with(preference, contradiction_text(test));
    Phrase& all = is_established ? differ : unestablished;
    all = all.empty() ? one : phrase("Analysis", "%1, %2").with(all, one);
  }
  if (differing <= kMostNamed) {
    return with_unestablished(
        differ.empty() ? differ : phrase("Analysis", "Chosen more often: %1.").with(differ),
        unestablished);
  }
  const Phrase counted =
      phrase("Analysis",
             "%1 of the %2 pairs differ significantly (largest of these p values, Holm-corrected: "
             "%3); the table of tests contains them.")
          .with(std::to_string(differing), std::to_string(differing + others.size()),
                display_p_cell(largest_p));
  const Phrase established = with_unestablished(counted, unestablished);
  if (others.empty() || others.size() > kMostNamed) return established;
  return phrase("Analysis", "%1 Not significantly different: %2.")
      .with(established, listed_names(others));
}

void ask_pairs(const PairWords& words, const StudyTests& tests, const FoundNumbers& found,
               AnalysisOutcome& outcome) {
  const std::string& name = words.test;
  const std::vector<const StudyTests::Test*> smallest = smallest_p(name, tests);
  if (smallest.empty()) {
    const bool is_one_participant = std::any_of(
        tests.tests().begin(), tests.tests().end(),
        [&name](const auto& test) { return test.name == name && is_of_one_participant(test); });
    add_question(outcome, "pairs", words.question,
                 is_one_participant
                     ? phrase("Analysis", "This cannot be tested with one participant.")
                     : words.nothing_chosen,
                 {}, "pairs", nullptr);
    return;
  }
  const StudyTests::Test& least = *smallest.front();
  const Phrase of_smallest = smallest_text(smallest);
  const auto is_of_pairs = [&name](const StudyTests::Test& test) { return test.name == name; };
  const bool is_only_pair =
      std::count_if(tests.tests().begin(), tests.tests().end(), is_of_pairs) == 1;
  const bool is_any_attainable =
      std::any_of(tests.tests().begin(), tests.tests().end(), [&](const StudyTests::Test& test) {
        return is_of_pairs(test) && test.p && !test.unattainable_p();
      });
  StatedNumbers stated{.numbers = of_smallest, .claim = preferences_text(name, tests, found)};
  if (is_only_pair) {
    stated.numbers = pair_text(least);
    stated.not_significant = phrase("Analysis", "%1 do not differ significantly (%2).");
    stated.exploratory = phrase("Analysis", "%1: %2.");
  } else {
    stated.not_significant =
        is_any_attainable
            ? phrase("Analysis", "No pair differs significantly: %1.")
            : phrase("Analysis", "No pair could differ significantly in these data: %1.");
    stated.exploratory = phrase("Analysis", "Among all pairs, %1.");
  }
  const Phrase answer = said_of(least, statements_of(least, stated));
  add_question(outcome, "pairs", words.question,
               is_only_pair ? with_zero_differences(answer, least) : answer, words.method, "pairs",
               found.find("signflip.p.two", {least.about.first, least.about.second}));
}

void ask_position(std::size_t positions, const Phrase& method, const FoundNumbers& found,
                  const StudyTests& tests, AnalysisOutcome& outcome) {
  const StudyTests::Test* test = tests.find("position");
  const Finding* first = found.find("subj.mean", "1");
  if (test == nullptr || first == nullptr || !first->value) return;
  const std::vector<std::string> names = numbers_up_to(positions);
  const GreatestMean most = greatest_mean(names, found);
  const Phrase question = phrase("Analysis", "Does the position in the trial matter?");
  if (is_of_one_participant(*test)) {
    add_question(outcome, "position", question,
                 phrase("Analysis", "This cannot be tested with one participant: %1.")
                     .with(positions_text(most, positions, *first)),
                 {}, kPositions, most.mean);
  }
  if (!test->p) return;
  const TestStatements statements = statements_of(
      *test,
      {.numbers = positions_text(most, positions, *first),
       .significant = phrase("Analysis", "The position has a significant effect (%2): %1."),
       .not_significant = phrase("Analysis", "The position has no significant effect (%2): %1."),
       .not_established = not_established(),
       .exploratory = phrase("Analysis", "Test of equal proportions: %2; %1.")});
  add_question(outcome, "position", question, said_of(*test, statements), method, kPositions,
               most.mean);
}

bool asks_about_textures(const Selection& selection) {
  return selection.has_target() && selection.textures.size() > 1 && selection.all_offered;
}

void ask_textures(const Selection& selection, const StudyTests& tests, AnalysisOutcome& outcome) {
  if (!asks_about_textures(selection)) return;
  const std::string& target = selection.target();
  const StudyTests::Test* test = tests.find("textures");
  const Phrase question =
      phrase("Analysis", "Does the proportion of choices of %1 depend on the texture?")
          .with(target);
  const Phrase method = phrase(
      "Analysis",
      "Permutation test of each participant's number of choices of the target with each texture: "
      "the textures are exchanged at random within each participant. Where each texture was "
      "judged once, this is the exact form of Cochran's Q test.");
  const TargetChoosers who = target_choosers(selection);
  if (test == nullptr || !test->p) {
    add_question(
        outcome, "textures", question,
        test != nullptr && is_of_one_participant(*test)
            ? phrase("Analysis", "This cannot be tested with one participant.")
        : who.choosers == 0
            ? phrase("Analysis", "This cannot be tested: no participant ever chose %1.")
                  .with(target)
            : phrase("Analysis",
                     "This cannot be tested: the participants have not judged every texture "
                     "equally often."),
        {}, kSharesByTexture, nullptr);
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
  Phrase answer = said_of(
      *test,
      statements_of(
          *test,
          {.numbers = phrase("Analysis", "test of equal proportions of %1 with every texture: %2.")
                          .with(target, p_text(*test)),
           .exploratory = {}}));
  if (who.choosers < who.participants) {
    answer = phrase("Analysis", "%1 Participants who never chose %2 do not contribute: %3 of %4.")
                 .with(answer, target, std::to_string(who.participants - who.choosers),
                       std::to_string(who.participants));
  }
  add_question(outcome, "textures", question, answer, method, kSharesByTexture, &finding);
}

}  // namespace asperity
