/// Labels of the steps that undo takes back.
#pragma once

#include <QString>
#include <QStringList>

namespace gui {

/// As menus say it: "Bloom radius" for the server's "set bloom.radius"; "" for "".
QString editLabel(const QString& step);

/// All that is translated of the table of commands, in English; the context is "Edits".
QStringList editTexts();

} // namespace gui
