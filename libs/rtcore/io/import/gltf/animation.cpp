#include "rtcore/io/import/gltf/animation.h"

#include "rtcore/io/import/pose/key_frames.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace rtcore::gltf {

namespace {

enum class Interpolation : std::uint8_t { Linear, Step, CubicSpline };

/// A value of a node over time.
struct Channel {
    std::string path; ///< the member of the node
    Interpolation interpolation = Interpolation::Linear;
    std::vector<float> times, values;
    std::size_t width = 1; ///< numbers of a value

    std::size_t valuesOfKey() const { return interpolation == Interpolation::CubicSpline ? 3 : 1; }
};

/// 0 for what is no path of a node.
std::uint32_t channelComponents(std::string_view path) {
    if (path == "translation" || path == "scale") return 3;
    if (path == "rotation") return 4;
    return path == "weights" ? 1 : 0;
}

Interpolation interpolationOf(const Json& sampler) {
    const std::string name = text(sampler, "interpolation");
    if (name == "STEP") return Interpolation::Step;
    return name == "CUBICSPLINE" ? Interpolation::CubicSpline : Interpolation::Linear;
}

bool areTimes(const std::vector<float>& times) {
    if (times.empty()) return false;
    const auto finite = [](float t) { return std::isfinite(t); };
    return std::ranges::all_of(times, finite) && std::ranges::is_sorted(times);
}

/// Nothing where it cannot be read.
std::optional<std::vector<float>> listOf(std::optional<std::size_t> number, std::uint32_t components,
                                         bool normalized, Accessors& accessors) {
    auto accessor = accessors.find(number);
    if (!accessor || accessor->elements.components != components) return std::nullopt;
    accessor->elements.normalized |= normalized;
    std::vector<float> list(accessor->count * components);
    if (!accessors.readFloats(*accessor, components, list)) return std::nullopt;
    return list;
}

/// Empty where there are none that can be used.
std::vector<float> timesOf(const Json& sampler, Accessors& accessors) {
    auto times = listOf(index(sampler, "input"), 1, false, accessors);
    return times && areTimes(*times) ? std::move(*times) : std::vector<float>();
}

/// False where lists cannot be read, or do not agree.
bool readKeys(const Json& sampler, Accessors& accessors, Channel& channel) {
    constexpr std::size_t kMaxTargets = 65'536;
    const std::uint32_t components = channelComponents(channel.path);
    // Whole numbers of these cannot be anything else.
    const bool normalized = channel.path == "rotation" || channel.path == "weights";
    channel.interpolation = interpolationOf(sampler);
    channel.times = timesOf(sampler, accessors);
    auto values = listOf(index(sampler, "output"), components, normalized, accessors);
    if (!values || channel.times.empty()) return false;
    channel.values = std::move(*values);
    const std::size_t keys = channel.times.size() * channel.valuesOfKey();
    channel.width = channel.values.size() / keys;
    if (channel.width == 0 || channel.width * keys != channel.values.size()) return false;
    return channel.path == "weights" ? channel.width <= kMaxTargets : channel.width == components;
}

double valueAt(const Channel& channel, const KeyInterval& at, std::size_t component) {
    const auto value = [&](std::size_t key, std::size_t kind) {
        return double{channel.values[(key * channel.valuesOfKey() + kind) * channel.width + component]};
    };
    if (channel.interpolation == Interpolation::Step) return value(at.from, 0);
    if (channel.interpolation == Interpolation::Linear)
        return value(at.from, 0) + at.part * (value(at.to, 0) - value(at.from, 0));
    constexpr std::size_t kInTangent = 0, kValue = 1, kOutTangent = 2;
    if (at.from == at.to) return value(at.from, kValue);
    return hermite(value(at.from, kValue), value(at.from, kOutTangent), value(at.to, kInTangent),
                   value(at.to, kValue), at.part, at.length);
}

Rotation unitRotation(Rotation q) {
    const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
    if (!(length > 0) || !std::isfinite(length)) return {0, 0, 0, 1};
    for (double& v : q) v /= length;
    return q;
}

Rotation rotationAt(const Channel& channel, const KeyInterval& at) {
    const auto ofKey = [&](std::size_t key) {
        Rotation q{};
        for (std::size_t i = 0; i < 4; ++i) q[i] = double{channel.values[key * 4 + i]};
        return unitRotation(q);
    };
    if (channel.interpolation == Interpolation::Linear) return slerp(ofKey(at.from), ofKey(at.to), at.part);
    Rotation q{};
    for (std::size_t i = 0; i < 4; ++i) q[i] = valueAt(channel, at, i);
    return unitRotation(q);
}

/// False for values that are no numbers.
bool setNode(Json& node, const Channel& channel, double seconds) {
    const KeyInterval at =
        keyInterval(channel.times.size(), seconds, [&](std::size_t i) { return double{channel.times[i]}; });
    std::vector<double> values;
    if (channel.path == "rotation") {
        const Rotation q = rotationAt(channel, at);
        values.assign(q.begin(), q.end());
    } else {
        for (std::size_t i = 0; i < channel.width; ++i) values.push_back(valueAt(channel, at, i));
    }
    if (!std::ranges::all_of(values, [](double v) { return std::isfinite(v); })) return false;
    if (channel.path != "weights") node.erase("matrix");
    node[channel.path] = values;
    return true;
}

} // namespace

std::vector<std::string> animationNames(const Json& root) {
    std::vector<std::string> names;
    for (const Json& animation : member(root, "animations")) names.push_back(text(animation, "name"));
    return names;
}

namespace {

/// The time of the first key of all.
double beginningOf(const Json& animation, Accessors& accessors) {
    float begin = std::numeric_limits<float>::infinity();
    for (const Json& each : member(animation, "channels")) {
        const Json& sampler = element(member(animation, "samplers"), index(each, "sampler"));
        const std::vector<float> times = timesOf(sampler, accessors);
        if (!times.empty()) begin = std::min(begin, times.front());
    }
    return std::isfinite(begin) ? double{begin} : 0;
}

} // namespace

std::size_t animate(Json& root, std::size_t animation, std::optional<double> seconds, Accessors& accessors) {
    const Json& stated = element(member(root, "animations"), animation);
    const std::size_t nodes = sizeOf(member(root, "nodes"));
    const double time = seconds ? *seconds : beginningOf(stated, accessors);
    std::size_t damaged = 0;
    for (const Json& each : member(stated, "channels")) {
        const Json& target = member(each, "target");
        const auto number = index(target, "node");
        Channel channel{text(target, "path"), {}, {}, {}, 1};
        if (!number || channelComponents(channel.path) == 0) continue; // of an extension
        const Json& sampler = element(member(stated, "samplers"), index(each, "sampler"));
        const bool sound = *number < nodes && readKeys(sampler, accessors, channel);
        Json* const node = sound ? &root["nodes"][*number] : nullptr;
        if (node == nullptr || !node->is_object() || !setNode(*node, channel, time)) ++damaged;
    }
    return damaged;
}

} // namespace rtcore::gltf
