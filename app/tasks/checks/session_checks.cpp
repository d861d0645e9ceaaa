// Runs the checks in their order; an error of one becomes a result that prevents the session.

#include "app/tasks/checks/session_checks.h"

#include <exception>
#include <filesystem>
#include <optional>
#include <string>

#include "app/tasks/checks/calibration_checks.h"
#include "app/tasks/checks/device_check.h"
#include "app/tasks/checks/disk_check.h"
#include "app/tasks/checks/noise_check.h"
#include "app/tasks/checks/participant_check.h"
#include "app/tasks/checks/protocol_check.h"
#include "app/tasks/checks/screens_check.h"
#include "app/tasks/checks/servo_loop_checks.h"
#include "app/tasks/checks/stimuli_check.h"
#include "app/tasks/checks/study_check.h"
#include "app/tasks/protocol_files.h"

namespace asperity {
namespace {

using State = SessionCheck::State;

/// All problems of a protocol or its translation, with the file and line of each.
Phrase problems_of(const ProtocolError& error) {
  Phrase text{};
  for (const Diagnostic& problem : error.diagnostics()) {
    const Phrase line = phrase("SessionChecks", "%1, line %2: %3")
                            .with(std::filesystem::path(problem.file).filename().string(),
                                  std::to_string(problem.line), problem.message)
                            .as_sentence();
    text = text.empty() ? line : Phrase("%1 %2").with(text, line);
  }
  return text;
}

/// The result of a check with its id and title; an exception becomes a result with the state `stop`.
template <class Check>
SessionCheck checked(const std::string& id, const Phrase& title, Check run) {
  SessionCheck check{};
  const auto stopped_by = [](const Phrase& text) {
    return SessionCheck{.state = State::stop,
                        .text = text,
                        .remedy = phrase("SessionChecks", "Fix the problem, then check again.")};
  };
  try {
    check = run();
  } catch (const ProtocolError& error) {
    check = stopped_by(problems_of(error));
  } catch (const std::exception& error) {
    check = stopped_by(phrase_of(error).as_sentence());
  }
  check.id = id;
  check.title = title;
  return check;
}

}  // namespace

std::vector<SessionCheck> check_session(const CheckInputs& inputs, const ModelRegistry& models,
                                        const std::stop_token& stop,
                                        const std::function<void(double)>& progress,
                                        const DriverRegistry& drivers) {
  std::vector<SessionCheck> checks{};
  std::optional<Protocol> protocol{};
  checks.push_back(checked("protocol", phrase("SessionChecks", "Protocol"), [&] {
    protocol = load_protocol(inputs.protocol, models, inputs.study);
    return protocol_check(inputs, *protocol);
  }));
  if (!protocol) return checks;
  const auto add = [&](const std::string& id, const Phrase& title, auto run) {
    if (!stop.stop_requested()) checks.push_back(checked(id, title, run));
  };
  std::optional<SessionCheck> warned{};
  try {
    warned = protocol_warnings_check(inputs, *protocol, models);
  } catch (const std::exception&) {
    // A study that cannot be read is reported by its own line.
  }
  if (warned) {
    add("protocol_warnings", phrase("SessionChecks", "Warnings"), [&] { return *warned; });
  }
  add("participant", phrase("SessionChecks", "Participant"),
      [&] { return participant_check(inputs, *protocol); });
  add("study", phrase("SessionChecks", "Study folder"), [&] { return study_check(inputs); });
  add("disk", phrase("SessionChecks", "Disk space"), [&] { return disk_check(inputs, *protocol); });
  add("stimuli", phrase("SessionChecks", "Stimuli"),
      [&] { return stimuli_check(inputs, *protocol, models); });
  add("device", phrase("SessionChecks", "Device"), [&] { return device_check(inputs, *protocol); });
  std::vector<SessionCheck> beyond{};
  add("calibration", phrase("SessionChecks", "Calibration"), [&] {
    std::vector<SessionCheck> lines = calibration_checks(inputs, *protocol, models, stop, progress);
    beyond.assign(lines.begin() + 1, lines.end());
    return lines.front();
  });
  checks.insert(checks.end(), beyond.begin(), beyond.end());
  std::optional<SessionCheck> rate{};  // from the same run of the loop
  if (can_be_tried(inputs)) {
    add("force_zero", phrase("SessionChecks", "Force zero"), [&] {
      auto [zero, its_rate] = loop_checks(inputs, *protocol, drivers);
      rate = its_rate;
      return zero;
    });
  }
  if (rate) add("rate", phrase("SessionChecks", "Rate"), [&] { return *rate; });
  add("screens", phrase("SessionChecks", "Screens"), [&] { return screens_check(inputs); });
  add("masking_noise", phrase("SessionChecks", "Masking noise"),
      [&] { return noise_check(inputs, *protocol); });
  return checks;
}

}  // namespace asperity
