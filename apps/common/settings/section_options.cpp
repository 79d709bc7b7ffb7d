#include "common/settings/section_options.h"

#include "rtcore/settings/plain_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

namespace app {

namespace {

constexpr std::size_t kPlanesOfBox = 6;

using SixNumbers = std::array<double, 6>;

/// Parted by commas.
std::optional<SixNumbers> sixNumbersIn(const std::string& text) {
    SixNumbers numbers{};
    std::size_t begin = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const bool last = i + 1 == numbers.size();
        const std::size_t comma = text.find(',', begin);
        if ((comma == std::string::npos) != last) return std::nullopt;
        const auto number = parseNumber(std::string_view(text).substr(begin, comma - begin));
        if (!number) return std::nullopt;
        numbers[i] = *number;
        begin = comma + 1;
    }
    return numbers;
}

SectionChoice::Plane planeOf(const SixNumbers& n) {
    return {{n[0], n[1], n[2]},
            {static_cast<float>(n[3]), static_cast<float>(n[4]), static_cast<float>(n[5])}};
}

void refuseUseless(const SectionChoice::Plane& plane, const char* option) {
    const rtcore::SectionPlane there{rtcore::LocalOrigin{}.local(plane.point), plane.normal};
    if (const auto problem = problemOf(there))
        throw UsageError(rtcore::say("option '{0}': {1}", option, *problem));
}

SectionChoice::Box boxOf(const SixNumbers& n) {
    SectionChoice::Box box;
    for (std::size_t a = 0; a < 3; ++a) {
        box.lo[a] = std::min(n[a], n[a + 3]);
        box.hi[a] = std::max(n[a], n[a + 3]);
        if (!(box.lo[a] < box.hi[a]))
            throw UsageError("option '--section-box': its corners must differ in each coordinate");
    }
    for (const rtcore::FilePoint& corner : {box.lo, box.hi})
        refuseUseless({corner, {1, 0, 0}}, "--section-box");
    return box;
}

} // namespace

SectionChoice readSections(const Arguments& arguments) {
    SectionChoice choice;
    for (const Occurrence& given : arguments.options()) {
        const bool box = given.name == "section-box";
        if (!box && given.name != "section") continue;
        const auto numbers = sixNumbersIn(given.value);
        if (!numbers)
            throw UsageError(fmt::format("option '--{}': {} is not six numbers, parted by commas", given.name,
                                         rtcore::inQuotes(given.value)));
        if (box) {
            choice.box = boxOf(*numbers);
            continue;
        }
        choice.planes.push_back(planeOf(*numbers));
        refuseUseless(choice.planes.back(), "--section");
    }
    if (choice.planes.size() + (choice.box ? kPlanesOfBox : 0) > rtcore::kMaxSectionPlanes)
        throw UsageError("more than six sections are given; a box has six");
    if (const auto light = arguments.text("section-light")) choice.light = rtcore::sectionLightNamed(*light);
    if (const auto caps = arguments.text("section-caps")) choice.caps = rtcore::capColoursNamed(*caps);
    return choice;
}

void cutOpen(const SectionChoice& choice, rtcore::Scene& scene) {
    std::vector<rtcore::SectionPlane>& planes = scene.sections.planes;
    if (choice.box)
        planes = rtcore::planesAround(scene.origin.local(choice.box->lo), scene.origin.local(choice.box->hi));
    else if (!choice.planes.empty())
        planes.clear();
    for (const SectionChoice::Plane& plane : choice.planes)
        planes.push_back({scene.origin.local(plane.point), plane.normal});
    if (choice.light) scene.sections.light = *choice.light;
    if (choice.caps) scene.sections.caps.colours = *choice.caps;
}

} // namespace app
