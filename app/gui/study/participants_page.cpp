// Fills a table with the participants, shows the answers of the selected one, and opens the withdrawal.

#include "app/gui/study/participants_page.h"

#include <algorithm>

#include <QtGui/QFontMetrics>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QButtonGroup>
#include <QtWidgets/QLineEdit>
#include <nlohmann/json.hpp>

#include "app/gui/base/shown_text.h"
#include "app/gui/base/study_table.h"
#include "app/gui/look/words.h"
#include "app/gui/study/withdraw_dialog.h"
#include "app/records/participant_answers.h"
#include "app/words/phrase_of_error.h"

namespace asperity {

namespace {

/// "hand_used: right · hand_problems: no"
QString text_of_answers(const std::string& json) {
  const auto answers = nlohmann::json::parse(json, nullptr, false);
  QStringList parts{};
  if (answers.is_object()) {
    for (const auto& [question, answer] : answers.items()) {
      const std::string text = answer.is_string() ? answer.get<std::string>() : answer.dump();
      parts.append(QString::fromStdString(question + ": " + text));
    }
  }
  return parts.join(" · ");
}

QString or_dash(const std::optional<std::string>& text) {
  return text ? QString::fromStdString(*text) : QString("–");
}

}  // namespace

ParticipantsPage::ParticipantsPage(OpenStudy& study, QWidget* parent)
    : StudyPage(study, tr("Participants"), parent) {
  setObjectName("participants_page");
  set_empty_state(
      new EmptyState(tr("No participants yet"),
                     tr("A participant is added when their first session starts: choose a protocol "
                        "on the Protocols page and press “Start session…”. A label is suggested "
                        "there, and the protocol's questions are asked."),
                     this));

  auto* tools = new QHBoxLayout();
  tools->setSpacing(kGrid);
  people_ = make_button({}, ButtonRole::selector, this);
  people_->setObjectName("participants_people");
  virtual_people_ = make_button({}, ButtonRole::selector, this);
  virtual_people_->setObjectName("participants_virtual");
  auto* group = new QButtonGroup(this);
  group->addButton(people_);
  group->addButton(virtual_people_);
  filter_ = new QLineEdit(this);
  filter_->setObjectName("participants_filter");
  filter_->setAccessibleName(tr("Filter"));
  filter_->setPlaceholderText(tr("Filter"));
  filter_->setClearButtonEnabled(true);
  filter_->setMaximumWidth(280);
  tools->addWidget(people_);
  tools->addWidget(virtual_people_);
  tools->addStretch(1);
  tools->addWidget(filter_, 1);
  body().addLayout(tools);

  using Align = StudyTable::Align;
  table_ = new StudyTable({{tr("Label"), 128, Align::text},
                           {tr("Age, years"), 120, Align::number},
                           {tr("Sex"), 88, Align::text},
                           {tr("Handedness"), 136, Align::text},
                           {tr("Sessions completed"), 144, Align::number},
                           {tr("Unfinished"), 120, Align::number},
                           {tr("Last session"), 0, Align::text}},
                          this);
  table_->setObjectName("participants_table");
  table_->setAccessibleName(tr("Participants"));
  body().addWidget(table_, 1);

  auto* below = new QHBoxLayout();
  below->setSpacing(kMargin);
  sessions_ = make_button(tr("Show sessions"), ButtonRole::plain, this);
  sessions_->setObjectName("participants_show_sessions");
  withdraw_ = make_button(tr("Withdraw…"), ButtonRole::plain, this);
  withdraw_->setObjectName("participants_withdraw");
  withdraw_->setToolTip(
      tr("Exclude the participant's data from all use, or delete them from the study."));
  answers_ = make_text({}, this, true);
  below->addWidget(sessions_);
  below->addWidget(withdraw_);
  below->addWidget(answers_, 1);
  body().addLayout(below);
  next_label_ = make_text({}, this, true);
  next_label_->setObjectName("participants_next_label");
  body().addWidget(next_label_);

  connect(group, &QButtonGroup::buttonClicked, this, [this](QAbstractButton* button) {
    chosen_ = true;
    show_virtual_ = button == virtual_people_;
    fill();
  });
  connect(filter_, &QLineEdit::textChanged, table_, &StudyTable::set_filter);
  connect(table_, &StudyTable::row_selected, this, &ParticipantsPage::show_selected);
  connect(table_, &StudyTable::row_opened, this, &ParticipantsPage::sessions_wanted);
  connect(sessions_, &QPushButton::clicked, this,
          [this] { emit sessions_wanted(table_->selected_key()); });
  connect(withdraw_, &QPushButton::clicked, this, &ParticipantsPage::ask_to_withdraw);
  read_with<std::vector<ParticipantOverview>>(
      Need::always,
      [](const Study& own, const std::stop_token&) { return participant_overviews(own); },
      [this](const std::vector<ParticipantOverview>& people) { show_people(people); });
}

void ParticipantsPage::show_people(const std::vector<ParticipantOverview>& people) {
  all_ = people;
  const auto persons = std::count_if(
      all_.begin(), all_.end(), [](const ParticipantOverview& one) { return !one.row.is_virtual; });
  const auto virtual_ones = static_cast<long>(all_.size()) - persons;
  if (!chosen_) show_virtual_ = persons == 0 && virtual_ones > 0;
  people_->setText(tr("Human %1").arg(persons));
  virtual_people_->setText(tr("Virtual %1").arg(virtual_ones));
  // The chosen one is bold, and its words are wider then.
  const QFontMetrics bold(text_font(TextSize::body, true));
  for (QPushButton* button : {people_, virtual_people_}) {
    button->setMinimumWidth(bold.horizontalAdvance(button->text()) + 2 * kMargin);
  }
  std::vector<ParticipantRow> rows{};
  for (const ParticipantOverview& one : all_) rows.push_back(one.row);
  next_label_->setText(tr("Next suggested participant label: %1.")
                           .arg(QString::fromStdString(suggested_label(rows))));
  emit counted(persons == 0 && virtual_ones > 0 ? tr("%1 virtual").arg(virtual_ones)
                                                : QString::number(persons));
  show_empty(all_.empty());
  fill();
}

void ParticipantsPage::fill() {
  people_->setChecked(!show_virtual_);
  virtual_people_->setChecked(show_virtual_);
  std::vector<StudyTable::Row> rows{};
  for (const ParticipantOverview& one : all_) {
    if (one.row.is_virtual != show_virtual_) continue;
    const QString label = QString::fromStdString(one.row.label);
    QStandardItem* age = one.row.age_years
                             ? number_cell(QString::number(*one.row.age_years), *one.row.age_years)
                             : empty_number_cell();
    rows.push_back({label,
                    {text_cell(one.row.withdrawn ? tr("%1 (withdrawn)").arg(label) : label), age,
                     text_cell(or_dash(one.row.sex)), text_cell(or_dash(one.row.handedness)),
                     number_cell(one.completed), number_cell(one.unfinished),
                     one.last_session ? text_cell(text_of_start(*one.last_session),
                                                  order_of_start(*one.last_session))
                                      : text_cell("–")}});
  }
  table_->fill(rows);
}

void ParticipantsPage::show_selected() {
  const std::string label = table_->selected_key().toStdString();
  sessions_->setEnabled(!label.empty());
  withdraw_->setEnabled(!label.empty());
  const auto found =
      std::find_if(all_.begin(), all_.end(),
                   [&label](const ParticipantOverview& one) { return one.row.label == label; });
  answers_->setText(found == all_.end()
                        ? tr("Select a participant to see their answers and sessions.")
                        : text_of_answers(found->row.answers_json));
}

void ParticipantsPage::ask_to_withdraw() {
  try {
    (new WithdrawDialog(study(), table_->selected_key().toStdString(), this))->open();
  } catch (const std::exception& error) {
    banner().show_news(State::stop, words_of(phrase_of(error)));
  }
}

}  // namespace asperity

#include "moc_participants_page.cpp"
