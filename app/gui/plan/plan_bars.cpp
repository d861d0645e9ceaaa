// Draws the parts of a plan in proportion to their durations, and writes the legend of its blocks.

#include "app/gui/plan/plan_bars.h"

#include <algorithm>

#include <QtGui/QHelpEvent>
#include <QtGui/QMouseEvent>
#include <QtGui/QPainter>
#include <QtWidgets/QLabel>
#include <QtWidgets/QToolTip>
#include <QtWidgets/QVBoxLayout>

#include "app/gui/base/shown_text.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"
#include "app/gui/look/words.h"

namespace asperity {

namespace {

constexpr int kBarHeight = 2 * kGrid;
constexpr double kNarrowest = 2.0;  // pixels, so that no part is invisible

QString words_of_part(const PlanPart& part) {
  const QString duration = text_of_duration(part.duration_s);
  switch (part.what) {
    case PlanPart::What::trials: {
      const PlannedRun shown{.block = part.block, .trials = part.trials};
      return PlanBars::tr("%1: %2, about %3")
          .arg(text(part.block->name), text_of_trials({&shown, 1}), duration);
    }
    case PlanPart::What::pause:
      return PlanBars::tr("break: at least %1").arg(duration);
    case PlanPart::What::reading:
      break;
  }
  return PlanBars::tr("texts, checks and questions: about %1").arg(duration);
}

}  // namespace

QString text_of_trials(std::span<const PlannedRun> runs) {
  int most_trials = 0;
  bool is_variable = false;
  for (const PlannedRun& run : runs) {
    most_trials += run.most_trials.value_or(run.trials);
    is_variable = is_variable || run.most_trials.has_value();
  }
  if (is_variable) return PlanBars::tr("at most %1 trials").arg(most_trials);
  return most_trials == 1 ? PlanBars::tr("1 trial") : PlanBars::tr("%1 trials").arg(most_trials);
}

PlanBars::PlanBars(QWidget* parent) : QWidget(parent) {
  setObjectName("plan_bars");
  setAccessibleName(tr("Blocks and breaks of the session"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, kBarHeight + kGrid / 2, 0, 0);
  legend_ = make_text({}, this, true);
  legend_->setObjectName("plan_legend");
  legend_->setFont(text_font(TextSize::small));
  legend_->setTextFormat(Qt::RichText);
  layout->addWidget(legend_);
}

void PlanBars::show_parts(std::span<const PlanPart> parts, std::span<const PlannedRun> runs) {
  add_entries(runs);
  double total_s = 0.0;
  for (const PlanPart& part : parts) total_s += part.duration_s;
  bars_.clear();
  QStringList words{};
  for (const PlanPart& part : parts) {
    Bar bar{.what = part.what,
            .share = total_s > 0.0 ? part.duration_s / total_s : 0.0,
            .first_step = static_cast<int>(part.first_step),
            .words = words_of_part(part)};
    if (part.block != nullptr) {
      const auto entry = std::ranges::find(entries_, text(part.block->name), &Entry::block);
      bar.color = static_cast<int>(entry - entries_.begin());
    }
    words.append(bar.words);
    bars_.push_back(std::move(bar));
  }
  setAccessibleDescription(words.join("; "));
  write_legend();
  update();
}

void PlanBars::add_entries(std::span<const PlannedRun> runs) {
  entries_.clear();
  std::vector<std::vector<PlannedRun>> of_blocks{};
  for (const PlannedRun& run : runs) {
    const QString block = text(run.block->name);
    const auto found = std::ranges::find(entries_, block, &Entry::block);
    const auto place = static_cast<std::size_t>(found - entries_.begin());
    if (found == entries_.end()) {
      entries_.push_back({.block = block});
      of_blocks.emplace_back();
    }
    of_blocks[place].push_back(run);
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    entries_[i].runs = static_cast<int>(of_blocks[i].size());
    entries_[i].trials = text_of_trials(of_blocks[i]);
    for (const PlannedRun& run : of_blocks[i]) entries_[i].duration_s += run.duration_s;
  }
}

void PlanBars::write_legend() {
  QStringList lines{};
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry& entry = entries_[i];
    QStringList facts{};
    if (entry.runs > 1) facts.append(tr("%1 runs").arg(entry.runs));
    facts.append(entry.trials);
    facts.append(tr("about %1").arg(text_of_duration(entry.duration_s)));
    // Spaces that do not break keep an entry on one line.
    const QString line = tr("%1: %2").arg(entry.block, facts.join(", "));
    lines.append(QString("<span style='color:%1'>■</span>&nbsp;%2")
                     .arg(series_color(static_cast<int>(i)).name(),
                          line.toHtmlEscaped().replace(' ', "&nbsp;")));
  }
  legend_->setText(lines.join("&ensp; "));
}

QRectF PlanBars::rect_of(std::size_t bar) const {
  // What remains after the narrowest width of every part is divided by duration.
  const double shared = std::max(0.0, width() - kNarrowest * static_cast<double>(bars_.size()));
  double left = 0.0;
  for (std::size_t i = 0; i < bar; ++i) left += kNarrowest + shared * bars_[i].share;
  return {left, 0.0, kNarrowest + shared * bars_[bar].share, static_cast<double>(kBarHeight)};
}

const PlanBars::Bar* PlanBars::bar_at(QPointF place) const {
  for (std::size_t i = 0; i < bars_.size(); ++i) {
    if (rect_of(i).contains(place)) return &bars_[i];
  }
  return nullptr;
}

void PlanBars::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  for (std::size_t i = 0; i < bars_.size(); ++i) {
    const QRectF rect = rect_of(i);
    switch (bars_[i].what) {
      case PlanPart::What::trials:
        painter.fillRect(rect.adjusted(0.0, 0.0, -1.0, 0.0), series_color(bars_[i].color));
        break;
      case PlanPart::What::pause:
        break;
      case PlanPart::What::reading:
        painter.fillRect(QRectF(rect.left(), rect.center().y() - 1.0, rect.width(), 2.0),
                         theme().muted);
        break;
    }
  }
}

void PlanBars::mousePressEvent(QMouseEvent* event) {
  if (const Bar* const bar = bar_at(event->position())) emit step_wanted(bar->first_step);
}

bool PlanBars::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto& help = static_cast<const QHelpEvent&>(*event);
  const Bar* const bar = bar_at(help.pos());
  QToolTip::showText(help.globalPos(), bar == nullptr ? QString() : bar->words, this);
  return true;
}

/// The colours of the legend are those of the theme.
void PlanBars::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::StyleChange || event->type() == QEvent::PaletteChange)
    write_legend();
}

}  // namespace asperity

#include "moc_plan_bars.cpp"
