// Finds the fewest columns that fit the height, and otherwise divides the options into pages.

#include "app/gui/participant/pages/option_list.h"

#include <algorithm>

#include "app/gui/participant/pages/page_frame.h"
#include "app/gui/participant/pages/participant_words.h"

namespace asperity {

namespace {

struct OptionRows {
  int columns = 1;
  int rows = 1;
  double width = 0.0;
  double row_height = 0.0;
  bool fits = false;
  int on_a_page() const noexcept { return columns * rows; }
};

/// As few columns as give all options room in `height`; where none does, as many rows of the last
/// arrangement as fit.
OptionRows option_rows(const PageFrame& frame, const std::vector<ListedOption>& options,
                       double height) {
  constexpr int kMostColumns = 3;  // more are not read as one list
  const int count = static_cast<int>(options.size());
  const double gap = frame.px(0.75 * frame.kGap);
  OptionRows best{};
  for (int columns = 1; columns <= std::min(count, kMostColumns); ++columns) {
    const double room = (frame.body().width() - (columns - 1) * frame.px(2 * frame.kGap)) / columns;
    double width = 0.0;
    double longest_word = 0.0;
    for (const ListedOption& option : options) {
      width = std::max(width, frame.width_of_answer(option.text));
      longest_word = std::max(longest_word,
                              frame.width_of_longest_word(option.text, frame.letters(frame.kText)));
    }
    if (columns > 1 && longest_word + frame.em(frame.kAroundAnswer) > room) break;
    width = std::min(width, room);
    OptionRows rows{.columns = columns, .width = width};
    for (const ListedOption& option : options) {
      rows.row_height = std::max(rows.row_height, frame.height_of_answer(option.text, width));
    }
    const int needed = (count + columns - 1) / columns;
    rows.rows = std::max(1, static_cast<int>((height + gap) / (rows.row_height + gap)));
    rows.fits = needed * rows.row_height + (needed - 1) * gap <= height;
    if (rows.fits) {
      rows.rows = needed;
      return rows;
    }
    if (rows.rows * columns > best.rows * best.columns || columns == 1) best = rows;
  }
  return best;
}

}  // namespace

void lay_out_options(PageFrame& frame, const OptionList& list) {
  const std::vector<ListedOption>& options = list.options;
  const OptionRows alone = option_rows(frame, options, frame.body().height());
  const int count = static_cast<int>(options.size());
  const bool answers = frame.question_over(
      list.question, [&](double height) { return option_rows(frame, options, height).fits; });
  frame.need_pages(frame.question_pages() +
                   (alone.fits ? 1 : (count + alone.on_a_page() - 1) / alone.on_a_page()));
  if (!answers) return;
  const double gap = frame.px(0.75 * frame.kGap);
  const OptionRows rows = option_rows(frame, options, frame.body().height());
  const int on_a_page = rows.on_a_page();
  frame.set_answer_page(0);
  if (!list.chosen.empty() && frame.question_pages() + 1 < frame.pages()) {
    frame.set_answer_page(frame.question_pages() + 1 + (list.chosen.front() - 1) / on_a_page);
  }
  const int first = (frame.page() - frame.question_pages() - 1) * on_a_page;
  const double total = rows.columns * rows.width + (rows.columns - 1) * frame.px(2 * frame.kGap);
  const double height = rows.rows * rows.row_height + (rows.rows - 1) * gap;
  const double top = frame.body().center().y() - height / 2.0;
  for (int i = first; i < std::min(first + on_a_page, count); ++i) {
    const int column = (i - first) / rows.rows;
    const int row = (i - first) % rows.rows;
    frame.add(
        {.kind = ParticipantItem::Kind::option,
         .rect = QRectF(frame.body().center().x() - total / 2.0 +
                            column * (rows.width + frame.px(2 * frame.kGap)),
                        top + row * (rows.row_height + gap), rows.width, rows.row_height),
         .text = options[static_cast<std::size_t>(i)].text,
         .key = options[static_cast<std::size_t>(i)].key,
         .size_px = frame.letters(frame.kText),
         .chosen = std::find(list.chosen.begin(), list.chosen.end(), i + 1) != list.chosen.end(),
         .current = options[static_cast<std::size_t>(i)].pointed_at,
         .action = ParticipantAction{.what = ParticipantAction::What::choose, .number = i + 1}});
  }
}

std::vector<ListedOption> options_in_words(const ParticipantScene& scene) {
  std::vector<ListedOption> options{};
  for (const ParticipantScene::Choice& choice : scene.choices) {
    options.push_back({words_of(choice.message, choice.text, scene.language),
                       QString::fromStdString(choice.key), choice.pointed_at});
  }
  return options;
}

std::vector<int> chosen_options(const ParticipantScene& scene) {
  std::vector<int> chosen{};
  for (std::size_t i = 0; i < scene.choices.size(); ++i) {
    if (scene.choices[i].chosen) chosen.push_back(static_cast<int>(i) + 1);
  }
  return chosen;
}

}  // namespace asperity
