// How much slower a renderer that keeps all cores busy gets by viewers. In alternating rounds, so that what
// else the machine does meets all of them; the spread shows how much that is.
#include "bench/bridge/bench_parts.h"
#include "bench/bridge/goals.h"

#include "ipc/endpoint/viewer.h"
#include "support/quantile.h"

#include <array>

namespace bridgebench {

namespace {

/// One round.
struct Round {
    double frame = 0;           ///< seconds of one frame of the renderer
    double bridge = 0, own = 0; ///< cores that the bridge and the viewers used
};

Round measureRound(const Bridge& bridge, const std::string& instance, int count, double seconds) {
    const Viewers viewers = startViewers(bridge.port(), count);
    sleepFor(1.5);
    ipc::Viewer look(instance);
    ipc::Frame frame;
    look.waitForFrame(frame, 5s);
    const auto firstNs = frame.info.nanoseconds;
    const std::uint64_t first = frame.info.number;
    const double cpu = bridge.cpu(), own = ownSeconds();
    const auto start = Clock::now();
    sleepFor(seconds);
    const double time = secondsFrom(start);
    Round round;
    round.bridge = (bridge.cpu() - cpu) / time;
    round.own = (ownSeconds() - own) / time;
    look.readFrame(frame);
    const auto frames = static_cast<double>(std::max<std::uint64_t>(1, frame.info.number - first));
    round.frame = 1e-9 * static_cast<double>(frame.info.nanoseconds - firstNs) / frames;
    return round;
}

/// Seconds that a frame would take if the viewers ran on another machine.
double withoutViewers(const Round& round, double cores) { return round.frame * (cores - round.own) / cores; }

double medianOf(const std::vector<Round>& rounds, auto&& value) {
    std::vector<double> values;
    for (const Round& each : rounds) values.push_back(value(each));
    return quantile(values, 0.5);
}

void tellGrowth(const std::vector<Round>& alone, const std::vector<Round>& with, int count) {
    const double cores = std::max(1U, std::thread::hardware_concurrency());
    const double before = medianOf(alone, [](const Round& each) { return each.frame; });
    const double after = medianOf(with, [&](const Round& each) { return withoutViewers(each, cores); });
    const double bridge = medianOf(with, [](const Round& each) { return each.bridge; });
    constexpr double kGoal = 5, kSlack = 3; // per cent
    tell(fmt::format("growth of the renderer's frame time, {} viewer(s), theirs out", count),
         100 * (after / before - 1), "%", Goal{atMost(kGoal), atMost(100 * bridge / cores + kSlack)});
    tell(fmt::format("bridge's processor time for a published frame, {} viewer(s)", count),
         kMs * medianOf(with, [](const Round& each) { return each.bridge * each.frame; }), "ms",
         count == 1    ? std::optional(Goal{atMost(4)})
         : count == 10 ? std::optional(Goal{atMost(6)})
                       : std::nullopt);
}

void tellSpread(const std::vector<Round>& rounds, int count) {
    std::vector<double> frames;
    for (const Round& each : rounds) frames.push_back(kMs * each.frame);
    fmt::print(
        "--- {} viewer(s): a frame lasts {:.2f} ms, from {:.2f} to {:.2f} by round; bridge {:.2f} cores, "
        "viewers {:.2f}\n",
        count, quantile(frames, 0.5), quantile(frames, 0), quantile(frames, 1),
        medianOf(rounds, [](const Round& each) { return each.bridge; }),
        medianOf(rounds, [](const Round& each) { return each.own; }));
}

} // namespace

void measureRenderer(const IpcInstance& instance, double seconds, int rounds) {
    fmt::print("=== the renderer, drawing without end, {} rounds of {:.0f} s each\n", rounds, seconds);
    const Bridge bridge(instance);
    constexpr std::array kCounts{0, 1, 10};
    std::array<std::vector<Round>, kCounts.size()> all;
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < kCounts.size(); ++i)
            all[i].push_back(measureRound(bridge, instance.name(), kCounts[i], seconds));
    for (std::size_t i = 0; i < kCounts.size(); ++i) tellSpread(all[i], kCounts[i]);
    for (std::size_t i = 1; i < kCounts.size(); ++i) tellGrowth(all[0], all[i], kCounts[i]);
}

} // namespace bridgebench
