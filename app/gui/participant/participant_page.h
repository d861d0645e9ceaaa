// The composition of the participant's picture; participant_layout.h is its face.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <QtCore/QCoreApplication>
#include <QtGui/QFontMetricsF>

#include "app/gui/look/words.h"
#include "app/gui/participant/participant_layout.h"
#include "app/gui/participant/participant_words.h"

namespace asperity {

/// Puts items into the picture from its edges inwards; `body_` is what is left. Frame, words, trials
/// and forms are in a file each.
class ParticipantPage final {
 public:
  ParticipantPage(const ParticipantScene& scene, const ParticipantLayoutInputs& inputs);

  std::vector<ParticipantItem> lay_out();

 private:
  using Item = ParticipantItem;
  using Action = ParticipantAction;
  using Scene = ParticipantScene;

  // Sizes at 1366 × 768 with letters of 32 px.
  static constexpr double kEdge = 32.0;
  static constexpr double kGap = 16.0;
  static constexpr double kLine = 48.0;     // progress, cue
  static constexpr double kControl = 72.0;  // height
  static constexpr double kBadge = 48.0;    // the key under a picture
  static constexpr double kWideBadge = 64.0;
  static constexpr double kChip = 80.0;     // height
  static constexpr double kOption = 72.0;   // height of an answer in words
  static constexpr double kLetter = 128.0;  // side of an answer that is a letter
  static constexpr double kSmallLetter = 88.0;
  static constexpr double kOneLine = 52.0;   // the least height of a box around one line
  static constexpr double kColumn = 1040.0;  // longer lines are hard to read
  static constexpr double kText = 32.0;      // 24 pt at 96 dots per inch: nothing is smaller
  static constexpr double kPrompt = 38.0;
  static constexpr double kLarge = 54.0;

  /// In the language of the scene.
  QString said(const Phrase& phrase) const { return words_in_language(scene_.language, phrase); }
  static QString text_from(const std::string& text) { return QString::fromStdString(text); }
  /// Of a form's option, from 0.
  static QString text_of(const Question& question, int option) {
    return text_from(question.text_of_option(static_cast<std::size_t>(option)));
  }
  bool shows_pictures() const;
  QString scene_text() const { return words_of(scene_.text_saying, scene_.text, scene_.language); }
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
  double letter_side() const { return em(is_wide() ? kLetter : kSmallLetter); }

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
  /// The place of words at the top of `room`, centred: as narrow as the same number of lines
  /// allows, so that no line is left with one word.
  QRectF place_of(const QString& text, int size_px, bool bold, const QRectF& room) const;
  double width_of_longest_word(const QString& text, int size_px) const;

  /// Of an answer in words, with its key in a circle.
  double width_of_answer(const QString& text) const {
    return width_of(text, letters(kText), false) + em(kAroundAnswer);
  }
  double height_of_answer(const QString& text, double width) const {
    return std::max(tall(kOption),
                    height_of(text, letters(kText), false, width - em(kAroundAnswer)) + em(16.0));
  }
  static constexpr double kAroundAnswer = 96.0;

  // --- words, and pages of them ---
  struct Divided {
    std::vector<QString> parts{};
    QString tail{};  ///< what stands over the answers
  };
  /// Parts of a text that fit into `room`, between sentences where that is possible.
  std::vector<QString> parts_of(const QString& text, int size_px, bool bold, QSizeF room) const;
  /// At the top of what is left.
  void prompt(const QString& text, int size_px);
  /// The question over what it is answered by, which says of a height whether that is enough for it.
  /// Where both find no room together, the question begins on `question_pages_` of its own, and only
  /// its last sentences, as far as they fit, stand over the answers. False on such a page: it is full.
  bool question_over(const QString& text, const std::function<bool(double height)>& is_enough);
  /// In the middle of what is left: the largest letters in which it fits; on pages where it does not
  /// fit in the smallest.
  void words(const QString& text, const QString& below = {});
  void part_of_words(const QString& text, const QString& below, int size_px);

  // --- the frame ---
  bool shows_cue() const { return inputs_.cue_shown && !scene_.cue.empty(); }
  void progress();
  void controls();
  void turning_controls();
  void reserve_cue();
  void cue();
  void add_control(Item item);
  void add_control(const QString& text, const QString& key, Action action, bool ready);
  /// At the inner end of the row of controls where there is room, so that it is not taken for one.
  void add_at_inner_end(Item item, double width);
  double width_of_control(const Item& item) const;
  QString again_text() const;
  QString key_name(const QString& name, const QString& sign) const;
  void answers_in_words_as_controls();

  // --- trials and forms ---
  void chips_in_rows();
  /// Of surfaces that pictures are given to: in columns beside the pictures, or in rows over them.
  void chips_to_pair();
  int chip_columns() const;
  void chips_beside();
  struct ChipRows {
    int rows = 1;
    int in_a_row = 1;
    double gap = 0.0;
    QSizeF chip{};
    double height = 0.0;  ///< of all rows
  };
  ChipRows chip_rows() const;
  void chips_over(const ChipRows& rows);
  Item chip_to_pair(std::size_t index) const;
  void answers_in_words();
  double height_of_answers_in_words() const;
  void pictures(QRectF room);
  double picture_side(QSizeF room) const;
  double picture_gap() const;
  struct Letters {
    int columns = 1;
    int rows = 1;
    double side = 0.0;
    double height = 0.0;
  };
  Letters letter_rows(QSizeF room) const;
  void letter_options(QRectF room);
  void standard_beside();
  void feel();
  double guide_height() const;
  void guide(const QRectF& place);
  void question();
  bool is_enough_for_question(double height) const;
  void form();
  struct OptionRows {
    int columns = 1;
    int rows = 1;
    double width = 0.0;
    double row_height = 0.0;
    bool fits = false;
  };
  OptionRows option_rows(const Question& question, double height) const;
  /// `chosen`: counted from 1.
  void form_choice(const Question& question, std::optional<int> chosen);
  void form_number(const Question& question);
  enum class Sign { none, minus };
  /// What was typed, and the keys that type it; `range` says what may be.
  void number_pad(const QString& range, Sign sign);
  /// What stands in the place of the range while what was typed is no number.
  QString no_number_text() const;
  bool is_enough_for_number(double height) const;
  QString range_text(const Question& question) const;
  Item answer_in_words(std::size_t index) const;

  // --- scales ---
  struct ScaleRows {
    double width = 0.0;
    double prompt_width = 0.0;  ///< 0: the prompts stand above the lines
    double label_width = 0.0;   ///< beside the ends of the lines; 0: above them, or no labels
    double label_height = 0.0;  ///< of labels above the lines
    double prompt_height = 0.0;  ///< of prompts above the lines
    double above() const { return prompt_height + label_height; }
    double line = 0.0;          ///< height of a line with its labels
    int on_a_page = 1;
    int pages = 1;
  };
  void scales();
  bool is_list_of_points() const;
  Question points_as_options() const;
  ScaleRows scale_rows(double height) const;
  /// For each of two labels above a line of this width.
  double label_room(double width) const;
  void scale_row(const Scene::Scale& scale, int number, const ScaleRows& rows, QRectF room);

  Item& add(Item item) {
    items_.push_back(std::move(item));
    return items_.back();
  }
  QRectF column() const {
    const double width = std::min(body_.width(), em(kColumn));
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
  double type_ = 1.0;
  double space_ = 1.0;
  QRectF body_{};
  std::vector<Item> items_{};

  // The row of controls that is being filled.
  double outer_x_ = 0.0;  ///< used of it, from its outer end
  double inner_x_ = 0.0;  ///< used of it, from its inner end
  double row_bottom_ = 0.0;
  double controls_top_ = 0.0;
  QRectF cue_strip_{};
  QRectF progress_strip_{};

  // How many pages there are is known when all has been laid out, and what stands on one of them
  // depends on it: the controls that turn pages take room.
  int page_ = 1;
  int pages_ = 1;
  int question_pages_ = 0;
  int answer_page_ = 0;  ///< 0: the last
};

}  // namespace asperity
