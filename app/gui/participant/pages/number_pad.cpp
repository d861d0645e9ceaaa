// Lays out the keys of the pad, and edits the typed digits; a number that cannot be read is not confirmed.

#include "app/gui/participant/pages/number_pad.h"

#include <array>

#include <QtCore/QRegularExpression>
#include <QtCore/Qt>

#include "app/gui/participant/pages/page_frame.h"

namespace asperity {

namespace {

using Action = ParticipantAction;

constexpr qsizetype kLongestNumber = 24;  // to be seen; not all of it can be an answer

bool is_enough_for_number(const PageFrame& frame, double height) {
  const double gap = frame.px(frame.kGap) / 2.0;
  const double pad = 4.0 * frame.em(44.0) + 3.0 * gap;
  const double above = frame.tall(frame.kChip) + frame.em(2.0 * frame.kLine) + gap;
  return height >= pad + (frame.is_wide() ? 0.0 : above);
}

struct PadKeys {
  QPointF corner{};
  QSizeF key{};
  double gap = 0.0;
};

void add_keys(PageFrame& frame, const PadKeys& pad, NumberSign sign) {
  // As on a keyboard's pad. A sign takes the place of nothing: it stands with the point.
  static const std::array<const char*, 12> kKeys = {"7", "8", "9", "4", "5", "6",
                                                    "1", "2", "3", ".", "0", "⌫"};
  for (std::size_t i = 0; i < kKeys.size(); ++i) {
    const auto column = static_cast<double>(i % 3);
    const auto row = static_cast<double>(i / 3);
    const QRectF rect(pad.corner.x() + column * (pad.key.width() + pad.gap),
                      pad.corner.y() + row * (pad.key.height() + pad.gap), pad.key.width(),
                      pad.key.height());
    const QString key = QString::fromUtf8(kKeys[i]);
    const bool is_erase = i + 1 == kKeys.size();
    const auto add_key = [&](const QRectF& place, const QString& text, Action action) {
      frame.add({.kind = ParticipantItem::Kind::pad,
                 .rect = place,
                 .text = text,
                 .size_px = frame.letters(
                     pad.key.height() < frame.em(frame.kOneLine) ? frame.kText : frame.kPrompt),
                 .bold = true,
                 .action = std::move(action)});
    };
    if (is_erase) {
      add_key(rect, key, {.what = Action::What::erase});
    } else if (key == "." && sign == NumberSign::minus) {
      const QRectF half = rect.adjusted(0.0, 0.0, -(rect.width() + pad.gap) / 2.0, 0.0);
      add_key(half, key, {.what = Action::What::write, .text = key});
      add_key(half.translated((rect.width() + pad.gap) / 2.0, 0.0), QStringLiteral("−"),
              {.what = Action::What::write, .text = "-"});
    } else {
      add_key(rect, key, {.what = Action::What::write, .text = key});
    }
  }
}

}  // namespace

void lay_out_number(PageFrame& frame, const NumberTexts& texts, NumberSign sign) {
  const bool answers = frame.question_over(
      frame.scene_text(), [&](double height) { return is_enough_for_number(frame, height); });
  frame.need_pages(frame.question_pages() + 1);
  if (!answers) return;
  const QRectF& body = frame.body();
  const QString& typed = frame.inputs().draft.number;
  const double gap = frame.px(frame.kGap) / 2.0;
  const double key_width = std::min(frame.em(104.0), std::floor((body.width() - 2.0 * gap) / 3.0));
  // Beside the pad, or above it.
  const double beside = body.width() - (3.0 * key_width + 2.0 * gap) - frame.px(3 * frame.kGap);
  QSizeF shown(std::min(frame.em(320.0), frame.is_wide() ? beside : body.width()),
               frame.tall(frame.kChip));
  // Both have room, so that nothing moves under the hand when one takes the place of the other.
  const double range_width = frame.is_wide() ? std::min(beside, frame.em(400.0)) : body.width();
  const double range_height =
      std::max(frame.height_of(texts.range, frame.letters(frame.kText), false, range_width),
               frame.height_of(texts.no_number, frame.letters(frame.kText), true, range_width)) +
      frame.em(8.0);
  const double above = frame.is_wide() ? 0.0 : shown.height() + range_height + gap;
  const double key_height =
      std::min(frame.em(80.0), std::floor((body.height() - 3.0 * gap - above) / 4.0));
  const QSizeF pad(3.0 * key_width + 2.0 * gap, 4.0 * key_height + 3.0 * gap);
  QRectF pad_rect{};
  QRectF number_rect{};
  QRectF range_rect{};
  if (frame.is_wide()) {
    const double number_width = std::max(shown.width(), range_width);
    const double total = pad.width() + frame.px(3 * frame.kGap) + number_width;
    const double left = body.center().x() - total / 2.0;
    const double pad_x = frame.inputs().mirrored ? left : left + total - pad.width();
    const double number_x = frame.inputs().mirrored ? left + total - number_width : left;
    const double top =
        body.center().y() - std::max(shown.height(), (shown.height() + range_height) / 2.0);
    pad_rect = QRectF(QPointF(pad_x, body.center().y() - pad.height() / 2.0), pad);
    number_rect = QRectF(QPointF(number_x + (number_width - shown.width()) / 2.0, top), shown);
    range_rect = QRectF(number_x, number_rect.bottom(), number_width, range_height);
  } else {
    number_rect = QRectF(QPointF(body.center().x() - shown.width() / 2.0, body.top()), shown);
    range_rect = QRectF(body.left(), number_rect.bottom(), body.width(), range_height);
    pad_rect =
        QRectF(QPointF(body.center().x() - pad.width() / 2.0, range_rect.bottom() + gap), pad);
  }
  // As large as all that may be typed fits.
  const double digits = shown.width() - frame.em(frame.kGap);
  int size_px = frame.letters(frame.kLarge);
  const QString number = texts.unit.isEmpty() ? typed : (typed + ' ' + texts.unit).trimmed();
  while (size_px > frame.letters(frame.kText) && frame.width_of(number, size_px, true) > digits) {
    --size_px;
  }
  frame.add({.kind = ParticipantItem::Kind::number,
             .rect = number_rect,
             .text = number,
             .size_px = size_px,
             .bold = true});
  if (is_no_number(typed, sign)) {
    frame.add({.rect = range_rect,
               .text = texts.no_number,
               .size_px = frame.letters(frame.kText),
               .bold = true});
  } else if (!texts.range.isEmpty()) {
    frame.add({.rect = range_rect,
               .text = texts.range,
               .size_px = frame.letters(frame.kText),
               .muted = true});
  }
  add_keys(frame, {.corner = pad_rect.topLeft(), .key = {key_width, key_height}, .gap = gap}, sign);
}

std::optional<ParticipantAction> key_of_number(int key, const QString& typed, NumberSign sign) {
  if (key == Qt::Key_Backspace) return Action{.what = Action::What::erase};
  if (typed == ",") return Action{.what = Action::What::write, .text = "."};
  const QString signs = sign == NumberSign::minus ? "0123456789.-" : "0123456789.";
  if (typed.size() == 1 && signs.contains(typed)) {
    return Action{.what = Action::What::write, .text = typed};
  }
  return {};
}

void write_number(const ParticipantAction& action, NumberSign sign, QString& number) {
  if (action.what == Action::What::erase) {
    number.chop(1);
  } else if (action.text == "-" && sign == NumberSign::minus &&
             !number.endsWith('e', Qt::CaseInsensitive)) {
    // A minus changes the sign, wherever it is pressed.
    number = number.startsWith('-') ? number.mid(1) : '-' + number;
  } else if (number.size() < kLongestNumber) {
    number += action.text;
  }
}

bool is_no_number(const QString& typed, NumberSign sign) {
  constexpr qsizetype kMostSigns = 15;  // all digits of it are kept
  static const QRegularExpression kBegun(
      QStringLiteral("^-?[0-9]*[.]?[0-9]*$|^-?([0-9]+[.]?[0-9]*|[.][0-9]+)[eE][+-]?[0-9]*$"));
  if (typed.startsWith('-') && sign == NumberSign::none) return true;
  return typed.size() > kMostSigns || !kBegun.match(typed).hasMatch();
}

}  // namespace asperity
