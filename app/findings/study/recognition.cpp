#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "analysis/number_text.h"
#include "app/findings/study/answer_columns.h"
#include "app/findings/study/crossed_textures.h"
#include "app/findings/study/group_equivalence.h"
#include "app/findings/study/kinds/recognition_analysis.h"
#include "app/findings/study/repetition_reliability.h"
#include "app/findings/study/study_findings.h"
#include "app/findings/study/tally.h"
#include "app/findings/study/test_sentences.h"

namespace asperity {

namespace {

/// The result of a response to a question that has a correct one.
struct Judged {
  const GatheredAnswer* answer = nullptr;
  std::uint32_t felt = 0;
  std::uint32_t chosen = 0;
  bool right = false;
};

/// The responses that can be classified as correct or incorrect.
std::vector<Judged> judged_of(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  std::vector<Judged> judged{};
  for (const GatheredAnswer& answer : gathered.answers) {
    const GatheredReply& reply = gathered.reply_of(answer);
    if (!reply.correct || answer.surface_count == 0) continue;
    judged.push_back({&answer, gathered.surfaces_of(answer)[0].item, reply.answer, *reply.correct});
  }
  const std::size_t left_out = gathered.answers.size() - judged.size();
  if (left_out > 0) {
    outcome.remarks.push_back(
        phrase("Analysis", "Responses in trials without a declared correct response, left out: %1.")
            .with(std::to_string(left_out)));
  }
  return judged;
}

/// The pictures of each option list: chance is 1 divided by their number. A participant who does
/// not choose has not guessed, and is not correct either.
std::vector<std::set<std::string>> pictures_of(const GatheredAnswers& gathered) {
  std::vector<std::set<std::string>> pictures{};
  for (const std::vector<std::string>& options : gathered.option_lists) {
    pictures.emplace_back(options.begin(), options.end()).erase(std::string(kCannotTell));
  }
  return pictures;
}

struct Pictures {
  std::vector<std::set<std::string>> of_list{};
  std::set<std::string> all{};
  bool always_the_same = true;
  std::vector<std::string> felt{};  ///< by name
};

Pictures pictures_in(const GatheredAnswers& gathered, const std::vector<Judged>& judged) {
  Pictures pictures{.of_list = pictures_of(gathered)};
  std::set<std::uint32_t> lists{};
  std::set<std::uint32_t> felt{};
  for (const Judged& one : judged) {
    lists.insert(one.answer->options);
    felt.insert(one.felt);
  }
  for (const std::uint32_t list : lists) {
    const std::set<std::string>& own = pictures.of_list[list];
    pictures.always_the_same = pictures.always_the_same && own == pictures.of_list[*lists.begin()];
    pictures.all.insert(own.begin(), own.end());
  }
  for (const std::uint32_t word : felt) pictures.felt.push_back(gathered.word(word));
  std::sort(pictures.felt.begin(), pictures.felt.end());
  return pictures;
}

/// Rows of the family `recognition`; a response that is not among the labels counts as missing.
TidyInput trials_table(const GatheredAnswers& gathered, const std::vector<Judged>& judged,
                       const std::vector<std::string>& labels) {
  std::vector<std::size_t> label_of(gathered.words.size(), LabelColumn::kMissing);
  for (std::size_t word = 0; word < label_of.size(); ++word) {
    const auto found = std::lower_bound(labels.begin(), labels.end(),
                                        gathered.word(static_cast<std::uint32_t>(word)));
    if (found != labels.end() && *found == gathered.word(static_cast<std::uint32_t>(word))) {
      label_of[word] = static_cast<std::size_t>(found - labels.begin());
    }
  }
  LabelColumn people = labels_of_people(gathered);
  LabelColumn felt{.names = labels};
  LabelColumn chosen{.names = labels};
  for (const Judged& one : judged) {
    people.codes.push_back(one.answer->person);
    felt.codes.push_back(label_of[one.felt]);
    chosen.codes.push_back(label_of[one.chosen]);
  }
  TidyInput input{};
  input.tables.emplace_back(std::vector<TidyTable::Column>{{"subject", std::move(people)},
                                                           {"stimulus", std::move(felt)},
                                                           {"response", std::move(chosen)}},
                            "the answers");
  input.options.set("labels", labels);
  return input;
}

/// A row per woman and man for the family `group`; nothing unless there are both.
std::optional<TidyInput> groups_table(const GatheredAnswers& gathered,
                                      const std::vector<Judged>& judged) {
  std::vector<HitCount> own(gathered.people.size());
  for (const Judged& one : judged) {
    ++own[one.answer->person].trials;
    own[one.answer->person].hits += one.right ? 1 : 0;
  }
  LabelRows subjects{};
  LabelRows groups{};
  NumberColumn correct{};
  NumberColumn trials{};
  std::set<std::string> sexes{};
  for (std::size_t i = 0; i < own.size(); ++i) {
    const std::string sex = gathered.people[i].sex.value_or("");
    if ((sex != "F" && sex != "M") || own[i].trials == 0) continue;
    sexes.insert(sex);
    subjects.add(gathered.people[i].label);
    groups.add(sex);
    correct.push_back(static_cast<double>(own[i].hits));
    trials.push_back(static_cast<double>(own[i].trials));
  }
  if (sexes.size() < 2) return std::nullopt;
  TidyInput input{};
  input.tables.emplace_back(std::vector<TidyTable::Column>{{"subject", std::move(subjects).take()},
                                                           {"group", std::move(groups).take()},
                                                           {"correct", std::move(correct)},
                                                           {"trials", std::move(trials)}},
                            "the participants");
  input.options.set("groups", std::vector<std::string>{"F", "M"});
  return input;
}

/// For each participant; nothing for those without a response that can be classified.
std::vector<std::optional<double>> proportions_right(const GatheredAnswers& gathered,
                                                     const std::vector<Judged>& judged) {
  std::vector<HitCount> own(gathered.people.size());
  for (const Judged& one : judged) {
    ++own[one.answer->person].trials;
    own[one.answer->person].hits += one.right ? 1 : 0;
  }
  std::vector<std::optional<double>> proportions(own.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i].trials > 0) proportions[i] = proportion(own[i]);
  }
  return proportions;
}

void add_recognition_tables(const GatheredAnswers& gathered, const std::vector<Judged>& judged,
                            const Pictures& pictures, AnalysisOutcome& outcome) {
  ChapterTally right(gathered);
  std::vector<Tally> by_texture(gathered.words.size());
  ConfusionTally confusions{};
  Tally all{};
  std::set<std::string> options{};
  for (const std::vector<std::string>& list : gathered.option_lists) {
    options.insert(list.begin(), list.end());
  }
  for (const Judged& one : judged) {
    const std::uint32_t person = one.answer->person;
    const std::uint64_t outcomes = pictures.of_list[one.answer->options].size();
    all.count(person, one.right, outcomes);
    by_texture[one.felt].count(person, one.right, outcomes);
    confusions.count(one.felt, one.chosen);
    right.count(
        {.column = one.answer->column, .person = person, .hit = one.right, .outcomes = outcomes});
  }
  right.add("table_3", phrase("Analysis", "Correct responses (counts)"),
            chance_note(all, phrase("Analysis", "Chance level: 1/%1 of the responses correct.")),
            outcome);
  ShareTable shares{
      "shares",
      phrase("Analysis", "Proportion correct"),
      phrase(
          "Analysis",
          "The chance level is 1 divided by the number of pictures shown; “cannot tell” counts as "
          "incorrect. p: exact binomial test, two-sided, uncorrected for the number of rows."),
      {"column", "person"},
      "correct",
      "share_correct",
      {}};
  right.add_rows(shares);
  add_shares(shares, outcome);
  ShareTable textures{"shares_by_texture",
                      phrase("Analysis", "Proportion correct, by texture"),
                      {},
                      {"felt"},
                      "correct",
                      "share_correct",
                      {}};
  for (const std::string& texture : pictures.felt) {
    textures.rows.push_back({{texture}, by_texture[*gathered.words.find(texture)]});
  }
  add_shares(textures, outcome);
  confusions.add_table(gathered, options, outcome);
}

bool is_about_likeness(const Finding& finding) {
  constexpr std::array<std::string_view, 4> kStarts{"scm.", "dis.", "mds.", "hclust."};
  return std::any_of(kStarts.begin(), kStarts.end(), [&finding](std::string_view start) {
    return finding.quantity.starts_with(start);
  });
}

/// Withdraws the fit of the choice model where it mainly fits the halves that were added.
void withhold_fit(std::vector<Finding>& likeness) {
  const bool too_few = std::any_of(likeness.begin(), likeness.end(), [](const Finding& one) {
    return one.quantity == "scm.too.few" && one.word == "TRUE";
  });
  if (!too_few) return;
  for (Finding& one : likeness) {
    if (one.quantity != "scm.p" && one.quantity != "scm.G2" && one.quantity != "scm.X2") continue;
    one.value.reset();
    one.word = "too_few_confusions";
    one.status = "at least half of the pairs were never confused: too few confusions for a fit";
  }
}

/// Similarities, map and tree of the pictures that were felt.
void add_likeness_tables(const std::vector<std::string>& felt, const FoundNumbers& found,
                         AnalysisOutcome& outcome) {
  const Finding* too_few = found.find("scm.too.few");
  if (too_few != nullptr && too_few->word == "TRUE" && felt.size() > 1) {
    const auto count = [&](const char* quantity) {
      return fixed(found.value(quantity).value_or(0.0), 0);
    };
    outcome.remarks.push_back(
        phrase("Analysis",
               "Similarities, MDS configuration and dendrogram rest on too few confusions (between "
               "textures that were presented: %1): %2 of %3 pairs of textures were never confused, "
               "and their "
               "dissimilarities are set by the ½ that is added to every count.")
            .with(count("scm.confusions"), count("scm.pairs.never"), count("scm.pairs")));
  }
  if (felt.size() < 2 || found.find("dis.shepard", felt[0] + '|' + felt[1]) == nullptr) return;
  NamedTable pairs{
      "similarity",
      phrase("Analysis", "Similarity of the textures"),
      {{"felt", "other", "similarity", "dissimilarity"}, {}},
      phrase("Analysis",
             "Similarity η: Luce's choice model, 1 for indistinguishable textures, with response "
             "biases separated; above 1: according to the model, confused more often than "
             "recognised. Dissimilarity: Shepard's −ln √(n_ij n_ji / (n_ii n_jj)) of the counts "
             "plus ½, not below 0; it is not the −ln of this similarity.")};
  NamedTable map{"map",
                 phrase("Analysis", "MDS configuration of the textures"),
                 {{"item", "x", "y"}, {}},
                 phrase("Analysis",
                        "Classical scaling of the dissimilarities. Only distances can be "
                        "interpreted: the configuration may be rotated and mirrored.")};
  NamedTable tree{"tree",
                  phrase("Analysis", "Dendrogram of the textures"),
                  {{"join", "first", "second", "height"}, {}},
                  phrase("Analysis",
                         "Average linkage of the dissimilarities. Each row joins the cluster of "
                         "the first texture with that of the second.")};
  for (std::size_t i = 0; i < felt.size(); ++i) {
    for (std::size_t j = i + 1; j < felt.size(); ++j) {
      const std::string key = felt[i] + '|' + felt[j];
      pairs.table.rows.push_back(
          {felt[i], felt[j], found.cell("scm.eta", key), found.cell("dis.shepard", key)});
    }
    map.table.rows.push_back(
        {felt[i], found.cell("mds.shepard.x", felt[i]), found.cell("mds.shepard.y", felt[i])});
  }
  for (std::size_t join = 1; join < felt.size(); ++join) {
    const std::string key = std::to_string(join);
    const Finding* first = found.find("hclust.shepard.average.first", key);
    const Finding* second = found.find("hclust.shepard.average.second", key);
    if (first == nullptr || second == nullptr) break;
    tree.table.rows.push_back({static_cast<std::int64_t>(join), first->word, second->word,
                               found.cell("hclust.shepard.average.height", key)});
  }
  for (NamedTable* table : {&pairs, &map, &tree}) outcome.tables.push_back(std::move(*table));
}

/// A row per felt texture for the family `proportion`.
TidyInput textures_table(const GatheredAnswers& gathered, const std::vector<Judged>& judged,
                         std::size_t pictures) {
  std::map<std::string, HitCount> by_texture{};
  for (const Judged& one : judged) {
    HitCount& count = by_texture[gathered.word(one.felt)];
    ++count.trials;
    count.hits += one.right ? 1 : 0;
  }
  LabelRows ids{};
  NumberColumn hits{};
  NumberColumn trials{};
  const NumberColumn chances(by_texture.size(), 1.0 / static_cast<double>(pictures));
  for (const auto& [texture, count] : by_texture) {
    ids.add(texture);
    hits.push_back(static_cast<double>(count.hits));
    trials.push_back(static_cast<double>(count.trials));
  }
  TidyInput input{};
  input.tables.emplace_back(std::vector<TidyTable::Column>{{"id", std::move(ids).take()},
                                                           {"k", std::move(hits)},
                                                           {"n", std::move(trials)},
                                                           {"p0", chances}},
                            "the textures");
  return input;
}

void ask_right(std::size_t pictures, const FoundNumbers& found, const StudyTests& tests,
               AnalysisOutcome& outcome) {
  const Finding* mean = found.find("subj.mean");
  const StudyTests::Test* test = tests.find("right");
  if (mean == nullptr || !mean->value || test == nullptr) return;
  const Phrase question = phrase("Analysis", "Are textures recognised above chance?");
  const Phrase proportion =
      averaged(phrase("Analysis", "Each participant's proportion correct"), mean);
  const Phrase method =
      (mean->n > 1 ? phrase("Analysis",
                            "%1 Two-sided one-sample t test against the chance level. “Cannot "
                            "tell” responses name no picture and are left out here; in the table "
                            "of proportions they count as incorrect.")
                   : phrase("Analysis",
                            "%1 One-sided exact binomial test against the chance level. “Cannot "
                            "tell” responses name no picture and are left out here; in the table "
                            "of proportions they count as incorrect."))
          .with(proportion);
  const Phrase chance = percent(1.0 / static_cast<double>(pictures));
  if (!test->p) {
    add_question(
        outcome, "right", question,
        phrase("Analysis",
               "On average %1 of a participant's responses were correct (%2), compared with a "
               "chance level of %3; the participants do not differ, so there is no test.")
            .with(percent(*mean->value), interval_text(*mean), chance),
        method, "shares", mean);
    return;
  }
  const auto with_numbers = [&](const Phrase& words) {
    return words.with(percent(*mean->value), interval_text(*mean), chance, p_text(*test));
  };
  const double level = 1.0 / static_cast<double>(pictures);
  if (test->is_significant() && holds_in_interval(*mean, level)) {
    qualify_test_sentence(outcome, test->name, kChanceInInterval);
  }
  const Sayings sayings{
      mean->n == 1 ? with_numbers(phrase(
                         "Analysis",
                         "For this participant only: %1 of the responses were correct (%2), "
                         "compared with a chance level of %3; %4. More participants are needed."))
      : *mean->value < level
          ? with_numbers(
                phrase("Analysis",
                       "No, less often than by chance: on average %1 of a participant's responses "
                       "were correct (%2), compared with a chance level of %3; %4."))
      : holds_in_interval(*mean, level)
          ? with_numbers(
                phrase("Analysis",
                       "Not established: on average %1 of a participant's responses were correct "
                       "(%2), compared with a chance level of %3; %4. The test is significant, but "
                       "the CI contains the chance level; more participants are needed."))
          : with_numbers(phrase("Analysis",
                                "Yes: on average %1 of a participant's responses were correct "
                                "(%2), compared with a chance level of %3; %4.")),
      with_numbers(phrase("Analysis",
                          "Not significantly: on average %1 of a participant's responses were "
                          "correct (%2), compared with a chance level of %3; %4.")),
      with_numbers(phrase("Analysis",
                          "On average %1 of a participant's responses were correct (%2), compared "
                          "with a chance level of %3; %4."))};
  add_question(outcome, "right", question, said_of(*test, sayings), method, "shares", mean);
}

void ask_information(const FoundNumbers& found, AnalysisOutcome& outcome) {
  const Finding* bits = found.find("IT.miller1955");
  const auto of = found.value("H.stimulus");
  const auto dprime = found.find("dprime");
  if (bits == nullptr || !bits->value || !of) return;
  const bool enough =
      found.find("IT.N.enough") != nullptr && found.find("IT.N.enough")->word == "TRUE";
  const double shown = std::clamp(*bits->value, 0.0, *of);
  const Phrase sensitivity = dprime != nullptr && dprime->value && dprime->low && dprime->high
                                 ? phrase("Analysis", "d′ = %1, 95 % CI [%2, %3], n = %4 responses")
                                       .with(fixed(*dprime->value, 2), fixed(*dprime->low, 2),
                                             fixed(*dprime->high, 2), std::to_string(dprime->n))
                                 : phrase("Analysis", "d′ has no finite value");
  const Phrase answer =
      enough ? phrase("Analysis",
                      "Transmitted information about the texture presented, bias-corrected: %1 of "
                      "%2 bits; %3.")
             : phrase("Analysis",
                      "Transmitted information about the texture presented: about %1 of %2 bits; "
                      "with so few responses the bias correction is not reliable; %3.");
  add_question(
      outcome, "information", phrase("Analysis", "How much information do the responses transmit?"),
      answer.with(fixed(shown, 2), fixed(*of, 2), sensitivity),
      phrase(
          "Analysis",
          "Transmitted information, bias-corrected (Miller 1955); at least 5·m² responses are "
          "needed for m pictures. d′ for m alternatives, assuming no response bias, all responses "
          "pooled; its CI is derived from the Wilson limits of the proportion correct."),
      "measures", bits, CountedUnit::answers);
}

/// Two textures that were felt, and how often one of them was confused with the other.
struct ConfusedPair {
  std::string names{};
  std::string key{};
  std::size_t times = 0;
  std::size_t answers = 0;  ///< to either

  double share() const { return static_cast<double>(times) / static_cast<double>(answers); }
};

/// The pairs with the largest proportion of confusions.
std::vector<ConfusedPair> most_confused(const GatheredAnswers& gathered,
                                        const std::vector<Judged>& judged,
                                        const std::vector<std::string>& felt) {
  ConfusionTally confusions{};
  std::vector<std::size_t> answers(gathered.words.size());
  for (const Judged& one : judged) {
    confusions.count(one.felt, one.chosen);
    ++answers[one.felt];
  }
  std::vector<ConfusedPair> most{};
  for (std::size_t i = 0; i < felt.size(); ++i) {
    for (std::size_t j = i + 1; j < felt.size(); ++j) {
      const std::uint32_t a = *gathered.words.find(felt[i]);
      const std::uint32_t b = *gathered.words.find(felt[j]);
      ConfusedPair pair{.names = felt[i] + " / " + felt[j],
                        .key = felt[i] + '|' + felt[j],
                        .times = confusions.at(a, b) + confusions.at(b, a),
                        .answers = answers[a] + answers[b]};
      // In integers, so that equal proportions of different numbers of responses are equal.
      const std::size_t mine = most.empty() ? 0 : pair.times * most.front().answers;
      const std::size_t others = most.empty() ? 0 : most.front().times * pair.answers;
      if (mine < others) continue;
      if (mine > others) most.clear();
      most.push_back(std::move(pair));
    }
  }
  return most;
}

/// One texture that was identified as another picture, whose texture may or may not have been felt.
struct Confusion {
  std::string felt{};
  std::string called{};
  std::size_t times = 0;
  std::size_t answers = 0;  ///< to the felt texture

  double share() const { return static_cast<double>(times) / static_cast<double>(answers); }
};

/// Those with the largest proportion.
std::vector<Confusion> largest_confusions(const GatheredAnswers& gathered,
                                          const std::vector<Judged>& judged,
                                          const Pictures& pictures) {
  ConfusionTally confusions{};
  std::vector<std::size_t> answers(gathered.words.size());
  for (const Judged& one : judged) {
    confusions.count(one.felt, one.chosen);
    ++answers[one.felt];
  }
  std::vector<Confusion> most{};
  for (const std::string& felt : pictures.felt) {
    for (const std::string& called : pictures.all) {
      const auto a = gathered.words.find(felt);
      const auto b = gathered.words.find(called);
      if (felt == called || !a || !b) continue;
      const std::size_t times = confusions.at(*a, *b);
      if (times == 0) continue;
      // In integers, so that equal proportions of different numbers of responses are equal.
      const std::size_t own = most.empty() ? 0 : times * most.front().answers;
      const std::size_t others = most.empty() ? 0 : most.front().times * answers[*a];
      if (own < others) continue;
      if (own > others) most.clear();
      most.push_back({.felt = felt, .called = called, .times = times, .answers = answers[*a]});
    }
  }
  return most;
}

/// "brick identified as gravel, brick called wood"
Phrase confusions_text(const std::vector<Confusion>& confusions) {
  Phrase all{};
  for (const Confusion& one : confusions) {
    const Phrase text = phrase("Analysis", "%1 identified as %2").with(one.felt, one.called);
    all = all.empty() ? text : phrase("Analysis", "%1, %2").with(all, text);
  }
  return all;
}

constexpr std::size_t kMostNamedConfusions = 3;  // the table lists further pairs and confusions

/// Adds what the pairs do not show: the most frequent confusions in one direction, where one of
/// them belongs to no pair that is reported.
Phrase with_larger_confusions(const Phrase& answer, const std::vector<ConfusedPair>& pairs,
                              const std::vector<Confusion>& largest) {
  const auto is_in_a_pair = [&pairs](const Confusion& one) {
    return std::any_of(pairs.begin(), pairs.end(), [&one](const ConfusedPair& pair) {
      return pair.key == one.felt + '|' + one.called || pair.key == one.called + '|' + one.felt;
    });
  };
  if (std::all_of(largest.begin(), largest.end(), is_in_a_pair)) return answer;
  const Confusion& first = largest.front();
  if (first.share() <= pairs.front().share()) return answer;
  if (largest.size() > kMostNamedConfusions) {
    return phrase("Analysis",
                  "%1 Counted in one direction only, %2 confusions are the most frequent: each in "
                  "%3 of the responses to the texture presented.")
        .with(answer, std::to_string(largest.size()), percent(first.share()));
  }
  if (largest.size() > 1) {
    return phrase("Analysis",
                  "%1 Counted in one direction only, these confusions are the most frequent: %2, "
                  "each in %3 of the responses to the texture presented.")
        .with(answer, confusions_text(largest), percent(first.share()));
  }
  return phrase("Analysis",
                "%1 Counted in one direction only, the most frequent confusion is %2: in %3 of %4 "
                "responses.")
      .with(answer, confusions_text(largest), std::to_string(first.times),
            std::to_string(first.answers));
}

void ask_confused_answers(const GatheredAnswers& gathered, const std::vector<Judged>& judged,
                          const Pictures& pictures, AnalysisOutcome& outcome) {
  const std::vector<ConfusedPair> most = most_confused(gathered, judged, pictures.felt);
  if (most.empty()) return;
  const ConfusedPair& first = most.front();
  Finding finding{};
  finding.quantity = "share_confused";
  finding.key = first.key;
  finding.value = first.share();
  finding.unit = "1";
  finding.n = first.answers;
  finding.method =
      "proportion of confusions with each other among the responses to the two textures; n counts "
      "responses";
  Phrase answer{};
  if (first.times == 0) {
    answer =
        phrase("Analysis", "No texture was ever confused with another one that was presented.");
  } else if (pictures.felt.size() == 2) {
    answer =
        phrase("Analysis",
               "Only %1 were presented: one was confused with the other in %2 of %3 responses.")
            .with(first.names, std::to_string(first.times), std::to_string(first.answers));
  } else if (most.size() == 1) {
    answer =
        phrase("Analysis",
               "The textures confused most often are %1: one with the other in %2 of %3 responses.")
            .with(first.names, std::to_string(first.times), std::to_string(first.answers));
  } else if (most.size() <= kMostNamedConfusions) {
    Phrase names = first.names;
    for (std::size_t i = 1; i < most.size(); ++i) {
      names =
          (i + 1 == most.size() ? phrase("Analysis", "%1 and %2") : phrase("Analysis", "%1, %2"))
              .with(names, most[i].names);
    }
    answer = phrase("Analysis",
                    "The following pairs are confused equally often: %1; one texture with the "
                    "other in %2 of the responses to the two textures of each pair.")
                 .with(names, percent(first.share()));
  } else {
    answer =
        phrase("Analysis",
               "%1 pairs of textures are confused equally often, and none more often: one texture "
               "with the other in %2 of the responses to the two textures of each pair.")
            .with(std::to_string(most.size()), percent(first.share()));
  }
  add_question(outcome, "confusions",
               phrase("Analysis", "Which textures are confused with each other?"),
               with_larger_confusions(answer, most, largest_confusions(gathered, judged, pictures)),
               pictures.felt.size() == 2
                   ? phrase("Analysis",
                            "Proportion of confusions among the responses to the two textures, all "
                            "participants pooled.")
                   : phrase("Analysis",
                            "Proportion of confusions with each other among the responses to the "
                            "two textures of a pair, all participants pooled. There is no CI, "
                            "because the pair is selected as the one confused most often."),
               "confusion", &finding, CountedUnit::answers);
}

}  // namespace

void analyze_recognition(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  const std::vector<Judged> judged = judged_of(gathered, outcome);
  if (judged.empty()) return;
  const Pictures pictures = pictures_in(gathered, judged);
  add_recognition_tables(gathered, judged, pictures, outcome);

  StudyTests tests(gathered);
  const std::size_t people = gathered.people.size();
  const std::vector<std::string> labels(pictures.all.begin(), pictures.all.end());
  std::vector<Finding> findings{};
  std::vector<Finding> likeness{};
  const bool all_shown = std::includes(pictures.all.begin(), pictures.all.end(),
                                       pictures.felt.begin(), pictures.felt.end());
  if (pictures.always_the_same && all_shown && labels.size() > 1) {
    findings = analysis_of("recognition", "recognition", trials_table(gathered, judged, labels));
    if (pictures.felt.size() == labels.size()) {
      std::copy_if(findings.begin(), findings.end(), std::back_inserter(likeness),
                   is_about_likeness);
      for (Finding& finding : likeness) finding.analysis = "similarity";
    } else if (pictures.felt.size() > 1) {
      likeness =
          analysis_of("similarity", "recognition", trials_table(gathered, judged, pictures.felt));
      std::erase_if(likeness, [](const Finding& one) { return !is_about_likeness(one); });
    }
    withhold_fit(likeness);
    keep_findings(findings, outcome,
                  [](const Finding& finding) { return !is_about_likeness(finding); });
    keep_findings(likeness, outcome);
  } else {
    outcome.remarks.push_back(phrase(
        "Analysis",
        "The pictures, and therefore the chance level, differ between trials: sensitivity, "
        "information and similarities over all responses are not meaningful and are left out."));
  }
  const FoundNumbers found(findings);
  const FoundNumbers found_likeness(likeness);
  const std::array<PersonsRow, 1> persons{PersonsRow{"all", ""}};
  add_persons(found, persons, "answers", "share_correct", outcome);
  constexpr std::array kMeasures{Measure{"share_of_pictures_right", "pc"},
                                 Measure{"d_prime", "dprime"},
                                 Measure{"kappa", "kappa"},
                                 Measure{"balanced_share", "balanced.pc"},
                                 Measure{"information_plug_in", "IT.plugin"},
                                 Measure{"information_miller", "IT.miller1955"},
                                 Measure{"information_miller_madow", "IT.millermadow"},
                                 Measure{"information_jackknife", "IT.jackknife"},
                                 Measure{"information_if_errors_equal", "IT.from.pc"},
                                 Measure{"information_at_most", "H.stimulus"}};
  if (!findings.empty()) add_measures(found, kMeasures, outcome);
  add_likeness_tables(pictures.felt, found_likeness, outcome);

  const char* of_right = people > 1 ? "subj.t.p.two" : "pc.p.greater";
  const double chance =
      1.0 / static_cast<double>(labels.size());  // where every trial shows the same pictures
  tests.add("right", "", found, found.find(of_right) != nullptr ? of_right : "subj.t");
  if (pictures.always_the_same) tests.state_chance(chance);
  tests.add("information", "", found, "G.perm.p");
  std::vector<Finding> textures{};
  if (!findings.empty()) {
    textures =
        analysis_of("textures", "proportion", textures_table(gathered, judged, labels.size()));
  }
  const FoundNumbers found_textures(textures);
  for (const std::string& texture : pictures.felt) {
    tests.add("textures", texture, found_textures, "p.greater", texture);
    if (pictures.always_the_same) tests.state_chance(chance);
  }
  std::vector<Finding> sexes{};
  if (std::optional<TidyInput> groups = groups_table(gathered, judged)) {
    sexes = analysis_of("sexes", "group", std::move(*groups));
  }
  keep_findings(sexes, outcome);
  const FoundNumbers found_sexes(sexes);
  if (!sexes.empty()) tests.add("sexes", "F|M", found_sexes, "perm.p.two");
  tests.finish(outcome);
  ask_right(labels.size(), found, tests, outcome);
  ask_information(found, outcome);
  if (!findings.empty()) ask_confused_answers(gathered, judged, pictures, outcome);
  const auto of_sexes = [&](const char* quantity, const char* key) {
    const Finding* finding = found_sexes.find(quantity, key);
    return finding == nullptr ? std::nullopt : std::optional(*finding);
  };
  ask_sexes({.women = of_sexes("subj.mean", "F"),
             .men = of_sexes("subj.mean", "M"),
             .difference = of_sexes("subj.diff", ""),
             .scale = SexesScale::shares_of_answers},
            tests, outcome);
  ask_equivalence_of_sexes(gathered, proportions_right(gathered, judged), outcome);
  std::vector<RepeatedScore> scores{};
  std::vector<TextureResponse> responses{};
  for (const Judged& one : judged) {
    const GatheredAnswer& answer = *one.answer;
    scores.push_back({answer.person, answer.column, answer.repetition, one.right ? 1.0 : 0.0});
    responses.push_back({.person = answer.person, .texture = one.felt, .is_hit = one.right});
  }
  if (pictures.always_the_same) {
    ask_other_textures({.responses = responses,
                        .chance = chance,
                        .proportion = phrase("Analysis", "the proportion correct")},
                       outcome);
  } else {
    add_no_crossed_model("pictures_differ",
                         "the pictures, and therefore the chance level, differ between the trials",
                         outcome);
  }
  ask_reliability(gathered, {scores, phrase("Analysis", "the participants' proportions correct")},
                  outcome);
  add_texture_force(gathered, outcome);
  remark_on_pooling(judged.size(), people, outcome);
}

}  // namespace asperity
