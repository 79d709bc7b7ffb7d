#include "cui/status_text.h"

#include "rtcore/settings/number_text.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <cstddef>

namespace cui {

namespace {

using Json = nlohmann::ordered_json;
using rtcore::shortestText;

std::string vectorText(const float (&v)[3]) {
    return fmt::format("{} {} {}", shortestText(v[0]), shortestText(v[1]), shortestText(v[2]));
}

std::string positionText(const std::array<double, 3>& p) {
    return fmt::format("{} {} {}", shortestText(p[0]), shortestText(p[1]), shortestText(p[2]));
}

// The double with the digits of the float: 0.1, not 0.10000000149011612.
double sameDigits(float value) {
    const std::string digits = shortestText(value);
    double result = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), result);
    return result;
}

Json vectorJson(const float (&v)[3]) { return {sameDigits(v[0]), sameDigits(v[1]), sameDigits(v[2])}; }

// In the coordinates of the model's file.
std::array<double, 3> eyeInFile(const ipc::Status& status) {
    std::array<double, 3> eye{};
    for (std::size_t i = 0; i < eye.size(); ++i)
        eye[i] = status.origin[i] == 0 ? sameDigits(status.eye[i]) : double{status.eye[i]} + status.origin[i];
    return eye;
}

// One line; numbers that are not finite become null.
std::string lineOf(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

// `idle` is the word for a frame that needs no more drawing: programs know the flag, people see an image.
const char* state(const ipc::Status& status, const char* idle) {
    if (status.progress < 1) return "loading";
    if (status.paused != 0) return "paused";
    return status.idle != 0 ? idle : "drawing";
}
const char* stateForPeople(const ipc::Status& status) { return state(status, "complete"); }
const char* stateForPrograms(const ipc::Status& status) { return state(status, "idle"); }

const char* mode(const ipc::Status& status) { return status.mode == 0 ? "fly" : "walk"; }

// Where nothing is below.
const char* floorNote(const ipc::Status& status) { return status.mode == 2 ? " (on an unseen floor)" : ""; }

} // namespace

std::string statusText(const std::string& instance, std::int64_t process, const ipc::Status& status) {
    std::string text;
    const auto line = [&](const char* name, const std::string& value) {
        text.append(name).append(": ").append(value).append("\n");
    };
    line("instance", instance);
    line("process", fmt::format("{}", process));
    line("state", stateForPeople(status));
    if (status.recording != 0) line("recording", "yes");
    line("resolution", fmt::format("{} x {}", status.width, status.height));
    line("polygons", fmt::format("{}", status.polygons));
    line("frame time", fmt::format("{:.2f} ms", status.frameSeconds * 1e3));
    if (status.wholeSeconds > 0) line("whole frame", fmt::format("{:.2f} s", status.wholeSeconds));
    line("frames per second", fmt::format("{:.1f}", status.framesPerSecond));
    if (status.kept > 0) line("new pixels", fmt::format("{:.1f} %", 100 * (1 - status.kept)));
    if (status.lightError > 0) line("indirect light", fmt::format("+-{:.1f} %", 100 * status.lightError));
    line("rays per second", fmt::format("{:.2f} million", status.raysPerSecond * 1e-6));
    line("mode", std::string(mode(status)) + floorNote(status));
    line("eye", positionText(eyeInFile(status)));
    line("forward", vectorText(status.forward));
    line("up", vectorText(status.up));
    if (status.parallelWidth > 0) {
        line("width of view", shortestText(status.parallelWidth) + " of the scene, without perspective");
    } else {
        line("field of view", shortestText(status.fieldOfView) + " degrees");
    }
    line("exposure", shortestText(status.exposure));
    return text;
}

std::string statusJson(const std::string& instance, std::int64_t process, const ipc::Status& status) {
    return lineOf({{"instance", instance},
                   {"process", process},
                   {"state", stateForPrograms(status)},
                   {"width", status.width},
                   {"height", status.height},
                   {"polygons", status.polygons},
                   {"frameSeconds", status.frameSeconds},
                   {"wholeSeconds", status.wholeSeconds},
                   {"framesPerSecond", status.framesPerSecond},
                   {"raysPerSecond", status.raysPerSecond},
                   {"kept", sameDigits(status.kept)},
                   {"indirectError", sameDigits(status.lightError)},
                   {"mode", mode(status)},
                   {"eye", eyeInFile(status)},
                   {"forward", vectorJson(status.forward)},
                   {"up", vectorJson(status.up)},
                   {"fieldOfView", sameDigits(status.fieldOfView)},
                   {"orthographicWidth", sameDigits(status.parallelWidth)},
                   {"exposure", sameDigits(status.exposure)},
                   {"progress", sameDigits(status.progress)},
                   {"idle", status.idle != 0},
                   {"paused", status.paused != 0},
                   {"recording", status.recording != 0}});
}

std::string statusLine(const ipc::Status& status) {
    return fmt::format("{:.1f} frames/s  {:.2f} ms  {:.2f} Mrays/s  {} x {}  {}\n", status.framesPerSecond,
                       status.frameSeconds * 1e3, status.raysPerSecond * 1e-6, status.width, status.height,
                       stateForPeople(status));
}

std::string listText(std::span<const ipc::Instance> instances) {
    std::string text;
    for (const ipc::Instance& instance : instances) {
        text += instance.running ? fmt::format("{}  process {}\n", instance.name, instance.process)
                                 : fmt::format("{}  dead; 'CUI free' removes it\n", instance.name);
    }
    return text;
}

std::string listJson(std::span<const ipc::Instance> instances) {
    Json list = Json::array();
    for (const ipc::Instance& instance : instances) {
        list.push_back(
            {{"instance", instance.name}, {"running", instance.running}, {"process", instance.process}});
    }
    return lineOf(list);
}

} // namespace cui
