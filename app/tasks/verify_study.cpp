#include "app/tasks/verify_study.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include <nlohmann/json.hpp>

#include "app/conductor/form_answer.h"
#include "app/program.h"
#include "app/tasks/recorded_attempt.h"
#include "renderers/offline/replay.h"
#include "results_schema/atomic_file.h"
#include "results_schema/table.h"

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

/// The segments of a session that this very program ran on a system like this one. What
/// ran a segment is stored with its beginning.
std::set<int> segments_of_this_program(const Study& study, const SessionRow& session,
                                       const ProgramIdentity& program) {
  std::set<int> same{};
  for (const EventRow& event : study.events(session.id)) {
    if (event.kind != "session_began" && event.kind != "session_resumed") continue;
    const auto data = nlohmann::json::parse(event.data_json, nullptr, false);
    if (data.is_object() && data.value("program_sha256", "") == program.sha256 &&
        data.value("instruction_set", "") == program.instruction_set &&
        data.value("os", "") == program.os) {
      same.insert(data.value("segment", 0));
    }
  }
  return same;
}

/// Every answer has to be one of the options of the planned question, and to be marked as it says.
void check_answers(const SessionRow& session, const Trial& trial, const AttemptRow& attempt,
                   std::vector<std::string>& problems) {
  for (const ResponseRow& response : attempt.responses) {
    const std::string where = "attempt " + natural_key(session, attempt) + ", item " +
                              std::to_string(response.item) + ": ";
    if (trial.question.form == TrialQuestion::Form::number) {
      if (estimate_in(response.answer) != response.answer_number || !response.answer_number) {
        problems.push_back(where + "the answer is no number above 0, or not the one beside it");
      }
      continue;
    }
    const auto& options = trial.question.options;
    const bool is_option = std::any_of(options.begin(), options.end(), [&](const Option& option) {
      return option.value == response.answer;
    });
    if (!is_option) problems.push_back(where + "the answer is not among the options of the trial");
    const auto item = static_cast<std::size_t>(response.item - 1);
    std::optional<bool> correct{};
    if (item < trial.question.correct.size()) {
      correct = response.answer == trial.question.correct[item];
    }
    if (correct != response.correct) {
      problems.push_back(where + "the answer is not marked as the planned trial says");
    }
  }
}

/// A file in protocols/ may be changed by anybody at any time, and what sessions ran is in the
/// database. But nobody changes a single byte on purpose.
void check_protocol_files(const Study& study, VerifyResult& result) {
  const std::vector<ProtocolRow> stored = study.protocols();
  std::error_code none{};
  std::set<std::filesystem::path> files{};
  for (const auto& entry :
       std::filesystem::directory_iterator(study.folder() / "protocols", none)) {
    if (entry.is_regular_file()) files.insert(entry.path());
  }
  for (const std::filesystem::path& file : files) {
    const std::string text = read_file(file);
    const std::string name = "protocols/" + file.filename().string();
    const ProtocolRow* nearly = nullptr;
    std::size_t byte = 0;
    bool is_stored = false;
    for (const ProtocolRow& row : stored) {
      if (row.source.size() != text.size()) continue;
      const auto [here, there] = std::mismatch(text.begin(), text.end(), row.source.begin());
      is_stored = is_stored || here == text.end();
      if (here == text.end() || !std::equal(here + 1, text.end(), there + 1)) continue;
      nearly = &row;
      byte = static_cast<std::size_t>(here - text.begin());
    }
    if (is_stored || nearly == nullptr) continue;
    result.problems.push_back(name + ": its byte " + std::to_string(byte) +
                              " is not what it was when sessions ran " + nearly->name + " " +
                              nearly->version +
                              "; restore the file, or give it another version if that was meant");
  }
}

/// Adds what `check` throws to the problems, unless it is there already: what is so broken that one
/// check cannot read it is as broken for the next.
void add_failure_of(const std::function<void()>& check, std::vector<std::string>& problems) {
  try {
    check();
  } catch (const std::exception& error) {
    if (std::find(problems.begin(), problems.end(), error.what()) == problems.end()) {
      problems.emplace_back(error.what());
    }
  }
}

}  // namespace

VerifyResult verify_study(Study& study, const ModelRegistry& models, bool replay_too,
                          const std::stop_token& stop,
                          const std::function<void(double)>& progress) {
  VerifyResult result{};
  const double store_share = replay_too ? 0.3 : 0.9;
  result.problems = study.verify([&](double fraction) { progress(store_share * fraction); }, stop);
  if (stop.stop_requested()) return result;
  add_failure_of([&] { result.remarks = study.leftovers(); }, result.problems);
  add_failure_of([&] { check_protocol_files(study, result); }, result.problems);
  std::vector<SessionRow> sessions{};
  add_failure_of([&] { sessions = study.sessions(); }, result.problems);
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
    std::set<int> same_program{};
    std::vector<AttemptRow> attempts{};
    add_failure_of(
        [&] {
          same_program = segments_of_this_program(study, session, program);
          attempts = study.attempts(session.id);
        },
        result.problems);
    for (const AttemptRow& attempt : attempts) {
      const auto number = static_cast<std::size_t>(attempt.trial);
      if (number < 1 || number > plan.trials.size()) {
        result.problems.push_back("attempt " + natural_key(session, attempt) +
                                  ": the plan of its session has no such trial");
        continue;
      }
      const Trial& trial = plan.trials[number - 1];
      check_answers(session, trial, attempt, result.problems);
      if (!replay_too || !attempt.recording || stop.stop_requested()) continue;
      const bool exact = same_program.contains(attempt.segment);
      const std::string name = natural_key(session, attempt);
      try {
        const RecordedAttempt recorded = recorded_attempt(study, session, trial, attempt, builder);
        ++result.recordings_replayed;
        for (const RecordedSurface& surface : recorded.surfaces) {
          const double difference_N = replay_difference_N(recorded, surface);
          const double tolerance_N =
              exact ? 0.0 : surface.stimulus.model->declaration.replay_tolerance_N + kFloatStep_N;
          (exact ? exact_used : tolerance_used) = true;
          if (difference_N <= tolerance_N) continue;
          std::string sentence = "attempt " + name + ", surface " +
                                 std::to_string(surface.row.position) + " (" + surface.row.model +
                                 "): the recorded hand is not given the recorded force again; "
                                 "largest difference " +
                                 text_of_number(difference_N) + " N";
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
