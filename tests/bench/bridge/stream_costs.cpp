// The cost of frames: each rung by itself, and 30 frames per second for one, ten and 64 viewers.
#include "bench/bridge/bench_parts.h"
#include "bench/bridge/goals.h"

#include "bridge/net/page_files.h"
#include "bridge/stream/motion_encoder.h"
#include "bridge/stream/still_encoder.h"
#include "common/process/thread_seconds.h"
#include "support/quantile.h"

namespace bridgebench {

namespace {

constexpr double kRate = 30;

/// The median of processor time, ms, and the bytes.
template <typename Encode>
std::pair<double, double> costOf(Encode&& encode) {
    std::vector<double> times;
    double bytes = 0;
    constexpr int kTries = 60;
    for (int i = 0; i < kTries; ++i) {
        const double start = app::threadSeconds();
        bytes = static_cast<double>(encode()->bytes.size());
        times.push_back(kMs * (app::threadSeconds() - start));
    }
    return {quantile(times, 0.5), bytes};
}

struct Costs {
    double cores = 0, perFrame = 0, rate = 0; ///< of a viewer
};

Costs costsWith(const Bridge& bridge, const InstantServer& server, int count, double seconds) {
    const Viewers viewers = startViewers(bridge.port(), count);
    sleepFor(2);
    const ViewerCounts before = countsOf(viewers);
    const double cpu = bridge.cpu();
    const int published = server.published;
    const auto start = Clock::now();
    sleepFor(seconds);
    const double time = secondsFrom(start), used = bridge.cpu() - cpu;
    const ViewerCounts after = countsOf(viewers);
    fmt::print("--- {} viewer(s): {:.1f} frames/s each of {:.1f} published, {:.1f} Mbit/s in all\n", count,
               (after.frames - before.frames) / time / count, (server.published - published) / time,
               8e-6 * (after.bytes - before.bytes) / time);
    return {used / time, kMs * used / std::max(1, server.published - published),
            (after.frames - before.frames) / time / count};
}

void tellTimes(const nlohmann::json& status) {
    const nlohmann::json& times = status["publishToSocket"];
    tell("published to last byte written, median", times["medianMs"], "ms", Goal{atMost(4)});
    tell("published to last byte written, 99 %", times["p99Ms"], "ms", Goal{atMost(8)});
}

} // namespace

void measureEncoders(const std::string& scene, const PixelBytes& pixels, double goalMs) {
    fmt::print("=== one frame of {}, {} x {}, one thread\n", scene, kWidth, kHeight);
    const bridge::Pixels frame{pixels, kWidth, kHeight};
    bridge::FrameFacts facts;
    facts.shownWidth = kWidth;
    facts.shownHeight = kHeight;
    bridge::MotionEncoder encoder;
    for (int rung = 0; rung < bridge::kRungCount; ++rung) {
        const bridge::Rung& step = bridge::kRungs[static_cast<std::size_t>(rung)];
        const auto [ms, bytes] = costOf([&] { return encoder.encode(frame, step, facts); });
        const std::string name =
            fmt::format("rung {}: size 1/{}, quality {}", rung, step.divide, step.quality);
        std::optional<Goal> time, mbit;
        if (rung == bridge::kFirstRung) time = Goal{atMost(goalMs)}, mbit = Goal{between(10, 25)};
        if (rung == bridge::kFirstHalfRung) mbit = Goal{between(4, 8)};
        tell(name + ", processor time", ms, "ms", time);
        tell(name + ", at 30 frames/s", 8e-6 * kRate * bytes, "Mbit/s", mbit);
    }
    bridge::StillEncoder still;
    const auto [ms, bytes] = costOf([&] { return still.encode(frame, facts); });
    tell("exact image, processor time", ms, "ms");
    tell("exact image, size", 1e-3 * bytes, "kB");
    double page = 0;
    for (const bridge::PageFile& each : bridge::pageFiles())
        page += static_cast<double>(each.packed.bytes.size());
    tell("size of the page, packed", 1e-3 * page, "kB", Goal{atMost(100)});
}

void measureAtThirty(const PixelBytes& pixels, double seconds) {
    fmt::print("=== a frame of the scene, published 30 times a second\n");
    const IpcInstance instance;
    const InstantServer server(instance.name(), pixels, static_cast<int>(kRate));
    double one = 0, ten = 0;
    {
        const Bridge bridge(instance);
        const Costs costs = costsWith(bridge, server, 1, seconds);
        one = costs.cores;
        tellTimes(bridge.status());
        tell("bridge's processor time for a published frame, 1 viewer", costs.perFrame, "ms",
             Goal{atMost(120 / kRate), atMost(4)});
        tell("bridge's processor time, 1 viewer", 100 * one, "%", Goal{atMost(12)});
        tell("memory of the bridge", memoryMb(bridge.process()), "MB",
             Goal{atMost(30 + 2 * 4e-6 * kWidth * kHeight)});
    }
    {
        const Bridge bridge(instance);
        const Costs costs = costsWith(bridge, server, 10, seconds);
        ten = costs.cores;
        tell("bridge's processor time for a published frame, 10 viewers", costs.perFrame, "ms",
             Goal{atMost(6)});
        tell("each further viewer", 100 * (ten - one) / 9, "%", Goal{atMost(1)});
    }
    const Bridge bridge(instance);
    const Costs costs = costsWith(bridge, server, 64, seconds);
    tell("bridge's processor time, 64 viewers", costs.cores, "cores", Goal{atMost(1.5)});
    tell("frames per second of each of 64 viewers", costs.rate, "1/s",
         Goal{between(0.95 * kRate, 2 * kRate)});
    tell("memory of the bridge, 64 viewers", memoryMb(bridge.process()), "MB");
}

} // namespace bridgebench
