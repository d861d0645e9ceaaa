// Draws the participant's picture.

#pragma once

#include <vector>

#include <QtCore/QStringList>

#include "app/gui/participant/pages/participant_brush.h"
#include "app/gui/participant/pages/participant_page.h"

namespace asperity {

/// Draws `items` of a scene on this page and returns every piece of text that was drawn, in order: a
/// test can hold it against what a participant must not read.
QStringList paint(QPainter& painter, const ParticipantPage& page,
                  const std::vector<ParticipantItem>& items, const ParticipantColors& colors,
                  const PictureOf& picture_of);

/// A surface's letter while it is dragged, centred on `at`.
void paint_dragged(QPainter& painter, const QString& letter, QPointF at, double scale,
                   const ParticipantColors& colors);

}  // namespace asperity
