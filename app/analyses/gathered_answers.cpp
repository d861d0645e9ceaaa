// Sessions, plans and attempts, read and sorted into groups.

#include "app/analyses/gathered_answers.h"

#include <algorithm>
#include <set>
#include <tuple>

#include <nlohmann/json.hpp>

#include "results_schema/table.h"

namespace asperity {

namespace {

constexpr const char* kMainPhase = "main";

std::string column_of(const PlannedTrialRow& trial) {
  const nlohmann::json factors = nlohmann::json::parse(trial.factors_json);
  const auto level = factors.find(kColumnFactor);
  if (level == factors.end()) return {};
  return level->is_string() ? level->get<std::string>() : text_of_number(level->get<double>());
}

/// Whether the observer's answers are guesses by declaration.
bool is_guessing(const SessionRow& session) {
  const nlohmann::json observer = nlohmann::json::parse(session.observer_json);
  if (!observer.is_object()) return false;
  return observer.value("deaf", false) || observer.value("expectation", "") == "none";
}

GatheredAnswer answer_of(const ParticipantRow& participant, const std::string& column,
                         AttemptRow attempt) {
  GatheredAnswer answer{};
  answer.participant = participant.label;
  answer.sex = participant.sex;
  answer.column = column;
  for (const PresentationRow& surface : attempt.presentations) {
    answer.surfaces.push_back({surface.item, surface.model, surface.texture,
                               surface.matched_texture_force_N, surface.achieved_texture_force_N});
  }
  std::sort(attempt.responses.begin(), attempt.responses.end(),
            [](const auto& a, const auto& b) { return a.item < b.item; });
  for (const ResponseRow& response : attempt.responses) {
    answer.answers.push_back(response.answer);
    answer.correct.push_back(response.correct);
    answer.options = nlohmann::json::parse(response.options_json).get<std::vector<std::string>>();
  }
  return answer;
}

void gather_session(const Study& study, const ParticipantRow& participant,
                    const SessionRow& session, GatheredAnswers& gathered) {
  std::map<int, std::string> column_of_trial{};
  for (const PlannedTrialRow& trial : study.plan(session.id)) {
    if (trial.phase == kMainPhase) column_of_trial[trial.trial] = column_of(trial);
  }
  gathered.count.planned_trials += column_of_trial.size();
  for (AttemptRow& attempt : study.attempts(session.id)) {
    const auto column = column_of_trial.find(attempt.trial);
    if (column == column_of_trial.end()) continue;
    if (!attempt.valid || attempt.responses.empty()) {
      const std::string outcome = text_of(attempt.outcome);
      // An answer that does not count was given, but the machine failed.
      ++gathered.count.not_counted[outcome == "answered" ? "answered but invalid" : outcome];
      continue;
    }
    if (attempt.excluded) {
      ++gathered.count.not_counted["excluded"];
      continue;
    }
    if (attempt.flagged) ++gathered.count.flagged;
    gathered.answers.push_back(answer_of(participant, column->second, std::move(attempt)));
  }
}

}  // namespace

const char* text_of(AnswerGroup group) noexcept {
  switch (group) {
    case AnswerGroup::people:
      return "people";
    case AnswerGroup::pilot:
      return "pilot";
    case AnswerGroup::virtual_participants:
      return "virtual";
  }
  return "";
}

AnswerGroup group_of(const ParticipantRow& participant, const SessionRow& session) {
  if (participant.is_virtual) return AnswerGroup::virtual_participants;
  return session.mode == SessionMode::pilot ? AnswerGroup::pilot : AnswerGroup::people;
}

std::vector<GatheredAnswers> gather_answers(const Study& study,
                                            const std::optional<std::string>& protocol,
                                            const std::stop_token& stop) {
  std::map<std::tuple<std::string, std::string, AnswerGroup>, GatheredAnswers> groups{};
  std::map<std::tuple<std::string, std::string, AnswerGroup>, std::set<std::string>> people{};
  std::map<std::tuple<std::string, std::string, AnswerGroup>, std::set<std::string>> sources{};
  for (const SessionRow& session : study.sessions()) {
    if (stop.stop_requested()) break;
    const ProtocolRow of = study.protocol(session.protocol_id);
    if (protocol && of.name != *protocol) continue;
    const ParticipantRow participant = study.participant(session.participant).value();
    const AnswerGroup group = group_of(participant, session);
    const auto key = std::tuple(of.name, of.version, group);
    GatheredAnswers& gathered = groups[key];
    gathered.protocol = of.name;
    gathered.version = of.version;
    gathered.kind = of.kind;
    gathered.design = of.design;
    gathered.group = group;
    ++gathered.count.sessions;
    if (session.state != SessionState::completed) ++gathered.count.unfinished_sessions;
    if (is_guessing(session)) ++gathered.count.guessing_sessions;
    people[key].insert(session.participant);
    sources[key].insert(of.source_sha256);
    gather_session(study, participant, session, gathered);
  }
  std::vector<GatheredAnswers> all{};
  for (auto& [key, gathered] : groups) {
    gathered.count.participants = people[key].size();
    gathered.sources = sources[key].size();
    all.push_back(std::move(gathered));
  }
  return all;
}

}  // namespace asperity
