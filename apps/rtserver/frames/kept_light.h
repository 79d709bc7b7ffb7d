/// The indirect light of walks, kept in files from one visit to the next.
#pragma once

#include "rtserver/detached_task.h"
#include "rtserver/document/document.h"
#include "rtserver/frames/frame_drawing.h"
#include "rtserver/messages.h"

#include "rtcore/gathering/indirect_state.h"
#include "rtcore/platform/sentence.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

namespace rtserver {

/// The file of a scene in a folder of such files: by its name and a hash of its path.
std::filesystem::path lightFileOf(const std::filesystem::path& folder, const std::filesystem::path& scene);

/// One thread, which hardly ever waits: another one reads and writes. Only light of a scene as its file has
/// it is kept, not that of edits which may never be saved; and none while the settings have it switched off.
class KeptLight {
  public:
    /// Of the options count `light`, which the first scene begins with, and `lightCache`, a folder of
    /// files from which scenes take their light and into which it is written. All must outlive it.
    KeptLight(const Options& options, const Document& document, FrameDrawing& drawing, Messages& messages)
        : options_(options), document_(document), drawing_(drawing), messages_(messages) {}

    /// Another scene is shown: its light is read. Waits a little, so that its first frame has it.
    void sceneShown();
    /// Takes what was read. Writes what was learned, while the server is idle.
    void advance(bool idle);
    /// Another scene will be shown, or none: what was learned since the last time is written. `wait`: it is,
    /// when this returns.
    void leave(bool wait);

  private:
    using Clock = std::chrono::steady_clock;

    struct Found {
        std::optional<rtcore::IndirectState> light;
        rtcore::Sentence problem; ///< empty: none
    };
    void takeRead();
    bool worthWriting(std::uint32_t steps) const;
    void write();

    const Options& options_;
    const Document& document_;
    FrameDrawing& drawing_;
    Messages& messages_;
    std::filesystem::path file_;      ///< of the scene that is shown; empty: it has none
    rtcore::Subscription lit_;        ///< the light that is being read
    rtcore::RenderSettings settings_; ///< the same
    bool first_ = true;               ///< no scene was shown before
    std::unique_ptr<DetachedTask<Found>> reading_;
    std::unique_ptr<DetachedTask<rtcore::Sentence>> writing_; ///< its failure; empty: none
    std::uint32_t written_ = 0;                               ///< steps of learning that the file has
    Clock::time_point writtenAt_;
};

} // namespace rtserver
