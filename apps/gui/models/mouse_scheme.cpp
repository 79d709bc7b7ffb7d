#include "gui/models/mouse_scheme.h"

#include "gui/models/translated.h"

#include <algorithm>
#include <iterator>

namespace gui {

namespace {

constexpr const char* kNames[]{"usual", "f3d", "blender"};

} // namespace

const QList<DragRow>& dragsOf(MouseScheme scheme) {
    static const QList<DragRow> kUsual{{Qt::LeftButton, Qt::ShiftModifier, Drag::Moves},
                                       {Qt::LeftButton, Qt::NoModifier, Drag::Turns},
                                       {Qt::MiddleButton, Qt::NoModifier, Drag::Moves}};
    static const QList<DragRow> kF3d{{Qt::LeftButton, Qt::ShiftModifier, Drag::Moves},
                                     {Qt::LeftButton, Qt::NoModifier, Drag::Turns},
                                     {Qt::MiddleButton, Qt::NoModifier, Drag::Moves},
                                     {Qt::RightButton, Qt::NoModifier, Drag::Nears}};
    static const QList<DragRow> kBlender{{Qt::MiddleButton, Qt::ShiftModifier, Drag::Moves},
                                         {Qt::MiddleButton, Qt::ControlModifier, Drag::Nears},
                                         {Qt::MiddleButton, Qt::NoModifier, Drag::Turns}};
    return scheme == MouseScheme::F3d ? kF3d : scheme == MouseScheme::Blender ? kBlender : kUsual;
}

Drag dragOf(MouseScheme scheme, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    for (const DragRow& row : dragsOf(scheme)) {
        if (row.button == button && (modifiers & row.modifiers) == row.modifiers) return row.does;
    }
    return Drag::None;
}

bool hasDrags(MouseScheme scheme, Qt::MouseButton button) {
    const QList<DragRow>& rows = dragsOf(scheme);
    return std::any_of(rows.begin(), rows.end(), [&](const DragRow& row) { return row.button == button; });
}

QString nameOf(MouseScheme scheme) { return QLatin1String(kNames[static_cast<int>(scheme)]); }

MouseScheme mouseSchemeNamed(const QString& name) {
    const auto* found = std::find_if(std::begin(kNames), std::end(kNames),
                                     [&](const char* each) { return name == QLatin1String(each); });
    return found == std::end(kNames) ? MouseScheme::Usual
                                     : static_cast<MouseScheme>(found - std::begin(kNames));
}

QList<MouseSchemeText> mouseSchemeTexts() {
    return {{MouseScheme::Usual, tr("left button turns, Shift moves")},
            {MouseScheme::F3d, tr("as f3d: left turns, middle moves, right goes nearer")},
            {MouseScheme::Blender, tr("as Blender: middle turns, Shift moves, Ctrl goes nearer")}};
}

DragTexts dragTexts(MouseScheme scheme) {
    switch (scheme) {
    case MouseScheme::Usual:
        break;
    case MouseScheme::F3d:
        return {tr("Drag"), tr("Middle button, Shift+drag"), tr("Right button, wheel")};
    case MouseScheme::Blender:
        return {tr("Middle button"), tr("Shift+middle button"), tr("Ctrl+middle button, wheel")};
    }
    return {tr("Drag"), tr("Shift+drag, middle button"), tr("Wheel")};
}

} // namespace gui
