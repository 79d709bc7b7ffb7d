/// The overlay in the corner of the viewport, and the text in its middle.
#pragma once

#include "gui/session/session.h"

#include <QString>

class QFontMetrics;
class QPainter;
class QRect;

namespace gui {

/// "29 fps · 1280 × 720 (62 %) · walking · drawing": `frame` is smaller while the server saves pixels. Does
/// the camera stand still, more pixels follow: "sharpening". `rendering`: what the Renderer does with the
/// view, such as "refined"; empty = nothing. It takes the place of "complete". `sharing`: "shared", or empty.
/// `orbits`: the model is in the hand.
QString overlayText(const ServerStatus& status, const QSize& frame, bool still, const QString& rendering,
                    const QString& sharing = {}, bool orbits = false);
/// The text in the middle while there is no live frame; empty when there is, and for the start page.
QString stateText(const Session& session);

/// From the top of the viewport to below the overlay.
int overlayHeight(const QFontMetrics& metrics);
void drawOverlay(QPainter& painter, const QRect& area, const QString& text);
void drawWords(QPainter& painter, const QRect& area, const QString& text);

} // namespace gui
