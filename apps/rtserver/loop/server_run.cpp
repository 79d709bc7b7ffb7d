#include "rtserver/loop/server_run.h"

#include "rtserver/detached_task.h"
#include "rtserver/loop/server_loop.h"
#include "rtserver/server_options.h"
#include "rtserver/walk/playback.h"

#include "common/process/background.h"
#include "common/process/error_sentence.h"
#include "common/process/ipc_exit_code.h"
#include "common/process/message.h"
#include "common/process/threads.h"

#include "rtcore/platform/files.h"

#include <cstdlib>

namespace rtserver {

app::ExitCode runServer(const app::Arguments& arguments) {
    const Options options = readOptions(arguments);
    app::shareMemoryAmongThreads(); // each command with a file has a thread
    // A mistake in the list shows before a big scene is loaded.
    if (options.path) const Playback check(*options.path, {});
    // Before the first thread, and before the lock that the server holds.
    if (options.daemon) {
        if (const std::optional<app::ExitCode> parent = app::goToBackground()) return *parent;
    }
    app::useThreads(options.threads);
    try {
        ServerLoop loop(options, [&] {
            if (options.daemon) app::detach();
        });
        return loop.run();
    } catch (const ipc::Error& error) {
        app::printSentence(serverSpec().name, app::sentenceOf(error));
        return app::exitCodeOf(error.problem);
    }
}

void endProcess(int exitCode) {
    // Static objects must outlive all threads that use them.
    if (tasksAtWork() == 0) std::exit(exitCode);
    rtcore::removeTemporaryFiles();
    std::_Exit(exitCode);
}

} // namespace rtserver
