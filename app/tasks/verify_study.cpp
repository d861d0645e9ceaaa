#include "app/tasks/verify_study.h"

#include <algorithm>
#include <cmath>

#include "app/program.h"
#include "app/tasks/recorded_attempt.h"
#include "renderers/offline/replay.h"

namespace asperity {

namespace {

// A recording keeps floats; two forces that are nearly equal may fall on neighbouring ones (at 8
// N).
constexpr double kFloatStep_N = 1e-6;

glm::dvec3 as_float(const glm::dvec3& v) {
  return {static_cast<double>(static_cast<float>(v.x)),
          static_cast<double>(static_cast<float>(v.y)),
          static_cast<double>(static_cast<float>(v.z))};
}

double largest_difference(const glm::dvec3& a, const glm::dvec3& b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

/// The largest difference between the recorded forces of one surface and those rendered again.
double replay_difference_N(const RecordedAttempt& attempt, const RecordedSurface& surface) {
  std::vector<TickRecord> felt{};
  for (const TickRecord& record : attempt.records) {
    if (record.presentation == static_cast<std::uint64_t>(surface.row.position)) {
      felt.push_back(record);
    }
  }
  const auto renderer = surface.stimulus.model->make(surface.stimulus.inputs);
  const std::vector<RenderedTick> again = replay(*renderer, felt, attempt.rate_Hz);
  double difference_N = 0.0;
  for (std::size_t i = 0; i < felt.size(); ++i) {
    if (!felt[i].has(TickFlag::presenting)) continue;
    difference_N = std::max(difference_N, largest_difference(as_float(again[i].wrench.force_N),
                                                             felt[i].rendered.force_N));
  }
  return difference_N;
}

}  // namespace

VerifyResult verify_study(Study& study, const ModelRegistry& models, bool replay_too,
                          const std::stop_token& stop,
                          const std::function<void(double)>& progress) {
  VerifyResult result{};
  const double store_share = replay_too ? 0.3 : 0.9;
  result.problems = study.verify([&](double fraction) { progress(store_share * fraction); });
  const std::vector<SessionRow> sessions = study.sessions();
  StimulusBuilder builder(models, study.folder());
  const ProgramIdentity program = this_program();
  bool exact_used = false;
  bool tolerance_used = false;
  for (std::size_t s = 0; s < sessions.size() && !stop.stop_requested(); ++s) {
    const SessionRow& session = sessions[s];
    progress(store_share +
             (1.0 - store_share) * static_cast<double>(s) / static_cast<double>(sessions.size()));
    Plan plan{};
    try {
      plan = plan_of(study, session, models);
    } catch (const std::exception& error) {
      result.problems.emplace_back(error.what());
      continue;
    }
    if (!replay_too) continue;
    const bool same_program = session.program_sha256 == program.sha256 &&
                              session.instruction_set == program.instruction_set &&
                              session.os == program.os;
    for (const AttemptRow& attempt : study.attempts(session.id)) {
      if (!attempt.recording || stop.stop_requested()) continue;
      const std::string name = session.participant + '/' + std::to_string(session.session) + '/' +
                               std::to_string(attempt.trial) + '/' +
                               std::to_string(attempt.attempt);
      try {
        const RecordedAttempt recorded = recorded_attempt(
            study, session, plan.trials.at(static_cast<std::size_t>(attempt.trial - 1)), attempt,
            builder);
        ++result.recordings_replayed;
        for (const RecordedSurface& surface : recorded.surfaces) {
          const double difference_N = replay_difference_N(recorded, surface);
          const double tolerance_N =
              same_program ? 0.0
                           : surface.stimulus.model->declaration.replay_tolerance_N + kFloatStep_N;
          (same_program ? exact_used : tolerance_used) = true;
          if (difference_N <= tolerance_N) continue;
          std::string sentence = "attempt " + name + ", surface " +
                                 std::to_string(surface.row.position) + " (" + surface.row.model +
                                 "): the recorded hand is not given the recorded force again; "
                                 "largest difference " +
                                 std::to_string(difference_N) + " N";
          if (attempt.servo && attempt.servo->lost_records > 0) {
            sentence +=
                " (" + std::to_string(attempt.servo->lost_records) + " records of it were lost)";
          }
          result.problems.push_back(std::move(sentence));
        }
      } catch (const std::exception& error) {
        result.problems.push_back("attempt " + name + ": " + error.what());
      }
    }
  }
  if (exact_used) result.rules.emplace_back("same program and system: compared bit for bit");
  if (tolerance_used) {
    result.rules.emplace_back(
        "another program or system: compared within each model's declared tolerance");
  }
  return result;
}

}  // namespace asperity
