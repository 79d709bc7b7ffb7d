/// Renderer: images of a scene.
#include "renderer/renderer_options.h"
#include "renderer/renderer_run.h"

#include "common/cli/run_program.h"

int main(int argc, char** argv) {
    return app::runProgram(argc, argv, renderer::rendererSpec(), renderer::runRenderer);
}
