#include "rtcore/io/text/scn_sections.h"
#include "rtcore/platform/sentence.h"

namespace rtcore {

namespace {

SectionPlane readPlane(StrictTable& table) {
    const auto point = table.position("point");
    const auto normal = table.vector("normal");
    table.finish();
    const SectionPlane plane{table.require("point", point), table.require("normal", normal)};
    if (const auto problem = problemOf(plane)) table.fail("point", *problem);
    return plane;
}

void readStyle(StrictTable& root, SectionPlanes& sections) {
    const auto known = [&](const char* key, auto value, const auto& take) {
        if (!value) return;
        root.needVersion(2, key);
        take(*value);
    };
    known("sectionLight", root.choice("sectionLight", kSectionLights),
          [&](std::size_t light) { sections.light = static_cast<SectionLight>(light); });
    known("sectionCaps", root.choice("sectionCaps", kCapColours),
          [&](std::size_t colours) { sections.caps.colours = static_cast<CapColours>(colours); });
    known("sectionColour", root.colour("sectionColour", kUnitRange),
          [&](Colour colour) { sections.caps.colour = colour; });
    known("sectionHatching", root.boolean("sectionHatching"),
          [&](bool hatched) { sections.caps.hatched = hatched; });
}

} // namespace

SectionPlanes readSectionPlanes(StrictTable& root) {
    SectionPlanes sections;
    for (StrictTable& table : root.tables("section")) {
        root.needVersion(2, "section");
        sections.planes.push_back(readPlane(table));
        if (sections.planes.size() > kMaxSectionPlanes)
            table.fail("point", say("there are more than {0} sections; leave some out", kMaxSectionPlanes));
    }
    readStyle(root, sections);
    return sections;
}

void writeSectionStyle(TomlWriter& writer, const SectionPlanes& sections) {
    const CapStyle &caps = sections.caps, usual;
    if (sections.light != SectionLight::Whole) writer.add("sectionLight", nameOf(sections.light));
    if (caps.colours != usual.colours) writer.add("sectionCaps", nameOf(caps.colours));
    if (!(caps.colour == usual.colour)) writer.add("sectionColour", caps.colour);
    if (caps.hatched != usual.hatched) writer.add("sectionHatching", caps.hatched);
}

void writeSectionPlane(TomlWriter& writer, const SectionPlane& plane) {
    writer.section("[[section]]");
    writer.add("point", plane.point);
    writer.add("normal", plane.normal);
}

} // namespace rtcore
