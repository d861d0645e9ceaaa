#include "app/gui/participant/participant_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <QtCore/QCoreApplication>
#include <QtGui/QFontDatabase>
#include <QtGui/QFontMetricsF>

#include "app/gui/participant/participant_words.h"

namespace asperity {

namespace {

using Item = ParticipantItem;
using Action = ParticipantAction;
using Scene = ParticipantScene;

// Sizes at 1366 × 768, in pixels; everything grows with a larger window.
constexpr double kEdge = 32.0;
constexpr double kGap = 16.0;
constexpr double kLine = 48.0;     // progress, cue
constexpr double kControl = 72.0;  // height
constexpr double kBadge = 48.0;    // the key under a picture
constexpr double kChip = 80.0;     // height
constexpr double kOption = 72.0;   // height of an answer in words
constexpr double kLetter = 128.0;  // side of an answer that is a letter
constexpr double kSmallLetter = 88.0;
constexpr double kColumn = 1040.0;  // longer lines are hard to read
constexpr int kText_px = 32;        // 24 pt at 96 dots per inch: nothing is smaller
constexpr int kPrompt_px = 38;
constexpr int kLarge_px = 54;

QString from(const std::string& text) { return QString::fromStdString(text); }

bool is_picture_question(const Scene& scene) {
  return std::any_of(scene.choices.begin(), scene.choices.end(),
                     [](const Scene::Choice& choice) { return choice.picture.has_value(); });
}

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

/// Puts items into the picture from its edges inwards; `body_` is what is left.
class Page final {
  Q_DECLARE_TR_FUNCTIONS(ParticipantLayout)
 public:
  Page(const Scene& scene, const ParticipantLayoutInputs& inputs)
      : scene_(scene),
        inputs_(inputs),
        scale_(std::max(1.0, std::min(inputs.size.width() / 1366.0, inputs.size.height() / 768.0))),
        body_(QPointF(0.0, 0.0), inputs.size) {
    const double edge = std::min(px(kEdge), inputs.size.width() / 28.0);
    body_.adjust(edge, edge / 2.0, -edge, -edge);
  }

  std::vector<Item> lay_out();

 private:
  double px(double at_reference) const { return std::round(at_reference * scale_); }
  int letters(int at_reference_px) const { return static_cast<int>(px(at_reference_px)); }
  QString scene_text() const { return words_of(scene_.text_saying, scene_.text); }
  double letter_side() const { return px(is_wide() ? kLetter : kSmallLetter); }
  bool is_wide() const { return inputs_.size.width() > 1.1 * inputs_.size.height(); }

  double height_of(const QString& text, int size_px, bool bold, double width) const {
    const QFontMetricsF metrics(participant_font(size_px, bold));
    return std::ceil(
        metrics
            .boundingRect(QRectF(0.0, 0.0, width, 1e6), Qt::AlignHCenter | Qt::TextWordWrap, text)
            .height());
  }
  /// The place of words at the top of `room`, centred: as narrow as the same number of lines
  /// allows, so that no line is left with one word.
  QRectF place_of(const QString& text, int size_px, bool bold, const QRectF& room) const {
    const double height = height_of(text, size_px, bold, room.width());
    double fits = room.width();
    double too_narrow = 0.0;
    while (fits - too_narrow > 8.0) {
      const double width = std::floor((fits + too_narrow) / 2.0);
      (height_of(text, size_px, bold, width) > height ? too_narrow : fits) = width;
    }
    // A line more than was asked for would be an accident of rounding.
    fits = std::min(room.width(), fits + 8.0);
    return QRectF(room.center().x() - fits / 2.0, room.top(), fits, height);
  }
  double width_of(const QString& text, int size_px, bool bold) const {
    return std::ceil(QFontMetricsF(participant_font(size_px, bold)).horizontalAdvance(text));
  }

  /// Of an answer in words, with its key in a circle.
  double width_of_answer(const QString& text) const {
    return width_of(text, letters(kText_px), false) + px(kOption) + px(1.5 * kGap);
  }

  void progress();
  void controls();
  void cue();
  /// At the top of what is left.
  void prompt(const QString& text, int size_px);
  /// In the middle of what is left: the largest letters in which it fits.
  void words(const QString& text, const QString& below = {});
  void chips_in_a_row(double height);
  void chips_beside();
  void options_without_picture();
  void pictures(QRectF room);
  void letter_options(QRectF room);
  void standard_beside();
  void feel();
  void question();
  void form();
  void form_choice(const Question& question);
  void form_number(const Question& question);
  static QString range_text(const Question& question);

  Item& add(Item item) {
    items_.push_back(std::move(item));
    return items_.back();
  }
  void add_control(Item item);
  void add_control(const QString& text, const QString& key, Action action, bool ready);
  QString again_text() const;
  void answers_in_words_as_controls();
  Item answer_in_words(std::size_t index) const;
  QRectF column() const {
    const double width = std::min(body_.width(), px(kColumn));
    return QRectF(body_.center().x() - width / 2.0, body_.top(), width, body_.height());
  }
  /// Takes a strip off one side: left for right-handed people, right for others.
  QRectF take_side(double width) {
    QRectF strip = body_;
    strip.setWidth(width);
    if (inputs_.mirrored) {
      strip.moveRight(body_.right());
      body_.setRight(strip.left() - px(2 * kGap));
    } else {
      body_.setLeft(strip.right() + px(2 * kGap));
    }
    return strip;
  }

  const Scene& scene_;
  const ParticipantLayoutInputs& inputs_;
  double scale_ = 1.0;
  QRectF body_{};
  double control_x_ = 0.0;  ///< used of the row of controls, from its outer end
  double controls_top_ = 0.0;
  std::vector<Item> items_{};
};

void Page::progress() {
  QRectF line = body_;
  line.setHeight(px(kLine));
  body_.setTop(line.bottom());
  if (scene_.block <= 0) return;
  add({.rect = line,
       .text = tr("Block %1 of %2").arg(scene_.block).arg(scene_.blocks),
       .size_px = letters(kText_px),
       .muted = true});
}

void Page::add_control(Item item) {
  // As it is drawn: a control says its key in words, an answer in a circle.
  const double width = item.kind == Item::Kind::option
                           ? width_of_answer(item.text)
                           : width_of(item.text, item.size_px, item.bold) +
                                 width_of(item.key, item.size_px, false) +
                                 px(is_wide() ? 64.0 : 44.0);
  // Outermost first, at the side of the free hand; what finds no room goes into a row above.
  if (control_x_ > 0.0 && control_x_ + width > body_.width()) {
    control_x_ = 0.0;
    controls_top_ -= px(kControl) + px(kGap) / 2.0;
  }
  item.rect =
      QRectF(inputs_.mirrored ? body_.left() + control_x_ : body_.right() - control_x_ - width,
             controls_top_, width, px(kControl));
  control_x_ += width + px(is_wide() ? kGap : kGap / 2.0);
  add(std::move(item));
}

void Page::add_control(const QString& text, const QString& key, Action action, bool ready) {
  add_control({.kind = Item::Kind::control,
               .text = text,
               .key = key,
               .size_px = letters(kText_px),
               .bold = true,
               .ready = ready,
               .action = std::move(action)});
}

QString Page::again_text() const {
  const std::optional<int> picked = inputs_.draft.surface;
  const bool names_it = picked && static_cast<std::size_t>(*picked) <= scene_.surfaces.size();
  // Where controls have little room their size stays the same.
  if (!names_it || !is_wide()) {
    return tr("Feel again");
  }
  return tr("Feel %1 again").arg(from(scene_.surfaces[static_cast<std::size_t>(*picked - 1)].code));
}

void Page::controls() {
  const Action confirm{.what = Action::What::confirm};
  const Action next{.what = Action::What::next};
  controls_top_ = inputs_.size.height() - px(kEdge) / 2.0 - px(kControl);
  const QString return_key = tr("Return");
  const QString space_key = tr("Space");
  switch (scene_.kind) {
    case Scene::Kind::text:
      add_control(tr("Go on"), return_key, confirm, true);
      break;
    case Scene::Kind::mask_on:
    case Scene::Kind::mask_off:
      add_control(tr("Done"), return_key, confirm, true);
      break;
    case Scene::Kind::rest:
      add_control(tr("Go on"), return_key, confirm, inputs_.rest_left_s <= 0);
      break;
    case Scene::Kind::feel:
      add_control(tr("Enough of this surface"), space_key, next, false);
      break;
    case Scene::Kind::question:
      add_control(tr("Confirm"), return_key, confirm, scene_.can_confirm);
      if (scene_.can_switch) add_control(again_text(), space_key, next, false);
      if (is_picture_question(scene_)) answers_in_words_as_controls();
      break;
    case Scene::Kind::form: {
      if (!scene_.question) break;
      const bool empty =
          scene_.question->form == Question::Form::choice
              ? !inputs_.draft.option
              : scene_.question->form == Question::Form::number && inputs_.draft.number.isEmpty();
      if (scene_.question->optional && empty) {
        add_control(tr("Leave out"), return_key, confirm, true);
      } else {
        add_control(tr("Confirm"), return_key, confirm, !empty);
      }
      break;
    }
    case Scene::Kind::blank:
    case Scene::Kind::feedback:
    case Scene::Kind::paused:
    case Scene::Kind::ended:
      break;
  }
  // The same room with and without controls, so that nothing jumps from scene to scene.
  body_.setBottom(controls_top_ - px(kGap));
}

void Page::cue() {
  QRectF line = body_;
  line.setTop(line.bottom() - px(kLine));
  body_.setBottom(line.top() - px(kGap) / 2.0);
  if (!inputs_.cue_shown || scene_.cue.empty()) return;
  const QString text = words_of(scene_.cue_saying, scene_.cue);
  const double width =
      std::min(line.width(), width_of(text, letters(kText_px), false) + px(2 * kEdge));
  line.setLeft(line.center().x() - width / 2.0);
  line.setWidth(width);
  add({.kind = Item::Kind::cue, .rect = line, .text = text, .size_px = letters(kText_px)});
}

void Page::prompt(const QString& text, int size_px) {
  if (text.isEmpty()) return;
  const QRectF rect = place_of(text, size_px, true, column());
  add({.rect = rect, .text = text, .size_px = size_px, .bold = true});
  body_.setTop(rect.bottom() + px(kGap));
}

void Page::words(const QString& text, const QString& below) {
  const QRectF room = column();
  const double gap = below.isEmpty() ? 0.0 : px(2 * kGap);
  // A short sentence is read from afar.
  const bool short_text =
      height_of(text, letters(kLarge_px), false, room.width()) < 3.0 * letters(kLarge_px);
  int size_px = letters(short_text ? kLarge_px : kPrompt_px);
  const auto heights = [&] {
    return std::pair(height_of(text, size_px, false, room.width()),
                     below.isEmpty() ? 0.0 : height_of(below, size_px, true, room.width()));
  };
  auto [first, second] = heights();
  while (first + gap + second > room.height() && size_px > kText_px / 2) {
    size_px -= 2;
    std::tie(first, second) = heights();
  }
  QRectF left = room;
  left.setTop(room.center().y() - (first + gap + second) / 2.0);
  add({.rect = place_of(text, size_px, false, left),
       .text = text,
       .size_px = size_px,
       // Lines of a paragraph are found again where they begin at one edge.
       .left_aligned = first > 3.0 * size_px});
  if (below.isEmpty()) return;
  left.setTop(left.top() + first + gap);
  add({.rect = place_of(below, size_px, true, left),
       .text = below,
       .size_px = size_px,
       .bold = true});
}

void Page::chips_in_a_row(double height) {
  const double width = px(112.0);
  const auto count = static_cast<double>(scene_.surfaces.size());
  const double total = count * width + (count - 1.0) * px(kGap);
  double x = body_.center().x() - total / 2.0;
  for (std::size_t i = 0; i < scene_.surfaces.size(); ++i) {
    const std::size_t index = inputs_.mirrored ? scene_.surfaces.size() - 1 - i : i;
    const Scene::Surface& surface = scene_.surfaces[index];
    Item& chip = add({.kind = Item::Kind::chip,
                      .rect = QRectF(x, body_.top(), width, height),
                      .text = from(surface.code),
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

void Page::chips_beside() {
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
                      .text = from(scene_.surfaces[i].code),
                      .key = from(scene_.surfaces[i].code),
                      .size_px = letters(kPrompt_px),
                      .bold = true,
                      .points_left = inputs_.mirrored,
                      .current = picked ? *picked == number : scene_.assigning == i,
                      .action = Action{.what = Action::What::surface, .number = number}});
    for (const Scene::Choice& choice : scene_.choices) {
      if (choice.assigned_to == scene_.surfaces[i].code) chip.given = from(choice.key);
    }
    y += height + px(kGap);
  }
}

Item Page::answer_in_words(std::size_t index) const {
  const Scene::Choice& choice = scene_.choices[index];
  return {.kind = Item::Kind::option,
          .text = words_of(choice.saying, choice.text),
          .key = from(choice.key),
          .size_px = letters(kText_px),
          .chosen = choice.chosen,
          .action = Action{.what = Action::What::choose, .number = static_cast<int>(index) + 1}};
}

// At the inner end of the row of controls where there is room, so that it is not taken for one.
void Page::answers_in_words_as_controls() {
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

void Page::options_without_picture() {
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

void Page::pictures(QRectF room) {
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
           .key = from(choice.key),
           .picture = from(*choice.picture),
           .side = grid.side,
           .size_px = letters(kText_px),
           .chosen = choice.chosen || !choice.assigned_to.empty(),
           .given_to = from(choice.assigned_to),
           .action = Action{.what = Action::What::choose, .number = static_cast<int>(index) + 1}});
      x += cell.width() + gap;
    }
    y += cell.height() + gap;
  }
}

void Page::letter_options(QRectF room) {
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
           .text = from(choice.key),
           .size_px = letters(kLarge_px),
           .bold = true,
           .chosen = choice.chosen,
           .action = Action{.what = Action::What::choose, .number = static_cast<int>(index) + 1}});
      x += grid.side + gap;
    }
    y += grid.side + gap;
  }
}

void Page::standard_beside() {
  if (!scene_.standard_picture) return;
  Item standard{.kind = Item::Kind::standard, .picture = from(*scene_.standard_picture)};
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

void Page::feel() {
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
  if (is_picture_question(scene_)) {
    pictures(body_);
  } else if (scene_.standard_picture) {
    const double side = std::floor(std::min(body_.height(), body_.width()));
    add({.kind = Item::Kind::standard,
         .rect =
             QRectF(body_.center().x() - side / 2.0, body_.center().y() - side / 2.0, side, side),
         .picture = from(*scene_.standard_picture)});
  }
}

void Page::question() {
  prompt(scene_text(), letters(kPrompt_px));
  if (scene_.is_assignment) chips_beside();
  if (is_picture_question(scene_)) {
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

void Page::form_choice(const Question& question) {
  const int count = static_cast<int>(question.options.size());
  const double gap = px(kGap) / 2.0 + 4.0;
  const int fit = std::max(1, static_cast<int>((body_.height() + gap) / (px(kOption) + gap)));
  const int columns = (count + fit - 1) / fit;
  const int rows = (count + columns - 1) / columns;
  double width = 0.0;
  for (const std::string& option : question.options) {
    width = std::max(width, width_of_answer(from(option)));
  }
  width = std::min(width, (body_.width() - (columns - 1) * px(2 * kGap)) / columns);
  const double total = columns * width + (columns - 1) * px(2 * kGap);
  const double height = rows * px(kOption) + (rows - 1) * gap;
  const double top = body_.center().y() - height / 2.0;
  for (int i = 0; i < count; ++i) {
    const int column = i / rows;
    const int row = i % rows;
    add({.kind = Item::Kind::option,
         .rect = QRectF(body_.center().x() - total / 2.0 + column * (width + px(2 * kGap)),
                        top + row * (px(kOption) + gap), width, px(kOption)),
         .text = from(question.options[static_cast<std::size_t>(i)]),
         .key = key_of_form_option(i + 1),
         .size_px = letters(kText_px),
         .chosen = inputs_.draft.option == i + 1,
         .action = Action{.what = Action::What::choose, .number = i + 1}});
  }
}

QString Page::range_text(const Question& question) {
  const auto number = [](double value) { return QString::number(value, 'g', 12); };
  if (question.minimum && question.maximum) {
    return tr("From %1 to %2").arg(number(*question.minimum), number(*question.maximum));
  }
  if (question.minimum) return tr("%1 or more").arg(number(*question.minimum));
  if (question.maximum) return tr("%1 or less").arg(number(*question.maximum));
  return {};
}

void Page::form_number(const Question& question) {
  const bool signed_number = !question.minimum || *question.minimum < 0.0;
  const double key_width = px(104.0);
  const double gap = px(kGap) / 2.0;
  const double key_height = std::min(
      px(80.0), std::floor((body_.height() - 3.0 * gap - (is_wide() ? 0.0 : px(136.0))) / 4.0));
  const QSizeF pad(3.0 * key_width + 2.0 * gap, 4.0 * key_height + 3.0 * gap);
  const QSizeF shown(px(320.0), px(80.0));
  QRectF pad_rect{};
  QRectF number_rect{};
  if (is_wide()) {
    const double total = pad.width() + px(3 * kGap) + shown.width();
    const double left = body_.center().x() - total / 2.0;
    const double pad_x = inputs_.mirrored ? left : left + total - pad.width();
    const double number_x = inputs_.mirrored ? left + total - shown.width() : left;
    pad_rect = QRectF(QPointF(pad_x, body_.center().y() - pad.height() / 2.0), pad);
    number_rect = QRectF(QPointF(number_x, pad_rect.center().y() - shown.height()), shown);
  } else {
    number_rect = QRectF(QPointF(body_.center().x() - shown.width() / 2.0, body_.top()), shown);
    pad_rect = QRectF(
        QPointF(body_.center().x() - pad.width() / 2.0, number_rect.bottom() + px(56.0)), pad);
  }
  add({.kind = Item::Kind::number,
       .rect = number_rect,
       .text = inputs_.draft.number,
       .size_px = letters(kLarge_px),
       .bold = true});
  const QString range = range_text(question);
  if (!range.isEmpty()) {
    add({.rect = QRectF(number_rect.left() - px(kGap), number_rect.bottom(),
                        number_rect.width() + px(2 * kGap), px(kLine)),
         .text = range,
         .size_px = letters(kText_px),
         .muted = true});
  }
  // As on a keyboard's pad. A sign takes the place of nothing: it stands with the point.
  static const std::array<const char*, 12> kKeys = {"7", "8", "9", "4", "5", "6",
                                                    "1", "2", "3", ".", "0", "⌫"};
  for (std::size_t i = 0; i < kKeys.size(); ++i) {
    const auto column = static_cast<double>(i % 3);
    const auto row = static_cast<double>(i / 3);
    const QRectF rect(pad_rect.left() + column * (key_width + gap),
                      pad_rect.top() + row * (key_height + gap), key_width, key_height);
    const QString key = QString::fromUtf8(kKeys[i]);
    const bool is_erase = i + 1 == kKeys.size();
    const auto add_key = [&](const QRectF& place, const QString& text, Action action) {
      add({.kind = Item::Kind::pad,
           .rect = place,
           .text = text,
           .size_px = letters(kPrompt_px),
           .bold = true,
           .action = std::move(action)});
    };
    if (is_erase) {
      add_key(rect, key, {.what = Action::What::erase});
    } else if (key == "." && signed_number) {
      const QRectF half = rect.adjusted(0.0, 0.0, -(rect.width() + gap) / 2.0, 0.0);
      add_key(half, key, {.what = Action::What::write, .text = key});
      add_key(half.translated((rect.width() + gap) / 2.0, 0.0), QStringLiteral("−"),
              {.what = Action::What::write, .text = "-"});
    } else {
      add_key(rect, key, {.what = Action::What::write, .text = key});
    }
  }
}

void Page::form() {
  prompt(scene_text(), letters(kPrompt_px));
  if (!scene_.question) return;
  switch (scene_.question->form) {
    case Question::Form::choice:
      form_choice(*scene_.question);
      break;
    case Question::Form::number:
      form_number(*scene_.question);
      break;
    case Question::Form::text: {
      QRectF field = column();
      field.setHeight(std::min(field.height(), px(280.0)));
      add({.kind = Item::Kind::field, .rect = field, .size_px = letters(kText_px)});
      break;
    }
  }
}

QString minutes_and_seconds(int seconds) {
  return QString("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QChar('0'));
}

std::vector<Item> Page::lay_out() {
  if (scene_.kind == Scene::Kind::blank) return {};
  progress();
  controls();
  cue();
  switch (scene_.kind) {
    case Scene::Kind::blank:
      break;
    case Scene::Kind::text:
    case Scene::Kind::mask_on:
    case Scene::Kind::mask_off:
    case Scene::Kind::feedback:
      words(scene_text());
      break;
    case Scene::Kind::rest:
      words(scene_text(),
            inputs_.rest_left_s > 0
                ? tr("You can go on in %1").arg(minutes_and_seconds(inputs_.rest_left_s))
                : tr("You can go on when you are ready."));
      break;
    case Scene::Kind::feel:
      feel();
      break;
    case Scene::Kind::question:
      question();
      break;
    case Scene::Kind::form:
      form();
      break;
    case Scene::Kind::paused:
      words(scene_.text.empty() ? tr("One moment, please. You may let go of the handle.")
                                : scene_text());
      break;
    case Scene::Kind::ended:
      words(scene_.text.empty() ? tr("Thank you. You may let go of the handle.") : scene_text());
      break;
  }
  return std::move(items_);
}

}  // namespace

QFont participant_font(int size_px, bool bold) {
  QFont font = QFontDatabase::systemFont(QFontDatabase::GeneralFont);
  font.setPixelSize(std::max(1, size_px));
  font.setBold(bold);
  return font;
}

QString key_of_form_option(int number) {
  if (number <= 9) return QString::number(number);
  return QString(QChar(static_cast<char16_t>(u'A' + number - 10)));
}

std::vector<ParticipantItem> lay_out(const ParticipantScene& scene,
                                     const ParticipantLayoutInputs& inputs) {
  return Page(scene, inputs).lay_out();
}

std::optional<ParticipantAction> action_of_key(const ParticipantScene& scene, int key,
                                               const QString& text) {
  const QString typed = text.toUpper();
  const bool is_return = key == Qt::Key_Return || key == Qt::Key_Enter;
  switch (scene.kind) {
    case Scene::Kind::text:
    case Scene::Kind::mask_on:
    case Scene::Kind::mask_off:
    case Scene::Kind::rest:
      if (is_return) return Action{.what = Action::What::confirm};
      return {};
    case Scene::Kind::feel:
    case Scene::Kind::question: {
      if (is_return && scene.kind == Scene::Kind::question) {
        return Action{.what = Action::What::confirm};
      }
      if (key == Qt::Key_Space) return Action{.what = Action::What::next};
      if (typed.isEmpty()) return {};
      for (std::size_t i = 0; i < scene.choices.size(); ++i) {
        if (from(scene.choices[i].key).toUpper() == typed) {
          return Action{.what = Action::What::choose, .number = static_cast<int>(i) + 1};
        }
      }
      for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        const bool can_be_meant =
            scene.is_assignment || scene.surfaces[i].can_go || scene.kind == Scene::Kind::feel;
        if (can_be_meant && from(scene.surfaces[i].code).toUpper() == typed) {
          return Action{.what = Action::What::surface, .number = static_cast<int>(i) + 1};
        }
      }
      // Answers before there is anything to choose from are refused by name, not ignored.
      bool is_number = false;
      const int number = typed.toInt(&is_number);
      if (!is_number || number < 1) return {};
      const bool has_letters = static_cast<std::size_t>(number) <= scene.choices.size() &&
                               scene.choices[static_cast<std::size_t>(number - 1)].text.empty();
      if (has_letters || scene.choices.empty()) {
        return Action{.what = Action::What::choose, .number = number};
      }
      return {};
    }
    case Scene::Kind::form: {
      if (is_return) return Action{.what = Action::What::confirm};
      if (!scene.question) return {};
      if (scene.question->form == Question::Form::choice) {
        for (std::size_t i = 0; i < scene.question->options.size(); ++i) {
          const int number = static_cast<int>(i) + 1;
          if (typed == key_of_form_option(number)) {
            return Action{.what = Action::What::choose, .number = number};
          }
        }
        return {};
      }
      if (scene.question->form != Question::Form::number) return {};
      if (key == Qt::Key_Backspace) return Action{.what = Action::What::erase};
      if (typed == ",") return Action{.what = Action::What::write, .text = "."};
      if (typed.size() == 1 && QStringLiteral("0123456789.-").contains(typed)) {
        return Action{.what = Action::What::write, .text = typed};
      }
      return {};
    }
    case Scene::Kind::blank:
    case Scene::Kind::feedback:
    case Scene::Kind::paused:
    case Scene::Kind::ended:
      return {};
  }
  return {};
}

}  // namespace asperity
