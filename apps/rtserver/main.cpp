/// RTServer: renders a scene in real time for the programs that look at it and command it.
#include "rtserver/loop/server_run.h"
#include "rtserver/server_options.h"

#include "common/cli/run_program.h"
#include "common/process/threads.h"

int main(int argc, char** argv) {
    app::spinLittle(argv);
    rtserver::endProcess(app::runProgram(argc, argv, rtserver::serverSpec(), rtserver::runServer));
}
