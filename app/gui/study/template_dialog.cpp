// Implements the choice of a template and of its textures.

#include "app/gui/study/template_dialog.h"

#include <algorithm>
#include <utility>
#include <variant>

#include <QtCore/QLocale>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QRadioButton>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QVBoxLayout>

#include "app/gui/base/shown_text.h"
#include "app/gui/base/study_table.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/participant/screen_preview.h"
#include "protocols/plan/course.h"
#include "protocols/texts/protocol_texts.h"

namespace asperity {

namespace {

constexpr QSize kSize{1120, 700};
constexpr int kTableWidth = 400;
constexpr int kReliefsHeight = 120;

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
    : QDialog(parent) {
  setObjectName("template_dialog");
  setWindowTitle(tr("New protocol from a template"));
  setAttribute(Qt::WA_DeleteOnClose);
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
                           {tr("Trials"), 64, Align::number},
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
    emit wanted(chosen()->name, textures());
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
  layout->addWidget(title_);
  layout->addWidget(facts_);

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
  reliefs_->setFixedHeight(kReliefsHeight);
  for (QWidget* const widget : std::initializer_list<QWidget*>{needs_, copied_, own_, reliefs_}) {
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
  connect(own_, &QRadioButton::toggled, this, &TemplateDialog::show_what_follows);
  connect(reliefs_, &QListWidget::itemChanged, this, &TemplateDialog::show_what_follows);
  return scroll;
}

void TemplateDialog::show_content(Content content) {
  content_ = std::move(content);
  std::vector<StudyTable::Row> rows{};
  for (const TemplateOverview& overview : content_.templates) {
    rows.push_back(
        {text(overview.name),
         {text_cell(text(overview.protocol.title)), text_cell(text_of_kind(overview.protocol.kind)),
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
  table_->fill(rows);
  show_chosen();
}

const TemplateOverview* TemplateDialog::chosen() const {
  for (const TemplateOverview& overview : content_.templates) {
    if (text(overview.name) == table_->selected_key()) return &overview;
  }
  return nullptr;
}

void TemplateDialog::show_chosen() {
  const TemplateOverview* const overview = chosen();
  const bool has_textures = overview != nullptr && !overview->textures.names.empty();
  surfaces_->setVisible(has_textures);
  if (overview != nullptr) {
    title_->setText(text(overview->protocol.title));
    const QString trials = tr("%n trial(s)", nullptr, overview->cost.trials);
    facts_->setText(QStringList{text_of_kind(overview->protocol.kind), trials,
                                tr("about %1").arg(text_of_duration(overview->cost.total_s)),
                                text(overview->name)}
                        .join(" · "));
    description_->setText(text(overview->protocol.description));
    show_screens(*overview);
  }
  if (has_textures) {
    needs_->setText(tr("This template compares %n texture(s).", nullptr,
                       static_cast<int>(overview->textures.names.size())));
    copied_->setEnabled(overview->textures.are_of_demonstration);
    copied_->setToolTip(overview->textures.are_of_demonstration
                            ? QString()
                            : tr("These textures are photographs that are not part of Asperity."));
    const auto count = static_cast<int>(overview->textures.names.size());
    for (int i = 0; i < reliefs_->count(); ++i) {
      reliefs_->item(i)->setCheckState(i < count ? Qt::Checked : Qt::Unchecked);
    }
    own_->setEnabled(!content_.reliefs.empty());
    for (QRadioButton* const button : {own_, copied_}) {
      button->setAutoExclusive(false);  // so that none is chosen where none is possible
      button->setChecked(false);
      button->setAutoExclusive(true);
    }
    if (own_->isEnabled()) {
      own_->setChecked(true);
    } else if (copied_->isEnabled()) {
      copied_->setChecked(true);
    }
  }
  show_what_follows();
}

/// Those of the first trial, and from there those of the other steps.
void TemplateDialog::show_screens(const TemplateOverview& overview) {
  protocol_ = std::make_shared<const Protocol>(overview.protocol);
  plan_ = std::make_shared<const Plan>(as_read(*protocol_, example_plan(*protocol_, {1, 0})));
  const auto first =
      std::find_if(plan_->steps.begin(), plan_->steps.end(),
                   [](const PlanStep& step) { return std::holds_alternative<TrialStep>(step); });
  screen_->show();
  screen_->show_step(protocol_, plan_, static_cast<std::size_t>(first - plan_->steps.begin()));
}

TemplateTextures TemplateDialog::textures() const {
  using From = TemplateTextures::From;
  if (chosen() == nullptr || chosen()->textures.names.empty()) return {};
  if (copied_->isChecked()) return {.from = From::demonstration};
  TemplateTextures textures{.from = From::study};
  for (int i = 0; i < reliefs_->count(); ++i) {
    const QListWidgetItem& item = *reliefs_->item(i);
    if (item.checkState() != Qt::Checked) continue;
    textures.own.push_back(content_.reliefs[item.data(Qt::UserRole).toULongLong()]);
  }
  return textures;
}

void TemplateDialog::show_what_follows() {
  const TemplateOverview* const overview = chosen();
  reliefs_->setEnabled(own_->isChecked());
  QString wrong{};
  if (overview == nullptr) {
    wrong = content_.templates.empty() ? what_follows_->text() : tr("Choose a template.");
  } else if (!overview->textures.names.empty() && !own_->isChecked() && !copied_->isChecked()) {
    wrong =
        tr("Make textures in the workbench first: this template needs photographs or reliefs "
           "of the study.");
  } else if (own_->isChecked() && surfaces_->isVisibleTo(this) && textures().own.empty()) {
    wrong = tr("Choose at least one texture.");
  }
  create_->setEnabled(wrong.isEmpty());
  if (!wrong.isEmpty()) {
    what_follows_->setText(wrong);
  } else if (copied_->isChecked()) {
    what_follows_->setText(
        tr("The textures are written into the study. The protocol can be changed afterwards."));
  } else {
    what_follows_->setText(tr("The protocol can be changed afterwards, also its textures."));
  }
}

}  // namespace asperity

#include "moc_template_dialog.cpp"
