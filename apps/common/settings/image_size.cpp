#include "common/settings/image_size.h"

#include "common/cli/command_line.h"

#include "rtcore/io/drawings/sheet.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {

namespace {

constexpr int kMaxSide = 1'000'000;

std::string lower(std::string_view text) {
    std::string lowered(text);
    for (char& c : lowered)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lowered;
}

std::optional<int> wholeWithin(std::string_view text, int max) {
    const auto number = parseInteger(text);
    if (!number || *number < 1 || *number > max) return std::nullopt;
    return static_cast<int>(*number);
}

int pixelsOf(double millimetres, int dpi) {
    constexpr double kInch = 25.4; // mm
    return std::max(1, static_cast<int>(std::lround(millimetres / kInch * dpi)));
}

/// "a4", "a4-upright"
std::optional<ImageSize> paperOf(std::string_view name, int dpi) {
    constexpr std::string_view kUpright = "-upright";
    const bool upright = name.ends_with(kUpright);
    if (upright) name.remove_suffix(kUpright.size());
    for (const rtcore::PaperSize& paper : rtcore::kPaperSizes) {
        if (lower(paper.name) != name) continue;
        ImageSize size{pixelsOf(paper.width, dpi), pixelsOf(paper.height, dpi)};
        if (upright) std::swap(size.width, size.height);
        return size;
    }
    return std::nullopt;
}

} // namespace

std::optional<ImageSize> imageSizeOf(std::string_view text) {
    const std::string word = lower(text);
    for (const NamedSize& screen : kScreenSizes)
        if (word == screen.name) return screen.size;
    const std::string_view whole = word;
    if (const std::size_t by = whole.find('x'); by != std::string_view::npos) {
        const auto width = wholeWithin(whole.substr(0, by), kMaxSide);
        const auto height = wholeWithin(whole.substr(by + 1), kMaxSide);
        if (!width || !height) return std::nullopt;
        return ImageSize{*width, *height};
    }
    const std::size_t at = std::min(whole.find('@'), whole.size());
    const auto dpi = at == whole.size() ? kUsualDpi : wholeWithin(whole.substr(at + 1), kMaxDpi);
    return dpi ? paperOf(whole.substr(0, at), *dpi) : std::nullopt;
}

std::string imageSizeNames() {
    std::string names;
    for (const NamedSize& screen : kScreenSizes) names += std::string(screen.name) + ", ";
    for (const rtcore::PaperSize& paper : rtcore::kPaperSizes) names += lower(paper.name) + ", ";
    return names + "a4-upright@150 or 1200x800";
}

} // namespace app
