// Fills a monitor from the course of a library protocol with a fixed seed and made-up ticks.

#include "tests/gui/session/filled_monitor.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <QtTest/QTest>

#include "app/gui/participant/participant_view.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/plan/course.h"
#include "renderers/built_in_models.h"
#include "renderers/force/force_model.h"
#include "tests/gui/participant/scenes.h"
#include "tests/gui/support/widgets.h"

namespace asperity {

namespace {

constexpr std::int64_t kBegan_ns = 3'600'000'000'000;
const std::filesystem::path kStudy = "/data/rough-surfaces";
constexpr std::int64_t kSessionSecond_ns = 1'000'000'000;

Protocol read_from_library(const std::string& name) {
  std::vector<ModelDeclaration> models{};
  const ModelRegistry registry = built_in_models();
  for (const ForceModel& model : registry.models()) models.push_back(model.declaration);
  for (const LibraryProtocol& each : library_protocols()) {
    if (each.name == name) return read_protocol(each.text, name + ".json", models);
  }
  throw std::invalid_argument("no protocol of the library is called " + name);
}

}  // namespace

FilledMonitor::FilledMonitor(const std::string& name, SessionMode mode)
    : protocol(std::make_shared<const Protocol>(read_from_library(name))),
      plan(std::make_shared<const Plan>(
          make_plan(*protocol, {.seed = 20260318, .counterbalance_row = 0}))) {
  SessionFacts facts{};
  facts.protocol = protocol;
  facts.plan = plan;
  facts.row.participant = "P013";
  facts.row.session = 13;
  facts.row.mode = mode;
  facts.row.seed = "20260318";
  facts.row.device = "delta.3";
  facts.row.pacing = "stepped";
  facts.row.rate_Hz = 1000.0;
  facts.study_folder = "/data/rough-surfaces";
  monitor.set_facts(facts);
  monitor.update([this](SessionSnapshot& s) {
    s.began_ns = kBegan_ns;
    s.now_ns = kBegan_ns + 1122 * kSessionSecond_ns;
    s.trials = static_cast<int>(plan->trials.size());
    s.blocks = plan->trials.back().block_ordinal;
    s.expected_left_s = 1390.0;
    s.health = {.rate_Hz = 999.8, .lateness_p99_s = 31e-6};
    s.masking = MaskingState::on;
  });
}

void FilledMonitor::answer_up_to(int done) {
  int attempts = 0;
  for (int trial = 1; trial <= done; ++trial) {
    const Trial& asked = plan->trials[static_cast<std::size_t>(trial - 1)];
    AttemptSummary attempt{};
    attempt.trial = trial;
    attempt.attempt = 1;
    attempt.duration_s = 9.0;
    if (trial % 7 == 3) {
      attempt.outcome = AttemptOutcome::not_compliant;
      attempt.valid = false;
      attempt.reason = "surface \"" + asked.presentations.front().stimulus.texture +
                       "\" was pressed with too little force (34 % in band)";
      monitor.add_attempt(attempt);
      ++attempts;
      attempt.reason = {};
      attempt.attempt = 2;
      attempt.valid = true;
    }
    attempt.outcome = trial % 11 == 6 ? AttemptOutcome::skipped : AttemptOutcome::answered;
    if (attempt.outcome == AttemptOutcome::answered) {
      attempt.answers = {std::to_string(1 + trial * 5 % 6)};
      if (!asked.questions.front().correct.empty()) attempt.correct = trial % 3 != 0;
      attempt.from_cue_s = 2.0 + 0.37 * (trial % 6);
      attempt.from_contact_s = *attempt.from_cue_s + 6.0;
    }
    attempt.flagged = trial % 9 == 4;
    if (attempt.flagged) attempt.reason = "too fast: 41 % in band";
    monitor.add_attempt(attempt);
    ++attempts;
  }
  monitor.update([&](SessionSnapshot& s) {
    const bool over = done >= s.trials;
    s.trials_done = done;
    s.trial = over ? 0 : done + 1;
    s.attempt = over ? 0 : 1;
    s.last_done = done;
    s.block = plan->trials[static_cast<std::size_t>(over ? done - 1 : done)].block_ordinal;
    s.rows_stored = attempts;
  });
}

void FilledMonitor::answer_tracks(int answers, std::optional<double> threshold) {
  Course course(*protocol, {.seed = 20260318, .counterbalance_row = 0});
  for (int i = 0; i < answers && course.awaited() != nullptr; ++i) {
    const Trial& trial = *course.awaited();
    const Protocol::Block& block = protocol->blocks.at(trial.block);
    const double value = std::get<double>(trial.factors.at(block.vary->factor));
    const double level = block.vary->level_of(value);
    const bool counts_down = threshold ? level > *threshold || i % 3 == 0 : i % 3 != 2;
    AttemptSummary attempt{};
    attempt.trial = trial.ordinal;
    attempt.attempt = 1;
    attempt.from_cue_s = 2.0 + 0.37 * (i % 6);
    if (!trial.questions.front().correct.empty()) attempt.correct = counts_down;
    for (const PlannedPresentation& surface : trial.presentations) {
      if ((surface.role == block.vary->role) == counts_down) attempt.answers = {surface.code};
    }
    if (trial.catch_trial) {
      monitor.add_attempt(attempt);
      course.advance({});
      continue;
    }
    const LevelOutcome outcome = forced_outcome(counts_down);
    attempt.answer_of_track = LevelAnswer{.level = level, .outcome = outcome};
    monitor.add_attempt(attempt);
    course.advance({.answer = TrialOutcome::Answer{.value = value, .outcome = outcome}});
  }
  SessionFacts facts = *monitor.facts();
  plan = std::make_shared<const Plan>(course.plan());
  facts.plan = plan;
  monitor.set_facts(facts);
  monitor.update([this](SessionSnapshot& s) {
    s.trial = plan->trials.back().ordinal;
    s.attempt = 1;
    s.block = plan->trials.back().block_ordinal;
    s.trials_done = s.last_done = s.trial - 1;
    s.rows_stored = s.trials_done;
    s.trials = static_cast<int>(example_plan(*protocol, {.seed = 1}).trials.size());
    s.trials_are_estimated = true;
  });
}

void FilledMonitor::set_phase(SessionPhase phase) {
  if (phase == SessionPhase::contact) {
    ParticipantScene scene = scenes::feel(1);
    scene.block = monitor.snapshot().block;
    scene.blocks = monitor.snapshot().blocks;
    monitor.show(scene);
  }
  monitor.update([phase](SessionSnapshot& s) {
    s.phase = phase;
    s.phase_began_ns = s.now_ns - 6'200'000'000;
    s.surface = phase == SessionPhase::contact ? 1 : 0;
    s.contact_s = phase == SessionPhase::contact ? 6.2 : 0.0;
  });
}

void FilledMonitor::open_response(bool open) {
  ParticipantScene scene{};
  scene.kind = open ? ParticipantScene::Kind::question : ParticipantScene::Kind::blank;
  scene.response_open = open;
  monitor.show(scene);
  set_phase(open ? SessionPhase::response : SessionPhase::iti);
}

void FilledMonitor::stroke(double duration_s) {
  const double end_s = stroked_s_ + duration_s;
  for (; stroked_s_ < end_s; stroked_s_ += SessionMonitor::kBin_s) {
    const double t = stroked_s_;
    const double turn = 2.0 * std::numbers::pi * 0.45 * t;
    LiveBin bin{};
    bin.time_ns = kBegan_ns + static_cast<std::int64_t>(1e9 * t);
    bin.touching = std::fmod(t, 7.0) > 0.8;
    const double pressing =
        bin.touching ? 1.1 + 0.35 * std::sin(0.9 * t) + 0.1 * std::sin(3.1 * t) : 0.0;
    const double ripple = bin.touching ? 0.18 + 0.1 * std::abs(std::sin(turn)) : 0.0;
    bin.is_felt = bin.touching;
    bin.pressing_N = pressing;
    if (bin.touching) bin.stroking_m_per_s = 0.054;  // 30 mm to either side, 0.45 times a second
    bin.force_minimum_N = static_cast<float>(pressing - ripple);
    bin.force_maximum_N = static_cast<float>(pressing + ripple);
    const double speed = 0.030 * 2.0 * std::numbers::pi * 0.45 * std::abs(std::cos(turn));
    bin.speed_minimum_m_per_s = static_cast<float>(0.9 * speed);
    bin.speed_maximum_m_per_s = static_cast<float>(1.08 * speed + 0.002);
    bin.x_m = static_cast<float>(0.030 * std::sin(turn));
    bin.y_m = static_cast<float>(0.006 * std::sin(0.31 * turn) + 0.002 * std::cos(2.1 * turn));
    bin.z_m = bin.touching ? -0.001F : 0.004F;
    bin.surface = bin.touching ? 1 : 0;
    monitor.add_bin(bin);
  }
  monitor.update([](SessionSnapshot& s) {
    s.hand = {.surface = 1,
              .force_N = {.samples = 5400, .fraction_in_band = 1.0},
              .speed_m_per_s = {.samples = 5400, .fraction_in_band = 0.91}};
  });
}

std::unique_ptr<SessionWindow> FilledMonitor::window() {
  auto window = std::make_unique<SessionWindow>(monitor, requests, kStudy);
  window->set_mirror(
      new ParticipantView(monitor, kStudy, ParticipantView::Role::mirror, window.get()));
  window->resize(1366, 768);
  window->show();
  window->activateWindow();
  if (!QTest::qWaitForWindowActive(window.get(), kPatience_ms))
    throw std::runtime_error("no active window");
  window->refresh();
  return window;
}

}  // namespace asperity
