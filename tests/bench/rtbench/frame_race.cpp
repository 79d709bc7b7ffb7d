#include "bench/rtbench/frame_race.h"

#include "bench/rtbench/stopwatch.h"

#include "rtcore/render/frame_renderer.h"
#include "rtcore/survey/default_view.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

namespace rtbench {

namespace {

constexpr float kMirror = 0.5F;
constexpr int kDepth = 5;

/// Opaque and lit by one light; nothing else of the model's materials that spawns rays.
rtcore::Scene litScene(const rtcore::Scene& scene, const BenchView& view, float mirror) {
    rtcore::Scene lit = scene;
    for (rtcore::Material& material : lit.materials) {
        material.opacity = 1;
        material.alphaTexture = rtcore::kNoTexture;
        material.mirror = rtcore::kWhite * mirror;
        material.mirrorScale = 1;
        material.fresnel = 0;
    }
    lit.closed.reset();
    rtcore::Light light = rtcore::defaultLight(view.camera(1), scene.mesh().bounds());
    light.position = view.light;
    lit.lights = {light};
    return lit;
}

rtcore::RenderSettings settingsOf(const FrameOptions& options, bool mirrors) {
    rtcore::RenderSettings settings;
    settings.width = options.width;
    settings.height = options.height;
    settings.reflections = mirrors;
    settings.refractions = false;
    settings.maxDepth = kDepth;
    return settings;
}

/// One image of one contender, again and again.
class FrameRunner {
  public:
    FrameRunner(const rtcore::Scene& scene, const rtcore::Camera& camera, const Contender& contender,
                const rtcore::RenderSettings& settings, int threads)
        : scene_(scene), camera_(camera), contender_(contender), settings_(settings), threads_(threads) {}

    void render() {
        const Stopwatch stopwatch(threads_);
        control_.threads = threads_;
        renderer_.render({scene_, *contender_.tracer, camera_, settings_}, control_, frame_);
        seconds_.push_back(stopwatch.seconds());
    }
    /// The times of all frames but the first, which fetches memory.
    FrameTimes times() const {
        std::vector<double> sorted(seconds_.begin() + (seconds_.size() > 1 ? 1 : 0), seconds_.end());
        std::sort(sorted.begin(), sorted.end());
        return {sorted.front(), sorted[sorted.size() / 2]};
    }
    const rtcore::Frame& frame() const { return frame_; }

  private:
    const rtcore::Scene& scene_;
    const rtcore::Camera& camera_;
    const Contender& contender_;
    const rtcore::RenderSettings& settings_;
    int threads_;
    rtcore::FrameRenderer renderer_;
    rtcore::RenderControl control_;
    rtcore::Frame frame_;
    std::vector<double> seconds_;
};

std::size_t differentPixels(const rtcore::Frame& a, const rtcore::Frame& b) {
    const auto differ = [](float x, float y) { return std::fabs(x - y) > 0.01F * std::max(x, y) + 1e-6F; };
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.radiance.pixels.size(); ++i) {
        const rtcore::Colour p = a.radiance.pixels[i];
        const rtcore::Colour q = b.radiance.pixels[i];
        count += differ(p.r, q.r) || differ(p.g, q.g) || differ(p.b, q.b) ? 1 : 0;
    }
    return count;
}

/// The same images by all contenders, in turns.
FrameFigures raceFrame(std::deque<FrameRunner>& runners, int rounds,
                       const std::function<void(double)>& onProgress) {
    for (int round = 0; round <= rounds; ++round) {
        for (FrameRunner& runner : runners) {
            onProgress(static_cast<double>(round) / (rounds + 1));
            runner.render();
        }
    }
    FrameFigures figures;
    figures.ours = runners.front().times();
    figures.pixels = runners.front().frame().radiance.pixels.size();
    if (runners.size() > 1) {
        figures.embree = runners.back().times();
        figures.differentPixels = differentPixels(runners.front().frame(), runners.back().frame());
    }
    return figures;
}

} // namespace

std::vector<FrameFigures> raceFrames(const rtcore::Scene& scene, const BenchView& view,
                                     std::span<const Contender> contenders, const FrameOptions& options) {
    const float aspect = static_cast<float>(options.width) / static_cast<float>(options.height);
    const rtcore::Camera camera = view.camera(aspect);
    std::vector<int> threads{1};
    if (options.threads > 1) threads.push_back(options.threads);
    std::vector<FrameFigures> all;
    const auto tell = [&](double fraction) {
        const double races = 2.0 * static_cast<double>(threads.size());
        if (options.onProgress) options.onProgress((static_cast<double>(all.size()) + fraction) / races);
    };
    for (const bool mirrors : {false, true}) {
        const rtcore::Scene lit = litScene(scene, view, mirrors ? kMirror : 0);
        const rtcore::RenderSettings settings = settingsOf(options, mirrors);
        for (const int count : threads) {
            std::deque<FrameRunner> runners;
            for (const Contender& contender : contenders) {
                runners.emplace_back(lit, camera, contender, settings, count);
            }
            FrameFigures figures = raceFrame(runners, options.rounds, tell);
            figures.kind = mirrors ? "mirrors" : "phong";
            figures.threads = count;
            all.push_back(std::move(figures));
        }
    }
    return all;
}

} // namespace rtbench
