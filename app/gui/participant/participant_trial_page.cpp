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
/// `key`: of the key with the space between it and the square.
Grid grid_for(int count, QSizeF room, double gap, QSizeF key) {
  Grid best{};
  for (const QSizeF added : {QSizeF(0.0, key.height()), QSizeF(key.width(), 0.0)}) {
    for (int columns = 1; columns <= count; ++columns) {
      const int rows = (count + columns - 1) / columns;
      // Keys stand apart, however small the squares over them are.
      if ((room.width() - (columns - 1) * gap) / columns < key.width()) break;
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

void ParticipantPage::chips_in_rows() {
  const int count = static_cast<int>(scene_.surfaces.size());
  const double gap = px(kGap);
  // Room for the letter and the mark of one that was felt.
  const double least = em(80.0);
  const int columns = std::clamp(static_cast<int>((body_.width() + gap) / (least + gap)), 1, count);
  const int rows = (count + columns - 1) / columns;
  const int in_a_row = (count + rows - 1) / rows;
  const double width = std::min(em(112.0), (body_.width() - (in_a_row - 1) * gap) / in_a_row);
  const double height = tall(kChip);
  for (int row = 0; row < rows; ++row) {
    const int first = row * in_a_row;
    const int here = std::min(in_a_row, count - first);
    double x = body_.center().x() - (here * width + (here - 1) * gap) / 2.0;
    for (int place = first; place < first + here; ++place) {
      const int index = inputs_.mirrored ? 2 * first + here - 1 - place : place;
      const Scene::Surface& surface = scene_.surfaces[static_cast<std::size_t>(index)];
      Item& chip = add({.kind = Item::Kind::chip,
                        .rect = QRectF(x, body_.top(), width, height),
                        .text = text_from(surface.code),
                        .size_px = letters(width < em(96.0) ? kText : kPrompt),
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

void ParticipantPage::chips_to_pair() {
  const ChipRows over = chip_rows();
  const int columns = chip_columns();
  const double beside = columns * em(columns == 1 ? 136.0 : 112.0) + px(2.5 * kGap);
  const double side_over = picture_side({body_.width(), body_.height() - over.height - px(kGap)});
  const double side_beside = picture_side({body_.width() - beside, body_.height()});
  if (is_tight() && side_over > side_beside) {
    chips_over(over);
  } else {
    chips_beside();
  }
}

ParticipantItem ParticipantPage::chip_to_pair(std::size_t index) const {
  const Scene::Surface& surface = scene_.surfaces[index];
  const int number = static_cast<int>(index) + 1;
  const std::optional<int> picked = inputs_.draft.surface;
  Item chip{.kind = Item::Kind::chip,
            .text = text_from(surface.code),
            .key = text_from(surface.code),
            .size_px = letters(kText),
            .bold = true,
            .current = picked ? *picked == number : scene_.assigning == index,
            .action = Action{.what = Action::What::surface, .number = number}};
  for (const Scene::Choice& choice : scene_.choices) {
    if (choice.assigned_to == surface.code) chip.given = text_from(choice.key);
  }
  return chip;
}

ParticipantPage::ChipRows ParticipantPage::chip_rows() const {
  const int count = std::max(1, static_cast<int>(scene_.surfaces.size()));
  ChipRows rows{.gap = px(kGap) / 4.0};
  // Room for a letter, a line and a key of two digits.
  const double least = em(100.0);
  const int most =
      std::clamp(static_cast<int>((body_.width() + rows.gap) / (least + rows.gap)), 1, count);
  rows.rows = (count + most - 1) / most;
  rows.in_a_row = (count + rows.rows - 1) / rows.rows;
  const double width = (body_.width() - (rows.in_a_row - 1) * rows.gap) / rows.in_a_row;
  rows.chip = QSizeF(std::min(em(136.0), width), em(42.0));
  rows.height = rows.rows * (rows.chip.height() + rows.gap) - rows.gap;
  return rows;
}

void ParticipantPage::chips_over(const ChipRows& rows) {
  const int count = static_cast<int>(scene_.surfaces.size());
  const double step = rows.chip.width() + rows.gap;
  const double left = body_.center().x() - (rows.in_a_row * step - rows.gap) / 2.0;
  for (int i = 0; i < count; ++i) {
    const int place = i % rows.in_a_row;
    const int column = inputs_.mirrored ? rows.in_a_row - 1 - place : place;
    Item chip = chip_to_pair(static_cast<std::size_t>(i));
    chip.rect = QRectF(QPointF(left + column * step,
                               body_.top() + i / rows.in_a_row * (rows.chip.height() + rows.gap)),
                       rows.chip);
    chip.points_down = true;
    add(std::move(chip));
  }
  body_.setTop(body_.top() + rows.height + px(kGap));
}

int ParticipantPage::chip_columns() const {
  // One under the other, in two columns where they would be too low for a letter.
  const int count = static_cast<int>(scene_.surfaces.size());
  const double height = (body_.height() - (count - 1) * px(kGap) / 2.0) / count;
  return height < em(44.0) ? 2 : 1;
}

void ParticipantPage::chips_beside() {
  const int count = static_cast<int>(scene_.surfaces.size());
  const double gap = px(kGap) / 2.0;
  const int columns = chip_columns();
  const int rows = (count + columns - 1) / columns;
  const double width = em(columns == 1 ? 136.0 : 112.0);
  const QRectF strip = take_side(columns * width + (columns - 1) * gap);
  const double height = std::min(em(kChip), (body_.height() - (rows - 1) * gap) / rows);
  const double between =
      rows < 2 ? 0.0 : std::min(px(kGap), (strip.height() - rows * height) / (rows - 1));
  const double top = strip.center().y() - (rows * height + (rows - 1) * between) / 2.0;
  for (int i = 0; i < count; ++i) {
    Item chip = chip_to_pair(static_cast<std::size_t>(i));
    chip.rect = QRectF(strip.left() + (i / rows) * (width + gap),
                       top + (i % rows) * (height + between), width, height);
    if (height >= em(kOneLine) && columns == 1) chip.size_px = letters(kPrompt);
    chip.points_left = inputs_.mirrored;
    add(std::move(chip));
  }
}

ParticipantItem ParticipantPage::answer_in_words(std::size_t index) const {
  const Scene::Choice& choice = scene_.choices[index];
  return {.kind = Item::Kind::option,
          .text = words_of(choice.saying, choice.text, scene_.language),
          .key = text_from(choice.key),
          .size_px = letters(kText),
          .chosen = choice.chosen,
          .action = Action{.what = Action::What::choose, .number = static_cast<int>(index) + 1}};
}

void ParticipantPage::answers_in_words_as_controls() {
  for (std::size_t i = 0; i < scene_.choices.size(); ++i) {
    if (scene_.choices[i].picture) continue;
    Item answer = answer_in_words(i);
    const double width = width_of_answer(answer.text);
    add_at_inner_end(std::move(answer), width);
  }
}

double ParticipantPage::height_of_answers_in_words() const {
  double height = 0.0;
  for (const Scene::Choice& choice : scene_.choices) {
    if (choice.picture || choice.text.empty()) continue;
    const QString text = words_of(choice.saying, choice.text, scene_.language);
    height += height_of_answer(text, std::min(body_.width(), width_of_answer(text))) + px(kGap);
  }
  return height;
}

// From below, in their order.
void ParticipantPage::answers_in_words() {
  for (std::size_t i = scene_.choices.size(); i-- > 0;) {
    if (scene_.choices[i].picture || scene_.choices[i].text.empty()) continue;
    Item answer = answer_in_words(i);
    const double width = std::min(body_.width(), width_of_answer(answer.text));
    const double height = height_of_answer(answer.text, width);
    answer.rect = QRectF(body_.center().x() - width / 2.0, body_.bottom() - height, width, height);
    body_.setBottom(answer.rect.top() - px(kGap));
    add(std::move(answer));
  }
}

namespace {

QSizeF key_size(const std::vector<ParticipantScene::Choice>& choices, double narrow, double wide) {
  const bool has_two_digits =
      std::any_of(choices.begin(), choices.end(), [](const ParticipantScene::Choice& choice) {
        return choice.picture && choice.key.size() > 1;
      });
  return {has_two_digits ? wide : narrow, narrow};
}

}  // namespace

double ParticipantPage::picture_side(QSizeF room) const {
  const auto count = std::count_if(scene_.choices.begin(), scene_.choices.end(),
                                   [](const Scene::Choice& choice) { return choice.picture; });
  const QSizeF key = key_size(scene_.choices, em(kBadge), em(kWideBadge));
  const QSizeF around(px(kGap) / 2.0, px(kGap) / 2.0);
  return grid_for(static_cast<int>(count), room, picture_gap(), key + around).side;
}

/// Many small pictures give their room to themselves.
double ParticipantPage::picture_gap() const {
  constexpr std::size_t kMany = 8;
  return px((is_tight() && scene_.choices.size() > kMany ? 0.5 : 1.5) * kGap);
}

void ParticipantPage::pictures(QRectF room) {
  std::vector<std::size_t> those{};
  for (std::size_t i = 0; i < scene_.choices.size(); ++i) {
    if (scene_.choices[i].picture) those.push_back(i);
  }
  const int count = static_cast<int>(those.size());
  if (count == 0) return;
  const double gap = picture_gap();
  const QSizeF key = key_size(scene_.choices, em(kBadge), em(kWideBadge));
  const QSizeF around(px(kGap) / 2.0, px(kGap) / 2.0);
  const Grid grid = grid_for(count, room.size(), gap, key + around);
  const QSizeF cell = QSizeF(grid.side, grid.side) + grid.key;
  double y = std::max(
      room.top(),
      std::floor(room.center().y() - (grid.rows * cell.height() + (grid.rows - 1) * gap) / 2.0));
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
           .rect = QRectF(QPointF(x, y), cell),
           .key = text_from(choice.key),
           .picture = text_from(*choice.picture),
           .side = grid.side,
           .size_px = letters(kText),
           .chosen = choice.chosen || !choice.assigned_to.empty(),
           .given_to = text_from(choice.assigned_to),
           .action = Action{.what = Action::What::choose, .number = static_cast<int>(index) + 1}});
      x += cell.width() + gap;
    }
    y += cell.height() + gap;
  }
}

/// As few rows as keep the letters large in them.
ParticipantPage::Letters ParticipantPage::letter_rows(QSizeF room) const {
  const auto count = static_cast<int>(std::count_if(
      scene_.choices.begin(), scene_.choices.end(),
      [](const Scene::Choice& choice) { return !choice.picture && choice.text.empty(); }));
  if (count == 0) return {.columns = 0, .rows = 0};
  const double gap = px(kGap) * (count > 6 ? 1.0 : 2.0);
  Letters best{};
  for (int rows = 1; rows <= count; ++rows) {
    const int columns = (count + rows - 1) / rows;
    const double side =
        std::floor(std::min({letter_side(), (room.width() - (columns - 1) * gap) / columns,
                             (room.height() - (rows - 1) * gap) / rows}));
    if (side > best.side) {
      best = {
          .columns = columns, .rows = rows, .side = side, .height = rows * side + (rows - 1) * gap};
    }
    if (best.side >= em(kSmallLetter)) break;
  }
  return best;
}

void ParticipantPage::letter_options(QRectF room) {
  std::vector<std::size_t> those{};
  for (std::size_t i = 0; i < scene_.choices.size(); ++i) {
    if (!scene_.choices[i].picture && scene_.choices[i].text.empty()) those.push_back(i);
  }
  const int count = static_cast<int>(those.size());
  const Letters grid = letter_rows(room.size());
  const double gap = px(kGap) * (count > 6 ? 1.0 : 2.0);
  double y = room.center().y() - grid.height / 2.0;
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
           .size_px = letters(grid.side < em(76.0) ? kText : kLarge),
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
    const double words = height_of_answers_in_words();
    const double group = words + px(2 * kGap) + letter_rows(body_.size()).height;
    const double room = std::max(em(64.0), body_.height() - group);
    const double side = std::floor(std::min(room, body_.width()));
    standard.rect = QRectF(body_.center().x() - side / 2.0, body_.top(), side, side);
    body_.setTop(standard.rect.bottom() + px(kGap));
  }
  standard.side = standard.rect.width();
  add(std::move(standard));
}

double ParticipantPage::guide_height() const {
  if (!scene_.guide) return 0.0;
  constexpr double kRow = 88.0;
  const GuideRows rows = guide_rows(*scene_.guide);
  const double wanted =
      rows.count() * tall(kRow, kOneLine) + rows.bars() * height_of_guide_numbers(letters(kText));
  return std::min(wanted, std::floor(0.6 * body_.height()));
}

void ParticipantPage::guide(const QRectF& place) {
  const GuideRows rows = guide_rows(*scene_.guide);
  if (rows.count() == 0) return;
  // Where the window is too low for both, the mark in its band comes before the numbers.
  double numbers = height_of_guide_numbers(letters(kText));
  double row = (place.height() - rows.bars() * numbers) / rows.count();
  const bool has_numbers = row >= em(kOneLine);
  if (!has_numbers) {
    numbers = 0.0;
    row = place.height() / rows.count();
  }
  std::vector<QString> names{};
  if (rows.force)
    names.push_back(has_numbers ? said(phrase("ParticipantLayout", "Force, N"))
                                : said(phrase("ParticipantLayout", "Force")));
  if (rows.speed)
    names.push_back(has_numbers ? said(phrase("ParticipantLayout", "Speed, mm/s"))
                                : said(phrase("ParticipantLayout", "Speed")));
  double beside = 0.0;
  for (const QString& name : names) {
    beside = std::max(beside, width_of(name, letters(kText), true) + px(kGap));
  }
  double top = place.top() + rows.track * row;
  for (const QString& name : names) {
    add({.rect = QRectF(place.left(), top, beside, row),
         .text = name,
         .size_px = letters(kText),
         .bold = true,
         .left_aligned = true});
    top += row + numbers;
  }
  add({.kind = Item::Kind::guide,
       .rect = place.adjusted(beside, 0.0, 0.0, 0.0),
       .size_px = has_numbers ? letters(kText) : 0});
}

void ParticipantPage::feel() {
  const bool shows_more =
      !scene_.choices.empty() || scene_.standard_picture || scene_.show_workspace;
  const QString text = scene_text();
  const bool has_chips = scene_.surfaces.size() > 1;
  const double guided = guide_height();
  if (!shows_more) {
    const double chips = has_chips ? tall(kChip) : 0.0;
    const double height = height_of(text, letters(kLarge), true, column().width());
    const double below = guided > 0.0 ? guided + px(2 * kGap) : 0.0;
    const double group = height + px(2 * kGap) + chips + below;
    body_.setTop(std::max(body_.top(), body_.center().y() - group / 2.0));
  }
  prompt(text, letters(shows_more ? kPrompt : kLarge));
  if (!shows_more) body_.setTop(body_.top() + px(kGap));
  if (has_chips) chips_in_rows();
  if (guided > 0.0) {
    const double above = has_chips && !shows_more ? px(kGap) : 0.0;
    QRectF place = column();
    place.setTop(place.top() + above);
    place.setHeight(std::min(guided, body_.height() - above));
    if (shows_more) {
      place.moveBottom(body_.bottom());
      body_.setBottom(place.top() - px(kGap));
    }
    guide(place);
  }
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

/// Pictures of half the size that they would have without a question over them, or large enough;
/// letters that can be pressed.
bool ParticipantPage::is_enough_for_question(double height) const {
  if (shows_pictures()) {
    const double width =
        body_.width() - (scene_.is_answered_by<AssignmentForm>() ? em(136.0) + px(2 * kGap) : 0.0);
    const double alone = picture_side({width, body_.height()});
    const double chips =
        scene_.is_answered_by<AssignmentForm>()
            ? static_cast<double>((scene_.surfaces.size() + 1) / 2) * (em(40.0) + px(kGap) / 2.0)
            : 0.0;
    return height >= chips && picture_side({width, height}) >= std::min(0.5 * alone, em(128.0));
  }
  double width = body_.width();
  double needed = height_of_answers_in_words();
  if (scene_.standard_picture) {
    if (is_wide()) {
      width = 0.54 * width - px(2 * kGap);
      if (height < em(200.0)) return false;
    } else {
      needed += em(144.0) + px(2 * kGap);
    }
  }
  const Letters rows = letter_rows({width, height - needed});
  return rows.rows == 0 ? height >= needed : rows.side >= em(64.0);
}

void ParticipantPage::question() {
  if (scene_.is_answered_by<ScaleForm>()) {
    scales();
    return;
  }
  if (scene_.is_answered_by<NumberForm>()) {
    const bool is_answered_here =
        question_over(scene_text(), [this](double height) { return is_enough_for_number(height); });
    pages_ = std::max(pages_, question_pages_ + 1);
    if (is_answered_here)
      number_pad(said(phrase("ParticipantLayout", "Any number above 0")), Sign::none);
    return;
  }
  const bool answers =
      question_over(scene_text(), [this](double height) { return is_enough_for_question(height); });
  pages_ = std::max(pages_, question_pages_ + 1);
  if (!answers) return;
  if (scene_.is_answered_by<AssignmentForm>()) chips_to_pair();
  if (shows_pictures()) {
    pictures(body_);
    return;
  }
  standard_beside();
  // Letters and the answers in words make one group, in the middle of what is left.
  const double in_words = height_of_answers_in_words();
  const Letters rows =
      letter_rows({body_.width(), std::max(em(64.0), body_.height() - in_words - px(kGap))});
  const double group = rows.height + (rows.rows > 0 ? px(kGap) : 0.0) + in_words;
  const double lift = std::max(0.0, (body_.height() - group) / 2.0);
  body_.setBottom(body_.bottom() - lift);
  answers_in_words();
  if (rows.rows == 0) return;
  letter_options(QRectF(body_.left(), body_.bottom() - rows.height, body_.width(), rows.height));
}

}  // namespace asperity
