#include "rtserver/frame_maker.h"

#include "rtcore/platform/error.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <string>

namespace rtserver {

namespace {

int scaled(int pixels, double scale) {
    return std::max(1, static_cast<int>(std::lround(static_cast<double>(pixels) * scale)));
}

} // namespace

bool FrameMaker::trace(const Session& session, double scale, rtcore::RenderControl& control) {
    const Clock::time_point start = Clock::now();
    const World& world = session.world();
    rtcore::RenderSettings settings = session.shownSettings();
    settings.width = scaled(settings.width, scale);
    settings.height = scaled(settings.height, scale);
    if (!renderer_.render(world.loaded.scene, *world.tracer, session.camera(), settings, threads_, control,
                          frame_)) {
        return false;
    }
    scale_ = scale;
    target_ = developer_.exposure(frame_, settings.exposure, threads_);
    seen_ = &developer_.finish(frame_, session.shownSettings(), threads_);
    seconds_ = std::chrono::duration<double>(Clock::now() - start).count();
    return true;
}

void FrameMaker::requireMemory(const rtcore::RenderSettings& settings) {
    constexpr std::size_t kRadiance = sizeof(rtcore::Colour), kPicture = 4, kLayers = 72;
    const bool finished = settings.bloom > 0 || settings.denoise > 0; // as a picture of its own
    const std::size_t pixel =
        kRadiance + kPicture + (finished ? kRadiance : 0) + (settings.denoise > 0 ? kLayers : 0);
    const std::size_t bytes =
        pixel * static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height);
    void* trial = ::operator new(bytes, std::nothrow);
    ::operator delete(trial);
    if (trial != nullptr) return;
    throw rtcore::FileError(rtcore::FailureKind::TryAgain, "",
                            "not enough memory for frames of " + std::to_string(settings.width) + " x " +
                                std::to_string(settings.height) + "; ask for a lower resolution");
}

void FrameMaker::drop() {
    frame_ = {};
    seen_ = nullptr;
    developer_ = {};
    image_ = {};
}

void FrameMaker::develop(const Session& session) {
    constexpr double kLongest = 0.25; // a pause is no time in which the eye saw anything
    const Clock::time_point now = Clock::now();
    const double passed = std::chrono::duration<double>(now - developed_).count();
    developed_ = now;
    const rtcore::RenderSettings settings = session.shownSettings();
    if (settings.exposure.mode == rtcore::ExposureMode::Fixed) {
        adaptation_.jump(target_);
    } else {
        adaptation_.advance(target_, adaptation_.settled() ? 0 : std::min(passed, kLongest),
                            {settings.exposure.brighterSeconds, settings.exposure.darkerSeconds});
    }
    developer_.develop(*seen_, settings, adaptation_.value(), threads_, image_);
}

} // namespace rtserver
