#include "common/commands/pack_words.h"

#include "rtcore/platform/sentence.h"
#include "rtcore/settings/nearest_name.h"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <system_error>

namespace app {

namespace {

constexpr std::string_view kOn = "on ", kOff = "off";

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

rtcore::Sentence packRefusal(std::span<const std::filesystem::path> outside) {
    std::string names;
    for (const std::filesystem::path& file : outside) {
        names += (names.empty() ? "" : ", ") + rtcore::inQuotes(file.string());
        std::error_code none;
        const std::filesystem::path end = std::filesystem::weakly_canonical(file, none);
        if (!none && end != file) names += ", a link to " + rtcore::inQuotes(end.string());
    }
    return rtcore::say(kPackRefusal, names);
}

} // namespace app
