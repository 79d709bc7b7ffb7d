#include "bridge/report/metrics.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <iterator>

namespace bridge {

namespace {

/// Rows of one metric; each gets the labels that it stands for.
class Rows {
  public:
    Rows(std::string& out, const char* name) : out_(out), name_(name) {}
    template <typename Number>
    void add(const std::string& labels, Number value, const char* suffix = "") {
        fmt::format_to(std::back_inserter(out_), "{}{}{{{}}} {}\n", name_, suffix, labels, value);
    }
    void add(const std::string& labels, const Histogram& histogram) {
        for (std::size_t i = 0; i < Histogram::kBounds.size(); ++i)
            add(fmt::format("{},le=\"{}\"", labels, Histogram::kBounds[i]), histogram.upTo(i), "_bucket");
        add(labels + ",le=\"+Inf\"", histogram.count(), "_bucket");
        add(labels, histogram.sum(), "_sum");
        add(labels, histogram.count(), "_count");
    }

  private:
    std::string& out_;
    const char* name_;
};

std::string instanceOf(const RoomFigures& room) { return fmt::format("instance=\"{}\"", room.instance); }

std::string with(const RoomFigures& room, const char* label, const auto& value) {
    return fmt::format("{},{}=\"{}\"", instanceOf(room), label, value);
}

struct Metric {
    const char* name;
    const char* type;
    const char* help;
    void (*rows)(const RoomFigures&, Rows&);
};

constexpr Metric kMetrics[] = {
    {"rtbridge_server_up", "gauge", "1 while the server answers",
     [](const RoomFigures& room, Rows& rows) { rows.add(instanceOf(room), room.hasServer ? 1 : 0); }},
    {"rtbridge_sessions", "gauge", "pages that are open",
     [](const RoomFigures& room, Rows& rows) {
         const auto drivers = std::ranges::count_if(room.sessions, &SessionFigures::drives);
         rows.add(with(room, "role", "driver"), drivers);
         rows.add(with(room, "role", "viewer"), std::ssize(room.sessions) - drivers);
     }},
    {"rtbridge_published_total", "counter", "frames of the server that were taken",
     [](const RoomFigures& room, Rows& rows) { rows.add(instanceOf(room), room.frames.published); }},
    {"rtbridge_frames_total", "counter", "moving frames that were sent, by rung",
     [](const RoomFigures& room, Rows& rows) {
         for (std::size_t rung = 0; rung < room.sent.size(); ++rung)
             rows.add(with(room, "rung", rung), room.sent[rung]);
     }},
    {"rtbridge_parts_total", "counter", "parts of resting images that were sent",
     [](const RoomFigures& room, Rows& rows) { rows.add(instanceOf(room), room.parts); }},
    {"rtbridge_skipped_total", "counter",
     "frames that a viewer was not sent, since it had not drawn those before",
     [](const RoomFigures& room, Rows& rows) { rows.add(instanceOf(room), room.skipped); }},
    {"rtbridge_bytes_total", "counter", "bytes of frames that were sent",
     [](const RoomFigures& room, Rows& rows) { rows.add(instanceOf(room), room.bytes); }},
    {"rtbridge_encode_seconds", "histogram", "time to encode a moving frame, by rung",
     [](const RoomFigures& room, Rows& rows) {
         for (std::size_t rung = 0; rung < room.frames.encode.size(); ++rung)
             rows.add(with(room, "rung", rung), room.frames.encode[rung]);
     }},
    {"rtbridge_still_seconds", "histogram", "time to encode a resting image",
     [](const RoomFigures& room, Rows& rows) { rows.add(instanceOf(room), room.frames.still); }},
    {"rtbridge_publish_to_socket_seconds", "histogram",
     "from the publication of a frame to its last byte at the socket, where no acknowledgement was waited "
     "for",
     [](const RoomFigures& room, Rows& rows) { rows.add(instanceOf(room), room.publishToSocket); }},
    {"rtbridge_input_to_ipc_seconds", "histogram", "from a message with keys to the server's key bits",
     [](const RoomFigures& room, Rows& rows) { rows.add(instanceOf(room), room.commands.keys); }},
};

void addHead(std::string& text, const char* name, const char* type, const char* help) {
    fmt::format_to(std::back_inserter(text), "# HELP {0} {1}\n# TYPE {0} {2}\n", name, help, type);
}

/// Adds the processor time of all threads, including the one that serves all instances.
void addProcessorTime(std::string& text, std::span<const RoomFigures> rooms, double ioCpu) {
    constexpr const char* kName = "rtbridge_cpu_seconds_total";
    addHead(text, kName, "counter", "processor time, by thread");
    Rows rows(text, kName);
    rows.add("thread=\"io\"", ioCpu);
    for (const RoomFigures& room : rooms) {
        rows.add(with(room, "thread", "frames"), room.frames.framesCpu);
        rows.add(with(room, "thread", "stills"), room.frames.stillsCpu);
        rows.add(with(room, "thread", "commands"), room.commands.cpuSeconds);
    }
}

} // namespace

std::string metricsText(std::span<const RoomFigures> rooms,
                        const std::map<std::string, std::uint64_t>& refused, double ioCpu) {
    std::string text;
    for (const Metric& metric : kMetrics) {
        addHead(text, metric.name, metric.type, metric.help);
        Rows rows(text, metric.name);
        for (const RoomFigures& room : rooms) metric.rows(room, rows);
    }
    addProcessorTime(text, rooms, ioCpu);
    constexpr const char* kRefused = "rtbridge_refused_total";
    addHead(text, kRefused, "counter", "connections that were refused, by reason");
    Rows rows(text, kRefused);
    for (const auto& [reason, count] : refused) rows.add(fmt::format("reason=\"{}\"", reason), count);
    return text;
}

} // namespace bridge
