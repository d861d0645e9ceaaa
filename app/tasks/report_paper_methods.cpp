// How a study was made, as the methods section of a paper states it.

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "app/analyses/cell_words.h"
#include "app/analyses/reading_number.h"
#include "app/coded_phrases.h"
#include "app/tasks/report_paper.h"
#include "protocols/stored_protocol.h"

namespace asperity {

namespace {

std::string paper_participants(const ReportFacts& facts, const StudyMetadata& metadata) {
  const SampleTexts sample = sample_texts(facts);
  std::string brackets{};
  for (const std::string& part :
       {sample.sexes, sample.ages.empty() ? "" : "age: " + sample.ages, sample.hands}) {
    if (!part.empty()) brackets += (brackets.empty() ? "" : "; ") + part;
  }
  std::string text = capitalised(participants_text(facts.group, facts.participants.size()));
  if (!brackets.empty()) text += " (" + brackets + ')';
  switch (facts.group) {
    case AnswerGroup::people:
      text += " took part.";
      break;
    case AnswerGroup::pilot:
      text += " took part in pilot sessions.";
      break;
    case AnswerGroup::virtual_participants:
      return text + (facts.participants.size() == 1 ? " was simulated" : " were simulated") +
             "; no person took part.";
  }
  const auto consented = static_cast<std::size_t>(std::count_if(
      facts.sessions.begin(), facts.sessions.end(),
      [](const ReportedSession& each) { return each.row.consent_version.has_value(); }));
  if (consented > 0) {
    const SessionShare share{.whole = consented, .all = facts.sessions.size()};
    text += " Consent was obtained beforehand" +
            (share.whole == share.all ? "." : ' ' + share.text() + '.');
  }
  const auto excluded = static_cast<std::size_t>(
      std::count_if(facts.sessions.begin(), facts.sessions.end(),
                    [](const ReportedSession& each) { return each.row.excluded.has_value(); }));
  if (excluded > 0) {
    text += ' ' + capitalised(count_in_words(excluded)) +
            (excluded == 1 ? " session was" : " sessions were") + " excluded from the analysis.";
  }
  if (!facts.withdrawals.empty()) text += ' ' + withdrawals_text(facts.withdrawals).text;
  if (metadata.ethics_approval) text += " Ethics approval: " + stopped(*metadata.ethics_approval);
  return text;
}

std::string paper_apparatus(const ReportFacts& facts) {
  if (facts.models.empty()) return {};
  std::vector<std::string> models{};
  for (const std::string& model : facts.models) {  // "height_map 1"
    const std::size_t blank = model.rfind(' ');
    models.push_back(blank == std::string::npos
                         ? model
                         : model.substr(0, blank) + " (version " + model.substr(blank + 1) + ')');
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
    text += " at a servo rate of " + reading_quantity(*rates_Hz.begin(), "Hz");
  }
  const std::string devices = devices_in(facts);
  if (!devices.empty()) text += "; device: " + devices;
  text += '.';
  if (facts.file.protocol) {
    text += " The stiffness was " +
            reading_quantity(facts.file.protocol->material.stiffness_N_per_m, "N/m") +
            ", and forces were limited to " +
            reading_quantity(facts.file.protocol->force_limit_N, "N") + '.';
  }
  if (facts.group != AnswerGroup::virtual_participants) {
    if (const std::string unfelt = unfelt_force_text(facts); !unfelt.empty()) text += ' ' + unfelt;
  }
  if (facts.has_equal_force) {
    text +=
        " The force models were matched in the RMS of their texture force along a prescribed path.";
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

/// "three textures were presented"; the number only where every answered trial had the same.
std::string presented_text(const ReportFacts& facts, const std::string& one,
                           const std::string& several) {
  const std::string number =
      facts.surfaces.size() == 1 ? count_in_words(*facts.surfaces.begin()) : "several";
  const bool is_one = facts.surfaces == std::set<std::size_t>{1};
  return "In each trial, " + number + ' ' + (is_one ? one + " was" : several + " were") +
         " presented";
}

std::string paper_task(const ReportFacts& facts) {
  const Protocol& protocol = *facts.file.protocol;
  switch (protocol.kind) {
    case ProtocolKind::selection: {
      const auto parameter = stored_protocol(protocol.source).compared_parameter;
      return presented_text(facts, "surface", "surfaces") +
             (parameter ? " that differed in " + *parameter + " alone" : "") +
             ", and one was to be chosen.";
    }
    case ProtocolKind::matching:
      return presented_text(facts, "texture", "textures") +
             ", and each was to be assigned to one of as many pictures.";
    case ProtocolKind::recognition:
      return "In each trial, one texture was presented, and its picture was to be chosen among "
             "several.";
    case ProtocolKind::magnitude:
      return "In each trial, one surface was presented, and its roughness was to be given a number "
             "(absolute magnitude estimation with free modulus).";
  }
  return {};
}

std::string paper_questions(const Protocol& protocol) {
  const std::vector<std::string> questions = main_questions(protocol);
  if (questions.empty()) return {};
  return (questions.size() == 1 ? "The question was " : "The questions were ") + listed(questions) +
         (questions.back().ends_with("?”") || questions.back().ends_with(".”") ||
                  questions.back().ends_with("!”")
              ? ""
              : ".");
}

std::string paper_order(const ReportFacts& facts, Sources& sources) {
  const Protocol& protocol = *facts.file.protocol;
  std::set<int> trials{};
  for (const ReportedSession& session : facts.sessions) trials.insert(session.main_trials);
  std::string text{};
  if (!trials.empty()) {
    text = "A session was planned with " + std::to_string(*trials.begin()) +
           (trials.size() == 1 ? "" : " to " + std::to_string(*trials.rbegin())) +
           (trials == std::set<int>{1} ? " experimental trial." : " experimental trials.");
  }
  switch (protocol.counterbalance) {
    case Protocol::Counterbalance::none:
      break;
    case Protocol::Counterbalance::latin:
      text += " The order of the levels was counterbalanced by a Latin square.";
      break;
    case Protocol::Counterbalance::williams:
      text += " The order of the levels was counterbalanced by a Williams square" +
              cited("Williams 1949", sources) + '.';
      break;
  }
  for (const auto& [name, exploration] : protocol.explorations) {
    text += (protocol.explorations.size() == 1 ? " Each" : " Exploration “" + name + "”: each") +
            std::string(" surface was to be explored ") + instructed_exploration(exploration) + '.';
  }
  return text;
}

}  // namespace

std::vector<std::string> paper_procedure(const ReportFacts& facts, const StudyMetadata& metadata,
                                         Sources& sources) {
  std::vector<std::string> methods{paper_participants(facts, metadata), paper_apparatus(facts),
                                   paper_environment(facts)};
  if (facts.file.protocol) {
    if (facts.sources.size() > 1) {
      methods.push_back(facts.differ_in_texts_only
                            ? "The protocol was run in " + count_in_words(facts.sources.size()) +
                                  " versions that differ in language and texts only."
                            : "The protocol has " + count_in_words(facts.sources.size()) +
                                  " files of this version; the following is that of the first.");
    }
    methods.push_back(paper_task(facts));
    methods.push_back(paper_questions(*facts.file.protocol));
    methods.push_back(paper_order(facts, sources));
  }
  return methods;
}

}  // namespace asperity
