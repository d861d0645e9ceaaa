// Gathers the responses, calls the analysis of each kind, then adds what all kinds have: times, learning, anchors.

#include "app/findings/study/analyze_study.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/study_analysis.h"
#include "app/findings/shared/anchors.h"
#include "app/findings/shared/equal_roughness.h"
#include "app/findings/shared/exploration.h"
#include "app/findings/shared/learning.h"
#include "app/findings/shared/repetition_reliability.h"
#include "app/findings/shared/response_times.h"
#include "app/study_files/study_condition.h"
#include "protocols/kinds/experiment_kind.h"
#include "results_schema/hashes/short_hash.h"

namespace asperity {

namespace {

/// A text with a placeholder for the count. `what` as in AnswerCount.
Phrase attempts_that_were(const std::string& what) {
  static const std::map<std::string, Phrase> kKnown{
      {"aborted", phrase("Analysis", "%1 interrupted")},
      {"answered but invalid", phrase("Analysis", "%1 answered but invalid")},
      {"device_fault", phrase("Analysis", "%1 stopped by a fault")},
      {"emergency_stop", phrase("Analysis", "%1 ended by the emergency stop")},
      {"excluded", phrase("Analysis", "%1 excluded")},
      {"not_compliant", phrase("Analysis", "%1 not explored as instructed")},
      {"skipped", phrase("Analysis", "%1 skipped")},
      {"timed_out", phrase("Analysis", "%1 not answered in time")}};
  const auto known = kKnown.find(what);
  return known == kKnown.end() ? Phrase("%1 " + what) : known->second;
}

void remark_on_counts(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  const AnswerCount& count = gathered.count;
  if (gathered.unread_recordings > 0) {
    outcome.remarks.push_back(
        phrase("Analysis",
               "Recordings that cannot be read, so that the properties of the stimuli lack their "
               "forces: %1. \"asperity verify\" names the files; restore them from a copy of the "
               "study.")
            .with(std::to_string(gathered.unread_recordings)));
  }
  if (gathered.group == AnswerGroup::virtual_participants) {
    outcome.remarks.push_back(phrase("Analysis",
                                     "These participants are virtual: the results serve to test "
                                     "the program and are not evidence about human participants."));
  }
  if (gathered.group == AnswerGroup::pilot) {
    outcome.remarks.push_back(phrase(
        "Analysis",
        "These sessions are pilots: they are analysed separately from sessions of mode \"run\"."));
  }
  if (gathered.sources > 1) {
    outcome.remarks.push_back(
        phrase(
            "Analysis",
            "%1 different files have this protocol name and version; their responses are pooled. "
            "Give a changed protocol a new version.")
            .with(std::to_string(gathered.sources)));
  }
  if (!gathered.declared_alike) {
    outcome.remarks.push_back(
        phrase("Analysis",
               "These files declare different tests, so that no test counts as declared before "
               "data collection; give a protocol with changed tests a new version."));
  }
  if (count.unfinished_sessions > 0) {
    outcome.remarks.push_back(
        phrase("Analysis", "Sessions that were not completed: %1 of %2.")
            .with(std::to_string(count.unfinished_sessions), std::to_string(count.sessions)));
  }
  if (count.unfelt_sessions > 0) {
    outcome.remarks.push_back(
        phrase("Analysis",
               "Sessions that began on a device on which no participant can feel the surfaces "
               "(without motors, or moved by the program): %1 of %2.")
            .with(std::to_string(count.unfelt_sessions), std::to_string(count.sessions)));
  }
  if (count.guessing_sessions > 0) {
    outcome.remarks.push_back(
        phrase(
            "Analysis",
            "Sessions of virtual participants that ignore the surface or have no expectations, so "
            "that their responses are guesses: %1.")
            .with(std::to_string(count.guessing_sessions)));
  }
  Phrase not_counted{};
  for (const auto& [what, attempts] : count.not_counted) {
    const Phrase these = attempts_that_were(what).with(std::to_string(attempts));
    not_counted =
        not_counted.empty() ? these : phrase("Analysis", "%1, %2").with(not_counted, these);
  }
  if (!not_counted.empty()) {
    outcome.remarks.push_back(
        phrase("Analysis", "Attempts that do not count: %1.").with(not_counted));
  }
  if (count.flagged > 0) {
    outcome.remarks.push_back(
        phrase("Analysis",
               "Flagged attempts among those that count: %1; the reasons are "
               "in the trials of each session and in attempts.tsv of an export.")
            .with(std::to_string(count.flagged)));
  }
}

/// A force model of a plug-in: its id and its version.
using PluginModel = std::pair<std::string, std::string>;
/// The attempts that each build rendered, by its SHA-256.
using AttemptsOfBuilds = std::map<std::string, std::size_t>;

bool has_several_builds(const Study& study) {
  const std::vector<PluginUse> uses = study.plugin_uses();
  // Those of a model and version follow each other.
  return std::adjacent_find(uses.begin(), uses.end(), [](const auto& one, const auto& other) {
           return one.model == other.model && one.model_version == other.model_version;
         }) != uses.end();
}

/// The sessions whose responses are analysed together.
std::vector<SessionRow> pooled_sessions(const Study& study, const GatheredAnswers& gathered) {
  std::set<std::int64_t> protocols{};
  for (const ProtocolRow& row : study.protocols()) {
    if (row.name == gathered.protocol && row.version == gathered.version) protocols.insert(row.id);
  }
  std::map<std::string, ParticipantRow> participants{};
  for (ParticipantRow& row : study.participants()) participants.emplace(row.label, std::move(row));
  std::vector<SessionRow> sessions = study.sessions();
  std::erase_if(sessions, [&](const SessionRow& session) {
    return session.withdrawn || !protocols.contains(session.protocol_id) ||
           group_of(participants.at(session.participant), session) != gathered.group;
  });
  return sessions;
}

/// The plug-ins of which several builds with one version rendered attempts that count. Attempts are read only in a study that has
/// such builds.
std::map<PluginModel, AttemptsOfBuilds> pooled_builds(const Study& study,
                                                      const GatheredAnswers& gathered) {
  std::map<PluginModel, AttemptsOfBuilds> builds{};
  if (!has_several_builds(study)) return builds;
  for (const SessionRow& session : pooled_sessions(study, gathered)) {
    std::map<int, PlannedTrialRow> plan{};
    for (PlannedTrialRow& trial : study.plan(session.id)) plan[trial.trial] = std::move(trial);
    for (const AttemptRow& attempt : study.attempts(session.id)) {
      if (use_in_analyses(plan[attempt.trial], attempt) != AnalysisUse::counted) continue;
      std::set<std::tuple<std::string, std::string, std::string>> of_attempt{};
      for (const PresentationRow& surface : attempt.presentations) {
        const auto sha256 = asset_sha256(surface.assets, kPluginRole);
        if (sha256) of_attempt.emplace(surface.model, surface.model_version, *sha256);
      }
      for (const auto& [model, version, sha256] : of_attempt) ++builds[{model, version}][sha256];
    }
  }
  std::erase_if(builds, [](const auto& plugin) { return plugin.second.size() < 2; });
  return builds;
}

/// Names the builds of plug-ins that have one version.
void remark_on_builds(const Study& study, const GatheredAnswers& gathered,
                      AnalysisOutcome& outcome) {
  for (const auto& [plugin, builds] : pooled_builds(study, gathered)) {
    Phrase list{};
    for (const auto& [sha256, attempts] : builds) {
      const Phrase one = phrase("Analysis", "%1… (attempts: %2)")
                             .with(short_hash(sha256), std::to_string(attempts));
      list = list.empty() ? one : phrase("Analysis", "%1, %2").with(list, one);
    }
    outcome.remarks.push_back(
        phrase("Analysis",
               "Different builds of the plug-in of the force model %1 have the version %2, and the "
               "responses to them are pooled. Their SHA-256: %3. Raise the version of a plug-in "
               "whose forces have changed; exclude the attempts with a build that must not be "
               "pooled.")
            .with(plugin.first, plugin.second, list));
  }
}

std::string names_in(const Study& study) {
  std::set<std::string> names{};
  for (const SessionRow& session : study.sessions()) {
    names.insert(study.protocol(session.protocol_id).name);
  }
  std::string text{};
  for (const std::string& name : names) text += (text.empty() ? "\"" : ", \"") + name + '"';
  return text.empty() ? "it has no sessions; run one first"
                      : "choose a protocol that has sessions: " + text;
}

/// Whether one of the tests is a test of this kind; so every test of a kind that this program does not have.
bool has_test_of(const std::vector<std::string>& family, const std::string& kind) {
  const ExperimentKind* const known = find_kind(kind);
  return known == nullptr ||
         std::any_of(family.begin(), family.end(), [known](const std::string& name) {
           return find_test(*known, name) != nullptr;
         });
}

std::vector<AnalysisOutcome> outcomes_of(const Study& study,
                                         const std::optional<std::string>& protocol,
                                         const std::stop_token& stop) {
  std::vector<AnalysisOutcome> outcomes{};
  for (const GatheredAnswers& gathered : gather_answers(study, protocol, stop)) {
    if (stop.stop_requested()) return {};
    AnalysisOutcome& outcome = outcomes.emplace_back();
    outcome.protocol = gathered.protocol;
    outcome.version = gathered.version;
    outcome.title = gathered.title;
    outcome.kind = gathered.kind;
    outcome.design = gathered.design;
    outcome.group = gathered.group;
    outcome.count = gathered.count;
    const std::vector<std::string>& family = gathered.declared.family;
    outcome.family = !gathered.declared_alike             ? FamilyDeclaration::differs_between_files
                     : family.empty()                     ? FamilyDeclaration::none
                     : has_test_of(family, gathered.kind) ? FamilyDeclaration::declared
                                                          : FamilyDeclaration::of_other_kinds;
    outcome.declares_sexes = std::find(family.begin(), family.end(), "sexes") != family.end();
    outcome.answers = gathered.answers.size();
    remark_on_counts(gathered, outcome);
    remark_on_builds(study, gathered, outcome);
    if (gathered.answers.empty()) {
      outcome.remarks.push_back(
          phrase("Analysis", "There are no responses yet; run a session first."));
    } else if (const StudyAnalysis* const analysis = find_analysis(gathered.kind)) {
      analysis->analyze(gathered, outcome);
      // The main question of a study whose declared tests all compare groups.
      const bool compares_groups = outcome.family == FamilyDeclaration::declared &&
                                   std::ranges::all_of(family, [](const std::string& test) {
                                     return test == kGroupsTest || test == kGroupProfilesTest;
                                   });
      if (compares_groups) {
        std::ranges::stable_partition(outcome.questions, [](const AnsweredQuestion& question) {
          return question.name.starts_with("group");
        });
      }
      // Only next to results.
      if (!outcome.tables.empty()) {
        if (repetitions_are_textures(gathered)) {
          outcome.remarks.push_back(phrase(
              "Analysis",
              "Each repetition presents other textures than the others: repetitions and textures "
              "cannot be distinguished. Differences between repetitions and changes over the "
              "trials "
              "are also differences between textures, and there is no reliability over "
              "repetitions."));
        }
        add_equal_roughness(gathered, outcome);
        add_response_times(gathered, outcome);
        add_learning(gathered, outcome);
        add_exploration(gathered, outcome);
        add_anchors(gathered, outcome);
      }
    } else {
      outcome.remarks.push_back(
          phrase("Analysis",
                 "This program has no analysis for protocols of the kind \"%1\"; export the tables "
                 "and analyse them with another program.")
              .with(gathered.kind));
    }
  }
  if (protocol && outcomes.empty()) {
    throw ResultsError("the study " + study.folder().string() + " has no session of a protocol \"" +
                           *protocol + "\"; " + names_in(study),
                       study.folder());
  }
  return outcomes;
}

}  // namespace

std::vector<AnalysisOutcome> analyze_study(const Study& study,
                                           const std::optional<std::string>& protocol,
                                           const std::stop_token& stop) {
  std::vector<AnalysisOutcome> outcomes{};
  read_unless_broken(
      study, [&] { outcomes = outcomes_of(study, protocol, stop); }, stop);
  if (stop.stop_requested()) return {};
  if (const std::optional<Phrase> remark = remark_on(study)) {
    for (AnalysisOutcome& outcome : outcomes) {
      outcome.remarks.insert(outcome.remarks.begin(), *remark);
    }
  }
  return outcomes;
}

}  // namespace asperity
