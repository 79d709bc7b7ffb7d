#include "rtserver/commands/measure_table.h"

#include "rtserver/commands/table_text.h"

#include "rtcore/settings/plain_text.h"

#include <fmt/format.h>

#include <string_view>

namespace rtserver {

namespace {

std::string pointsText(const MeasureStyle& style, const rtcore::KeptMeasure& measure,
                       std::string_view between) {
    std::string text;
    for (const rtcore::Vec3d& p : measure.points)
        text += fmt::format("{}{}", text.empty() ? "" : between, pointText(p, style.origin));
    return text;
}

} // namespace

std::string measureLine(const MeasureStyle& style, std::size_t index) {
    const rtcore::KeptMeasure& measure = style.measures.all[index];
    const rtcore::MeasureValue value = valueOf(measure, style.measures, style.metresPerUnit);
    const std::string name = measure.name.empty() ? "" : ' ' + rtcore::printable(measure.name);
    return fmt::format("{} {} {} {}{}", index + 1, nameOf(measure.kind), textOf(value, style.measures.unit),
                       pointsText(style, measure, ", "), name);
}

std::string measureTable(const MeasureStyle& style) {
    std::string text = "number,kind,name,value,unit,points\r\n";
    for (std::size_t i = 0; i < style.measures.all.size(); ++i) {
        const rtcore::KeptMeasure& measure = style.measures.all[i];
        const rtcore::MeasureValue value = valueOf(measure, style.measures, style.metresPerUnit);
        text +=
            fmt::format("{},{},{},{:.10g},{},{}\r\n", i + 1, nameOf(measure.kind), tableField(measure.name),
                        value.value, unitText(value, style.measures.unit), pointsText(style, measure, "; "));
    }
    return text;
}

} // namespace rtserver
