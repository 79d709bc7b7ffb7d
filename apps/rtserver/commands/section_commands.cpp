// Commands for the planes that cut the model open.
#include "rtserver/commands/command_call.h"
#include "rtserver/commands/model_objects.h"
#include "rtserver/commands/seen_surface.h"
#include "rtserver/document/model_edits.h"

#include "common/cli/command_line.h"

#include "rtcore/platform/sentence.h"
#include "rtcore/scene/up_axis.h"
#include "rtcore/settings/plain_text.h"
#include "rtcore/settings/settings_table.h"
#include "rtcore/survey/subject.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace rtserver {

namespace {

using rtcore::SectionPlane;
using rtcore::SectionPlanes;
using rtcore::Vec3;

const SectionPlanes& sectionsOf(const Call& call) { return call.document().scene()->sections; }

Result sections(const Call& call) {
    const SectionPlanes& all = sectionsOf(call);
    std::string text;
    for (std::size_t i = 0; i < all.planes.size(); ++i) {
        const Vec3 n = all.planes[i].normal;
        text += fmt::format("{} {} {} {} {}\n", i + 1, positionText(call, all.planes[i].point),
                            rtcore::settingText(n.x), rtcore::settingText(n.y), rtcore::settingText(n.z));
    }
    const rtcore::Colour c = all.caps.colour;
    text += fmt::format("light {}\ncaps {}\ncolour {} {} {}\nhatching {}", nameOf(all.light),
                        nameOf(all.caps.colours), rtcore::settingText(c.r), rtcore::settingText(c.g),
                        rtcore::settingText(c.b), all.caps.hatched ? "on" : "off");
    for (const std::string& part : call.document().caps().openParts(*call.document().scene()))
        text += "\nopen " + rtcore::inQuotes(part);
    const rtcore::Scene& scene = *call.document().scene();
    if (scene.uncutParts == nullptr) return {.answer = text};
    for (const rtcore::NamedPart& part : rtcore::namedParts(scene.model))
        if (isIn(part, scene.uncutParts)) text += "\nuncut " + rtcore::inQuotes(part.name);
    return {.answer = text};
}

/// In place of all sections.
void cutBy(const Call& call, std::vector<SectionPlane> planes) {
    SectionPlanes all = sectionsOf(call);
    all.planes = std::move(planes);
    cutOpen(call.document(), std::move(all));
}

void refuseUseless(const SectionPlane& plane) {
    if (const auto problem = problemOf(plane)) throw app::UsageError(*problem);
}

void add(const Call& call, const SectionPlane& plane) {
    refuseUseless(plane);
    SectionPlanes all = sectionsOf(call);
    if (all.planes.size() == rtcore::kMaxSectionPlanes)
        throw rtcore::Refusal("there are six sections already; remove one first");
    all.planes.push_back(plane);
    cutOpen(call.document(), std::move(all));
}

Result sectionAdd(const Call& call) {
    add(call, {positionAt(call, 0), vectorAt(call, 3)});
    return {};
}

Result sectionHere(const Call& call) {
    const auto seen = surfaceAt(call.document(), number(call[0]), number(call[1]));
    if (!seen) throw rtcore::Refusal("nothing of the model is seen there");
    add(call, {seen->position, seen->normal});
    return {};
}

Result sectionThrough(const Call& call) {
    const rtcore::Scene& scene = *call.document().scene();
    const bool below = call[0].starts_with('-');
    const Vec3 normal = rtcore::axisNamed(below ? call[0] : '+' + call[0]).value();
    add(call, {subjectOf(scene.model.mesh, rtcore::axesOf(scene)).bounds.centre(), normal});
    return {};
}

Result sectionBox(const Call& call) {
    const Vec3 a = positionAt(call, 0), b = positionAt(call, 3);
    Vec3 lo, hi;
    for (int axis = 0; axis < 3; ++axis) {
        lo[axis] = std::min(a[axis], b[axis]);
        hi[axis] = std::max(a[axis], b[axis]);
        if (!(lo[axis] < hi[axis]))
            throw app::UsageError(rtcore::say("the two corners of a box differ in each coordinate"));
    }
    std::vector<SectionPlane> planes = rtcore::planesAround(lo, hi);
    for (const SectionPlane& plane : planes) refuseUseless(plane);
    cutBy(call, std::move(planes));
    return {};
}

/// All sections, and that which the first argument numbers.
std::pair<SectionPlanes, std::size_t> chosen(const Call& call) {
    SectionPlanes all = sectionsOf(call);
    const auto number = static_cast<std::size_t>(integer(call[0]));
    if (number > all.planes.size())
        throw rtcore::Refusal(rtcore::say("there is no section {0}; 'sections' lists them", number));
    return {std::move(all), number - 1};
}

Result sectionMove(const Call& call) {
    auto [all, i] = chosen(call);
    all.planes[i].point = all.planes[i].point + normalize(all.planes[i].normal) * number(call[1]);
    refuseUseless(all.planes[i]);
    cutOpen(call.document(), std::move(all));
    return {};
}

Result sectionAt(const Call& call) {
    auto [all, i] = chosen(call);
    all.planes[i].point = positionAt(call, 1);
    refuseUseless(all.planes[i]);
    cutOpen(call.document(), std::move(all));
    return {};
}

Result sectionPlane(const Call& call) {
    auto [all, i] = chosen(call);
    all.planes[i] = {positionAt(call, 1), vectorAt(call, 4)};
    refuseUseless(all.planes[i]);
    cutOpen(call.document(), std::move(all));
    return {};
}

Result sectionTurn(const Call& call) {
    auto [all, i] = chosen(call);
    all.planes[i].normal = Vec3{} - all.planes[i].normal; // no -0
    cutOpen(call.document(), std::move(all));
    return {};
}

Result sectionRemove(const Call& call) {
    auto [all, i] = chosen(call);
    all.planes.erase(all.planes.begin() + static_cast<std::ptrdiff_t>(i));
    cutOpen(call.document(), std::move(all));
    return {};
}

Result sectionClear(const Call& call) {
    cutBy(call, {});
    return {};
}

Result sectionLight(const Call& call) {
    SectionPlanes all = sectionsOf(call);
    all.light = rtcore::sectionLightNamed(call[0]).value();
    cutOpen(call.document(), std::move(all));
    return {};
}

template <typename Change>
Result style(const Call& call, const Change& change) {
    SectionPlanes all = sectionsOf(call);
    change(all.caps);
    cutOpen(call.document(), std::move(all));
    return {};
}

Result sectionCaps(const Call& call) {
    return style(call,
                 [&](rtcore::CapStyle& caps) { caps.colours = rtcore::capColoursNamed(call[0]).value(); });
}

Result sectionColour(const Call& call) {
    return style(call, [&](rtcore::CapStyle& caps) {
        caps.colour = {number(call[0]), number(call[1]), number(call[2])};
    });
}

Result sectionHatching(const Call& call) {
    return style(call, [&](rtcore::CapStyle& caps) { caps.hatched = call[0] == "on"; });
}

void setUncut(const Call& call, bool uncut) {
    const rtcore::Scene& scene = *call.document().scene();
    const std::vector<rtcore::NamedPart> parts = rtcore::namedParts(scene.model);
    const std::vector<std::uint8_t> chosen = partsNamed(parts, call.arguments);
    leaveUncut(call.document(), withParts(scene.model, parts, chosen, uncut, scene.uncutParts));
}

Result sectionLeave(const Call& call) {
    setUncut(call, true);
    return {};
}

Result sectionCut(const Call& call) {
    setUncut(call, false);
    return {};
}

constexpr std::array kSectionFunctions{
    CommandFunction{app::CommandId::Sections, sections},
    CommandFunction{app::CommandId::SectionAdd, sectionAdd},
    CommandFunction{app::CommandId::SectionHere, sectionHere},
    CommandFunction{app::CommandId::SectionThrough, sectionThrough},
    CommandFunction{app::CommandId::SectionBox, sectionBox},
    CommandFunction{app::CommandId::SectionMove, sectionMove},
    CommandFunction{app::CommandId::SectionAt, sectionAt},
    CommandFunction{app::CommandId::SectionPlane, sectionPlane},
    CommandFunction{app::CommandId::SectionTurn, sectionTurn},
    CommandFunction{app::CommandId::SectionRemove, sectionRemove},
    CommandFunction{app::CommandId::SectionClear, sectionClear},
    CommandFunction{app::CommandId::SectionLight, sectionLight},
    CommandFunction{app::CommandId::SectionCaps, sectionCaps},
    CommandFunction{app::CommandId::SectionColour, sectionColour},
    CommandFunction{app::CommandId::SectionHatching, sectionHatching},
    CommandFunction{app::CommandId::SectionLeave, sectionLeave},
    CommandFunction{app::CommandId::SectionCut, sectionCut},
};

} // namespace

std::span<const CommandFunction> sectionFunctions() { return kSectionFunctions; }

} // namespace rtserver
