#include "rtcore/io/import/scan/point_text.h"

#include "rtcore/io/import/materials/colour_decoder.h"
#include "rtcore/io/import/scan/point_discs.h"
#include "rtcore/io/import/text/statement_pieces.h"
#include "rtcore/io/import/text/statement_text.h"
#include "rtcore/io/import/text/statement_warning.h"
#include "rtcore/math/nearest_float.h"
#include "rtcore/platform/error.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

namespace rtcore {

namespace {

constexpr std::size_t kMaxNumbers = 10;

[[noreturn]] void refusePointText(const Sentence& why) { throw FileError(FailureKind::BadData, "", why); }

/// The numbers at the beginning of a line.
struct Row {
    std::array<double, kMaxNumbers> numbers{};
    std::size_t count = 0;
    bool onlyNumbers = true;

    Vec3 triple(std::size_t first) const { return LocalOrigin().local(point(first)); }
    FilePoint point(std::size_t first) const {
        return {numbers[first], numbers[first + 1], numbers[first + 2]};
    }
};

/// Where commas stand between numbers, not before fractions: no blanks do, or they follow commas.
bool partsByCommas(std::string_view line) {
    const std::size_t comma = line.find(',');
    if (comma == std::string_view::npos) return false;
    const bool followed = comma + 1 < line.size() && (line[comma + 1] == ' ' || line[comma + 1] == '\t');
    return followed || line.find_first_of(" \t;") == std::string_view::npos;
}

Row readRow(std::string_view line) {
    const std::string_view between = partsByCommas(line) ? ", \t;" : " \t;";
    Row row;
    while (row.count < kMaxNumbers) {
        line.remove_prefix(std::min(line.find_first_not_of(between), line.size()));
        if (line.empty()) break;
        const std::size_t end = std::min(line.find_first_of(between), line.size());
        const auto number = preciseNumberOf(line.substr(0, end));
        row.onlyNumbers = number.has_value();
        if (!number) break;
        row.numbers[row.count++] = *number;
        line.remove_prefix(end);
    }
    return row;
}

bool isComment(std::string_view line) { return line.starts_with('#') || line.starts_with("//"); }

/// Where in a row things stand; 0 = nowhere.
struct Layout {
    std::size_t intensity = 0, colour = 0, normal = 0;
};

/// Whether three numbers of all rows from `first` on are of unit length.
bool areNormals(const std::vector<Row>& rows, std::size_t first) {
    return std::ranges::all_of(rows, [&](const Row& row) {
        const Vec3 v = row.triple(first);
        return row.count < first + 3 || std::fabs(length(v) - 1) < 0.02F || length(v) == 0;
    });
}

/// By rows from the beginning of a file. An intensity stands before colours in PTS, behind all in XYZ.
Layout layoutOf(const std::vector<Row>& rows, bool intensityFirst) {
    std::size_t count = rows.empty() ? 0 : kMaxNumbers;
    for (const Row& row : rows) count = std::min(count, row.count);
    Layout layout;
    std::size_t at = 3;
    if (count == 4 || count == 7 || count == 10) layout.intensity = intensityFirst ? at++ : count - 1;
    for (; at + 3 <= count; at += 3) {
        const bool normals = layout.normal == 0 && areNormals(rows, at);
        std::size_t& first = normals ? layout.normal : layout.colour;
        if (first == 0) first = at;
    }
    return layout;
}

class PointLines {
  public:
    PointLines(const Layout& layout, const LocalOrigin& origin, OddStatements& odd)
        : layout_(layout), odd_(odd) {
        points_.origin = origin;
    }

    void read(std::string_view text) {
        while (!text.empty()) {
            const std::size_t end = std::min(text.find_first_of("\n\r"), text.size());
            add(text.substr(0, end));
            const bool both = text.substr(end).starts_with("\r\n");
            text.remove_prefix(std::min(end + (both ? 2 : 1), text.size()));
            ++line_;
        }
    }
    std::uint64_t count() const { return count_; }

    ScanMesh finish() {
        if (layout_.colour != 0) {
            decodeColours();
        } else if (layout_.intensity != 0) {
            greyByIntensity();
        }
        return std::move(points_);
    }

  private:
    void add(std::string_view line) {
        line.remove_prefix(std::min(line.find_first_not_of(" \t,;"), line.size()));
        if (line.empty() || isComment(line)) return;
        const Row row = readRow(line);
        if (row.count < 3) {
            const bool isCount = row.count == 1 && row.onlyNumbers, isHead = count_ == 0 && row.count == 0;
            if (!isCount && !isHead) odd_.add(line_, line.substr(0, 40));
            return;
        }
        if (++count_ > kMaxPoints) return;
        points_.positions.push_back(points_.origin.local(row.point(0)));
        if (layout_.normal != 0) points_.normals.push_back(row.triple(layout_.normal));
        if (layout_.colour != 0) {
            const Vec3 c = row.triple(layout_.colour);
            points_.colours.push_back({c.x, c.y, c.z});
        } else if (layout_.intensity != 0) {
            const float grey = nearestFloat(row.numbers[layout_.intensity]);
            points_.colours.push_back({grey, grey, grey});
        }
    }

    void decodeColours() {
        float max = 0;
        for (const Colour c : points_.colours)
            if (std::isfinite(maxComponent(c))) max = std::max(max, maxComponent(c));
        const float scale = max > 255 ? 1.0F / 65535 : max > 1 ? 1.0F / 255 : 1;
        const ColourDecoder decode(false);
        const auto part = [scale](float v) {
            return std::isfinite(v) ? std::clamp(v * scale, 0.0F, 1.0F) : 0;
        };
        for (Colour& c : points_.colours) c = decode({part(c.r), part(c.g), part(c.b)});
    }
    /// From black at the least to white.
    void greyByIntensity() {
        float lo = 0, hi = 0;
        bool any = false;
        for (const Colour c : points_.colours) {
            if (!std::isfinite(c.r)) continue;
            lo = any ? std::min(lo, c.r) : c.r;
            hi = any ? std::max(hi, c.r) : c.r;
            any = true;
        }
        if (!(hi > lo)) {
            points_.colours.clear();
            return;
        }
        const ColourDecoder decode(false);
        for (Colour& c : points_.colours) {
            const float grey = std::isfinite(c.r) ? (c.r - lo) / (hi - lo) : 0;
            c = decode({grey, grey, grey});
        }
    }

    Layout layout_;
    OddStatements& odd_;
    ScanMesh points_;
    std::uint64_t count_ = 0, line_ = 1;
};

/// Lines from the beginning of a file, whole ones.
std::vector<std::string_view> firstLines(std::string_view head) {
    constexpr std::size_t kLines = 500;
    std::vector<std::string_view> lines;
    while (lines.size() < kLines) {
        const std::size_t end = head.find_first_of("\n\r");
        if (end == std::string_view::npos) break;
        lines.push_back(head.substr(0, end));
        head.remove_prefix(end + 1);
    }
    if (lines.empty() && !head.empty()) lines.push_back(head);
    return lines;
}

/// A number of atoms, a title, then the sign of an element before each position.
bool isMolecule(std::span<const std::string_view> lines) {
    if (lines.size() < 3) return false;
    const Row count = readRow(lines[0]);
    const std::string_view atom =
        lines[2].substr(std::min(lines[2].find_first_not_of(" \t"), lines[2].size()));
    if (count.count != 1 || !count.onlyNumbers || atom.empty()) return false;
    const std::size_t sign = std::min(atom.find_first_of(" \t"), atom.size());
    return std::isalpha(static_cast<unsigned char>(atom[0])) != 0 && sign <= 2 &&
           readRow(atom.substr(sign)).count >= 3;
}

} // namespace

PointText readPointText(const std::filesystem::path& path, const LocalOrigin& origin, ImportReport& report,
                        const std::function<void()>& alive) {
    constexpr std::size_t kLookedThrough = 65536;
    InputFile file(path);
    const auto bytes = file.head(kLookedThrough);
    const std::string head(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::vector<std::string_view> lines = firstLines(head);
    if (isMolecule(lines))
        refusePointText(say("it is a molecule, which has no surfaces; export a mesh of it as OBJ or glTF"));
    std::vector<Row> rows;
    for (const std::string_view line : lines) {
        const Row row = isComment(line) ? Row{} : readRow(line);
        if (row.count >= 3) rows.push_back(row);
    }
    OddStatements odd;
    const bool isPts = inSmallLetters(path.extension().string()) == ".pts";
    PointLines points(layoutOf(rows, isPts), origin, odd);
    forEachStatements(file, alive, [&](std::string_view text, std::uint64_t) { points.read(text); });
    if (points.count() == 0)
        refusePointText(
            say("it holds no points: none of its lines begins with x, y and z; export them again"));
    odd.warn(path, report);
    const std::uint64_t count = points.count();
    return {points.finish(), count};
}

} // namespace rtcore
