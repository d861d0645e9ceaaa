// Scales: the labelled points of one as a list, or the lines of one or more in rows.

#include "app/gui/participant/participant_page.h"

namespace asperity {

/// A label for every point needs the room of a list.
bool ParticipantPage::is_list_of_points() const {
  return scene_.scales.size() == 1 && scene_.scales.front().form.labels_every_point();
}

/// The labelled points of the only scale, as the options of a form are laid out.
Question ParticipantPage::points_as_options() const {
  Question question{};
  question.options = scene_.scales.front().form.labels;
  return question;
}

/// The rows in `height`: prompts above their lines, or beside them where that saves pages.
ParticipantPage::ScaleRows ParticipantPage::scale_rows(double height) const {
  const double width = std::min(body_.width(), em(kColumn));
  const double gap = px(kGap) / 2.0;
  const auto measured = [&](bool beside) {
    ScaleRows rows{.width = width};
    if (beside) rows.prompt_width = std::floor(0.3 * width);
    const double lines = width - (beside ? rows.prompt_width + px(kGap) : 0.0);
    double natural = 0.0;
    double longest_word = 0.0;
    for (const Scene::Scale& scale : scene_.scales) {
      for (const std::string& label : scale.form.labels) {
        const QString text = text_from(label);
        natural = std::max(natural, width_of(text, letters(kText), false));
        longest_word = std::max(longest_word, width_of_longest_word(text, letters(kText)));
      }
    }
    // The line keeps almost half of the row; where labels leave it less, they stand above it.
    constexpr double kMostOfLabel = 0.26;
    const bool is_beside = natural > 0.0 && longest_word <= kMostOfLabel * lines;
    if (is_beside) rows.label_width = std::min(natural + 2.0, std::floor(kMostOfLabel * lines));
    rows.line = em(kOneLine);
    for (const Scene::Scale& scale : scene_.scales) {
      for (const std::string& label : scale.form.labels) {
        const double room = is_beside ? rows.label_width : label_room(lines);
        const double taken = height_of(text_from(label), letters(kText), false, room);
        double& tallest = is_beside ? rows.line : rows.label_height;
        tallest = std::max(tallest, taken);
      }
      const QString prompt = text_from(scale.prompt);
      if (!prompt.isEmpty() && beside) {
        rows.line = std::max(rows.line, height_of(prompt, letters(kText), true, rows.prompt_width));
      } else if (!prompt.isEmpty()) {
        rows.prompt_height =
            std::max(rows.prompt_height, height_of(prompt, letters(kText), true, width));
      }
    }
    const double row = rows.above() + rows.line;
    rows.on_a_page = std::max(1, static_cast<int>((height + gap) / (row + gap)));
    return rows;
  };
  const auto pages_of_scales = [this](const ScaleRows& rows) {
    const int count = static_cast<int>(scene_.scales.size());
    return (count + rows.on_a_page - 1) / rows.on_a_page;
  };
  ScaleRows above = measured(false);
  above.pages = pages_of_scales(above);
  if (above.pages == 1 || !is_wide()) return above;
  ScaleRows beside = measured(true);
  beside.pages = pages_of_scales(beside);
  return beside.pages < above.pages ? beside : above;
}

double ParticipantPage::label_room(double width) const {
  return std::floor((width - px(kGap)) / 2.0);
}

void ParticipantPage::scale_row(const Scene::Scale& scale, int number, const ScaleRows& rows,
                                QRectF room) {
  const QString prompt = text_from(scale.prompt);
  if (rows.prompt_width > 0.0) {
    QRectF place = room;
    place.setWidth(rows.prompt_width);
    room.setLeft(place.right() + px(kGap));
    add({.rect = place,
         .text = prompt,
         .size_px = letters(kText),
         .bold = true,
         .left_aligned = true});
  } else if (rows.prompt_height > 0.0) {
    QRectF place = room;
    place.setHeight(rows.prompt_height);
    room.setTop(place.bottom());
    add({.rect = place, .text = prompt, .size_px = letters(kText), .bold = true});
  }
  QRectF low = room;
  if (rows.label_width > 0.0) {
    const double taken = rows.label_width + px(kGap) / 2.0;
    low.setWidth(rows.label_width);
    room.adjust(taken, 0.0, -taken, 0.0);
  } else {
    low.setSize({label_room(room.width()), rows.label_height});
    room.setTop(low.bottom());
  }
  if (!scale.form.labels.empty()) {
    const QString left = text_from(scale.form.labels.front());
    const QString right = text_from(scale.form.labels.back());
    QRectF high = low;
    if (rows.label_width > 0.0) {
      high.moveRight(room.right() + px(kGap) / 2.0 + rows.label_width);
    } else {
      // At the ends of the line.
      const double most = low.width();
      low.setWidth(std::min(most, width_of(left, letters(kText), false) + 2.0));
      high.setWidth(std::min(most, width_of(right, letters(kText), false) + 2.0));
      high.moveRight(room.right());
    }
    add({.rect = low, .text = left, .size_px = letters(kText)});
    add({.rect = high, .text = right, .size_px = letters(kText)});
  }
  add({.kind = Item::Kind::scale,
       .rect = room,
       .side = em(kBadge) / 2.0,
       .size_px = letters(kText),
       .scale = scale,
       .action = Action{.what = Action::What::mark, .number = number}});
}

void ParticipantPage::scales() {
  if (is_list_of_points()) {
    const Scene::Scale& scale = scene_.scales.front();
    const Question points = points_as_options();
    const OptionRows rows = option_rows(points, body_.height());
    const bool answers = question_over(
        scene_text(), [&](double height) { return option_rows(points, height).fits; });
    const int on_a_page = rows.columns * rows.rows;
    const int count = static_cast<int>(points.options.size());
    pages_ =
        std::max(pages_, question_pages_ + (rows.fits ? 1 : (count + on_a_page - 1) / on_a_page));
    if (!answers) return;
    const bool is_marked = scale.step.has_value() && scale.counts;
    form_choice(points, is_marked ? std::optional(*scale.step + 1) : std::nullopt);
    return;
  }
  // The question stands over the scales unless that takes more pages than a separate one.
  const ScaleRows alone = scale_rows(body_.height());
  const bool answers = question_over(
      scene_text(), [&](double height) { return scale_rows(height).pages <= alone.pages + 1; });
  const ScaleRows rows = answers ? scale_rows(body_.height()) : alone;
  pages_ = std::max(pages_, question_pages_ + rows.pages);
  if (!answers) return;
  const int count = static_cast<int>(scene_.scales.size());
  for (int i = 0; i < count; ++i) {
    if (scene_.scales[static_cast<std::size_t>(i)].current) {
      answer_page_ = question_pages_ + 1 + i / rows.on_a_page;
    }
  }
  const int first = (page_ - question_pages_ - 1) * rows.on_a_page;
  const int shown = std::min(rows.on_a_page, count - first);
  const double row = rows.above() + rows.line;
  // Rows stand apart where there is room, and in the middle.
  const double gap = std::clamp((body_.height() - shown * row) / std::max(1, shown - 1),
                                px(kGap) / 2.0, px(2.0 * kGap));
  double y = body_.center().y() - (shown * row + (shown - 1) * gap) / 2.0;
  for (int i = first; i < first + shown; ++i) {
    scale_row(scene_.scales[static_cast<std::size_t>(i)], i + 1, rows,
              QRectF(body_.center().x() - rows.width / 2.0, y, rows.width, row));
    y += row + gap;
  }
}

}  // namespace asperity
