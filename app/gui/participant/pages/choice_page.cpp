// Lays out options as a list of words, or as pictures and letters as large as the room allows, next to a standard.

#include "app/gui/participant/pages/choice_page.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/gui/participant/pages/option_list.h"
#include "app/gui/participant/pages/page_frame.h"
#include "app/gui/participant/pages/picture_grid.h"
#include "app/gui/participant/pages/trial_controls.h"

namespace asperity {

namespace {

using Action = ParticipantAction;
using Item = ParticipantItem;
using Scene = ParticipantScene;

constexpr double kLetter = 128.0;  // side of an answer that is a letter
constexpr double kSmallLetter = 88.0;

/// Pictures; or letters and words, with the picture of the standard beside or above them.
class ChoiceLayout final {
 public:
  explicit ChoiceLayout(PageFrame& frame)
      : frame_(frame), scene_(frame.scene()), body_(frame.body()) {}

  void lay_out();

 private:
  struct Letters {
    int columns = 1;
    int rows = 1;
    double side = 0.0;
    double height = 0.0;
  };
  bool is_enough(double height) const;
  double letter_side() const { return frame_.em(frame_.is_wide() ? kLetter : kSmallLetter); }
  Letters letter_rows(QSizeF room) const;
  void letter_options(QRectF room);
  void standard_beside();
  void options_in_words();
  double height_of_options_in_words() const;
  double width_of_options_in_words() const;

  PageFrame& frame_;
  const Scene& scene_;
  QRectF& body_;
};

/// Pictures that are large enough, or letters that can be pressed.
bool ChoiceLayout::is_enough(double height) const {
  if (shows_pictures(scene_)) return is_enough_for_pictures(frame_, {body_.width(), height});
  double width = body_.width();
  double needed = height_of_options_in_words();
  if (scene_.standard_picture) {
    if (frame_.is_wide()) {
      width = 0.54 * width - frame_.px(2 * frame_.kGap);
      if (height < frame_.em(200.0)) return false;
    } else {
      needed += frame_.em(144.0) + frame_.px(2 * frame_.kGap);
    }
  }
  const Letters rows = letter_rows({width, height - needed});
  return rows.rows == 0 ? height >= needed : rows.side >= frame_.em(64.0);
}

void ChoiceLayout::lay_out() {
  const bool answers = frame_.question_over(frame_.scene_text(),
                                            [this](double height) { return is_enough(height); });
  frame_.need_pages(frame_.question_pages() + 1);
  if (!answers) return;
  if (shows_pictures(scene_)) {
    add_pictures(frame_, body_);
    return;
  }
  standard_beside();
  // Letters and the answers in words make one group, in the middle of what is left.
  const double in_words = height_of_options_in_words();
  const Letters rows =
      letter_rows({body_.width(),
                   std::max(frame_.em(64.0), body_.height() - in_words - frame_.px(frame_.kGap))});
  const double group = rows.height + (rows.rows > 0 ? frame_.px(frame_.kGap) : 0.0) + in_words;
  const double lift = std::max(0.0, (body_.height() - group) / 2.0);
  body_.setBottom(body_.bottom() - lift);
  options_in_words();
  if (rows.rows == 0) return;
  letter_options(QRectF(body_.left(), body_.bottom() - rows.height, body_.width(), rows.height));
}

/// As few rows as keep the letters large in them.
ChoiceLayout::Letters ChoiceLayout::letter_rows(QSizeF room) const {
  const auto count = static_cast<int>(std::count_if(
      scene_.choices.begin(), scene_.choices.end(),
      [](const Scene::Choice& choice) { return !choice.picture && choice.text.empty(); }));
  if (count == 0) return {.columns = 0, .rows = 0};
  const double gap = frame_.px(frame_.kGap) * (count > 6 ? 1.0 : 2.0);
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
    if (best.side >= frame_.em(kSmallLetter)) break;
  }
  return best;
}

void ChoiceLayout::letter_options(QRectF room) {
  std::vector<std::size_t> those{};
  for (std::size_t i = 0; i < scene_.choices.size(); ++i) {
    if (!scene_.choices[i].picture && scene_.choices[i].text.empty()) those.push_back(i);
  }
  const int count = static_cast<int>(those.size());
  const Letters grid = letter_rows(room.size());
  const double gap = frame_.px(frame_.kGap) * (count > 6 ? 1.0 : 2.0);
  double y = room.center().y() - grid.height / 2.0;
  for (int row = 0; row < grid.rows; ++row) {
    const int first = row * grid.columns;
    const int in_row = std::min(grid.columns, count - first);
    double x = room.center().x() - (in_row * grid.side + (in_row - 1) * gap) / 2.0;
    for (int place = first; place < first + in_row; ++place) {
      const std::size_t index = those[static_cast<std::size_t>(place)];
      const Scene::Choice& choice = scene_.choices[index];
      frame_.add(
          {.kind = Item::Kind::option,
           .rect = QRectF(x, y, grid.side, grid.side),
           .text = frame_.text_from(choice.key),
           .size_px = frame_.letters(grid.side < frame_.em(76.0) ? frame_.kText : frame_.kLarge),
           .bold = true,
           .chosen = choice.chosen,
           .action = Action{.what = Action::What::choose, .number = static_cast<int>(index) + 1}});
      x += grid.side + gap;
    }
    y += grid.side + gap;
  }
}

void ChoiceLayout::standard_beside() {
  if (!scene_.standard_picture) return;
  Item standard{.kind = Item::Kind::standard,
                .picture = frame_.text_from(*scene_.standard_picture)};
  if (frame_.is_wide()) {
    const double side = std::floor(std::min(body_.height(), 0.42 * body_.width()));
    const QRectF strip = frame_.take_side(0.46 * body_.width());
    standard.rect =
        QRectF(strip.center().x() - side / 2.0, strip.center().y() - side / 2.0, side, side);
  } else {
    const double words = height_of_options_in_words();
    const double group = words + frame_.px(2 * frame_.kGap) + letter_rows(body_.size()).height;
    const double room = std::max(frame_.em(64.0), body_.height() - group);
    const double side = std::floor(std::min(room, body_.width()));
    standard.rect = QRectF(body_.center().x() - side / 2.0, body_.top(), side, side);
    body_.setTop(standard.rect.bottom() + frame_.px(frame_.kGap));
  }
  standard.side = standard.rect.width();
  frame_.add(std::move(standard));
}

/// Of the widest one, so that their edges are aligned.
double ChoiceLayout::width_of_options_in_words() const {
  double width = 0.0;
  for (const Scene::Choice& choice : scene_.choices) {
    if (choice.picture || choice.text.empty()) continue;
    const QString text = words_of(choice.message, choice.text, scene_.language);
    width = std::max(width, frame_.width_of_answer(text));
  }
  return std::min(body_.width(), width);
}

// From below, in their order.
void ChoiceLayout::options_in_words() {
  const double width = width_of_options_in_words();
  for (std::size_t i = scene_.choices.size(); i-- > 0;) {
    if (scene_.choices[i].picture || scene_.choices[i].text.empty()) continue;
    Item answer = option_in_words(frame_, i);
    const double height = frame_.height_of_answer(answer.text, width);
    answer.rect = QRectF(body_.center().x() - width / 2.0, body_.bottom() - height, width, height);
    body_.setBottom(answer.rect.top() - frame_.px(frame_.kGap));
    frame_.add(std::move(answer));
  }
}

double ChoiceLayout::height_of_options_in_words() const {
  const double width = width_of_options_in_words();
  double height = 0.0;
  for (const Scene::Choice& choice : scene_.choices) {
    if (choice.picture || choice.text.empty()) continue;
    const QString text = words_of(choice.message, choice.text, scene_.language);
    height += frame_.height_of_answer(text, width) + frame_.px(frame_.kGap);
  }
  return height;
}

bool are_all_words(const Scene& scene) {
  return !scene.standard_picture && !scene.choices.empty() &&
         std::ranges::all_of(scene.choices, [](const Scene::Choice& choice) {
           return !choice.picture && !choice.text.empty();
         });
}

class ChoicePage final : public ParticipantPage {
 public:
  void lay_out(PageFrame& frame) const override {
    const Scene& scene = frame.scene();
    if (are_all_words(scene)) {
      const QString note =
          scene.is_answered_by<MultipleChoiceForm>()
              ? '\n' + frame.said(phrase("ParticipantLayout", "Choose all that apply."))
              : QString();
      lay_out_options(frame, {.question = frame.scene_text() + note,
                              .options = options_in_words(scene),
                              .chosen = chosen_options(scene)});
    } else {
      ChoiceLayout(frame).lay_out();
    }
  }

  void add_controls(PageFrame& frame) const override {
    add_question_controls(frame, *this, frame.scene().can_confirm);
    if (shows_pictures(frame.scene())) add_words_as_controls(frame);
  }

  std::optional<Action> action_of_key(const Scene& scene, int key,
                                      const QString& typed) const override {
    return key_of_question(scene, key, typed);
  }
};

}  // namespace

const ParticipantPage& choice_page() {
  static const ChoicePage kScenePage{};
  return kScenePage;
}

}  // namespace asperity
