// Runs sessions with and without windows, requests their end in time, and reads the stored servo times.

#include "tests/gui/long_window/long_session.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <future>
#include <optional>
#include <stop_token>
#include <utility>

#include <QtCore/QEventLoop>
#include <QtCore/QTimer>
#include <QtTest/QTest>
#include <nlohmann/json.hpp>

#include "analysis/numbers/summary.h"
#include "app/gui/participant/participant_view.h"
#include "app/gui/session/session_runner.h"
#include "app/gui/session/session_window.h"
#include "app/gui/window/session_desk.h"
#include "app/gui/window/study_window.h"
#include "app/session/rig/recording_columns.h"
#include "app/tasks/new_study.h"
#include "app/tasks/run_session.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"
#include "tests/support/patient_servo.h"

namespace asperity {

namespace {

using SteadyTime = std::chrono::steady_clock::time_point;

// Reading the stimuli, the trial under way, closing the store, all on a slow machine.
constexpr double kPatience_s = 180.0;
constexpr int kLook_ms = 100;
// No trial of three surfaces is shorter, so that the plan outlasts the session.
constexpr double kShortestTrial_s = 3.0;

double seconds_since(SteadyTime then) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
}

double load_of_the_last_minute() {
  double load = 0.0;
  return getloadavg(&load, 1) == 1 ? load : std::nan("");
}

RunInputs inputs_of(const std::filesystem::path& study, const std::string& participant) {
  RunInputs inputs{};
  inputs.protocol = study / "protocols" / "long.json";
  inputs.study = study;
  inputs.participant = participant;
  inputs.seed = 1;
  inputs.mode = SessionMode::simulate;
  inputs.is_virtual = true;
  inputs.pacing = RunPacing::real_time;
  inputs.servo = patient_servo();
  return inputs;
}

ServoTimes servo_times_of(const std::filesystem::path& study_folder,
                          const std::string& participant) {
  const Study study = Study::open(study_folder, Access::read_only);
  ServoTimes times{};
  std::vector<double> lateness_s{};
  for (const SessionRow& session : study.sessions()) {
    if (session.participant != participant) continue;
    times.scheduling = session.scheduling;
    const std::vector<AttemptRow> attempts = study.attempts(session.id);
    for (const AttemptRow& attempt : attempts) {
      if (!attempt.servo || !attempt.recording) continue;  // cut off before its first tick
      ++times.attempts;
      times.missed_deadlines += attempt.servo->missed_deadlines;
      times.lost_records += attempt.servo->lost_records;
      const Recording recording = read_recording(study_folder / attempt.recording->path);
      for (const TickRecord& tick : records_of(recording)) {
        lateness_s.push_back(static_cast<double>(tick.lateness_ns) * 1e-9);
      }
    }
    if (attempts.empty()) continue;
    times.span_s =
        static_cast<double>(attempts.back().offset_ns - attempts.front().onset_ns) * 1e-9;
  }
  times.ticks = lateness_s.size();
  if (lateness_s.empty()) return times;
  std::sort(lateness_s.begin(), lateness_s.end());
  times.lateness_p50_s = quantile(lateness_s, 0.5);
  times.lateness_p99_s = quantile(lateness_s, 0.99);
  times.lateness_maximum_s = lateness_s.back();
  return times;
}

/// Why a session ended otherwise than by being asked to after its time.
std::string trouble_of(const SessionEnd& end, bool was_asked) {
  if (was_asked && end.state == SessionState::stopped) return {};
  return end.reason.empty() ? "the plan was done before the time was over"
                            : "the session ended early: " + end.reason.english();
}

}  // namespace

std::filesystem::path make_long_study(const std::filesystem::path& folder, double duration_s) {
  new_demo_study(folder, [](double) {});
  auto protocol =
      nlohmann::ordered_json::parse(read_file(folder / "protocols" / "chapter_selection.json"));
  protocol["name"] = "long";
  // All that can be drawn is drawn: the relief and the probe, in the mirror.
  protocol["environment"]["scene"] = {{"visual_texture", "on"}};
  auto& block = protocol["blocks"]["main"];
  const auto trials = static_cast<double>(block["listed"].size());
  block["repetitions"] = 1 + static_cast<int>(std::ceil(duration_s / (trials * kShortestTrial_s)));
  protocol["flow"] = nlohmann::ordered_json::parse(R"([{"run": "main"}])");
  write_file(folder / "protocols" / "long.json", protocol.dump(2), Overwrite::refuse);
  return folder;
}

LongSession run_with_windows(const std::filesystem::path& study, const std::string& participant,
                             double duration_s) {
  LongSession session{};
  session.load = load_of_the_last_minute();
  StudyWindow study_window{};
  SessionDesk desk(study_window, nullptr);
  study_window.open_study(study);
  study_window.show();
  SessionOrder order{};
  order.inputs = inputs_of(study, participant);
  desk.begin(order);

  SessionRunner& runner = *desk.runner();
  SessionWindow& window = *desk.session_window();
  const FrameTimes frames(window, *window.findChild<ParticipantView*>());
  // An event loop of its own: what waits by looking now and then would keep frames waiting too.
  QEventLoop loop{};
  bool asked = false;
  bool gave_up = false;
  QObject::connect(&runner, &SessionRunner::ended, &loop, [&](const SessionEnd& end) {
    if (session.trouble.empty()) session.trouble = trouble_of(end, asked);
    loop.quit();
  });
  QObject::connect(&runner, &SessionRunner::failed, &loop, [&](const QString& what) {
    session.trouble = what.toStdString();
    loop.quit();
  });
  const SteadyTime started = std::chrono::steady_clock::now();
  std::optional<SteadyTime> began{};
  QTimer look{};
  QObject::connect(&look, &QTimer::timeout, &loop, [&] {
    const SessionSnapshot snapshot = runner.monitor().snapshot();
    if (!began && runner.monitor().facts() != nullptr && snapshot.trial > 0)
      began = std::chrono::steady_clock::now();
    if (began && !asked && seconds_since(*began) >= duration_s) {
      asked = true;
      runner.requests().stop_after(StopAfter::trial);
    }
    if (gave_up) return;
    if (snapshot.fault != Fault::none) {
      session.trouble = std::string("the force was stopped: ") + name_of(snapshot.fault);
    } else if (seconds_since(started) > duration_s + kPatience_s) {
      session.trouble = "the session did not end when it was asked to";
    }
    if (session.trouble.empty()) return;
    gave_up = true;
    runner.requests().abort(session.trouble);
  });
  look.start(kLook_ms);
  loop.exec();
  look.stop();
  session.window = frames.window();
  session.mirror = frames.mirror();
  window.close();
  if (!QTest::qWaitFor([&desk] { return desk.session_window() == nullptr; })) {
    session.trouble += "the session window did not close";
  }
  session.servo = servo_times_of(study, participant);
  return session;
}

LongSession run_headless(const std::filesystem::path& study, const std::string& participant,
                         double duration_s) {
  LongSession session{};
  session.load = load_of_the_last_minute();
  std::stop_source stop{};
  std::optional<SteadyTime> first_done{};
  bool asked = false;
  const auto done = [&](const AttemptDone&) {  // on the session's thread
    if (!first_done) first_done = std::chrono::steady_clock::now();
    if (seconds_since(*first_done) < duration_s) return;
    asked = true;
    stop.request_stop();
  };
  auto running = std::async(std::launch::async, [&] {
    return run_session(inputs_of(study, participant), built_in_models(), nullptr, stop.get_token(),
                       done);
  });
  if (running.wait_for(std::chrono::duration<double>(duration_s + kPatience_s)) ==
      std::future_status::timeout) {
    session.trouble = "the session did not end when it was asked to";
    stop.request_stop();
  }
  try {
    const SessionEnd end = running.get();
    if (session.trouble.empty()) session.trouble = trouble_of(end, asked);
  } catch (const std::exception& error) {
    session.trouble = error.what();
  }
  session.servo = servo_times_of(study, participant);
  return session;
}

}  // namespace asperity
