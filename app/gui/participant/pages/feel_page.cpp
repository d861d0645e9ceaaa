// Lays out the instruction, the guide, the workspace and the pictures around it, and draws surfaces as chips.

#include "app/gui/participant/pages/feel_page.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/gui/participant/pages/guide_rows.h"
#include "app/gui/participant/pages/page_frame.h"
#include "app/gui/participant/pages/participant_brush.h"
#include "app/gui/participant/pages/picture_grid.h"
#include "app/gui/participant/pages/trial_controls.h"

namespace asperity {

namespace {

using Action = ParticipantAction;
using Item = ParticipantItem;
using Scene = ParticipantScene;

/// Several surfaces are felt at once.
bool is_side_by_side(const Scene& scene) {
  return std::count_if(scene.surfaces.begin(), scene.surfaces.end(),
                       [](const Scene::Surface& surface) { return surface.now; }) > 1;
}

/// What is to be felt, and beside or below it the guide, the workspace, the pictures.
class FeelLayout final {
 public:
  explicit FeelLayout(PageFrame& frame)
      : frame_(frame), scene_(frame.scene()), body_(frame.body()) {}

  void lay_out();

 private:
  void chips_in_rows();
  double guide_height() const;
  void guide(const QRectF& place);
  void surface_of_pointer(QRectF place);

  PageFrame& frame_;
  const Scene& scene_;
  QRectF& body_;
};

void FeelLayout::lay_out() {
  const bool has_surface = frame_.inputs().surface_aspect > 0.0 && !scene_.show_workspace;
  const bool shows_more =
      !scene_.choices.empty() || scene_.standard_picture || scene_.show_workspace || has_surface;
  const QString text = frame_.scene_text();
  const bool has_chips = scene_.surfaces.size() > 1;
  const double guided = guide_height();
  if (!shows_more) {
    const double chips = has_chips ? frame_.tall(frame_.kChip) : 0.0;
    const double height =
        frame_.height_of(text, frame_.letters(frame_.kLarge), true, frame_.column().width());
    const double below = guided > 0.0 ? guided + frame_.px(2 * frame_.kGap) : 0.0;
    const double group = height + frame_.px(2 * frame_.kGap) + chips + below;
    body_.setTop(std::max(body_.top(), body_.center().y() - group / 2.0));
  }
  frame_.prompt(text, frame_.letters(shows_more ? frame_.kPrompt : frame_.kLarge));
  if (!shows_more) body_.setTop(body_.top() + frame_.px(frame_.kGap));
  if (has_chips) chips_in_rows();
  const bool alone = scene_.choices.empty() && !scene_.standard_picture;
  if (guided > 0.0 && has_surface && alone) {
    // One below the other, neither would have the height that it needs.
    surface_of_pointer(frame_.take_side(0.55 * body_.width()));
    const double height = std::min(guided, body_.height());
    guide(QRectF(body_.left(), body_.center().y() - height / 2.0, body_.width(), height));
    return;
  }
  if (guided > 0.0) {
    const double above = has_chips && !shows_more ? frame_.px(frame_.kGap) : 0.0;
    QRectF place = frame_.column();
    place.setTop(place.top() + above);
    place.setHeight(std::min(guided, body_.height() - above));
    if (shows_more) {
      place.moveBottom(body_.bottom());
      body_.setBottom(place.top() - frame_.px(frame_.kGap));
    }
    guide(place);
  }
  if (!shows_more) return;
  if (scene_.show_workspace || has_surface) {
    const QRectF place = alone ? body_ : frame_.take_side(0.55 * body_.width());
    if (has_surface) {
      surface_of_pointer(place);
    } else {
      frame_.add({.kind = Item::Kind::workspace, .rect = place});
    }
  }
  if (shows_pictures(scene_)) {
    add_pictures(frame_, body_);
  } else if (scene_.standard_picture) {
    const double side = std::floor(std::min(body_.height(), body_.width()));
    frame_.add({.kind = Item::Kind::standard,
                .rect = QRectF(body_.center().x() - side / 2.0, body_.center().y() - side / 2.0,
                               side, side),
                .picture = frame_.text_from(*scene_.standard_picture)});
  }
}

/// As large as there is room below what is to be done: nothing lies over it.
void FeelLayout::surface_of_pointer(QRectF place) {
  const QString what = frame_.said(phrase(
      "ParticipantLayout", "Keep the left mouse button pressed on the surface, and stroke it."));
  const int size_px = frame_.letters(frame_.kText);
  const double words = frame_.height_of(what, size_px, false, place.width());
  // On the smallest screens the surface comes before the words.
  if (words < 0.4 * place.height()) {
    frame_.add({.rect = QRectF(place.left(), place.top(), place.width(), words),
                .text = what,
                .size_px = size_px});
    place.setTop(place.top() + words + frame_.px(frame_.kGap));
  }
  const double aspect = frame_.inputs().surface_aspect;
  const double width = std::floor(std::min(place.width(), aspect * place.height()));
  const double height = std::floor(width / aspect);
  frame_.add({.kind = Item::Kind::surface,
              .rect = QRectF(place.center().x() - width / 2.0, place.center().y() - height / 2.0,
                             width, height)});
}

void FeelLayout::chips_in_rows() {
  const int count = static_cast<int>(scene_.surfaces.size());
  const double gap = frame_.px(frame_.kGap);
  // Room for the letter and the mark of one that was felt.
  const double least = frame_.em(80.0);
  const int columns = std::clamp(static_cast<int>((body_.width() + gap) / (least + gap)), 1, count);
  const int rows = (count + columns - 1) / columns;
  const int in_a_row = (count + rows - 1) / rows;
  const double width =
      std::min(frame_.em(112.0), (body_.width() - (in_a_row - 1) * gap) / in_a_row);
  const double height = frame_.tall(frame_.kChip);
  for (int row = 0; row < rows; ++row) {
    const int first = row * in_a_row;
    const int here = std::min(in_a_row, count - first);
    double x = body_.center().x() - (here * width + (here - 1) * gap) / 2.0;
    for (int place = first; place < first + here; ++place) {
      // Surfaces side by side lie in the workspace as their chips.
      const bool mirrored = frame_.inputs().mirrored && !is_side_by_side(scene_);
      const int index = mirrored ? 2 * first + here - 1 - place : place;
      const Scene::Surface& surface = scene_.surfaces[static_cast<std::size_t>(index)];
      Item& chip = frame_.add(
          {.kind = Item::Kind::chip,
           .rect = QRectF(x, body_.top(), width, height),
           .text = frame_.text_from(surface.code),
           .size_px = frame_.letters(width < frame_.em(96.0) ? frame_.kText : frame_.kPrompt),
           .bold = true,
           .felt = surface.felt,
           .current = surface.now});
      if (surface.can_go) {
        chip.action = Action{.what = Action::What::surface, .number = index + 1};
      }
      x += width + gap;
    }
    body_.setTop(body_.top() + height + gap);
  }
}

double FeelLayout::guide_height() const {
  if (!scene_.guide) return 0.0;
  constexpr double kRow = 88.0;
  const GuideRows rows = guide_rows(*scene_.guide);
  const double wanted = rows.count() * frame_.tall(kRow, frame_.kOneLine) +
                        rows.bars() * height_of_guide_numbers(frame_.letters(frame_.kText));
  return std::min(wanted, std::floor(0.6 * body_.height()));
}

void FeelLayout::guide(const QRectF& place) {
  const GuideRows rows = guide_rows(*scene_.guide);
  if (rows.count() == 0) return;
  // Where the window is too low for both, the mark in its band comes before the numbers.
  double numbers = height_of_guide_numbers(frame_.letters(frame_.kText));
  double row = (place.height() - rows.bars() * numbers) / rows.count();
  const bool has_numbers = row >= frame_.em(frame_.kOneLine);
  if (!has_numbers) {
    numbers = 0.0;
    row = place.height() / rows.count();
  }
  std::vector<QString> names{};
  if (rows.force)
    names.push_back(has_numbers ? frame_.said(phrase("ParticipantLayout", "Force, N"))
                                : frame_.said(phrase("ParticipantLayout", "Force")));
  if (rows.speed)
    names.push_back(has_numbers ? frame_.said(phrase("ParticipantLayout", "Speed, mm/s"))
                                : frame_.said(phrase("ParticipantLayout", "Speed")));
  double beside = 0.0;
  for (const QString& name : names) {
    beside = std::max(
        beside, frame_.width_of(name, frame_.letters(frame_.kText), true) + frame_.px(frame_.kGap));
  }
  double top = place.top() + rows.track * row;
  for (const QString& name : names) {
    frame_.add({.rect = QRectF(place.left(), top, beside, row),
                .text = name,
                .size_px = frame_.letters(frame_.kText),
                .bold = true,
                .left_aligned = true});
    top += row + numbers;
  }
  frame_.add({.kind = Item::Kind::guide,
              .rect = place.adjusted(beside, 0.0, 0.0, 0.0),
              .size_px = has_numbers ? frame_.letters(frame_.kText) : 0});
}

void draw_chip(ParticipantBrush& brush, const Item& item) {
  const ParticipantColors& colors = brush.colors();
  const double unit = item.size_px / 38.0;
  const QColor ink = item.current ? colors.on_press : colors.text;
  brush.box(item.rect, 10.0 * unit, item.current ? colors.press : colors.panel,
            item.current ? colors.text : colors.muted, (item.current ? 5.0 : 2.0) * unit);
  const bool marked = item.felt && !item.current;
  brush.write(item.rect, marked ? item.text + QStringLiteral(" ✓") : item.text, item.size_px, true,
              ink);
}

class FeelPage final : public ParticipantPage {
 public:
  void lay_out(PageFrame& frame) const override {
    if (frame.scene().kind == Scene::Kind::feel) FeelLayout(frame).lay_out();
  }

  void add_controls(PageFrame& frame) const override {
    if (frame.scene().kind != Scene::Kind::feel || !frame.scene().can_finish) return;
    frame.add_control(frame.said(is_side_by_side(frame.scene())
                                     ? phrase("ParticipantLayout", "Finish with these surfaces")
                                     : phrase("ParticipantLayout", "Finish with this surface")),
                      frame.space_key(), {.what = Action::What::next}, false);
  }

  void draw(ParticipantBrush& brush, const Item& item) const override {
    if (item.kind == Item::Kind::chip) {
      draw_chip(brush, item);
    } else {
      brush.draw(item);
    }
  }

  /// Between surfaces they are taken only to be refused.
  std::optional<Action> action_of_key(const Scene& scene, int key,
                                      const QString& typed) const override {
    if (scene.kind == Scene::Kind::blank && scene.surfaces.empty()) return {};
    return key_of_trial(scene, key, typed, SurfaceKeys::all);
  }
};

}  // namespace

const ParticipantPage& feel_page() {
  static const FeelPage kScenePage{};
  return kScenePage;
}

}  // namespace asperity
