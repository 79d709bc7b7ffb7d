#include "common/commands/pack_words.h"

#include "rtcore/settings/nearest_name.h"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <system_error>

namespace app {

namespace {

constexpr std::string_view kOn = "on ", kOff = "off";
constexpr std::string_view kBefore = "the scene names files outside of its folder: ";
constexpr std::string_view kBehind = "; 'pack FOLDER outside' takes them along";

} // namespace

std::string packProgressText(std::optional<double> fraction) {
    return fraction ? fmt::format("{}{:.0f} %", kOn, std::floor(100 * *fraction)) : std::string(kOff);
}

std::optional<double> packedFraction(std::string_view answer) {
    int percent = 0;
    if (!answer.starts_with(kOn)) return std::nullopt;
    const auto read = std::from_chars(answer.data() + kOn.size(), answer.data() + answer.size(), percent);
    return read.ec == std::errc() ? std::optional(percent / 100.0) : std::nullopt;
}

std::string packRefusal(std::span<const std::filesystem::path> outside) {
    std::string names;
    for (const std::filesystem::path& file : outside) {
        names += (names.empty() ? "" : ", ") + rtcore::inQuotes(file.string());
        std::error_code none;
        const std::filesystem::path end = std::filesystem::weakly_canonical(file, none);
        if (!none && end != file) names += ", a link to " + rtcore::inQuotes(end.string());
    }
    return std::string(kBefore).append(names).append(kBehind);
}

std::optional<std::string> refusedFiles(std::string_view message) {
    const std::size_t before = message.find(kBefore), behind = message.rfind(kBehind);
    if (before == std::string_view::npos || behind == std::string_view::npos) return std::nullopt;
    const std::size_t first = before + kBefore.size();
    if (behind < first) return std::nullopt;
    return std::string(message.substr(first, behind - first));
}

} // namespace app
