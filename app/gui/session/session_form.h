// How much of the session window stands side by side, by its size.

#pragma once

namespace asperity {

enum class SessionForm {
  wide,    ///< plan, plots and the rest in three columns
  medium,  ///< two columns, without the mirror: half of a screen of 1920
  narrow,  ///< one part at a time: half of a screen of 1366, or a low window
};

/// Where a form fits in the longest of the program's languages.
inline SessionForm form_for(int width, int height) {
  constexpr int kWide = 1264;  // a screen of 1280 less the frame of a window
  constexpr int kMedium = 840;
  // Plan, answers and notes one above the other, below two rows of everything else.
  constexpr int kMediumHeight = 780;
  if (width >= kWide) return SessionForm::wide;
  return width >= kMedium && height >= kMediumHeight ? SessionForm::medium : SessionForm::narrow;
}

}  // namespace asperity
