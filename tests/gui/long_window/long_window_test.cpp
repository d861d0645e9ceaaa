// What the windows cost a session in real time: no record, no punctuality, and few milliseconds of
// the screen's own time. Means something only where nothing else runs.

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <mutex>
#include <thread>

#include <QtCore/QString>
#include <QtGui/QGuiApplication>
#include <QtGui/QScreen>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/numbers/summary.h"
#include "app/study_files/program.h"
#include "tests/gui/long_window/long_session.h"
#include "tests/gui/study/quiet_home.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMostFrame_s = 0.020;
constexpr double kMostRatio = 1.5;
constexpr double kUnnoticed_s = 100e-6;  // below this, a ratio is one of two noises

/// Seconds, or a number, from the environment.
double setting(const char* name, double usual) {
  const QByteArray text = qgetenv(name);
  if (text.isEmpty()) return usual;
  bool is_number = false;
  const double value = text.toDouble(&is_number);
  if (!is_number || value < 0.0) {
    throw std::runtime_error(std::string(name) + " is \"" + text.toStdString() +
                             "\"; a number from 0 on would be right");
  }
  return value;
}

/// Ends the program where it hangs for good: nobody watches for an hour.
class Watchdog final {
 public:
  explicit Watchdog(double patience_s)
      : thread_([this, patience_s] {
          std::unique_lock lock(mutex_);
          if (over_.wait_for(lock, std::chrono::duration<double>(patience_s),
                             [this] { return is_over_; })) {
            return;
          }
          std::fputs("The measurement hangs and is ended here.\n", stderr);
          std::_Exit(1);
        }) {}
  ~Watchdog() {
    {
      const std::lock_guard lock(mutex_);
      is_over_ = true;
    }
    over_.notify_all();
    thread_.join();
  }
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

 private:
  std::mutex mutex_{};
  std::condition_variable over_{};
  bool is_over_ = false;
  std::thread thread_;
};

double quantile_of(std::vector<double> samples, double p) {
  if (samples.empty()) return 0.0;
  std::sort(samples.begin(), samples.end());
  return quantile(samples, p);
}

Json quantiles_of(const std::vector<double>& samples) {
  return {{"p50_s", quantile_of(samples, 0.5)},
          {"p95_s", quantile_of(samples, 0.95)},
          {"p99_s", quantile_of(samples, 0.99)},
          {"maximum_s", quantile_of(samples, 1.0)}};
}

Json json_of(const LongSession& session) {
  const ServoTimes& servo = session.servo;
  Json json{{"windows", !session.window.frame_s.empty()},
            {"load_average", session.load},
            {"scheduling", servo.scheduling},
            {"span_s", servo.span_s},
            {"attempts", servo.attempts},
            {"ticks", servo.ticks},
            {"lateness_p50_s", servo.lateness_p50_s},
            {"lateness_p99_s", servo.lateness_p99_s},
            {"lateness_maximum_s", servo.lateness_maximum_s},
            {"missed_deadlines", servo.missed_deadlines},
            {"lost_records", servo.lost_records}};
  if (!session.window.frame_s.empty()) {
    json["frames"] = {{"session_window", session.window.frame_s.size()},
                      {"mirror", session.mirror.frame_s.size()}};
    json["frame_of_session_window"] = quantiles_of(session.window.frame_s);
    json["frame_of_mirror"] = quantiles_of(session.mirror.frame_s);
    json["interval_of_session_window"] = quantiles_of(session.window.interval_s);
  }
  if (!session.trouble.empty()) json["trouble"] = session.trouble;
  return json;
}

Json document(const char* what) {
  const ProgramIdentity program = this_program();
  const QSize screen = QGuiApplication::primaryScreen()->size();
  return {{"format", "asperity.bench/1"},
          {"measured", what},
          {"machine", program.os},
          {"processors", std::thread::hardware_concurrency()},
          {"commit", program.commit},
          {"build", program.build},
          {"platform", QGuiApplication::platformName().toStdString()},
          {"screen_px", {screen.width(), screen.height()}}};
}

class LongWindow : public QuietHome {};

TEST_F(LongWindow, LosesNoRecordAndDrawsEveryFrameInTime) {
  const double duration_s = setting("ASPERITY_WINDOW_SESSION_S", 600.0);
  if (duration_s == 0.0) GTEST_SKIP() << "ASPERITY_WINDOW_SESSION_S is 0";
  const Watchdog watchdog(2.0 * duration_s + 600.0);
  const std::filesystem::path study = make_long_study(home() / "study", duration_s);
  const LongSession session = run_with_windows(study, "virtual0001", duration_s);

  Json report = document("a session with its windows");
  report["session"] = json_of(session);
  std::cout << report.dump(2) << std::endl;
  EXPECT_EQ(session.trouble, "");
  EXPECT_GE(session.servo.span_s, duration_s);
  EXPECT_EQ(session.servo.lost_records, 0);
  // The plots moved all the time, at a rate that the eye takes for motion.
  EXPECT_GE(static_cast<double>(session.window.frame_s.size()), 30.0 * duration_s);
  EXPECT_GT(session.mirror.frame_s.size(), 0U);
  EXPECT_LT(quantile_of(session.window.frame_s, 0.95), kMostFrame_s);
  EXPECT_LT(quantile_of(session.mirror.frame_s, 0.95), kMostFrame_s);
  EXPECT_LT(quantile_of(session.window.interval_s, 0.95), kMostFrame_s);
}

TEST_F(LongWindow, LeavesTheServoAsPunctualAsWithoutWindows) {
  const double leg_s = setting("ASPERITY_WINDOW_LEG_S", 120.0);
  const int pairs = static_cast<int>(setting("ASPERITY_WINDOW_PAIRS", 5.0));
  if (pairs == 0) GTEST_SKIP() << "ASPERITY_WINDOW_PAIRS is 0";
  const Watchdog watchdog(2.0 * pairs * (2.0 * leg_s + 300.0));
  const std::filesystem::path study = make_long_study(home() / "study", leg_s);
  Json report = document("pairs of sessions with and without windows");
  std::vector<double> with_s{};
  std::vector<double> without_s{};
  int number = 0;
  const auto measure = [&](bool windows) {
    const std::string participant =
        QString("virtual%1").arg(++number, 4, 10, QChar('0')).toStdString();
    const LongSession session = windows ? run_with_windows(study, participant, leg_s)
                                        : run_headless(study, participant, leg_s);
    report["legs"].push_back(json_of(session));
    EXPECT_EQ(session.trouble, "") << "leg " << number;
    EXPECT_EQ(session.servo.lost_records, 0) << "leg " << number;
    (windows ? with_s : without_s).push_back(session.servo.lateness_p99_s);
  };
  for (int pair = 0; pair < pairs; ++pair) {
    // What drifts with time weighs on both alike when each is as often the first.
    const bool window_first = pair % 2 == 0;
    measure(window_first);
    measure(!window_first);
  }
  const double with_windows_s = quantile_of(with_s, 0.5);
  const double headless_s = quantile_of(without_s, 0.5);
  const double ratio = with_windows_s / headless_s;
  report["median_lateness_p99_s"] = {{"window", with_windows_s}, {"headless", headless_s}};
  report["ratio"] = ratio;
  std::cout << report.dump(2) << std::endl;
  // A window that keeps the processor awake may even help: only what it costs counts.
  EXPECT_TRUE(ratio <= kMostRatio || std::max(with_windows_s, headless_s) < kUnnoticed_s)
      << "median p99 lateness with windows " << 1e6 * with_windows_s << " µs, without "
      << 1e6 * headless_s << " µs, ratio " << ratio;
}

}  // namespace
}  // namespace asperity
