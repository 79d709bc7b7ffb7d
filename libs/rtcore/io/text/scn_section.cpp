#include "rtcore/io/text/scn_sections.h"
#include "rtcore/platform/sentence.h"

namespace rtcore {

namespace {

SectionPlane readPlane(StrictTable& table) {
    const auto point = table.position("point");
    const auto normal = table.vector("normal");
    table.finish();
    const SectionPlane plane{table.require("point", point), table.require("normal", normal)};
    if (normalize(plane.normal) == Vec3{})
        table.fail("normal", say("normal is zero; give the side that is taken away"));
    return plane;
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
    if (const auto light = root.choice("sectionLight", kSectionLights)) {
        root.needVersion(2, "sectionLight");
        sections.light = static_cast<SectionLight>(*light);
    }
    return sections;
}

void writeSectionLight(TomlWriter& writer, SectionLight light) {
    if (light != SectionLight::Whole) writer.add("sectionLight", nameOf(light));
}

void writeSectionPlane(TomlWriter& writer, const SectionPlane& plane) {
    writer.section("[[section]]");
    writer.add("point", plane.point);
    writer.add("normal", plane.normal);
}

} // namespace rtcore
