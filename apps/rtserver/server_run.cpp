#include "rtserver/server_run.h"

#include "rtserver/background.h"
#include "rtserver/server_loop.h"
#include "rtserver/server_options.h"

#include "common/run_program.h"
#include "common/threads.h"

#include "ipc/platform/error.h"

namespace rtserver {

namespace {

app::ExitCode exitCodeOf(ipc::Problem problem) {
    switch (problem) {
    case ipc::Problem::BadName:
        return app::ExitCode::Usage;
    case ipc::Problem::AlreadyRunning:
    case ipc::Problem::NoSpace:
        return app::ExitCode::TryAgain;
    default:
        return app::ExitCode::Failed;
    }
}

} // namespace

app::ExitCode runServer(const app::Arguments& arguments) {
    const Options options = readOptions(arguments);
    // Before the first thread, and before the lock that the server holds.
    if (options.daemon) {
        if (const std::optional<app::ExitCode> parent = goToBackground()) return *parent;
    }
    app::useThreads(options.threads);
    try {
        ServerLoop loop(options, [&] {
            if (options.daemon) detach();
        });
        return loop.run();
    } catch (const ipc::Error& error) {
        app::printMessage(serverSpec().name, error.what());
        return exitCodeOf(error.problem);
    }
}

} // namespace rtserver
