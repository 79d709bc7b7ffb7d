/// The transition from the image before to a whole frame while that is traced, so that nothing jumps.
#pragma once

#include "rtcore/post/transition.h"
#include "rtcore/render/finished_tiles.h"
#include "rtcore/render/frame.h"
#include "rtcore/scene/image.h"
#include "rtcore/settings/render_settings.h"

#include <chrono>
#include <functional>
#include <mutex>
#include <vector>

namespace rtserver {

/// begin() and end() are for the thread that traces the frame, step() for another one meanwhile. Knows time
/// only by what it is told.
class GradualImage {
  public:
    using Clock = std::chrono::steady_clock;

    /// A frame of these settings is traced from now on; until then `before` is seen, of the same view, with
    /// that exposure. `threads` = 0: all cores.
    void begin(const rtcore::Frame& before, const rtcore::RenderSettings& settings, float exposure,
               int threads, Clock::time_point now);
    /// False colours of it from here on; null: none. Before the first step().
    void showBy(const rtcore::FalseColours* falseColours);
    /// A better image of that view is seen from here on until the frame is finished; its tiles count from
    /// now on.
    void beginAgain(const rtcore::Frame& better, const rtcore::RenderSettings& settings, int threads);
    /// From here on step() shows nothing. Waits for one that is under way.
    void end();
    /// Gives its memory back; after end().
    void drop();
    /// Gets the tiles of that frame.
    rtcore::FinishedTiles& finished() { return finished_; }

    /// The next image, or null when none is to be shown yet. `radiance` of the frame: only finished tiles are
    /// read; `exposure` gives that of this moment, for surfaces so many times as bright as in `before`.
    const rtcore::LdrImage* step(const rtcore::HdrImage& radiance,
                                 const std::function<float(float brightening)>& exposure,
                                 Clock::time_point now);

  private:
    bool expose(float exposure);

    std::mutex mutex_; ///< guards all below, but for finished_
    rtcore::Transition transition_;
    rtcore::FinishedTiles finished_;
    std::vector<rtcore::PixelArea> waiting_; ///< finished and not yet shown
    double pixels_ = 0;                      ///< of the image
    float exposure_ = 1;
    float brightened_ = 1, brightening_ = 1; ///< before the image that was begun with last; in all
    Clock::time_point shown_;
    bool active_ = false, developed_ = false;
};

} // namespace rtserver
