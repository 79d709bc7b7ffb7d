/// GUI: the window on a running RTServer.
#include "gui/gui_run.h"
#include "gui/gui_spec.h"

#include "common/cli/run_program.h"

int main(int argc, char** argv) { return app::runProgram(argc, argv, gui::guiSpec(), gui::runGui); }
