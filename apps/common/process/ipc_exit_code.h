/// The exit code that tells of a failure between the processes: TryAgain for all that may be otherwise soon.
#pragma once

#include "common/process/exit_codes.h"

#include "ipc/platform/error.h"

namespace app {

inline ExitCode exitCodeOf(ipc::Problem problem) {
    switch (problem) {
    case ipc::Problem::BadName:
        return ExitCode::Usage;
    case ipc::Problem::AlreadyRunning:
    case ipc::Problem::NoServer:
    case ipc::Problem::NoSlot:
    case ipc::Problem::NoSpace:
        return ExitCode::TryAgain;
    case ipc::Problem::NotYours:
        return ExitCode::CannotWrite;
    default:
        return ExitCode::Failed;
    }
}

} // namespace app
