#include "rtcore/plans/file_metres.h"

#include <array>
#include <charconv>

namespace rtcore {

namespace {

/// Of the scene's zero in the file, in scene units.
double heightOfZero(const Scene& scene) {
    const FilePoint& at = scene.origin.at;
    return at[0] * scene.up.x + at[1] * scene.up.y + at[2] * scene.up.z;
}

} // namespace

double exactMetresPerUnit(const Scene& scene) {
    std::array<char, 32> text{};
    const char* const end = std::to_chars(text.data(), text.data() + text.size(), scene.metresPerUnit).ptr;
    double value = scene.metresPerUnit;
    std::from_chars(text.data(), end, value);
    return value;
}

double heightInFile(const Scene& scene, double height) {
    return (height + heightOfZero(scene)) * exactMetresPerUnit(scene);
}

double heightInScene(const Scene& scene, double metres) {
    return metres / exactMetresPerUnit(scene) - heightOfZero(scene);
}

} // namespace rtcore
