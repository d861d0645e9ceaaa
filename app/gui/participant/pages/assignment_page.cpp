// Lays out the surfaces as chips next to the pictures or above them, with the given picture in each.

#include "app/gui/participant/pages/assignment_page.h"

#include <algorithm>
#include <cmath>

#include <QtGui/QPainter>
#include <QtGui/QPainterPath>

#include "app/gui/participant/pages/page_frame.h"
#include "app/gui/participant/pages/participant_brush.h"
#include "app/gui/participant/pages/picture_grid.h"
#include "app/gui/participant/pages/trial_controls.h"

namespace asperity {

namespace {

using Action = ParticipantAction;
using Item = ParticipantItem;
using Scene = ParticipantScene;

/// Surfaces that pictures are given to: in columns beside the pictures, or in rows over them.
class AssignmentLayout final {
 public:
  explicit AssignmentLayout(PageFrame& frame)
      : frame_(frame), scene_(frame.scene()), body_(frame.body()) {}

  void lay_out();

 private:
  struct ChipRows {
    int rows = 1;
    int in_a_row = 1;
    double gap = 0.0;
    QSizeF chip{};
    double height = 0.0;  ///< of all rows
  };
  bool is_enough(double height) const;
  void add_chips();
  int chip_columns() const;
  void chips_beside();
  ChipRows chip_rows() const;
  void chips_over(const ChipRows& rows);
  Item chip_of(std::size_t index) const;

  PageFrame& frame_;
  const Scene& scene_;
  QRectF& body_;
};

bool AssignmentLayout::is_enough(double height) const {
  const double width = body_.width() - (frame_.em(136.0) + frame_.px(2 * frame_.kGap));
  const double chips = static_cast<double>((scene_.surfaces.size() + 1) / 2) *
                       (frame_.em(40.0) + frame_.px(frame_.kGap) / 2.0);
  return height >= chips && is_enough_for_pictures(frame_, {width, height});
}

void AssignmentLayout::lay_out() {
  const bool answers = frame_.question_over(frame_.scene_text(),
                                            [this](double height) { return is_enough(height); });
  frame_.need_pages(frame_.question_pages() + 1);
  if (!answers) return;
  add_chips();
  add_pictures(frame_, body_);
}

void AssignmentLayout::add_chips() {
  const ChipRows over = chip_rows();
  const int columns = chip_columns();
  const double beside =
      columns * frame_.em(columns == 1 ? 136.0 : 112.0) + frame_.px(2.5 * frame_.kGap);
  const double side_over =
      picture_side(frame_, {body_.width(), body_.height() - over.height - frame_.px(frame_.kGap)});
  const double side_beside = picture_side(frame_, {body_.width() - beside, body_.height()});
  if (frame_.is_tight() && side_over > side_beside) {
    chips_over(over);
  } else {
    chips_beside();
  }
}

ParticipantItem AssignmentLayout::chip_of(std::size_t index) const {
  const Scene::Surface& surface = scene_.surfaces[index];
  const int number = static_cast<int>(index) + 1;
  const std::optional<int> picked = frame_.inputs().draft.surface;
  Item chip{.kind = Item::Kind::chip,
            .text = frame_.text_from(surface.code),
            .key = frame_.text_from(surface.code),
            .size_px = frame_.letters(frame_.kText),
            .bold = true,
            .current = picked ? *picked == number : scene_.assigning == index,
            .action = Action{.what = Action::What::surface, .number = number}};
  for (const Scene::Choice& choice : scene_.choices) {
    if (choice.assigned_to == surface.code) chip.given = frame_.text_from(choice.key);
  }
  return chip;
}

AssignmentLayout::ChipRows AssignmentLayout::chip_rows() const {
  const int count = std::max(1, static_cast<int>(scene_.surfaces.size()));
  ChipRows rows{.gap = frame_.px(frame_.kGap) / 4.0};
  // Room for a letter, a line and a key of two digits.
  const double least = frame_.em(100.0);
  const int most =
      std::clamp(static_cast<int>((body_.width() + rows.gap) / (least + rows.gap)), 1, count);
  rows.rows = (count + most - 1) / most;
  rows.in_a_row = (count + rows.rows - 1) / rows.rows;
  const double width = (body_.width() - (rows.in_a_row - 1) * rows.gap) / rows.in_a_row;
  rows.chip = QSizeF(std::min(frame_.em(136.0), width), frame_.em(42.0));
  rows.height = rows.rows * (rows.chip.height() + rows.gap) - rows.gap;
  return rows;
}

void AssignmentLayout::chips_over(const ChipRows& rows) {
  const int count = static_cast<int>(scene_.surfaces.size());
  const double step = rows.chip.width() + rows.gap;
  const double left = body_.center().x() - (rows.in_a_row * step - rows.gap) / 2.0;
  for (int i = 0; i < count; ++i) {
    const int place = i % rows.in_a_row;
    const int column = frame_.inputs().mirrored ? rows.in_a_row - 1 - place : place;
    Item chip = chip_of(static_cast<std::size_t>(i));
    chip.rect = QRectF(QPointF(left + column * step,
                               body_.top() + i / rows.in_a_row * (rows.chip.height() + rows.gap)),
                       rows.chip);
    chip.points_down = true;
    frame_.add(std::move(chip));
  }
  body_.setTop(body_.top() + rows.height + frame_.px(frame_.kGap));
}

int AssignmentLayout::chip_columns() const {
  // One under the other, in two columns where they would be too low for a letter.
  const int count = static_cast<int>(scene_.surfaces.size());
  const double height = (body_.height() - (count - 1) * frame_.px(frame_.kGap) / 2.0) / count;
  return height < frame_.em(44.0) ? 2 : 1;
}

void AssignmentLayout::chips_beside() {
  const int count = static_cast<int>(scene_.surfaces.size());
  const double gap = frame_.px(frame_.kGap) / 2.0;
  const int columns = chip_columns();
  const int rows = (count + columns - 1) / columns;
  const double width = frame_.em(columns == 1 ? 136.0 : 112.0);
  const QRectF strip = frame_.take_side(columns * width + (columns - 1) * gap);
  const double height =
      std::min(frame_.em(frame_.kChip), (body_.height() - (rows - 1) * gap) / rows);
  const double between =
      rows < 2 ? 0.0
               : std::min(frame_.px(frame_.kGap), (strip.height() - rows * height) / (rows - 1));
  const double top = strip.center().y() - (rows * height + (rows - 1) * between) / 2.0;
  for (int i = 0; i < count; ++i) {
    Item chip = chip_of(static_cast<std::size_t>(i));
    chip.rect = QRectF(strip.left() + (i / rows) * (width + gap),
                       top + (i % rows) * (height + between), width, height);
    if (height >= frame_.em(frame_.kOneLine) && columns == 1)
      chip.size_px = frame_.letters(frame_.kPrompt);
    chip.points_left = frame_.inputs().mirrored;
    frame_.add(std::move(chip));
  }
}

/// A surface with the picture that it has.
void draw_chip_with_picture(ParticipantBrush& brush, const Item& item) {
  QPainter& painter = brush.painter();
  const ParticipantColors& colors = brush.colors();
  const double unit = item.size_px / 38.0;
  const bool filled = !item.given.isEmpty();
  const QColor ink = filled ? colors.on_press : colors.text;
  brush.box(item.rect, 10.0 * unit, filled ? colors.press : colors.panel,
            item.current ? colors.text : colors.muted, (item.current ? 5.0 : 2.0) * unit);
  // The half that is nearer to the pictures says which one it has.
  QRectF near = item.rect;
  QRectF far = item.rect;
  // A letter needs less room than a key of two digits.
  near.setWidth((item.points_down ? 0.6 : 0.5) * item.rect.width());
  far.setWidth(item.rect.width() - near.width());
  (item.points_left ? far : near).moveRight(item.rect.right());
  brush.write(far, item.text, item.size_px, true, ink, Qt::AlignCenter);
  if (!item.given.isEmpty()) {
    brush.write(near, item.given, item.size_px, false, ink, Qt::AlignCenter);
    painter.setPen(QPen(ink, 3.0 * unit));
    const QPointF middle(item.points_left ? near.right() : near.left(), item.rect.center().y());
    const double half = (item.points_down ? 6.0 : 9.0) * unit;
    painter.drawLine(middle - QPointF(half, 0.0), middle + QPointF(half, 0.0));
  } else if (item.current) {
    // Points to the pictures: the next one is for this surface.
    const double ahead = (item.points_left ? -1.0 : 1.0) * 9.0 * unit;
    const QPointF middle = near.center();
    const auto corner = [&](double along, double across) {
      return middle + (item.points_down ? QPointF(across, std::abs(ahead) / ahead * along)
                                        : QPointF(along, across));
    };
    QPainterPath arrow(corner(ahead, 0.0));
    arrow.lineTo(corner(-0.6 * ahead, -9.0 * unit));
    arrow.lineTo(corner(-0.6 * ahead, 9.0 * unit));
    arrow.closeSubpath();
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    painter.drawPath(arrow);
  }
}

class AssignmentPage final : public ParticipantPage {
 public:
  void lay_out(PageFrame& frame) const override { AssignmentLayout(frame).lay_out(); }

  void add_controls(PageFrame& frame) const override {
    add_question_controls(frame, *this, frame.scene().can_confirm);
    add_words_as_controls(frame);
  }

  void draw(ParticipantBrush& brush, const Item& item) const override {
    if (item.kind == Item::Kind::chip) {
      draw_chip_with_picture(brush, item);
    } else {
      brush.draw(item);
    }
  }

  std::optional<Action> action_of_key(const Scene& scene, int key,
                                      const QString& typed) const override {
    return key_of_question(scene, key, typed, SurfaceKeys::all);
  }

  /// The first digit has given its picture away.
  bool takes_two_digits() const override { return false; }

  ActionEffect act(const Scene& scene, const Action& action,
                   ParticipantDraft& draft) const override {
    using Kind = ParticipantInput::Kind;
    if (action.what == Action::What::surface) {
      if (draft.surface == action.number) {
        draft.surface.reset();
      } else {
        draft.surface = action.number;
      }
      return {};
    }
    if (draft.surface && action.what == Action::What::choose) {
      return {.told = ParticipantInput{
                  .kind = Kind::assign, .number = action.number, .surface = *draft.surface}};
    }
    if (draft.surface && action.what == Action::What::next && scene.can_switch) {
      return {.told = ParticipantInput{.kind = Kind::surface, .number = *draft.surface}};
    }
    return ParticipantPage::act(scene, action, draft);
  }

  QString carried_from(const Item& item) const override {
    return item.kind == Item::Kind::chip ? item.text : item.given_to;
  }

  /// A surface's letter that is let go over a picture is given to it; drawn off its picture, it is
  /// taken back.
  std::optional<ParticipantInput> dropped(const Scene& scene, const Item& from,
                                          const Item* onto) const override {
    ParticipantInput input{.kind = ParticipantInput::Kind::assign};
    if (onto != nullptr && onto->kind == Item::Kind::picture) {
      if (onto->action == from.action) return {};
      input.number = onto->action->number;
      const std::string letter = carried_from(from).toStdString();
      for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        if (scene.surfaces[i].code == letter) input.surface = static_cast<int>(i) + 1;
      }
      return input;
    }
    if (from.kind != Item::Kind::picture) return {};
    input.number = from.action->number;
    return input;
  }
};

}  // namespace

const ParticipantPage& assignment_page() {
  static const AssignmentPage kScenePage{};
  return kScenePage;
}

}  // namespace asperity
