#include "gui/operations/to_middle.h"

#include "gui/session/session.h"
#include "gui/view/frame_view.h"

namespace gui {

void bringToMiddle(const GuiContext& context, const QPointF& position) {
    const auto place = context.view.inPicture(position);
    if (!place) return;
    context.session.takeHold((place->x() + 1) / 2, (1 - place->y()) / 2);
    const QRectF area = context.view.pictureArea();
    context.session.pan(-place->x() / 2, -place->y() / 2 * area.height() / area.width());
}

} // namespace gui
