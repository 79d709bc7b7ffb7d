#include "renderer/output_patterns.h"

#include "renderer/output_names.h"

#include "common/command_line.h"

#include "rtcore/platform/error.h"

namespace renderer {

std::vector<std::filesystem::path> outputPatterns(const RendererOptions& options,
                                                  const rtcore::SceneFile* scene) {
    if (!options.outputs.empty()) return options.outputs;
    if (options.video || options.preview) return {};
    std::filesystem::path output = options.scene.stem().string() + ".png";
    if (scene != nullptr && scene->output) output = *scene->output;
    try {
        checkOutput(output);
    } catch (const app::UsageError& error) {
        throw rtcore::FileError(rtcore::FailureKind::BadData, options.scene.string(), error.what());
    }
    return {output};
}

} // namespace renderer
