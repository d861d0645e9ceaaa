// Each group of answers goes to the family of its protocol.

#include "app/analyses/analyze_study.h"

#include <map>
#include <set>
#include <utility>

#include "app/analyses/families.h"
#include "app/analyses/gathered_answers.h"

namespace asperity {

namespace {

using Family = void (*)(const GatheredAnswers&, AnalysisOutcome&);

Family family_of(const std::string& kind) {
  static const std::map<std::string, Family> kFamilies{{"selection", analyze_selection},
                                                       {"matching", analyze_matching},
                                                       {"recognition", analyze_recognition}};
  const auto found = kFamilies.find(kind);
  return found == kFamilies.end() ? nullptr : found->second;
}

void remark_on_counts(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  const AnswerCount& count = gathered.count;
  if (gathered.group == AnswerGroup::virtual_participants) {
    outcome.remarks.emplace_back(
        "These participants are virtual: the numbers exercise the machinery and say nothing about "
        "people.");
  }
  if (gathered.group == AnswerGroup::pilot) {
    outcome.remarks.emplace_back(
        "These sessions are pilots and stand apart from those that count.");
  }
  if (gathered.sources > 1) {
    outcome.remarks.push_back(std::to_string(gathered.sources) +
                              " different files carry this protocol name and version; their "
                              "answers are counted together.");
  }
  if (count.unfinished_sessions > 0) {
    outcome.remarks.push_back(
        "Sessions that are not completed: " + std::to_string(count.unfinished_sessions) + " of " +
        std::to_string(count.sessions) + '.');
  }
  if (count.guessing_sessions > 0) {
    outcome.remarks.push_back(
        "Sessions of observers that are deaf or expect nothing, so that their "
        "answers are guesses (source virtual_guess): " +
        std::to_string(count.guessing_sessions) + '.');
  }
  std::string not_counted{};
  for (const auto& [what, attempts] : count.not_counted) {
    not_counted += (not_counted.empty() ? "" : ", ") + std::to_string(attempts) + ' ' + what;
  }
  if (!not_counted.empty()) {
    outcome.remarks.push_back("Attempts that do not count: " + not_counted + '.');
  }
  if (count.flagged > 0) {
    outcome.remarks.push_back(
        "Flagged attempts among those that count: " + std::to_string(count.flagged) +
        "; attempts.tsv of an export says why.");
  }
}

std::string names_in(const Study& study) {
  std::set<std::string> names{};
  for (const SessionRow& session : study.sessions()) {
    names.insert(study.protocol(session.protocol_id).name);
  }
  std::string text{};
  for (const std::string& name : names) text += (text.empty() ? "\"" : ", \"") + name + '"';
  return text.empty() ? "no sessions at all" : "sessions of " + text;
}

}  // namespace

std::vector<AnalysisOutcome> analyze_study(const Study& study,
                                           const std::optional<std::string>& protocol) {
  std::vector<AnalysisOutcome> outcomes{};
  for (const GatheredAnswers& gathered : gather_answers(study, protocol)) {
    AnalysisOutcome& outcome = outcomes.emplace_back();
    outcome.protocol = gathered.protocol;
    outcome.version = gathered.version;
    outcome.kind = gathered.kind;
    outcome.design = gathered.design;
    outcome.group = gathered.group;
    outcome.count = gathered.count;
    outcome.answers = gathered.answers.size();
    remark_on_counts(gathered, outcome);
    if (gathered.answers.empty()) {
      outcome.remarks.emplace_back("There is no answer to count yet.");
    } else if (const Family analyze = family_of(gathered.kind)) {
      analyze(gathered, outcome);
    } else {
      outcome.remarks.push_back("This program has no analysis for protocols of the kind \"" +
                                gathered.kind + "\".");
    }
  }
  if (protocol && outcomes.empty()) {
    throw ResultsError("the study " + study.folder().string() + " has no session of a protocol \"" +
                           *protocol + "\"; it has " + names_in(study),
                       study.folder());
  }
  return outcomes;
}

}  // namespace asperity
