// A study with a million attempts: how long its analysis and the reading of its lists take.
//
// `--make DIR` writes one through the store, as sessions would, and ends; on a disk that syncs every
// attempt that takes its time, in memory (/dev/shm) some minutes. `--study DIR` measures, by the wall
// and of the processor.

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/random.h"
#include "app/analyses/analyze_study.h"
#include "app/tasks/study_overview.h"
#include "results_schema/study.h"

namespace asperity {
namespace {

const std::vector<std::string> kModels{"height_map", "sinusoid", "stochastic"};
const std::vector<std::string> kTextures{"metal", "stone", "wood", "brick"};
const std::vector<std::string> kPictures{"metal", "stone", "wood", "brick", "gravel", "grass"};
constexpr int kTrials = 1000;  // of a session
constexpr double kShareRight = 0.6;

struct MadeTrial {
  std::vector<PresentationRow> surfaces{};
  std::vector<ResponseRow> responses{};
};

PresentationRow surface_of(const std::string& item, const std::string& model,
                           const std::string& texture, int position) {
  PresentationRow surface{};
  surface.position = position;
  surface.role = "alternative";
  surface.item = item;
  surface.stimulus = "rendered_" + texture + "_" + model;
  surface.model = model;
  surface.model_version = "1";
  surface.texture = texture;
  surface.parameters_json =
      R"({"depth_limit_m":0.003,"friction_speed_m_per_s":0.01,"height_scale":1.0,)"
      R"("k1_N_per_m":500.0,"lateral_gradient_gain":0.0,"law":"corrected","offset":"none"})";
  surface.height_field_sha256 = std::string(64, 'a');
  surface.seed = "15803544891900678840";
  surface.contact_s = 2.5;
  surface.matched_texture_force_N = 0.03;
  surface.achieved_texture_force_N = 0.03 + 0.001 * position;
  return surface;
}

ResponseRow response_of(int item, const std::string& answer, std::optional<bool> correct,
                        const std::string& options_json) {
  ResponseRow response{};
  response.question = "which";
  response.item = item;
  response.answer = answer;
  response.correct = correct;
  response.options_json = options_json;
  response.from_cue_s = 1.5;
  response.source = "virtual";
  return response;
}

MadeTrial trial_of(const std::string& kind, const std::string& texture, Random& random) {
  MadeTrial made{};
  if (kind == "selection") {
    std::vector<std::string> models = kModels;
    random.shuffle(std::span(models));
    int position = 0;
    for (const std::string& model : models) {
      made.surfaces.push_back(surface_of(model, model, texture, ++position));
    }
    const bool likes = random.uniform() < 0.25;
    made.responses.push_back(response_of(1, likes ? kModels[0] : models[random.below(3)], {},
                                         nlohmann::json(models).dump()));
  } else if (kind == "matching") {
    std::vector<std::string> felt = kTextures;
    random.shuffle(std::span(felt));
    std::vector<std::string> answers = felt;
    if (random.uniform() > kShareRight) random.shuffle(std::span(answers));
    const std::string options = nlohmann::json(kTextures).dump();
    for (std::size_t i = 0; i < felt.size(); ++i) {
      const int position = static_cast<int>(i) + 1;
      made.surfaces.push_back(surface_of(felt[i], "height_map", felt[i], position));
      made.responses.push_back(response_of(position, answers[i], answers[i] == felt[i], options));
    }
  } else {
    made.surfaces.push_back(surface_of(texture, "height_map", texture, 1));
    std::vector<std::string> options = kPictures;
    random.shuffle(std::span(options));
    const std::string answer =
        random.uniform() < kShareRight ? texture : options[random.below(options.size())];
    made.responses.push_back(
        response_of(1, answer, answer == texture, nlohmann::json(options).dump()));
  }
  return made;
}

AttemptRow attempt_of(MadeTrial&& made, int trial, int segment) {
  constexpr std::int64_t kTrial_ns = 10'000'000'000;
  AttemptRow attempt{};
  attempt.trial = trial;
  attempt.attempt = 1;
  attempt.segment = segment;
  attempt.onset_ns = trial * kTrial_ns;
  attempt.offset_ns = attempt.onset_ns + kTrial_ns / 2;
  attempt.presentations = std::move(made.surfaces);
  attempt.responses = std::move(made.responses);
  for (ResponseRow& response : attempt.responses) response.time_ns = attempt.offset_ns;
  attempt.servo.emplace();
  attempt.servo->rate_Hz = 1000.0;
  attempt.servo->ticks = 5000;
  attempt.servo->fault = "none";
  for (const PresentationRow& surface : attempt.presentations) {
    for (const char* quantity : {"normal_force_N", "speed_m_per_s", "contact_s"}) {
      ComplianceRow row{};
      row.position = surface.position;
      row.quantity = quantity;
      row.mean = 1.0;
      row.fraction_in_band = 0.9;
      row.passed = true;
      attempt.compliance.push_back(row);
    }
  }
  return attempt;
}

void make_study(const std::filesystem::path& folder, const std::string& kind, int attempts) {
  Study study = Study::create(folder, "large");
  ProtocolRow protocol{};
  protocol.name = "large_" + kind;
  protocol.version = "1.0.0";
  protocol.kind = kind;
  protocol.design = "improved";
  protocol.source = "{\"name\": \"" + protocol.name + "\"}";
  const std::int64_t protocol_id = study.add_protocol(protocol);
  const std::string plan_json = "{\"filler\":\"" + std::string(1200, 'x') + "\"}";
  Random random(7);
  for (int begun = 0; begun < attempts; begun += kTrials) {
    ParticipantRow person{};
    person.label = "p" + std::to_string(10000 + begun / kTrials);
    person.sex = begun / kTrials % 2 == 0 ? "F" : "M";
    study.add_participant(person);
    SessionRow session{};
    session.participant = person.label;
    session.protocol_id = protocol_id;
    session.seed = "42";
    session.generator = "none";
    session.program_version = "1";
    session.program_commit = "none";
    session.program_build = "bench";
    session.instruction_set = "sse2";
    session.os = "none";
    session.device = "simulated";
    session.device_json = "{}";
    session.pacing = "real_time";
    session.scheduling = "none";
    session.rate_Hz = 1000.0;
    session.started_utc = "2001-02-03T04:05:06Z";
    std::vector<PlannedTrialRow> plan{};
    for (int trial = 1; trial <= std::min(kTrials, attempts - begun); ++trial) {
      PlannedTrialRow& row = plan.emplace_back();
      row.trial = trial;
      row.block = "main";
      row.block_ordinal = 1;
      row.phase = "main";
      row.factors_json = "{\"column\":" + std::to_string(trial % 3 + 1) + ",\"texture\":\"" +
                         kTextures[static_cast<std::size_t>(trial) % kTextures.size()] + "\"}";
      row.plan_json = plan_json;
    }
    const std::int64_t id = study.add_session(session, plan);
    const int segment = study.begin_segment(id, 0);
    for (const PlannedTrialRow& row : plan) {
      const std::string& texture =
          kTextures[static_cast<std::size_t>(row.trial) % kTextures.size()];
      study.add_attempt(id, attempt_of(trial_of(kind, texture, random), row.trial, segment));
    }
    study.end_session(id, SessionState::completed, "2001-02-03T05:05:06Z");
    std::cerr << "\r" << begun + static_cast<int>(plan.size()) << " attempts" << std::flush;
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
  const Study study = Study::open(folder, Access::read_only);
  time("session_overviews", [&] { (void)session_overviews(study, {}); });
  time("participant_overviews", [&] { (void)participant_overviews(study); });
  time("protocol_overviews", [&] { (void)protocol_overviews(study, built_in_models(), {}); });
  time("analyze_study", [&] { (void)analyze_study(study); });
  if (!json) return;
  const nlohmann::ordered_json document{{"machine", std::thread::hardware_concurrency()},
                                        {"commit", ASPERITY_COMMIT},
                                        {"isa", "none"},
                                        {"cases", cases}};
  std::cout << document.dump(2) << '\n';
}

int run(const std::vector<std::string>& arguments) {
  std::filesystem::path make{};
  std::filesystem::path study{};
  std::string kind = "selection";
  int attempts = 1'000'000;
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
    if (arguments[i - 1] == "--kind") kind = value;
    if (arguments[i - 1] == "--attempts") attempts = std::stoi(value);
  }
  if (!make.empty()) {
    make_study(make, kind, attempts);
    return 0;
  }
  if (!study.empty()) {
    measure(study, json);
    return 0;
  }
  std::cerr << "bench_large_study --make DIR [--kind selection|matching|recognition] "
               "[--attempts N]\nbench_large_study --study DIR [--json]\n";
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
