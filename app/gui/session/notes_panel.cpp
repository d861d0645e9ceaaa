// Emits the typed or chosen note, and offers as many phrases as there is room for.

#include "app/gui/session/notes_panel.h"

#include <algorithm>
#include <utility>

#include <QtCore/QList>
#include <QtCore/QStringList>
#include <QtCore/QTime>
#include <QtGui/QAction>
#include <QtGui/QFontMetrics>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QPushButton>

#include "app/gui/base/settings.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/words/offered_reasons.h"

namespace asperity {

namespace {

/// What a hand at a haptic device, and whoever it belongs to, is noted for most often.
QStringList usual_phrases() {
  QStringList phrases{};
  for (const Phrase& phrase : offered_reasons(ReasonFor::noting)) phrases += words_of(phrase);
  return phrases;
}

}  // namespace

/// Buttons in rows of three, of which as many are shown as there is room for.
class NotesPanel::PhraseGrid final : public QWidget {
 public:
  static constexpr int kFewest = 2;  ///< rows that are always shown

  using QWidget::QWidget;

  /// In place of those before; they are children of this.
  void set_buttons(const QList<QPushButton*>& buttons) {
    for (QPushButton* before : std::as_const(buttons_)) {
      before->hide();
      before->deleteLater();  // a click on one of them may be what asks anew
    }
    buttons_ = buttons;
    place();
  }
  /// The last rows are left out where `height` is short of them.
  void fit(int height) {
    shown_ = std::max(kFewest, (height + kGap) / (kRowHeight + kGap));
    place();
  }
  int fewest_height() const { return height_of(std::min(rows(), kFewest)); }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QWidget::resizeEvent(event);
    place();
  }

 private:
  static constexpr int kColumns = 3;
  static constexpr int kGap = kGrid / 2;
  static constexpr int kRowHeight = 28;

  int rows() const { return (static_cast<int>(buttons_.size()) + kColumns - 1) / kColumns; }
  static int height_of(int rows) { return rows * (kRowHeight + kGap) - kGap; }
  void place() {
    const int shown = std::min(rows(), shown_);
    setFixedHeight(height_of(shown));
    const int column_width = (width() - (kColumns - 1) * kGap) / kColumns;
    for (int i = 0; i < buttons_.size(); ++i) {
      const int row = i / kColumns;
      buttons_[i]->setGeometry(i % kColumns * (column_width + kGap), row * (kRowHeight + kGap),
                               column_width, kRowHeight);
      buttons_[i]->setVisible(row < shown);
    }
  }

  QList<QPushButton*> buttons_{};
  int shown_ = kFewest;
};

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
  field_->setAccessibleName(tr("Note"));
  field_->setPlaceholderText(tr("Note (F2); Return stores it"));
  keep_ = make_button(tr("Keep as phrase"), ButtonRole::link, this);
  keep_->setObjectName("keep_phrase");
  keep_->setFont(text_font(TextSize::small));
  keep_->setToolTip(tr("Adds a button for this note, in later sessions too"));
  keep_->hide();
  auto* write = new QHBoxLayout();
  write->setSpacing(kGrid / 2);
  write->addWidget(field_, 1);
  write->addWidget(keep_);
  rows->addLayout(write);
  phrases_ = new PhraseGrid(this);
  rows->addWidget(phrases_);
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
  connect(field_, &QLineEdit::textChanged, this,
          [this](const QString& text) { keep_->setHidden(text.trimmed().isEmpty()); });
  connect(keep_, &QPushButton::clicked, this, &NotesPanel::keep_phrase);
  show_phrases();
}

void NotesPanel::show_phrases() {
  QList<QPushButton*> buttons{};
  // One's own first: where there is little room, the last ones are left out.
  for (const QString& phrase : note_phrases()) {
    QPushButton* button = make_phrase(phrase);
    // It may be longer than there is room for: the tool tip says the rest.
    constexpr int kRoom = 104;
    const QFontMetrics letters(button->font());
    button->setText(letters.elidedText(phrase, Qt::ElideRight, kRoom).replace('&', "&&"));
    button->setToolTip(tr("Adds the note “%1”. Right-click to remove the phrase.").arg(phrase));
    auto* forget = new QAction(tr("Remove this phrase"), button);
    connect(forget, &QAction::triggered, this, [this, phrase] { forget_phrase(phrase); });
    button->addAction(forget);
    button->setContextMenuPolicy(Qt::ActionsContextMenu);
    buttons += button;
  }
  for (const QString& phrase : usual_phrases()) buttons += make_phrase(phrase);
  phrases_->set_buttons(buttons);
}

QPushButton* NotesPanel::make_phrase(const QString& phrase) {
  QPushButton* button = make_button(phrase, ButtonRole::plain, phrases_);
  button->setObjectName("phrase");
  button->setProperty("phrase", phrase);
  button->setFont(text_font(TextSize::small));
  button->setStyleSheet("min-height: 24px; padding: 0 4px;");
  button->setFocusPolicy(Qt::NoFocus);
  button->setToolTip(tr("Adds the note “%1”").arg(phrase));
  connect(button, &QPushButton::clicked, this, [this, phrase] { note(phrase); });
  return button;
}

void NotesPanel::keep_phrase() {
  const QString phrase = field_->text().trimmed();
  QStringList phrases = note_phrases();
  phrases.removeAll(phrase);
  if (!usual_phrases().contains(phrase)) phrases.append(phrase);
  while (phrases.size() > kOwn) phrases.removeFirst();
  remember_note_phrases(phrases);
  show_phrases();
  field_->setFocus();  // it is not noted yet
}

void NotesPanel::forget_phrase(const QString& phrase) {
  QStringList phrases = note_phrases();
  phrases.removeAll(phrase);
  remember_note_phrases(phrases);
  show_phrases();
}

int NotesPanel::height_beside_phrases() const {
  return layout()->minimumSize().height() - phrases_->minimumHeight();
}

QSize NotesPanel::minimumSizeHint() const {
  return {layout()->minimumSize().width(), height_beside_phrases() + phrases_->fewest_height()};
}

void NotesPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  phrases_->fit(height() - height_beside_phrases());
}

void NotesPanel::lock(const QString& why) {
  if (why_locked_->text() == why && field_->isEnabled() == why.isEmpty()) return;
  why_locked_->setText(why);
  // The focus is not handed on: the next button would hear what the participant presses. Nor does
  // the field get it back afterwards.
  if (!why.isEmpty() && field_->hasFocus()) field_->clearFocus();
  field_->setEnabled(why.isEmpty());
  keep_->setEnabled(why.isEmpty());
}

bool NotesPanel::is_locked() const { return !field_->isEnabled(); }

void NotesPanel::focus_field() {
  if (field_->isEnabled()) field_->setFocus(Qt::ShortcutFocusReason);
}

void NotesPanel::show_earlier(const std::vector<Phrase>& notes) {
  for (const Phrase& note : notes) list_->insertItem(0, tr("earlier  %1").arg(words_of(note)));
}

void NotesPanel::note(const QString& text) {
  if (text.isEmpty()) return;
  list_->insertItem(0, QString("%1  %2").arg(QTime::currentTime().toString("HH:mm"), text));
  list_->scrollToTop();
  emit noted(text);
}

}  // namespace asperity

#include "moc_notes_panel.cpp"
