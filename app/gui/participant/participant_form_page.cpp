#include <array>

#include "app/gui/participant/participant_page.h"

namespace asperity {

/// As few columns as give all options room in `height`; where none does, as many rows of the last
/// arrangement as fit.
ParticipantPage::OptionRows ParticipantPage::option_rows(const Question& question,
                                                         double height) const {
  constexpr int kMostColumns = 3;  // more are not read as one list
  const int count = static_cast<int>(question.options.size());
  const double gap = px(0.75 * kGap);
  OptionRows best{};
  for (int columns = 1; columns <= std::min(count, kMostColumns); ++columns) {
    const double room = (body_.width() - (columns - 1) * px(2 * kGap)) / columns;
    double width = 0.0;
    double longest_word = 0.0;
    for (int i = 0; i < count; ++i) {
      width = std::max(width, width_of_answer(text_of(question, i)));
      longest_word =
          std::max(longest_word, width_of_longest_word(text_of(question, i), letters(kText)));
    }
    if (columns > 1 && longest_word + em(kAroundAnswer) > room) break;
    width = std::min(width, room);
    OptionRows rows{.columns = columns, .width = width};
    for (int i = 0; i < count; ++i) {
      rows.row_height = std::max(rows.row_height, height_of_answer(text_of(question, i), width));
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

void ParticipantPage::form_choice(const Question& question, std::optional<int> chosen) {
  const int count = static_cast<int>(question.options.size());
  const double gap = px(0.75 * kGap);
  const OptionRows rows = option_rows(question, body_.height());
  const int on_a_page = rows.columns * rows.rows;
  answer_page_ = 0;
  if (chosen && question_pages_ + 1 < pages_) {
    answer_page_ = question_pages_ + 1 + (*chosen - 1) / on_a_page;
  }
  const int first = (page_ - question_pages_ - 1) * on_a_page;
  const double total = rows.columns * rows.width + (rows.columns - 1) * px(2 * kGap);
  const double height = rows.rows * rows.row_height + (rows.rows - 1) * gap;
  const double top = body_.center().y() - height / 2.0;
  for (int i = first; i < std::min(first + on_a_page, count); ++i) {
    const int column = (i - first) / rows.rows;
    const int row = (i - first) % rows.rows;
    add({.kind = Item::Kind::option,
         .rect = QRectF(body_.center().x() - total / 2.0 + column * (rows.width + px(2 * kGap)),
                        top + row * (rows.row_height + gap), rows.width, rows.row_height),
         .text = text_of(question, i),
         .key = key_of_form_option(i + 1),
         .size_px = letters(kText),
         .chosen = chosen == i + 1,
         .action = Action{.what = Action::What::choose, .number = i + 1}});
  }
}

QString ParticipantPage::range_text(const Question& question) const {
  const auto number = [](double value) {
    return QString::number(value, 'g', 12).replace('-', "−").toStdString();
  };
  if (question.minimum && question.maximum) {
    return said(phrase("ParticipantLayout", "From %1 to %2")
                    .with(number(*question.minimum), number(*question.maximum)));
  }
  if (question.minimum)
    return said(phrase("ParticipantLayout", "%1 or more").with(number(*question.minimum)));
  if (question.maximum)
    return said(phrase("ParticipantLayout", "%1 or less").with(number(*question.maximum)));
  return {};
}

void ParticipantPage::form_number(const Question& question) {
  number_pad(range_text(question), may_be_negative(scene_) ? Sign::minus : Sign::none);
}

QString ParticipantPage::no_number_text() const {
  return scene_.kind == Scene::Kind::question
             ? said(phrase("ParticipantLayout", "This is not a number above 0. Please correct it."))
             : said(phrase("ParticipantLayout", "This is not a number. Please correct it."));
}

bool ParticipantPage::is_enough_for_number(double height) const {
  const double gap = px(kGap) / 2.0;
  const double pad = 4.0 * em(44.0) + 3.0 * gap;
  const double above = tall(kChip) + em(2.0 * kLine) + gap;
  return height >= pad + (is_wide() ? 0.0 : above);
}

void ParticipantPage::number_pad(const QString& range, Sign sign) {
  const double gap = px(kGap) / 2.0;
  const double key_width = std::min(em(104.0), std::floor((body_.width() - 2.0 * gap) / 3.0));
  // Beside the pad, or above it.
  const double beside = body_.width() - (3.0 * key_width + 2.0 * gap) - px(3 * kGap);
  QSizeF shown(std::min(em(320.0), is_wide() ? beside : body_.width()), tall(kChip));
  // Both have room, so that nothing moves under the hand when one takes the place of the other.
  const QString amiss = no_number_text();
  const double range_width = is_wide() ? std::min(beside, em(400.0)) : body_.width();
  const double range_height = std::max(height_of(range, letters(kText), false, range_width),
                                       height_of(amiss, letters(kText), true, range_width)) +
                              em(8.0);
  const double above = is_wide() ? 0.0 : shown.height() + range_height + gap;
  const double key_height =
      std::min(em(80.0), std::floor((body_.height() - 3.0 * gap - above) / 4.0));
  const QSizeF pad(3.0 * key_width + 2.0 * gap, 4.0 * key_height + 3.0 * gap);
  QRectF pad_rect{};
  QRectF number_rect{};
  QRectF range_rect{};
  if (is_wide()) {
    const double number_width = std::max(shown.width(), range_width);
    const double total = pad.width() + px(3 * kGap) + number_width;
    const double left = body_.center().x() - total / 2.0;
    const double pad_x = inputs_.mirrored ? left : left + total - pad.width();
    const double number_x = inputs_.mirrored ? left + total - number_width : left;
    const double top =
        body_.center().y() - std::max(shown.height(), (shown.height() + range_height) / 2.0);
    pad_rect = QRectF(QPointF(pad_x, body_.center().y() - pad.height() / 2.0), pad);
    number_rect = QRectF(QPointF(number_x + (number_width - shown.width()) / 2.0, top), shown);
    range_rect = QRectF(number_x, number_rect.bottom(), number_width, range_height);
  } else {
    number_rect = QRectF(QPointF(body_.center().x() - shown.width() / 2.0, body_.top()), shown);
    range_rect = QRectF(body_.left(), number_rect.bottom(), body_.width(), range_height);
    pad_rect =
        QRectF(QPointF(body_.center().x() - pad.width() / 2.0, range_rect.bottom() + gap), pad);
  }
  // As large as all that may be typed fits.
  const double digits = shown.width() - em(kGap);
  int size_px = letters(kLarge);
  while (size_px > letters(kText) && width_of(inputs_.draft.number, size_px, true) > digits) {
    --size_px;
  }
  add({.kind = Item::Kind::number,
       .rect = number_rect,
       .text = inputs_.draft.number,
       .size_px = size_px,
       .bold = true});
  if (is_no_number(scene_, inputs_.draft.number)) {
    add({.rect = range_rect, .text = amiss, .size_px = letters(kText), .bold = true});
  } else if (!range.isEmpty()) {
    add({.rect = range_rect, .text = range, .size_px = letters(kText), .muted = true});
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
           .size_px = letters(key_height < em(kOneLine) ? kText : kPrompt),
           .bold = true,
           .action = std::move(action)});
    };
    if (is_erase) {
      add_key(rect, key, {.what = Action::What::erase});
    } else if (key == "." && sign == Sign::minus) {
      const QRectF half = rect.adjusted(0.0, 0.0, -(rect.width() + gap) / 2.0, 0.0);
      add_key(half, key, {.what = Action::What::write, .text = key});
      add_key(half.translated((rect.width() + gap) / 2.0, 0.0), QStringLiteral("−"),
              {.what = Action::What::write, .text = "-"});
    } else {
      add_key(rect, key, {.what = Action::What::write, .text = key});
    }
  }
}

void ParticipantPage::form() {
  if (!scene_.question) {
    prompt(scene_text(), letters(kPrompt));
    return;
  }
  const Question& question = *scene_.question;
  const auto is_enough = [&](double height) {
    switch (question.form) {
      case Question::Form::choice:
        return option_rows(question, height).fits;
      case Question::Form::number:
        return is_enough_for_number(height);
      case Question::Form::text:
        return height >= em(104.0);
    }
    return true;
  };
  int answer_pages = 1;
  if (question.form == Question::Form::choice) {
    const OptionRows rows = option_rows(question, body_.height());
    const int count = static_cast<int>(question.options.size());
    const int on_a_page = rows.columns * rows.rows;
    if (!rows.fits) answer_pages = (count + on_a_page - 1) / on_a_page;
  }
  const bool answers = question_over(scene_text(), is_enough);
  pages_ = std::max(pages_, question_pages_ + answer_pages);
  if (!answers) return;
  switch (question.form) {
    case Question::Form::choice:
      form_choice(question, inputs_.draft.option);
      break;
    case Question::Form::number:
      form_number(question);
      break;
    case Question::Form::text: {
      QRectF field = column();
      field.setHeight(std::min(field.height(), em(280.0)));
      add({.kind = Item::Kind::field,
           .rect = field,
           .text = inputs_.draft.text,
           .size_px = letters(kText)});
      break;
    }
  }
}

}  // namespace asperity
