#include "rtcore/look/fill_lights.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

namespace rtcore {

namespace {

constexpr std::array<std::string_view, 4> kWords{"fill", "filllight", "bounce", "bounced"};
constexpr std::string_view kOfStudio = "fill"; ///< the name of one of LightingPreset::Studio

/// Whether one of the words stands alone in the name, in whatever case.
bool saysSo(std::string_view name) {
    std::string word;
    const auto isOne = [&] { return std::ranges::find(kWords, word) != kWords.end(); };
    for (const char c : name) {
        const auto letter = static_cast<unsigned char>(c);
        if (std::isalpha(letter) != 0) {
            word.push_back(static_cast<char>(std::tolower(letter)));
            continue;
        }
        if (isOne()) return true;
        word.clear();
    }
    return isOne();
}

} // namespace

std::vector<const SceneLight*> fillLights(const Scene& scene) {
    std::vector<const SceneLight*> found;
    for (const SceneLight& each : scene.lights)
        if (each.light.on != 0 && !each.ofSky && each.name != kOfStudio && saysSo(each.name))
            found.push_back(&each);
    return found;
}

} // namespace rtcore
