/// The effects of drags over the image while the mouse turns the model: by preference as in other viewers.
#pragma once

#include <QList>
#include <QPair>
#include <QString>
#include <Qt>

namespace gui {

enum class MouseScheme { Usual, F3d, Blender };

enum class Drag {
    None,
    Turns, ///< the model, about the point under the pointer
    Moves, ///< it, across the view
    Nears  ///< it, upwards; away downwards
};

/// The effect of a drag by that button while these modifiers are down; others may be, too.
struct DragRow {
    Qt::MouseButton button;
    Qt::KeyboardModifiers modifiers;
    Drag does;
};

/// The first row that fits holds.
const QList<DragRow>& dragsOf(MouseScheme scheme);
Drag dragOf(MouseScheme scheme, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);
/// Whether any row is of that button.
bool hasDrags(MouseScheme scheme, Qt::MouseButton button);

/// Names in the preferences; what is none of them is the usual one.
QString nameOf(MouseScheme scheme);
MouseScheme mouseSchemeNamed(const QString& name);

/// For the user: the schemes with what is done how, and how one does each of these in one of them.
struct MouseSchemeText {
    MouseScheme scheme;
    QString text;
};
QList<MouseSchemeText> mouseSchemeTexts();
struct DragTexts {
    QString turning, moving, nearing; ///< keys and button
};
DragTexts dragTexts(MouseScheme scheme);

} // namespace gui
