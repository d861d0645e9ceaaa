// Implements a table model of headings and trials, with codes for a blind experimenter.

#include "app/gui/session/plan_table.h"

#include <algorithm>
#include <utility>

#include <QtGui/QKeyEvent>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QStyledItemDelegate>
#include <QtWidgets/QTableView>

#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "protocols/plan/course.h"

namespace asperity {

namespace {

constexpr int kTrialColumn = 0;
constexpr int kConditionColumn = 1;
constexpr int kOutcomeColumn = 2;
constexpr int kAroundCell = 24;  // both sides of its text, and the margin of a focused cell
constexpr int kRowHeight = 28;   // two more rows in sight than with the height of controls

/// What the surfaces of a trial share is said once: "brick: height_map, sinusoid".
QString stimulus_names(const Trial& trial) {
  const auto& surfaces = trial.presentations;
  if (surfaces.size() > 1) {
    const StimulusDescription& first = surfaces.front().stimulus;
    const auto all = [&surfaces](auto shares) {
      return std::all_of(surfaces.begin(), surfaces.end(), shares);
    };
    const auto listed = [&surfaces](const std::string& shared, auto differs) {
      QStringList names{};
      for (const PlannedPresentation& each : surfaces) {
        names += QString::fromStdString(differs(each.stimulus));
      }
      return QString("%1: %2").arg(QString::fromStdString(shared), names.join(", "));
    };
    if (!first.texture.empty() && all([&first](const PlannedPresentation& each) {
          return each.stimulus.texture == first.texture;
        })) {
      return listed(first.texture, [](const StimulusDescription& each) { return each.model; });
    }
    if (all([&first](const PlannedPresentation& each) {
          return each.stimulus.model == first.model && !each.stimulus.texture.empty();
        })) {
      return listed(first.model, [](const StimulusDescription& each) { return each.texture; });
    }
  }
  return QString::fromStdString(unblinded_text(trial));
}

/// "3, right · attempt 2"
QString numbered(const QString& outcome, int attempt) {
  return attempt > 1 ? PlanModel::tr("%1 · attempt %2").arg(outcome).arg(attempt) : outcome;
}

/// Numbers to the right, but not up against the next column.
class NumberDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    if (option->displayAlignment.testFlag(Qt::AlignRight))
      option->text += QChar(0x2002);  // en space
  }
};

/// Those of all trials outside procedures, which do not depend on the responses: a code keeps its stimulus when the plan
/// grows.
BlindCodes codes_of_session(const SessionFacts& facts) {
  const SessionRow& row = facts.row;
  return {example_plan(*facts.protocol, {.seed = row.seed.empty() ? 0 : std::stoull(row.seed),
                                         .counterbalance_row = row.counterbalance_row,
                                         .group = row.group_level.value_or("")}),
          row.seed};
}

}  // namespace

PlanModel::PlanModel(QObject* parent) : QAbstractTableModel(parent) {}

void PlanModel::set_facts(std::shared_ptr<const SessionFacts> facts) {
  beginResetModel();
  facts_ = std::move(facts);
  rows_.clear();
  row_of_trial_.clear();
  if (facts_ != nullptr && facts_->plan != nullptr && facts_->protocol != nullptr) {
    const Plan& plan = *facts_->plan;
    if (!codes_ || codes_of_ != facts_->protocol) {
      codes_of_ = facts_->protocol;
      codes_ = codes_of_session(*facts_);
    }
    veil_ = NameVeil(*facts_->protocol, plan);
    int block = 0;
    for (const Trial& trial : plan.trials) {
      if (trial.block_ordinal != block) {
        block = trial.block_ordinal;
        Row heading{};
        heading.block = tr("Block %1 of %2, %3")
                            .arg(block)
                            .arg(plan.blocks)
                            .arg(QString::fromStdString(trial.block));
        rows_.push_back(std::move(heading));
      }
      Row row{};
      row.trial = &trial;
      row.code = QString::fromStdString(codes_->of(trial));
      row.name = stimulus_names(trial);
      for (const PlannedPresentation& surface : trial.presentations) {
        row.surface_codes +=
            QString::fromStdString(is_named_by_places(trial) ? surface.code : codes_->of(surface));
        Trial alone{};
        alone.presentations.push_back(surface);
        row.surface_names += QString::fromStdString(unblinded_text(alone));
      }
      row_of_trial_.resize(
          std::max(row_of_trial_.size(), static_cast<std::size_t>(trial.ordinal) + 1), -1);
      row_of_trial_[static_cast<std::size_t>(trial.ordinal)] = static_cast<int>(rows_.size());
      rows_.push_back(std::move(row));
    }
  }
  write_outcomes();
  endResetModel();
}

void PlanModel::set_blind(bool blind) {
  if (blind == blind_) return;
  blind_ = blind;
  write_outcomes();
  if (!rows_.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, kOutcomeColumn));
}

bool PlanModel::set_attempts(std::shared_ptr<const std::vector<AttemptSummary>> attempts) {
  if (attempts == attempts_) return false;
  attempts_ = std::move(attempts);
  write_outcomes();
  if (!rows_.empty()) {
    emit dataChanged(index(0, kOutcomeColumn), index(rowCount() - 1, kOutcomeColumn));
  }
  return true;
}

void PlanModel::set_now(int trial, const QString& phase) {
  if (trial == now_ && phase == phase_) return;
  const int before = row_of(now_);
  now_ = trial;
  phase_ = phase;
  const int after = row_of(now_);
  for (const int row : {before, after}) {
    if (row >= 0) emit dataChanged(index(row, 0), index(row, kOutcomeColumn));
    if (before == after) break;
  }
}

QString PlanModel::condition(int trial, int surface) const {
  const int number = row_of(trial);
  if (number < 0) return {};
  const Row& row = rows_[static_cast<std::size_t>(number)];
  return (blind_ ? row.surface_codes : row.surface_names).value(surface - 1);
}

int PlanModel::row_of(int trial) const {
  return trial > 0 && static_cast<std::size_t>(trial) < row_of_trial_.size()
             ? row_of_trial_[static_cast<std::size_t>(trial)]
             : -1;
}

bool PlanModel::is_heading(int row) const {
  return rows_[static_cast<std::size_t>(row)].trial == nullptr;
}

bool PlanModel::explains(int row) const { return explains(rows_[static_cast<std::size_t>(row)]); }

bool PlanModel::tells_right(const AttemptSummary& attempt) const {
  if (!blind_) return true;
  const int row = row_of(attempt.trial);
  if (row < 0) return false;
  const auto& blocks = facts_->protocol->blocks;
  const auto block = blocks.find(rows_[static_cast<std::size_t>(row)].trial->block);
  return block != blocks.end() && block->second.feedback != Protocol::Block::Feedback::none;
}

void PlanModel::write_outcomes() {
  for (Row& row : rows_) {
    row.outcome.clear();
    row.history.clear();
    row.attempts = 0;
    row.reason.clear();
    row.is_of_hand = false;
    row.state = State::unknown;
  }
  if (attempts_ == nullptr) return;
  for (const AttemptSummary& attempt : *attempts_) {
    const int number = row_of(attempt.trial);
    if (number < 0) continue;
    Row& row = rows_[static_cast<std::size_t>(number)];
    const QString text = SessionText::of_attempt(attempt, tells_right(attempt));
    row.history = row.history.isEmpty() ? text : tr("%1, previously: %2").arg(text, row.history);
    if (attempt.purpose == AttemptPurpose::refresher) continue;
    // What counts is the last one; the tool tip states those before it.
    row.attempts = attempt.attempt;
    row.outcome = numbered(text, attempt.attempt);
    row.state = SessionText::state_of(attempt);
    const QString reason = words_of(attempt.reason);
    row.reason = blind_ ? veil_.veiled(reason) : reason;
    row.is_of_hand = attempt.outcome == AttemptOutcome::answered ||
                     attempt.outcome == AttemptOutcome::not_compliant;
  }
}

int PlanModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int PlanModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : 3; }

QString PlanModel::text_of(const Row& row, int column) const {
  if (row.trial == nullptr) {
    if (column != 0) return {};
    return blind_ ? veil_.veiled(row.block) : row.block;
  }
  const bool now = row.trial->ordinal == now_;
  switch (column) {
    case kTrialColumn:
      return now ? QString("▶ %1").arg(row.trial->ordinal) : QString::number(row.trial->ordinal);
    case kConditionColumn:
      return blind_ ? row.code : row.name;
    case kOutcomeColumn: {
      if (now && !phase_.isEmpty()) {
        return numbered(phase_, row.attempts + 1);
      }
      if (row.outcome.isEmpty()) return {};
      const QString outcome = QString("%1 %2").arg(shape_of(row.state), row.outcome);
      return explains(row) ? tr("%1: %2").arg(outcome, row.reason) : outcome;
    }
    default:
      return {};
  }
}

QVariant PlanModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  const bool now = row.trial != nullptr && row.trial->ordinal == now_;
  switch (role) {
    case Qt::DisplayRole:
      return text_of(row, index.column());
    case Qt::ToolTipRole: {
      if (row.trial == nullptr) return {};
      if (index.column() != kOutcomeColumn) return text_of(row, index.column());
      QStringList lines{now && !phase_.isEmpty() ? text_of(row, kOutcomeColumn) : QString(),
                        row.history, row.reason};
      lines.removeAll(QString());
      return lines.join('\n');
    }
    case Qt::TextAlignmentRole:
      return QVariant::fromValue(row.trial != nullptr && index.column() == kTrialColumn
                                     ? Qt::AlignRight | Qt::AlignVCenter
                                     : Qt::AlignLeft | Qt::AlignVCenter);
    case Qt::FontRole:
      return text_font(row.trial == nullptr ? TextSize::small : TextSize::body,
                       now || row.trial == nullptr);
    case Qt::ForegroundRole:
      if (row.trial == nullptr) return theme().muted;
      if (now) return theme().text;
      return index.column() == kOutcomeColumn && row.state == State::look ? theme().look
                                                                          : theme().text;
    case Qt::BackgroundRole:
      if (now) return theme().raised;
      return row.trial == nullptr ? QVariant(theme().ground) : QVariant();
    default:
      return {};
  }
}

QVariant PlanModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) {
    return QVariant::fromValue(section == kTrialColumn ? Qt::AlignRight | Qt::AlignVCenter
                                                       : Qt::AlignLeft | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kTrialColumn:
      return tr("Trial");
    case kConditionColumn:
      return blind_ ? tr("Code") : tr("Condition");
    case kOutcomeColumn:
      return tr("Outcome");
    default:
      return {};
  }
}

PlanTable::PlanTable(QWidget* parent) : QWidget(parent) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kGrid);
  auto* top = new QHBoxLayout();
  auto* title = new QLabel(tr("PLAN"), this);
  title->setFont(text_font(TextSize::small, true));
  title->setProperty("role", "muted");
  follow_button_ = make_button(tr("Show the trial under way"), ButtonRole::link, this);
  follow_button_->setObjectName("plan_follow");
  follow_button_->setFont(text_font(TextSize::small));
  follow_button_->setStyleSheet("min-height: 16px; max-height: 16px;");
  QSizePolicy keeps_place = follow_button_->sizePolicy();
  keeps_place.setRetainSizeWhenHidden(true);
  follow_button_->setSizePolicy(keeps_place);
  follow_button_->hide();
  top->addWidget(title, 1);
  top->addWidget(follow_button_);
  rows->addLayout(top);

  model_ = new PlanModel(this);
  view_ = new QTableView(this);
  view_->setObjectName("plan");
  view_->setAccessibleName(tr("Plan"));
  view_->setModel(model_);
  style_table(*view_);
  view_->setSortingEnabled(false);  // the order is what it shows
  view_->setWordWrap(true);         // names are longer than codes
  view_->verticalHeader()->setDefaultSectionSize(kRowHeight);
  view_->horizontalHeader()->setSectionResizeMode(kTrialColumn, QHeaderView::Fixed);
  view_->horizontalHeader()->setSectionResizeMode(kConditionColumn, QHeaderView::Fixed);
  view_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  view_->setItemDelegateForColumn(kTrialColumn, new NumberDelegate(view_));
  view_->setFocusPolicy(Qt::TabFocus);
  view_->installEventFilter(this);
  rows->addWidget(view_, 1);
  connect(view_->verticalScrollBar(), &QScrollBar::actionTriggered, this, &PlanTable::let_go);
  connect(follow_button_, &QPushButton::clicked, this, &PlanTable::follow);
}

void PlanTable::set_facts(std::shared_ptr<const SessionFacts> facts) {
  model_->set_facts(std::move(facts));
  view_->clearSpans();
  for (int row = 0; row < model_->rowCount(); ++row) {
    if (model_->is_heading(row)) view_->setSpan(row, 0, 1, model_->columnCount());
  }
  fit_columns();
}

void PlanTable::set_blind(bool blind) {
  model_->set_blind(blind);
  fit_columns();
}

void PlanTable::fit_columns() {
  constexpr int kPadding = 12;
  int widest = 0;
  const QFontMetrics letters(text_font(TextSize::body, true));
  // The trial under way is marked, and its number is what the experimenter looks for.
  const int marked = letters.horizontalAdvance(QString("▶ %1").arg(model_->rowCount()));
  view_->setColumnWidth(kTrialColumn, marked + 2 * kPadding);
  for (int row = 0; row < model_->rowCount(); ++row) {
    if (model_->is_heading(row)) continue;
    widest = std::max(
        widest, letters.horizontalAdvance(model_->index(row, kConditionColumn).data().toString()));
  }
  // Longer texts take two lines; names get the room first.
  constexpr int kOutcome = 176;
  constexpr int kLeastOutcome = 120;
  const int width = view_->viewport()->width() - view_->columnWidth(kTrialColumn);
  const int wanted = std::max(widest + kAroundCell, 72);
  const int outcome = wanted + kOutcome <= width ? kOutcome : kLeastOutcome;
  view_->setColumnWidth(kConditionColumn, std::min(wanted, std::max(width - outcome, 72)));
  for (int row = 0; row < model_->rowCount(); ++row) fit_row(row);
}

void PlanTable::fit_row(int row) {
  if (row < 0 || model_->is_heading(row)) return;
  const QFontMetrics letters(text_font(TextSize::body, true));
  int height = letters.height();
  for (const int column : {kConditionColumn, kOutcomeColumn}) {
    const QRect room(0, 0, view_->columnWidth(column) - kAroundCell, QWIDGETSIZE_MAX);
    const QString text = model_->index(row, column).data().toString();
    height = std::max(height, letters.boundingRect(room, Qt::TextWordWrap, text).height());
  }
  const int needed = kRowHeight + height - letters.height();
  if (view_->rowHeight(row) != needed) view_->setRowHeight(row, needed);
}

void PlanTable::set_attempts(std::shared_ptr<const std::vector<AttemptSummary>> attempts) {
  if (!model_->set_attempts(std::move(attempts))) return;
  for (int row = 0; row < model_->rowCount(); ++row) {
    if (model_->explains(row) || view_->rowHeight(row) != kRowHeight) fit_row(row);
  }
}

void PlanTable::set_now(int trial, const QString& phase) {
  model_->set_now(trial, phase);
  for (const int changed : {now_, trial}) fit_row(model_->row_of(changed));
  if (trial == now_) return;
  now_ = trial;
  if (following_) follow();
}

void PlanTable::follow() {
  following_ = true;
  follow_button_->hide();
  const int row = model_->row_of(now_);
  if (row >= 0) view_->scrollTo(model_->index(row, 0), QAbstractItemView::PositionAtCenter);
}

void PlanTable::let_go() {
  following_ = false;
  follow_button_->show();
}

bool PlanTable::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_ && event->type() == QEvent::Resize) {
    // After the view has laid itself out anew.
    QMetaObject::invokeMethod(
        this,
        [this] {
          fit_columns();
          if (following_) follow();
        },
        Qt::QueuedConnection);
  }
  // The arrows move the row that is chosen, and the view after it.
  if (watched == view_ && event->type() == QEvent::KeyPress) {
    switch (static_cast<QKeyEvent*>(event)->key()) {
      case Qt::Key_Up:
      case Qt::Key_Down:
      case Qt::Key_PageUp:
      case Qt::Key_PageDown:
      case Qt::Key_Home:
      case Qt::Key_End:
        let_go();
        break;
      default:
        break;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace asperity

#include "moc_plan_table.cpp"
