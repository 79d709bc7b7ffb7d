#include "common/process/exit_codes.h"

#include "common/process/stop.h"

namespace app {

ExitCode exitCodeOf(rtcore::FailureKind kind) {
    switch (kind) {
    case rtcore::FailureKind::BadData:
        return ExitCode::BadData;
    case rtcore::FailureKind::NoInput:
        return ExitCode::NoInput;
    case rtcore::FailureKind::CannotWrite:
        return ExitCode::CannotWrite;
    case rtcore::FailureKind::TryAgain:
        return ExitCode::TryAgain;
    case rtcore::FailureKind::Stopped:
        return stopExitCode();
    }
    return ExitCode::Failed;
}

} // namespace app
