// The methods section of a text for a paper.

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/study_analysis.h"
#include "app/findings/outcome/task_words.h"
#include "app/report/text/report_arrangement.h"
#include "app/report/text/report_languages.h"
#include "app/report/text/report_paper.h"
#include "app/report/text/report_paper_trials.h"
#include "app/report/text/report_parameters.h"
#include "app/report/text/report_roughness.h"
#include "app/words/coded_phrases.h"
#include "app/words/text_parts.h"
#include "protocols/design/block_factors.h"
#include "protocols/kinds/experiment_kind.h"
#include "renderers/offline/perceived_instability.h"
#include "renderers/offline/unexplained_vibration.h"
#include "results_schema/hashes/short_hash.h"

namespace asperity {

namespace {

/// " in one session each", " in 5 sessions in total"
std::string sessions_of_participants(const ReportFacts& facts) {
  std::map<std::string, std::size_t> counts{};
  for (const ReportedSession& session : facts.sessions) ++counts[session.row.participant];
  if (counts.empty()) return {};
  const std::size_t first = counts.begin()->second;
  const bool is_same = std::all_of(counts.begin(), counts.end(),
                                   [first](const auto& each) { return each.second == first; });
  const std::size_t shown = is_same ? first : facts.sessions.size();
  return " in " + count_in_words(shown) + (shown == 1 ? " session" : " sessions") +
         (!is_same             ? " in total"
          : counts.size() == 1 ? ""
                               : " each");
}

/// "Two sessions were not completed (one was stopped and one was interrupted)."
std::string unfinished_sessions(const ReportFacts& facts) {
  std::map<std::string, std::size_t> states{};
  std::size_t all = 0;
  for (const ReportedSession& session : facts.sessions) {
    if (session.row.state == SessionState::completed) continue;
    ++all;
    ++states[session.is_running                           ? "running"
             : session.row.state == SessionState::open    ? "left open"
             : session.row.state == SessionState::stopped ? "stopped"
                                                          : "interrupted"];
  }
  if (all == 0) return {};
  std::vector<std::string> parts{};
  for (const auto& [state, count] : states) {
    parts.push_back(count_in_words(count) + (count == 1 ? " was " : " were ") + state);
  }
  return capitalised(count_in_words(all)) +
         (all == 1 ? " session was not completed (" : " sessions were not completed (") +
         (states.size() == 1 ? states.begin()->first : listed(parts)) + ").";
}

/// "One session was interrupted and resumed."
std::string resumed_sessions(const ReportFacts& facts) {
  const auto all = std::count_if(facts.sessions.begin(), facts.sessions.end(),
                                 [](const auto& session) { return session.resumed > 0; });
  if (all == 0) return {};
  return capitalised(count_in_words(static_cast<std::uint64_t>(all))) +
         (all == 1 ? " session was interrupted and resumed."
                   : " sessions were interrupted and resumed.");
}

/// "Two sessions were excluded from the analysis (fire alarm; wrong hand)."
std::string excluded_sessions(const ReportFacts& facts) {
  std::size_t all = 0;
  std::string reasons{};
  std::set<std::string> known{};
  for (const ReportedSession& session : facts.sessions) {
    if (!session.row.excluded) continue;
    ++all;
    const std::string reason = phrase_of(session.row.excluded).english();
    if (reason.empty() || !known.insert(reason).second) continue;
    reasons += (reasons.empty() ? "" : "; ") + reason;
  }
  if (all == 0) return {};
  return capitalised(count_in_words(all)) + (all == 1 ? " session was" : " sessions were") +
         " excluded from the analysis" + (reasons.empty() ? "" : " (" + reasons + ')') + '.';
}

std::string paper_participants(const ReportFacts& facts, const StudyMetadata& metadata) {
  const SampleTexts sample = sample_texts(facts);
  std::string brackets{};
  for (const std::string& part :
       {sample.sexes, sample.ages.empty() ? "" : "age: " + sample.ages, sample.hands}) {
    if (!part.empty()) brackets += (brackets.empty() ? "" : "; ") + part;
  }
  std::string text = capitalised(participants_text(facts.group, facts.participants.size()));
  if (!brackets.empty()) text += " (" + brackets + ')';
  const std::string sessions = with_sentences({sessions_of_participants(facts) + '.',
                                               groups_text(facts), unfinished_sessions(facts),
                                               resumed_sessions(facts), excluded_sessions(facts)});
  switch (facts.group) {
    case AnswerGroup::people:
      text += " took part" + sessions;
      break;
    case AnswerGroup::pilot:
      text += " took part in the pilot study" + sessions;
      break;
    case AnswerGroup::virtual_participants:
      return text + (facts.participants.size() == 1 ? " was simulated" : " were simulated") +
             sessions + " No human participant took part.";
  }
  const auto consented = static_cast<std::size_t>(std::count_if(
      facts.sessions.begin(), facts.sessions.end(),
      [](const ReportedSession& each) { return each.row.consent_version.has_value(); }));
  if (consented > 0) {
    const SessionShare share{.whole = consented, .all = facts.sessions.size()};
    text += " Consent was obtained beforehand" +
            (share.whole == share.all ? "." : ' ' + share.text() + '.');
  }
  if (!facts.withdrawals.empty()) text += ' ' + withdrawals_text(facts.withdrawals).text;
  if (metadata.ethics_approval) text += " Ethics approval: " + stopped(*metadata.ethics_approval);
  return text;
}

/// ", a plug-in with the SHA-256 0f1e2d3c…"; empty for a built-in model.
std::string plugin_text(const ReportFacts& facts, const std::string& model) {
  const auto builds = facts.plugin_builds.find(model);
  if (builds == facts.plugin_builds.end()) return {};
  std::vector<std::string> hashes{};
  for (const std::string& sha256 : builds->second) hashes.push_back(short_hash(sha256) + "…");
  return ", a plug-in with the SHA-256 " + listed(hashes);
}

std::string paper_apparatus(const ReportFacts& facts) {
  if (facts.models.empty()) return {};
  std::vector<std::string> models{};
  for (const std::string& model : facts.models) {  // "height_map 1"
    const std::size_t blank = model.rfind(' ');
    models.push_back(blank == std::string::npos
                         ? model
                         : model.substr(0, blank) + " (version " + model.substr(blank + 1) +
                               plugin_text(facts, model) + ')');
  }
  std::set<std::string> programs{};
  for (const ReportedSession& session : facts.sessions) {
    for (const RecordedStretch& stretch : session.stretches)
      programs.insert(stretch.program.program);
  }
  std::string text =
      "Surfaces were rendered (" + listed({programs.begin(), programs.end()}) + ") with the " +
      std::string(facts.models.size() == 1 ? "force model " : "force models ") + listed(models);
  std::set<double> rates_Hz{};
  for (const ReportedSession& session : facts.sessions) rates_Hz.insert(session.row.rate_Hz);
  if (rates_Hz.size() == 1) {
    text += " at a servo rate of " + display_quantity(*rates_Hz.begin(), "Hz");
  }
  const std::string devices = devices_in(facts);
  if (!devices.empty()) text += "; device: " + devices;
  text += '.';
  if (facts.file.protocol) {
    const Protocol& protocol = *facts.file.protocol;
    text += " The stiffness was " + stiffness_text(facts.stiffness_N_per_m, protocol) +
            ", the coefficient of friction was " + friction_text(facts.friction, protocol) +
            ", and forces were limited to " + display_quantity(protocol.force_limit_N, "N") + '.';
  }
  if (const std::string parameters = paper_parameters(facts); !parameters.empty()) {
    text += ' ' + parameters;
  }
  if (facts.group != AnswerGroup::virtual_participants) {
    if (const std::string unfelt = unfelt_force_text(facts); !unfelt.empty()) text += ' ' + unfelt;
  }
  if (const std::string matched = equal_force_text(facts); !matched.empty()) text += ' ' + matched;
  if (const std::string matched = equal_roughness_text(facts); !matched.empty()) {
    text += ' ' + matched;
  }
  return text;
}

std::string paper_environment(const ReportFacts& facts) {
  if (facts.group == AnswerGroup::virtual_participants) return {};
  const SessionShare masked = share_of_sessions(
      facts, [](const RecordedStretch& stretch) { return stretch.eye_mask_confirmed; });
  const std::string noise = recorded_noise_text(facts);
  return masked.is_any()
             ? with_sentences({"Participants wore an eye mask while exploring (confirmed " +
                                   masked.text() + ").",
                               noise})
             : noise;
}

std::string factors_sentence(const Protocol& protocol) {
  std::vector<std::string> factors{};
  for (const auto& [name, factor] : protocol.factors) {
    // The levels of a varied parameter belong to the description of the task.
    if (!is_varied(protocol, name)) factors.push_back(factor_text(name, factor));
  }
  if (factors.empty()) return {};
  return (factors.size() == 1 ? "The factor was " : "The factors were ") + listed(factors) + '.';
}

/// The factor whose levels are presented together in every trial of the main phase, each once; null
/// where there is none.
const Factor* factor_within_trials(const Protocol& protocol) {
  const Factor* within = nullptr;
  for (const auto& [block_name, block] : protocol.blocks) {
    if (block.phase != Phase::main) continue;
    std::map<std::string, std::set<Level>, std::less<>> levels{};
    for (const Protocol::Presented& presented : block.presented) {
      for (const auto& [factor, level] : presented.with) levels[factor].insert(level);
    }
    const Factor* of_block = nullptr;
    for (const auto& [factor, presented] : levels) {
      const auto known = protocol.factors.find(factor);
      if (known == protocol.factors.end() || presented.size() < 2 ||
          presented.size() != block.presented.size() ||
          presented.size() != known->second.levels.size()) {
        continue;
      }
      if (of_block != nullptr) return nullptr;
      of_block = &known->second;
    }
    if (of_block == nullptr || (within != nullptr && within != of_block)) return nullptr;
    within = of_block;
  }
  return within;
}

/// ", one for each level of model", where every answered trial had that many stimuli.
std::string within_text(const ReportFacts& facts) {
  const Factor* within = factor_within_trials(*facts.file.protocol);
  if (within == nullptr || facts.surfaces != std::set<std::size_t>{within->levels.size()})
    return {};
  return ", one for each level of " + words_of_parameter(within->name);
}

std::string stimuli_were_presented(const std::set<std::size_t>& counts) {
  if (counts == std::set<std::size_t>{1}) return "one stimulus was presented";
  return (counts.size() == 1 ? count_in_words(*counts.begin()) : "several") +
         " stimuli were presented";
}

/// "In each trial, three stimuli were presented, one for each level of model, …"; with several kinds of blocks a sentence
/// for each, with the numbers of the protocol.
std::string paper_task(const ReportFacts& facts) {
  const Protocol& protocol = *facts.file.protocol;
  // Without kinds that only accompany the questions of others.
  std::vector<const ExperimentKind*> kinds = analysed_kinds_of(protocol);
  std::erase_if(kinds, [&protocol](const ExperimentKind* kind) {
    return std::none_of(protocol.blocks.begin(), protocol.blocks.end(), [kind](const auto& each) {
      return each.second.phase == Phase::main && &kind_of(each.second) == kind;
    });
  });
  if (kinds.size() == 1) {
    return "In each trial, " + stimuli_were_presented(facts.surfaces) + within_text(facts) +
           find_analysis(kinds.front()->id)->task_for_paper(protocol);
  }
  std::string text{};
  for (const ExperimentKind* const kind : kinds) {
    std::set<std::size_t> counts{};
    for (const auto& [name, block] : protocol.blocks) {
      if (block.phase == Phase::main && &kind_of(block) == kind) {
        counts.insert(surfaces_in_trial(block));
      }
    }
    text += (text.empty() ? "In each trial of the " : " In each trial of the ") +
            name_of_kind(kind->id) + ", " + stimuli_were_presented(counts) +
            find_analysis(kind->id)->task_for_paper(protocol);
  }
  return text;
}

/// "Each response of the absolute identification was accompanied by ratings on one continuous scale from 0 to 100."
std::string paper_accompanying_scales(const Protocol& protocol) {
  std::vector<std::string> sentences{};
  for (const ExperimentKind* const kind : analysed_kinds_of(protocol)) {
    if (std::holds_alternative<ScaleForm>(kind->form)) continue;
    const std::string scales = scales_of_blocks(protocol, kind->id);
    if (scales.empty()) continue;
    sentences.push_back("Each response of the " + name_of_kind(kind->id) +
                        " was accompanied by ratings on " + scales + '.');
  }
  return with_sentences(sentences);
}

std::string paper_questions(const Protocol& protocol) {
  const std::vector<std::string> questions = main_questions(protocol);
  if (questions.empty()) return {};
  const bool can_abstain =
      std::any_of(protocol.blocks.begin(), protocol.blocks.end(), [](const auto& each) {
        const auto& asked = each.second.questions;
        return each.second.phase == Phase::main &&
               std::any_of(asked.begin(), asked.end(),
                           [](const auto& question) { return question.allow_cannot_tell; });
      });
  return (questions.size() == 1 ? "The question was " : "The questions were ") + listed(questions) +
         (questions.back().ends_with("?”") || questions.back().ends_with(".”") ||
                  questions.back().ends_with("!”")
              ? ""
              : ".") +
         (can_abstain ? " “Cannot tell” was also a response option." : "");
}

/// The rule for vibrations that no force model contains, where the protocol has one.
std::string vibrating_attempts(const Protocol& protocol) {
  if (!protocol.instability) return {};
  const std::string excess = "if a surface vibrated above " + display_quantity(kBuzzFrom_Hz, "Hz") +
                             " with an RMS force of more than " +
                             number_text(protocol.instability->buzz_max) +
                             " times its texture force, which was counted as at least " +
                             display_quantity(1e3 * kLeastTexture_N, "mN");
  switch (protocol.instability->on) {
    case InstabilityRule::OnExcess::flag:
      return " An attempt was flagged " + excess + '.';
    case InstabilityRule::OnExcess::repeat_now:
      return " An attempt was also invalid, and was repeated at most twice, " + excess + '.';
  }
  return {};
}

/// When the program counts an attempt as invalid, regardless of later decisions.
std::string invalid_attempts(const Protocol& protocol) {
  const auto more_than = [](int count, const std::string& one, const std::string& several) {
    return count == 0 ? "any " + one + " was"
                      : "more than " + std::to_string(count) + ' ' + (count == 1 ? one : several) +
                            " were";
  };
  return "An attempt at a trial was invalid if " +
         more_than(protocol.maximum_missed_deadlines, "deadline of the servo loop",
                   "deadlines of the servo loop") +
         " missed during contact, if " +
         more_than(protocol.maximum_gaps_in_contact, "gap of more than two periods between ticks",
                   "gaps of more than two periods between ticks") +
         " found during contact, or if " +
         more_than(protocol.maximum_lost_records, "sample of the recording",
                   "samples of the recording") +
         " lost." + vibrating_attempts(protocol);
}

}  // namespace

std::vector<std::string> paper_procedure(const ReportFacts& facts, const StudyMetadata& metadata,
                                         Sources& sources) {
  std::vector<std::string> paragraphs{with_sentences(
      {paper_participants(facts, metadata), paper_apparatus(facts), paper_environment(facts)})};
  if (!facts.file.protocol) return paragraphs;
  const Protocol& protocol = *facts.file.protocol;
  std::vector<std::string> task{};
  if (facts.sources.size() > 1) {
    task.push_back(facts.are_translations
                       ? "The protocol was run in " + count_in_words(facts.sources.size()) +
                             " versions that differ in language and texts only."
                       : "The protocol has " + count_in_words(facts.sources.size()) +
                             " files of this version; the description below is from the first.");
    task.back() += languages_text(facts);
  }
  task.push_back(factors_sentence(protocol));
  task.push_back(with_citations(paper_task(facts), sources));
  task.push_back(external_programs_text(facts));
  task.push_back(paper_accompanying_scales(protocol));
  task.push_back(paper_questions(protocol));
  task.push_back(paper_arrangement(protocol));
  paragraphs.push_back(with_sentences(task));
  paragraphs.push_back(with_sentences({paper_order(facts, sources), invalid_attempts(protocol)}));
  return paragraphs;
}

}  // namespace asperity
