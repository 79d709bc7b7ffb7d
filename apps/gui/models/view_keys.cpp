#include "gui/models/view_keys.h"

#include "gui/models/translated.h"

namespace gui {

QList<ViewKey> viewKeys(MouseScheme scheme) {
    const DragTexts drags = dragTexts(scheme);
    return {{tr("Click, Enter"), tr("Capture mouse and keyboard")},
            {tr("Esc"), tr("Release them")},
            {tr("Mouse"), tr("Look around")},
            {tr("Double click"), tr("Look there")},
            {tr("Ctrl+double click"), tr("Focus the lens there")},
            {tr("Right click"), tr("Select a part and its material")},
            {tr("Alt+digit"), tr("Go to a bookmark")},
            {tr("Wheel"), tr("Speed")},
            {drags.turning, tr("While orbiting: turn the model")},
            {drags.moving, tr("While orbiting: move the model")},
            {drags.nearing, tr("While orbiting: go nearer")},
            {tr("Double click"), tr("While orbiting: look there")},
            {QStringLiteral("E"), tr("Export the camera")},
            {QStringLiteral("H"), tr("Export the camera for high quality")},
            {QStringLiteral("R"), tr("Render in higher quality")},
            {QStringLiteral("R+L"), tr("The same with anti-aliasing")}};
}

} // namespace gui
