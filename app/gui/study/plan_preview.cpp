#include "app/gui/study/plan_preview.h"

#include "app/gui/look/controls.h"
#include "app/gui/study/study_table.h"

namespace asperity {

namespace {

QString text(const std::string& utf8) { return QString::fromStdString(utf8); }

/// One step in a line of the table.
struct Line {
  QString trial{};
  QString block{};
  QString what{};
  QString answer{};
};

QString surfaces_of(const Trial& trial) {
  QStringList surfaces{};
  for (const PlannedPresentation& surface : trial.presentations) {
    surfaces.append(PlanPreview::tr("%1 %2").arg(text(surface.code), text(surface.item)));
  }
  return surfaces.join(", ");
}

Line line_of(const Trial& trial) {
  QStringList right{};
  for (const std::string& answer : trial.question.correct) right.append(text(answer));
  return {QString::number(trial.ordinal), text(trial.block), surfaces_of(trial), right.join(", ")};
}

Line line_of(const PlanStep& step, const Plan& plan) {
  if (const auto* trial = std::get_if<TrialStep>(&step)) return line_of(plan.trials[trial->trial]);
  if (const auto* screen = std::get_if<Protocol::Screen>(&step)) {
    return {{}, PlanPreview::tr("screen"), text(screen->text), {}};
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
    questions.append(text(name));
  }
  return {{}, PlanPreview::tr("questions"), questions.join(", "), {}};
}

}  // namespace

PlanPreview::PlanPreview(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  auto* row = new QHBoxLayout();
  words_ = make_text({}, this, true);
  words_->setObjectName("plan_words");
  QPushButton* another = make_button(tr("Another example"), ButtonRole::link, this);
  another->setObjectName("plan_another");
  row->addWidget(words_, 1);
  row->addWidget(another);
  layout->addLayout(row);
  using Align = StudyTable::Align;
  table_ = new StudyTable({{tr("Step"), 80, Align::number},
                           {tr("Trial"), 72, Align::number},
                           {tr("Block"), 144, Align::text},
                           {tr("Surfaces in order"), 0, Align::text},
                           {tr("Right answer"), 208, Align::text}},
                          this);
  table_->setObjectName("plan_table");
  layout->addWidget(table_, 1);
  connect(another, &QPushButton::clicked, this, [this] {
    ++seed_;
    make_example();
  });
}

void PlanPreview::show_protocol(const Protocol& protocol) {
  protocol_ = std::make_shared<const Protocol>(protocol);
  make_example();
}

void PlanPreview::make_example() {
  task_.run<Plan>(
      [protocol = protocol_, seed = seed_](const std::stop_token&,
                                           const BackgroundTask::Progress&) {
        return make_plan(*protocol,
                         {seed, static_cast<int>(seed - 1) % counterbalance_rows(*protocol)});
      },
      [this](const Plan& plan) {
        words_->setText(
            tr("Example %1: what is random is drawn anew for every session.").arg(seed_));
        std::vector<StudyTable::Row> rows{};
        for (std::size_t i = 0; i < plan.steps.size(); ++i) {
          const Line line = line_of(plan.steps[i], plan);
          QStandardItem* trial = line.trial.isEmpty()
                                     ? number_cell({}, -1.0)
                                     : number_cell(line.trial, line.trial.toDouble());
          rows.push_back({QString::number(i),
                          {number_cell(static_cast<int>(i) + 1), trial, text_cell(line.block),
                           text_cell(line.what), text_cell(line.answer)}});
        }
        table_->fill(rows);
      },
      [this](const QString& what) { words_->setText(what); });
}

}  // namespace asperity
