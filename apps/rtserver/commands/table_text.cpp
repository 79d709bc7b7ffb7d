#include "rtserver/commands/table_text.h"

#include "rtcore/settings/number_text.h"

#include <fmt/format.h>

namespace rtserver {

namespace {

std::string coordinateText(double coordinate) {
    const auto single = static_cast<float>(coordinate);
    return double{single} == coordinate ? rtcore::shortestText(single) : rtcore::shortestText(coordinate);
}

} // namespace

std::string tableField(std::string_view text) {
    // Where a program takes `;` for what parts cells, quotation marks hold nothing together.
    constexpr std::string_view kFormulas = "=+-@", kNewCell = "\n\r\t;";
    std::string plain = text.starts_with('\t') || text.starts_with('\r') ? "'" : "";
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool begins = i == 0 || kNewCell.find(text[i - 1]) != std::string_view::npos;
        if (begins && kFormulas.find(text[i]) != std::string_view::npos) plain += '\'';
        plain += text[i];
    }
    if (plain.find_first_of("\",\r\n") == std::string::npos) return plain;
    std::string field = "\"";
    for (const char c : plain) field += c == '"' ? std::string("\"\"") : std::string(1, c);
    return field + '"';
}

std::string pointText(const rtcore::Vec3d& point, const rtcore::LocalOrigin& origin) {
    const rtcore::FilePoint& zero = origin.at;
    return fmt::format("{} {} {}", coordinateText(point.x + zero[0]), coordinateText(point.y + zero[1]),
                       coordinateText(point.z + zero[2]));
}

} // namespace rtserver
