#include "rtcore/io/import/import_report.h"

#include "rtcore/io/import/import_forms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace rtcore {

namespace {

constexpr std::size_t kMaxWarnings = 50;

/// One line whatever the text holds: it may come from a damaged file.
std::string printable(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, '?');
    return text.substr(0, 500);
}

void addOnce(std::vector<std::string>& paths, const std::string& path) {
    if (std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
}

/// One line, from which pathOf() makes the same name.
std::string lineOf(const std::string& path) {
    std::string line;
    for (const char c : path) {
        if (c == '\n' || c == '\\') line += '\\';
        line += c == '\n' ? 'n' : c;
    }
    return line;
}

std::string pathOf(const std::string& line) {
    std::string path;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool quoted = line[i] == '\\' && i + 1 < line.size();
        if (quoted) ++i;
        path += quoted && line[i] == 'n' ? '\n' : line[i];
    }
    return path;
}

void writePaths(std::ostream& out, const char* name, const std::vector<std::string>& paths) {
    for (const std::string& path : paths) out << name << ' ' << lineOf(path) << '\n';
}

} // namespace

std::string firstOf(std::span<const std::string> names) {
    constexpr std::size_t kShown = 3;
    std::string text;
    for (std::size_t i = 0; i < std::min(kShown, names.size()); ++i) {
        text += (i == 0 ? "'" : i + 1 == names.size() ? " and '" : ", '") + names[i] + "'";
    }
    if (names.size() > kShown) text += fmt::format(" and {} more", names.size() - kShown);
    return text;
}

void addWarning(ImportReport& report, const std::string& text) {
    const std::string line = printable(text);
    const auto& known = report.warnings;
    if (known.size() > kMaxWarnings || std::find(known.begin(), known.end(), line) != known.end()) return;
    report.warnings.push_back(known.size() < kMaxWarnings ? line : import_forms::kMore);
}

void addFile(ImportReport& report, const std::string& path) { addOnce(report.files, path); }

void addImage(ImportReport& report, const std::string& path) {
    addOnce(report.files, path);
    addOnce(report.images, path);
}

std::string writeReport(const ImportReport& report) {
    std::ostringstream out;
    out << writeOrigin(report.origin) << "degenerate " << report.degenerateTriangles << '\n'
        << "ignored " << report.ignoredPrimitives << '\n'
        << "nonfinite " << report.nonFiniteTriangles << '\n'
        << "unconnected " << report.unconnectedTriangles << '\n'
        << "equal " << report.equalTriangles << '\n';
    for (const std::string& warning : report.warnings) out << "warning " << warning << '\n';
    writePaths(out, "file", report.files);
    writePaths(out, "image", report.images);
    return out.str();
}

ImportReport readReport(const std::string& text) {
    ImportReport report;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        const std::size_t space = line.find(' ');
        if (space == std::string::npos) continue;
        const std::string name = line.substr(0, space);
        const std::string value = line.substr(space + 1);
        if (readOriginLine(line, report.origin)) continue;
        const std::uint64_t count = std::strtoull(value.c_str(), nullptr, 10);
        if (name == "degenerate") report.degenerateTriangles = count;
        if (name == "ignored") report.ignoredPrimitives = count;
        if (name == "nonfinite") report.nonFiniteTriangles = count;
        if (name == "unconnected") report.unconnectedTriangles = count;
        if (name == "equal") report.equalTriangles = count;
        if (name == "warning") addWarning(report, value);
        if (name == "file") addFile(report, pathOf(value));
        if (name == "image") addImage(report, pathOf(value));
    }
    return report;
}

} // namespace rtcore
