#include "renderer/frame_list.h"

#include "common/command_line.h"

#include <algorithm>
#include <system_error>

namespace renderer {

namespace {

FrameTask makeFrame(int number, const std::filesystem::path& camera,
                    std::span<const std::filesystem::path> patterns, bool ofList) {
    FrameTask frame{number, camera, {}};
    for (const std::filesystem::path& pattern : patterns) {
        const bool plain = isStandardOutput(pattern);
        frame.outputs.push_back(plain ? pattern : numberedPath(pattern, number, ofList));
        if (std::count(frame.outputs.begin(), frame.outputs.end(), frame.outputs.back()) > 1) {
            throw app::UsageError("two outputs have the same name, " + frame.outputs.back().string());
        }
    }
    return frame;
}

} // namespace

std::vector<FrameTask> framesOfList(std::span<const std::filesystem::path> cameras, const FrameRange& range,
                                    std::span<const std::filesystem::path> patterns) {
    std::vector<FrameTask> frames;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const int number = static_cast<int>(i) + 1;
        if (range.contains(number)) frames.push_back(makeFrame(number, cameras[i], patterns, true));
    }
    if (frames.empty() && !cameras.empty()) {
        throw app::UsageError("no frame to render: the list has " + std::to_string(cameras.size()) +
                              ", and --frames picks none of them");
    }
    return frames;
}

FrameTask singleFrame(const std::filesystem::path& camera, std::span<const std::filesystem::path> patterns) {
    return makeFrame(1, camera, patterns, false);
}

bool isFinished(const FrameTask& frame) {
    std::error_code ignored;
    return std::all_of(frame.outputs.begin(), frame.outputs.end(), [&](const std::filesystem::path& output) {
        return !isStandardOutput(output) && std::filesystem::is_regular_file(output, ignored);
    });
}

} // namespace renderer
