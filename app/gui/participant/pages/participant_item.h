// A thing in the participant's picture, and what it does when it is pressed.

#pragma once

#include <optional>
#include <vector>

#include <QtCore/QRectF>
#include <QtCore/QSizeF>
#include <QtCore/QString>

#include "app/session/respondents/participant_scene.h"

namespace asperity {

/// What a key or a click means to the present scene.
struct ParticipantAction {
  enum class What {
    choose,   ///< option `number` (from 1) of a question or form
    surface,  ///< surface `number` (from 1): to be felt, or the one that a picture is given to
    next,     ///< enough of this surface; feel again
    confirm,
    mark,     ///< scale `number` (from 1), at `position`
    step,     ///< the mark of the current scale, `number` steps to the right
    select,   ///< the scale `number` places further on
    write,    ///< `text` into the number
    erase,    ///< the last digit of it
    turn_to,  ///< page `number` (from 1) of the words: of the picture, the session hears nothing
  };
  What what = What::confirm;
  int number = 0;
  double position = 0.0;  ///< of a mark, from 0 at the left end of the scale to 1 at the right
  QString text{};

  bool operator==(const ParticipantAction&) const = default;
};

/// What the participant has begun and not yet said: of no concern to the session until it is
/// confirmed or completed.
struct ParticipantDraft {
  std::optional<int> surface{};  ///< of an assignment: picked by hand, from 1
  QString number{};              ///< as typed
  QString text{};                ///< as written
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
    line,       ///< where a line is drawn; the ends of the longest one are `side` inside of `rect`
    pad,        ///< a key of the number pad
    number,     ///< what was typed
    field,      ///< where text is typed
    workspace,  ///< where the scene of object, tool and probe is
    surface,    ///< where a mouse or a pen feels the surface, seen from above
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
  /// The surface under the hand, or the one that the next picture is given to; the option that a button points at.
  bool current = false;
  bool ready = false;  ///< a control that would be accepted now
  QString given_to{};  ///< of a picture: the surface's letter
  QString given{};     ///< of a chip: the picture's key
  std::optional<ParticipantScene::Scale> scale{};
  std::optional<int> line_step{};  ///< of a line, as ParticipantScene::line_step
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
  /// Width over height of the surface where a mouse or a pen is the probe; 0: it is felt with a device.
  double surface_aspect = 0.0;
  bool cue_shown = false;
  int rest_left_s = 0;
};

}  // namespace asperity
