// Switches between fields for a new participant and the list of known ones, and lists what is missing.

#include "app/gui/start/participant_card.h"

#include <algorithm>
#include <utility>

#include <QtCore/QSignalBlocker>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QButtonGroup>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>

#include "app/gui/base/question_form.h"
#include "app/gui/base/shown_text.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"
#include "app/gui/start/group_chooser.h"
#include "app/records/participant_answers.h"
#include "app/tasks/label_notice.h"
#include "app/tasks/study_overview.h"

namespace asperity {

namespace {

constexpr int kParticipantFieldWidth = 240;
constexpr int kShortButton = 104;

/// A widget with a vertical layout and no margins.
QWidget* make_group(QWidget* parent, QVBoxLayout*& layout) {
  auto* group = new QWidget(parent);
  layout = new QVBoxLayout(group);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  return group;
}

QHBoxLayout* make_row(const QString& text, QWidget* field, QWidget* parent) {
  auto* row = new QHBoxLayout();
  row->setSpacing(kMargin);
  QLabel* label = make_text(text, parent);
  label->setBuddy(field);
  field->setFixedWidth(kParticipantFieldWidth);
  row->addWidget(label, 1);
  row->addWidget(field);
  return row;
}

}  // namespace

ParticipantCard::ParticipantCard(QWidget* parent) : QWidget(parent) {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* layout = nullptr;
  outer->addWidget(make_card(this, layout));
  auto* head = new QHBoxLayout();
  head->setSpacing(kGrid);
  head->addWidget(make_heading(tr("Participant"), this), 1);
  switches_ = new QWidget(this);
  auto* switches = new QHBoxLayout(switches_);
  switches->setContentsMargins(0, 0, 0, 0);
  switches->setSpacing(kGrid);
  new_ = make_button(tr("New"), ButtonRole::selector, this);
  new_->setObjectName("new_participant");
  new_->setMinimumWidth(kShortButton);  // as wide for "Virtual"
  known_ = make_button(tr("Already in the study"), ButtonRole::selector, this);
  known_->setObjectName("known_participant");
  auto* kinds = new QButtonGroup(this);
  kinds->addButton(new_);
  kinds->addButton(known_);
  new_->setChecked(true);
  switches->addWidget(new_);
  switches->addWidget(known_);
  head->addWidget(switches_);
  layout->addLayout(head);

  QVBoxLayout* new_layout = nullptr;
  new_fields_ = make_group(this, new_layout);
  label_ = new QLineEdit(this);
  label_->setObjectName("participant_label");
  new_layout->addLayout(make_row(tr("Label instead of a name *"), label_, this));
  form_ = new QuestionForm(this);
  new_layout->addWidget(form_);
  layout->addWidget(new_fields_);

  QVBoxLayout* known_layout = nullptr;
  known_fields_ = make_group(this, known_layout);
  list_ = new ChoiceBox(this);
  list_->setObjectName("participants");
  list_->setPlaceholderText(tr("Choose"));
  ignore_wheel(*list_);
  known_layout->addLayout(make_row(tr("Participant *"), list_, this));
  known_text_ = make_text({}, this, true);
  known_layout->addWidget(known_text_);
  layout->addWidget(known_fields_);

  virtual_text_ = make_text({}, this, true);
  virtual_text_->setObjectName("virtual_labels");
  layout->addWidget(virtual_text_);
  group_ = new GroupChooser(this);
  layout->addWidget(group_);
  unfinished_ = new QWidget(this);
  auto* offer = new QHBoxLayout(unfinished_);
  offer->setContentsMargins(0, 0, 0, 0);
  offer->setSpacing(kMargin);
  unfinished_text_ = new StateLabel(unfinished_);
  unfinished_text_->setObjectName("unfinished");
  go_on_ = make_button({}, ButtonRole::plain, unfinished_);
  go_on_->setObjectName("resume");
  offer->addWidget(unfinished_text_, 1);
  offer->addWidget(go_on_);
  layout->addWidget(unfinished_);
  QVBoxLayout* late_layout = nullptr;
  late_ = make_group(this, late_layout);
  late_reason_ = new QLineEdit(this);
  late_reason_->setObjectName("late_reason");
  late_layout->addLayout(make_row(tr("Reason for resuming *"), late_reason_, this));
  late_->hide();
  layout->addWidget(late_);
  session_text_ = make_text({}, this, true);
  session_text_->setObjectName("session_text");
  layout->addWidget(session_text_);

  connect(kinds, &QButtonGroup::buttonClicked, this, [this] {
    show_kind();
    emit person_changed();
    emit changed();
  });
  connect(label_, &QLineEdit::textChanged, this, [this] {
    emit person_changed();
    emit changed();
  });
  connect(list_, &QComboBox::currentIndexChanged, this, [this] {
    show_kind();
    emit person_changed();
    emit changed();
  });
  connect(form_, &QuestionForm::answered, this, &ParticipantCard::changed);
  connect(group_, &GroupChooser::changed, this, &ParticipantCard::changed);
  connect(late_reason_, &QLineEdit::textChanged, this, &ParticipantCard::late_reason_changed);
  connect(go_on_, &QPushButton::clicked, this, &ParticipantCard::go_on_wanted);
  set_unfinished({}, false);
  show_kind();
}

void ParticipantCard::set_questions(const std::vector<Question>& questions) {
  form_->set_questions(questions);
  // Fields that are made later come last otherwise, wherever they stand.
  QWidget* before = label_;
  for (QWidget* field : form_->fields()) {
    setTabOrder(before, field);
    before = field;
  }
}

void ParticipantCard::set_people(const std::vector<ParticipantRow>& people) {
  const QString suggested_before = QString::fromStdString(suggested_label(people_));
  people_ = people;
  // A label that was only suggested follows the study; one that somebody typed, or cleared, stays.
  if (!std::exchange(has_suggested_, true) || label_->text() == suggested_before) {
    const QSignalBlocker silent(label_);
    label_->setText(QString::fromStdString(suggested_label(people)));
  }
  const QString chosen = list_->currentText();
  const QSignalBlocker silent(list_);
  list_->clear();
  for (const ParticipantRow& person : people_) {
    if (person.withdrawn) continue;
    if (person.is_virtual == is_virtual_) list_->addItem(QString::fromStdString(person.label));
  }
  list_->setCurrentIndex(list_->findText(chosen));
  switches_->setVisible(list_->count() > 0);  // otherwise there is nothing to choose
  if (list_->count() == 0) new_->setChecked(true);
  show_kind();
}

void ParticipantCard::set_virtual(bool is_virtual, const QString& labels) {
  virtual_text_->setText(labels);
  if (is_virtual_ == is_virtual) return;
  is_virtual_ = is_virtual;
  new_->setText(is_virtual ? tr("Virtual") : tr("New"));
  new_->setChecked(true);
  set_people(people_);
}

void ParticipantCard::set_unfinished(const std::optional<UnfinishedSession>& session,
                                     bool goes_on) {
  unfinished_->setVisible(session.has_value());
  if (!session) return;
  const SessionRow& row = session->row;
  const bool made_up = has_made_up_dates(row);
  const QString begun = text_of_time(row.started_utc);
  QString text{};
  if (goes_on) {
    text = made_up ? tr("Session %1, on a simulated clock, will be resumed; trials completed and "
                        "stored: %2 of %3.")
                         .arg(row.session)
                   : tr("Session %1, begun %2, will be resumed; trials completed and stored: %3 of "
                        "%4.")
                         .arg(row.session)
                         .arg(begun);
    text = text.arg(session->trials_done).arg(session->trials);
  } else {
    text = made_up ? tr("Session %1 of this protocol, on a simulated clock, is unfinished.")
                         .arg(row.session)
                   : tr("Session %1 of this protocol, begun %2, is unfinished.")
                         .arg(row.session)
                         .arg(begun);
  }
  unfinished_text_->set_state(goes_on ? State::fine : State::look, text);
  go_on_->setVisible(!goes_on);
  go_on_->setText(tr("Resume session %1 (trials completed: %2 of %3)")
                      .arg(row.session)
                      .arg(session->trials_done)
                      .arg(session->trials));
}

void ParticipantCard::ask_late_reason(bool asked) { late_->setVisible(asked); }

std::string ParticipantCard::late_reason() const {
  return late_->isHidden() ? std::string() : late_reason_->text().trimmed().toStdString();
}

void ParticipantCard::set_session_text(const QString& text) {
  session_text_->setText(text);
  session_text_->setVisible(!text.isEmpty());
}

void ParticipantCard::choose(const std::string& label) {
  const int index = list_->findText(QString::fromStdString(label));
  const QSignalBlocker silent_label(label_);
  const QSignalBlocker silent_list(list_);
  (index >= 0 ? known_ : new_)->setChecked(true);
  if (index >= 0) {
    list_->setCurrentIndex(index);
  } else {
    label_->setText(QString::fromStdString(label));
  }
  show_kind();
  emit person_changed();
  emit changed();
}

void ParticipantCard::choose_next() {
  new_->setChecked(true);
  form_->clear_answers();
  label_->setText(QString::fromStdString(suggested_label(people_)));
  show_kind();
  emit person_changed();
  emit changed();
}

StartDraft::Person ParticipantCard::draft() const {
  const std::string typed = label_->text().toStdString();
  const bool is_suggested = typed == suggested_label(people_);
  return {.is_new = is_new(),
          .label = !is_new()      ? label()
                   : is_suggested ? ""
                                  : typed,
          .answers = form_->answers(),
          .group = group_->group()};
}

void ParticipantCard::fill_in(const StartDraft::Person& draft) {
  form_->set_answers(draft.answers);
  const QString label = QString::fromStdString(draft.label);
  const int index = list_->findText(label);
  if (!draft.is_new && index >= 0) {
    known_->setChecked(true);
    list_->setCurrentIndex(index);
  } else {
    new_->setChecked(true);
    if (!label.isEmpty()) label_->setText(label);
  }
  show_kind();
  emit person_changed();
  group_->choose(draft.group);
  emit changed();
}

std::string ParticipantCard::label() const {
  if (!is_new()) return list_->currentIndex() < 0 ? "" : list_->currentText().toStdString();
  return is_virtual_ ? next_virtual_label(people_) : label_->text().trimmed().toStdString();
}

bool ParticipantCard::is_new() const { return new_->isChecked(); }

std::optional<ParticipantRow> ParticipantCard::known() const {
  if (is_new()) return {};
  const std::string wanted = label();
  const auto found =
      std::find_if(people_.begin(), people_.end(),
                   [&wanted](const ParticipantRow& person) { return person.label == wanted; });
  return found == people_.end() ? std::nullopt : std::optional(*found);
}

ParticipantRow ParticipantCard::new_person(const Protocol& protocol) const {
  // Dated when it is stored.
  return person_of(label(), protocol, form_->answers(), "");
}

std::vector<QString> ParticipantCard::complaints() const {
  std::vector<QString> complaints{};
  if (group_->is_missing()) complaints.push_back(tr("No group is chosen; choose one."));
  if (!is_new()) {
    if (label().empty()) return {tr("No participant is chosen; choose one.")};
    return complaints;
  }
  if (is_virtual_) return complaints;
  if (label().empty()) {
    complaints.push_back(tr("The new participant has no label; enter one."));
  } else if (const auto complaint = complaint_about_label(label(), false)) {
    complaints.push_back(tr(
        "The label must consist of 1 to 32 letters and digits (0-9, A-Z, a-z) and must not begin "
        "with “virtual”."));
  } else if (std::any_of(people_.begin(), people_.end(), [this](const ParticipantRow& person) {
               return person.label == label();
             })) {
    complaints.push_back(tr("%1 is already in the study: choose it under “Already in the study”, "
                            "or enter another label.")
                             .arg(QString::fromStdString(label())));
  }
  for (QString& complaint : form_->complaints()) complaints.push_back(std::move(complaint));
  return complaints;
}

void ParticipantCard::show_kind() {
  const bool is_new_person = is_new();
  new_fields_->setVisible(is_new_person && !is_virtual_);
  known_fields_->setVisible(!is_new_person);
  virtual_text_->setVisible(is_virtual_ && is_new_person);
  QString text{};
  if (const std::optional<ParticipantRow> person = known()) {
    QStringList parts{};
    if (person->age_years) parts << tr("%1 years").arg(*person->age_years);
    if (person->sex == "F") parts << tr("female");
    if (person->sex == "M") parts << tr("male");
    if (person->handedness == "left") parts << tr("left-handed");
    if (person->handedness == "right") parts << tr("right-handed");
    text = parts.join(" · ");
  }
  known_text_->setText(text);
  known_text_->setVisible(!text.isEmpty());
}

}  // namespace asperity

#include "moc_participant_card.cpp"
