// Divides scales into pages of rows, draws lines, points and marks, and converts positions to values.

#include "app/gui/participant/pages/scale_lines.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <QtCore/Qt>
#include <QtGui/QPainter>

#include "app/gui/participant/pages/option_list.h"
#include "app/gui/participant/pages/page_frame.h"
#include "app/gui/participant/pages/participant_brush.h"

namespace asperity {

namespace {

using Action = ParticipantAction;
using Item = ParticipantItem;
using Scene = ParticipantScene;

/// A label for every point needs the room of a list.
bool is_list_of_points(std::span<const Scene::Scale> scales) {
  return scales.size() == 1 && scales.front().form.labels_every_point();
}

void lay_out_points(PageFrame& frame, const Scene::Scale& scale) {
  std::vector<ListedOption> labels{};
  for (const std::string& label : scale.form.labels) {
    labels.push_back({frame.text_from(label),
                      frame.text_from(key_of_option(static_cast<int>(labels.size()) + 1))});
  }
  std::vector<int> chosen{};
  if (scale.step && scale.counts) chosen.push_back(*scale.step + 1);
  lay_out_options(frame, {.question = frame.scene_text(), .options = labels, .chosen = chosen});
}

/// The lines of one or more scales, in rows.
class ScaleLayout final {
 public:
  ScaleLayout(PageFrame& frame, std::span<const Scene::Scale> scales)
      : frame_(frame), scales_(scales), body_(frame.body()) {}

  void lay_out();

 private:
  struct Rows {
    double width = 0.0;
    double prompt_width = 0.0;   ///< 0: the prompts stand above the lines
    double label_width = 0.0;    ///< beside the ends of the lines; 0: above them, or no labels
    double label_height = 0.0;   ///< of labels above the lines
    double prompt_height = 0.0;  ///< of prompts above the lines
    double above() const { return prompt_height + label_height; }
    double line = 0.0;  ///< height of a line with its labels
    int on_a_page = 1;
    int pages = 1;
  };
  Rows rows_in(double height) const;
  /// For each of two labels above a line of this width.
  double label_room(double width) const;
  void add_row(const Scene::Scale& scale, int number, const Rows& rows, QRectF room);

  PageFrame& frame_;
  std::span<const Scene::Scale> scales_;
  QRectF& body_;
};

/// The rows in `height`: prompts above their lines, or beside them where that saves pages.
ScaleLayout::Rows ScaleLayout::rows_in(double height) const {
  const double width = std::min(body_.width(), frame_.em(frame_.kColumn));
  const double gap = frame_.px(frame_.kGap) / 2.0;
  const auto measured = [&](bool beside) {
    Rows rows{.width = width};
    if (beside) rows.prompt_width = std::floor(0.3 * width);
    const double lines = width - (beside ? rows.prompt_width + frame_.px(frame_.kGap) : 0.0);
    double natural = 0.0;
    double longest_word = 0.0;
    for (const Scene::Scale& scale : scales_) {
      for (const std::string& label : scale.form.labels) {
        const QString text = frame_.text_from(label);
        natural = std::max(natural, frame_.width_of(text, frame_.letters(frame_.kText), false));
        longest_word = std::max(longest_word,
                                frame_.width_of_longest_word(text, frame_.letters(frame_.kText)));
      }
    }
    // The line keeps almost half of the row; where labels leave it less, they stand above it.
    constexpr double kMostOfLabel = 0.26;
    const bool is_beside = natural > 0.0 && longest_word <= kMostOfLabel * lines;
    if (is_beside) rows.label_width = std::min(natural + 2.0, std::floor(kMostOfLabel * lines));
    rows.line = frame_.em(frame_.kOneLine);
    for (const Scene::Scale& scale : scales_) {
      for (const std::string& label : scale.form.labels) {
        const double room = is_beside ? rows.label_width : label_room(lines);
        const double taken =
            frame_.height_of(frame_.text_from(label), frame_.letters(frame_.kText), false, room);
        double& tallest = is_beside ? rows.line : rows.label_height;
        tallest = std::max(tallest, taken);
      }
      const QString prompt = frame_.text_from(scale.prompt);
      if (!prompt.isEmpty() && beside) {
        rows.line = std::max(rows.line, frame_.height_of(prompt, frame_.letters(frame_.kText), true,
                                                         rows.prompt_width));
      } else if (!prompt.isEmpty()) {
        rows.prompt_height =
            std::max(rows.prompt_height,
                     frame_.height_of(prompt, frame_.letters(frame_.kText), true, width));
      }
    }
    const double row = rows.above() + rows.line;
    rows.on_a_page = std::max(1, static_cast<int>((height + gap) / (row + gap)));
    return rows;
  };
  const auto pages_of_scales = [this](const Rows& rows) {
    const int count = static_cast<int>(scales_.size());
    return (count + rows.on_a_page - 1) / rows.on_a_page;
  };
  Rows above = measured(false);
  above.pages = pages_of_scales(above);
  if (above.pages == 1 || !frame_.is_wide()) return above;
  Rows beside = measured(true);
  beside.pages = pages_of_scales(beside);
  return beside.pages < above.pages ? beside : above;
}

double ScaleLayout::label_room(double width) const {
  return std::floor((width - frame_.px(frame_.kGap)) / 2.0);
}

void ScaleLayout::add_row(const Scene::Scale& scale, int number, const Rows& rows, QRectF room) {
  const QString prompt = frame_.text_from(scale.prompt);
  if (rows.prompt_width > 0.0) {
    QRectF place = room;
    place.setWidth(rows.prompt_width);
    room.setLeft(place.right() + frame_.px(frame_.kGap));
    frame_.add({.rect = place,
                .text = prompt,
                .size_px = frame_.letters(frame_.kText),
                .bold = true,
                .left_aligned = true});
  } else if (rows.prompt_height > 0.0) {
    QRectF place = room;
    place.setHeight(rows.prompt_height);
    room.setTop(place.bottom());
    frame_.add(
        {.rect = place, .text = prompt, .size_px = frame_.letters(frame_.kText), .bold = true});
  }
  QRectF low = room;
  if (rows.label_width > 0.0) {
    const double taken = rows.label_width + frame_.px(frame_.kGap) / 2.0;
    low.setWidth(rows.label_width);
    room.adjust(taken, 0.0, -taken, 0.0);
  } else {
    low.setSize({label_room(room.width()), rows.label_height});
    room.setTop(low.bottom());
  }
  if (!scale.form.labels.empty()) {
    const QString left = frame_.text_from(scale.form.labels.front());
    const QString right = frame_.text_from(scale.form.labels.back());
    QRectF high = low;
    if (rows.label_width > 0.0) {
      high.moveRight(room.right() + frame_.px(frame_.kGap) / 2.0 + rows.label_width);
    } else {
      // At the ends of the line.
      const double most = low.width();
      low.setWidth(
          std::min(most, frame_.width_of(left, frame_.letters(frame_.kText), false) + 2.0));
      high.setWidth(
          std::min(most, frame_.width_of(right, frame_.letters(frame_.kText), false) + 2.0));
      high.moveRight(room.right());
    }
    frame_.add({.rect = low, .text = left, .size_px = frame_.letters(frame_.kText)});
    frame_.add({.rect = high, .text = right, .size_px = frame_.letters(frame_.kText)});
  }
  frame_.add(
      {.kind = Item::Kind::scale,
       .rect = room,
       .side = frame_.em(frame_.kBadge) / 2.0,
       .size_px = frame_.letters(frame_.kText),
       .scale = scale,
       .action = ParticipantAction{.what = ParticipantAction::What::mark, .number = number}});
}

void ScaleLayout::lay_out() {
  // The question stands over the scales unless that takes more pages than a separate one.
  const Rows alone = rows_in(body_.height());
  const bool answers = frame_.question_over(
      frame_.scene_text(), [&](double height) { return rows_in(height).pages <= alone.pages + 1; });
  const Rows rows = answers ? rows_in(body_.height()) : alone;
  frame_.need_pages(frame_.question_pages() + rows.pages);
  if (!answers) return;
  const int count = static_cast<int>(scales_.size());
  for (int i = 0; i < count; ++i) {
    if (scales_[static_cast<std::size_t>(i)].current) {
      frame_.set_answer_page(frame_.question_pages() + 1 + i / rows.on_a_page);
    }
  }
  const int first = (frame_.page() - frame_.question_pages() - 1) * rows.on_a_page;
  const int shown = std::min(rows.on_a_page, count - first);
  const double row = rows.above() + rows.line;
  // Rows stand apart where there is room, and in the middle.
  const double gap = std::clamp((body_.height() - shown * row) / std::max(1, shown - 1),
                                frame_.px(frame_.kGap) / 2.0, frame_.px(2.0 * frame_.kGap));
  double y = body_.center().y() - (shown * row + (shown - 1) * gap) / 2.0;
  for (int i = first; i < first + shown; ++i) {
    add_row(scales_[static_cast<std::size_t>(i)], i + 1, rows,
            QRectF(body_.center().x() - rows.width / 2.0, y, rows.width, row));
    y += row + gap;
  }
}

/// Where its points are on the screen.
struct DrawnLine {
  double left = 0.0;
  double length = 0.0;
};
DrawnLine drawn_line_of(const Item& item) {
  return {.left = item.rect.left() + item.side, .length = item.rect.width() - 2.0 * item.side};
}

}  // namespace

void lay_out_scales(PageFrame& frame, std::span<const Scene::Scale> scales) {
  if (is_list_of_points(scales)) {
    lay_out_points(frame, scales.front());
  } else {
    ScaleLayout(frame, scales).lay_out();
  }
}

/// A mark that is no answer yet is hollow. The current scale has a heavier line and a frame.
void draw_scale(ParticipantBrush& brush, const Item& item) {
  QPainter& painter = brush.painter();
  const ParticipantColors& colors = brush.colors();
  const ParticipantScene::Scale& scale = *item.scale;
  const double unit = item.size_px / 32.0;
  const DrawnLine line = drawn_line_of(item);
  const double y = item.rect.center().y();
  if (scale.current) brush.box(item.rect, 8.0 * unit, colors.panel, colors.press, 2.0 * unit);
  painter.setPen(QPen(colors.text, (scale.current ? 4.0 : 3.0) * unit));
  painter.drawLine(QPointF(line.left, y), QPointF(line.left + line.length, y));
  const int steps = scale.form.steps();
  const auto x_of = [&line, steps](int step) { return line.left + line.length * step / steps; };
  const double half = 16.0 * unit;
  if (scale.form.points == 0) {
    for (const double x : {line.left, line.left + line.length}) {
      painter.drawLine(QPointF(x, y - half), QPointF(x, y + half));
    }
  } else {
    painter.setBrush(colors.panel);
    for (int step = 0; step <= steps; ++step) {
      painter.drawEllipse(QPointF(x_of(step), y), 0.75 * half, 0.75 * half);
    }
  }
  if (!scale.step) return;
  painter.setPen(QPen(colors.press, 4.0 * unit));
  painter.setBrush(scale.counts ? colors.press : colors.panel);
  const QPointF at(x_of(*scale.step), y);
  if (scale.form.points == 0) {
    painter.drawRoundedRect(QRectF(at.x() - 5.0 * unit, y - 1.25 * half, 10.0 * unit, 2.5 * half),
                            4.0 * unit, 4.0 * unit);
  } else {
    painter.drawEllipse(at, half, half);
  }
}

std::optional<Action> key_of_scales(std::span<const Scene::Scale> scales, int key,
                                    const QString& typed) {
  switch (key) {
    case Qt::Key_Left:
      return Action{.what = Action::What::step, .number = -1};
    case Qt::Key_Right:
      return Action{.what = Action::What::step, .number = 1};
    case Qt::Key_Up:
    case Qt::Key_Backtab:
      return Action{.what = Action::What::select, .number = -1};
    case Qt::Key_Down:
    case Qt::Key_Tab:
      return Action{.what = Action::What::select, .number = 1};
    default:
      break;
  }
  if (!is_list_of_points(scales)) return {};
  for (int number = 1; number <= scales.front().form.points; ++number) {
    if (typed.toStdString() == key_of_option(number)) {
      return Action{.what = Action::What::choose, .number = number};
    }
  }
  return {};
}

std::optional<double> position_on_scale(const Item& item, QPointF at) {
  if (item.kind != Item::Kind::scale) return {};
  const DrawnLine line = drawn_line_of(item);
  const double position = std::clamp((at.x() - line.left) / line.length, 0.0, 1.0);
  const int steps = item.scale->form.steps();
  return std::round(position * steps) / steps;
}

}  // namespace asperity
