/// Frames of a session: traced, exposed as an eye gets used to them, developed.
#pragma once

#include "rtserver/adaptation.h"
#include "rtserver/session.h"

#include "rtcore/post/develop.h"
#include "rtcore/render/frame_renderer.h"

#include <chrono>
#include <cstdint>

namespace rtserver {

/// One thread, which uses `threads` of its own. Keeps its memory from frame to frame.
class FrameMaker {
  public:
    explicit FrameMaker(int threads) : threads_(threads) {}

    /// The radiance of what the session shows, with `scale` times its width and height. False when
    /// control.cancel was set: nothing can be developed then until a frame was traced.
    bool trace(const Session& session, double scale, rtcore::RenderControl& control);
    /// Whether the last frame has fewer pixels than the session asks for.
    bool reduced() const { return scale_ < 1; }
    double scale() const { return scale_; }
    /// The picture of the frame that was traced last, at the exposure of this moment.
    void develop(const Session& session);
    /// Whether develop() would give the same picture again.
    bool settled() const { return adaptation_.settled(); }
    /// Throws rtcore::FileError TryAgain when there is no memory for such frames, as far as one can tell.
    static void requireMemory(const rtcore::RenderSettings& settings);
    /// Gives its memory back; there is no frame then.
    void drop();
    /// The next frame is of another scene: its exposure is found at once.
    void forget() { adaptation_ = {}; }

    const rtcore::LdrImage& image() const { return image_; } ///< empty before the first one
    /// As it is shown: denoised, with its glow. After trace() only.
    const rtcore::HdrImage& radiance() const { return *seen_; }
    float exposure() const { return adaptation_.value(); }
    double seconds() const { return seconds_; } ///< that the last frame took to trace
    std::uint64_t rays() const { return frame_.statistics.total(); }

  private:
    using Clock = std::chrono::steady_clock;

    int threads_;
    rtcore::FrameRenderer renderer_;
    rtcore::PictureDeveloper developer_;
    rtcore::Frame frame_;
    const rtcore::HdrImage* seen_ = nullptr; ///< the frame with its effects; null: no frame
    rtcore::LdrImage image_;
    Adaptation adaptation_;
    float target_ = 1; ///< the exposure that suits the frame
    Clock::time_point developed_;
    double seconds_ = 0;
    double scale_ = 1;
};

} // namespace rtserver
