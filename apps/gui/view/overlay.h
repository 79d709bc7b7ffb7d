/// The figures in the corner of the picture, and the words in its middle.
#pragma once

#include "gui/session/session.h"

#include <QString>

class QFontMetrics;
class QPainter;
class QRect;

namespace gui {

/// "29 fps · 1280 × 720 (62 %) · walking · drawing": `frame` is smaller while the server saves pixels. Does
/// the camera stand still, more pixels follow: "refining".
QString figuresText(const ServerStatus& status, const QSize& frame, bool still);
/// What stands in the middle while there is no live picture; empty when there is.
QString stateText(const Session& session);

/// From the top of the picture down to below the figures.
int figuresHeight(const QFontMetrics& metrics);
void drawFigures(QPainter& painter, const QRect& area, const QString& text);
void drawWords(QPainter& painter, const QRect& area, const QString& text);

} // namespace gui
