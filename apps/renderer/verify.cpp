#include "renderer/verify.h"

#include "renderer/flight_list.h"
#include "renderer/frame_check.h"
#include "renderer/frame_list.h"
#include "renderer/output_patterns.h"

#include "common/cli/command_line.h"
#include "common/process/terminal.h"

#include "rtcore/io/recording/camera_list.h"
#include "rtcore/io/text/scn.h"

#include <fmt/core.h>

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
    const auto cameras =
        options.flight ? std::vector<std::filesystem::path>(static_cast<std::size_t>(framesOfFlight(options)))
                       : rtcore::readCameraList(*options.list);
    const auto frames =
        framesOfChunk(framesOfList(cameras, options.frames, patternsOf(options)), options.chunk);
    std::set<int> unfinished;
    std::string lines;
    for (const FileFlaw& flaw : findFlaws(frames, options.threads, progress)) {
        unfinished.insert(flaw.frame);
        lines += fmt::format("{}\t{}\t{}\n", flaw.frame, flaw.file.string(),
                             flaw.missing ? "missing" : "broken: " + flaw.reason.english());
    }
    app::writeLines(lines);
    progress.print(unfinished.empty() ? fmt::format("all {} frames are there", frames.size())
                                      : fmt::format("{} of {} frames are missing or broken",
                                                    unfinished.size(), frames.size()));
    return unfinished.empty() ? app::ExitCode::Done : app::ExitCode::Failed;
}

} // namespace renderer
