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
    const bool formula =
        !text.empty() && std::string_view("=+-@\t\r").find(text[0]) != std::string_view::npos;
    std::string plain = formula ? "'" : "";
    plain += text;
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
