// Implements the choice of a template and of its textures.

#include "app/gui/study/template_dialog.h"

#include <algorithm>
#include <exception>
#include <utility>
#include <variant>

#include <QtCore/QLocale>
#include <QtCore/QSignalBlocker>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QRadioButton>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QVBoxLayout>

#include "app/gui/base/form_words.h"
#include "app/gui/base/question_form.h"
#include "app/gui/base/shown_text.h"
#include "app/gui/base/study_table.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/participant/screen_preview.h"
#include "protocols/keys/tables.h"
#include "protocols/plan/course.h"
#include "protocols/plan/plan_parts.h"
#include "protocols/texts/protocol_texts.h"
#include "results_schema/error_text.h"

namespace asperity {

namespace {

constexpr QSize kSize{1120, 700};
constexpr int kTableWidth = 400;
constexpr int kFewestReliefs = 2;
constexpr int kMostReliefs = 10;
constexpr int kLeastRowHeight = 20;

QString trials_of(const TemplateOverview& overview) {
  return QString::number(overview.cost.trials);
}

QString minutes_of(const TemplateOverview& overview) {
  constexpr double kSecondsPerMinute = 60.0;
  return QString::number(qRound(overview.cost.total_s / kSecondsPerMinute));
}

}  // namespace

TemplateDialog::TemplateDialog(const std::filesystem::path& study, const ModelRegistry& models,
                               QWidget* parent)
    : QDialog(parent),
      study_(study),
      models_(models),
      height_fields_(std::make_shared<KeptHeightFields>()) {
  setObjectName("template_dialog");
  setWindowTitle(tr("New protocol from a template"));
  // A check that runs ends in the hidden dialog: its destructor would wait for it.
  connect(this, &QDialog::finished, this, [this] {
    connect(&work_, &NewestWork::settled, this, &QObject::deleteLater);
    if (!work_.is_busy()) deleteLater();
  });
  resize(parent == nullptr ? kSize : kSize.boundedTo(parent->window()->size()));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGroupGap, kGroupGap, kGroupGap, kGroupGap);
  layout->setSpacing(kMargin);
  layout->addWidget(make_heading(tr("New protocol from a template"), this));
  auto* columns = new QHBoxLayout();
  columns->setSpacing(kGroupGap);
  layout->addLayout(columns, 1);
  using Align = StudyTable::Align;
  table_ = new StudyTable({{tr("Experiment"), 0, Align::text},
                           {tr("Method"), 152, Align::text},
                           {tr("Trials"), 104, Align::number},
                           {tr("Minutes"), 72, Align::number}},
                          this);
  table_->setObjectName("template_table");
  table_->setAccessibleName(tr("Templates"));
  table_->wrap_texts();
  table_->leave_out_when_tight({1});  // which is next to it as well
  table_->setMinimumWidth(kTableWidth);
  columns->addWidget(table_, 1);
  columns->addWidget(make_detail(study), 1);

  auto* buttons = new QHBoxLayout();
  buttons->setSpacing(kGrid);
  what_follows_ = make_text(tr("The templates are being read."), this, true);
  what_follows_->setObjectName("template_what_follows");
  QPushButton* cancel = make_button(tr("Cancel"), ButtonRole::plain, this);
  create_ = make_button(tr("Create protocol"), ButtonRole::primary, this);
  create_->setObjectName("template_create");
  create_->setDefault(true);
  create_->setEnabled(false);
  buttons->addWidget(what_follows_, 1);
  buttons->addWidget(cancel);
  buttons->addWidget(create_);
  layout->addLayout(buttons);
  connect(table_, &StudyTable::row_selected, this, &TemplateDialog::show_chosen);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(create_, &QPushButton::clicked, this, [this] {
    emit wanted(choice_of(textures()));
    accept();
  });
  task_.run<Content>(
      [study, &models, language = QLocale().bcp47Name().section('-', 0, 0).toStdString()](
          const std::stop_token& stop, const BackgroundTask::Progress&) {
        return Content{template_overviews(models, language, stop), reliefs_of_study(study)};
      },
      [this](Content content) { show_content(std::move(content)); },
      [this](const QString& what) {
        what_follows_->setText(tr("The templates could not be read: %1").arg(what));
      });
}

/// Everything about the chosen template in one scroll area: what has to be chosen first, then what can be read.
QWidget* TemplateDialog::make_detail(const std::filesystem::path& study) {
  auto* scroll = new QScrollArea(this);
  scroll->setObjectName("template_details");
  scroll->setAccessibleName(tr("Description"));
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  auto* detail = new QWidget(scroll);
  auto* layout = new QVBoxLayout(detail);
  layout->setContentsMargins(0, 0, kGrid, 0);
  layout->setSpacing(kGrid);
  title_ = make_heading({}, detail);
  title_->setObjectName("template_title");
  title_->setWordWrap(true);
  facts_ = make_text({}, detail, true);
  facts_->setObjectName("template_facts");
  layout->addWidget(title_);
  layout->addWidget(facts_);
  layout->addWidget(make_texts());

  surfaces_ = new QWidget(detail);
  auto* surfaces = new QVBoxLayout(surfaces_);
  surfaces->setContentsMargins(0, 0, 0, 0);
  needs_ = make_text({}, surfaces_);
  needs_->setObjectName("template_needs");
  copied_ = new QRadioButton(tr("Textures of the template"), surfaces_);
  copied_->setObjectName("template_copied");
  own_ = new QRadioButton(tr("Textures of this study, in this order:"), surfaces_);
  own_->setObjectName("template_own");
  reliefs_ = new QListWidget(surfaces_);
  reliefs_->setObjectName("template_reliefs");
  reliefs_->setAccessibleName(tr("Textures of this study"));
  reliefs_->setDragDropMode(QAbstractItemView::InternalMove);
  state_ = new StateLabel(surfaces_);
  state_->setObjectName("template_state");
  state_->setWordWrap(true);
  for (QWidget* const widget :
       std::initializer_list<QWidget*>{needs_, copied_, own_, make_ticks(), reliefs_, state_}) {
    surfaces->addWidget(widget);
  }
  surfaces_->hide();
  layout->addWidget(surfaces_);

  screen_ = new ScreenPreview(study, detail);
  screen_->setObjectName("template_screen");
  screen_->hide();
  layout->addWidget(screen_);
  description_ = make_text({}, detail);
  description_->setObjectName("template_description");
  layout->addWidget(description_);
  layout->addStretch(1);
  scroll->setWidget(detail);
  connect(screen_, &ScreenPreview::step_wanted, this, [this](int step) {
    if (step < 0 || step >= std::ssize(plan_->steps)) return;
    screen_->show_step(protocol_, plan_, static_cast<std::size_t>(step));
  });
  for (QRadioButton* const button : {own_, copied_}) {
    connect(button, &QRadioButton::toggled, this, [this](bool is_chosen) {
      if (is_chosen) check_chosen();
    });
  }
  connect(reliefs_, &QListWidget::itemChanged, this, &TemplateDialog::check_chosen);
  connect(reliefs_->model(), &QAbstractItemModel::rowsMoved, this, &TemplateDialog::check_chosen);
  return scroll;
}

/// Ticks all textures of the study, or none.
QWidget* TemplateDialog::make_ticks() {
  ticks_ = new QWidget(surfaces_);
  auto* row = new QHBoxLayout(ticks_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kMargin);
  const auto add = [this, row](const QString& words, const char* name, Qt::CheckState state) {
    QPushButton* button = make_button(words, ButtonRole::link, ticks_);
    button->setObjectName(name);
    row->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, state] {
      const QSignalBlocker quiet(reliefs_);
      for (int i = 0; i < reliefs_->count(); ++i) reliefs_->item(i)->setCheckState(state);
      check_chosen();
    });
  };
  add(tr("All"), "template_all", Qt::Checked);
  add(tr("None"), "template_none", Qt::Unchecked);
  row->addStretch(1);
  return ticks_;
}

/// The title of the new protocol, and its language.
QWidget* TemplateDialog::make_texts() {
  texts_ = new QWidget(this);
  auto* fields = new QGridLayout(texts_);
  fields->setContentsMargins(0, 0, 0, 0);
  fields->setSpacing(kGrid);
  own_title_ = new QLineEdit(texts_);
  own_title_->setObjectName("template_own_title");
  own_title_->setMaxLength(
      static_cast<int>(std::get<TextShape>(kProtocolTable.find("title")->shape).longest));
  language_ = new ChoiceBox(texts_);
  language_->setObjectName("template_language");
  ignore_wheel(*language_);
  const auto add = [this, fields](const QString& name, QWidget* field) {
    QLabel* label = make_text(name, texts_);
    label->setBuddy(field);
    const int row = fields->rowCount();
    fields->addWidget(label, row, 0);
    fields->addWidget(field, row, 1);
  };
  add(tr("Title"), own_title_);
  add(tr("Language of the participants’ texts"), language_);
  fields->setColumnStretch(1, 1);
  texts_->hide();
  connect(own_title_, &QLineEdit::textEdited, this, [this](const QString& written) {
    own_titles_[chosen()->name] = written;
    show_what_follows();
  });
  connect(language_, &QComboBox::currentIndexChanged, this, [this] {
    show_texts();
    // It is another protocol, which can have other problems.
    if (own_->isChecked() || copied_->isChecked()) {
      check_chosen();
    } else {
      choose_textures();
    }
  });
  return texts_;
}

void TemplateDialog::show_content(Content content) {
  content_ = std::move(content);
  std::vector<StudyTable::Row> rows{};
  for (const TemplateOverview& overview : content_.templates) {
    rows.push_back({text(overview.name),
                    {text_cell(text(overview.protocols.front().title)),
                     text_cell(text_of_kind(overview.protocols.front().kind)),
                     number_cell(trials_of(overview), overview.cost.trials),
                     number_cell(minutes_of(overview), overview.cost.total_s)}});
  }
  for (const OwnTexture& relief : content_.reliefs) {
    auto* item = new QListWidgetItem(text(relief.name), reliefs_);
    item->setData(Qt::UserRole, reliefs_->count() - 1);
    item->setToolTip(text(relief.height_field));
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    item->setCheckState(Qt::Checked);
  }
  const int shown = std::clamp(reliefs_->count(), kFewestReliefs, kMostReliefs);
  reliefs_->setFixedHeight(shown * std::max(reliefs_->sizeHintForRow(0), kLeastRowHeight) +
                           2 * reliefs_->frameWidth());
  table_->fill(rows);
  show_chosen();
}

const TemplateOverview* TemplateDialog::chosen() const {
  for (const TemplateOverview& overview : content_.templates) {
    if (text(overview.name) == table_->selected_key()) return &overview;
  }
  return nullptr;
}

const Protocol& TemplateDialog::chosen_in_language() const {
  return chosen()->protocols[static_cast<std::size_t>(language_->currentIndex())];
}

void TemplateDialog::show_chosen() {
  const TemplateOverview* const overview = chosen();
  const bool has_textures = overview != nullptr && !overview->textures.names.empty();
  surfaces_->setVisible(has_textures);
  texts_->setVisible(overview != nullptr);
  if (overview != nullptr) {
    offer_languages(*overview);
    show_texts();
  }
  if (has_textures) {
    needs_->setText(tr("This template compares %n texture(s).", nullptr,
                       static_cast<int>(overview->textures.names.size())));
    copied_->setEnabled(overview->textures.are_of_demonstration);
    copied_->setToolTip(overview->textures.are_of_demonstration
                            ? QString()
                            : tr("These textures are photographs that are not part of Asperity."));
  }
  choose_textures();
}

/// "20 trials, about 12 min".
QString TemplateDialog::text_of_cost(const PlanCost& cost) {
  return tr("%n trial(s), about %1", nullptr, cost.trials).arg(text_of_duration(cost.total_s));
}

/// The method and the name. Where textures can be chosen, the line below them states the cost, so that nothing above them moves while
/// they are ticked; otherwise it is that of the template.
void TemplateDialog::show_facts(bool has_choice) {
  const TemplateOverview& overview = *chosen();
  QStringList facts{text_of_kind(overview.protocols.front().kind)};
  if (!has_choice) facts << text_of_cost(overview.cost);
  facts << text(overview.name);
  facts_->setText(facts.join(" · "));
}

/// The one that was chosen with another template stays.
void TemplateDialog::offer_languages(const TemplateOverview& overview) {
  const QSignalBlocker quiet(language_);
  const QVariant before = language_->currentData();
  language_->clear();
  for (const Protocol& protocol : overview.protocols) {
    language_->addItem(text_of_language(protocol.language), text(protocol.language));
  }
  language_->setCurrentIndex(std::max(language_->findData(before), 0));
}

/// The title, unless another one was written for this template, the description and the screens, in the language of the new
/// protocol.
void TemplateDialog::show_texts() {
  const Protocol& protocol = chosen_in_language();
  title_->setText(text(protocol.title));
  const auto written = own_titles_.find(chosen()->name);
  own_title_->setText(written == own_titles_.end() ? text(protocol.title) : written->second);
  own_title_->setCursorPosition(0);  // so that its beginning is shown
  description_->setText(text(protocol.description));
  show_screens(protocol);
}

/// Ticks as many textures of the study as the template has, with pictures where those of the template have some, and chooses these
/// or the template's: the first with which the protocol is valid. Until that is known none is chosen.
void TemplateDialog::choose_textures() {
  const TemplateOverview* const overview = chosen();
  std::vector<TemplateTextures> possible{};
  if (overview != nullptr && !overview->textures.names.empty()) {
    const QSignalBlocker quiet_reliefs(reliefs_);
    std::vector<QListWidgetItem*> items{};
    for (int i = 0; i < reliefs_->count(); ++i) items.push_back(reliefs_->item(i));
    if (overview->textures.have_pictures) {
      std::ranges::stable_partition(
          items, [this](const auto* item) { return !relief_of(*item).picture.empty(); });
    }
    for (std::size_t i = 0; i < items.size(); ++i) {
      const bool is_needed = i < overview->textures.names.size();
      items[i]->setCheckState(is_needed ? Qt::Checked : Qt::Unchecked);
    }
    own_->setEnabled(!content_.reliefs.empty());
    for (QRadioButton* const button : {own_, copied_}) {
      const QSignalBlocker quiet(button);
      button->setAutoExclusive(false);  // so that none is chosen
      button->setChecked(false);
      button->setAutoExclusive(true);
    }
    using From = TemplateTextures::From;
    if (own_->isEnabled()) possible.push_back({.from = From::study, .own = ticked()});
    if (copied_->isEnabled()) possible.push_back({.from = From::demonstration});
  }
  check(possible);
}

void TemplateDialog::check_chosen() {
  const TemplateTextures wanted = textures();
  using From = TemplateTextures::From;
  const bool can_be_checked =
      wanted.from == From::demonstration || (wanted.from == From::study && !wanted.own.empty());
  check(can_be_checked ? std::vector{wanted} : std::vector<TemplateTextures>{});
}

/// Checks the protocol with these textures, or with the next ones where it is not valid, and so on; shows the first ones where
/// it is valid with none.
void TemplateDialog::check(const std::vector<TemplateTextures>& possible) {
  const std::uint64_t number = ++shown_;
  is_refused_ = false;
  is_checking_ = !possible.empty();
  state_->setVisible(!possible.empty());
  show_what_follows();
  const bool has_choice = !surfaces_->isHidden() && (own_->isEnabled() || copied_->isEnabled());
  if (chosen() != nullptr) show_facts(has_choice);
  if (possible.empty()) return;
  state_->set_state(State::unknown, tr("Checking…"));
  std::vector<TemplateChoice> choices{};
  for (const TemplateTextures& textures : possible) choices.push_back(choice_of(textures));
  work_.ask(
      [this, number, choices = std::move(choices), study = study_, &models = models_,
       kept = height_fields_]() -> NewestWork::Delivery {
        std::vector<Checked> all{};
        for (const TemplateChoice& choice : choices) {
          all.push_back({.choice = choice});
          try {
            const CheckedTemplate made = check_of_template(study, choice, models, kept.get());
            all.back().check = made.check;
            const bool is_valid = made.check.diagnostics.empty();
            const auto& remarks = is_valid ? made.check.warnings : made.check.diagnostics;
            if (!remarks.empty()) {
              all.back().remark =
                  remark_in_form(nlohmann::json::parse(made.text, nullptr, false), remarks.front());
            }
          } catch (const std::exception& error) {
            all.back().refusal = message_of(error);
          }
          if (all.back().check.is_valid()) break;
        }
        kept->forget_unused();
        const Checked& first = all.back().check.is_valid() ? all.back() : all.front();
        return [this, number, first] {
          if (number == shown_) take(first);  // otherwise another choice is being checked
        };
      },
      [this, number](const QString& what) {
        if (number != shown_) return;
        is_checking_ = false;
        state_->set_state(State::unknown, what);
        show_what_follows();
      });
}

void TemplateDialog::take(const Checked& checked) {
  {
    QRadioButton* const button =
        checked.choice.textures.from == TemplateTextures::From::study ? own_ : copied_;
    const QSignalBlocker quiet_own(own_);
    const QSignalBlocker quiet_copied(copied_);
    button->setChecked(true);
  }
  is_checking_ = false;
  is_refused_ = !checked.refusal.empty();
  const std::vector<Diagnostic>& problems = checked.check.diagnostics;
  // The pictures of the template are not in the study yet, and a protocol with problems has no screens.
  const bool is_own = checked.choice.textures.from == TemplateTextures::From::study;
  show_screens(is_own && checked.check.protocol ? *checked.check.protocol : chosen_in_language());
  if (is_refused_) {
    state_->set_state(
        State::stop,
        tr("With these textures no protocol can be created: %1").arg(text(checked.refusal)));
  } else if (problems.empty()) {
    const QString valid =
        tr("With these textures the protocol is valid: %1.").arg(text_of_cost(checked.check.cost));
    if (checked.remark.isEmpty()) {
      state_->set_state(State::fine, valid);
    } else {
      state_->set_state(State::look, valid + ' ' + tr("Warning: %1").arg(checked.remark));
    }
  } else {
    const QString& what = checked.remark;
    state_->set_state(State::look,
                      problems.size() == 1
                          ? tr("With these textures the protocol has a problem: %1").arg(what)
                          : tr("With these textures the protocol has %1 problems, the first: %2")
                                .arg(QString::number(problems.size()), what));
  }
  show_what_follows();
}

/// Those of the first trial, and from there those of the other steps.
void TemplateDialog::show_screens(const Protocol& protocol) {
  protocol_ = std::make_shared<const Protocol>(protocol);
  plan_ = std::make_shared<const Plan>(as_read(*protocol_, example_plan(*protocol_, {1, 0})));
  screen_->show();
  screen_->show_step(protocol_, plan_, first_trial_step(*plan_));
}

TemplateChoice TemplateDialog::choice_of(const TemplateTextures& textures) const {
  return {.name = chosen()->name,
          .language = language_->currentData().toString().toStdString(),
          .title = own_title_->text().trimmed().toStdString(),
          .textures = textures};
}

TemplateTextures TemplateDialog::textures() const {
  using From = TemplateTextures::From;
  if (chosen() == nullptr || chosen()->textures.names.empty()) return {};
  if (copied_->isChecked()) return {.from = From::demonstration};
  return {.from = From::study, .own = ticked()};
}

const OwnTexture& TemplateDialog::relief_of(const QListWidgetItem& item) const {
  return content_.reliefs[item.data(Qt::UserRole).toULongLong()];
}

std::vector<OwnTexture> TemplateDialog::ticked() const {
  std::vector<OwnTexture> own{};
  for (int i = 0; i < reliefs_->count(); ++i) {
    const QListWidgetItem& item = *reliefs_->item(i);
    if (item.checkState() != Qt::Checked) continue;
    own.push_back(relief_of(item));
  }
  return own;
}

void TemplateDialog::show_what_follows() {
  const TemplateOverview* const overview = chosen();
  reliefs_->setEnabled(own_->isChecked());
  ticks_->setEnabled(own_->isChecked());
  const bool has_textures = overview != nullptr && !overview->textures.names.empty();
  const bool is_chosen = own_->isChecked() || copied_->isChecked();
  QString wrong{};
  if (overview == nullptr) {
    wrong = content_.templates.empty() ? what_follows_->text() : tr("Choose a template.");
  } else if (own_title_->text().trimmed().isEmpty()) {
    wrong = tr("Write a title.");
  } else if (has_textures && is_checking_) {
    wrong = tr("The textures are being checked.");
  } else if (has_textures && !is_chosen) {
    wrong =
        tr("Make textures in the workbench first: this template needs photographs or reliefs "
           "of the study.");
  } else if (has_textures && own_->isChecked() && ticked().empty()) {
    wrong = tr("Choose at least one texture.");
  } else if (has_textures && is_refused_) {
    wrong = tr("Choose other textures.");
  }
  create_->setEnabled(wrong.isEmpty());
  if (!wrong.isEmpty()) {
    what_follows_->setText(wrong);
  } else if (has_textures && copied_->isChecked()) {
    what_follows_->setText(
        tr("The textures are written into the study. The protocol can be changed afterwards."));
  } else if (has_textures) {
    what_follows_->setText(
        tr("Check that the title is true of these textures. The description, which is about those "
           "of the template, is not copied."));
  } else {
    what_follows_->setText(tr("The protocol can be changed afterwards."));
  }
}

}  // namespace asperity

#include "moc_template_dialog.cpp"
