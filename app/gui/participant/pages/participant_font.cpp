// Takes the general font of the system at a size in pixels, so that letters scale with the layout.

#include "app/gui/participant/pages/participant_font.h"

#include <algorithm>

#include <QtGui/QFontDatabase>

namespace asperity {

QFont participant_font(int size_px, bool bold) {
  QFont font = QFontDatabase::systemFont(QFontDatabase::GeneralFont);
  font.setPixelSize(std::max(1, size_px));
  font.setBold(bold);
  return font;
}

}  // namespace asperity
