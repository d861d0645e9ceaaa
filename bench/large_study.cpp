// A study with a million attempts: how long its analysis, its check and the reading of its lists
// take.
//
// `--make DIR` writes one through the store, as sessions would, and ends; on a disk that syncs every
// attempt that takes its time, in memory (/dev/shm) some minutes. `--study DIR` measures, by the wall
// and of the processor.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/numbers/random.h"
#include "app/findings/study/analyze_study.h"
#include "app/session/rig/recording_columns.h"
#include "app/session/session_setup.h"
#include "app/tasks/new_study.h"
#include "app/tasks/study_overview.h"
#include "app/tasks/verify/verify_study.h"
#include "device/machine.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/recording.h"
#include "results_schema/study.h"

namespace asperity {
namespace {

constexpr int kRepetitions = 333;  // of the chapter's three trials: 999 trials a session
constexpr double kShareRight = 0.6;
constexpr std::int64_t kTrial_ns = 10'000'000'000;
constexpr std::int64_t kVisitPeriod_ns = 1'000'000'000;
constexpr double kSpread = 0.3;  // SD of the logarithms of times, forces and speeds

/// The chapter's protocol of this kind, with more trials.
std::string long_protocol(const std::string& kind) {
  for (const LibraryProtocol& library : library_protocols()) {
    if (library.name != "chapter_" + kind) continue;
    auto json = nlohmann::ordered_json::parse(library.text);
    json["name"] = "large_" + kind;
    json["blocks"]["main"]["repetitions"] = kRepetitions;
    return json.dump(2);
  }
  throw std::invalid_argument("--kind: selection, matching or recognition");
}

PresentationRow surface_of(const PlannedPresentation& planned) {
  PresentationRow surface{};
  surface.position = planned.position;
  surface.role = planned.role;
  surface.item = planned.item;
  surface.stimulus = planned.stimulus.name;
  surface.model = planned.stimulus.model;
  surface.model_version = "1";
  surface.texture = planned.stimulus.texture;
  surface.parameters_json =
      R"({"depth_limit_m":0.003,"friction_speed_m_per_s":0.01,"height_scale":1.0,)"
      R"("k1_N_per_m":500.0,"lateral_gradient_gain":0.0,"law":"corrected","offset":"none"})";
  surface.assets = {{"height_field", std::string(64, 'a')}};
  surface.seed = "15803544891900678840";
  surface.matched_texture_force_N = 0.03;
  surface.achieved_texture_force_N = 0.03 + 0.001 * planned.position;
  return surface;
}

/// One for a choice, one for each surface of an assignment.
std::vector<std::string> answers_to(const Question& question, Random& random) {
  std::vector<std::string> options{};
  for (const Option& option : question.options) options.push_back(option.value);
  if (std::holds_alternative<AssignmentForm>(question.form)) {
    if (random.uniform() < kShareRight) return question.correct;
    random.shuffle(std::span(options));
    return options;
  }
  if (!question.correct.empty() && random.uniform() < kShareRight) return question.correct;
  return {options[random.below(options.size())]};
}

std::vector<ResponseRow> responses_to(const Question& question, Random& random) {
  nlohmann::json options = nlohmann::json::array();
  for (const Option& option : question.options) options.push_back(option.value);
  std::vector<ResponseRow> responses{};
  for (const std::string& answer : answers_to(question, random)) {
    ResponseRow& response = responses.emplace_back();
    response.question = question.name;
    response.item = static_cast<int>(responses.size());
    response.answer = answer;
    if (responses.size() <= question.correct.size()) {
      response.correct = answer == question.correct[responses.size() - 1];
    }
    response.options_json = options.dump();
    response.source = "virtual";
  }
  return responses;
}

/// What an exploration of a surface stores, with values that differ as those of a hand do: models of equal ones stop early.
void add_exploration_of(int position, double hand, AttemptRow& attempt, Random& random) {
  const auto varied = [&](double typical) {
    return typical * std::exp(hand + kSpread * random.normal());
  };
  PresentationRow& surface = attempt.presentations.back();
  surface.contact_s = varied(2.5);
  const struct {
    const char* quantity;
    double mean;
    double sd;
  } quantities[] = {{"normal_force_N", varied(1.0), varied(0.2)},
                    {"speed_m_per_s", varied(0.1), varied(0.03)},
                    {"contact_s", surface.contact_s, 0.0},
                    {"strokes", std::round(varied(5.0)), 0.0},
                    {"stroke_length_m", varied(0.04), varied(0.005)}};
  for (const auto& each : quantities) {
    ComplianceRow row{};
    row.position = position;
    row.quantity = each.quantity;
    row.mean = row.p50 = each.mean;
    row.sd = each.sd;
    row.p05 = std::max(0.0, each.mean - 1.6 * each.sd);
    row.p95 = each.mean + 1.6 * each.sd;
    row.fraction_in_band = 0.9;
    row.passed = true;
    attempt.compliance.push_back(row);
  }
  VisitRow visit{};
  visit.contact_ns = attempt.onset_ns + position * kVisitPeriod_ns;
  visit.offset_ns = visit.contact_ns + kVisitPeriod_ns / 2;
  visit.contact_s = surface.contact_s;
  visit.path_m = varied(0.2);
  visit.force_mean_N = quantities[0].mean;
  visit.force_sd_N = quantities[0].sd;
  visit.speed_mean_m_per_s = quantities[1].mean;
  visit.speed_sd_m_per_s = quantities[1].sd;
  surface.visits.push_back(visit);
}

/// `hand`: of the participant, the logarithm of a factor of times, forces and speeds.
AttemptRow attempt_of(const Trial& trial, int segment, double hand, Random& random) {
  AttemptRow attempt{};
  attempt.trial = trial.ordinal;
  attempt.attempt = 1;
  attempt.segment = segment;
  attempt.onset_ns = trial.ordinal * kTrial_ns;
  attempt.offset_ns = attempt.onset_ns + kTrial_ns / 2;
  for (const PlannedPresentation& planned : trial.presentations) {
    attempt.presentations.push_back(surface_of(planned));
    add_exploration_of(planned.position, hand, attempt, random);
  }
  attempt.responses = responses_to(trial.questions.front(), random);
  const double time_s = 1.5 * std::exp(hand + kSpread * random.normal());
  for (ResponseRow& response : attempt.responses) {
    response.time_ns = attempt.offset_ns;
    response.from_cue_s = time_s;
  }
  attempt.servo.emplace();
  attempt.servo->rate_Hz = 1000.0;
  attempt.servo->ticks = 5000;
  return attempt;
}

/// Noise, which does not pack: as many bytes as there can be.
RecordingRow record(const Study& study, const std::string& path, int ticks, Random& random) {
  RecordingWriter writer(study.folder(), path, {.rate_Hz = 1000.0, .columns = recording_columns()});
  std::array<float, kRecordingColumns> values{};
  for (int tick = 0; tick < ticks; ++tick) {
    for (float& value : values) value = static_cast<float>(random.uniform());
    writer.append(tick * 1'000'000, values.data());
  }
  return writer.finish();
}

struct StudyWish {
  std::string kind = "selection";
  int attempts = 1'000'000;
  int recorded_ticks = 0;  ///< of every attempt
};

void make_study(const std::filesystem::path& folder, const StudyWish& wish) {
  new_demo_study(folder, [](double) {});
  const std::string source = long_protocol(wish.kind);
  const std::string name = "large_" + wish.kind;
  write_file(folder / "protocols" / (name + ".json"), source, Overwrite::refuse);
  const Protocol protocol = read_protocol(source, name, declarations_of(built_in_models()));
  const ProgramIdentity program = this_program();
  Study study = Study::open(folder, Access::read_write);
  Random random(7);
  int number = 10000;  // so that labels sort as they are given
  for (int begun = 0; begun < wish.attempts; ++number) {
    ParticipantRow person{};
    person.label = "p" + std::to_string(number);
    person.sex = number % 2 == 0 ? "F" : "M";
    study.add_participant(person);
    const OpenSession session = begin_session(study, protocol, person.label,
                                              {.seed = static_cast<std::uint64_t>(number),
                                               .pacing = "real_time",
                                               .scheduling = "none",
                                               .device = device_overviews().front(),
                                               .started_utc = "2001-02-03T04:05:06Z"},
                                              program);
    const std::int64_t id = session.row.id;
    const int segment = study.begin_segment(id, 0);
    const double hand = kSpread * random.normal();
    for (const Trial& trial : session.course->plan().trials) {
      AttemptRow attempt = attempt_of(trial, segment, hand, random);
      if (wish.recorded_ticks > 0) {
        attempt.recording = record(study,
                                   "recordings/" + person.label + "/session-01/trial-" +
                                       std::to_string(trial.ordinal) + "-attempt-1.rec",
                                   wish.recorded_ticks, random);
      }
      study.add_attempt(id, attempt);
    }
    const std::int64_t end_ns = (std::ssize(session.course->plan().trials) + 1) * kTrial_ns;
    study.end_segment(id, segment, end_ns, "completed");
    study.end_session(id, SessionState::completed, "2001-02-03T07:05:06Z");
    begun += static_cast<int>(session.course->plan().trials.size());
    std::cerr << "\r" << begun << " attempts" << std::flush;
  }
  std::cerr << '\n';
}

struct Taken {
  double wall_s = 0.0;
  double cpu_s = 0.0;  ///< what it would take on a machine with nothing beside it and a warm disk
};

template <class Function>
Taken time_taken_by(const Function& function) {
  const auto began = std::chrono::steady_clock::now();
  const std::clock_t cpu_began = std::clock();
  function();
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count(),
          static_cast<double>(std::clock() - cpu_began) / CLOCKS_PER_SEC};
}

nlohmann::ordered_json case_of(const std::string& name, double value_s) {
  return {{"name", name},     {"unit", "s"}, {"p50", value_s}, {"p99", value_s},
          {"p99_9", value_s}, {"count", 1},  {"preempted", 0}};
}

void measure(const std::filesystem::path& folder, bool json) {
  nlohmann::ordered_json cases = nlohmann::ordered_json::array();
  const auto time = [&](const std::string& name, const auto& function) {
    const Taken taken = time_taken_by(function);
    cases.push_back(case_of(name, taken.wall_s));
    cases.push_back(case_of(name + "/cpu", taken.cpu_s));
    if (!json) {
      std::cout << name << ": " << taken.wall_s << " s, " << taken.cpu_s << " s of processor\n";
    }
  };
  Study study = Study::open(folder, Access::read_only);
  time("session_overviews", [&] { (void)session_overviews(study, {}); });
  time("participant_overviews", [&] { (void)participant_overviews(study); });
  time("protocol_overviews", [&] { (void)protocol_overviews(study, built_in_models(), {}); });
  time("analyze_study", [&] { (void)analyze_study(study); });
  time("verify_study", [&] {
    const VerifyResult result = verify_study(study, built_in_models(), false, {}, [](double) {});
    if (!result.problems.empty()) throw std::runtime_error(result.problems.front());
  });
  if (!json) return;
  const nlohmann::ordered_json document{{"format", "asperity.bench/1"},
                                        {"machine", machine()},
                                        {"commit", ASPERITY_COMMIT},
                                        {"isa", "none"},
                                        {"cases", cases}};
  std::cout << document.dump(2) << '\n';
}

int run(const std::vector<std::string>& arguments) {
  std::filesystem::path make{};
  std::filesystem::path study{};
  StudyWish wish{};
  bool json = false;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == "--json") {
      json = true;
      continue;
    }
    if (i + 1 == arguments.size()) break;
    const std::string& value = arguments[++i];
    if (arguments[i - 1] == "--make") make = value;
    if (arguments[i - 1] == "--study") study = value;
    if (arguments[i - 1] == "--kind") wish.kind = value;
    if (arguments[i - 1] == "--attempts") wish.attempts = std::stoi(value);
    if (arguments[i - 1] == "--recorded") wish.recorded_ticks = std::stoi(value);
  }
  if (!make.empty()) {
    make_study(make, wish);
    return 0;
  }
  if (!study.empty()) {
    measure(study, json);
    return 0;
  }
  std::cerr << "bench_large_study --make DIR [--kind selection|matching|recognition] "
               "[--attempts N] [--recorded TICKS]\nbench_large_study --study DIR [--json]\n";
  return 2;
}

}  // namespace
}  // namespace asperity

int main(int argc, char** argv) {
  try {
    return asperity::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::cerr << "bench_large_study: " << error.what() << '\n';
    return 1;
  }
}
