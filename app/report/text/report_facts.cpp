// Reads the sessions of a chapter once, and counts attempts, events and presentations.

#include "app/report/text/report_facts.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/plugins/stored_plugins.h"
#include "app/records/session_timeline.h"
#include "app/study_files/parameter_json.h"
#include "app/tasks/study_overview.h"
#include "app/words/coded_phrases.h"
#include "app/words/event_kinds.h"
#include "protocols/design/protocol.h"
#include "protocols/file/stored_protocol.h"
#include "renderers/built_in_models.h"
#include "renderers/force/layers.h"

namespace asperity {

namespace {

// Not a limit, but the number of ticks in contact, of which the limits of a model count a part.
constexpr const char* kAllContact = "contact";

void count_servo(const ServoQualityRow& row, ReportedServo& servo) {
  ++servo.attempts;
  servo.ticks += row.ticks;
  servo.lateness_p50_s.push_back(row.lateness_p50_s);
  servo.lateness_p99_s.push_back(row.lateness_p99_s);
  servo.lateness_maximum_s.push_back(row.lateness_maximum_s);
  servo.period_p99_s.push_back(row.period_p99_s);
  servo.execution_p99_s.push_back(row.execution_p99_s);
  servo.missed_deadlines.add(row.missed_deadlines);
  servo.missed_in_contact.add(row.missed_in_contact);
  servo.gaps_in_contact.add(row.gaps_in_contact);
  servo.held_readings.add(row.held_readings);
  servo.lost_records.add(row.lost_records);
  servo.saturated.add(row.saturated_ticks);
  servo.slew_limited.add(row.slew_limited_ticks);
  servo.not_finite.add(row.not_finite_ticks);
  if (row.fault != "none") ++servo.faults[row.fault];
}

/// The required fraction of the exploration of a trial; nothing where the protocol cannot be read.
std::optional<double> required_fraction(const ReportFacts& facts, const PlannedTrialRow& planned) {
  if (!facts.file.protocol) return {};
  const Protocol& protocol = *facts.file.protocol;
  const auto block = protocol.blocks.find(planned.block);
  if (block == protocol.blocks.end()) return {};
  const Binding<std::string>& named = block->second.exploration;
  std::string name = named.value.value_or("");
  if (!named.value) {
    const auto factors = nlohmann::json::parse(planned.factors_json, nullptr, false);
    if (!factors.is_object() || !factors.contains(named.factor)) return {};
    const nlohmann::json& level = factors.at(named.factor);
    if (level.is_string()) name = level.get<std::string>();
  }
  const auto exploration = protocol.explorations.find(name);
  if (exploration == protocol.explorations.end()) return {};
  return exploration->second.required_fraction_in_band;
}

/// Whether a measure has no data. Without contact there is no force, and without a stroke neither
/// speed nor length: their mean is stored as zero, and their fraction is absent. A contact time and
/// a number of strokes of zero are measurements.
bool is_of_nothing(const ComplianceRow& row) {
  const bool is_counted = row.quantity == "contact_s" || row.quantity == "strokes";
  return !is_counted && row.mean == 0.0 && !row.fraction_in_band;
}

/// Whether every surface passes because no part of the contact or of the strokes has to lie in the
/// band.
bool always_passes(const ComplianceRow& row, std::optional<double> required_fraction) {
  return (row.quantity == "normal_force_N" || row.quantity == "speed_m_per_s") &&
         required_fraction && *required_fraction <= 0.0;
}

void count_compliance(const ComplianceRow& row, std::optional<double> required_fraction,
                      ReportFacts& facts) {
  ReportedBand& band = facts.bands[{row.quantity, row.minimum, row.maximum}];
  if (!is_of_nothing(row)) band.means.push_back(row.mean);
  if (row.fraction_in_band) band.fractions.push_back(*row.fraction_in_band);
  if (!row.passed || always_passes(row, required_fraction)) return;
  ++band.judged;
  if (*row.passed) ++band.passed;
}

/// The purpose of a trial outside the results: "familiarisation", "practice", "anchors", "catch trials".
std::string other_kind(const PlannedTrialRow& planned, AnalysisUse use) {
  if (use == AnalysisUse::anchor) return "anchors";
  if (use == AnalysisUse::catch_trial) return kCatchTrialsKind;
  return planned.phase.empty() ? "unknown trials" : planned.phase;
}

void count_use(const AttemptRow& attempt, const PlannedTrialRow& planned, AnalysisUse use,
               ReportFacts& facts) {
  switch (use) {
    case AnalysisUse::practice:
    case AnalysisUse::anchor:
    case AnalysisUse::catch_trial:
      ++facts.other_attempts;
      facts.other_kinds.insert(other_kind(planned, use));
      return;
    case AnalysisUse::invalid:
    case AnalysisUse::unanswered:
    case AnalysisUse::excluded: {
      const std::optional<StoredWords>& reason =
          use == AnalysisUse::excluded ? attempt.excluded : attempt.invalid_reason;
      ++facts.not_counted[fate_of(use, attempt.outcome)][phrase_of(reason).english()];
      break;
    }
    case AnalysisUse::counted:
      ++facts.counted;
      if (attempt.flagged) ++facts.flagged[phrase_of(attempt.flag_reason).english()];
      break;
  }
  ++facts.attempts;
}

/// A presentation names the texture that varies; the other body may have a separate, constant
/// texture.
void add_textures_of_bodies(const std::string& stimulus, ReportFacts& facts) {
  if (!facts.file.protocol) return;
  const Protocol& protocol = *facts.file.protocol;
  const auto known = protocol.stimuli.find(stimulus);
  if (known == protocol.stimuli.end()) return;
  for (const Binding<std::string>* bound : {&known->second.surface, &known->second.tool}) {
    const auto body = protocol.bodies.find(bound->value.value_or(""));
    if (body == protocol.bodies.end() || !body->second.texture) continue;
    facts.body_textures.insert(*body->second.texture);
  }
}

void count_parameters(const PresentationRow& surface, ReportFacts& facts) {
  const ParameterValues rendered = parameter_values_in(surface.parameters_json);
  for (const auto& [name, value] : without_unused_layers(rendered)) {
    facts.parameters[surface.model][name].insert(value);
  }
}

void count_attempt(const AttemptRow& attempt, const PlannedTrialRow& planned, ReportFacts& facts) {
  const AnalysisUse use = use_in_analyses(planned, attempt);
  count_use(attempt, planned, use, facts);
  if (attempt.servo) count_servo(*attempt.servo, facts.servo);
  const std::optional<double> fraction = required_fraction(facts, planned);
  for (const ComplianceRow& row : attempt.compliance) count_compliance(row, fraction, facts);
  for (const PresentationRow& surface : attempt.presentations) {
    if (!surface.onset_ns) continue;  // the attempt ended before it
    const std::string model = surface.model + ' ' + surface.model_version;
    facts.models.insert(model);
    if (const auto sha256 = asset_sha256(surface.assets, kPluginRole)) {
      facts.plugin_builds[model].insert(*sha256);
    }
    const bool has_body = asset_sha256(surface.assets, "surface").has_value();
    const bool is_point = !asset_sha256(surface.assets, "tool");
    if (has_body) add_textures_of_bodies(surface.stimulus, facts);
    if (has_body && is_point) facts.points_on_bodies.insert(surface.stimulus);
    if (has_body && !is_point) facts.body_textures.insert(surface.texture);
    if (is_point && asset_sha256(surface.assets, "height_field")) {
      facts.height_fields.insert(surface.texture);
    }
    facts.has_equal_force = facts.has_equal_force || surface.matched_texture_force_N;
    for (const ModelLimitRow& limit : surface.limits) {
      if (limit.kind == kAllContact) continue;
      const std::string& felt = surface.texture.empty() ? surface.stimulus : surface.texture;
      facts.limits[{surface.model, limit.kind, felt}].add(limit.ticks);
    }
  }
  if (attempt.outcome == AttemptOutcome::answered) {
    facts.surfaces.insert(attempt.presentations.size());
    for (const PresentationRow& surface : attempt.presentations) {
      facts.stiffness_N_per_m.insert(surface.stiffness_N_per_m);
      facts.friction.insert(surface.friction);
      if (use == AnalysisUse::counted) count_parameters(surface, facts);
    }
  }
  for (const ResponseRow& response : attempt.responses) {
    facts.answer_sources.insert(response.source);
  }
}

/// Whether the experimenter wrote the text of such an event. The reason for a late resume is
/// reported with the sessions.
bool is_in_own_words(const std::string& kind) {
  return kind == "note" || kind == "unblinded" || kind == "trial_repeated";
}

/// The trial that an event refers to: the one that was repeated, or the current one.
std::optional<int> trial_of(const TimedEvent& event) {
  const auto data = nlohmann::json::parse(event.row.data_json, nullptr, false);
  if (data.is_object() && data.contains("trial") && data["trial"].is_number_integer()) {
    return data["trial"].get<int>();
  }
  if (event.attempt == nullptr) return {};
  return event.attempt->trial;
}

/// A stimulus that several blocks present has one match. Only the trials with an attempt that counts present it.
void count_matches(const Protocol& protocol, const std::map<int, PlannedTrialRow>& plan,
                   const std::vector<AttemptRow>& attempts, ReportFacts& facts) {
  if (!presents_matches(protocol)) return;
  std::vector<PlannedTrialRow> trials{};
  for (const AttemptRow& attempt : attempts) {
    const PlannedTrialRow& planned = plan.at(attempt.trial);
    if (use_in_analyses(planned, attempt) == AnalysisUse::counted) trials.push_back(planned);
  }
  for (const PresentedMatch& match : without_blocks(presented_matches(protocol, trials))) {
    ++facts.roughness_matches[match.status];
  }
}

void add_file_of_plugin(const EventRow& event, ReportFacts& facts) {
  const auto data = nlohmann::json::parse(event.data_json, nullptr, false);
  if (!data.is_object() || !data.contains("file") || !data.contains("sha256")) return;
  if (!data["file"].is_string() || !data["sha256"].is_string()) return;
  facts.plugin_files[data["sha256"].get<std::string>()] = data["file"].get<std::string>();
}

/// `specified`: the stored protocol of the session.
void count_session(const Study& study, const SessionOverview& overview, const Protocol& specified,
                   ReportFacts& facts) {
  const SessionRow& row = overview.row;
  ReportedSession& session = facts.sessions.emplace_back();
  session.row = row;
  session.is_running = overview.is_running;
  session.planned_trials = overview.planned_trials;
  session.planned_is_estimated = overview.planned_is_estimated;
  session.done_trials = overview.done_trials;
  session.decisions = study.decisions(row.id);
  const std::vector<EventRow> events = study.events(row.id);
  const EventRow* started = nullptr;  // a program that has stated nothing yet
  for (const EventRow& event : events) {
    if (event.kind == "guidance") session.is_unguided = event.text == "not_given";
    if (event.kind == "session_resumed") ++session.resumed;
    if (event.kind == kResumedLate) session.late_resumes.push_back(event);
    if (event.kind == kExternalProgram) started = &event;
    if (event.kind == kExternalLevel && started != nullptr) {
      session.external_programs.push_back(*std::exchange(started, nullptr));
    }
    if (event.kind == kExternalFailure) ++session.external_failures;
    if (event.kind == kPluginEvent) add_file_of_plugin(event, facts);
    if (event.kind == "criterion_not_met") session.unmet_criteria.insert(event.text);
  }
  std::map<int, PlannedTrialRow> plan{};
  for (PlannedTrialRow& trial : study.plan(row.id)) {
    const AnalysisUse use = use_in_analyses(trial);
    if (use == AnalysisUse::counted) {
      ++session.main_trials;
    } else {
      facts.other_planned.insert(other_kind(trial, use));
    }
    plan[trial.trial] = std::move(trial);
  }
  const std::vector<AttemptRow> attempts = study.attempts(row.id);
  const std::size_t counted_before = facts.counted;
  std::set<int> presented{};
  for (const AttemptRow& attempt : attempts) {
    if (attempt.purpose == AttemptPurpose::refresher) {
      ++facts.refreshers;
      facts.refreshed_sessions.insert(row.id);
    }
    // A trial that is missing in a damaged study is not counted in the main phase.
    count_attempt(attempt, plan[attempt.trial], facts);
    if (attempt.purpose == AttemptPurpose::trial) presented.insert(attempt.trial);
  }
  count_matches(specified, plan, attempts, facts);
  for (const int trial : presented) {
    const PlannedTrialRow& planned = plan[trial];
    ++session.presented_trials;
    if (use_in_analyses(planned) == AnalysisUse::counted) ++session.presented_main_trials;
    ++session.presented_in_run[{planned.block, planned.block_ordinal}];
  }
  session.counted_attempts = facts.counted - counted_before;
  if (facts.counted > counted_before) facts.counted_participants.insert(row.participant);
  session.stretches = recorded_stretches(row, events, attempts);
  for (const TimedEvent& event : session_timeline(events, attempts)) {
    if (!is_in_own_words(event.row.kind)) continue;
    session.notes.push_back(
        {.kind = event.row.kind,
         .text = phrase_of(event.row).english(),
         .time_s = static_cast<double>(event.row.time_ns - row.clock_zero_ns) * 1e-9,
         .trial = trial_of(event)});
  }
}

}  // namespace

void ReportedCount::add(std::int64_t count) {
  total += count;
  worst = std::max(worst, count);
  if (count > 0) ++affected;
  ++of;
}

bool ReportFacts::is_running() const {
  return std::any_of(sessions.begin(), sessions.end(),
                     [](const ReportedSession& session) { return session.is_running; });
}

std::vector<ReportFacts> report_facts(const Study& study,
                                      const std::optional<std::string>& protocol,
                                      const std::stop_token& stop,
                                      const std::function<void(double)>& progress) {
  std::map<std::int64_t, ProtocolRow> protocols{};
  for (ProtocolRow& row : study.protocols()) protocols[row.id] = std::move(row);
  std::map<std::string, ParticipantRow> people{};
  for (ParticipantRow& row : study.participants()) people[row.label] = std::move(row);

  std::map<std::tuple<std::string, std::string, AnswerGroup>, ReportFacts> groups{};
  const std::vector<SessionOverview> sessions = session_overviews(study, stop);
  const ModelRegistry models = with_stored_plugins(built_in_models(), study);
  std::map<const ReportFacts*, std::vector<std::string>> texts_of_sources{};
  std::map<std::int64_t, Protocol> specified{};  ///< those of the sessions, each once
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    if (stop.stop_requested()) break;
    if (progress) progress(static_cast<double>(i) / static_cast<double>(sessions.size()));
    const ProtocolRow& of = protocols.at(sessions[i].row.protocol_id);
    if (sessions[i].row.withdrawn || (protocol && of.name != *protocol)) continue;
    const ParticipantRow& person = people.at(sessions[i].row.participant);
    const AnswerGroup group = group_of(person, sessions[i].row);
    ReportFacts& facts = groups[{of.name, of.version, group}];
    if (facts.sources.empty()) {
      facts.protocol = of;
      facts.declared_models = models;
      facts.file = check_protocol_text(of.source, of.name, models, std::nullopt, std::nullopt);
    }
    facts.group = group;
    if (facts.sources.insert(of.source_sha256).second) {
      texts_of_sources[&facts].push_back(of.source);
      facts.are_translations = count_protocols(texts_of_sources[&facts]) == 1;
    }
    if (facts.participants.empty() || facts.participants.back().label != person.label) {
      facts.participants.push_back(person);
    }
    const auto [stored, is_new] = specified.try_emplace(of.id);
    if (is_new) stored->second = stored_protocol(of.source).protocol;
    facts.languages[stored->second.language].insert(person.label);
    count_session(study, sessions[i], stored->second, facts);
  }
  std::vector<ReportFacts> all{};
  const std::vector<WithdrawalRow> withdrawals = study.withdrawals();
  for (auto& [key, facts] : groups) {
    const bool is_virtual = facts.group == AnswerGroup::virtual_participants;
    std::copy_if(withdrawals.begin(), withdrawals.end(), std::back_inserter(facts.withdrawals),
                 [is_virtual](const WithdrawalRow& row) { return row.is_virtual == is_virtual; });
    all.push_back(std::move(facts));
  }
  return all;
}

}  // namespace asperity
