/// Where the other programs of the suite are, and where their logs go.
#pragma once

#include <QString>

namespace gui {

/// "RTServer" -> its path: beside this program, else in PATH; empty when it is nowhere.
QString programPath(const QString& name);

/// A file that a new process of that name may write; its folder exists, for this user alone. Throws nothing:
/// the file may turn out not to be writable.
QString logPath(const QString& name);

/// The folder of this login session, where there is one: files that a killed window leaves there go with the
/// session. Else the folder for temporary files.
QString sessionFolder();

/// A file filter for scenes, kd-trees and models, for file dialogs.
QString sceneFilter();

} // namespace gui
