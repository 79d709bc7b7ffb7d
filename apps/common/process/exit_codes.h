/// Exit codes of the programs (the numbers of sysexits.h, and 128 + signal).
#pragma once

#include "rtcore/platform/error.h"

namespace app {

enum class ExitCode {
    Done = 0,
    Failed = 1,        ///< anything without a code of its own
    Usage = 2,         ///< the command line is wrong
    BadData = 65,      ///< the content of a file is wrong
    NoInput = 66,      ///< a file is missing or cannot be read
    CannotWrite = 73,  ///< an output cannot be written
    TryAgain = 75,     ///< a resource is short for the moment; a farm may send the job again
    HungUp = 129,      ///< stopped by SIGHUP
    Interrupted = 130, ///< stopped by SIGINT (Ctrl-C)
    Terminated = 143,  ///< stopped by SIGTERM
};

/// The exit code that tells of such a failure.
ExitCode exitCodeOf(rtcore::FailureKind kind);

} // namespace app
