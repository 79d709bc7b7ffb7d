#include "bridge/report/metrics.h"

#include <fmt/core.h>

namespace bridge {

namespace {

struct Metric {
    const char* name;
    const char* type;
    const char* help;
    double (*of)(const Room&);
};

constexpr Metric kMetrics[] = {
    {"rtbridge_server_up", "gauge", "1 while the server answers",
     [](const Room& room) { return room.hasServer() ? 1.0 : 0.0; }},
    {"rtbridge_sessions", "gauge", "pages that are open",
     [](const Room& room) { return double(room.sessions()); }},
    {"rtbridge_frames_total", "counter", "frames that were sent",
     [](const Room& room) { return double(room.framesSent()); }},
    {"rtbridge_skipped_total", "counter",
     "frames that a viewer was not sent, since it had not drawn those before",
     [](const Room& room) { return double(room.framesSkipped()); }},
    {"rtbridge_bytes_total", "counter", "bytes of frames that were sent",
     [](const Room& room) { return double(room.bytesSent()); }},
    {"rtbridge_encoded_total", "counter", "frames that were encoded",
     [](const Room& room) { return double(room.frameFigures().encoded); }},
    {"rtbridge_encode_seconds_total", "counter", "time that took",
     [](const Room& room) { return room.frameFigures().encodeSeconds; }},
    {"rtbridge_stills_total", "counter", "resting images that were encoded",
     [](const Room& room) { return double(room.frameFigures().stills); }},
    {"rtbridge_still_seconds_total", "counter", "time that took",
     [](const Room& room) { return room.frameFigures().stillSeconds; }},
    {"rtbridge_cpu_seconds_total", "counter", "processor time of the threads that serve the instance",
     [](const Room& room) { return room.frameFigures().cpuSeconds + room.commandCpu(); }},
};

} // namespace

std::string metricsText(std::span<const Room* const> rooms,
                        const std::map<std::string, std::uint64_t>& refused) {
    std::string text;
    for (const Metric& metric : kMetrics) {
        text += fmt::format("# HELP {0} {1}\n# TYPE {0} {2}\n", metric.name, metric.help, metric.type);
        for (const Room* const room : rooms)
            text +=
                fmt::format("{}{{instance=\"{}\"}} {}\n", metric.name, room->instance(), metric.of(*room));
    }
    text += "# HELP rtbridge_refused_total connections that were refused\n# TYPE rtbridge_refused_total "
            "counter\n";
    for (const auto& [reason, count] : refused)
        text += fmt::format("rtbridge_refused_total{{reason=\"{}\"}} {}\n", reason, count);
    return text;
}

} // namespace bridge
