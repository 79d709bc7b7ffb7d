#include "common/process/stop.h"

#include "rtcore/platform/error.h"

#include <atomic>

namespace app {

namespace {

std::atomic<bool> workEnded{false};

} // namespace

bool stopRequested() noexcept { return stopSignal() != 0 || workEnded.load(std::memory_order_relaxed); }

void endWork() noexcept { workEnded = true; }

void beginWork() noexcept { workEnded = false; }

void throwIfStopped() {
    if (stopRequested()) throw rtcore::FileError(rtcore::FailureKind::Stopped, "", "stopped");
}

ExitCode stopExitCode() noexcept {
    const int signal = stopSignal();
    return signal == 0 ? ExitCode::Interrupted : static_cast<ExitCode>(128 + signal);
}

} // namespace app
