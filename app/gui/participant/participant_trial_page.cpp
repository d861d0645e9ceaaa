#include "app/gui/participant/participant_page.h"

namespace asperity {

namespace {

/// Squares of one size in rows, as large as fits, each with its key below or beside it.
struct Grid {
  int columns = 1;
  int rows = 1;
  double side = 0.0;
  QSizeF key{};  ///< what the key adds to the square
};
Grid grid_for(int count, QSizeF room, double gap, double key) {
  Grid best{};
  for (const QSizeF added : {QSizeF(0.0, key), QSizeF(key, 0.0)}) {
    for (int columns = 1; columns <= count; ++columns) {
      const int rows = (count + columns - 1) / columns;
      const double side =
          std::floor(std::min((room.width() - (columns - 1) * gap) / columns - added.width(),
                              (room.height() - (rows - 1) * gap) / rows - added.height()));
      if (side > best.side) best = {columns, rows, side, added};
    }
  }
  return best;
}

}  // namespace

bool ParticipantPage::shows_pictures() const {
  return std::any_of(scene_.choices.begin(), scene_.choices.end(),
                     [](const Scene::Choice& choice) { return choice.picture.has_value(); });
}

void ParticipantPage::chips_in_a_row(double height) {
  const double width = px(112.0);
  const auto count = static_cast<double>(scene_.surfaces.size());
  const double total = count * width + (count - 1.0) * px(kGap);
  double x = body_.center().x() - total / 2.0;
  for (std::size_t i = 0; i < scene_.surfaces.size(); ++i) {
    const std::size_t index = inputs_.mirrored ? scene_.surfaces.size() - 1 - i : i;
    const Scene::Surface& surface = scene_.surfaces[index];
    Item& chip = add({.kind = Item::Kind::chip,
                      .rect = QRectF(x, body_.top(), width, height),
                      .text = text_from(surface.code),
                      .size_px = letters(kPrompt_px),
                      .bold = true,
                      .felt = surface.felt,
                      .current = surface.now});
    if (surface.can_go) {
      chip.action = Action{.what = Action::What::surface, .number = static_cast<int>(index) + 1};
    }
    x += width + px(kGap);
  }
  body_.setTop(body_.top() + height + px(kGap));
}

void ParticipantPage::chips_beside() {
  const auto count = static_cast<double>(scene_.surfaces.size());
  const QRectF strip = take_side(px(136.0));
  const double height =
      std::min(px(kChip), (strip.height() - (count - 1.0) * px(kGap)) / std::max(1.0, count));
  double y = strip.center().y() - (count * height + (count - 1.0) * px(kGap)) / 2.0;
  const std::optional<int> picked = inputs_.draft.surface;
  for (std::size_t i = 0; i < scene_.surfaces.size(); ++i) {
    const int number = static_cast<int>(i) + 1;
    Item& chip = add({.kind = Item::Kind::chip,
                      .rect = QRectF(strip.left(), y, strip.width(), height),
                      .text = text_from(scene_.surfaces[i].code),
                      .key = text_from(scene_.surfaces[i].code),
                      .size_px = letters(kPrompt_px),
                      .bold = true,
                      .points_left = inputs_.mirrored,
                      .current = picked ? *picked == number : scene_.assigning == i,
                      .action = Action{.what = Action::What::surface, .number = number}});
    for (const Scene::Choice& choice : scene_.choices) {
      if (choice.assigned_to == scene_.surfaces[i].code) chip.given = text_from(choice.key);
    }
    y += height + px(kGap);
  }
}

ParticipantItem ParticipantPage::answer_in_words(std::size_t index) const {
  const Scene::Choice& choice = scene_.choices[index];
  return {.kind = Item::Kind::option,
          .text = words_of(choice.saying, choice.text),
          .key = text_from(choice.key),
          .size_px = letters(kText_px),
          .chosen = choice.chosen,
          .action = Action{.what = Action::What::choose, .number = static_cast<int>(index) + 1}};
}

// At the inner end of the row of controls where there is room, so that it is not taken for one.
void ParticipantPage::answers_in_words_as_controls() {
  for (std::size_t i = 0; i < scene_.choices.size(); ++i) {
    if (scene_.choices[i].picture) continue;
    const double row_top = controls_top_;
    add_control(answer_in_words(i));
    QRectF& rect = items_.back().rect;
    if (controls_top_ != row_top) continue;
    control_x_ -= rect.width() + px(is_wide() ? kGap : kGap / 2.0);
    if (inputs_.mirrored) {
      rect.moveRight(body_.right());
    } else {
      rect.moveLeft(body_.left());
    }
  }
}

void ParticipantPage::options_without_picture() {
  for (std::size_t i = scene_.choices.size(); i-- > 0;) {
    if (scene_.choices[i].picture || scene_.choices[i].text.empty()) continue;
    Item answer = answer_in_words(i);
    const double width = std::min(body_.width(), width_of_answer(answer.text));
    answer.rect =
        QRectF(body_.center().x() - width / 2.0, body_.bottom() - px(kOption), width, px(kOption));
    body_.setBottom(answer.rect.top() - px(kGap));
    add(std::move(answer));
  }
}

void ParticipantPage::pictures(QRectF room) {
  std::vector<std::size_t> those{};
  for (std::size_t i = 0; i < scene_.choices.size(); ++i) {
    if (scene_.choices[i].picture) those.push_back(i);
  }
  const int count = static_cast<int>(those.size());
  if (count == 0) return;
  const double gap = px(1.5 * kGap);
  const Grid grid = grid_for(count, room.size(), gap, px(kBadge) + px(kGap) / 2.0);
  const QSizeF cell = QSizeF(grid.side, grid.side) + grid.key;
  double y = room.center().y() - (grid.rows * cell.height() + (grid.rows - 1) * gap) / 2.0;
  // A last row that is not full begins where the others do.
  const double left = std::floor(room.center().x() -
                                 (grid.columns * cell.width() + (grid.columns - 1) * gap) / 2.0);
  for (int row = 0; row < grid.rows; ++row) {
    const int first = row * grid.columns;
    double x = left;
    for (int place = first; place < std::min(first + grid.columns, count); ++place) {
      const std::size_t index = those[static_cast<std::size_t>(place)];
      const Scene::Choice& choice = scene_.choices[index];
      add({.kind = Item::Kind::picture,
           .rect = QRectF(QPointF(x, std::floor(y)), cell),
           .key = text_from(choice.key),
           .picture = text_from(*choice.picture),
           .side = grid.side,
           .size_px = letters(kText_px),
           .chosen = choice.chosen || !choice.assigned_to.empty(),
           .given_to = text_from(choice.assigned_to),
           .action = Action{.what = Action::What::choose, .number = static_cast<int>(index) + 1}});
      x += cell.width() + gap;
    }
    y += cell.height() + gap;
  }
}

void ParticipantPage::letter_options(QRectF room) {
  std::vector<std::size_t> those{};
  for (std::size_t i = 0; i < scene_.choices.size(); ++i) {
    if (!scene_.choices[i].picture && scene_.choices[i].text.empty()) those.push_back(i);
  }
  const int count = static_cast<int>(those.size());
  if (count == 0) return;
  const double gap = px(2 * kGap);
  Grid grid = grid_for(count, room.size(), gap, 0.0);
  // One row where the letters stay large in it.
  const double in_one_row = (room.width() - (count - 1) * gap) / count;
  if (in_one_row >= px(88.0)) grid = {count, 1, std::min(in_one_row, room.height())};
  grid.side = std::min(grid.side, letter_side());
  double y = room.center().y() - (grid.rows * grid.side + (grid.rows - 1) * gap) / 2.0;
  for (int row = 0; row < grid.rows; ++row) {
    const int first = row * grid.columns;
    const int in_row = std::min(grid.columns, count - first);
    double x = room.center().x() - (in_row * grid.side + (in_row - 1) * gap) / 2.0;
    for (int place = first; place < first + in_row; ++place) {
      const std::size_t index = those[static_cast<std::size_t>(place)];
      const Scene::Choice& choice = scene_.choices[index];
      add({.kind = Item::Kind::option,
           .rect = QRectF(x, y, grid.side, grid.side),
           .text = text_from(choice.key),
           .size_px = letters(kLarge_px),
           .bold = true,
           .chosen = choice.chosen,
           .action = Action{.what = Action::What::choose, .number = static_cast<int>(index) + 1}});
      x += grid.side + gap;
    }
    y += grid.side + gap;
  }
}

void ParticipantPage::standard_beside() {
  if (!scene_.standard_picture) return;
  Item standard{.kind = Item::Kind::standard, .picture = text_from(*scene_.standard_picture)};
  if (is_wide()) {
    const double side = std::floor(std::min(body_.height(), 0.42 * body_.width()));
    const QRectF strip = take_side(0.46 * body_.width());
    standard.rect =
        QRectF(strip.center().x() - side / 2.0, strip.center().y() - side / 2.0, side, side);
  } else {
    const double group = letter_side() + px(kGap) + px(kOption) + px(2 * kGap);
    const double side = std::floor(std::min(body_.height() - group, body_.width()));
    standard.rect = QRectF(body_.center().x() - side / 2.0, body_.top(), side, side);
    body_.setTop(standard.rect.bottom() + px(kGap));
  }
  standard.side = standard.rect.width();
  add(std::move(standard));
}

void ParticipantPage::feel() {
  const bool shows_more =
      !scene_.choices.empty() || scene_.standard_picture || scene_.show_workspace;
  const QString text = scene_text();
  const bool has_chips = scene_.surfaces.size() > 1;
  const double chips = has_chips ? px(kChip) : 0.0;
  if (!shows_more) {
    const double height = height_of(text, letters(kLarge_px), true, column().width());
    body_.setTop(body_.center().y() - (height + px(2 * kGap) + chips) / 2.0);
  }
  prompt(text, letters(shows_more ? kPrompt_px : kLarge_px));
  if (!shows_more) body_.setTop(body_.top() + px(kGap));
  if (has_chips) chips_in_a_row(chips);
  if (!shows_more) return;
  if (scene_.show_workspace) {
    const bool alone = scene_.choices.empty() && !scene_.standard_picture;
    const QRectF place = alone ? body_ : take_side(0.55 * body_.width());
    add({.kind = Item::Kind::workspace, .rect = place});
  }
  if (shows_pictures()) {
    pictures(body_);
  } else if (scene_.standard_picture) {
    const double side = std::floor(std::min(body_.height(), body_.width()));
    add({.kind = Item::Kind::standard,
         .rect =
             QRectF(body_.center().x() - side / 2.0, body_.center().y() - side / 2.0, side, side),
         .picture = text_from(*scene_.standard_picture)});
  }
}

void ParticipantPage::question() {
  prompt(scene_text(), letters(kPrompt_px));
  if (scene_.is_assignment) chips_beside();
  if (shows_pictures()) {
    pictures(body_);
    return;
  }
  standard_beside();
  // Letters and the answers in words make one group, in the middle of what is left.
  const QRectF whole = body_;
  options_without_picture();
  const double in_words = whole.bottom() - body_.bottom();
  const bool has_letters =
      std::any_of(scene_.choices.begin(), scene_.choices.end(),
                  [](const Scene::Choice& choice) { return choice.text.empty(); });
  if (!has_letters) return;
  const double group = letter_side() + px(kGap) + in_words;
  const double lift = std::max(0.0, (whole.height() - group) / 2.0);
  for (Item& item : items_) {
    if (item.kind == Item::Kind::option) item.rect.translate(0.0, -lift);
  }
  body_.translate(0.0, -lift);
  letter_options(QRectF(whole.left(), body_.bottom() - letter_side() - px(kGap), whole.width(),
                        letter_side()));
}

}  // namespace asperity
