#include "rtcore/io/text/scn_sections.h"
#include "rtcore/platform/sentence.h"

#include <algorithm>

namespace rtcore {

namespace {

constexpr Limits kAmount{.minimum = 0, .maximum = 1e36};
constexpr int kMaxPart = 1'000'000'000;

std::vector<Vec3d> vectorsOf(const std::vector<FilePoint>& points) {
    std::vector<Vec3d> vectors;
    for (const FilePoint& p : points) vectors.push_back({p[0], p[1], p[2]});
    return vectors;
}

KeptMeasure readMeasure(StrictTable& table) {
    const auto kind = table.choice("kind", kMeasureKinds);
    const auto points = table.positions("points");
    KeptMeasure measure;
    measure.name = table.text("name").value_or("");
    measure.kind = static_cast<MeasureKind>(table.require("kind", kind));
    if (measure.kind == MeasureKind::Area) {
        const auto normal = table.vector("normal");
        measure.normal = table.require("normal", normal);
        const auto area = table.preciseNumber("area", kAmount);
        measure.amount = table.require("area", area);
    }
    if (measure.kind == MeasureKind::Volume) {
        const auto part = table.integer("part", 1, kMaxPart);
        measure.part = table.require("part", part);
        const auto volume = table.preciseNumber("volume", kAmount);
        measure.amount = table.require("volume", volume);
    }
    table.finish();
    measure.points = vectorsOf(table.require("points", points));
    if (const auto problem = problemOf(measure)) table.fail("points", *problem);
    return measure;
}

} // namespace

KeptMeasures readMeasures(StrictTable& root) {
    KeptMeasures measures;
    const auto unit = root.choice("measureUnit", kLengthUnits);
    root.needVersion(2, "measureUnit");
    if (unit) measures.unit = static_cast<LengthUnit>(*unit);
    const auto decimals = root.integer("measureDecimals", 0, kMaxMeasureDecimals);
    root.needVersion(2, "measureDecimals");
    measures.decimals = decimals.value_or(measures.decimals);
    for (StrictTable& table : root.tables("measure")) {
        root.needVersion(2, "measure");
        if (measures.all.size() == kMaxMeasures)
            table.fail("kind", say("there are more than {0} measures; leave some out", kMaxMeasures));
        measures.all.push_back(readMeasure(table));
    }
    return measures;
}

void writeMeasureStyle(TomlWriter& writer, const KeptMeasures& measures) {
    const KeptMeasures usual;
    if (measures.unit != usual.unit) writer.add("measureUnit", nameOf(measures.unit));
    if (measures.decimals != usual.decimals) writer.add("measureDecimals", measures.decimals);
}

void writeMeasure(TomlWriter& writer, const KeptMeasure& measure) {
    writer.section("[[measure]]");
    writer.add("kind", nameOf(measure.kind));
    std::vector<FilePoint> points;
    for (const Vec3d p : measure.points) points.push_back({p.x, p.y, p.z});
    writer.add("points", points);
    if (measure.kind == MeasureKind::Area) {
        writer.add("normal", measure.normal);
        writer.add("area", measure.amount);
    }
    if (measure.kind == MeasureKind::Volume) {
        writer.add("part", measure.part);
        writer.add("volume", measure.amount);
    }
    if (!measure.name.empty()) writer.add("name", measure.name);
}

} // namespace rtcore
