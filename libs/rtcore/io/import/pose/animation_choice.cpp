#include "rtcore/io/import/pose/animation_choice.h"

#include "rtcore/io/import/import_forms.h"
#include "rtcore/platform/error.h"
#include "rtcore/settings/plain_text.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace rtcore {

namespace {

std::string listOf(std::span<const std::string> names) {
    constexpr std::size_t kMaxListed = 50;
    std::string list;
    for (std::size_t i = 0; i < names.size() && i < kMaxListed; ++i) {
        if (i > 0) list += ", ";
        list += std::to_string(i + 1) + (names[i].empty() ? "" : " " + inQuotes(names[i]));
    }
    return names.size() > kMaxListed ? list + ", ..." : list;
}

std::optional<std::size_t> numberIn(const std::string& text, std::size_t count) {
    std::size_t number = 0;
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, number);
    if (error != std::errc() || end != last || number < 1 || number > count) return std::nullopt;
    return number - 1;
}

} // namespace

std::optional<std::size_t> animationOf(const PoseChoice& pose, std::span<const std::string> names,
                                       ImportReport& report) {
    if (pose.kind == PoseChoice::Kind::Rest) return std::nullopt;
    if (pose.kind == PoseChoice::Kind::First) {
        if (names.empty()) addWarning(report, import_forms::kNoAnimation);
        return names.empty() ? std::nullopt : std::optional<std::size_t>(0);
    }
    const auto named = std::ranges::find(names, pose.animation);
    if (named != names.end()) return static_cast<std::size_t>(named - names.begin());
    if (const auto number = numberIn(pose.animation, names.size())) return number;
    if (names.empty())
        throw FileError(
            FailureKind::BadData, "",
            say("it has no animation {0}, nor any other; leave the pose out", inQuotes(pose.animation)));
    throw FileError(
        FailureKind::BadData, "",
        say("it has no animation {0}; name one of these: {1}", inQuotes(pose.animation), listOf(names)));
}

} // namespace rtcore
