#include "bridge/stream/preview_frames.h"

#include "common/frames/error_byte.h"

#include "ipc/platform/error.h"

#include <algorithm>

namespace bridge {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t kPixelBytes = 4, kAlpha = 3;

/// Pixels of an image that is not whole yet; where A is 0 they are those of `live`.
void layOver(const ipc::Frame& live, ipc::Frame& image) {
    for (std::size_t i = 0; i < image.pixels.size(); i += kPixelBytes) {
        if (image.pixels[i + kAlpha] != std::byte{0}) continue;
        std::copy_n(live.pixels.begin() + static_cast<std::ptrdiff_t>(i), kPixelBytes,
                    image.pixels.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

} // namespace

PreviewProgress progressOf(const ipc::FrameInfo& info) {
    PreviewProgress progress{.run = info.run,
                             .part = static_cast<double>(info.tag) / static_cast<double>(ipc::kPreviewDone),
                             .done = info.tag == ipc::kPreviewDone,
                             .samples = info.samples};
    if (info.format != ipc::PixelFormat::Rgb8Error8) return progress;
    progress.error = app::errorOfThousandths(info.error);
    progress.largestError = app::errorOfThousandths(info.largestError);
    return progress;
}

bool PreviewFrames::find(const std::string& instance) {
    if (instance != instance_) viewer_.reset();
    instance_ = instance;
    try {
        if (!viewer_) viewer_.emplace(instance, 0ns);
        viewer_->update();
    } catch (const ipc::Error& error) {
        viewer_.reset();
        if (error.problem != ipc::Problem::NoServer) throw;
    }
    return viewer_.has_value();
}

bool PreviewFrames::read(const PreviewRun& run, const ipc::Frame& live, ipc::Frame& frame) {
    if (!find(run.instance)) return false;
    frame.info = last_;
    frame.epoch = epoch_;
    if (!viewer_->readFrame(frame)) return false;
    last_ = frame.info;
    epoch_ = frame.epoch;
    const bool fits = frame.info.width == live.info.width && frame.info.height == live.info.height &&
                      frame.pixels.size() == live.pixels.size() &&
                      frame.pixels.size() == kPixelBytes * frame.info.width * frame.info.height;
    if (frame.info.run != run.run || !fits) return false;
    const bool shares = frame.info.samples == 0 && frame.info.tag != ipc::kPreviewDone;
    if (shares && frame.info.format == ipc::PixelFormat::Rgba8) layOver(live, frame);
    return true;
}

} // namespace bridge
