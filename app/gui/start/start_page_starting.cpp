// Whether a session can start, and starting it.

#include <algorithm>

#include <QtCore/QTimer>
#include <QtGui/QGuiApplication>
#include <QtWidgets/QSpinBox>

#include "app/gui/base/command_lines.h"
#include "app/gui/base/settings.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/sound/noise_check.h"
#include "app/gui/sound/sound_output.h"
#include "app/gui/start/check_list.h"
#include "app/gui/start/consent_card.h"
#include "app/gui/start/device_chooser.h"
#include "app/gui/start/group_chooser.h"
#include "app/gui/start/participant_card.h"
#include "app/gui/start/program_chooser.h"
#include "app/gui/start/setup_card.h"
#include "app/gui/start/start_page.h"
#include "app/profiles/device_kind.h"
#include "app/tasks/checks/protocol_check.h"
#include "app/tasks/checks/session_checks.h"
#include "renderers/built_in_models.h"

namespace asperity {

MaskingNoise StartPage::noise() const {
  return noise_ != nullptr && !is_virtual() ? noise_->value() : MaskingNoise{};
}

std::vector<QString> StartPage::reasons() const {
  if (read_task_.is_running()) return {tr("The study is being read.")};
  if (!is_read_) return {tr("The study has not been read; press “Try again”.")};
  if (chosen() == nullptr) {
    return {facts_.chosen.is_read()
                ? tr("The protocol is not valid; correct it, or choose another one.")
                : tr("No protocol is chosen; choose one.")};
  }
  std::vector<QString> reasons = participant_->complaints();
  if (const auto before = language_before(); !resume_ && before && *before != chosen()->language) {
    reasons.push_back(tr("The earlier sessions of this participant were in the language “%1”: add "
                         "this translation of the protocol, or choose another participant.")
                          .arg(QString::fromStdString(*before)));
  }
  if (needs_consent()) {
    for (QString& complaint : consent_->complaints()) reasons.push_back(std::move(complaint));
  }
  if (QString complaint = program_->complaint(); !complaint.isEmpty()) {
    reasons.push_back(std::move(complaint));
  }
  if (const QString waits_for = setup_->device().waits_for(); !waits_for.isEmpty()) {
    reasons.push_back(waits_for);
    return reasons;
  }
  if (!checks_) {
    reasons.push_back(check_cancelled_ ? tr("The checks were cancelled: press “Check again”.")
                                       : tr("Running the checks…"));
    return reasons;
  }
  for (const SessionCheck& check : *checks_) {
    if (check.state != SessionCheck::State::stop) continue;
    // Said above already, in the words of the form.
    if (check.id == "participant" && !participant_->complaints().empty()) continue;
    reasons.push_back(tr("%1: %2").arg(words_of(check.title), words_of(check.text)));
  }
  return reasons;
}

/// Nothing is examined while the checks run, which time the servo loop.
void StartPage::forget_checks() {
  checks_.reset();
  study_.examiner().withdraw(this);
  check_list_->set_note({});
}

void StartPage::examine_stimuli() {
  if (chosen() == nullptr || setup_->device().is_trying()) return;
  check_list_->set_note(tr("The stimuli are being examined; the session does not wait for this."));
  study_.examiner().request(
      this, {facts_.chosen.protocol},
      [this](const Protocol& protocol, const StimulusExaminer::Result& result) {
        check_list_->set_note({});
        std::vector<SessionCheck> checks = *checks_;
        if (auto warned = stimulus_warnings_check(result->warnings)) {
          checks.push_back(std::move(*warned));
        }
        check_list_->set_checks(checks, protocol.source);
      });
}

void StartPage::check_soon() {
  forget_checks();
  check_cancelled_ = false;
  show_start();
  if (isVisible() && is_read_) check_timer_->start();
}

void StartPage::check() {
  check_timer_->stop();
  forget_checks();
  if (facts_.chosen.file.empty() || !is_read_ || !isVisible()) return;
  if (check_task_.is_running()) {
    // The loop that it tries runs for a while yet: nobody waits for it here.
    check_task_.cancel();
    check_outdated_ = true;
    return;
  }
  const CheckInputs inputs{
      .study = study_.folder(),
      .protocol = facts_.chosen.file,
      .protocol_sha256 = facts_.chosen.sha256,
      .participant = participant_->label(),
      .mode = mode_,
      .resume = resume_,
      .resumed_session = resumed_session(),
      .late_reason = participant_->late_reason(),
      .pacing = order().inputs.pacing,
      .device = setup_->device().device(),
      .device_name = setup_->device().name().toStdString(),
      .driver_options = driver_options(setup_->device().device()),
      .device_blocker = setup_->device().blocker(),
      .trial = study_.device_trial(),
      .tried = setup_->device().tried(),
      .rehearsal = rehearsal_,
      .noise = noise(),
      .sound_card = !sound_outputs().empty(),
      .screens = static_cast<int>(QGuiApplication::screens().size()),
  };
  check_cancelled_ = false;
  check_list_->set_running(true);
  check_task_.run<std::vector<SessionCheck>>(
      [inputs, models = study_.models(), drivers = study_.drivers()](
          const std::stop_token& stop, const BackgroundTask::Progress& progress) {
        return check_session(inputs, models, stop, progress, drivers);
      },
      [this](std::vector<SessionCheck> checks) {
        // Something else is chosen by now, or being read: then it is looked at once more.
        if (check_outdated_ || check_timer_->isActive() || !is_read_ || !isVisible()) return;
        if (check_cancelled_) {
          check_list_->set_cancelled();
          return show_start();
        }
        check_list_->set_running(false);
        check_list_->set_checks(checks, chosen() == nullptr ? std::string{} : chosen()->source);
        checks_ = std::move(checks);
        show_start();
        examine_stimuli();
      },
      [this](const QString& what) {
        check_list_->set_running(false);
        banner_->show_news(State::stop, what);
      });
  show_start();
}

SessionOrder StartPage::order() const {
  SessionOrder order{};
  RunInputs& inputs = order.inputs;
  inputs.protocol = facts_.chosen.file;
  inputs.study = study_.folder();
  inputs.participant = participant_->label();
  inputs.seed = seed_;
  inputs.mode = mode_;
  inputs.resume = resume_;
  inputs.resumed_session = resumed_session();
  inputs.late_reason = participant_->late_reason();
  inputs.group = participant_->group().group();
  inputs.level_program = program_->program();
  inputs.is_virtual = is_virtual();
  inputs.pacing = is_virtual() && fast_->isChecked() ? RunPacing::stepped : RunPacing::real_time;
  inputs.servo = study_.servo();
  inputs.mirrored = setup_->is_mirrored();
  inputs.device = setup_->device().device();
  inputs.driver_options = driver_options(inputs.device);
  inputs.rehearsal = rehearsal_;
  const Protocol* protocol = chosen();
  if (protocol != nullptr && !is_virtual() && participant_->is_new()) {
    inputs.new_person = participant_->new_person(*protocol);
  }
  if (needs_consent()) {
    if (consent_->is_given()) inputs.consent = facts_.chosen.consent;
    order.consent_seen_by = consent_->seen_by();
  }
  order.noise = noise();
  order.own_keyboard = setup_->own_keyboard();
  order.participant_screen = setup_->participant_screen();
  if (protocol != nullptr) {
    for (const auto& [cue, path] : protocol->speech) order.speech[cue] = study_.folder() / path;
  }
  order.protocol_sha256 = facts_.chosen.sha256;
  return order;
}

void StartPage::press_start() {
  if (!reasons().empty()) return;
  if (is_batch()) {
    emit simulation_wanted(simulation());
    seed_ = new_seed();
    return;
  }
  // What was found holds for one start: the next one looks again.
  const SessionOrder ordered = order();
  seed_ = new_seed();
  setup_->device().forget_try();
  forget_checks();
  show_start();
  emit start_wanted(ordered);
}

SimulationInputs StartPage::simulation() const {
  SimulationInputs inputs{};
  inputs.protocols = {facts_.chosen.file};
  inputs.study = study_.folder();
  inputs.participants = virtual_people_->value();
  inputs.seed = seed_;
  inputs.level_program = program_->program();
  return inputs;
}

std::vector<ShownCommand> StartPage::commands() const {
  ShownCommand command{.action = start_->text()};
  const RunInputs inputs = order().inputs;
  if (is_batch()) {
    command.line = simulate_line(simulation(), plugin_files());
  } else if (inputs.is_virtual) {
    command.line = run_line(inputs, plugin_files());
  } else if (inputs.device.empty() || kind_of_device(inputs.device) == DeviceKind::pointer) {
    command.remark = tr("A terminal has no mouse: choose another device.");
  } else if (inputs.mirrored) {
    command.remark = tr("A terminal does not mirror the workspace for a left hand.");
  } else {
    command.line = run_line(inputs, plugin_files());
    command.remark = tr(
        "The terminal asks for the consent, the details of a new participant and all responses.");
  }
  return {command};
}

}  // namespace asperity
