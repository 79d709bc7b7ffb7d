/// Frames of a state: traced, exposed as an eye gets used to them, developed.
#pragma once

#include "rtserver/frames/adaptation.h"
#include "rtserver/frames/frame_detail.h"
#include "rtserver/frames/gradual_image.h"
#include "rtserver/frames/live_governor.h"
#include "rtserver/frames/walk_light.h"
#include "rtserver/walk/workspace.h"

#include "rtcore/live/live_renderer.h"
#include "rtcore/post/develop.h"
#include "rtcore/render/frame_renderer.h"
#include "rtcore/render/light_meter.h"
#include "rtcore/render/view_light.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace rtserver {

/// One thread, which uses `threads` of its own. Keeps its memory from frame to frame.
class FrameMaker {
  public:
    explicit FrameMaker(int threads) : threads_(threads) {}

    /// The radiance of what the state shows, in such detail; a cut frame that is not live takes its shadows
    /// from `maps`, unless that is null. False when control.cancel was set; then there may be no radiance,
    /// while the image stays.
    bool trace(const Workspace& state, const FrameDetail& detail, const rtcore::ShadowMaps* maps,
               rtcore::RenderControl& control);
    /// While trace() draws a whole frame after a coarse one, in another thread: what is seen now, or null
    /// where that is nothing new. Stands until the next call. `state` as trace() has it.
    const rtcore::LdrImage* underWay(const Document& document);
    /// Whether the next frame can be a live one: there is light of a frame before, and nearly all of it
    /// holds. What does not is forgotten.
    bool drawsLive(const Document& document);
    /// Takes over the light of the last frame that was not live, for live ones: that is put off until one is
    /// asked for.
    void seedLive(const Document& document);
    /// The traced pixels of the last frame, if that was live, and the part of its time that they took.
    const LiveGovernor::Cost& liveCost() const { return liveCost_; }
    /// The fraction of the last frame's pixels whose light is of frames before it.
    double kept() const { return keptPart_; }
    /// Of the indirect light that the last frame shows (IndirectLight::Learned::error); 0 without it.
    double indirectError() const { return indirectError_; }
    /// The revision of the state that the last frame shows; 0: there is no frame.
    std::uint64_t revision() const { return revision_; }
    /// Whether the state changed since, or there is no frame.
    bool stale(const Document& document) const {
        return revision_ == 0 || revision_ != document.revisions().revision();
    }
    bool hasRadiance() const { return seen_ != nullptr; }
    /// Whether the last frame has all the pixels and samples that the state asks for.
    bool whole() const { return detail_.whole(); }
    /// Whether a view that stands is shown no better.
    bool complete() const { return detail_.complete(); }
    /// Whether it depends on the state alone.
    bool exact() const { return detail_.exact(); }
    const FrameDetail& detail() const { return detail_; } ///< of the last frame
    /// The image of the frame that was traced last, at the exposure of this moment. Needs hasRadiance().
    void develop(const Document& document);
    /// Whether develop() would give the same image again.
    bool settled() const { return adaptation_.settled(); }
    /// Bytes for whole frames of such settings, by so many threads, with their image, its copies for caps and
    /// legends, which may come at any time, and effects; `live`, where there is a frame
    /// time: also the least that coarse and live ones take. (docs/live.md)
    static std::size_t bytesOf(const rtcore::RenderSettings& settings, bool live, int threads);
    /// Throws rtcore::FileError TryAgain when there is no memory for such frames and for clients beside them,
    /// to whom the server would not answer otherwise, as far as one can tell.
    static void requireMemory(const rtcore::RenderSettings& settings, bool live, int threads);
    /// The light that walks learn; null: none yet.
    const rtcore::IndirectLight* walkLight() const { return walkLight_->known(); }
    /// Walks go on from what is kept of the light of the state.
    void beginLightWith(const Document& document, const rtcore::IndirectState& kept) {
        walkLight_->beginWith(document, kept);
    }
    /// Gives its memory back; there is no frame then.
    void drop();

    const rtcore::LdrImage& image() const { return image_; } ///< empty before the first one
    /// As it is shown: denoised, with its bloom. Needs hasRadiance().
    const rtcore::HdrImage& radiance() const { return *seen_; }
    float exposure() const { return adaptation_.value(); }
    double seconds() const { return seconds_; } ///< that the last frame took to trace
    std::uint64_t rays() const { return rays_; }

  private:
    bool draw(const Workspace& state, const FrameDetail& detail, const rtcore::ShadowMaps* maps,
              rtcore::RenderControl& control, rtcore::Frame& frame);
    bool drawLive(const Document& document, const FrameDetail& detail, rtcore::RenderControl& control,
                  rtcore::Frame& frame);
    void keepFinished(const rtcore::View& view, const std::vector<rtcore::PixelArea>& tiles,
                      const rtcore::Frame& frame);
    bool showAtOnce(const Document& document, rtcore::RenderControl& control, rtcore::Frame& frame);
    void countRays();
    double errorOfIndirect(const Document& document, const FrameDetail& detail) const;
    bool lightIndirectly(const Document& document, const FrameDetail& detail, const rtcore::View& view,
                         rtcore::RenderControl& control);
    void noticeChanges(const Document& document);
    void seedLive();
    void meter(const Document& document, const rtcore::RenderSettings& settings, const FrameDetail& detail,
               rtcore::RenderControl& control);
    void adapt(float target, const rtcore::ExposureSettings& settings);

    using Clock = std::chrono::steady_clock;

    int threads_;
    std::optional<rtcore::FrameRenderer> renderer_{std::in_place};
    std::optional<rtcore::LiveRenderer> live_{std::in_place};
    std::optional<WalkLight> walkLight_{std::in_place};
    std::optional<rtcore::ViewLight> viewLight_; ///< of the last whole frame
    LiveGovernor::Cost liveCost_;
    rtcore::Subscription kept_;      ///< what the light of live frames knows of the state
    rtcore::RenderSettings keptFor_; ///< the settings that it was traced with
    std::vector<rtcore::Light> keptLights_;
    /// A frame whose light is to be kept.
    struct Unkept {
        const rtcore::Frame* frame; ///< null: there is none
        rtcore::ImagePlane plane;
        std::uint8_t age;
    };
    Unkept unkept_{};
    rtcore::PictureDeveloper developer_;
    rtcore::Frame whole_, coarse_;           ///< apart, so that one keeps its memory beside the other
    const rtcore::HdrImage* seen_ = nullptr; ///< the last frame with its effects; null: no frame
    rtcore::LdrImage image_, step_;          ///< step_: with caps, while a whole frame is traced
    double indirectError_ = 0;
    std::uint64_t revision_ = 0;
    Adaptation adaptation_;
    rtcore::Subscription adapted_; ///< what the adaptation knows of the state
    rtcore::LightMeter meter_;
    std::optional<float> white_; ///< by the meter, of the last frame's view; nothing where it is not asked
    int unmetered_ = 0;          ///< live frames since then
    float target_ = 1;           ///< the exposure that suits the last frame
    Clock::time_point adaptedAt_;
    /// The eye when a whole frame was begun of a view that had been seen before.
    struct Eye {
        Adaptation eye;
        Clock::time_point at;
    };
    std::optional<Eye> begun_;
    GradualImage gradual_;
    double seconds_ = 0, keptPart_ = 0;
    std::uint64_t rays_ = 0;
    FrameDetail detail_; ///< of the last frame
};

} // namespace rtserver
