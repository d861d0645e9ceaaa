// The composition of the participant's picture; participant_layout.h is its face.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <QtCore/QCoreApplication>
#include <QtGui/QFontMetricsF>

#include "app/gui/participant/participant_layout.h"
#include "app/gui/participant/participant_words.h"

namespace asperity {

/// Puts items into the picture from its edges inwards; `body_` is what is left. Frame, trials and
/// forms are in a file each.
class ParticipantPage final {
  Q_DECLARE_TR_FUNCTIONS(ParticipantLayout)
 public:
  ParticipantPage(const ParticipantScene& scene, const ParticipantLayoutInputs& inputs)
      : scene_(scene),
        inputs_(inputs),
        scale_(std::max(1.0, std::min(inputs.size.width() / 1366.0, inputs.size.height() / 768.0))),
        body_(QPointF(0.0, 0.0), inputs.size) {
    const double edge = std::min(px(kEdge), inputs.size.width() / 28.0);
    body_.adjust(edge, edge / 2.0, -edge, -edge);
  }

  std::vector<ParticipantItem> lay_out();

 private:
  using Item = ParticipantItem;
  using Action = ParticipantAction;
  using Scene = ParticipantScene;

  // Sizes at 1366 × 768, in pixels; everything grows with a larger window.
  static constexpr double kEdge = 32.0;
  static constexpr double kGap = 16.0;
  static constexpr double kLine = 48.0;     // progress, cue
  static constexpr double kControl = 72.0;  // height
  static constexpr double kBadge = 48.0;    // the key under a picture
  static constexpr double kChip = 80.0;     // height
  static constexpr double kOption = 72.0;   // height of an answer in words
  static constexpr double kLetter = 128.0;  // side of an answer that is a letter
  static constexpr double kSmallLetter = 88.0;
  static constexpr double kColumn = 1040.0;  // longer lines are hard to read
  static constexpr int kText_px = 32;        // 24 pt at 96 dots per inch: nothing is smaller
  static constexpr int kPrompt_px = 38;
  static constexpr int kLarge_px = 54;

  static QString text_from(const std::string& text) { return QString::fromStdString(text); }
  bool shows_pictures() const;
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

}  // namespace asperity
