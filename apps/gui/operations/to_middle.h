/// Moving the camera sideways, so that a point is seen in the middle.
#pragma once

#include "gui/operations/gui_context.h"

class QPointF;

namespace gui {

/// The point at that position in the viewport, widget pixels, comes to the middle of the image, and is the
/// pivot from then on. The direction stays. Nothing beside the image.
void bringToMiddle(const GuiContext& context, const QPointF& position);

} // namespace gui
