#include "rtcore/io/import/assimp/md5_frame_rate.h"

#include "rtcore/platform/files.h"

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <system_error>

namespace rtcore {

std::optional<double> md5FrameRate(const std::filesystem::path& mesh) {
    constexpr std::string_view kWord = "frameRate";
    std::filesystem::path path = mesh;
    path.replace_extension(".md5anim");
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
    const std::string text = readTextFile(path);
    std::size_t at = text.find(kWord);
    if (at == std::string::npos) return std::nullopt;
    at = text.find_first_not_of(" \t", at + kWord.size());
    if (at == std::string::npos) return std::nullopt;
    double rate = 0;
    std::from_chars(text.data() + at, text.data() + text.size(), rate);
    return rate > 0 && std::isfinite(rate) ? std::optional(rate) : std::nullopt;
}

} // namespace rtcore
