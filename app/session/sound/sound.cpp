// Names the cues for the store.

#include "app/session/sound/sound.h"

namespace asperity {

const char* text_of(Cue cue) noexcept {
  switch (cue) {
    case Cue::surface:
      return "surface";
    case Cue::next:
      return "next";
    case Cue::question:
      return "question";
    case Cue::option:
      return "option";
    case Cue::accepted:
      return "accepted";
    case Cue::refused:
      return "refused";
    case Cue::right:
      return "right";
    case Cue::wrong:
      return "wrong";
    case Cue::rest:
      return "rest";
    case Cue::paused:
      return "paused";
    case Cue::mask_on:
      return "mask_on";
    case Cue::mask_off:
      return "mask_off";
    case Cue::finished:
      return "finished";
  }
  return "";
}

}  // namespace asperity
