// The same figures in /metrics, /status and --watch.
#include "bridge/report/metrics.h"
#include "bridge/report/status.h"
#include "bridge/report/watch.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <set>
#include <sstream>

namespace {

using namespace bridge;

RoomFigures roomOf(const std::string& name) {
    RoomFigures room;
    room.instance = name;
    room.state = "there";
    room.hasServer = true;
    room.server.width = 1280;
    room.server.height = 720;
    room.server.frameSeconds = 0.03;
    room.sessions.resize(3);
    room.sessions[0].id = 7;
    room.sessions[0].name = "Anna";
    room.sessions[0].drives = true;
    room.sessions[0].link.rung = 1;
    room.sessions[1].link.rung = room.sessions[2].link.rung = 3;
    room.sent = {0, 40, 0, 2, 0, 0};
    room.bytes = 1'000'000;
    room.skipped = 5;
    for (const double ms : {2.0, 2.2, 2.4, 9.0}) room.frames.encode[1].add(1e-3 * ms);
    room.publishToSocket.add(0.004);
    room.commands.keys.add(0.0002);
    room.commands.epoch = 0xabc;
    room.frames.framesCpu = 1.5;
    return room;
}

/// A sample of the text format: name, labels, value.
struct Sample {
    std::string name;
    std::map<std::string, std::string> labels;
    double value = 0;
};

bool isName(const std::string& text) {
    return !text.empty() && text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == std::string::npos;
}

Sample parseSample(const std::string& line) {
    Sample sample;
    const std::size_t open = line.find('{'), close = line.rfind("} ");
    if (open == std::string::npos || close == std::string::npos) {
        ADD_FAILURE() << line;
        return sample;
    }
    sample.name = line.substr(0, open);
    EXPECT_TRUE(isName(sample.name)) << line;
    std::istringstream labels(line.substr(open + 1, close - open - 1));
    for (std::string label; std::getline(labels, label, ',');) {
        const std::size_t equals = label.find("=\"");
        if (equals == std::string::npos || !label.ends_with('"')) {
            ADD_FAILURE() << line;
            continue;
        }
        EXPECT_TRUE(isName(label.substr(0, equals))) << line;
        sample.labels[label.substr(0, equals)] = label.substr(equals + 2, label.size() - equals - 3);
    }
    std::size_t used = 0;
    sample.value = std::stod(line.substr(close + 2), &used);
    EXPECT_EQ(used, line.size() - close - 2) << line;
    return sample;
}

/// All samples; each line is checked: a family has HELP and TYPE once, before its samples, which stand
/// together.
std::vector<Sample> parseMetrics(const std::string& text) {
    std::vector<Sample> samples;
    std::set<std::string> helped, typed, seen;
    std::string family, type;
    std::istringstream lines(text);
    EXPECT_TRUE(text.ends_with('\n'));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string hash, what, name;
        words >> hash >> what >> name;
        if (hash == "#") {
            EXPECT_TRUE(isName(name)) << line;
            if (what == "HELP") {
                EXPECT_TRUE(helped.insert(name).second) << line;
                continue;
            }
            EXPECT_EQ(what, "TYPE") << line;
            EXPECT_TRUE(typed.insert(name).second && helped.contains(name)) << line;
            family = name;
            words >> type;
            EXPECT_TRUE(type == "counter" || type == "gauge" || type == "histogram") << line;
            EXPECT_EQ(type == "counter", name.ends_with("_total")) << line;
            continue;
        }
        samples.push_back(parseSample(line));
        std::string expected = family;
        if (type == "histogram") {
            for (const char* suffix : {"_bucket", "_sum", "_count"})
                if (samples.back().name.ends_with(suffix)) expected = family + suffix;
        }
        EXPECT_EQ(samples.back().name, expected) << line;
        EXPECT_TRUE(seen.insert(line.substr(0, line.rfind("} "))).second) << "twice: " << line;
    }
    return samples;
}

double valueOf(const std::vector<Sample>& samples, const std::string& name,
               const std::map<std::string, std::string>& labels) {
    for (const Sample& each : samples)
        if (each.name == name && each.labels == labels) return each.value;
    ADD_FAILURE() << "no " << name;
    return -1;
}

TEST(Metrics, AreValidText) {
    const std::vector<RoomFigures> rooms{roomOf("hall"), roomOf("nave")};
    const auto samples = parseMetrics(metricsText(rooms, {{"origin", 3}, {"host", 1}}, 0.25));
    EXPECT_EQ(valueOf(samples, "rtbridge_server_up", {{"instance", "hall"}}), 1);
    EXPECT_EQ(valueOf(samples, "rtbridge_sessions", {{"instance", "nave"}, {"role", "driver"}}), 1);
    EXPECT_EQ(valueOf(samples, "rtbridge_sessions", {{"instance", "nave"}, {"role", "viewer"}}), 2);
    EXPECT_EQ(valueOf(samples, "rtbridge_frames_total", {{"instance", "hall"}, {"rung", "1"}}), 40);
    EXPECT_EQ(valueOf(samples, "rtbridge_skipped_total", {{"instance", "hall"}}), 5);
    EXPECT_EQ(valueOf(samples, "rtbridge_bytes_total", {{"instance", "hall"}}), 1e6);
    EXPECT_EQ(valueOf(samples, "rtbridge_refused_total", {{"reason", "origin"}}), 3);
    EXPECT_EQ(valueOf(samples, "rtbridge_cpu_seconds_total", {{"thread", "io"}}), 0.25);
    EXPECT_EQ(valueOf(samples, "rtbridge_cpu_seconds_total", {{"instance", "nave"}, {"thread", "frames"}}),
              1.5);
    EXPECT_EQ(valueOf(samples, "rtbridge_input_to_ipc_seconds_count", {{"instance", "nave"}}), 1);
    EXPECT_EQ(valueOf(samples, "rtbridge_publish_to_socket_seconds_count", {{"instance", "nave"}}), 1);
}

TEST(Metrics, HaveWholeHistograms) {
    const std::vector<RoomFigures> rooms{roomOf("hall")};
    const auto samples = parseMetrics(metricsText(rooms, {}, 0));
    const std::map<std::string, std::string> one{{"instance", "hall"}, {"rung", "1"}};
    EXPECT_NEAR(valueOf(samples, "rtbridge_encode_seconds_sum", one), 0.0156, 1e-9);
    double last = -1, before = 0, end = 0;
    for (const Sample& each : samples) {
        if (each.name != "rtbridge_encode_seconds_bucket" || each.labels.at("rung") != "1") continue;
        const std::string& le = each.labels.at("le");
        const double bound = le == "+Inf" ? 1e300 : std::stod(le);
        EXPECT_GT(bound, last) << le;
        EXPECT_GE(each.value, before) << "cumulative: " << le;
        last = bound;
        end = before = each.value;
    }
    EXPECT_EQ(last, 1e300) << "the last bucket is +Inf";
    EXPECT_EQ(end, 4);
    EXPECT_EQ(valueOf(samples, "rtbridge_encode_seconds_count", one), 4);
    auto bucket = one;
    bucket["le"] = "0.0025";
    EXPECT_EQ(valueOf(samples, "rtbridge_encode_seconds_bucket", bucket), 3);
}

TEST(Status, TellsOfServerEncodersAndSessions) {
    const nlohmann::json status = statusOf(roomOf("hall"));
    EXPECT_EQ(status["name"], "hall");
    EXPECT_EQ(status["epoch"], "abc");
    EXPECT_EQ(status["width"], 1280);
    EXPECT_EQ(status["idle"], false);
    EXPECT_DOUBLE_EQ(status["frameMs"], 30);
    ASSERT_EQ(status["encode"].size(), kRungs.size());
    EXPECT_EQ(status["encode"][1]["count"], 4);
    EXPECT_NEAR(status["encode"][1]["medianMs"].get<double>(), 2.3, 0.3);
    EXPECT_GT(status["encode"][1]["p95Ms"].get<double>(), 8);
    ASSERT_EQ(status["sessions"].size(), 3U);
    EXPECT_EQ(status["sessions"][0]["role"], "driver");
    EXPECT_EQ(status["sessions"][1]["role"], "viewer");
    for (const char* key : {"id", "name", "role", "rung", "window", "rttMs", "baseMs", "queueMs", "decodeMs",
                            "mbit", "sent", "skipped", "seconds"})
        EXPECT_TRUE(status["sessions"][0].contains(key)) << key;
}

TEST(Watch, TellsRatesSinceTheLastLine) {
    Watch watch;
    std::vector<RoomFigures> rooms{roomOf("hall"), roomOf("nave")};
    const std::string first = watch.lines(rooms, 0.5, 100);
    EXPECT_NE(first.find("hall: server there, 3 pages, driver Anna, 0.0 frames/s, 0.00 Mbit/s, 1 of rung 1, "
                         "2 of rung 3, 0.0 % of a core\n"),
              std::string::npos)
        << first;
    rooms[0].sent[1] += 60;
    rooms[0].bytes += 500'000;
    rooms[0].frames.framesCpu += 0.2;
    const std::string second = watch.lines(rooms, 0.6, 102);
    EXPECT_NE(second.find("30.0 frames/s, 2.00 Mbit/s"), std::string::npos) << second;
    EXPECT_NE(second.find("15.0 % of a core\nnave: "), std::string::npos) << second;
    EXPECT_NE(second.find("0.0 frames/s"), std::string::npos) << second;
}

TEST(Watch, TellsWhereThereIsNobody) {
    Watch watch;
    RoomFigures room;
    room.instance = "hall";
    room.state = "gone";
    EXPECT_EQ(watch.lines(std::span(&room, 1), 0, 1),
              "hall: server gone, 0 pages, no driver, 0.0 frames/s, 0.00 Mbit/s, no rung, 0.0 % of a core\n");
}

} // namespace
