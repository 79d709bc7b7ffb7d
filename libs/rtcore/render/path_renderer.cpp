#include "rtcore/render/path_renderer.h"

#include "rtcore/pathtracing/path_integrator.h"
#include "rtcore/pathtracing/visibility_samples.h"
#include "rtcore/platform/task_errors.h"
#include "rtcore/platform/threads.h"
#include "rtcore/render/pixel_area.h"
#include "rtcore/scene/part_list.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

/// Paths of a wave at most. After many bounces their rays still fill streams, and the longer a stream, the
/// more rays share each node that it fetches. A thread needs 0.5 KB for each.
constexpr std::uint32_t kPaths = 262144;
constexpr std::uint32_t kShownSamples = 16; ///< between two images that are shown
/// The width of the image whose points say what is visible, at most: some 0.3 s of two processors, and of a
/// coarse image, which is there for a moment, less than 0.1.
constexpr int kSurveyed = 128, kSurveyedOfCoarse = 64;

/// How a range of samples is cut into tasks: squares of the image, and samples of each pixel in one wave.
struct Cut {
    int width, height;
    int side;
    std::uint32_t samples;

    int columns() const { return (width + side - 1) / side; }
    int count() const { return columns() * ((height + side - 1) / side); }
    PixelArea area(int task) const {
        const int x = task % columns() * side, y = task / columns() * side;
        return {x, y, std::min(side, width - x), std::min(side, height - y)};
    }
};

/// Squares whose samples fill one wave, but enough of them for all threads. Many samples of few pixels are
/// better than few of many: what is near takes the same way.
Cut cutOf(int width, int height, std::uint32_t samples, int threads) {
    constexpr int kMaxSide = 256, kMinSide = 16, kTasksOfThread = 8;
    const std::uint32_t max = std::clamp(samples, 1U, 1024U);
    Cut cut{width, height, kMaxSide, 1};
    const auto pathsOf = [&] { return static_cast<std::uint32_t>(cut.side * cut.side); };
    while (cut.side > kMinSide && (pathsOf() * max > kPaths || cut.count() < kTasksOfThread * threads))
        cut.side /= 2;
    cut.samples = kPaths / pathsOf();
    return cut;
}

std::uint64_t pixelsOf(const RenderSettings& settings) {
    return static_cast<std::uint64_t>(settings.width) * static_cast<std::uint64_t>(settings.height);
}

/// The mean, in which none counts more than 4096 times what a quarter of the lit ones stay below: numbers
/// that are far too large must not make the unit so large that nothing is left of the rest.
double usualMean(std::vector<double>& values) {
    constexpr double kMaxTimes = 4096;
    const auto count = static_cast<double>(values.size());
    std::erase_if(values, [](double value) { return !(value > 0); });
    if (values.empty()) return 0;
    std::ranges::sort(values);
    const double max = kMaxTimes * values[values.size() / 4];
    double sum = 0;
    for (const double value : values) sum += std::min(value, max);
    return sum / count;
}

} // namespace

/// Renders paths in one thread.
class PathRenderer::Worker {
  public:
    void begin(const PathFrame& frame, const SampleView& samples, const std::atomic<bool>* stop) {
        view_ = &samples;
        integrator_.begin(frame);
        integrator_.stopWhen(stop);
    }

    /// Calls use(id, radiance, index) with each sample, pixel by pixel, and its index for hit() and
    /// transmitted(). False when it was stopped.
    template <typename Use>
    bool render(const Cut& cut, int task, const SampleRange& range, const std::atomic<bool>& stop,
                Use&& use) {
        for (std::uint32_t first = range.first; first < range.last; first += cut.samples) {
            nameSamples(cut.area(task), {first, std::min(range.last, first + cut.samples)});
            makeSampleRays(*view_, samples_, rays_);
            integrator_.trace(rays_, samples_);
            if (stop.load(std::memory_order_relaxed)) return false;
            for (std::size_t i = 0; i < samples_.size(); ++i)
                use(samples_[i], integrator_.radiance().colourAt(i), i);
        }
        return true;
    }
    bool hit(std::size_t index) const { return integrator_.hit()[index] != 0; }
    Colour transmitted(std::size_t index) const { return integrator_.transmitted().colourAt(index); }
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

void PathRenderer::begin(const View& view, int threads) { begin(view, kSurveyed, threads, nullptr); }

void PathRenderer::begin(const View& view, int surveyed, int threads, const std::atomic<bool>* stop) {
    view_ = std::make_unique<const View>(view);
    statistics_ = {};
    materials_.prepare(view.scene, view.settings, Colour{});
    lights_.prepare(view.scene, view.settings, view.tracer.bounds(),
                    partTriangles(view.scene.model, view.scene.hiddenParts));
    aim(view);
    workers_.resize(std::max(workers_.size(), static_cast<std::size_t>(threadsFor(threads))));
    lookAround(surveyed, threads, stop);
    measure();
    hits_.assign(view.settings.width * static_cast<std::size_t>(view.settings.height), 0);
    transmitted_.start(isHidden(background_, view.scene) ? hits_.size() : 0);
}

PathFrame PathRenderer::frame() const {
    return {.scene = view_->scene,
            .tracer = view_->tracer,
            .settings = view_->settings,
            .materials = materials_,
            .lights = lights_,
            .white = view_->settings.falseColours.seesWhite(),
            .hidesBackground = isHidden(background_, view_->scene)};
}

void PathRenderer::aim(const View& view) {
    aimSamples(view, focus_, samples_);
    samples_.pathSeed = static_cast<std::uint32_t>(view.settings.path.seed);
}

/// The same view in an image so wide, but at most twice as high, with its samples in `samples`.
RenderSettings PathRenderer::aimSmall(int width, SampleView& samples) {
    RenderSettings small = view_->settings;
    small.width = width;
    small.height = std::clamp(
        static_cast<int>(width * static_cast<double>(view_->settings.height) / view_->settings.width + 0.5),
        1, 2 * width);
    const View coarse{view_->scene, view_->tracer, view_->camera, small};
    aimSamples(coarse, focus_, samples);
    samples.pathSeed = samples_.pathSeed;
    return small;
}

/// What is to be known of the lights' visibility, from an image that is `maxWidth` wide at most.
void PathRenderer::lookAround(int maxWidth, int threads, const std::atomic<bool>* stop) {
    constexpr int kPixels = 4; ///< of the image, for each of that one, each way
    const RenderSettings& settings = view_->settings;
    if (!settings.shadows || (lights_.surroundings().empty() && lights_.rows().candidates() < 2)) return;
    SampleView samples;
    const RenderSettings small = aimSmall(std::clamp(settings.width / kPixels, 1, maxWidth), samples);
    std::vector<SampleId> ids;
    for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x)
            ids.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), 0});
    }
    RayWave rays;
    makeSampleRays(samples, ids, rays);
    lights_.setVisibility(
        learnVisibility({view_->scene, view_->tracer, settings, materials_, lights_, threads, stop}, rays));
}

/// The unit of the sums, by one sample for each of some 64 x 36 pixels.
void PathRenderer::measure() {
    SampleView samples;
    const RenderSettings small = aimSmall(64, samples);
    const std::atomic<bool> never{false};
    Worker& worker = workerOfThread(0);
    worker.begin(frame(), samples, nullptr);
    std::vector<double> seen;
    const Cut cut = cutOf(small.width, small.height, 1, 0);
    for (int task = 0; task < cut.count(); ++task) {
        worker.render(cut, task, {0, 1}, never, [&](const SampleId&, Colour radiance, std::size_t) {
            const double light = luminance(radiance);
            seen.push_back(std::isfinite(light) ? std::max(light, 0.0) : 0);
        });
    }
    sums_ = ImageSums(view_->settings.width, view_->settings.height, static_cast<float>(usualMean(seen)),
                      keepsHalves(view_->settings));
}

bool PathRenderer::render(const View& view, RenderControl& control, Frame& frame, const Show& show) {
    const auto samples = static_cast<std::uint32_t>(view.settings.path.samples);
    control.tilesDone = 0;
    control.tiles = samples * pixelsOf(view.settings);
    begin(view, kSurveyed, control.threads, &control.cancel);
    std::uint32_t done = 0;
    while (done < samples) {
        // Rounds double at first.
        const std::uint32_t round = show ? std::clamp(done, 1U, kShownSamples) : samples;
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

bool PathRenderer::renderCoarse(const View& view, int block, RenderControl& control, Frame& frame) {
    coarse_ = coarserSettings(view.settings, block);
    control.tilesDone = 0;
    control.tiles = pixelsOf(coarse_);
    begin({view.scene, view.tracer, view.camera, coarse_}, kSurveyedOfCoarse, control.threads,
          &control.cancel);
    aim(view);
    samples_.camera = samples_.camera.coarser(block);
    if (!add({0, 1}, control)) return false;
    develop(frame);
    return true;
}

bool PathRenderer::add(const SampleRange& range, RenderControl& control) {
    const RenderSettings& settings = view_->settings;
    const int team = threadsFor(control.threads);
    const Cut cut = cutOf(settings.width, settings.height, range.count(), team);
    const int tasks = cut.count();
    workers_.resize(std::max(workers_.size(), static_cast<std::size_t>(team)));
    TaskErrors errors;
    const PathFrame frame = this->frame();
#pragma omp parallel num_threads(team)
    errors.guard([&] {
        Worker& worker = workerOfThread(threadNumber());
        worker.begin(frame, samples_, &control.cancel);
#pragma omp for schedule(dynamic, 1) nowait
        for (int task = 0; task < tasks; ++task) {
            if (control.cancel.load(std::memory_order_relaxed) || errors.any()) continue;
            errors.guard([&] {
                worker.render(cut, task, range, control.cancel,
                              [&](const SampleId& id, Colour radiance, std::size_t index) {
                                  const std::size_t pixel =
                                      id.y * static_cast<std::size_t>(settings.width) + id.x;
                                  sums_.add(id.x, id.y, radiance, id.sub);
                                  hits_[pixel] += worker.hit(index) ? 1U : 0U;
                                  if (!transmitted_.empty())
                                      transmitted_.add(pixel, worker.transmitted(index));
                              });
            });
            const PixelArea area = cut.area(task);
            control.tilesDone.fetch_add(static_cast<std::uint64_t>(area.columns) *
                                            static_cast<std::uint64_t>(area.rows) * range.count(),
                                        std::memory_order_relaxed);
        }
#pragma omp critical(rtcore_statistics)
        statistics_.add(worker.statistics());
    });
    errors.rethrow();
    return !control.cancel;
}

void PathRenderer::develop(Frame& frame) const {
    sums_.mean(frame.radiance);
    sums_.halfMeans(frame.halves);
    frame.covered.resize(hits_.size());
    for (std::size_t i = 0; i < hits_.size(); ++i) {
        const auto width = static_cast<std::size_t>(sums_.width());
        const std::uint32_t samples =
            sums_.pixel(static_cast<int>(i % width), static_cast<int>(i / width)).samples;
        const std::uint64_t full = std::uint64_t{hits_[i]} * 255;
        frame.covered[i] = static_cast<std::uint8_t>(
            samples > 0 ? std::min<std::uint64_t>(255, (full + samples / 2) / samples) : 0);
    }
    developTransmitted(frame);
    frame.aovs.clear();
    frame.seen = {};
    frame.matter = {};
    frame.metered.clear();
    frame.checked.clear();
    frame.statistics = statistics_;
}

void PathRenderer::developTransmitted(Frame& frame) const {
    frame.behind = colourBehind(background_, view_->scene);
    if (transmitted_.empty()) {
        frame.transmitted = {};
        return;
    }
    frame.transmitted.width = sums_.width();
    frame.transmitted.height = sums_.height();
    frame.transmitted.pixels.resize(hits_.size());
    for (int y = 0; y < sums_.height(); ++y) {
        for (int x = 0; x < sums_.width(); ++x) {
            const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(sums_.width()) +
                               static_cast<std::size_t>(x);
            frame.transmitted.pixels[pixel] = transmitted_.mean(pixel, sums_.pixel(x, y).samples);
        }
    }
}

} // namespace rtcore
