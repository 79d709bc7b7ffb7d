/// RTBridge: shows what an RTServer renders in web pages.
#include "bridge/bridge_options.h"
#include "bridge/bridge_run.h"

#include "common/cli/run_program.h"

int main(int argc, char** argv) {
    return app::runProgram(argc, argv, bridge::bridgeSpec(), bridge::runBridge);
}
