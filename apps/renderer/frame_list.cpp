#include "renderer/frame_list.h"

#include "common/cli/command_line.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace renderer {

namespace {

FrameTask makeFrame(int number, const std::filesystem::path& camera,
                    std::span<const std::filesystem::path> patterns, bool ofList) {
    FrameTask frame{.number = number, .camera = camera, .outputs = {}};
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

std::vector<FrameTask> pickFrames(std::span<const std::filesystem::path> cameras, const FrameRange& range,
                                  std::span<const std::filesystem::path> patterns) {
    std::vector<FrameTask> frames;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const int number = static_cast<int>(i) + 1;
        if (range.contains(number)) frames.push_back(makeFrame(number, cameras[i], patterns, true));
    }
    return frames;
}

std::vector<FrameTask> framesOfList(std::span<const std::filesystem::path> cameras, const FrameRange& range,
                                    std::span<const std::filesystem::path> patterns) {
    std::vector<FrameTask> frames = pickFrames(cameras, range, patterns);
    if (frames.empty() && !cameras.empty()) {
        throw app::UsageError(fmt::format(
            "no frame to render: the list has {}, and --frames picks none of them", cameras.size()));
    }
    return frames;
}

FrameTask singleFrame(const std::filesystem::path& camera, std::span<const std::filesystem::path> patterns) {
    return makeFrame(1, camera, patterns, false);
}

void refuseInputs(const app::InputFiles& inputs, const FrameTask& frame) {
    for (const std::filesystem::path& output : frame.outputs) {
        if (!isStandardOutput(output)) inputs.refuse(output);
    }
}

std::vector<FrameTask> framesOfChunk(std::vector<FrameTask> frames, const Chunk& chunk) {
    const auto bound = [&](int part) {
        return static_cast<std::ptrdiff_t>(static_cast<std::uint64_t>(frames.size()) *
                                           static_cast<std::uint64_t>(part) /
                                           static_cast<std::uint64_t>(chunk.parts));
    };
    return {frames.begin() + bound(chunk.part - 1), frames.begin() + bound(chunk.part)};
}

} // namespace renderer
