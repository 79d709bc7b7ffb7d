#include "renderer/output_patterns.h"

#include "renderer/output_names.h"
#include "renderer/variant_choice.h"

#include "common/cli/command_line.h"

#include "rtcore/platform/error.h"

#include <algorithm>
#include <system_error>

namespace renderer {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const RendererOptions& options, const rtcore::Sentence& reason) {
    throw rtcore::FileError(rtcore::FailureKind::BadData, options.scene.string(), reason);
}

/// A user who renders a foreign scene does not expect it to write anywhere but beside itself.
void checkInsideFolder(const RendererOptions& options, const fs::path& output) {
    std::error_code unknown;
    const fs::path folder = fs::weakly_canonical(fs::absolute(options.scene).parent_path(), unknown);
    const fs::path target = fs::weakly_canonical(fs::absolute(output), unknown);
    const bool inside =
        std::mismatch(folder.begin(), folder.end(), target.begin(), target.end()).first == folder.end();
    if (!inside)
        refuse(options,
               rtcore::say("its output, {0}, lies outside of the scene's folder; name it by -o if it is "
                           "to be written",
                           output.string()));
}

} // namespace

std::vector<fs::path> outputPatterns(const RendererOptions& options, const rtcore::SceneFile* scene) {
    if (!options.outputs.empty()) {
        std::vector<fs::path> outputs = options.outputs;
        for (fs::path& each : outputs) each = withWord(each, options.outputWord);
        return outputs;
    }
    if (options.video || options.preview) return {};
    fs::path output = options.scene.stem().string() + ".png";
    if (scene != nullptr && scene->output) {
        output = *scene->output;
        checkInsideFolder(options, output);
    }
    try {
        checkOutput(output, options.missingFolder());
    } catch (const app::UsageError& error) {
        refuse(options, error.sentence());
    }
    return {withWord(output, options.outputWord)};
}

} // namespace renderer
