/// Renderer: images of a scene.
#include "renderer/renderer_options.h"
#include "renderer/renderer_run.h"

#include "common/cli/run_program.h"

int main(int argc, char** argv) {
    app::ProgramSpec spec = renderer::rendererSpec();
    spec.features.push_back(renderer::netFeature());
    return app::runProgram(argc, argv, spec, renderer::runRenderer);
}
