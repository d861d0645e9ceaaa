// Analyses recognition: which picture was chosen for the texture felt.

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "app/findings/methods/recognition/recognition_analysis.h"
#include "app/findings/methods/recognition/recognition_confusions.h"
#include "app/findings/methods/recognition/recognition_similarity.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/outcome/tally.h"
#include "app/findings/outcome/test_sentences.h"
#include "app/findings/shared/choice_tables.h"
#include "app/findings/shared/crossed_textures.h"
#include "app/findings/shared/figures/confusion_figure.h"
#include "app/findings/shared/figures/forest_figures.h"
#include "app/findings/shared/judged_answers.h"
#include "app/findings/shared/participant_pairs.h"
#include "app/findings/shared/repetition_reliability.h"

namespace asperity {

namespace {

constexpr const char* kRecognition =
    "recognition";  // the analysis of the responses, and its family

void add_recognition_tables(const GatheredAnswers& gathered,
                            const std::vector<JudgedAnswer>& judged,
                            const RecognitionPictures& pictures, AnalysisOutcome& outcome) {
  ChapterTally right(gathered);
  std::vector<Tally> by_texture(gathered.words.size());
  ConfusionTally confusions{};
  Tally all{};
  std::set<std::string> options{};
  for (const std::vector<std::string>& list : gathered.option_lists) {
    options.insert(list.begin(), list.end());
  }
  for (const JudgedAnswer& one : judged) {
    const std::uint32_t person = one.answer->person;
    const std::uint64_t outcomes = pictures.of_list[one.answer->options].size();
    all.count(person, one.right, outcomes);
    by_texture[one.felt].count(person, one.right, outcomes);
    confusions.count(one.felt, one.chosen);
    right.count({.column = gathered.column_of(*one.answer),
                 .person = person,
                 .hit = one.right,
                 .outcomes = outcomes});
  }
  right.add("table_3", phrase("Analysis", "Correct responses (counts)"),
            chance_note(all, phrase("Analysis", "Chance level: 1/%1 of the responses correct.")),
            outcome);
  ShareTable shares{
      kAllShares,
      phrase("Analysis", "Proportion correct"),
      phrase(
          "Analysis",
          "The chance level is 1 divided by the number of pictures shown; “cannot tell” counts as "
          "incorrect. p: exact binomial test, two-sided, uncorrected for the number of rows."),
      {columns::kRepetition, columns::kSex},
      columns::kCorrect,
      "share_correct",
      {}};
  right.add_rows(shares);
  add_shares(shares, outcome).figures = [](const ResultTable& table, const AnalysisOutcome& drawn) {
    return std::vector{share_forest(table, drawn, {kPersonMeans, kRecognition})};
  };
  ShareTable textures{kSharesByTexture,
                      phrase("Analysis", "Proportion correct, by texture"),
                      {},
                      {columns::kFelt},
                      columns::kCorrect,
                      "share_correct",
                      {}};
  for (const std::string& texture : pictures.felt) {
    textures.rows.push_back({{texture}, by_texture[*gathered.words.find(texture)]});
  }
  add_shares(textures, outcome).figures = [](const ResultTable& table,
                                             const AnalysisOutcome& drawn) {
    return std::vector{
        answering("right", share_forest(table, drawn, {kPersonMeans, kRecognition}))};
  };
  confusions.add_table(gathered, options, outcome).figures = confusion_figures;
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
  if (!test->p && mean->n == 1) {
    add_question(outcome, "right", question,
                 phrase("Analysis",
                        "Only one participant named a picture: %1 of these responses were correct "
                        "(%2), compared with a chance level of %3; this cannot be tested with one "
                        "participant.")
                     .with(percent(*mean->value), interval_text(*mean), chance),
                 phrase("Analysis",
                        "%1 “Cannot tell” responses name no picture and are left out here; in the "
                        "table of proportions they count as incorrect.")
                     .with(proportion),
                 kAllShares, mean);
    return;
  }
  if (!test->p) {
    add_question(
        outcome, "right", question,
        phrase("Analysis",
               "On average %1 of a participant's responses were correct (%2), compared with a "
               "chance level of %3; all participants have the same proportion correct, so there is "
               "no test.")
            .with(percent(*mean->value), interval_text(*mean), chance),
        method, kAllShares, mean);
    return;
  }
  const auto with_numbers = [&](const Phrase& words) {
    return words.with(percent(*mean->value), interval_text(*mean), chance, p_text(*test));
  };
  const double level = 1.0 / static_cast<double>(pictures);
  const Phrase of_one = with_numbers(
      phrase("Analysis",
             "For this participant only: %1 of the responses were correct (%2), compared with a "
             "chance level of %3; %4. More participants are needed."));
  TestStatements statements = statements_of(
      *test, {.numbers = with_numbers(phrase(
                  "Analysis",
                  "on average %1 of a participant's responses were correct (%2), compared with a "
                  "chance level of %3; %4.")),
              .significant = *mean->value < level
                                 ? phrase("Analysis", "No, significantly below chance: %1")
                                 : phrase("Analysis", "Yes: %1"),
              .not_significant = phrase("Analysis", "Not significantly above chance: %1"),
              .exploratory = {}});
  if (mean->n == 1) statements.claim = statements.told = of_one;
  add_question(outcome, "right", question, said_of(*test, statements), method, kAllShares, mean);
}

void ask_information(const FoundNumbers& found, AnalysisOutcome& outcome) {
  const Finding* bits = found.find("IT.miller1955");
  const auto of = found.value("H.stimulus");
  const auto dprime = found.find("dprime");
  if (bits == nullptr || !bits->value || !of) return;
  const bool enough =
      found.find("IT.N.enough") != nullptr && found.find("IT.N.enough")->word == "TRUE";
  const double shown = std::clamp(*bits->value, 0.0, *of);
  const Phrase sensitivity =
      dprime != nullptr && dprime->value && dprime->low && dprime->high
          ? phrase("Analysis", "d′ = %1, 95 % CI [%2, %3], n = %4 responses")
                .with(display_signed(*dprime->value, 2), display_signed(*dprime->low, 2),
                      display_signed(*dprime->high, 2), std::to_string(dprime->n))
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

/// Whether the responses can be analysed together: every trial showed the same pictures, among them those of all textures felt.
bool have_common_chance(const RecognitionPictures& pictures) {
  const bool all_shown = std::includes(pictures.all.begin(), pictures.all.end(),
                                       pictures.felt.begin(), pictures.felt.end());
  return pictures.always_the_same && all_shown && pictures.all.size() > 1;
}

double chance_of_pictures(const RecognitionPictures& pictures) {
  return 1.0 / static_cast<double>(pictures.all.size());
}

/// `found`: of the family `recognition`, none where there is no common chance.
void add_right_test(const GatheredAnswers& gathered, const RecognitionPictures& pictures,
                    const FoundNumbers& found, StudyTests& tests) {
  const QuantityName of_right =
      gathered.people.size() > 1 ? QuantityName("subj.t.p.two") : "pc.p.greater";
  tests.add("right", "", found, found.find(of_right) != nullptr ? of_right : "subj.t");
  if (pictures.always_the_same) tests.state_chance(chance_of_pictures(pictures));
}

void add_texture_tests(const GatheredAnswers& gathered, const std::vector<JudgedAnswer>& judged,
                       const RecognitionPictures& pictures, StudyTests& tests) {
  std::vector<Finding> textures{};
  if (have_common_chance(pictures)) {
    textures = analysis_of("textures", "proportion",
                           judged_textures_table(gathered, judged, pictures.all.size()));
  }
  const FoundNumbers found(textures);
  for (const std::string& texture : pictures.felt) {
    tests.add("textures", texture, found, "p.greater", texture);
    if (pictures.always_the_same) tests.state_chance(chance_of_pictures(pictures));
  }
}

PairComparisons comparisons_of_people(const GatheredAnswers& gathered,
                                      const std::vector<JudgedAnswer>& judged) {
  std::vector<ParticipantPair> pairs = pairs_of_groups(gathered);
  pairs.insert(pairs.begin(), women_and_men(gathered));
  return {gathered, pairs, responses_of_people(gathered, judged)};
}

}  // namespace

std::vector<StudyTest> test_recognition(const GatheredAnswers& gathered) {
  StudyTests tests(gathered);
  AnalysisOutcome unused{};
  const std::vector<JudgedAnswer> judged = judged_answers(gathered, unused);
  if (judged.empty()) return std::move(tests).take_family();
  const RecognitionPictures pictures = pictures_in(gathered, judged);
  std::vector<Finding> findings{};
  const bool needs_information = tests.is_in_family("information");
  if (have_common_chance(pictures) && (tests.is_in_family("right") || needs_information)) {
    TidyInput input =
        judged_trials_table(gathered, judged, {pictures.all.begin(), pictures.all.end()});
    input.options.set("parts", std::string(needs_information ? "all" : "participants"));
    findings = analysis_of(kRecognition, kRecognition, std::move(input));
  }
  const FoundNumbers found(findings);
  add_right_test(gathered, pictures, found, tests);
  tests.state_effect(found.find("subj.mean"), "mean proportion correct");
  tests.add("information", "", found, "G.perm.p");
  if (tests.is_in_family("textures")) add_texture_tests(gathered, judged, pictures, tests);
  if (tests.is_in_family(kSexesTest) || tests.is_in_family(kGroupsTest)) {
    comparisons_of_people(gathered, judged).add_tests(tests, unused);
  }
  return std::move(tests).take_family();
}

void analyze_recognition(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  const std::vector<JudgedAnswer> judged = judged_answers(gathered, outcome);
  if (judged.empty()) return;
  const RecognitionPictures pictures = pictures_in(gathered, judged);
  add_recognition_tables(gathered, judged, pictures, outcome);

  StudyTests tests(gathered);
  const std::size_t people = gathered.people.size();
  const std::vector<std::string> labels(pictures.all.begin(), pictures.all.end());
  std::vector<Finding> findings{};
  std::vector<Finding> similarity{};
  if (have_common_chance(pictures)) {
    findings =
        analysis_of(kRecognition, kRecognition, judged_trials_table(gathered, judged, labels));
    if (pictures.felt.size() == labels.size()) {
      std::copy_if(findings.begin(), findings.end(), std::back_inserter(similarity),
                   is_about_similarity);
      for (Finding& finding : similarity) finding.analysis = kTextureSimilarity;
    } else if (pictures.felt.size() > 1) {
      similarity = analysis_of(kTextureSimilarity, kRecognition,
                               judged_trials_table(gathered, judged, pictures.felt));
      std::erase_if(similarity, [](const Finding& one) { return !is_about_similarity(one); });
    }
    withhold_fit(similarity);
    keep_findings(findings, outcome,
                  [](const Finding& finding) { return !is_about_similarity(finding); });
    keep_findings(similarity, outcome);
  } else {
    outcome.remarks.push_back(phrase(
        "Analysis",
        "The pictures, and therefore the chance level, differ between trials: sensitivity, "
        "information and similarities over all responses are not meaningful and are left out."));
  }
  const FoundNumbers found(findings);
  const FoundNumbers found_similarity(similarity);
  const std::array<PersonsRow, 1> persons{PersonsRow{"all", ""}};
  add_persons(found, persons, columns::kAllAnswers, "share_correct", outcome);
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
  add_similarity_tables(pictures.felt, found_similarity, outcome);

  add_right_test(gathered, pictures, found, tests);
  tests.add("information", "", found, "G.perm.p");
  add_texture_tests(gathered, judged, pictures, tests);
  const PairComparisons compared = comparisons_of_people(gathered, judged);
  compared.add_tests(tests, outcome);
  tests.finish(outcome);
  ask_right(labels.size(), found, tests, outcome);
  ask_information(found, outcome);
  if (!findings.empty()) ask_confusions(gathered, judged, pictures, outcome);
  compared.ask(PairScale::shares_of_answers, "", tests, outcome);
  std::vector<RepeatedScore> scores{};
  std::vector<TextureResponse> responses{};
  for (const JudgedAnswer& one : judged) {
    const GatheredAnswer& answer = *one.answer;
    scores.push_back(
        {answer.person, gathered.column_of(answer), answer.repetition, one.right ? 1.0 : 0.0});
    responses.push_back({.person = answer.person, .texture = one.felt, .is_hit = one.right});
  }
  if (pictures.always_the_same) {
    ask_other_textures({.responses = responses,
                        .chance = chance_of_pictures(pictures),
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
