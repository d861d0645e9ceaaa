// Draws the participant's picture.

#pragma once

#include <functional>
#include <vector>

#include <QtCore/QStringList>
#include <QtGui/QColor>
#include <QtGui/QPixmap>

#include "app/gui/participant/participant_layout.h"

class QPainter;

namespace asperity {

/// The same in the light and the dark theme: what a participant sees is part of the experiment, not
/// of the experimenter's taste. Text on either ground has a contrast of 7 : 1 or more.
struct ParticipantColors {
  QColor ground{"#E6E8EB"};
  QColor panel{"#FFFFFF"};
  QColor line{"#A7AEB7"};
  QColor text{"#14181D"};
  QColor muted{"#414A54"};
  QColor press{"#0A4FB3"};
  QColor on_press{"#FFFFFF"};
  QColor cue_ground{"#FFF1C9"};
  QColor cue_line{"#8A5300"};
};

/// The scaled picture of a study-relative path, null while it is not there yet.
using PictureOf = std::function<QPixmap(const QString& picture, double side)>;

/// Draws `items` and returns every piece of text that was drawn, in order: a test can hold it
/// against what a participant must not read.
QStringList paint(QPainter& painter, const std::vector<ParticipantItem>& items,
                  const ParticipantColors& colors, const PictureOf& picture_of);

/// A surface's letter while it is dragged, centred on `at`.
void paint_dragged(QPainter& painter, const QString& letter, QPointF at, double scale,
                   const ParticipantColors& colors);

}  // namespace asperity
