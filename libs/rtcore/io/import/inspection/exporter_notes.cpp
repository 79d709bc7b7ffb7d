#include "rtcore/io/import/inspection/exporter_notes.h"

#include "rtcore/platform/files.h"
#include "rtcore/scene/up_axis.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

namespace rtcore {

namespace {

constexpr std::size_t kNotesHead = 4096, kStlHead = 80;

std::string inLowerCase(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

std::string headOf(const std::filesystem::path& path) {
    if (!std::filesystem::is_regular_file(path)) return {};
    InputFile file(path);
    const auto bytes = file.head(kNotesHead);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string_view nextLine(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

/// Words between single blanks, without what draws lines.
void append(std::string& notes, std::string_view text) {
    for (const char c : text) {
        const bool blank = static_cast<unsigned char>(c) <= 0x20 || c == '#' || c == '*';
        if (!blank) {
            notes += c;
        } else if (!notes.empty() && notes.back() != ' ') {
            notes += ' ';
        }
    }
    if (!notes.empty() && notes.back() != ' ') notes += ' ';
}

std::string plyComments(std::string_view text) {
    std::string notes;
    while (!text.empty()) {
        const std::string_view line = nextLine(text);
        if (line.starts_with("end_header")) break;
        for (const std::string_view word : {"comment ", "obj_info "})
            if (line.starts_with(word)) append(notes, line.substr(word.size()));
    }
    return notes;
}

/// The first line of an ASCII file; the head of a binary one has 80 bytes.
std::string stlHead(std::string_view text) {
    const std::string_view head = text.substr(0, kStlHead);
    std::string notes;
    append(notes, head.substr(0, head.find_first_of(std::string_view("\n\r\0", 3))));
    return notes;
}

std::string objNotes(const std::filesystem::path& path) {
    std::string notes = openingComments(headOf(path));
    if (notes.empty()) notes = openingComments(headOf(std::filesystem::path(path).replace_extension(".mtl")));
    return notes;
}

constexpr std::array<std::pair<std::string_view, double>, 12> kUnits{{{"millimeter", 0.001},
                                                                      {"millimetre", 0.001},
                                                                      {"centimeter", 0.01},
                                                                      {"centimetre", 0.01},
                                                                      {"micron", 1e-6},
                                                                      {"meter", 1},
                                                                      {"metre", 1},
                                                                      {"inch", 0.0254},
                                                                      {"feet", 0.3048},
                                                                      {"foot", 0.3048},
                                                                      {"mm", 0.001},
                                                                      {"cm", 0.01}}};

std::optional<double> unitBeginning(std::string_view word) {
    for (const auto& [name, metres] : kUnits)
        if (word.starts_with(name)) return metres;
    return std::nullopt;
}

} // namespace

// Until the first line of vertices or materials.
std::string openingComments(std::string_view text) {
    std::string notes;
    while (!text.empty()) {
        const std::string_view line = nextLine(text);
        if (line.starts_with("v ") || line.starts_with("newmtl")) break;
        if (line.starts_with("#")) append(notes, line);
    }
    return notes;
}

std::string exporterNotes(const std::filesystem::path& path) {
    const std::string ending = inLowerCase(path.extension().string());
    std::string notes;
    if (ending == ".obj") {
        notes = objNotes(path);
    } else if (ending == ".ply") {
        notes = plyComments(headOf(path));
    } else if (ending == ".stl") {
        notes = stlHead(headOf(path));
    }
    if (notes.ends_with(' ')) notes.pop_back();
    return notes;
}

std::optional<double> statedUnit(const std::string& notes) {
    const std::string text = inLowerCase(notes);
    for (const std::string_view word : {"file units = ", "units = ", "units: ", "unit: "}) {
        const std::size_t at = text.find(word);
        if (at == std::string::npos) continue;
        if (const auto unit = unitBeginning(std::string_view(text).substr(at + word.size()))) return unit;
    }
    return std::nullopt;
}

void readFixedUnits(const std::filesystem::path& path, ModelOrigin& origin) {
    const std::string ending = inLowerCase(path.extension().string());
    if (ending != ".amf") return;
    origin.up = axisNamed("+z");
    origin.metresPerUnit = 0.001; // where nothing is said
    const std::string text = inLowerCase(headOf(path));
    const std::size_t at = text.find("unit=\"");
    if (at == std::string::npos) return;
    if (const auto unit = unitBeginning(std::string_view(text).substr(at + 6))) origin.metresPerUnit = unit;
}

} // namespace rtcore
