#include "bridge/report/status.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace bridge {

namespace {

using nlohmann::json;

constexpr double kMs = 1000, kMbit = 1e-6;

json timesOf(const Histogram& histogram) {
    return {{"count", histogram.count()},
            {"medianMs", histogram.quantile(0.5) * kMs},
            {"p95Ms", histogram.quantile(0.95) * kMs},
            {"p99Ms", histogram.quantile(0.99) * kMs}};
}

json encodersOf(const FrameFigures& frames) {
    json rungs = json::array();
    for (std::size_t rung = 0; rung < kRungs.size(); ++rung) {
        json row = timesOf(frames.encode[rung]);
        row["rung"] = rung;
        rungs.push_back(std::move(row));
    }
    return rungs;
}

json sessionOf(const SessionFigures& session) {
    const LinkReport& link = session.link;
    return {{"id", session.id},
            {"name", session.name},
            {"role", session.drives ? "driver" : "viewer"},
            {"rung", link.rung},
            {"window", link.window},
            {"rttMs", link.rtt * kMs},
            {"baseMs", link.base * kMs},
            {"queueMs", link.queue * kMs},
            {"decodeMs", link.decode * kMs},
            {"mbit", session.bitsPerSecond * kMbit},
            {"sent", session.sent},
            {"skipped", session.skipped},
            {"seconds", session.seconds}};
}

} // namespace

json statusOf(const RoomFigures& room) {
    json sessions = json::array();
    for (const SessionFigures& each : room.sessions) sessions.push_back(sessionOf(each));
    return {{"name", room.instance},
            {"state", room.state},
            {"epoch", fmt::format("{:x}", room.commands.epoch)},
            {"fps", room.server.framesPerSecond},
            {"frameMs", room.server.frameSeconds * kMs},
            {"width", room.server.width},
            {"height", room.server.height},
            {"idle", room.server.idle != 0},
            {"published", room.frames.published},
            {"cpuSeconds",
             {{"frames", room.frames.framesCpu},
              {"stills", room.frames.stillsCpu},
              {"commands", room.commands.cpuSeconds}}},
            {"encode", encodersOf(room.frames)},
            {"still", timesOf(room.frames.still)},
            {"publishToSocket", timesOf(room.publishToSocket)},
            {"inputToIpc", timesOf(room.commands.keys)},
            {"sessions", sessions}};
}

} // namespace bridge
