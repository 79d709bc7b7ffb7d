#include "rtserver/commands/measure_table.h"

#include "rtcore/settings/number_text.h"
#include "rtcore/settings/plain_text.h"

#include <fmt/format.h>

#include <string_view>

namespace rtserver {

namespace {

/// What came of floats has no more digits than these.
std::string coordinateText(double coordinate) {
    const auto single = static_cast<float>(coordinate);
    return double{single} == coordinate ? rtcore::shortestText(single) : rtcore::shortestText(coordinate);
}

std::string pointsText(const MeasureStyle& style, const rtcore::KeptMeasure& measure,
                       std::string_view between) {
    const rtcore::FilePoint& zero = style.origin.at;
    std::string text;
    for (const rtcore::Vec3d p : measure.points)
        text += fmt::format("{}{} {} {}", text.empty() ? "" : between, coordinateText(p.x + zero[0]),
                            coordinateText(p.y + zero[1]), coordinateText(p.z + zero[2]));
    return text;
}

/// As a field of a table.
std::string fieldOf(std::string_view name) {
    const bool formula =
        !name.empty() && std::string_view("=+-@\t\r").find(name[0]) != std::string_view::npos;
    std::string text = formula ? "'" : "";
    text += name;
    if (text.find_first_of("\",\r\n") == std::string::npos) return text;
    std::string field = "\"";
    for (const char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
    return field + '"';
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
            fmt::format("{},{},{},{:.10g},{},{}\r\n", i + 1, nameOf(measure.kind), fieldOf(measure.name),
                        value.value, unitText(value, style.measures.unit), pointsText(style, measure, "; "));
    }
    return text;
}

} // namespace rtserver
