// The only file of the window that calls the operating system.
#include "gui/processes/detach.h"

#include <QProcess>

#include <sys/resource.h>
#include <unistd.h>

namespace gui {

void startDetached(QProcess& process) {
    process.setChildProcessModifier([] { ::setsid(); });
}

void startModestly(QProcess& process) {
    constexpr int kNicer = 10;
    process.setChildProcessModifier([] { ::setpriority(PRIO_PROCESS, 0, kNicer); });
}

} // namespace gui
