#include "cui/status_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace cui {

namespace {

// The fewest digits that keep every bit, whatever the locale. JSON has no infinity.
template <typename Number>
std::string exact(Number value) {
    std::array<char, 32> digits{};
    if constexpr (std::is_floating_point_v<Number>) {
        if (!std::isfinite(value)) return "null";
    }
    return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

std::string fixed(double value, int decimals) {
    std::array<char, 64> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals);
    return end.ec == std::errc() ? std::string(text.data(), end.ptr) : "?";
}

std::string vector(const float (&v)[3], const char* between) {
    return exact(v[0]) + between + exact(v[1]) + between + exact(v[2]);
}

const char* state(const ipc::Status& status) {
    if (status.progress < 1) return "loading";
    if (status.paused != 0) return "paused";
    return status.idle != 0 ? "idle" : "drawing";
}

const char* mode(const ipc::Status& status) { return status.mode == 0 ? "fly" : "walk"; }

// Where nothing is below.
const char* floorNote(const ipc::Status& status) { return status.mode == 2 ? " (on an unseen floor)" : ""; }

const char* truth(std::uint32_t value) { return value != 0 ? "true" : "false"; }

} // namespace

std::string statusText(const std::string& instance, std::int64_t process, const ipc::Status& status) {
    std::string text;
    const auto line = [&](const char* name, const std::string& value) {
        text.append(name).append(": ").append(value).append("\n");
    };
    line("instance", instance);
    line("process", exact(process));
    line("state", state(status));
    if (status.recording != 0) line("recording", "yes");
    line("resolution", exact(status.width) + " x " + exact(status.height));
    line("polygons", exact(status.polygons));
    line("frame time", fixed(status.frameSeconds * 1e3, 2) + " ms");
    line("frames per second", fixed(status.framesPerSecond, 1));
    line("rays per second", fixed(status.raysPerSecond * 1e-6, 2) + " million");
    line("mode", std::string(mode(status)) + floorNote(status));
    line("eye", vector(status.eye, " "));
    line("forward", vector(status.forward, " "));
    line("up", vector(status.up, " "));
    line("field of view", exact(status.fieldOfView) + " degrees");
    line("exposure", exact(status.exposure));
    return text;
}

std::string statusJson(const std::string& instance, std::int64_t process, const ipc::Status& status) {
    std::string text = "{\"instance\":\"" + instance + "\""; // letters, digits, '_' and '-' only
    const auto add = [&](const char* name, const std::string& value) {
        text.append(",\"").append(name).append("\":").append(value);
    };
    add("process", exact(process));
    add("state", "\"" + std::string(state(status)) + "\"");
    add("width", exact(status.width));
    add("height", exact(status.height));
    add("polygons", exact(status.polygons));
    add("frameSeconds", exact(status.frameSeconds));
    add("framesPerSecond", exact(status.framesPerSecond));
    add("raysPerSecond", exact(status.raysPerSecond));
    add("mode", "\"" + std::string(mode(status)) + "\"");
    add("eye", "[" + vector(status.eye, ",") + "]");
    add("forward", "[" + vector(status.forward, ",") + "]");
    add("up", "[" + vector(status.up, ",") + "]");
    add("fieldOfView", exact(status.fieldOfView));
    add("exposure", exact(status.exposure));
    add("progress", exact(status.progress));
    add("idle", truth(status.idle));
    add("paused", truth(status.paused));
    add("recording", truth(status.recording));
    return text + "}\n";
}

std::string statusLine(const ipc::Status& status) {
    return fixed(status.framesPerSecond, 1) + " frames/s  " + fixed(status.frameSeconds * 1e3, 2) + " ms  " +
           fixed(status.raysPerSecond * 1e-6, 2) + " Mrays/s  " + exact(status.width) + " x " +
           exact(status.height) + "  " + state(status) + "\n";
}

std::string listText(std::span<const ipc::Instance> instances) {
    std::string text;
    for (const ipc::Instance& instance : instances) {
        text += instance.name;
        text += instance.running ? "  process " + exact(instance.process) : "  dead; 'CUI free' removes it";
        text += "\n";
    }
    return text;
}

std::string listJson(std::span<const ipc::Instance> instances) {
    std::string text = "[";
    for (const ipc::Instance& instance : instances) {
        text += text.size() > 1 ? "," : "";
        text += "{\"instance\":\"" + instance.name + "\",\"running\":" + truth(instance.running ? 1 : 0) +
                ",\"process\":" + exact(instance.process) + "}";
    }
    return text + "]\n";
}

} // namespace cui
