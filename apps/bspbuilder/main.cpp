/// BSPBuilder: a model and its kd-tree in one file that loads quickly.
#include "bspbuilder/builder_options.h"
#include "bspbuilder/builder_run.h"

#include "common/cli/run_program.h"

int main(int argc, char** argv) {
    return app::runProgram(argc, argv, bspbuilder::builderSpec(), bspbuilder::runBuilder);
}
