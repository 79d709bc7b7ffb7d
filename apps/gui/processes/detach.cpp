#include "gui/processes/detach.h"

#include "gui/session/printed_lines.h"

#include "common/process/background.h"

#include <QProcess>

namespace gui {

void startDetached(QProcess& process) {
    wantSentences(process);
    process.setChildProcessModifier(app::startSession);
}

void startInBackground(QProcess& process) {
    wantSentences(process);
    process.setChildProcessModifier(app::lowerPriority);
}

} // namespace gui
