#include "bridge/report/watch.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace bridge {

namespace {

std::string driverOf(const RoomFigures& room) {
    const auto driver = std::ranges::find_if(room.sessions, &SessionFigures::drives);
    if (driver == room.sessions.end()) return "no driver";
    return "driver " + (driver->name.empty() ? fmt::format("{}", driver->id) : driver->name);
}

/// "2 of rung 1, 1 of rung 3"
std::string rungsOf(const RoomFigures& room) {
    std::array<int, kRungCount> pages{};
    for (const SessionFigures& each : room.sessions) ++pages[static_cast<std::size_t>(each.link.rung)];
    std::string text;
    for (std::size_t rung = 0; rung < pages.size(); ++rung)
        if (pages[rung] > 0)
            text += fmt::format("{}{} of rung {}", text.empty() ? "" : ", ", pages[rung], rung);
    return text.empty() ? "no rung" : text;
}

double cpuOf(const RoomFigures& room) {
    return room.frames.framesCpu + room.frames.stillsCpu + room.commands.cpuSeconds;
}

} // namespace

std::string Watch::lines(std::span<const RoomFigures> rooms, double ioCpu, double now) {
    const double seconds = lastTime_ == 0 ? 0 : now - lastTime_;
    const auto rate = [&](double more) { return seconds > 0 ? std::max(0.0, more) / seconds : 0; };
    std::string text;
    for (const RoomFigures& room : rooms) {
        // The thread of the sockets serves all instances; it counts where it is looked at first.
        const double shared = &room == rooms.data() ? ioCpu : 0;
        const Counters counters{std::accumulate(room.sent.begin(), room.sent.end(), std::uint64_t(0)),
                                room.bytes, cpuOf(room) + shared};
        const Counters before = std::exchange(last_[room.instance], counters);
        text += fmt::format(
            "{}: server {}, {} page{}, {}, {:.1f} frames/s, {:.2f} Mbit/s, {}, {:.1f} % of a core\n",
            room.instance, room.state, room.sessions.size(), room.sessions.size() == 1 ? "" : "s",
            driverOf(room), rate(static_cast<double>(counters.frames - before.frames)),
            8e-6 * rate(static_cast<double>(counters.bytes - before.bytes)), rungsOf(room),
            100 * rate(counters.cpu - before.cpu));
    }
    lastTime_ = now;
    return text;
}

} // namespace bridge
