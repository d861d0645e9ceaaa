// Words of any length in letters of a fixed least size: set in one piece, or divided into pages.

#include "app/gui/participant/pages/page_frame.h"

namespace asperity {

QRectF PageFrame::place_of(const QString& text, int size_px, bool bold, const QRectF& room) const {
  const double height = height_of(text, size_px, bold, room.width());
  double fits = room.width();
  double too_narrow = width_of_longest_word(text, size_px);
  while (fits - too_narrow > 8.0) {
    const double width = std::floor((fits + too_narrow) / 2.0);
    (height_of(text, size_px, bold, width) > height ? too_narrow : fits) = width;
  }
  // A line more than was asked for would be an accident of rounding.
  fits = std::min(room.width(), fits + 8.0);
  return QRectF(room.center().x() - fits / 2.0, room.top(), fits, height);
}

std::vector<QString> PageFrame::parts_of(const QString& text, int size_px, bool bold,
                                         QSizeF room) const {
  const auto fits = [&](const QString& words) {
    return height_of(words.trimmed(), size_px, bold, room.width()) <= room.height();
  };
  std::vector<QString> parts{};
  QString part{};
  const auto end_part = [&] {
    if (!part.trimmed().isEmpty()) parts.push_back(part.trimmed());
    part.clear();
  };
  for (const QString& sentence : pieces_of(text, QTextBoundaryFinder::Sentence)) {
    if (fits(part + sentence)) {
      part += sentence;
      continue;
    }
    end_part();
    for (const QString& word : pieces_of(sentence, QTextBoundaryFinder::Line)) {
      if (!fits(part + word)) end_part();
      part += word;
    }
  }
  end_part();
  return parts;
}

void PageFrame::prompt(const QString& text, int size_px) {
  if (text.isEmpty()) return;
  const QRectF rect = place_of(text, size_px, true, column());
  add({.rect = rect, .text = text, .size_px = size_px, .bold = true});
  body_.setTop(rect.bottom() + px(kGap));
}

bool PageFrame::question_over(const QString& text,
                              const std::function<bool(double height)>& is_enough) {
  question_pages_ = 0;
  if (text.isEmpty()) return true;
  const double width = column().width();
  const auto stands_over = [&](const QString& words, int size_px) {
    return is_enough(body_.height() - px(kGap) - height_of(words, size_px, true, width));
  };
  for (const double size : {kPrompt, kText}) {
    if (!stands_over(text, letters(size))) continue;
    prompt(text, letters(size));
    return true;
  }
  const int size_px = letters(kText);
  QString tail{};
  std::vector<QString> sentences = pieces_of(text, QTextBoundaryFinder::Sentence);
  while (sentences.size() > 1 && stands_over((sentences.back() + tail).trimmed(), size_px)) {
    tail.prepend(sentences.back());
    sentences.pop_back();
  }
  QString head{};
  for (const QString& sentence : sentences) head += sentence;
  const std::vector<QString> parts =
      parts_of(head, size_px, true, QSizeF(width, body_.height() - px(kGap)));
  question_pages_ = static_cast<int>(parts.size());
  if (page_ <= question_pages_) {
    const QString& part = parts[static_cast<std::size_t>(page_ - 1)];
    body_.setTop(body_.center().y() - height_of(part, size_px, true, width) / 2.0);
    prompt(part, size_px);
    return false;
  }
  prompt(tail.trimmed(), size_px);
  return true;
}

void PageFrame::words(const QString& text, const QString& below) {
  const QRectF room = column();
  const double gap = below.isEmpty() ? 0.0 : px(2 * kGap);
  const auto height_left = [&](int size_px) {
    return room.height() - gap -
           (below.isEmpty() ? 0.0 : height_of(below, size_px, true, room.width()));
  };
  // A short sentence is read from afar.
  const bool is_short =
      height_of(text, letters(kLarge), false, room.width()) < 3.0 * letters(kLarge);
  for (const double size : {kLarge, kPrompt, kText}) {
    const int size_px = letters(size);
    if (size == kLarge && !is_short) continue;
    if (height_of(text, size_px, false, room.width()) > height_left(size_px)) continue;
    part_of_words(text, below, size_px);
    return;
  }
  const int size_px = letters(kText);
  const std::vector<QString> parts =
      parts_of(text, size_px, false, QSizeF(room.width(), height_left(size_px)));
  pages_ = std::max(pages_, static_cast<int>(parts.size()));
  const auto number = static_cast<std::size_t>(page_);
  if (number <= parts.size()) part_of_words(parts[number - 1], below, size_px);
}

void PageFrame::part_of_words(const QString& text, const QString& below, int size_px) {
  const double gap = below.isEmpty() ? 0.0 : px(2 * kGap);
  QRectF left = column();
  const double first = height_of(text, size_px, false, left.width());
  const double second = below.isEmpty() ? 0.0 : height_of(below, size_px, true, left.width());
  left.setTop(left.center().y() - (first + gap + second) / 2.0);
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

}  // namespace asperity
