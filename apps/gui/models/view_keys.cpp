#include "gui/models/view_keys.h"

#include "gui/models/translated.h"

namespace gui {

namespace {} // namespace

QList<ViewKey> viewKeys() {
    return {{tr("Click, Enter"), tr("Capture mouse and keyboard")},
            {tr("Esc"), tr("Release them")},
            {tr("Mouse"), tr("Look around")},
            {tr("Double click"), tr("Look there")},
            {tr("Ctrl+double click"), tr("Focus the lens there")},
            {tr("Right click"), tr("Select a part and its material")},
            {tr("Alt+digit"), tr("Go to a bookmark")},
            {tr("Wheel"), tr("Speed")},
            {tr("Drag"), tr("While orbiting: turn the model")},
            {tr("Shift+drag, middle button"), tr("While orbiting: move the model")},
            {tr("Wheel, double click"), tr("While orbiting: go nearer, look there")},
            {QStringLiteral("E"), tr("Export the camera")},
            {QStringLiteral("H"), tr("Export the camera for high quality")},
            {QStringLiteral("R"), tr("Render in higher quality")},
            {QStringLiteral("R+L"), tr("The same with anti-aliasing")}};
}

} // namespace gui
