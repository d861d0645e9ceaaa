// Makes the plan for the chosen seed, row and group, and lists its steps and its cost.

#include "app/gui/plan/plan_preview.h"

#include <algorithm>
#include <limits>
#include <span>

#include <QtCore/QSignalBlocker>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QSpinBox>
#include <QtWidgets/QSplitter>

#include "app/gui/base/shown_text.h"
#include "app/gui/base/study_table.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/look/wrapping_row.h"
#include "app/gui/plan/plan_bars.h"
#include "protocols/plan/course.h"
#include "protocols/plan/groups.h"
#include "protocols/plan/plan_parts.h"
#include "protocols/texts/protocol_texts.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

constexpr int kMostGroupWidth = 280;

/// One step in a line of the table.
struct Line {
  QString trial{};
  QString block{};
  QString what{};
  QString answer{};
};

/// "if pain = yes: "; empty without a condition.
QString if_text(const std::optional<AnswerCondition>& condition) {
  if (!condition) return {};
  return PlanPreview::tr("if %1:").arg(text(signs_of(*condition))) + ' ';
}

/// "only haptic: "; empty for all participants.
QString groups_text(const std::vector<std::string>& groups) {
  if (groups.empty()) return {};
  QStringList names{};
  for (const std::string& group : groups) names.append(text(group));
  return PlanPreview::tr("only %1:").arg(names.join(", ")) + ' ';
}

QString surfaces_text(const Trial& trial) {
  QStringList surfaces{};
  for (const PlannedPresentation& surface : trial.presentations) {
    surfaces.append(PlanPreview::tr("%1 %2").arg(text(surface.code), text(surface.item)));
  }
  return surfaces.join(", ");
}

Line line_of(const Trial& trial) {
  QStringList right{};
  for (const Question& question : trial.questions) {
    for (const std::string& answer : question.correct) right.append(text(answer));
  }
  return {QString::number(trial.ordinal), text(trial.block), surfaces_text(trial),
          right.join(", ")};
}

Line line_of(const PlanStep& step, const Plan& plan, const Protocol& protocol) {
  if (const auto* trial = std::get_if<TrialStep>(&step)) return line_of(plan.trials[trial->trial]);
  if (const auto* screen = std::get_if<Protocol::Screen>(&step)) {
    return {{},
            PlanPreview::tr("screen"),
            groups_text(screen->groups) + if_text(screen->condition) + text(screen->text),
            {}};
  }
  if (const auto* check = std::get_if<Protocol::Check>(&step)) {
    const bool zero = check->what == Protocol::Check::What::force_zero;
    return {{},
            PlanPreview::tr("check"),
            zero ? PlanPreview::tr("the force at rest") : PlanPreview::tr("the device"),
            {}};
  }
  if (const auto* pause = std::get_if<Protocol::Break>(&step)) {
    return {{},
            PlanPreview::tr("break"),
            PlanPreview::tr("at least %1 s: %2").arg(pause->minimum_s).arg(text(pause->text)),
            {}};
  }
  QStringList questions{};
  for (const std::string& name : std::get<Protocol::Ask>(step).questions) {
    questions.append(if_text(protocol.questions.at(name).condition) + text(name));
  }
  return {{}, PlanPreview::tr("questions"), questions.join(", "), {}};
}

QString html_line(const QString& what, const QString& words) {
  return words.isEmpty()
             ? QString{}
             : QString("<p><b>%1</b><br>%2</p>").arg(what.toHtmlEscaped(), words.toHtmlEscaped());
}

QString factors_of(const Trial& trial) {
  QStringList factors{};
  for (const auto& [name, level] : trial.factors) {
    const auto* const number = std::get_if<double>(&level);
    factors.append(number != nullptr
                       ? text_of_level(name, *number)
                       : PlanPreview::tr("%1: %2").arg(text(name), text(text_of(level))));
  }
  return factors.join(" · ");
}

/// "A: height_map of metal, stiffness 500 N/m"
QString surface_in_full(const PlannedPresentation& surface) {
  const StimulusDescription& stimulus = surface.stimulus;
  QString words = stimulus.texture.empty()
                      ? PlanPreview::tr("%1: %2").arg(text(surface.code), text(stimulus.model))
                      : PlanPreview::tr("%1: %2 of %3")
                            .arg(text(surface.code), text(stimulus.model), text(stimulus.texture));
  for (const auto& [name, value] : stimulus.parameters) {
    const auto* const number = std::get_if<double>(&value);
    words += ", " + (number != nullptr ? text_of_level(name, *number)
                                       : text(name) + ' ' + text(std::get<std::string>(value)));
  }
  return words;
}

QString text_of_anchor(AnchorPlace place) {
  switch (place) {
    case AnchorPlace::start:
      return PlanPreview::tr("anchor at the start");
    case AnchorPlace::middle:
      return PlanPreview::tr("anchor in the middle");
    case AnchorPlace::end:
      break;
  }
  return PlanPreview::tr("anchor at the end");
}

/// "repetition 2", "track 1, step 7".
QString place_in_block(const Trial& trial) {
  if (trial.catch_trial) return PlanPreview::tr("catch trial");
  if (trial.track) {
    return PlanPreview::tr("track %1, step %2").arg(trial.track->track).arg(trial.track->step);
  }
  if (trial.anchor) return text_of_anchor(*trial.anchor);
  return PlanPreview::tr("repetition %1").arg(trial.repetition);
}

QString in_full(const Trial& trial) {
  QStringList surfaces{};
  for (const PlannedPresentation& surface : trial.presentations) {
    surfaces.append(surface_in_full(surface));
  }
  QString questions{};
  for (const Question& question : trial.questions) {
    QStringList options{};
    for (const Option& option : question.options) {
      options.append(option.label.empty()
                         ? text(option.value)
                         : PlanPreview::tr("%1: %2").arg(text(option.label), text(option.value)));
    }
    questions += html_line(PlanPreview::tr("Question"), text(question.prompt)) +
                 html_line(PlanPreview::tr("Options as shown"), options.join(" · "));
  }
  const QString head = PlanPreview::tr("Trial %1, %2, %3")
                           .arg(trial.ordinal)
                           .arg(text(trial.block), place_in_block(trial));
  return QString("<p><b>%1</b></p>").arg(head.toHtmlEscaped()) +
         html_line(PlanPreview::tr("Factors"), factors_of(trial)) +
         html_line(PlanPreview::tr("Surfaces in order"), surfaces.join(" · ")) + questions +
         html_line(PlanPreview::tr("Correct response"), line_of(trial).answer);
}

QString in_full(const PlanStep& step, const Plan& plan, const Protocol& protocol) {
  if (const auto* trial = std::get_if<TrialStep>(&step)) return in_full(plan.trials[trial->trial]);
  const Line line = line_of(step, plan, protocol);
  return html_line(line.block, line.what);
}

/// "48 trials · 48 contacts · about 42 min · at most 12 min without a break"
QString cost_in_words(const PlanCost& cost, std::span<const PlannedRun> runs, const Plan& plan) {
  QStringList facts{text_of_trials(runs),
                    cost.contacts == 1 ? PlanPreview::tr("1 contact")
                                       : PlanPreview::tr("%1 contacts").arg(cost.contacts),
                    PlanPreview::tr("about %1").arg(text_of_duration(cost.total_s)),
                    PlanPreview::tr("at most %1 without a break")
                        .arg(text_of_duration(cost.longest_without_break_s))};
  if (std::any_of(plan.trials.begin(), plan.trials.end(),
                  [](const Trial& trial) { return trial.track.has_value(); })) {
    facts.prepend(PlanPreview::tr("example of a session, whose levels depend on the responses"));
  }
  return facts.join(" · ");
}

}  // namespace

PlanPreview::PlanPreview(Shape shape, QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  auto* head = new QHBoxLayout();
  head->setSpacing(2 * kGrid);
  layout->addLayout(head);
  auto* choice = new WrappingRow(nullptr, kGrid);
  add_choice(*choice);
  words_ = make_text({}, this, true);
  words_->setObjectName("plan_words");
  if (shape == Shape::wide) {
    head->addLayout(choice);
    head->addWidget(words_, 1);
  } else {
    head->addLayout(choice, 1);
    layout->addWidget(words_);
  }
  QPushButton* another = make_button(tr("Another order"), ButtonRole::link, this);
  another->setObjectName("plan_another");
  head->addWidget(another, 0, Qt::AlignTop);
  connect(another, &QPushButton::clicked, this, [this] { seed_->setValue(seed_->value() + 1); });
  using Align = StudyTable::Align;
  if (shape == Shape::wide) {
    table_ = new StudyTable({{tr("Step"), 80, Align::number},
                             {tr("Trial"), 72, Align::number},
                             {tr("Block"), 144, Align::text},
                             {tr("Surfaces in order"), 0, Align::text},
                             {tr("Correct response"), 208, Align::text}},
                            this);
    layout->addWidget(table_, 1);
  } else {
    QSplitter* splitter = make_splitter(Qt::Vertical, this, kGrid);
    table_ = new StudyTable({{tr("Step"), 56, Align::number},
                             {tr("Trial"), 56, Align::number},
                             {tr("Block"), 96, Align::text},
                             {tr("Surfaces"), 0, Align::text}},
                            splitter);
    const QFont small = text_font(TextSize::small);
    words_->setFont(small);
    table_->setFont(small);
    table_->horizontalHeader()->setFont(small);
    table_->verticalHeader()->setDefaultSectionSize(3 * kGrid);
    bars_ = new PlanBars(this);
    layout->addWidget(bars_);
    connect(bars_, &PlanBars::step_wanted, this, &PlanPreview::select_step);
    auto* scroll = new QScrollArea(splitter);
    scroll->setAccessibleName(tr("Selected step"));
    scroll->setWidgetResizable(true);
    scroll->viewport()->setAutoFillBackground(false);
    detail_ = make_text({}, scroll);
    detail_->setObjectName("plan_detail");
    detail_->setFont(small);
    detail_->setTextFormat(Qt::RichText);
    detail_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    scroll->setWidget(detail_);
    detail_->setAutoFillBackground(false);  // setWidget turns it on
    splitter->addWidget(table_);
    splitter->addWidget(scroll);
    splitter->setStretchFactor(0, 1);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({320, 240});
    layout->addWidget(splitter, 1);
    connect(table_, &StudyTable::row_selected, this, [this](const QString& key) {
      if (!key.isEmpty()) show_step(key.toInt());
    });
  }
  table_->setObjectName("plan_table");
  table_->setAccessibleName(tr("Generated trial list"));
  table_->setTextElideMode(Qt::ElideRight);                  // sentences
  table_->horizontalHeader()->setSortIndicatorShown(false);  // the order of the session is plain
}

void PlanPreview::add_choice(QLayout& row) {
  const auto add = [&](const QString& name, const char* object, int least, int most) {
    auto* spin = new QSpinBox(this);
    spin->setObjectName(object);
    spin->setRange(least, most);
    spin->setPrefix(name + ' ');
    spin->setAccessibleName(name);
    spin->setFixedWidth(88 + spin->fontMetrics().horizontalAdvance(name));
    row.addWidget(spin);
    connect(spin, &QSpinBox::valueChanged, this, &PlanPreview::make_plan_anew);
    return spin;
  };
  seed_ = add(tr("Seed"), "plan_seed", 0, std::numeric_limits<int>::max());
  seed_->setValue(1);
  seed_->setToolTip(tr("Random orders are drawn separately for every session."));
  row_ = add(tr("Row"), "plan_row", 1, 1);
  row_->setToolTip(
      tr("Counterbalancing row: each new participant is assigned the least used one."));
  group_ = make_group_box(this);
  group_->setObjectName("plan_group");
  row.addWidget(group_);
  connect(group_, &QComboBox::currentIndexChanged, this, [this] {
    show_group();
    make_plan_anew();
  });
}

QComboBox* PlanPreview::make_group_box(QWidget* parent) {
  auto* const box = new ChoiceBox(parent);
  // The names of groups are those of another protocol after a while.
  box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  box->setMaximumWidth(kMostGroupWidth);
  box->setAccessibleName(tr("Group"));
  box->setToolTip(tr("Group of the participant"));
  box->hide();
  return box;
}

QComboBox* PlanPreview::make_group_choice(QWidget* parent) {
  other_group_ = make_group_box(parent);
  other_group_->setObjectName("screen_group");
  other_group_->setModel(group_->model());
  connect(other_group_, &QComboBox::activated, group_, &QComboBox::setCurrentIndex);
  return other_group_;
}

void PlanPreview::show_group() {
  group_->setVisible(group_->count() > 0);
  if (other_group_ == nullptr) return;
  other_group_->setCurrentIndex(group_->currentIndex());
  other_group_->setVisible(group_->count() > 0);
}

Allocation PlanPreview::allocation() const {
  return {.seed = static_cast<std::uint64_t>(seed_->value()),
          .counterbalance_row = row_->value() - 1,
          .group = group_->currentText().toStdString()};
}

PlanPreview::Choice PlanPreview::choice() const {
  return resumed_.value_or(Choice{allocation(), table_->selected_key()});
}

void PlanPreview::show_protocol(const Protocol& protocol) {
  protocol_ = std::make_shared<const Protocol>(protocol);
  const int rows = counterbalance_rows(protocol);
  {
    const QSignalBlocker quiet(row_);
    const QSignalBlocker quiet_seed(seed_);
    row_->setMaximum(rows);
    if (resumed_) {
      row_->setValue(resumed_->allocation.counterbalance_row + 1);
      seed_->setValue(static_cast<int>(resumed_->allocation.seed));
    }
  }
  row_->setVisible(rows > 1);  // else nothing is counterbalanced
  row_->setSuffix(' ' + tr("of %1").arg(rows));
  const std::vector<std::string> groups = groups_of(protocol);
  {
    const QSignalBlocker quiet(group_);
    const QString before =
        resumed_ ? QString::fromStdString(resumed_->allocation.group) : group_->currentText();
    const int index_before =
        group_->count() == static_cast<int>(groups.size()) ? group_->currentIndex() : -1;
    group_->clear();
    for (const std::string& group : groups) group_->addItem(QString::fromStdString(group));
    int index = group_->findText(before);
    if (index < 0) index = index_before;  // it has another name
    group_->setCurrentIndex(std::max(index, groups.empty() ? -1 : 0));
  }
  show_group();
  make_plan_anew();
}

void PlanPreview::forget() {
  protocol_ = nullptr;
  words_->setText(tr("The plan is being made…"));
  table_->fill({});
  if (bars_ != nullptr) bars_->show_parts({}, {});
  if (detail_ != nullptr) detail_->clear();
}

void PlanPreview::make_plan_anew() {
  if (protocol_ == nullptr) return;
  work_.ask(
      [this, protocol = protocol_, allocation = allocation()]() -> NewestWork::Delivery {
        auto plan = std::make_shared<Plan>(example_plan(*protocol, allocation));
        const PlanCost cost = cost_of(*protocol, *plan);
        const std::vector<PlanPart> parts = parts_of(*protocol, *plan);
        const std::vector<PlannedRun> runs = runs_in(*protocol, parts);
        *plan = as_read(*protocol, std::move(*plan));
        return [this, protocol, plan, cost, parts, runs] {
          if (protocol != protocol_) return;
          planned_ = protocol;
          plan_ = plan;
          words_->setText(cost_in_words(cost, runs, *plan));
          if (bars_ != nullptr) bars_->show_parts(parts, runs);
          show_plan();
        };
      },
      [this](const QString& what) { words_->setText(what); });
}

void PlanPreview::show_plan() {
  std::vector<StudyTable::Row> rows{};
  for (std::size_t i = 0; i < plan_->steps.size(); ++i) {
    const Line line = line_of(plan_->steps[i], *plan_, *planned_);
    QStandardItem* trial = line.trial.isEmpty() ? number_cell({}, -1.0)
                                                : number_cell(line.trial, line.trial.toDouble());
    QList<QStandardItem*> cells{number_cell(static_cast<int>(i) + 1), trial, text_cell(line.block),
                                text_cell(line.what)};
    if (detail_ == nullptr) cells.append(text_cell(line.answer));
    rows.push_back({QString::number(i), cells});
  }
  table_->fill(rows);
  if (resumed_) table_->select(resumed_->step);
  resumed_.reset();
  if (detail_ == nullptr) return;
  if (table_->selected_key().isEmpty()) select_step(static_cast<int>(first_trial_step(*plan_)));
}

void PlanPreview::select_step(int step) { table_->select(QString::number(step)); }

void PlanPreview::show_step(int step) {
  if (detail_ == nullptr || static_cast<std::size_t>(step) >= plan_->steps.size()) return;
  detail_->setText(in_full(plan_->steps[static_cast<std::size_t>(step)], *plan_, *planned_));
  emit step_shown(planned_, plan_, step);
}

}  // namespace asperity

#include "moc_plan_preview.cpp"
