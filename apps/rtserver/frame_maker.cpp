#include "rtserver/frame_maker.h"

#include <algorithm>

namespace rtserver {

bool FrameMaker::trace(const Session& session, rtcore::RenderControl& control) {
    const Clock::time_point start = Clock::now();
    const World& world = session.world();
    if (!renderer_.render(world.loaded.scene, world.tracer, session.camera(), session.settings(), threads_,
                          control, frame_)) {
        return false;
    }
    target_ = developer_.exposure(frame_, session.settings().exposure, threads_);
    seconds_ = std::chrono::duration<double>(Clock::now() - start).count();
    return true;
}

void FrameMaker::develop(const Session& session) {
    constexpr double kLongest = 0.25; // a pause is no time in which the eye saw anything
    const Clock::time_point now = Clock::now();
    const double passed = std::chrono::duration<double>(now - developed_).count();
    developed_ = now;
    if (session.settings().exposure.mode == rtcore::ExposureMode::Fixed) {
        adaptation_.jump(target_);
    } else {
        adaptation_.advance(target_, adaptation_.settled() ? 0 : std::min(passed, kLongest));
    }
    developer_.develop(frame_, session.settings(), adaptation_.value(), threads_, image_);
}

} // namespace rtserver
