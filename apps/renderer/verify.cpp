#include "renderer/verify.h"

#include "renderer/frame_check.h"
#include "renderer/frame_list.h"
#include "renderer/output_patterns.h"

#include "common/cli/command_line.h"
#include "common/process/terminal.h"

#include "rtcore/io/recording/camera_list.h"
#include "rtcore/io/text/scn.h"

#include <set>
#include <string>
#include <vector>

namespace renderer {

namespace {

std::vector<std::filesystem::path> patternsOf(const RendererOptions& options) {
    if (options.scene.extension() != ".scn" || !options.outputs.empty())
        return outputPatterns(options, nullptr);
    const rtcore::SceneFile scene = rtcore::readSceneFile(options.scene);
    return outputPatterns(options, &scene);
}

} // namespace

app::ExitCode verifyFrames(const RendererOptions& options, app::Progress& progress) {
    const auto cameras = rtcore::readCameraList(*options.list);
    const auto frames =
        framesOfChunk(framesOfList(cameras, options.frames, patternsOf(options)), options.chunk);
    std::set<int> unfinished;
    std::string lines;
    for (const FileFlaw& flaw : findFlaws(frames, options.threads, progress)) {
        unfinished.insert(flaw.frame);
        lines += std::to_string(flaw.frame) + "\t" + flaw.file.string() + "\t" +
                 (flaw.missing ? "missing" : "broken: " + flaw.reason) + "\n";
    }
    app::writeLines(lines);
    const std::string count = std::to_string(frames.size());
    progress.print(unfinished.empty() ? "all " + count + " frames are there"
                                      : std::to_string(unfinished.size()) + " of " + count +
                                            " frames are missing or broken");
    return unfinished.empty() ? app::ExitCode::Done : app::ExitCode::Failed;
}

} // namespace renderer
