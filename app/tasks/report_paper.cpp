// Methods and results as a paper prints them, each sentence from what is stored.

#include <algorithm>
#include <iterator>
#include <set>
#include <span>

#include "app/analyses/cell_words.h"
#include "app/analyses/reading_number.h"
#include "app/analyses/references.h"
#include "app/analyses/test_methods.h"
#include "app/program.h"
#include "app/tasks/report_sections.h"
#include "protocols/stored_protocol.h"

namespace asperity {

namespace {

constexpr std::size_t kMostExploratory = 24;  // more are read in the table of tests

/// The keys of what is cited.
using Sources = std::set<std::string>;

std::string cited(const std::string& key, Sources& sources) {
  sources.insert(key);
  return " (" + std::string(reference(key).cited) + ')';
}

std::string with_sentences(const std::vector<std::string>& sentences) {
  std::string text{};
  for (const std::string& sentence : sentences) {
    if (!sentence.empty()) text += (text.empty() ? "" : " ") + sentence;
  }
  return text;
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

bool is_of_family(const TestSentence& each) { return each.role != TestRole::exploratory; }

/// Those of the family first, without further ones that could not be made.
std::vector<TestSentence> printed_sentences(const AnalysisOutcome& outcome) {
  std::vector<TestSentence> printed{};
  std::copy_if(outcome.test_sentences.begin(), outcome.test_sentences.end(),
               std::back_inserter(printed), is_of_family);
  std::size_t exploratory = 0;
  for (const TestSentence& each : outcome.test_sentences) {
    if (is_of_family(each) || each.is_untested || exploratory == kMostExploratory) continue;
    ++exploratory;
    printed.push_back(each);
  }
  return printed;
}

/// Where no analysis is shown.
std::string withheld_text(const ReportFacts& facts) {
  return reading_count(facts.attempts) +
         (facts.attempts == 1 ? " attempt at a trial is" : " attempts at trials are") +
         " stored; there are no results.";
}

/// "The 18 attempts at trials were analysed", "Two of the 18 …", "None of the 18 …"
std::string analysed_text(const ReportFacts& facts) {
  const std::string all = facts.attempts == 1
                              ? "the only attempt at a trial"
                              : "the " + reading_count(facts.attempts) + " attempts at trials";
  if (facts.counted == 0) {
    return facts.attempts == 1 ? "The only attempt at a trial was not included in the analysis."
                               : "None of " + all + " was included in the analysis.";
  }
  const bool is_all = facts.counted == facts.attempts;
  return (is_all ? capitalised(all) : capitalised(count_in_words(facts.counted)) + " of " + all) +
         (facts.counted == 1 ? " was" : " were") + " analysed, with Asperity " + program_version() +
         '.';
}

std::string correction_text(const AnalysisOutcome& outcome, Sources& sources) {
  std::vector<std::string> names{};  // of the tests in the family
  std::size_t family = 0;
  std::size_t made = 0;
  bool is_declared = false;
  for (const TestSentence& each : outcome.test_sentences) {
    if (!is_of_family(each)) continue;
    ++family;
    if (!each.is_untested) ++made;
    is_declared = each.role == TestRole::confirmatory;
    const std::string name = words_of_cell("family", each.test).english();
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  const std::string undeclared =
      is_declared ? "" : "No test was declared in advance: all tests are exploratory.";
  if (family < 2 || made == 0) return undeclared;
  return with_sentences(
      {undeclared, "The p values of the " + reading_count(family) +
                       (is_declared ? " confirmatory tests" : " tests") + " (" + listed(names) +
                       ") were Holm-corrected" + cited("Holm 1979", sources) +
                       (made < family ? "; a test that could not be made counts as p = 1." : ".")});
}

/// A name with what it is cited for behind it: "Cohen’s d (Cohen, 1988)".
std::string cited_name(const Phrase& name, std::string_view source, Sources& sources) {
  return name.english() + (source.empty() ? "" : cited(std::string(source), sources));
}

/// "Tests: one-sample t test, effect size Cohen’s d (Cohen, 1988); …": each once.
std::string methods_text(std::span<const TestSentence> printed, Sources& sources) {
  struct Used {
    const TestMethod* method = nullptr;
    std::vector<std::string> effects{};
  };
  std::vector<Used> all{};
  for (const TestSentence& each : printed) {
    if (each.made_by == nullptr) continue;
    const TestMethod& by = *each.made_by;
    auto used = std::find_if(all.begin(), all.end(),
                             [&by](const Used& one) { return one.method->code == by.code; });
    if (used == all.end()) used = all.insert(all.end(), {.method = &by});
    if (!each.has_effect || by.effect_name.empty()) continue;
    const std::string effect = cited_name(by.effect_name, by.sources[1], sources);
    if (std::find(used->effects.begin(), used->effects.end(), effect) == used->effects.end()) {
      used->effects.push_back(effect);
    }
  }
  std::string text{};
  for (const Used& used : all) {
    text += (text.empty() ? "" : "; ") +
            cited_name(used.method->name, used.method->sources[0], sources);
    if (used.effects.empty()) continue;
    text +=
        (used.effects.size() == 1 ? ", effect size " : ", effect sizes ") + listed(used.effects);
  }
  if (text.empty()) return {};
  return (all.size() == 1 ? "Test: " : "Tests: ") + text + '.';
}

std::string paper_data(const ReportFacts& facts, const AnalysisOutcome& outcome,
                       std::span<const TestSentence> printed, Sources& sources) {
  std::vector<std::string> sentences{facts.attempts > 0 ? analysed_text(facts) : "",
                                     correction_text(outcome, sources)};
  const auto is_any = [&printed](const auto& is_so) {
    return std::any_of(printed.begin(), printed.end(), is_so);
  };
  if (is_any([](const TestSentence& each) { return !each.is_untested; })) {
    sentences.emplace_back("The level of significance was .05.");
  }
  if (is_any([](const TestSentence& each) { return each.has_mean_interval; })) {
    sentences.emplace_back(
        "Confidence intervals (CI) of mean proportions are Student's t over participants on the "
        "logit scale.");
  }
  sentences.push_back(methods_text(printed, sources));
  return with_sentences(sentences);
}

std::string results_paragraph(const AnalysisOutcome& outcome,
                              std::span<const TestSentence> printed) {
  std::vector<std::string> sentences{};
  // Without a declaration all tests are exploratory, which the methods state.
  bool follows_confirmatory = false;
  for (const TestSentence& each : printed) {
    const bool is_confirmatory = each.role == TestRole::confirmatory;
    if (follows_confirmatory && !is_confirmatory) {
      sentences.emplace_back("The following tests are exploratory.");
    }
    follows_confirmatory = is_confirmatory;
    sentences.push_back(each.text);
  }
  const auto worth_printing = static_cast<std::size_t>(std::count_if(
      outcome.test_sentences.begin(), outcome.test_sentences.end(),
      [](const TestSentence& each) { return is_of_family(each) || !each.is_untested; }));
  if (worth_printing > printed.size()) {
    sentences.push_back("The table of tests has " + reading_count(worth_printing - printed.size()) +
                        " more.");
  }
  return with_sentences(sentences);
}

}  // namespace

ReportSection paper_section(const ReportFacts& facts, const AnalysisOutcome* outcome,
                            const StudyMetadata& metadata) {
  ReportSection section{"Text for a paper", {}};
  Sources sources{};
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
  const std::vector<TestSentence> printed =
      outcome == nullptr ? std::vector<TestSentence>{} : printed_sentences(*outcome);
  methods.push_back(outcome == nullptr ? withheld_text(facts)
                                       : paper_data(facts, *outcome, printed, sources));
  section.parts.emplace_back(ReportText{"Methods", ReportText::Tone::lead});
  section.parts.emplace_back(ReportText{with_sentences(methods)});
  const std::string results = outcome == nullptr ? "" : results_paragraph(*outcome, printed);
  if (!results.empty()) {
    section.parts.emplace_back(ReportText{"Results", ReportText::Tone::lead});
    section.parts.emplace_back(ReportText{results});
  }
  if (!sources.empty()) {
    ReportList entries{};
    for (const std::string& key : sources) entries.items.emplace_back(reference(key).entry);
    section.parts.emplace_back(ReportText{"References", ReportText::Tone::lead});
    section.parts.emplace_back(std::move(entries));
  }
  return section;
}

}  // namespace asperity
