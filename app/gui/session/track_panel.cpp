// Paints the levels of each track as marks on common axes, with one line of text per track.

#include "app/gui/session/track_panel.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QtCore/QPointF>
#include <QtCore/QRectF>
#include <QtGui/QFontMetricsF>
#include <QtGui/QPainter>
#include <QtGui/QPainterPath>
#include <QtWidgets/QToolTip>

#include "app/findings/outcome/cell_words.h"
#include "app/gui/look/theme.h"
#include "app/gui/look/words.h"

namespace asperity {

namespace {

constexpr int kLeastLines = 2;        // of words above the plot; more where there is room
constexpr double kMostOfLines = 0.4;  // of the height
constexpr double kMark_px = 4.0;      // half the width of a mark
constexpr double kDot_px = 0.7;       // the radius of the dot of an unsure response
constexpr int kLeastPlot_px = 72;

QString digits_of(double level) { return shown_number(level, 'g', 3); }

/// The ranges of the axes, over all tracks.
struct Ranges {
  int steps = 1;
  double low = 0.0;
  double high = 0.0;
};

Ranges axes_of(const RunningTracks& tracks) {
  Ranges ranges{};
  bool is_first = true;
  const auto hold = [&](double level) {
    ranges.low = is_first ? level : std::min(ranges.low, level);
    ranges.high = is_first ? level : std::max(ranges.high, level);
    is_first = false;
  };
  for (const RunningTrack& track : tracks.tracks) {
    for (const RunningTrial& trial : track.trials) {
      ranges.steps = std::max(ranges.steps, trial.step);
      hold(trial.level);
    }
    if (track.estimate) hold(track.estimate->level);
  }
  if (!(ranges.high > ranges.low)) {
    const double room = std::max(std::abs(ranges.low) * 0.1, 1e-9);
    ranges.low -= room;
    ranges.high += room;
  }
  return ranges;
}

/// The shape of a mark belongs to its track, so that tracks differ not by colour alone.
QPainterPath mark_of(int track, QPointF at) {
  QPainterPath path{};
  switch ((track - 1) % 3) {
    case 0:
      path.addEllipse(at, kMark_px, kMark_px);
      break;
    case 1:
      path.addRect(QRectF(at.x() - kMark_px, at.y() - kMark_px, 2.0 * kMark_px, 2.0 * kMark_px));
      break;
    default:
      path.moveTo(at.x(), at.y() - 1.3 * kMark_px);
      path.lineTo(at.x() + 1.2 * kMark_px, at.y() + kMark_px);
      path.lineTo(at.x() - 1.2 * kMark_px, at.y() + kMark_px);
      path.closeSubpath();
      break;
  }
  return path;
}

Qt::PenStyle pen_of(int track) {
  switch ((track - 1) % 3) {
    case 0:
      return Qt::DashLine;
    case 1:
      return Qt::DotLine;
    default:
      return Qt::DashDotLine;
  }
}

}  // namespace

TrackPanel::TrackPanel(QWidget* parent) : QWidget(parent) {
  setObjectName("track_panel");
  setFont(text_font(TextSize::small));
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding);
}

void TrackPanel::show_tracks(std::optional<RunningTracks> tracks) {
  tracks_ = std::move(tracks);
  write_words();
}

void TrackPanel::set_blind(bool blind) {
  // A tooltip that is shown does not follow the property.
  if (blind && !blind_) QToolTip::hideText();
  blind_ = blind;
  write_words();
}

void TrackPanel::write_words() {
  const bool shows = shows_tracks();
  setAccessibleName(shows ? lines().join('\n') : instead());
  QStringList all = lines();
  all +=
      tr("Filled marks lead to a lower level, hollow ones to a higher level; hollow marks with a "
         "dot: “cannot tell”.");
  setToolTip(shows ? all.join('\n') : QString());
  update();
}

bool TrackPanel::shows_tracks() const { return !blind_ && tracks_ && !tracks_->tracks.empty(); }

QString TrackPanel::instead() const {
  if (blind_) return tr("Tracks are hidden while you are blind to the conditions.");
  return tracks_ ? tr("No response of a track yet") : tr("This block has no tracks.");
}

QString TrackPanel::line_of(const RunningTrack& track) const {
  const QString name =
      track.condition.empty()
          ? tr("Track %1").arg(track.track)
          : tr("Track %1 (%2)").arg(track.track).arg(QString::fromStdString(track.condition));
  if (!track.estimate) return tr("%1: no estimate yet").arg(name);
  const QString unit =
      tracks_->unit.empty() ? QString() : ' ' + QString::fromStdString(tracks_->unit);
  const QString level = digits_of(track.estimate->level) + unit;
  if (track.estimate->low && track.estimate->high) {
    return tr("%1: posterior median %2, 95 % interval %3 to %4")
        .arg(name, level, digits_of(*track.estimate->low), digits_of(*track.estimate->high) + unit);
  }
  return tr("%1: mean of the reversals %2 (n = %3)").arg(name, level).arg(track.reversals);
}

QStringList TrackPanel::lines() const {
  QStringList lines{};
  if (!shows_tracks()) return lines;
  for (const RunningTrack& track : tracks_->tracks) lines += line_of(track);
  return lines;
}

int TrackPanel::marks() const {
  int marks = 0;
  if (!shows_tracks()) return marks;
  for (const RunningTrack& track : tracks_->tracks) {
    marks += static_cast<int>(track.trials.size());
  }
  return marks;
}

QSize TrackPanel::minimumSizeHint() const {
  return {1, kLeastLines * QFontMetrics(font()).lineSpacing() + kLeastPlot_px};
}

void TrackPanel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme& colors = theme();
  const QFontMetricsF metrics(font());
  const double line = metrics.lineSpacing();
  if (!shows_tracks()) {
    painter.setPen(colors.muted);
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, instead());
    return;
  }
  const QStringList words = lines();
  double top = 0.0;
  const int rows = std::max(kLeastLines, static_cast<int>(kMostOfLines * height() / line));
  const int shown = std::min(rows, static_cast<int>(words.size()));
  for (int i = 0; i < shown; ++i) {
    painter.setPen(colors.text);
    painter.drawText(QRectF(0.0, top, width(), line), Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(words[i], Qt::ElideRight, width()));
    top += line;
  }
  const Ranges ranges = axes_of(*tracks_);
  const QString unit =
      tracks_->unit.empty() ? QString() : ' ' + QString::fromStdString(tracks_->unit);
  const QString highest = digits_of(ranges.high) + unit;
  const QString lowest = digits_of(ranges.low) + unit;
  const double left =
      line + std::max(metrics.horizontalAdvance(highest), metrics.horizontalAdvance(lowest)) +
      kGrid;
  const int taken = std::max(kLeastLines, shown);
  const QRectF plot(left, taken * line + 1.5 * kMark_px, width() - left - 2.0 * kMark_px,
                    height() - (taken + 1) * line - 3.0 * kMark_px);
  painter.setPen(colors.muted);
  // The title of the ordinate, upwards, next to the numbers.
  const double along_ordinate = height() - plot.top();
  painter.save();
  painter.translate(0.0, height());
  painter.rotate(-90.0);
  painter.drawText(QRectF(0.0, 0.0, along_ordinate, line), Qt::AlignCenter,
                   metrics.elidedText(text(words_of_parameter(tracks_->quantity)), Qt::ElideRight,
                                      along_ordinate));
  painter.restore();
  painter.drawText(QRectF(0.0, plot.top() - line / 2.0, left - kGrid / 2.0, line),
                   Qt::AlignRight | Qt::AlignVCenter, highest);
  painter.drawText(QRectF(0.0, plot.bottom() - line / 2.0, left - kGrid / 2.0, line),
                   Qt::AlignRight | Qt::AlignVCenter, lowest);
  painter.drawText(QRectF(plot.left(), height() - line, plot.width(), line), Qt::AlignCenter,
                   tr("trial of the track, 1 to %1").arg(ranges.steps));
  painter.setPen(QPen(colors.line, 1.0));
  painter.drawLine(plot.bottomLeft(), plot.bottomRight());
  painter.drawLine(plot.topLeft(), plot.bottomLeft());
  const auto place = [&](double step, double level) {
    const double along = ranges.steps > 1 ? (step - 1.0) / (ranges.steps - 1.0) : 0.5;
    return QPointF(
        plot.left() + along * plot.width(),
        plot.bottom() - (level - ranges.low) / (ranges.high - ranges.low) * plot.height());
  };
  for (const RunningTrack& track : tracks_->tracks) {
    const QColor color = series_color(track.track - 1);
    QPainterPath path{};
    for (const RunningTrial& trial : track.trials) {
      const QPointF at = place(trial.step, trial.level);
      if (path.elementCount() == 0) {
        path.moveTo(at);
      } else {
        path.lineTo(at);
      }
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(color, 1.0));
    painter.drawPath(path);
    if (track.estimate) {
      painter.setPen(QPen(color, 1.5, pen_of(track.track)));
      painter.drawLine(place(1.0, track.estimate->level),
                       QPointF(plot.right(), place(1.0, track.estimate->level).y()));
    }
    painter.setPen(QPen(color, 1.5));
    for (const RunningTrial& trial : track.trials) {
      const QPointF at = place(trial.step, trial.level);
      const bool is_filled = trial.outcome == LevelOutcome::correct;
      painter.setBrush(is_filled ? QBrush(color) : QBrush(colors.ground));
      painter.drawPath(mark_of(track.track, at));
      if (trial.outcome != LevelOutcome::unsure) continue;
      painter.setBrush(QBrush(color));
      painter.drawEllipse(at, kDot_px, kDot_px);
    }
  }
}

}  // namespace asperity

#include "moc_track_panel.cpp"
