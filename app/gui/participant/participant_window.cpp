// Covers the chosen screen, or stands next to the session window where there is only one.

#include "app/gui/participant/participant_window.h"

#include <algorithm>
#include <utility>

#include <QtCore/QTimer>
#include <QtGui/QCloseEvent>
#include <QtGui/QGuiApplication>
#include <QtGui/QScreen>
#include <QtWidgets/QBoxLayout>

#include "app/gui/look/controls.h"
#include "app/gui/participant/pages/page_for.h"
#include "app/gui/participant/pages/participant_brush.h"
#include "app/gui/participant/pages/participant_page.h"

namespace asperity {

ParticipantWindow::ParticipantWindow(const SessionMonitor& monitor, std::filesystem::path study,
                                     QWidget* parent)
    : QWidget(parent, Qt::Window | Qt::FramelessWindowHint), monitor_(monitor) {
  setObjectName("participant_window");
  setWindowTitle(tr("Participant"));
  QPalette calm = palette();
  calm.setColor(QPalette::Window, ParticipantColors{}.ground);
  setPalette(calm);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  band_ = new ModeBand(this);
  layout->addWidget(band_);
  view_ = new ParticipantView(monitor, std::move(study), ParticipantView::Role::participant, this);
  layout->addWidget(view_, 1);
  keys_ = std::make_unique<ResponseKeys>(*view_);
  setFocusProxy(view_);

  connect(view_, &ParticipantView::acted, this, &ParticipantWindow::acted);
  connect(view_, &ParticipantView::remarked, this, &ParticipantWindow::remarked);
  connect(keys_.get(), &ResponseKeys::remarked, this, &ParticipantWindow::remarked);
  connect(view_, &ParticipantView::scene_changed, this, &ParticipantWindow::follow);
  connect(qGuiApp, &QGuiApplication::screenRemoved, this, &ParticipantWindow::leave_screen);
  thanks_ = new QTimer(this);
  thanks_->setObjectName("thanks");
  thanks_->setSingleShot(true);
  thanks_->setInterval(static_cast<int>(kThanks_s * 1000.0));
  connect(thanks_, &QTimer::timeout, this, [this] {
    allow_close();
    close();
  });
  follow();
}

void ParticipantWindow::feed(LatestValue<PointerSample>& samples) {
  view_->set_pointer_is_probe(true);
  feed_ = std::make_unique<PointerFeed>(*view_, monitor_, samples);
}

void ParticipantWindow::follow() {
  if (const auto facts = monitor_.facts()) band_->set_mode(facts->row.mode);
  const bool ended = view_->scene().kind == ParticipantScene::Kind::ended;
  if (ended && !thanks_->isActive()) thanks_->start();
  if (!ended) thanks_->stop();
  // What is typed as a text has to go to one field: this window's, from the moment that it is asked
  // for.
  const bool asks_for_text =
      page_for(view_->scene()).typing(view_->scene()) == ParticipantPage::Typing::text;
  if (asks_for_text && !asked_for_text_ && isVisible() && !keys_->own_keyboard()) {
    activateWindow();
  }
  asked_for_text_ = asks_for_text;
}

namespace {

// What the session window needs with its frame, and what is left for the participant at the least.
constexpr int kExperimentersWidth = 682;
constexpr int kLeastWidth = 546;

/// Null: it is not there.
QScreen* screen_of(const QString& name) {
  for (QScreen* each : QGuiApplication::screens()) {
    if (each->name() == name) return each;
  }
  return nullptr;
}

}  // namespace

void ParticipantWindow::open_on(const QString& screen) {
  QScreen* chosen = screen_of(screen);
  if (chosen != nullptr && QGuiApplication::screens().size() > 1) return cover(*chosen);
  stand_beside(chosen != nullptr ? *chosen : *QGuiApplication::primaryScreen());
  if (chosen == nullptr && !screen.isEmpty()) emit screen_lost(screen);
}

void ParticipantWindow::cover(QScreen& screen) {
  screen_name_ = screen.name();
  full_screen_ = true;
  setScreen(&screen);
  setGeometry(screen.geometry());
  showFullScreen();
}

void ParticipantWindow::stand_beside(QScreen& screen) {
  screen_name_ = screen.name();
  full_screen_ = false;
  const QRect room = screen.availableGeometry();
  setScreen(&screen);
  showNormal();
  const int beside =
      std::max(room.width() / 2, std::min(kExperimentersWidth, room.width() - kLeastWidth));
  setGeometry(room.adjusted(beside, 0, 0, 0));
}

QRect ParticipantWindow::room_beside() const {
  QRect room = screen()->availableGeometry();
  room.setRight(x() - 1);
  return room;
}

void ParticipantWindow::come_back() {
  if (QScreen* const mine = screen_of(screen_name_); mine != nullptr && full_screen_) {
    cover(*mine);
  } else {
    stand_beside(mine != nullptr ? *mine : *QGuiApplication::primaryScreen());
  }
  raise();
}

void ParticipantWindow::leave_screen(QScreen* screen) {
  if (screen == nullptr || screen->name() != screen_name_ || !isVisible()) return;
  const QString name = screen_name_;
  QScreen* left = QGuiApplication::primaryScreen();
  if (left != nullptr) stand_beside(*left);
  emit screen_lost(name);
}

void ParticipantWindow::closeEvent(QCloseEvent* event) {
  if (!may_close_) {
    event->ignore();
    return;
  }
  event->accept();
  emit closed();
}

}  // namespace asperity

#include "moc_participant_window.cpp"
