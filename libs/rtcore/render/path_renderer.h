/// Images by path tracing, in rounds of samples that are summed up in whole numbers.
#pragma once

#include "rtcore/kernels/ray_statistics.h"
#include "rtcore/pathtracing/light_set.h"
#include "rtcore/pathtracing/path_integrator.h"
#include "rtcore/render/background.h"
#include "rtcore/render/frame.h"
#include "rtcore/render/frame_renderer.h"
#include "rtcore/render/image_sums.h"
#include "rtcore/render/sample_rays.h"
#include "rtcore/render/transmitted_sums.h"
#include "rtcore/render/view.h"
#include "rtcore/shading/surface/material_table.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace rtcore {

/// Samples of each pixel, from first to last - 1.
struct SampleRange {
    std::uint32_t first = 0, last = 0;

    std::uint32_t count() const { return last - first; }
};

/// One image after another; keeps the memory of its threads. Not for several threads at once: it uses all of
/// them itself. The sums have the same bits for any number of threads, any instruction set, and any cut of
/// the samples into ranges, in any order.
class PathRenderer {
  public:
    PathRenderer();
    ~PathRenderer();
    PathRenderer(const PathRenderer&) = delete;
    PathRenderer& operator=(const PathRenderer&) = delete;

    /// Of images to come; shown unless told.
    void treatBackground(Background how) { background_ = how; }

    /// Gets the image so far, of so many samples, and may read it until it returns.
    using Show = std::function<void(std::uint32_t samples, const Frame&)>;

    /// Renders view.settings.path.samples of each pixel into `frame`; with `show`, in rounds that it gets,
    /// from one sample on. control.tilesDone over control.tiles, here in samples, is how far it is. False
    /// when control.cancel was set, with `frame` undefined.
    bool render(const View& view, RenderControl& control, Frame& frame, const Show& show = {});

    /// A coarse image: one sample for each square of `block` x `block` pixels. `frame` gets a pixel for each
    /// square, also for those that the right or lower edge cuts.
    bool renderCoarse(const View& view, int block, RenderControl& control, Frame& frame);

    /// Begins an image without samples, of view.settings.width x height. Everything of the view must live,
    /// and stay as it is, until the next one begins. Learns what points see (learnVisibility()), and measures
    /// the mean luminance in a small pass, for the unit of the sums. Throws what std::vector throws.
    void begin(const View& view, int threads);

    /// Adds these samples to each pixel; control.tiles and tilesDone tell how far it is. False when
    /// control.cancel was set: the image then needs a new beginning.
    bool add(const SampleRange& range, RenderControl& control);

    const ImageSums& sums() const { return sums_; }
    const LightSet& lights() const { return lights_; }
    /// The means so far: radiance, where a net is mixed with it its halves, coverage, and what is seen of a
    /// background that is hidden; without AOVs.
    void develop(Frame& frame) const;

  private:
    class Worker;
    void begin(const View& view, int surveyed, int threads, const std::atomic<bool>* stop);
    PathFrame frame() const;
    void aim(const View& view);
    RenderSettings aimSmall(int width, SampleView& samples);
    void lookAround(int maxWidth, int threads, const std::atomic<bool>* stop);
    void measure();
    void developTransmitted(Frame& frame) const;
    Worker& workerOfThread(int thread);

    std::unique_ptr<const View> view_;
    RenderSettings coarse_; ///< of the view, where it is a coarse one
    SampleView samples_;
    FocusFinder focus_;
    MaterialTable materials_;
    LightSet lights_;
    ImageSums sums_;
    std::vector<std::uint32_t> hits_; ///< of each pixel: samples that hit something
    Background background_ = Background::Shown;
    TransmittedSums transmitted_; ///< where the background is hidden
    RayStatistics statistics_;
    std::vector<std::unique_ptr<Worker>> workers_; ///< by thread
};

} // namespace rtcore
