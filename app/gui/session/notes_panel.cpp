#include "app/gui/session/notes_panel.h"

#include <QtCore/QTime>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QPushButton>

#include "app/gui/look/controls.h"

namespace asperity {

NotesPanel::NotesPanel(QWidget* parent) : QWidget(parent) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kGrid / 2);
  auto* top = new QHBoxLayout();
  auto* title = new QLabel(tr("NOTES"), this);
  title->setFont(text_font(TextSize::small, true));
  title->setProperty("role", "muted");
  why_locked_ = new QLabel(this);
  why_locked_->setObjectName("note_locked");
  why_locked_->setFont(text_font(TextSize::small));
  why_locked_->setProperty("role", "muted");
  why_locked_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  top->addWidget(title);
  top->addWidget(why_locked_, 1);
  rows->addLayout(top);

  field_ = new QLineEdit(this);
  field_->setObjectName("note");
  field_->setPlaceholderText(tr("Note, F2; Return stores it"));
  rows->addWidget(field_);
  phrases_ = new QGridLayout();
  phrases_->setSpacing(kGrid / 2);
  rows->addLayout(phrases_);
  list_ = new QListWidget(this);
  list_->setObjectName("notes");
  list_->setFont(text_font(TextSize::small));
  list_->setFocusPolicy(Qt::NoFocus);
  list_->setSelectionMode(QAbstractItemView::NoSelection);
  list_->setWordWrap(true);
  list_->setMinimumHeight(24);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored);
  rows->addWidget(list_, 1);
  connect(field_, &QLineEdit::returnPressed, this, [this] {
    note(field_->text().trimmed());
    field_->clear();
  });
  set_phrases(usual_phrases());
}

QStringList NotesPanel::usual_phrases() {
  return {tr("Lifted early"),  tr("Distracted"),   tr("Asked a question"),
          tr("Noise outside"), tr("Grip changed"), tr("Seems tired")};
}

void NotesPanel::set_phrases(const QStringList& phrases) {
  while (QLayoutItem* item = phrases_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  constexpr int kColumns = 3;
  int place = 0;
  for (const QString& phrase : phrases) {
    QPushButton* button = make_button(phrase, ButtonRole::plain, this);
    button->setObjectName("phrase");
    button->setFont(text_font(TextSize::small));
    button->setStyleSheet("min-height: 24px; padding: 0 4px;");
    button->setFocusPolicy(Qt::NoFocus);
    button->setToolTip(tr("Notes “%1”").arg(phrase));
    connect(button, &QPushButton::clicked, this, [this, phrase] { note(phrase); });
    phrases_->addWidget(button, place / kColumns, place % kColumns);
    ++place;
  }
}

void NotesPanel::lock(const QString& why) {
  if (why_locked_->text() == why && field_->isEnabled() == why.isEmpty()) return;
  why_locked_->setText(why);
  // The focus is not handed on: the next button would hear what the participant presses. Nor does
  // the field get it back afterwards.
  if (!why.isEmpty() && field_->hasFocus()) field_->clearFocus();
  field_->setEnabled(why.isEmpty());
}

bool NotesPanel::is_locked() const { return !field_->isEnabled(); }

void NotesPanel::focus_field() {
  if (field_->isEnabled()) field_->setFocus(Qt::ShortcutFocusReason);
}

void NotesPanel::note(const QString& text) {
  if (text.isEmpty()) return;
  list_->insertItem(0, QString("%1  %2").arg(QTime::currentTime().toString("HH:mm"), text));
  list_->scrollToTop();
  emit noted(text);
}

}  // namespace asperity
