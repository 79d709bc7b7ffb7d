/// The image of a run while it refines, for other programs to look at: a server of frames that takes no
/// commands. docs/protocol.md, "A preview".
#pragma once

#include "renderer/preview_filter.h"
#include "renderer/preview_options.h"
#include "renderer/preview_pace.h"

#include "ipc/endpoint/server.h"
#include "ipc/layout/frame_info.h"

#include "rtcore/post/backdrop.h"
#include "rtcore/post/develop.h"
#include "rtcore/render/image_renderer.h"
#include "rtcore/sections/cap_painter.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace renderer {

/// The errors that a net left in an image.
struct PictureErrors {
    const rtcore::NetReport& report;
    const std::vector<float>& pixels; ///< empty: none are known
};

/// One thread calls it; a thread of its own answers clients, shows tiles as they are finished, and tells how
/// far the image is.
class Preview {
  public:
    /// Takes the instance over, so that viewers find it from now on. Throws ipc::Error; rtcore::FileError
    /// Stopped when a signal came while it waited for a predecessor that is just dying.
    explicit Preview(const PreviewOptions& options);
    /// Nothing is left in shared memory.
    ~Preview();
    Preview(const Preview&) = delete;
    Preview& operator=(const Preview&) = delete;

    /// Marks the frames of images to come, in place of the options' run.
    void setRun(std::uint64_t run);

    /// The light on what images to come show, by rtcore::LightMeter.
    void meter(std::optional<float> white) { white_ = white; }

    /// Behind images to come whose background is hidden; chequers unless told.
    void useBackdrop(const rtcore::Backdrop& backdrop) { backdrop_ = backdrop; }

    /// For images to come whose settings ask for it; null: the filter.
    void useNet(std::shared_ptr<const rtcore::UNet> net) { filter_.useNet(std::move(net)); }

    /// A view to be rendered, with its renderer, control and frame.
    struct Work {
        rtcore::ImageRenderer& images;
        const rtcore::View& view;
        rtcore::RenderControl& control;
        rtcore::Frame& frame;
        rtcore::LuminanceUnit unit = {}; ///< for false colours
    };
    /// As rtcore::ImageRenderer::render, and with its result, which is not shown yet. What is shown before it
    /// has less noise than it has (PreviewFilter). Throws ipc::Error when there is no memory for frames, or
    /// the instance was lost.
    bool render(const Work& work, rtcore::ImageRequest request);

    /// Shows the image that render() gave, developed with `exposure`, before the backdrop where it is
    /// transparent: the last one of the run, when its files stand.
    void finish(const rtcore::LdrImage& picture, float exposure, const PictureErrors& errors);
    /// Until viewers had time to find the last frame, or a signal asks to stop.
    void linger();

  private:
    using Clock = std::chrono::steady_clock;

    void begin(const Work& work);
    void end();
    void showPass(const rtcore::ImagePass& pass);
    void showTiles();
    std::uint64_t tagUnderWay() const;
    void publish(std::uint64_t tag, const rtcore::LdrImage& image);
    const rtcore::LdrImage& withCaps();
    void mark(const PictureErrors& errors);
    void run(const std::stop_token& stop);
    void serve();
    void throwIfFailed() const;

    PreviewOptions options_;       ///< its run is guarded by mutex_
    std::uint32_t allSamples_ = 1; ///< of each pixel of the whole image
    rtcore::PictureDeveloper developer_;
    std::optional<float> white_;
    PreviewFilter filter_;
    rtcore::LdrImage small_;
    rtcore::Backdrop backdrop_ = rtcore::Backdrop::chequers();
    bool hides_ = false; ///< the background of the image at hand

    std::mutex mutex_; ///< guards all below
    std::condition_variable_any wake_;
    std::unique_ptr<ipc::Server> server_;
    ipc::Status status_;
    const Work* work_ = nullptr;        ///< null: nothing is being rendered
    rtcore::LdrImage picture_, capped_; ///< capped_: the same with caps
    rtcore::CapPainter caps_;
    ipc::FrameInfo info_;         ///< of picture_
    rtcore::EffectChain effects_; ///< for parts, by the last whole pass
    PreviewPace pace_;
    Clock::time_point begun_;    ///< the rendering
    std::exception_ptr failure_; ///< of the thread
    std::jthread thread_;        ///< last: it starts when all else stands
};

} // namespace renderer
