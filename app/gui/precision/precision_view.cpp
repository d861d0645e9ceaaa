// Simulates studies in portions of a second, each on a copy of the studies before, and shows the figures after each portion.

#include "app/gui/precision/precision_view.h"

#include <algorithm>
#include <any>
#include <chrono>
#include <cstddef>
#include <utility>

#include <QtCore/QSignalBlocker>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QSpinBox>
#include <QtWidgets/QSplitter>

#include "analysis/power/recruitment.h"
#include "app/gui/base/command_lines.h"
#include "app/gui/base/settings.h"
#include "app/gui/base/study_table.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/precision/assumption_fields.h"
#include "app/power/power_model.h"
#include "app/words/phrase_of_error.h"

namespace asperity {

namespace {

constexpr const char* kLeftPrecision = "precision";
constexpr const char* kStatedInEditor = "stated in the editor";
constexpr int kUsualParticipants = 20;  // of a protocol that plans no number
constexpr int kMostParticipants = 1000;
constexpr int kInputPause_ms = 400;  // longer than between two keys
constexpr std::chrono::milliseconds kPortion{1000};

QString figure_name(PrecisionFigure::What what) {
  switch (what) {
    case PrecisionFigure::What::power:
      return PrecisionView::tr("Power");
    case PrecisionFigure::What::median_width:
      return PrecisionView::tr("Width of the 95 % CI, median");
    case PrecisionFigure::What::p90_width:
      return PrecisionView::tr("Width of the 95 % CI, 90th percentile");
    case PrecisionFigure::What::standard_error:
      return PrecisionView::tr("Standard error");
  }
  return {};
}

/// "37.5 % [22.7, 54.2]"; without a value why there is none yet.
QString figure_text(const PrecisionFigure& figure, NumberShape shape, QString unit) {
  if (!figure.value || !figure.interval) return PrecisionView::tr("too few studies so far");
  if (figure.what == PrecisionFigure::What::power) {
    shape = {.display = {.unit = "%", .power = -2}};
    unit = "%";
  }
  const QString value = rounded_in_unit(*figure.value, shape);
  return PrecisionView::tr("%1 [%2, %3]")
      .arg(unit.isEmpty() ? value : value + ' ' + unit,
           rounded_in_unit(figure.interval->low, shape),
           rounded_in_unit(figure.interval->high, shape));
}

QString name_of(const PrecisionOf& result) {
  if (result.family.empty()) return assumption_caption(result.name);
  if (result.name.empty()) {
    return PrecisionView::tr("at least one of: %1").arg(text(result.family));
  }
  const QString name = result.measure.empty() ? text(result.name)
                                              : PrecisionView::tr("%1 (%2)").arg(
                                                    text(result.name), text(result.measure));
  if (result.without_p == 0 || result.statuses.empty()) return name;
  return PrecisionView::tr("%1; without p in %2: %3")
      .arg(name)
      .arg(result.without_p)
      .arg(text(result.statuses.front()));
}

}  // namespace

/// What is read from a protocol before its studies can be simulated.
struct PrecisionView::Design {
  std::vector<Assumption> usual{};
  int round = 1;
  int planned = 0;  ///< participants; 0: not stated
  QString refusal{};
};

PrecisionView::PrecisionView(OpenStudy& study, QWidget* parent)
    : QWidget(parent), study_(study), left_to_(&study) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  auto* row = new QHBoxLayout();
  row->setSpacing(kGrid);
  participants_ = new QSpinBox(this);
  participants_->setObjectName("precision_participants");
  participants_->setRange(1, kMostParticipants);
  participants_->setValue(kUsualParticipants);
  participants_->setPrefix(tr("Participants") + ' ');
  participants_->setAccessibleName(tr("Participants"));
  participants_->setKeyboardTracking(false);
  round_ = make_text({}, this, true);
  round_->setObjectName("precision_round");
  QPushButton* shown_commands = make_commands_button([this] { return commands(); }, this);
  row->addWidget(participants_);
  row->addWidget(round_, 1);
  row->addWidget(shown_commands);
  layout->addLayout(row);
  state_ = new StateLabel(this);
  state_->setObjectName("precision_state");
  state_->setWordWrap(true);
  layout->addWidget(state_);
  QSplitter* splitter = make_splitter(Qt::Vertical, this, kGrid);
  scroll_ = new QScrollArea(splitter);
  scroll_->setAccessibleName(tr("Assumptions"));
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->viewport()->setAutoFillBackground(false);
  fields_ = new AssumptionFields(scroll_);
  scroll_->setWidget(fields_);
  fields_->setAutoFillBackground(false);  // setWidget turns it on
  table_ = new StudyTable({{tr("Quantity"), 0, StudyTable::Align::text},
                           {tr("Value [95 % Monte-Carlo CI]"), 168, StudyTable::Align::text}},
                          splitter);
  table_->setObjectName("precision_table");
  table_->setAccessibleName(tr("Precision"));
  table_->setFont(text_font(TextSize::small));
  table_->horizontalHeader()->setFont(text_font(TextSize::small));
  table_->horizontalHeader()->setSortIndicatorShown(false);  // the order of the analysis
  table_->wrap_texts();
  splitter->addWidget(scroll_);
  splitter->addWidget(table_);
  splitter->setStretchFactor(0, 1);
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({240, 240});
  layout->addWidget(splitter, 1);
  pause_.setSingleShot(true);
  pause_.setInterval(kInputPause_ms);
  connect(&pause_, &QTimer::timeout, this, &PrecisionView::proceed);
  connect(participants_, &QSpinBox::valueChanged, this, &PrecisionView::take_inputs);
  connect(fields_, &AssumptionFields::edited, this, &PrecisionView::take_inputs);
  connect(&study_.examiner(), &StimulusExaminer::held_changed, this, &PrecisionView::proceed);
  const std::any before = study_.take_left(kLeftPrecision);
  if (const auto* left = std::any_cast<std::map<std::string, Inputs>>(&before)) inputs_ = *left;
}

PrecisionView::~PrecisionView() {
  // At the end of the program the study may be gone first.
  if (left_to_ != nullptr) left_to_->leave(kLeftPrecision, inputs_);
}

void PrecisionView::show_protocol(const std::filesystem::path& file,
                                  std::shared_ptr<const Protocol> protocol) {
  const bool is_same =
      protocol_ != nullptr && file == file_ && protocol->source == protocol_->source;
  has_new_text_ = false;
  if (!is_same) {
    file_ = file;
    protocol_ = std::move(protocol);
    is_read_ = false;
    reading_.abandon();
    restart();  // the design is read after a pause: the text may be changed again
    return;
  }
  if (isVisible()) proceed();
}

void PrecisionView::hold_for_new_text() {
  has_new_text_ = true;
  pause_.stop();
  simulation_.abandon();
}

void PrecisionView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  proceed();
}

void PrecisionView::hideEvent(QHideEvent* event) {
  pause_.stop();
  simulation_.abandon();
  QWidget::hideEvent(event);
}

void PrecisionView::read_design() {
  if (reading_.is_running()) return;
  reading_.run<Design>(
      [protocol = protocol_](const std::stop_token&, const BackgroundTask::Progress&) {
        Design design{.round = participants_per_round(*protocol),
                      .planned = protocol->planned_participants};
        try {
          design.usual = assumptions_of(*protocol);
        } catch (const std::exception& error) {
          design.refusal = words_of(phrase_of(error));
        }
        return design;
      },
      [this](const Design& design) { show_design(design); },
      [this](const QString& what) { show_design({.refusal = what}); });
}

void PrecisionView::show_design(const Design& design) {
  is_read_ = true;
  usual_ = design.usual;
  refusal_ = design.refusal;
  const auto round = static_cast<std::size_t>(design.round);
  {
    const QSignalBlocker quiet(participants_);
    participants_->setSingleStep(std::max(1, std::min(design.round, kMostParticipants)));
    const int chosen = inputs().participants;
    const int usual = design.planned > 0 ? design.planned : kUsualParticipants;
    participants_->setValue(chosen > 0 ? chosen
                                       : static_cast<int>(rounded_up_to_multiple(
                                             static_cast<std::size_t>(usual), round)));
  }
  round_->setText(design.round > 1 ? tr("rounds of %1").arg(design.round) : QString());
  round_->setToolTip(
      tr("Participants until every row of counterbalancing occurs equally often in every group."));
  fields_->show_assumptions(usual_, inputs().stated);
  // Fields that are made later than the table come before it.
  QWidget* before = scroll_;
  for (QLineEdit* field : fields_->fields()) {
    QWidget::setTabOrder(before, field);
    before = field;
  }
  QWidget::setTabOrder(before, table_);
  proceed();
}

void PrecisionView::take_inputs() {
  inputs() = {.participants = participants_->value(), .stated = fields_->stated()};
  restart();
}

void PrecisionView::restart() {
  simulation_.abandon();
  studies_.reset();
  results_.clear();
  failure_.clear();
  show_results();
  show_state();
  pause_.start();
}

std::vector<Assumption> PrecisionView::assumptions() const {
  return with_stated(usual_, fields_->stated(), kStatedInEditor);
}

QString PrecisionView::blocker() const {
  if (!failure_.isEmpty()) return tr("The studies could not be simulated: %1").arg(failure_);
  if (!refusal_.isEmpty()) return tr("Studies cannot be simulated here: %1").arg(refusal_);
  if (usual_.empty()) {
    return tr(
        "No block of the protocol has responses that an analysis counts. Add a block of "
        "trials.");
  }
  const QString invalid = fields_->invalid_fields();
  if (!invalid.isEmpty()) return tr("Correct these values: %1").arg(invalid);
  QStringList missing{};
  for (const std::string& name : names_without_value(assumptions())) {
    missing.append(assumption_caption(name));
  }
  if (missing.isEmpty()) return {};
  constexpr qsizetype kNamed = 3;
  const auto others = static_cast<int>(missing.size() - kNamed);
  const QString named = tr("State these values to see the precision: %1")
                            .arg(missing.first(std::min(kNamed, missing.size())).join("; "));
  return others > 0 ? tr("%1; and %n other(s)", nullptr, others).arg(named) : named;
}

void PrecisionView::proceed() {
  pause_.stop();
  if (protocol_ == nullptr) return;
  const bool is_held = study_.examiner().is_held();
  if (!isVisible() || has_new_text_ || is_held) {
    simulation_.abandon();
    show_state();
    return;
  }
  if (!is_read_) {
    read_design();
    show_state();
    return;
  }
  if (!simulation_.is_running() && studies() < kStudies && blocker().isEmpty()) {
    using Studies = std::shared_ptr<const PrecisionStudies>;
    simulation_.run<Studies>(
        [before = studies_, protocol = protocol_, values = assumptions(),
         participants = participants_->value()](const std::stop_token& stop,
                                                const BackgroundTask::Progress&) -> Studies {
          const auto end = std::chrono::steady_clock::now() + kPortion;
          auto studies = before ? std::make_shared<PrecisionStudies>(*before)
                                : std::make_shared<PrecisionStudies>(PowerModel(*protocol, values),
                                                                     participants, kSeed);
          studies->simulate(kStudies - studies->studies(), [&] {
            return stop.stop_requested() || std::chrono::steady_clock::now() >= end;
          });
          return studies;
        },
        [this](const Studies& studies) {
          studies_ = studies;
          results_ = studies->results();
          show_results();
          proceed();
        },
        [this](const QString& what) {
          failure_ = what;
          show_state();
        });
  }
  show_state();
}

void PrecisionView::show_state() {
  if (study_.examiner().is_held()) {
    state_->set_state(State::unknown, tr("No studies are simulated while the device is in use."));
  } else if (!is_read_) {
    state_->set_state(State::unknown, tr("The protocol is being read…"));
  } else if (const QString why = blocker(); !why.isEmpty()) {
    state_->set_state(State::look, why);
  } else {
    const bool is_complete = studies() >= kStudies;
    const bool has_tests = studies() == 0 || std::ranges::any_of(results_, [](const auto& one) {
                             return !one.family.empty();
                           });
    const QString count = tr("%1 of %2 simulated studies").arg(studies()).arg(kStudies);
    state_->set_state(is_complete ? State::fine : State::unknown,
                      has_tests
                          ? count
                          : tr("%1. The protocol has no family of tests, so there is no power: "
                               "declare one in “analysis”.")
                                .arg(count));
  }
}

void PrecisionView::show_results() {
  std::vector<StudyTable::Row> rows{};
  for (const PrecisionOf& result : results_) {
    NumberShape shape{};
    QString unit{};
    for (const Assumption& one : usual_) {
      if (!result.family.empty() || one.name != result.name) continue;
      shape = shape_of(one);
      unit = unit_text(one);
    }
    const QString name = name_of(result);
    for (const PrecisionFigure& figure : result.figures) {
      const int place = static_cast<int>(rows.size());
      rows.push_back({QString::number(place),
                      {text_cell(tr("%1: %2").arg(name, figure_name(figure.what)), place),
                       text_cell(figure_text(figure, shape, unit))}});
    }
  }
  table_->fill(rows);
}

std::vector<ShownCommand> PrecisionView::commands() const {
  ShownCommand command{.action = tr("Simulate %1 studies").arg(kStudies)};
  if (protocol_ == nullptr || !is_read_ || !blocker().isEmpty()) {
    command.remark = tr("There is no command until the values are stated.");
    return {command};
  }
  PowerLine line{
      .protocol = file_, .participants = participants_->value(), .seed = kSeed, .runs = kStudies};
  for (const Assumption& one : usual_) {
    const auto stated = fields_->stated().find(one.name);
    if (stated == fields_->stated().end()) continue;
    (one.part == Assumption::Part::effect ? line.effects : line.assumed).push_back(*stated);
  }
  command.line = power_line(line, plugin_files());
  command.remark = tr("The command reads the saved file. Standard errors are shown here only.");
  return {command};
}

}  // namespace asperity

#include "moc_precision_view.cpp"
