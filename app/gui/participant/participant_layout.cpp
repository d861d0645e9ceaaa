#include "app/gui/participant/participant_layout.h"

#include <QtGui/QFontDatabase>

#include "app/gui/participant/participant_page.h"

namespace asperity {

QFont participant_font(int size_px, bool bold) {
  QFont font = QFontDatabase::systemFont(QFontDatabase::GeneralFont);
  font.setPixelSize(std::max(1, size_px));
  font.setBold(bold);
  return font;
}

std::vector<ParticipantItem> lay_out(const ParticipantScene& scene,
                                     const ParticipantLayoutInputs& inputs) {
  return ParticipantPage(scene, inputs).lay_out();
}

}  // namespace asperity
