#include "common/process/stop.h"

#include "rtcore/platform/error.h"

namespace app {

void throwIfStopped() {
    if (stopRequested()) throw rtcore::FileError(rtcore::FailureKind::Stopped, "", "stopped");
}

ExitCode stopExitCode() noexcept {
    const int signal = stopSignal();
    return signal == 0 ? ExitCode::Interrupted : static_cast<ExitCode>(128 + signal);
}

} // namespace app
