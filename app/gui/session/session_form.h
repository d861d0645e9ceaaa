// How much of the session window stands side by side, by its width.

#pragma once

namespace asperity {

enum class SessionForm {
  wide,    ///< plan, plots and the rest in three columns
  medium,  ///< two columns, without the mirror: half of a screen of 1920
  narrow,  ///< one part at a time: half of a screen of 1366
};

/// Where a form fits in the longest of the program's languages.
inline SessionForm form_for(int width) {
  constexpr int kWide = 1280;
  constexpr int kMedium = 840;
  if (width >= kWide) return SessionForm::wide;
  return width >= kMedium ? SessionForm::medium : SessionForm::narrow;
}

}  // namespace asperity
