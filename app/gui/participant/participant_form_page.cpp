#include <array>

#include "app/gui/participant/participant_page.h"

namespace asperity {

void ParticipantPage::form_choice(const Question& question) {
  const int count = static_cast<int>(question.options.size());
  const double gap = px(0.75 * kGap);
  const int fit = std::max(1, static_cast<int>((body_.height() + gap) / (px(kOption) + gap)));
  const int columns = (count + fit - 1) / fit;
  const int rows = (count + columns - 1) / columns;
  double width = 0.0;
  for (const std::string& option : question.options) {
    width = std::max(width, width_of_answer(text_from(option)));
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
         .text = text_from(question.options[static_cast<std::size_t>(i)]),
         .key = key_of_form_option(i + 1),
         .size_px = letters(kText_px),
         .chosen = inputs_.draft.option == i + 1,
         .action = Action{.what = Action::What::choose, .number = i + 1}});
  }
}

QString ParticipantPage::range_text(const Question& question) {
  const auto number = [](double value) { return QString::number(value, 'g', 12); };
  if (question.minimum && question.maximum) {
    return tr("From %1 to %2").arg(number(*question.minimum), number(*question.maximum));
  }
  if (question.minimum) return tr("%1 or more").arg(number(*question.minimum));
  if (question.maximum) return tr("%1 or less").arg(number(*question.maximum));
  return {};
}

void ParticipantPage::form_number(const Question& question) {
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

void ParticipantPage::form() {
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

}  // namespace asperity
