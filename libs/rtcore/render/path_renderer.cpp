#include "rtcore/render/path_renderer.h"

#include "rtcore/pathtracing/path_integrator.h"
#include "rtcore/platform/task_errors.h"
#include "rtcore/platform/threads.h"
#include "rtcore/render/pixel_area.h"
#include "rtcore/scene/part_list.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

/// Pixels of a task's side, and the most samples of each in one wave: 16,384 paths, a full stream.
constexpr int kSide = 32;
constexpr std::uint32_t kSamplesAtOnce = 16;

PixelArea areaOf(int tile, int width, int height) {
    const int columns = (width + kSide - 1) / kSide;
    const int x = tile % columns * kSide, y = tile / columns * kSide;
    return {x, y, std::min(kSide, width - x), std::min(kSide, height - y)};
}
int tilesOf(int width, int height) { return ((width + kSide - 1) / kSide) * ((height + kSide - 1) / kSide); }

/// The mean, in which none counts more than 4096 times what a quarter of the lit ones stay below: numbers
/// that are far too large must not make the unit so large that nothing is left of the rest.
double usualMean(std::vector<double>& values) {
    constexpr double kMostTimes = 4096;
    const auto count = static_cast<double>(values.size());
    std::erase_if(values, [](double value) { return !(value > 0); });
    if (values.empty()) return 0;
    std::ranges::sort(values);
    const double most = kMostTimes * values[values.size() / 4];
    double sum = 0;
    for (const double value : values) sum += std::min(value, most);
    return sum / count;
}

} // namespace

/// Of one thread.
class PathRenderer::Worker {
  public:
    void begin(const PathFrame& frame, const SampleView& samples, const std::atomic<bool>* stop) {
        view_ = &samples;
        integrator_.begin(frame);
        integrator_.stopWhen(stop);
    }

    /// Calls use(x, y, radiance, hit) with each sample, pixel by pixel. False when it was stopped.
    template <typename Use>
    bool render(const PixelArea& area, const SampleRange& range, const std::atomic<bool>& stop, Use&& use) {
        for (std::uint32_t first = range.first; first < range.last; first += kSamplesAtOnce) {
            nameSamples(area, {first, std::min(range.last, first + kSamplesAtOnce)});
            makeSampleRays(*view_, samples_, rays_);
            integrator_.trace(rays_, samples_);
            if (stop.load(std::memory_order_relaxed)) return false;
            for (std::size_t i = 0; i < samples_.size(); ++i)
                use(samples_[i].x, samples_[i].y, integrator_.radiance().colourAt(i), integrator_.hit()[i]);
        }
        return true;
    }
    const RayStatistics& statistics() const { return integrator_.statistics(); }

  private:
    /// Neighbouring pixels follow each other in blocks, for each sample anew: what is near takes the same
    /// way.
    void nameSamples(const PixelArea& area, const SampleRange& range) {
        samples_.clear();
        for (std::uint32_t sub = range.first; sub < range.last; ++sub) {
            for (int y = 0; y < area.rows; y += kCameraBlock) {
                for (int x = 0; x < area.columns; x += kCameraBlock) nameBlock(area, x, y, sub);
            }
        }
    }
    void nameBlock(const PixelArea& area, int left, int top, std::uint32_t sub) {
        for (int i = 0; i < kCameraBlockRays; ++i) {
            const int x = left + columnInBlock(i), y = top + rowInBlock(i);
            if (x >= area.columns || y >= area.rows) continue;
            samples_.push_back(
                {static_cast<std::uint16_t>(area.left + x), static_cast<std::uint16_t>(area.top + y), sub});
        }
    }

    const SampleView* view_ = nullptr;
    PathIntegrator integrator_;
    std::vector<SampleId> samples_;
    RayWave rays_;
};

PathRenderer::PathRenderer() = default;
PathRenderer::~PathRenderer() = default;

PathRenderer::Worker& PathRenderer::workerOfThread(int thread) {
    auto& worker = workers_[static_cast<std::size_t>(thread)];
    if (worker == nullptr) worker = std::make_unique<Worker>();
    return *worker;
}

void PathRenderer::begin(const View& view, int threads) {
    view_ = std::make_unique<const View>(view);
    statistics_ = {};
    materials_.prepare(view.scene, view.settings, Colour{});
    lights_.prepare(view.scene, view.settings, view.tracer.bounds(),
                    hiddenTriangles(view.scene.model, view.scene.hiddenParts));
    aimSamples(view, focus_, samples_);
    samples_.pathSeed = static_cast<std::uint32_t>(view.settings.path.seed);
    workers_.resize(std::max(workers_.size(), static_cast<std::size_t>(threadsFor(threads))));
    measure();
    hits_.assign(view.settings.width * static_cast<std::size_t>(view.settings.height), 0);
}

/// The unit of the sums, by one sample for each of some 64 x 36 pixels.
void PathRenderer::measure() {
    constexpr int kWidth = 64;
    RenderSettings small = view_->settings;
    small.width = kWidth;
    small.height = std::clamp(
        static_cast<int>(kWidth * static_cast<double>(view_->settings.height) / view_->settings.width + 0.5),
        1, 2 * kWidth);
    const View coarse{view_->scene, view_->tracer, view_->camera, small};
    SampleView samples;
    aimSamples(coarse, focus_, samples);
    samples.pathSeed = samples_.pathSeed;
    const std::atomic<bool> never{false};
    Worker& worker = workerOfThread(0);
    worker.begin({view_->scene, view_->tracer, view_->settings, materials_, lights_}, samples, nullptr);
    std::vector<double> seen;
    for (int tile = 0; tile < tilesOf(small.width, small.height); ++tile) {
        worker.render(areaOf(tile, small.width, small.height), {0, 1}, never,
                      [&](int, int, Colour radiance, int) {
                          const double light = luminance(radiance);
                          seen.push_back(std::isfinite(light) ? std::max(light, 0.0) : 0);
                      });
    }
    sums_ = ImageSums(view_->settings.width, view_->settings.height, static_cast<float>(usualMean(seen)));
}

bool PathRenderer::render(const View& view, RenderControl& control, Frame& frame, const Show& show) {
    const auto samples = static_cast<std::uint32_t>(view.settings.path.samples);
    control.tilesDone = 0;
    control.tiles = std::uint64_t{samples} *
                    static_cast<std::uint64_t>(tilesOf(view.settings.width, view.settings.height));
    begin(view, control.threads);
    std::uint32_t done = 0;
    while (done < samples) {
        // Rounds double until each is a whole wave of a tile.
        const std::uint32_t round = show ? std::clamp(done, 1U, kSamplesAtOnce) : samples;
        const SampleRange range{done, std::min(samples, done + round)};
        if (!add(range, control)) return false;
        done = range.last;
        if (!show || done == samples) continue;
        develop(frame);
        show(done, frame);
    }
    develop(frame);
    return !control.cancel;
}

bool PathRenderer::add(const SampleRange& range, RenderControl& control) {
    const RenderSettings& settings = view_->settings;
    const int tiles = tilesOf(settings.width, settings.height);
    const int team = threadsFor(control.threads);
    workers_.resize(std::max(workers_.size(), static_cast<std::size_t>(team)));
    TaskErrors errors;
    const PathFrame frame{view_->scene, view_->tracer, settings, materials_, lights_};
#pragma omp parallel num_threads(team)
    errors.guard([&] {
        Worker& worker = workerOfThread(threadNumber());
        worker.begin(frame, samples_, &control.cancel);
#pragma omp for schedule(dynamic, 1) nowait
        for (int tile = 0; tile < tiles; ++tile) {
            if (control.cancel.load(std::memory_order_relaxed) || errors.any()) continue;
            errors.guard([&] {
                worker.render(
                    areaOf(tile, settings.width, settings.height), range, control.cancel,
                    [&](int x, int y, Colour radiance, int hit) {
                        sums_.add(x, y, radiance);
                        hits_[static_cast<std::size_t>(y) * static_cast<std::size_t>(settings.width) +
                              static_cast<std::size_t>(x)] += hit != 0 ? 1U : 0U;
                    });
            });
            control.tilesDone.fetch_add(range.count(), std::memory_order_relaxed);
        }
#pragma omp critical(rtcore_statistics)
        statistics_.add(worker.statistics());
    });
    errors.rethrow();
    return !control.cancel;
}

void PathRenderer::develop(Frame& frame) const {
    sums_.mean(frame.radiance);
    frame.covered.resize(hits_.size());
    for (std::size_t i = 0; i < hits_.size(); ++i) {
        const auto width = static_cast<std::size_t>(sums_.width());
        const std::uint32_t samples =
            sums_.pixel(static_cast<int>(i % width), static_cast<int>(i / width)).samples;
        const std::uint64_t full = std::uint64_t{hits_[i]} * 255;
        frame.covered[i] = static_cast<std::uint8_t>(
            samples > 0 ? std::min<std::uint64_t>(255, (full + samples / 2) / samples) : 0);
    }
    frame.aovs.clear();
    frame.seen = {};
    frame.metered.clear();
    frame.checked.clear();
    frame.statistics = statistics_;
}

} // namespace rtcore
