#include "gui/processes/detach.h"

#include "common/process/background.h"

#include <QProcess>

namespace gui {

void startDetached(QProcess& process) { process.setChildProcessModifier(app::startSession); }
void startInBackground(QProcess& process) { process.setChildProcessModifier(app::lowerPriority); }

} // namespace gui
