// Where everything stands in the participant's picture, and what it does when it is pressed.

#pragma once

#include <optional>
#include <vector>

#include <QtCore/QRectF>
#include <QtCore/QSizeF>
#include <QtCore/QString>
#include <QtGui/QFont>

#include "app/gui/participant/participant_keys.h"
#include "app/session/respondents/participant_scene.h"

namespace asperity {

/// What the participant has begun and not yet said: of no concern to the session until it is
/// confirmed or completed.
struct ParticipantDraft {
  std::optional<int> surface{};  ///< of an assignment: picked by hand, from 1
  std::optional<int> option{};   ///< of a form
  QString number{};              ///< of a form or a trial, as typed
  QString text{};                ///< of a form, as written
};

/// One thing in the picture.
struct ParticipantItem {
  enum class Kind {
    words,
    picture,    ///< with `key` under or beside it, and on it the surface that it was `given_to`
    standard,   ///< the picture that realism is measured against
    option,     ///< a large button: a letter, or words with their key
    chip,       ///< a surface
    control,    ///< goes on, feels again, confirms
    scale,      ///< a line with a mark; its ends are `side` inside of `rect`
    pad,        ///< a key of the number pad
    number,     ///< what was typed
    field,      ///< where text is typed
    workspace,  ///< where the scene of object, tool and probe is
    guide,      ///< where bars and target are (LiveGuide); `size_px`: of numbers at bars, or 0
    cue,
  };
  Kind kind = Kind::words;
  QRectF rect{};
  QString text{};
  QString key{};      ///< what is pressed for it
  QString picture{};  ///< study-relative
  double side = 0.0;  ///< of the picture, which is a square
  int size_px = 0;    ///< of the letters
  bool muted = false;
  bool bold = false;
  bool left_aligned = false;  ///< of words
  bool points_left = false;   ///< of a chip: the pictures are on its left
  bool points_down = false;   ///< of a chip: the pictures are below it
  bool chosen = false;
  bool felt = false;  ///< of a chip
  bool current =
      false;           ///< the surface under the hand, or the one that the next picture is given to
  bool ready = false;  ///< a control that would be accepted now
  QString given_to{};  ///< of a picture: the surface's letter
  QString given{};     ///< of a chip: the picture's key
  std::optional<ParticipantScene::Scale> scale{};
  std::optional<ParticipantAction> action{};
};

struct ParticipantLayoutInputs {
  QSizeF size{1366.0, 768.0};
  double smallest_text_px = 32.0;  ///< 24 points on the screen (type_size.h)
  /// From 1, of words that do not fit on one page; 0: the page on which the answer stands. Beyond the
  /// last: the last.
  int page = 1;
  ParticipantDraft draft{};
  bool mirrored = false;  ///< left-handed
  bool cue_shown = false;
  int rest_left_s = 0;
};

/// The picture of a scene: one page of it, where its words do not fit on one. No letter is smaller
/// than `smallest_text_px`; in a window with room all are larger. What has many words is divided,
/// between sentences where that is possible, and has items that turn the page; the last page has what
/// answers the scene. Options of a form too are divided where they find no room on one page. Everything
/// fits without scrolling in a window of 17 × 19 of the smallest letters' heights and more, which is
/// half of a screen of 1093 × 614 px.
std::vector<ParticipantItem> lay_out(const ParticipantScene& scene,
                                     const ParticipantLayoutInputs& inputs);

/// What a guide shows, from above, in rows of one height.
struct GuideRows {
  int track = 0;  ///< rows of the stroke that a target moves along
  bool force = false;
  bool speed = false;
  int bars() const noexcept { return (force ? 1 : 0) + (speed ? 1 : 0); }
  int count() const noexcept { return track + bars(); }
};
GuideRows guide_rows(const Exploration& asked);
/// How much higher a bar's row is with the numbers of its scale under it, in letters of that size.
double height_of_guide_numbers(double letters_px);
/// What stands at a scale from 0 to `end`: at most five round numbers and 0.
std::vector<double> guide_ticks(double end);

QFont participant_font(int size_px, bool bold);

}  // namespace asperity
