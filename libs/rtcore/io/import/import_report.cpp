#include "rtcore/io/import/import_report.h"

#include "rtcore/io/import/import_forms.h"
#include "rtcore/io/text/sentence_json.h"
#include "rtcore/settings/plain_text.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace rtcore {

namespace {

constexpr std::size_t kMaxWarnings = 50;
constexpr std::size_t kLongestWarning = 500;
constexpr std::string_view kRefusal = "refusal ";

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

Sentence firstOf(std::span<const std::string> names) {
    constexpr std::size_t kShown = 3;
    const std::size_t listed = names.size() > kShown ? kShown : names.size() - 1; // without the last one
    std::string text = "'" + names[0];
    for (std::size_t i = 1; i < listed; ++i) text += "', '" + names[i];
    if (names.size() > kShown) return say(import_forms::kAndMore, text, names.size() - kShown);
    if (names.size() > 1) return say(import_forms::kAnd, text, names.back() + "'");
    return text + "'";
}

void addWarning(ImportReport& report, const Sentence& warning) {
    const std::string text = warning.english();
    const Sentence shown = text.size() <= kLongestWarning ? warning : printable(text, kLongestWarning);
    const auto& known = report.warnings;
    if (known.size() > kMaxWarnings || std::find(known.begin(), known.end(), shown) != known.end()) return;
    report.warnings.push_back(known.size() < kMaxWarnings ? shown : import_forms::kMore);
}

std::string warningLine(const Sentence& warning) { return sentenceJson(warning); }

Sentence readWarning(std::string_view line) {
    return readSentenceJson(line).value_or(readAs(line, import_forms::kAll));
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
    for (const Sentence& warning : report.warnings) out << "warning " << warningLine(warning) << '\n';
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
        if (name == "warning") addWarning(report, readWarning(value));
        if (name == "file") addFile(report, pathOf(value));
        if (name == "image") addImage(report, pathOf(value));
    }
    return report;
}

std::string refusalLine(const Sentence& why) { return std::string(kRefusal) + sentenceJson(why) + '\n'; }

std::optional<Sentence> readRefusal(std::string_view text) {
    std::optional<Sentence> refusal;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        if (line.starts_with(kRefusal)) refusal = readSentenceJson(line.substr(kRefusal.size()));
    }
    return refusal;
}

} // namespace rtcore
