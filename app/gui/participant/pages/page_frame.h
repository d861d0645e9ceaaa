// The frame of the participant's picture, and the measures of what is put into it.

#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <QtCore/QRectF>
#include <QtGui/QFontMetricsF>

#include "app/gui/look/words.h"
#include "app/gui/participant/pages/participant_font.h"
#include "app/gui/participant/pages/participant_item.h"
#include "app/gui/participant/pages/participant_words.h"

namespace asperity {

/// Puts items into the picture from its edges inwards: the progress, the row of controls, the place of
/// cues. What is left is the body, which a page (participant_page.h) fills.
///
/// How many pages there are is known when all has been laid out, and what stands on one of them
/// depends on it, as the controls that turn pages take room: a picture is laid out until the counts
/// stay the same (participant_layout.h).
class PageFrame final {
 public:
  PageFrame(const ParticipantScene& scene, const ParticipantLayoutInputs& inputs);

  const ParticipantScene& scene() const noexcept { return scene_; }
  const ParticipantLayoutInputs& inputs() const noexcept { return inputs_; }
  /// What is left of the picture.
  QRectF& body() noexcept { return body_; }
  const QRectF& body() const noexcept { return body_; }

  // --- measures ---
  // Sizes at 1366 × 768 with letters of 32 px.
  static constexpr double kEdge = 32.0;
  static constexpr double kGap = 16.0;
  static constexpr double kLine = 48.0;      // progress, cue
  static constexpr double kControl = 72.0;   // height
  static constexpr double kBadge = 48.0;     // the key under a picture
  static constexpr double kChip = 80.0;      // height
  static constexpr double kOption = 72.0;    // height of an answer in words
  static constexpr double kOneLine = 52.0;   // the least height of a box around one line
  static constexpr double kColumn = 1040.0;  // longer lines are hard to read
  static constexpr double kText = 32.0;      // 24 pt at 96 dots per inch: nothing is smaller
  static constexpr double kPrompt = 38.0;
  static constexpr double kLarge = 54.0;
  static constexpr double kAroundAnswer = 96.0;

  bool is_wide() const { return inputs_.size.width() > 1.1 * inputs_.size.height(); }
  /// Half a small screen, or large letters on one.
  bool is_tight() const {
    return std::min(inputs_.size.width(), inputs_.size.height()) < em(700.0);
  }

  // Spaces grow and shrink with the window. What holds letters grows with the letters; the height of
  // a box may fall to `least` where the window is low.
  double px(double at_reference) const { return std::round(at_reference * space_); }
  double em(double at_reference) const { return std::round(at_reference * type_); }
  double tall(double at_reference, double least = kOneLine) const {
    return std::round(std::clamp(at_reference * inputs_.size.height() / 768.0,
                                 std::min(least, at_reference) * type_, at_reference * type_));
  }
  int letters(double at_reference_px) const {
    return static_cast<int>(std::ceil(at_reference_px * type_ - 1e-9));
  }

  double height_of(const QString& text, int size_px, bool bold, double width) const {
    const QFontMetricsF metrics(participant_font(size_px, bold));
    return std::ceil(
        metrics
            .boundingRect(QRectF(0.0, 0.0, width, 1e6), Qt::AlignHCenter | Qt::TextWordWrap, text)
            .height());
  }
  double width_of(const QString& text, int size_px, bool bold) const {
    return std::ceil(QFontMetricsF(participant_font(size_px, bold)).horizontalAdvance(text));
  }
  double width_of_longest_word(const QString& text, int size_px) const {
    return std::ceil(
        asperity::width_of_longest_word(text, QFontMetricsF(participant_font(size_px, false))));
  }
  /// Of an answer in words, with its key in a circle.
  double width_of_answer(const QString& text) const {
    return width_of(text, letters(kText), false) + em(kAroundAnswer);
  }
  double height_of_answer(const QString& text, double width) const {
    return std::max(tall(kOption),
                    height_of(text, letters(kText), false, width - em(kAroundAnswer)) + em(16.0));
  }

  /// In the language of the scene.
  QString said(const Phrase& phrase) const { return words_in_language(scene_.language, phrase); }
  QString scene_text() const { return words_of(scene_.text_message, scene_.text, scene_.language); }
  /// The names of keys; what is printed on them where there is no room for that.
  QString return_key() const;
  QString space_key() const;

  static QString text_from(const std::string& text) { return QString::fromStdString(text); }

  // --- items ---
  ParticipantItem& add(ParticipantItem item) {
    items_.push_back(std::move(item));
    return items_.back();
  }
  /// The part of the body that is narrow enough to be read.
  QRectF column() const {
    const double width = std::min(body_.width(), em(kColumn));
    return QRectF(body_.center().x() - width / 2.0, body_.top(), width, body_.height());
  }
  /// Takes a strip off one side: left for right-handed people, right for others.
  QRectF take_side(double width);

  // --- words, and pages of them (page_frame_words.cpp) ---
  /// At the top of what is left.
  void prompt(const QString& text, int size_px);
  /// The question over what it is answered by, which says of a height whether that is enough for it.
  /// Where both find no room together, the question begins on `question_pages` of its own, and only
  /// its last sentences, as far as they fit, stand over the answers. False on such a page: it is full.
  bool question_over(const QString& text, const std::function<bool(double height)>& is_enough);
  /// In the middle of what is left: the largest letters in which it fits; on pages where it does not
  /// fit in the smallest.
  void words(const QString& text, const QString& below = {});

  // --- pages ---
  int page() const noexcept { return page_; }                      ///< that is laid out, from 1
  int pages() const noexcept { return pages_; }                    ///< as far as is known
  int question_pages() const noexcept { return question_pages_; }  ///< before those of the answer
  int answer_page() const noexcept { return answer_page_; }        ///< 0: the last
  void need_pages(int pages) { pages_ = std::max(pages_, pages); }
  void set_answer_page(int page) { answer_page_ = page; }

  // --- controls ---
  void add_control(const QString& text, const QString& key, ParticipantAction action, bool ready);
  /// At the inner end of the row of controls where there is room, so that it is not taken for one.
  void add_at_inner_end(ParticipantItem item, double width);

  // --- for the layout: the frame itself, in this order ---
  void begin_page(int page);
  /// `arrow_turns`: → and ← are free to turn pages.
  void add_turning_controls(bool arrow_turns);
  double controls_top() const noexcept { return controls_top_; }
  /// The place of cues and the end of the body: over controls that begin at `controls_top`.
  void end_controls(double controls_top);
  /// Last of all: one that takes more lines covers what is above it.
  void cue();
  void clear() { items_.clear(); }
  std::vector<ParticipantItem> take_items() { return std::move(items_); }

 private:
  bool shows_cue() const { return inputs_.cue_shown && !scene_.cue.empty(); }
  QString key_name(const QString& name, const QString& sign) const;
  void progress();
  void add_control(ParticipantItem item);
  double width_of_control(const ParticipantItem& item) const;
  /// The place of words at the top of `room`, centred: as narrow as the same number of lines
  /// allows, so that no line is left with one word.
  QRectF place_of(const QString& text, int size_px, bool bold, const QRectF& room) const;
  /// Parts of a text that fit into `room`, between sentences where that is possible.
  std::vector<QString> parts_of(const QString& text, int size_px, bool bold, QSizeF room) const;
  void part_of_words(const QString& text, const QString& below, int size_px);

  const ParticipantScene& scene_;
  const ParticipantLayoutInputs& inputs_;
  double type_ = 1.0;
  double space_ = 1.0;
  QRectF body_{};
  std::vector<ParticipantItem> items_{};

  // The row of controls that is being filled.
  double outer_x_ = 0.0;  ///< used of it, from its outer end
  double inner_x_ = 0.0;  ///< used of it, from its inner end
  double row_bottom_ = 0.0;
  double controls_top_ = 0.0;
  QRectF cue_strip_{};
  QRectF progress_strip_{};

  int page_ = 1;
  int pages_ = 1;
  int question_pages_ = 0;
  int answer_page_ = 0;
};

}  // namespace asperity
