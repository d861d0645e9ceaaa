#include "app/gui/session/session_header.h"

#include <algorithm>
#include <utility>

#include <QtCore/QEvent>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QProgressBar>
#include <QtWidgets/QPushButton>

#include "app/gui/look/controls.h"
#include "app/gui/session/session_text.h"

namespace asperity {

namespace {

void set_if_new(QLabel& label, const QString& text) {
  if (label.text() != text) label.setText(text);
}

}  // namespace

SessionHeader::SessionHeader(QWidget* parent) : QWidget(parent) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kGrid);
  rows->addLayout(make_title_line());
  auto* now = new QVBoxLayout();
  now->setSpacing(kGrid / 2);
  now->addLayout(make_count_line());
  now->addLayout(make_now_line());
  rows->addLayout(now);
}

QLayout* SessionHeader::make_title_line() {
  auto* row = new QHBoxLayout();
  row->setSpacing(kMargin);
  title_ = make_heading(tr("Session"), this);
  title_->setObjectName("session_title");
  title_->setWordWrap(false);
  title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  title_->installEventFilter(this);
  blindness_ = new QLabel(this);
  blindness_->setObjectName("blindness");
  unblind_ = make_button({}, ButtonRole::plain, this);
  unblind_->setObjectName("unblind");
  unblind_->setFocusPolicy(Qt::TabFocus);
  connect(unblind_, &QPushButton::clicked, this, &SessionHeader::unblind_pressed);
  row->addWidget(title_, 1);
  row->addWidget(blindness_);
  row->addWidget(unblind_);
  return row;
}

QLayout* SessionHeader::make_count_line() {
  auto* counts = new QHBoxLayout();
  counts->setSpacing(kGroupGap);
  block_ = new QLabel(this);
  block_->setObjectName("block");
  progress_ = new QProgressBar(this);
  progress_->setTextVisible(false);
  progress_->setObjectName("progress");
  trial_ = new QLabel(this);
  trial_->setObjectName("trial");
  elapsed_ = new QLabel(this);
  elapsed_->setObjectName("elapsed");
  left_ = new QLabel(this);
  left_->setObjectName("left");
  counts->addWidget(block_);
  counts->addWidget(progress_, 1);
  for (QLabel* label : {trial_, elapsed_, left_}) counts->addWidget(label);
  return counts;
}

QLayout* SessionHeader::make_now_line() {
  auto* now = new QHBoxLayout();
  now->setSpacing(kGroupGap);
  now_ = new QLabel(this);
  now_->setObjectName("now");
  now_->setFont(text_font(TextSize::heading, true));
  now_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  pending_ = new StateLabel(this);
  pending_->setObjectName("pending");
  pending_->setFont(text_font(TextSize::heading, true));
  pending_->setWordWrap(false);
  pending_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  now->addWidget(now_, 1);
  now->addWidget(pending_);
  return now;
}

void SessionHeader::set_facts(std::shared_ptr<const SessionFacts> facts) {
  facts_ = std::move(facts);
  write_title();
}

QString SessionHeader::title_with(const QString& protocol) const {
  const SessionRow& row = facts_->row;
  return tr("Session %1 · %2 · %3 · %4")
      .arg(row.session)
      .arg(QString::fromStdString(row.participant), protocol, SessionText::of_mode(row.mode));
}

QString SessionHeader::title() const { return title_->toolTip(); }

/// Whole in the tool tip; where it does not fit, the protocol's title is what is cut.
void SessionHeader::write_title() {
  if (facts_ == nullptr || facts_->protocol == nullptr) return;
  const QString protocol = QString::fromStdString(facts_->protocol->title);
  const QFontMetrics letters(title_->font());
  const int room = title_->width() - letters.horizontalAdvance(title_with({}));
  set_if_new(*title_, title_with(letters.elidedText(protocol, Qt::ElideRight, std::max(room, 0))));
  title_->setToolTip(title_with(protocol));
}

bool SessionHeader::eventFilter(QObject* watched, QEvent* event) {
  if (watched == title_ && event->type() == QEvent::Resize) write_title();
  return QWidget::eventFilter(watched, event);
}

void SessionHeader::show_blindness(const Blindness& blindness) {
  const bool marked = !blindness.unblinded_at.isEmpty();
  QString words{};
  if (marked) {
    words = blindness.is_blind ? tr("▲ Blind again; UNBLINDED at %1").arg(blindness.unblinded_at)
                               : tr("▲ UNBLINDED at %1").arg(blindness.unblinded_at);
  } else {
    words = blindness.is_blind ? tr("Blind: codes stand for conditions") : tr("Names are shown");
  }
  blindness_->setText(words);
  blindness_->setFont(text_font(TextSize::body, marked));
  blindness_->setStyleSheet(
      QString("color: %1").arg((marked ? theme().look : theme().muted).name()));
  if (blindness.is_blind) {
    unblind_->setText(blindness.is_run ? tr("Unblind…") : tr("Show names"));
  } else {
    unblind_->setText(blindness.is_run ? tr("Blind again") : tr("Hide names"));
  }
  unblind_->setEnabled(blindness.can_change);
}

void SessionHeader::show_progress(const SessionSnapshot& snapshot) {
  const SessionSnapshot& s = snapshot;
  set_if_new(*block_, s.block > 0 ? tr("Block %1 of %2").arg(s.block).arg(s.blocks)
                                  : tr("Blocks: %1").arg(s.blocks));
  progress_->setMaximum(std::max(1, s.trials));
  progress_->setValue(s.trials_done);
  set_if_new(*trial_, s.trial > 0 ? tr("trial %1 of %2").arg(s.trial).arg(s.trials)
                                  : tr("trials: %1").arg(s.trials));
}

void SessionHeader::show_left(const QString& text) {
  set_if_new(*left_, text);
  left_->setHidden(text.isEmpty());
}

void SessionHeader::show_now(const QString& text) { set_if_new(*now_, text); }

void SessionHeader::show_elapsed(double elapsed_s) {
  set_if_new(*elapsed_, tr("%1 elapsed").arg(SessionText::of_duration(elapsed_s)));
}

void SessionHeader::show_pending(const QString& text) {
  if (text == pending_->property("words").toString()) return;
  pending_->setProperty("words", text);
  if (text.isEmpty()) {
    pending_->clear();
  } else {
    pending_->set_state(State::look, text);
  }
}

}  // namespace asperity
