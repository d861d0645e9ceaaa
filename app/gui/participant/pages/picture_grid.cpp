// Finds the number of columns with the largest squares, and places each picture with its key.

#include "app/gui/participant/pages/picture_grid.h"

#include <algorithm>
#include <vector>

#include "app/gui/participant/pages/page_frame.h"

namespace asperity {

namespace {

using Action = ParticipantAction;
using Scene = ParticipantScene;

constexpr double kWideBadge = 64.0;

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

QSizeF key_size(const std::vector<ParticipantScene::Choice>& choices, double narrow, double wide) {
  const bool has_two_digits =
      std::any_of(choices.begin(), choices.end(), [](const ParticipantScene::Choice& choice) {
        return choice.picture && choice.key.size() > 1;
      });
  return {has_two_digits ? wide : narrow, narrow};
}

/// Many small pictures give their room to themselves.
double picture_gap(const PageFrame& frame) {
  constexpr std::size_t kMany = 8;
  return frame.px((frame.is_tight() && frame.scene().choices.size() > kMany ? 0.5 : 1.5) *
                  frame.kGap);
}

}  // namespace

bool shows_pictures(const ParticipantScene& scene) {
  return std::any_of(scene.choices.begin(), scene.choices.end(),
                     [](const Scene::Choice& choice) { return choice.picture.has_value(); });
}

double picture_side(const PageFrame& frame, QSizeF room) {
  const auto count = std::count_if(frame.scene().choices.begin(), frame.scene().choices.end(),
                                   [](const Scene::Choice& choice) { return choice.picture; });
  const QSizeF key = key_size(frame.scene().choices, frame.em(frame.kBadge), frame.em(kWideBadge));
  const QSizeF around(frame.px(frame.kGap) / 2.0, frame.px(frame.kGap) / 2.0);
  return grid_for(static_cast<int>(count), room, picture_gap(frame), key + around).side;
}

bool is_enough_for_pictures(const PageFrame& frame, QSizeF room) {
  const double alone = picture_side(frame, {room.width(), frame.body().height()});
  return picture_side(frame, room) >= std::min(0.5 * alone, frame.em(128.0));
}

void add_pictures(PageFrame& frame, const QRectF& room) {
  std::vector<std::size_t> those{};
  for (std::size_t i = 0; i < frame.scene().choices.size(); ++i) {
    if (frame.scene().choices[i].picture) those.push_back(i);
  }
  const int count = static_cast<int>(those.size());
  if (count == 0) return;
  const double gap = picture_gap(frame);
  const QSizeF key = key_size(frame.scene().choices, frame.em(frame.kBadge), frame.em(kWideBadge));
  const QSizeF around(frame.px(frame.kGap) / 2.0, frame.px(frame.kGap) / 2.0);
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
      const Scene::Choice& choice = frame.scene().choices[index];
      frame.add(
          {.kind = ParticipantItem::Kind::picture,
           .rect = QRectF(QPointF(x, y), cell),
           .key = frame.text_from(choice.key),
           .picture = frame.text_from(*choice.picture),
           .side = grid.side,
           .size_px = frame.letters(frame.kText),
           .chosen = choice.chosen || !choice.assigned_to.empty(),
           .given_to = frame.text_from(choice.assigned_to),
           .action = Action{.what = Action::What::choose, .number = static_cast<int>(index) + 1}});
      x += cell.width() + gap;
    }
    y += cell.height() + gap;
  }
}

ParticipantItem option_in_words(const PageFrame& frame, std::size_t index) {
  const Scene::Choice& choice = frame.scene().choices[index];
  return {.kind = ParticipantItem::Kind::option,
          .text = words_of(choice.message, choice.text, frame.scene().language),
          .key = frame.text_from(choice.key),
          .size_px = frame.letters(frame.kText),
          .chosen = choice.chosen,
          .action = Action{.what = Action::What::choose, .number = static_cast<int>(index) + 1}};
}

void add_words_as_controls(PageFrame& frame) {
  for (std::size_t i = 0; i < frame.scene().choices.size(); ++i) {
    if (frame.scene().choices[i].picture) continue;
    ParticipantItem answer = option_in_words(frame, i);
    const double width = frame.width_of_answer(answer.text);
    frame.add_at_inner_end(std::move(answer), width);
  }
}

}  // namespace asperity
