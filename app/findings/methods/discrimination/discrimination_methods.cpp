// Composes sentences on fit, intervals, posterior, means and d′ from the blocks, each stated once.

#include "app/findings/methods/discrimination/discrimination_methods.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <variant>

#include "analysis/numbers/number_text.h"
#include "app/findings/methods/discrimination/sensitivity/confidence_roc.h"
#include "app/findings/methods/discrimination/sensitivity/discrimination_sensitivity.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_coverage.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_thresholds.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_tracks.h"
#include "app/findings/methods/discrimination/thresholds/unforced_functions.h"
#include "app/findings/outcome/display_number.h"
#include "protocols/design/block_factors.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/kinds/kind_list.h"
#include "protocols/plan/block_design.h"
#include "protocols/plan/roughness_matching.h"

namespace asperity {

/// The main blocks of this kind that vary a parameter relative to a stated standard.
std::vector<const Protocol::Block*> discrimination_blocks(const Protocol& protocol) {
  std::vector<const Protocol::Block*> blocks{};
  for (const auto& [name, block] : protocol.blocks) {
    if (block.phase != Phase::main || block.kind != discrimination_kind().id) continue;
    if (block.vary && block.vary->standard) blocks.push_back(&block);
  }
  return blocks;
}

bool asks_for_performance(const Protocol::Block& block) {
  const auto* const asked = judged_question(block);
  return asked != nullptr && asked->judgement() == DiscriminationJudgement::performance;
}

namespace {

using Block = Protocol::Block;

/// Whether functions contain responses "cannot tell" (`DiscriminationResults::unsure`).
struct UnforcedParticipants {
  bool has_unforced = false;  ///< functions with such a response
  bool has_forced = false;    ///< functions without one
};

UnforcedParticipants unforced_participants(const AnalysisOutcome& outcome) {
  std::set<FindingKey> with_responses{};
  for (const Finding& finding : outcome.findings) {
    if (finding.analysis == kUnsure && finding.value.value_or(0.0) > 0.0) {
      with_responses.insert(finding.key);
    }
  }
  UnforcedParticipants found{.has_unforced = !with_responses.empty()};
  for (const Finding& finding : outcome.findings) {
    if (finding.analysis != kThresholds || !is(finding, "standard")) continue;
    found.has_forced = found.has_forced || !with_responses.contains(finding.key);
  }
  return found;
}

bool allows_cannot_tell(const Block& block) {
  return std::any_of(
      block.questions.begin(), block.questions.end(), [&block](const auto& question) {
        return question.allow_cannot_tell && kind_of_question(kind_of(block), question) != nullptr;
      });
}

/// " Each response “cannot tell” counted as …"
std::string split_sentence(const Block& block) {
  const std::string part = block.design()->alternatives() == 2 ? "one half" : "one third";
  return " Each response “cannot tell” counted as the mean of a guess, " + part +
         (asks_for_performance(block) ? " of a correct response" : " of a choice of each surface") +
         " [Kaernbach 2001].";
}

/// The intervals of constant stimuli.
std::string interval_at_constant_levels(const Block& block, const UnforcedParticipants& unforced) {
  const bool is_of_performance = asks_for_performance(block);
  const std::string delta = std::string(" by the delta method") +
                            (is_of_performance ? "" : ", for the JND on the logarithmic scale");
  if (!unforced.has_unforced || !allows_cannot_tell(block)) {
    return " Confidence intervals (CI) of single participants are" + delta + '.';
  }
  return " Confidence intervals (CI) of single participants" +
         std::string(unforced.has_forced ? " with responses “cannot tell”" : "") +
         " are bootstrap percentiles (" + std::to_string(kUnforcedResamples) +
         " resamples of the three outcomes at each level)" +
         (unforced.has_forced ? "; those of the other participants are" + delta : "") + '.' + ' ' +
         note_on_unforced_jnd(is_of_performance).english();
}

/// How the intervals of single participants are made, and how the slope is limited where a procedure chose the levels.
std::string interval_sentence(const Block& block, const UnforcedParticipants& unforced) {
  if (block.design()->has_noise()) {
    return " Confidence intervals (CI) of single participants are Wald intervals on the "
           "logarithmic scale.";
  }
  if (!chooses_levels_from_answers(block)) return interval_at_constant_levels(block, unforced);
  const ProcedureSettings& first = block.procedure->tracks.front();
  const bool has_prior = posterior_track_of(first) != nullptr;
  const bool is_external = std::holds_alternative<External>(first);
  return (asks_for_performance(block) ? " The slope of the function was limited to " +
                                            display_number(kSlopesOfProcedures.least) + " to " +
                                            display_number(kSlopesOfProcedures.greatest) + '.'
                                      : std::string()) +
         (is_external
              ? " Confidence intervals of single participants were not computed: the levels "
                "that the program would have stated after other responses are unknown."
          : has_prior ? std::string()
                      : " Confidence intervals (CI) of single participants are likelihood-ratio "
                        "intervals whose critical value was found by running the procedure again "
                        "with " +
                            std::to_string(kRepetitionsOfProcedures) + " simulated observers.");
}

/// Empty where the procedure has no prior.
std::string posterior_sentence(const Block& block) {
  if (!block.procedure || posterior_track_of(block.procedure->tracks.front()) == nullptr) return {};
  return std::string(" In addition, the posterior mean of the ") +
         (*block.vary->standard == 0.0 ? "detection threshold" : "JND") +
         " on the logarithmic scale was computed with the prior of the procedure and the responses "
         "of all trials; its 95 % credible interval (CrI) has equal tails.";
}

std::string mean_sentence(const Block& block) {
  return asks_for_performance(block)
             ? " Means over participants are geometric, with CIs based on Student's t on the "
               "logarithmic scale."
             : " Mean PSEs are arithmetic and mean JNDs geometric, with CIs based on Student's t, "
               "of JNDs on the logarithmic scale.";
}

/// The model of a design with options in words, and its decision rule.
std::string fit_in_words(const Block& block) {
  const std::string threshold =
      std::string(*block.vary->standard == 0.0 ? "detection threshold"
                                               : "just-noticeable difference (JND)") +
      " is the difference from the standard with d′ = 1";
  const std::string model =
      "d′ as a power function of the difference from the standard and lapse rates fixed at 2 % in "
      "both directions. The ";
  return block.design()->surfaces() == 1
             ? "For each participant and condition, the responses “yes” were modelled by signal "
               "detection [Macmillan 2005] by maximum likelihood, with " +
                   model + threshold + "."
             : "For each participant and condition, the responses “different” were modelled by "
               "signal detection with the differencing rule [Macmillan 2005] by maximum "
               "likelihood, with " +
                   model + threshold +
                   "; an observer with this rule compares the difference of two impressions with a "
                   "criterion.";
}

/// "50 %", "33.3 %"
std::string per_cent_of(double proportion) {
  return number_text(std::round(1000.0 * proportion) / 10.0) + " %";
}

std::string fit_of_block(const Block& block) {
  if (block.design()->has_noise()) return fit_in_words(block);
  if (!asks_for_performance(block)) {
    return "For each participant and condition, a cumulative normal function was fitted to the "
           "choices by maximum likelihood, with lapse rates fixed at 2 % in both directions. The "
           "point of subjective equality (PSE) is the value at which both responses are equally "
           "frequent, and the just-noticeable difference (JND) is half the distance between the "
           "values at 25 % and 75 %.";
  }
  const std::string fit =
      std::string(
          "For each participant and condition, a Weibull function of the difference from "
          "the standard ") +
      "was fitted to the correct responses by maximum likelihood, with the guess rate fixed at " +
      per_cent_of(block.design()->guess_rate()) + " and a lapse rate between 0 and 6 %. The ";
  return fit +
         (*block.vary->standard == 0.0 ? "detection threshold is the value"
                                       : "just-noticeable difference (JND) is the difference") +
         " at " + per_cent_of(proportion_at_threshold(*block.design())) + " correct responses.";
}

/// Whether the outcome answers a question with this name, of one or of several tasks, by a number.
bool has_answer(const AnalysisOutcome& outcome, const std::string& name) {
  return std::any_of(
      outcome.questions.begin(), outcome.questions.end(), [&name](const AnsweredQuestion& each) {
        return (each.name == name || each.name.starts_with(name + ':')) && each.finding.value;
      });
}

std::string sensitivity_method(const Block& block) {
  const DiscriminationDesign& design = *block.design();
  if (design.is_choice_of_three()) {
    return std::string(" d′ at each level is that of ") +
           (design.asks_for_odd_one ? "an oddity task by the differencing rule [Frijters 1979]"
                                    : "an unbiased choice among three [Hacker 1979]") +
           ", with the proportion correct estimated by (correct responses + 1/3)/(trials + 1).";
  }
  if (!design.has_noise()) return {};
  const bool is_pair = design.surfaces() > 1;
  return std::string(
             " d′ at each level was computed from the hit rate at the level and the "
             "false-alarm rate in all trials ") +
         (is_pair ? "with equal surfaces, by the differencing rule [Macmillan 2005], with the "
                    "log-linear correction [Hautus 1995]."
                  : "without a signal, d′ = z(H) − z(F), with the log-linear correction [Hautus "
                    "1995].");
}

/// How d′ and the ROC were computed, as far as the outcome states them.
std::string sensitivity_methods(const std::vector<const Block*>& blocks,
                                const AnalysisOutcome& outcome) {
  std::string text{};
  if (has_answer(outcome, kSensitivity)) {
    for (const Block* const block : blocks) {
      const std::string sentence = sensitivity_method(*block);
      if (text.find(sentence) == std::string::npos) text += sentence;
    }
    const bool has_interval = std::any_of(
        outcome.questions.begin(), outcome.questions.end(), [](const AnsweredQuestion& each) {
          return each.name.starts_with(kSensitivity) && each.finding.low;
        });
    if (has_interval) {
      text +=
          " CIs of mean d′ are expanded percentiles of a bootstrap over participants [Hesterberg "
          "2015].";
    }
  }
  if (!has_answer(outcome, kConfidenceRoc)) return text;
  return text +
         " Responses and ratings of confidence together formed ordered categories, to which a "
         "normal model with unequal variances was fitted by maximum likelihood over the responses "
         "of all participants [Dorfman 1969]. A_z is the area under its ROC, and d_a the "
         "difference between the means divided by the root mean square of the standard deviations "
         "[Simpson 1973]; equal variances were tested by a likelihood ratio, in exploratory and "
         "uncorrected tests that treat all responses as independent.";
}

}  // namespace

std::string paper_fit_of_discrimination(const Protocol& protocol, const AnalysisOutcome& outcome) {
  const std::vector<const Block*> blocks = discrimination_blocks(protocol);
  const UnforcedParticipants unforced = unforced_participants(outcome);
  std::string text{};
  for (const Block* const block : blocks) {
    if (matches_roughness(protocol, *block)) continue;  // its matches are reported instead
    for (const std::string& sentence :
         {fit_of_block(*block),
          unforced.has_unforced && allows_cannot_tell(*block) ? split_sentence(*block)
                                                              : std::string(),
          interval_sentence(*block, unforced), posterior_sentence(*block), mean_sentence(*block)}) {
      if (text.find(sentence) != std::string::npos) continue;
      text += (text.empty() || sentence.starts_with(' ') ? "" : " ") + sentence;
    }
  }
  return text + sensitivity_methods(blocks, outcome);
}

std::string sensitivity_sentences(const AnalysisOutcome& outcome) {
  double unsure = 0.0;
  double all = 0.0;
  std::map<std::string, std::pair<double, double>> by_participant{};
  for (const Finding& finding : outcome.findings) {
    if (finding.analysis != kUnsure || !finding.value) continue;
    const auto n = static_cast<double>(finding.n);
    auto& [own, own_n] = by_participant[finding.key[0]];
    own += n * *finding.value;
    own_n += n;
    unsure += n * *finding.value;
    all += n;
  }
  std::string text{};
  if (all > 0.0) {
    double least = 1.0;
    double most = 0.0;
    for (const auto& [participant, of] : by_participant) {
      least = std::min(least, of.first / of.second);
      most = std::max(most, of.first / of.second);
    }
    text += " The rate of the response “cannot tell” was " + display_percent(unsure / all) +
            (least < most ? " (" + display_percent(least) + " to " + display_percent(most) +
                                " for single participants)"
                          : std::string()) +
            '.';
  }
  for (const AnsweredQuestion& each : outcome.questions) {
    const bool is_stated =
        each.name.starts_with(kSensitivity) || each.name.starts_with(kConfidenceRoc);
    if (is_stated && each.finding.value) text += ' ' + each.answer.english();
  }
  return text;
}

}  // namespace asperity
