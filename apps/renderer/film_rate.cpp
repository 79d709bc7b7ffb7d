#include "renderer/film_rate.h"

#include "rtcore/io/text/cam.h"
#include "rtcore/platform/error.h"

#include <cmath>
#include <optional>

namespace renderer {

namespace {

constexpr double kSlowest = 1, kFastest = 240;

std::optional<double> timeOf(const FrameTask& frame) {
    try {
        return rtcore::readCameraFile(frame.camera).time;
    } catch (const rtcore::FileError&) {
        return std::nullopt; // it is reported when the frame's turn comes
    }
}

} // namespace

double recordedFrameRate(std::span<const FrameTask> frames) {
    if (frames.size() < 2) return kUsualFrameRate;
    const std::optional<double> first = timeOf(frames.front()), last = timeOf(frames.back());
    if (!first || !last || !(*last > *first)) return kUsualFrameRate;
    const double rate = (frames.back().number - frames.front().number) / (*last - *first);
    if (!(rate >= kSlowest && rate <= kFastest)) return kUsualFrameRate;
    return std::round(rate * 1000) / 1000;
}

} // namespace renderer
