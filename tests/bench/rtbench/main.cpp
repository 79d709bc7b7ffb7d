/// rtbench: how fast rays and frames are, beside Embree on the same rays in the same run.
#include "bench/rtbench/bench_options.h"
#include "bench/rtbench/bench_run.h"

#include "common/cli/run_program.h"

int main(int argc, char** argv) {
    return app::runProgram(argc, argv, rtbench::benchSpec(), rtbench::runBench);
}
