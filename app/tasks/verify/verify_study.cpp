// Checks checksum, database, files and rows, and replays the recorded hands of each session.

#include "app/tasks/verify/verify_study.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <exception>
#include <future>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/plugins/stored_plugins.h"
#include "app/records/builders_of_attempts.h"
#include "app/records/recorded_attempt.h"
#include "app/session/attempt_measures.h"
#include "app/session/session_compute.h"
#include "app/study_files/program.h"
#include "app/tasks/verify/verify_groups.h"
#include "app/tasks/verify/verify_instability.h"
#include "app/tasks/verify/verify_places.h"
#include "app/tasks/verify/verify_questionnaire.h"
#include "protocols/plan/shown_options.h"
#include "results_schema/error_text.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/files/folder_entries.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

// A recording stores floats; two nearly equal forces may be rounded to adjacent ones (at 8 N).
constexpr double kFloatStep_N = 1e-6;

double largest_difference(const glm::dvec3& a, const glm::dvec3& b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

/// The largest difference between the recorded and the replayed forces of one surface.
double replay_difference_N(const RecordedAttempt& attempt, const RecordedSurface& surface) {
  const auto [felt, again] = replay_surface(attempt, surface.row.position, *surface.stimulus.model,
                                            surface.stimulus.inputs);
  double difference_N = 0.0;
  for (std::size_t i = 0; i < felt.size(); ++i) {
    if (!felt[i].has(TickFlag::presenting)) continue;
    difference_N =
        std::max(difference_N, largest_difference(rounded_for_recording(again[i].wrench.force_N),
                                                  felt[i].rendered.force_N));
  }
  return difference_N;
}

/// What differs between the stored number of gaps in contact with a surface and that of the recording; empty: nothing.
std::string differing_gaps(const RecordedAttempt& attempt, const PresentationRow& surface) {
  const std::int64_t recorded =
      gaps_in_contact_of(attempt.records, static_cast<std::uint64_t>(surface.position));
  if (recorded == surface.gaps_in_contact) return {};
  return "the stored number of gaps in contact is " + std::to_string(surface.gaps_in_contact) +
         ", that of the recording is " + std::to_string(recorded);
}

/// What ran a segment of a session; stored with its beginning.
struct SegmentMaker {
  bool is_this_program = false;  ///< exactly this build, on a system like this one
  std::optional<ComputeDeviceName> compute{};
};

std::map<int, SegmentMaker> makers_of_segments(const Study& study, const SessionRow& session,
                                               const ProgramIdentity& program) {
  std::map<int, SegmentMaker> makers{};
  for (const EventRow& event : study.events(session.id)) {
    if (event.kind != "session_began" && event.kind != "session_resumed") continue;
    const auto data = nlohmann::json::parse(event.data_json, nullptr, false);
    if (!data.is_object()) continue;
    makers[data.value("segment", 0)] = {
        .is_this_program = data.value("program_sha256", "") == program.sha256 &&
                           data.value("instruction_set", "") == program.instruction_set &&
                           data.value("os", "") == program.os,
        .compute = stored_compute(data)};
  }
  return makers;
}

/// Ticks of a surface that the processor evaluated because the compute device had no answer in time.
std::int64_t ticks_without_compute(const RecordedSurface& surface) {
  const auto& limits = surface.row.limits;
  const auto found = std::find_if(limits.begin(), limits.end(),
                                  [](const auto& limit) { return limit.kind == "no_compute"; });
  return found == limits.end() ? 0 : found->ticks;
}

void keep_largest(std::map<std::string, double>& largest_N, const std::string& of,
                  double difference_N) {
  double& known_N = largest_N[of];
  known_N = std::max(known_N, difference_N);
}

/// The problems of one session.
struct SessionFaults {
  struct Failure {
    std::string before{};  ///< the beginning of the sentence, which names its subject
    std::string what{};
  };
  std::vector<Failure> failures{};  ///< of reading: another check may have reported the same one
  std::vector<std::string> problems{};
  int recordings_replayed = 0;
  int attempts_without_recording = 0;
  int recordings_without_plugin = 0;
  /// Of surfaces whose contacts the replay evaluates elsewhere than the session did: device and the largest difference.
  std::map<std::string, double> differences_by_device_N{};
  /// Of surfaces whose model had another version, by model and version, with the largest difference beyond the tolerance.
  std::map<std::string, double> differences_by_version_N{};
  bool has_stated_levels = false;  ///< of an external program
  bool exact_used = false;
  bool tolerance_used = false;
};

/// Whether surfaces were felt in the planned order, and all of them unless the attempt was
/// interrupted.
bool are_as_planned(std::span<const SessionAnswers::Surface> felt,
                    const std::vector<std::string>& words, const Trial& planned) {
  const auto is_as_planned = [&words](const SessionAnswers::Surface& surface,
                                      const PlannedPresentation& presentation) {
    return words[surface.item] == presentation.item &&
           words[surface.model] == presentation.stimulus.model &&
           words[surface.texture] == presentation.stimulus.texture;
  };
  return felt.size() <= planned.presentations.size() &&
         std::equal(felt.begin(), felt.end(), planned.presentations.begin(), is_as_planned);
}

/// Checks that every answer is one of the options of the planned question and agrees with it in the mark of
/// correctness, and that the options stored with it are those of the question.
void check_answers(const SessionRow& session, const Plan& plan, const SessionAnswers& answers,
                   std::vector<std::string>& problems) {
  AttemptRow at{};  // for the sentences: the attempts of a trial are in order, numbered from 1
  for (const SessionAnswers::Attempt& attempt : answers.attempts) {
    at.attempt = attempt.trial == at.trial ? at.attempt + 1 : 1;
    at.trial = attempt.trial;
    const auto where = [&] { return "attempt " + natural_key(session, at); };
    const auto number = static_cast<std::size_t>(attempt.trial);
    if (number < 1 || number > plan.trials.size()) {
      problems.push_back(where() + ": the plan of its session has no such trial");
      continue;
    }
    const Trial& planned = plan.trials[number - 1];
    if (!are_as_planned(answers.surfaces_of(attempt), answers.words, planned)) {
      problems.push_back(where() + ": its surfaces differ from those of the planned trial");
    }
    std::map<std::string, std::vector<AnsweredItem>> stored{};
    std::set<std::string> not_asked{};
    for (const SessionAnswers::Reply& reply : answers.replies_of(attempt)) {
      const std::string& name = answers.words[reply.question];
      if (!reply.was_asked) not_asked.insert(name);
      std::vector<AnsweredItem>& items = stored[name];
      items.push_back({.item = reply.item,
                       .answer = answers.words[reply.answer],
                       .number = reply.number,
                       .correct = reply.correct});
      const Question* const question = find_question(planned, name);
      if (question == nullptr) {
        problems.push_back(where() + ": the planned trial has no question " + name);
      } else if (answers.words[reply.options_json] != options_json_of(*question)) {
        problems.push_back(where() + ", question " + name +
                           ": the options stored with the response differ from those of the "
                           "planned trial");
      }
    }
    const int surfaces = static_cast<int>(planned.presentations.size());
    const auto meets = [&stored](const AnswerCondition& condition) {
      const auto needed = stored.find(condition.question);
      return needed != stored.end() && is_met(condition, texts_of(needed->second));
    };
    for (const Question& question : planned.questions) {
      const auto items = stored.find(question.name);
      if (items == stored.end()) continue;
      const bool was_asked = !not_asked.contains(question.name);
      const bool is_condition_met = !question.condition || meets(*question.condition);
      for (const std::string& problem :
           answer_problems(question, items->second, was_asked, is_condition_met, surfaces)) {
        problems.push_back(where() + ", question " + question.name + ": " + problem);
      }
    }
  }
}

/// Checks whether every recorded hand of a session receives the same forces again.
void replay_session(const Study& study, const SessionRow& session, const Plan& plan,
                    const ProgramIdentity& program, BuildersOfAttempts& builders,
                    const std::stop_token& stop, SessionFaults& faults) {
  std::map<int, SegmentMaker> makers = makers_of_segments(study, session, program);
  for (const AttemptRow& attempt : study.attempts(session.id)) {
    const auto number = static_cast<std::size_t>(attempt.trial);
    if (number < 1 || number > plan.trials.size()) continue;
    if (!attempt.recording) {
      ++faults.attempts_without_recording;
      continue;
    }
    if (stop.stop_requested()) return;
    const SegmentMaker& maker = makers[attempt.segment];
    StimulusBuilder* const builder = builders.builder_for(attempt, maker.compute.has_value());
    if (builder == nullptr) {  // `plugin_problems` reports it
      ++faults.recordings_without_plugin;
      continue;
    }
    const std::string name = "attempt " + natural_key(session, attempt);
    try {
      const RecordedAttempt recorded =
          recorded_attempt(study.folder(), session, plan.trials[number - 1], attempt, *builder);
      ++faults.recordings_replayed;
      for (const RecordedSurface& surface : recorded.surfaces) {
        const std::string of_surface = name + ", surface " + std::to_string(surface.row.position) +
                                       " (" + surface.row.model + "): ";
        if (const std::string gaps = differing_gaps(recorded, surface.row); !gaps.empty()) {
          faults.problems.push_back(of_surface + gaps);
        }
        const double difference_N = replay_difference_N(recorded, surface);
        const std::shared_ptr<const Compute>& compute = surface.stimulus.model->compute;
        const bool computed_then =
            maker.compute && surface.stimulus.model->declaration.needs_bodies;
        // The processor keeps heights, whose errors the device does not have.
        if (computed_then && (!compute || ticks_without_compute(surface) > 0)) {
          keep_largest(faults.differences_by_device_N, described(*maker.compute), difference_N);
          continue;
        }
        const bool exact = maker.is_this_program &&
                           (!computed_then || is_same(compute->device.name(), *maker.compute));
        const double tolerance_N =
            exact ? 0.0 : surface.stimulus.model->declaration.replay_tolerance_N + kFloatStep_N;
        (exact ? faults.exact_used : faults.tolerance_used) = true;
        const auto differing =
            differing_instability(recorded, surface, exact ? Agreement::exact : Agreement::close);
        // Forces that differ are reported below, and explain it.
        if (differing && difference_N <= tolerance_N) {
          faults.problems.push_back(of_surface + *differing);
        }
        if (difference_N <= tolerance_N) continue;
        const ModelDeclaration& declaration = surface.stimulus.model->declaration;
        if (surface.row.model_version != declaration.version) {
          keep_largest(faults.differences_by_version_N,
                       "forces of " + declaration.id + " that were recorded with its version " +
                           surface.row.model_version + " and replayed with version " +
                           declaration.version,
                       difference_N);
          continue;
        }
        std::string sentence = of_surface +
                               "the replay of the recorded hand does not reproduce the recorded "
                               "force; largest difference " +
                               text_of_number(difference_N) + " N";
        if (attempt.servo && attempt.servo->lost_records > 0) {
          sentence += " (" + std::to_string(attempt.servo->lost_records) +
                      " ticks are missing from the recording, which can be the cause)";
        }
        faults.problems.push_back(std::move(sentence));
      }
    } catch (const std::exception& error) {
      const std::string what = message_of(error);
      faults.failures.push_back({what.find(name) == std::string::npos ? name + ": " : "", what});
    }
  }
}

/// A file in protocols/ may be changed at any time, and the protocols that sessions ran are in the
/// database. A change of a single byte, however, is unlikely to be intentional.
void check_protocol_files(const Study& study, VerifyResult& result) {
  const std::vector<ProtocolRow> stored = study.protocols();
  for (const auto& entry : entries_in(study.folder() / "protocols")) {
    std::error_code unknown{};
    const std::filesystem::path& file = entry.path();
    if (!entry.is_regular_file(unknown)) continue;
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
    result.problems.push_back(
        name + ": byte " + std::to_string(byte) + " has changed since sessions were run with " +
        nearly->name + " " + nearly->version +
        "; restore the file, or give it another version if the change was intended");
  }
}

/// Unless it is already reported: data that one check cannot read are also unreadable for the next,
/// and the damage of a recording is part of the report on its checksum.
void add_unless_told(const std::string& what, const std::string& before,
                     std::vector<std::string>& problems) {
  const auto tells = [&what](const std::string& told) {
    return told.find(what) != std::string::npos;
  };
  if (std::none_of(problems.begin(), problems.end(), tells)) problems.push_back(before + what);
}

void add_once(const std::string& problem, std::vector<std::string>& problems) {
  if (std::find(problems.begin(), problems.end(), problem) == problems.end()) {
    problems.push_back(problem);
  }
}

/// Parts of the store that another thread checks before any session, while the caller lets SQLite
/// check the file, which takes longest.
constexpr std::array kBeside{StudyPart::checksum, StudyPart::rows};

/// A replay keeps bodies in memory; in a process that writes there are no readers unknown to the
/// caller.
std::size_t threads_for(const Study& study, bool replay_too, std::size_t sessions) {
  constexpr unsigned kMost = 8;
  if (replay_too || study.access() != Access::read_only) return 1;
  return std::min<std::size_t>(std::clamp(std::thread::hardware_concurrency(), 1U, kMost),
                               kBeside.size() + sessions);
}

/// Passes progress on. An exception from it ends the work and is not mistaken for a problem of the
/// study by the checks around it.
class ProgressToCaller final {
 public:
  ProgressToCaller(const std::function<void(double)>& progress, std::stop_source& end)
      : progress_(progress), end_(end) {}
  void tell(double fraction) {
    if (failure_) return;
    try {
      progress_(fraction);
    } catch (...) {
      failure_ = std::current_exception();
      end_.request_stop();
    }
  }
  void rethrow_failure() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  const std::function<void(double)>& progress_;
  std::stop_source& end_;
  std::exception_ptr failure_{};
};

/// Adds an exception of `check` to the problems.
void add_failure_of(const std::function<void()>& check, std::vector<std::string>& problems) {
  try {
    check();
  } catch (const std::exception& error) {
    add_unless_told(message_of(error), "", problems);
  }
}

/// Zero also where it cannot be read, which the checks report.
std::size_t number_of_withdrawals(const Study& study) {
  try {
    return study.withdrawals().size();
  } catch (const std::exception&) {
    return 0;
  }
}

VerifyResult verify_once(Study& study, const ModelBuilds& builds, bool replay_too,
                         const std::stop_token& asked_to_stop,
                         const std::function<void(double)>& progress) {
  VerifyResult result{};
  std::stop_source end{};
  const std::stop_callback end_when_asked(asked_to_stop, [&end] { end.request_stop(); });
  const std::stop_token stop = end.get_token();
  ProgressToCaller to_caller(progress, end);
  std::vector<SessionRow> sessions{};
  std::vector<std::string> failures{};
  add_failure_of([&] { sessions = study.sessions(); }, failures);
  std::vector<SessionFaults> found(sessions.size());
  const ProgramIdentity& program = this_program();
  // Work shared between threads: parts of the store, then session by session.
  std::array<std::vector<std::string>, kBeside.size()> beside{};
  std::atomic<std::size_t> next{0};
  // Each thread has a separate study.
  const auto take_share = [&](const Study& own, const std::function<void(double)>& tell) {
    BuildersOfAttempts builders(builds, own.folder());
    PlansOfSessions plans(own, builds.models());
    while (!stop.stop_requested()) {
      const std::size_t place = next++;
      if (place < kBeside.size()) {
        add_failure_of([&] { beside[place] = own.verify({}, stop, {kBeside[place]}); },
                       beside[place]);
        continue;
      }
      const std::size_t s = place - kBeside.size();
      if (s >= sessions.size()) return;
      tell(static_cast<double>(s) / static_cast<double>(sessions.size()));
      try {
        const Plan plan = plans.of(sessions[s]);
        found[s].has_stated_levels = plans.has_stated_levels(sessions[s]);
        check_answers(sessions[s], plan, own.answers(sessions[s].id), found[s].problems);
        for (const std::string& problem :
             questionnaire_problems(sessions[s], plans.protocol_of(sessions[s]),
                                    own.session_answers(sessions[s].id))) {
          found[s].problems.push_back(problem);
        }
        if (replay_too) replay_session(own, sessions[s], plan, program, builders, stop, found[s]);
      } catch (const std::exception& error) {
        found[s].failures.push_back({"", message_of(error)});
      }
    }
  };
  const auto take_share_beside = [&] {
    try {
      take_share(Study::open(study.folder(), Access::read_only), [](double) {});
    } catch (const std::exception&) {
      // This thread cannot help: its work is left to the others, including the caller.
    }
  };
  std::vector<std::future<void>> others{};
  for (std::size_t i = 1; i < threads_for(study, replay_too, sessions.size()); ++i) {
    try {
      others.push_back(std::async(std::launch::async, take_share_beside));
    } catch (const std::system_error&) {
      break;  // no further thread is available
    }
  }
  std::vector<StudyPart> parts{StudyPart::database, StudyPart::files};
  if (others.empty()) {
    parts = {StudyPart::checksum, StudyPart::database, StudyPart::files, StudyPart::rows};
    next = kBeside.size();
  }
  const double store_share = replay_too ? 0.3 : 0.9;
  std::vector<std::string> by_caller{};
  add_failure_of(
      [&] {
        by_caller =
            study.verify([&](double share) { to_caller.tell(store_share * share); }, stop, parts);
      },
      by_caller);
  take_share(study,
             [&](double share) { to_caller.tell(store_share + (1.0 - store_share) * share); });
  for (const std::future<void>& other : others) other.wait();
  to_caller.rethrow_failure();
  // In an order that does not depend on the threads.
  for (const auto* const part : {&beside[0], &by_caller, &beside[1]}) {
    for (const std::string& problem : *part) add_once(problem, result.problems);
  }
  if (stop.stop_requested()) return result;
  add_failure_of([&] { result.remarks = study.leftovers(); }, result.problems);
  add_failure_of([&] { check_protocol_files(study, result); }, result.problems);
  add_failure_of(
      [&] {
        PlansOfSessions plans(study, builds.models());
        for (const std::string& problem : group_problems(study, plans)) {
          result.problems.push_back(problem);
        }
        for (const std::string& problem : place_problems(study, plans)) {
          result.problems.push_back(problem);
        }
        for (const std::string& warning : shared_places(study)) result.remarks.push_back(warning);
      },
      result.problems);
  add_failure_of(
      [&] {
        for (const std::string& problem : plugin_problems(builds, study)) {
          result.problems.push_back(problem);
          ++result.plugin_problems;
        }
      },
      result.problems);
  for (const std::string& failure : failures) add_unless_told(failure, "", result.problems);
  bool exact_used = false;
  bool tolerance_used = false;
  std::map<std::string, double> differences_by_device_N{};
  std::map<std::string, double> differences_by_version_N{};
  int with_stated_levels = 0;
  int without_plugin = 0;
  for (SessionFaults& faults : found) {
    for (const SessionFaults::Failure& failure : faults.failures) {
      add_unless_told(failure.what, failure.before, result.problems);
    }
    std::move(faults.problems.begin(), faults.problems.end(), std::back_inserter(result.problems));
    result.recordings_replayed += faults.recordings_replayed;
    result.attempts_without_recording += faults.attempts_without_recording;
    without_plugin += faults.recordings_without_plugin;
    with_stated_levels += faults.has_stated_levels ? 1 : 0;
    for (const auto& [device, difference_N] : faults.differences_by_device_N) {
      keep_largest(differences_by_device_N, device, difference_N);
    }
    for (const auto& [versions, difference_N] : faults.differences_by_version_N) {
      keep_largest(differences_by_version_N, versions, difference_N);
    }
    exact_used = exact_used || faults.exact_used;
    tolerance_used = tolerance_used || faults.tolerance_used;
  }
  if (without_plugin > 0) {
    result.remarks.push_back(
        "recordings that were not replayed because their plug-in is not loaded: " +
        std::to_string(without_plugin));
  }
  for (const auto& [device, difference_N] : differences_by_device_N) {
    result.remarks.push_back("forces computed on " + device +
                             ", of which the processor computed at least a part (then or in the "
                             "replay), differ by up to " +
                             text_of_number(difference_N) + " N; they are not compared further");
  }
  for (const auto& [versions, difference_N] : differences_by_version_N) {
    result.remarks.push_back(versions + " differ by up to " + text_of_number(difference_N) + " N");
  }
  if (with_stated_levels > 0) {
    result.rules.push_back(
        "levels of an external program, as stored (their range, order and tracks were checked): " +
        std::to_string(with_stated_levels) + (with_stated_levels == 1 ? " session" : " sessions"));
  }
  if (exact_used) result.rules.emplace_back("same program and system: compared bit for bit");
  if (tolerance_used) {
    result.rules.emplace_back(
        "another program or system: compared within each model's declared tolerance");
  }
  return result;
}

}  // namespace

VerifyResult verify_study(Study& study, const ModelBuilds& builds, bool replay_too,
                          const std::stop_token& asked_to_stop,
                          const std::function<void(double)>& progress) {
  for (;;) {
    const std::size_t withdrawals = number_of_withdrawals(study);
    VerifyResult result = verify_once(study, builds, replay_too, asked_to_stop, progress);
    if (result.problems.empty() || number_of_withdrawals(study) == withdrawals) {
      if (!asked_to_stop.stop_requested()) progress(1.0);
      return result;
    }
  }
}

}  // namespace asperity
