#include "rtcore/io/import/obj/list_reader.h"

#include <array>
#include <cmath>
#include <limits>

namespace rtcore {

namespace {

constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

/// From 0; kNoIndex for one that cannot be there.
std::uint32_t indexOf(std::int64_t number, std::size_t count) {
    const std::int64_t index = number > 0 ? number - 1 : static_cast<std::int64_t>(count) + number;
    return index >= 0 && index < std::int64_t{kNoIndex} ? static_cast<std::uint32_t>(index) : kNoIndex;
}

/// A list of indices of corners begins with the first that is one.
void addIndex(std::vector<std::uint32_t>& list, std::uint32_t index, std::size_t at) {
    if (list.empty()) {
        if (index == kNoIndex) return;
        list.resize(at, kNoIndex);
    }
    list.push_back(index);
}

} // namespace

bool ObjListReader::read(std::string_view keyword, StatementText& in) {
    if (keyword == "v") return readPosition(in);
    if (keyword == "vt") return readTexcoord(in);
    if (keyword == "vn") return readNormal(in);
    return readFace(in);
}

void ObjListReader::addDamaged(std::string_view keyword) {
    if (keyword == "v") {
        lists_.positions.push_back({kNoNumber, kNoNumber, kNoNumber});
        if (!lists_.colours.empty()) lists_.colours.push_back(kWhite);
    }
    if (keyword == "vt") lists_.texcoords.emplace_back();
    if (keyword == "vn") lists_.normals.emplace_back();
}

/// x y z, and a weight, a colour or a colour with an opacity behind them.
bool ObjListReader::readPosition(StatementText& in) {
    std::array<float, 8> n{};
    std::size_t count = 0;
    while (count < n.size() && in.hasWord() && in.next() != '#') {
        const auto number = count < 3 ? in.coordinate(origin_.at[count]) : in.number();
        if (!number) return false;
        n[count++] = *number;
    }
    if (count < 3) return false;
    Vec3 position{n[0], n[1], n[2]};
    if (count == 4 && n[3] != 0) position = divided(position, n[3]);
    lists_.positions.push_back(position);
    if (count == 6 || count == 7) {
        lists_.colours.resize(lists_.positions.size(), kWhite);
        lists_.colours.back() = {n[3], n[4], n[5]};
    } else if (!lists_.colours.empty()) {
        lists_.colours.push_back(kWhite);
    }
    return true;
}

/// A position whose numbers are to be divided by its weight, less the origin either way.
Vec3 ObjListReader::divided(Vec3 p, float weight) const {
    if (origin_.isZero()) return {p.x / weight, p.y / weight, p.z / weight};
    FilePoint point = origin_.inFile(p);
    for (double& each : point) each /= double{weight};
    return origin_.local(point);
}

bool ObjListReader::readTexcoord(StatementText& in) {
    const auto x = in.number();
    const auto y = x && in.hasWord() && in.next() != '#' ? in.number() : std::optional(0.0F);
    if (!x || !y) return false;
    const auto finite = [](float v) { return std::isfinite(v) ? v : 0.0F; };
    lists_.texcoords.push_back({finite(*x), finite(*y)});
    return true;
}

bool ObjListReader::readNormal(StatementText& in) {
    const auto x = in.number(), y = in.number(), z = in.number();
    if (!x || !y || !z) return false;
    lists_.normals.push_back({*x, *y, *z});
    return true;
}

/// "v", "v/t", "v//n" or "v/t/n"; nothing for what is none.
std::optional<ObjListReader::Corner> ObjListReader::readCorner(StatementText& in) const {
    Corner corner;
    const std::int64_t position = in.wholeNumber();
    if (position == 0 || (amidst_ && position < 0)) return std::nullopt;
    corner.position = indexOf(position, lists_.positions.size());
    if (in.slash()) {
        const std::int64_t second = in.wholeNumber();
        const bool third = in.slash();
        const std::int64_t normal = third ? in.wholeNumber() : 0;
        // Without texture coordinates in the file, programs write "v/n".
        const bool hasTexcoords = texcoordsBefore_ || !lists_.texcoords.empty();
        const bool unclear = second != 0 && !third && !hasTexcoords;
        if (amidst_ && (second < 0 || normal < 0 || unclear)) return std::nullopt;
        const bool secondIsNormal = unclear && !lists_.normals.empty();
        if (second != 0 && !secondIsNormal) corner.texcoord = indexOf(second, lists_.texcoords.size());
        if (secondIsNormal) corner.normal = indexOf(second, lists_.normals.size());
        if (normal != 0) corner.normal = indexOf(normal, lists_.normals.size());
    }
    return in.endsWord() ? std::optional(corner) : std::nullopt;
}

bool ObjListReader::readFace(StatementText& in) {
    face_.clear();
    while (in.hasWord() && in.next() != '#') {
        const auto corner = readCorner(in);
        if (!corner) return false;
        face_.push_back(*corner);
    }
    if (face_.empty()) return false;
    addFace();
    return true;
}

void ObjListReader::addFace() {
    ObjCorners& corners = lists_.corners;
    for (const Corner& corner : face_) {
        const std::size_t at = corners.positions.size();
        corners.positions.push_back(corner.position);
        addIndex(corners.texcoords, corner.texcoord, at);
        addIndex(corners.normals, corner.normal, at);
    }
    const std::size_t size = face_.size();
    if (size != 3 && lists_.sizes.empty()) lists_.sizes.assign(lists_.faces, 3);
    if (size != 3 || !lists_.sizes.empty()) lists_.sizes.push_back(static_cast<std::uint32_t>(size));
    ++lists_.faces;
}

} // namespace rtcore
