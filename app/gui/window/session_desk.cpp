// Creates start page, runner, session window and participant window in turn, and reacts to lost screens.

#include "app/gui/window/session_desk.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QtCore/QTimer>
#include <QtGui/QGuiApplication>
#include <QtGui/QScreen>

#include "app/device_bench/device_choice.h"
#include "app/gui/base/open_study.h"
#include "app/gui/base/settings.h"
#include "app/gui/data/analysis_page.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/participant/live_workspace.h"
#include "app/gui/session/window_place.h"
#include "app/gui/start/start_page.h"
#include "app/gui/study/trials_page.h"
#include "app/gui/window/batch_simulation.h"
#include "app/gui/window/study_window.h"
#include "app/session/new_seed.h"
#include "app/tasks/mouse_trial.h"
#include "app/tasks/protocol_files.h"
#include "app/words/coded_phrases.h"
#include "app/words/reason.h"

namespace asperity {

namespace {

constexpr const char* kStartPage = "start";
constexpr int kDeskLook_ms = 20;
constexpr QSize kSmallestWindow{1366, 700};

SurfaceLook look_of(VisualTexture texture) {
  switch (texture) {
    case VisualTexture::on:
      return SurfaceLook::relief;
    case VisualTexture::off:
      return SurfaceLook::plain;
    case VisualTexture::neutral:
      return SurfaceLook::pattern;
  }
  return SurfaceLook::plain;
}

/// The first text of a trial with the mouse.
QString introduction_of(const Protocol& protocol) {
  QStringList paragraphs{
      SessionDesk::tr("You try this experiment with the mouse."),
      SessionDesk::tr(
          "The mouse exerts no force: you will not feel the surfaces. The forces that a "
          "device would exert are computed, and the session window plots them. Where a "
          "surface is shown, keep the left mouse button pressed on it and stroke it.")};
  if (protocol.vision == Vision::blindfold) {
    paragraphs += SessionDesk::tr("Do not put on the eye mask when a text asks for it.");
  }
  paragraphs += SessionDesk::tr(
      "The experiment ends after two trials. They belong to a temporary copy, "
      "and nothing is stored in the study.");
  return paragraphs.join("\n\n");
}

/// Whether this reason of the end is the last trial or the wish of who tries the protocol.
bool was_wanted(const Phrase& reason) {
  constexpr std::array kWanted{Reason::as_asked, Reason::as_asked_after_trial,
                               Reason::as_asked_after_block, Reason::stopped_as_asked};
  return std::ranges::any_of(kWanted,
                             [&](Reason each) { return reason.code() == phrase_of(each).code(); });
}

/// As soon as the session says what its protocol lets the participant see.
void add_workspace(ParticipantView& view, const SessionMonitor& monitor,
                   const std::filesystem::path& study) {
  auto* waiting = new QTimer(&view);
  QObject::connect(waiting, &QTimer::timeout, &view, [&view, &monitor, study, waiting] {
    const auto facts = monitor.facts();
    if (facts == nullptr) return;
    waiting->deleteLater();
    waiting->stop();
    if (!facts->protocol->scene) return;
    view.set_workspace(new LiveWorkspace(monitor, study, look_of(*facts->protocol->scene), &view));
  });
  waiting->start(kDeskLook_ms);
}

}  // namespace

SessionDesk::SessionDesk(StudyWindow& window, QObject* parent, SoundMaker make_sound)
    : QObject(parent),
      window_(window),
      make_sound_(std::move(make_sound)),
      simulation_(new BatchSimulation(window, this)) {
  connect(&window_, &StudyWindow::study_opened, this,
          [this](OpenStudy* study) { take_study(*study); });
  connect(&window_, &StudyWindow::session_wanted, this, &SessionDesk::choose);
  connect(simulation_, &BatchSimulation::wanted, this, &SessionDesk::simulate);
  connect(simulation_, &BatchSimulation::running, this,
          [this](bool now) { start_page_->set_simulating(now); });
}

SessionDesk::~SessionDesk() {
  // The windows hold references into the runner: they go first.
  delete participant_window_;
  delete session_window_;
}

bool SessionDesk::is_running() const { return runner_ != nullptr && runner_->is_running(); }

void SessionDesk::take_study(OpenStudy& study) {
  study_ = &study;
  start_page_ = new StartPage(study);
  window_.add_page(kStartPage, {}, start_page_);
  connect(start_page_, &StartPage::start_wanted, this, &SessionDesk::begin);
  connect(start_page_, &StartPage::simulation_wanted, this, &SessionDesk::simulate);
}

/// The processors of a session with a participant are shared with nothing.
bool SessionDesk::refuse_another() {
  if (runner_ != nullptr) {
    window_.banner().show_news(
        State::look,
        tr("Only one session can be open at a time: close the window of the open one first."));
    if (session_window_ != nullptr) session_window_->raise();
  } else if (simulation_->is_running()) {
    window_.banner().show_news(
        State::look, tr("The sessions of virtual participants are being simulated. Cancel the "
                        "simulation first, or wait until it is complete."));
  } else {
    return false;
  }
  return true;
}

void SessionDesk::simulate(const SimulationInputs& inputs) {
  if (!refuse_another()) simulation_->run(inputs);
}

void SessionDesk::try_by_mouse(const SessionWish& wish) {
  if (prepare_task_.is_running() || refuse_another()) return;
  window_.set_busy(tr("A session is being prepared."));
  prepare_task_.run<SessionOrder>(
      [wish, folder = study_->folder(), models = study_->models(), servo = study_->servo()](
          const std::stop_token&, const BackgroundTask::Progress&) {
        const Protocol loaded = load_protocol(wish.protocol, models, folder);
        const auto trial = std::make_shared<const MouseTrial>(
            loaded, folder, introduction_of(loaded).toStdString(), new_seed(), wish.group);
        SessionOrder order{.inputs = trial->inputs(), .mouse_trial = trial};
        order.inputs.servo = servo;
        for (const auto& [cue, path] : loaded.speech) {
          order.speech[cue] = order.inputs.study / path;
        }
        return order;
      },
      [this](const SessionOrder& order) { begin(order); },
      [this](const QString& what) {
        window_.set_busy({});
        window_.banner().show_news(State::stop, what);
      });
}

void SessionDesk::end_mouse_trial(State state, const QString& what) {
  finish("protocols");
  window_.banner().show_news(state, what);
}

void SessionDesk::choose(const SessionWish& wish) {
  if (wish.simulation) return simulate(*wish.simulation);
  if (wish.by_mouse) return try_by_mouse(wish);
  if (refuse_another()) return;
  if (wish.simulate) {
    start_page_->set_mode(SessionMode::simulate);
  } else if (!wish.participant && start_page_->mode() == SessionMode::simulate) {
    start_page_->set_mode(SessionMode::run);
  }
  start_page_->choose(wish.protocol, wish.participant, wish.session);
  window_.show_page(kStartPage);
}

void SessionDesk::begin(const SessionOrder& order) {
  if (refuse_another()) return;
  runner_ =
      std::make_unique<SessionRunner>(nullptr, make_sound_, study_->drivers(), study_->models());
  hold_ = study_->examiner().hold();  // the servo loop needs the processor
  runner_->start(order);
  window_.set_busy(tr("A session is running. End it in its own window first."));
  // The page before a session has done its part.
  if (order.mouse_trial == nullptr) window_.show_page("sessions");
  if (!order.inputs.is_virtual) open_participant_window();
  open_session_window();
  // First of all: the session's window may close at once, and then nothing is busy any more.
  const auto is_over = [this] {
    hold_.reset();
    window_.set_busy(tr("The window of the session that has ended is still open. Close it first."));
  };
  connect(runner_.get(), &SessionRunner::ended, this, is_over);
  connect(runner_.get(), &SessionRunner::failed, this, is_over);
  connect(runner_.get(), &SessionRunner::told, session_window_, &SessionWindow::tell_device_wish);
  finish_later_ = nullptr;
  if (order.mouse_trial != nullptr) {
    connect(runner_.get(), &SessionRunner::ended, this, [this](const SessionEnd& end) {
      const bool as_planned = end.reason.empty() || was_wanted(end.reason);
      end_mouse_trial(as_planned ? State::fine : State::look,
                      as_planned ? tr("The trial with the mouse has ended. Nothing was stored in "
                                      "the study.")
                                 : tr("The trial with the mouse has ended: %1. Nothing was stored "
                                      "in the study.")
                                       .arg(words_of(end.reason)));
    });
    connect(runner_.get(), &SessionRunner::failed, this,
            [this](const QString& what) { end_mouse_trial(State::stop, what); });
    return;
  }
  connect(runner_.get(), &SessionRunner::attempt_done, study_, &OpenStudy::announce_change);
  connect(runner_.get(), &SessionRunner::ended, session_window_, &SessionWindow::show_end);
  connect(runner_.get(), &SessionRunner::failed, session_window_, &SessionWindow::show_failure);
  connect(runner_.get(), &SessionRunner::failed, study_, &OpenStudy::announce_change);
  connect(runner_.get(), &SessionRunner::ended, study_, &OpenStudy::announce_change);
  const auto finish_if_closed = [this] {
    if (const auto finish_now = std::exchange(finish_later_, nullptr)) finish_now();
  };
  connect(runner_.get(), &SessionRunner::ended, this, finish_if_closed);
  connect(runner_.get(), &SessionRunner::failed, this, finish_if_closed);
}

void SessionDesk::open_participant_window() {
  const std::filesystem::path& study = runner_->order().inputs.study;
  participant_window_ = new ParticipantWindow(runner_->monitor(), study);
  add_workspace(participant_window_->view(), runner_->monitor(), study);
  participant_window_->keys().set_own_keyboard(runner_->order().own_keyboard);
  SessionRunner* runner = runner_.get();
  if (kind_of_device(runner_->order().inputs.device) == DeviceKind::pointer) {
    participant_window_->feed(runner_->pointer());
  }
  connect(participant_window_, &ParticipantWindow::acted, runner,
          [runner](const ParticipantInput& input) { runner->person().post(input); });
  connect(&participant_window_->view(), &ParticipantView::more_to_read, runner,
          [runner](bool more) { runner->person().set_more_to_read(more); });
  connect(participant_window_, &ParticipantWindow::remarked, runner,
          [runner](const QString& kind, const QString& text) {
            runner->requests().remark(kind.toStdString(), text.toStdString());
          });
  connect(participant_window_, &ParticipantWindow::screen_lost, this,
          &SessionDesk::stop_for_lost_screen);
  connect(participant_window_, &ParticipantWindow::closed, this, [this] {
    if (session_window_ != nullptr) session_window_->set_participant_window(false);
    // After the thanks: nobody else takes the keyboard up where it lies on one screen.
    if (session_window_ == nullptr || !session_window_->isVisible()) return;
    session_window_->raise();
    session_window_->activateWindow();
  });
  participant_window_->open_on(runner_->order().participant_screen);
}

/// Nobody feels what they cannot see any more: the force goes to zero first.
void SessionDesk::stop_for_lost_screen(const QString& screen) {
  SessionRequests& requests = runner_->requests();
  requests.remark("screen_lost", screen.toStdString());
  const SessionSnapshot now = runner_->monitor().snapshot();
  const bool is_felt = now.phase == SessionPhase::fore || now.phase == SessionPhase::contact;
  if (is_felt) {
    requests.emergency_stop();
  } else {
    requests.pause();
  }
  // Once the experimenter's window is there, and has said what it says of any screen.
  QTimer::singleShot(0, this, [this, screen, is_felt] {
    if (session_window_ == nullptr) return;
    session_window_->tell_screen_lost(screen,
                                      is_felt ? ScreenLoss::force_stopped : ScreenLoss::pausing);
  });
}

void SessionDesk::put_participant_back(const QString& screen) {
  if (participant_window_ == nullptr) return;
  const QList<QScreen*> screens = QGuiApplication::screens();
  const bool is_there = std::any_of(screens.begin(), screens.end(), [&screen](const QScreen* each) {
    return each->name() == screen;
  });
  if (is_there) {
    participant_window_->open_on(screen);
  } else {
    session_window_->tell_screen_lost(screen, ScreenLoss::still_gone);
  }
}

void SessionDesk::open_session_window() {
  const std::filesystem::path& study = runner_->order().inputs.study;
  session_window_ = new SessionWindow(runner_->monitor(), runner_->requests(), study);
  session_window_->setAttribute(Qt::WA_DeleteOnClose, false);
  if (participant_window_ != nullptr) {
    participant_window_->keys().set_session_window(session_window_);
  }
  session_window_->set_own_keyboard(runner_->order().own_keyboard);
  session_window_->set_only_tried(runner_->order().mouse_trial != nullptr);
  auto* mirror = new ParticipantView(runner_->monitor(), study, ParticipantView::Role::mirror,
                                     session_window_);
  if (participant_window_ != nullptr) mirror->follow(participant_window_->view());
  add_workspace(*mirror, runner_->monitor(), study);
  session_window_->set_mirror(mirror);
  connect(session_window_, &SessionWindow::closed, this, [this] { finish({}); });
  connect(session_window_, &SessionWindow::cancel_wanted, runner_.get(), &SessionRunner::cancel);
  connect(session_window_, &SessionWindow::results_wanted, this, [this] { finish("analysis"); });
  connect(session_window_, &SessionWindow::trials_wanted, this, [this] { finish("trials"); });
  connect(session_window_, &SessionWindow::way_on_wanted, this, &SessionDesk::go_on);
  connect(session_window_, &SessionWindow::participant_screen_back, this,
          &SessionDesk::put_participant_back);
  connect(session_window_, &SessionWindow::participant_window_wanted, this, [this] {
    if (participant_window_ != nullptr) participant_window_->come_back();
  });
  session_window_->set_participant_window(participant_window_ != nullptr);
  const bool beside = participant_window_ != nullptr && !participant_window_->is_full_screen();
  if (beside) {
    session_window_->place().fill(participant_window_->room_beside());
  } else if (!restore_geometry(*session_window_, "session")) {
    const QRect room = window_.screen()->availableGeometry();
    session_window_->resize(kSmallestWindow.expandedTo(room.size() * 0.9).boundedTo(room.size()));
  }
  session_window_->show();
  if (!beside) {
    session_window_->place().keep_within(session_window_->screen()->availableGeometry());
  }
  session_window_->raise();
  if (beside) {
    participant_window_->raise();
    participant_window_->activateWindow();
  } else {
    session_window_->activateWindow();
  }
}

void SessionDesk::go_on(AfterFailure way) {
  if (runner_ == nullptr) return;
  SessionOrder order = runner_->order();
  // What kept it from beginning may have been set up meanwhile.
  order.inputs.driver_options = driver_options(order.inputs.device);
  const auto facts = runner_->monitor().facts();
  switch (way) {
    case AfterFailure::start_again:
      return finish({}, [this, order] { begin(order); });
    case AfterFailure::check_again:
      return finish(kStartPage, [this] { start_page_->check_again(); });
    case AfterFailure::go_on:
      if (facts == nullptr) return;
      return finish({}, [this, wish = SessionWish{.protocol = order.inputs.protocol,
                                                  .participant = facts->row.participant,
                                                  .session = facts->row.id}] { choose(wish); });
  }
}

void SessionDesk::finish(const QString& page, std::function<void()> next) {
  if (runner_ == nullptr) return;
  if (is_running()) {
    // The window knows of the end from the monitor, a moment before the session's thread is done.
    finish_later_ = [this, page, next = std::move(next)] { finish(page, next); };
    return;
  }
  const bool was_beside = participant_window_ != nullptr && !participant_window_->is_full_screen();
  if (session_window_ != nullptr && !was_beside) remember_geometry(*session_window_, "session");
  window_.set_busy({});
  // The signal comes from inside the session's window: it lives until the event is over, and the
  // runner as long as the windows that look into it.
  // Of a trial with the mouse the study has nothing.
  const bool is_stored = runner_->order().mouse_trial == nullptr;
  const auto facts = is_stored ? runner_->monitor().facts() : nullptr;
  // A session that did not begin is started again with the same answers.
  if (facts != nullptr && start_page_ != nullptr) start_page_->forget_person();
  auto* runner = runner_.release();
  if (session_window_ != nullptr) {
    session_window_->disconnect(this);
    session_window_->hide();
    connect(session_window_, &QObject::destroyed, runner, &QObject::deleteLater);
    session_window_->deleteLater();
  } else {
    runner->deleteLater();
  }
  if (participant_window_ != nullptr) {
    participant_window_->allow_close();
    participant_window_->close();
    delete participant_window_;
  }
  if (auto* trials = qobject_cast<TrialsPage*>(window_.page("trials"));
      trials != nullptr && facts != nullptr && page == "trials") {
    trials->show_session(facts->row.id);
  }
  if (!page.isEmpty()) window_.show_page(page);
  if (auto* analysis = qobject_cast<AnalysisPage*>(window_.page("analysis"));
      analysis != nullptr && facts != nullptr) {
    analysis->choose(facts->protocol->name, facts->row.mode);
  }
  study_->announce_change();
  window_.raise();
  window_.activateWindow();
  if (next) next();
}

}  // namespace asperity

#include "moc_session_desk.cpp"
