// Draws the line from its fixed end, and converts the pointer and the arrow keys to its length.

#include "app/gui/participant/pages/line_page.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include <QtCore/Qt>
#include <QtGui/QPainter>

#include "app/gui/participant/pages/page_frame.h"
#include "app/gui/participant/pages/participant_brush.h"
#include "app/gui/participant/pages/trial_controls.h"

namespace asperity {

namespace {

using Action = ParticipantAction;
using Item = ParticipantItem;
using Scene = ParticipantScene;

/// The first and the last end that a line can have.
struct LineEnds {
  double left = 0.0;
  double longest = 0.0;
};
LineEnds ends_of(const Item& item) {
  return {.left = item.rect.left() + item.side, .longest = item.rect.width() - 2.0 * item.side};
}

class LinePage final : public ParticipantPage {
 public:
  void lay_out(PageFrame& frame) const override {
    const QString hint = frame.said(
        phrase("ParticipantLayout", "Press where the line is to end, or use the keys ← and →."));
    const int letters = frame.letters(frame.kText);
    const double gap = frame.px(frame.kGap);
    const double field = frame.tall(frame.kOption);
    const auto hint_height = [&] {
      return frame.height_of(hint, letters, false, frame.column().width());
    };
    const bool answers = frame.question_over(
        frame.scene_text(), [&](double height) { return height >= field + gap + hint_height(); });
    frame.need_pages(frame.question_pages() + 1);
    if (!answers) return;
    const QRectF& body = frame.body();
    // A proportion of the screen: as wide in every window of the same screen.
    const double longest =
        std::get<LineForm>(frame.scene().form).longest * frame.inputs().size.width();
    const double side =
        std::min(frame.px(frame.kGap), (frame.inputs().size.width() - longest) / 2.0);
    const double needed = field + gap + hint_height();
    const double top = body.center().y() - needed / 2.0;
    frame.add(
        {.kind = Item::Kind::line,
         .rect = QRectF(body.center().x() - longest / 2.0 - side, top, longest + 2.0 * side, field),
         .side = side,
         .size_px = letters,
         .line_step = frame.scene().line_step,
         .action = Action{.what = Action::What::mark, .number = 1}});
    QRectF words = frame.column();
    words.setTop(top + field + gap);
    words.setHeight(hint_height());
    frame.add({.rect = words, .text = hint, .size_px = letters, .muted = true});
  }

  void add_controls(PageFrame& frame) const override {
    add_question_controls(frame, *this, frame.scene().can_confirm);
  }

  void draw(ParticipantBrush& brush, const Item& item) const override {
    if (item.kind != Item::Kind::line) {
      brush.draw(item);
      return;
    }
    QPainter& painter = brush.painter();
    const ParticipantColors& colors = brush.colors();
    const double unit = item.size_px / 32.0;
    const LineEnds ends = ends_of(item);
    const double y = item.rect.center().y();
    const double half = 16.0 * unit;
    brush.box(item.rect, 8.0 * unit, colors.panel, colors.press, 2.0 * unit);
    painter.setPen(QPen(colors.text, 4.0 * unit, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(ends.left, y - half), QPointF(ends.left, y + half));
    if (!item.line_step) return;
    const double right = ends.left + ends.longest * *item.line_step / LineForm::kSteps;
    painter.setPen(QPen(colors.press, 8.0 * unit, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(ends.left, y), QPointF(right, y));
  }

  std::optional<Action> action_of_key(const Scene& scene, int key,
                                      const QString& typed) const override {
    if (key == Qt::Key_Left) return Action{.what = Action::What::step, .number = -1};
    if (key == Qt::Key_Right) return Action{.what = Action::What::step, .number = 1};
    return key_of_question(scene, key, typed);
  }

  std::optional<double> position_at(const Item& item, QPointF at) const override {
    if (item.kind != Item::Kind::line) return {};
    const LineEnds ends = ends_of(item);
    const double position = std::clamp((at.x() - ends.left) / ends.longest, 0.0, 1.0);
    return std::max(1.0, std::round(position * LineForm::kSteps)) / LineForm::kSteps;
  }
};

}  // namespace

const ParticipantPage& line_page() {
  static const LinePage kScenePage{};
  return kScenePage;
}

}  // namespace asperity
