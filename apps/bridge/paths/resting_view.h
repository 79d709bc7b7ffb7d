/// When a view rests, an image of it by paths is rendered: with the light that surfaces send to each other,
/// and with its noise taken away.
#pragma once

#include "bridge/clock.h"
#include "bridge/paths/path_renderer.h"
#include "bridge/stream/preview_frames.h"

#include "ipc/layout/status.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace bridge {

/// One thread: that of the sockets.
class RestingView {
  public:
    /// What it uses of its room.
    struct Links {
        /// Asks the server; `done` is told whether it did it, and its text.
        std::function<void(const std::string& command, std::function<void(bool, const std::string&)> done)>
            ask;
        std::function<void(const std::optional<PreviewRun>&)> show; ///< in place of the server's frames
        std::function<void(const std::string&)> note;               ///< for the journal
    };
    /// Without a renderer it does nothing. `clock` must outlive it.
    RestingView(std::unique_ptr<PathRenderer> renderer, const Clock& clock, Links links);

    /// Whether a page is open and visible; without one nothing is begun.
    void setWatched(bool watched) { watched_ = watched; }
    void statusChanged(const ipc::Status& status);
    /// The server need not learn the light of views that rest: they are rendered here.
    void serverFound();
    void serverGone();
    /// Someone acts, so that the image will be out of date.
    void touched() { interrupt(); }
    void progressed(const PreviewProgress& progress);
    /// To be called every few hundredths of a second.
    void tick();

    /// Of the image that is seen; nothing while the server's frames are.
    const std::optional<PreviewProgress>& shown() const { return shown_; }

  private:
    /// What an image shows.
    struct Moment {
        std::array<float, 10> view{};
        std::uint32_t width = 0, height = 0;
        std::uint64_t image = 0; ///< ipc::Status::imageRevision
        friend bool operator==(const Moment&, const Moment&) = default;
    };
    static Moment momentOf(const ipc::Status& status);
    void interrupt();
    void begin();
    void exported(std::uint64_t run, const std::string& scene, const std::string& camera);
    void fail(const std::string& why);

    const std::unique_ptr<PathRenderer> renderer_;
    const Clock& clock_;
    const Links links_;
    bool watched_ = false, rests_ = false;
    Moment moment_;
    double since_ = 0;     ///< when it began to rest
    std::uint64_t run_;    ///< of the image under way, or of the next
    bool begun_ = false;   ///< this moment has its image, or cannot have one
    bool working_ = false; ///< it is being rendered
    bool again_ = false;   ///< a Renderer of this moment was lost, and another one is tried
    std::optional<PreviewProgress> shown_;
    std::string told_; ///< why there is no image
};

} // namespace bridge
