// Runs the session in a std::jthread, and turns attempts, messages and the end into signals.

#include "app/gui/session/session_runner.h"

#include <cassert>
#include <exception>
#include <utility>

#include <QtCore/QMetaObject>

#include "app/gui/look/words.h"
#include "app/gui/sound/qt_sound.h"
#include "app/tasks/checks/protocol_check.h"
#include "app/tasks/mouse_trial.h"
#include "app/words/reason.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

std::unique_ptr<Sound> usual_sound(const SessionOrder& order) {
  if (order.inputs.is_virtual) return nullptr;
  return std::make_unique<QtSound>(order.noise, order.speech);
}

SessionRunner::SessionRunner(QObject* parent, SoundMaker make_sound, DriverRegistry drivers,
                             ModelRegistry models)
    : QObject(parent),
      make_sound_(std::move(make_sound)),
      drivers_(std::move(drivers)),
      models_(std::move(models)) {
  qRegisterMetaType<asperity::SessionOrder>();
  qRegisterMetaType<asperity::SessionEnd>();
  qRegisterMetaType<asperity::AfterFailure>();
}

SessionRunner::~SessionRunner() {
  if (!worker_.joinable()) return;
  requests_.abort(phrase_of(Reason::window_closed));
  worker_.request_stop();
  worker_.join();
}

PersonAtWindow& SessionRunner::person() noexcept {
  assert(person_);
  return *person_;
}

void SessionRunner::start(const SessionOrder& order) {
  assert(!worker_.joinable());
  order_ = order;
  order_.inputs.driver_options.pointer = &pointer_;
  order_.inputs.driver_options.tell = [this](const std::string& sentence) {
    QMetaObject::invokeMethod(
        this, [this, text = QString::fromStdString(sentence)] { emit told(text); },
        Qt::QueuedConnection);
  };
  order_.inputs.comparing = [this](double fraction) {
    monitor_.update([fraction](SessionSnapshot& snapshot) { snapshot.compared = fraction; });
  };
  running_ = true;
  person_ = std::make_unique<PersonAtWindow>(monitor_, nullptr);
  if (!order.consent_seen_by.empty()) {
    requests_.remark("consent_seen",
                     phrase_of(Reason::agreement_witnessed).with(order.consent_seen_by));
  }
  worker_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void SessionRunner::run(const std::stop_token& stop) {
  const auto tell_end = [this](const SessionEnd& end) {
    QMetaObject::invokeMethod(
        this,
        [this, end] {
          running_ = false;
          emit ended(end);
        },
        Qt::QueuedConnection);
  };
  // As asked, before there was a session: there is nothing to fix.
  const auto tell_not_begun = [this, &tell_end] {
    monitor_.update([](SessionSnapshot& snapshot) { snapshot.phase = SessionPhase::ended; });
    tell_end({.state = SessionState::stopped, .reason = phrase_of(Reason::stopped_as_asked)});
  };
  try {
    // Here and not in a window's thread: a sound server takes its time.
    sound_ = make_sound_(order_);
    person_->set_sound(sound_.get());
    if (!order_.protocol_sha256.empty()) {
      require_unchanged(order_.inputs.protocol, order_.protocol_sha256);
    }
    SessionLinks links{.requests = &requests_,
                       .monitor = &monitor_,
                       .sound = sound_.get(),
                       .experimenter_is_there = true};
    if (order_.mouse_trial != nullptr) links.last_trial = MouseTrial::kLastTrial;
    RunInputs inputs = order_.inputs;
    inputs.ready = [&stop](const Protocol&) {
      if (stop.stop_requested()) throw RespondentGone(phrase_of(Reason::stopped_as_asked));
    };
    Respondent* respondent = order_.inputs.is_virtual ? nullptr : person_.get();
    tell_end(run_session(
        inputs, models_, respondent, stop, [this](const AttemptDone&) { announce_attempt(); },
        links, drivers_));
  } catch (const OpeningStopped&) {
    tell_not_begun();
  } catch (const RespondentGone& error) {
    if (stop.stop_requested()) {
      tell_not_begun();
    } else {
      fail(phrase_of(error), AfterFailure::start_again);
    }
  } catch (const ProtocolChangedSinceCheck& error) {
    fail(phrase_of(error), AfterFailure::check_again);
  } catch (const ProtocolError& error) {
    fail(phrase_of(error), AfterFailure::check_again);
  } catch (const std::exception& error) {
    fail(phrase_of(error), AfterFailure::start_again);
  }
}

void SessionRunner::announce_attempt() {
  ++attempts_;
  if (announced_.exchange(true)) return;
  QMetaObject::invokeMethod(
      this,
      [this] {
        announced_ = false;
        emit attempt_done();
      },
      Qt::QueuedConnection);
}

void SessionRunner::fail(const Phrase& what, AfterFailure unbegun) {
  // Every attempt that was reported is on disk: the conductor tells of none before its commit.
  const bool had_begun = attempts_ > 0 || monitor_.facts() != nullptr;
  QString text = words_of(what.as_sentence());
  if (order_.mouse_trial != nullptr) {
    text += ' ' + tr("Nothing was stored in the study.");
  } else if (had_begun) {
    text += ' ' +
            tr("The force is zero and the session has stopped. Every completed trial is stored (%n "
               "attempt(s) since the session was started or resumed). Fix the cause, then resume "
               "this session on the Sessions page.",
               nullptr, attempts_);
  } else {
    text +=
        ' ' +
        tr("The session did not begin and no trial was run. Fix the cause, then start it again.");
  }
  const std::string language = monitor_.snapshot().scene->language;
  monitor_.show({.kind = ParticipantScene::Kind::ended,
                 .language = language,
                 .text = words_in_language(language, phrase("ParticipantWords",
                                                            "Please wait for the experimenter."))
                             .toStdString()});
  monitor_.update([&text](SessionSnapshot& snapshot) {
    snapshot.phase = SessionPhase::ended;
    snapshot.trouble = SessionTrouble{.what = text.toStdString(),
                                      .time_ns = snapshot.now_ns,
                                      .remedy = SessionTrouble::Remedy::try_again};
  });
  QMetaObject::invokeMethod(
      this,
      [this, text, next = had_begun ? AfterFailure::go_on : unbegun] {
        running_ = false;
        emit failed(text, next);
      },
      Qt::QueuedConnection);
}

}  // namespace asperity

#include "moc_session_runner.cpp"
