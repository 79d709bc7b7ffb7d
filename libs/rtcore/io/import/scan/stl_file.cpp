#include "rtcore/io/import/scan/stl_file.h"

#include "rtcore/io/import/scan/piece_reader.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/large_vector.h"

#include <array>
#include <atomic>
#include <bit>
#include <cstring>
#include <string_view>

namespace rtcore {

namespace {

constexpr std::size_t kTitle = 80;
constexpr std::size_t kHead = kTitle + 4;
constexpr std::size_t kFacet = 50;       ///< a normal, three corners, an attribute
constexpr std::size_t kCorners = 12;     ///< bytes before them
constexpr std::size_t kAttribute = 48;   ///< bytes before it
constexpr std::uint32_t kMax = 1U << 30; ///< facets whose corners can be numbered

std::uint16_t attributeOf(const std::byte* facet) {
    return static_cast<std::uint16_t>(std::to_integer<unsigned>(facet[kAttribute]) |
                                      std::to_integer<unsigned>(facet[kAttribute + 1]) << 8U);
}

/// Numbers are little-endian.
void toNative(Vec3& v) {
    if constexpr (std::endian::native == std::endian::little) return;
    for (int axis = 0; axis < 3; ++axis) {
        auto bytes = std::bit_cast<std::array<std::byte, 4>>(v[axis]);
        std::swap(bytes[0], bytes[3]);
        std::swap(bytes[1], bytes[2]);
        v[axis] = std::bit_cast<float>(bytes);
    }
}

/// How many there are, if the file is what it says.
std::optional<std::uint32_t> facetsOf(const InputFile& file) {
    std::array<std::byte, kHead> head{};
    if (file.readAt(0, head) < kHead) return {};
    std::uint32_t count = 0;
    for (std::size_t i = 4; i-- > 0;) count = count << 8U | std::to_integer<std::uint32_t>(head[kTitle + i]);
    const std::string_view title(reinterpret_cast<const char*>(head.data()), kTitle);
    const bool coloured = title.find("COLOR=") != std::string_view::npos;
    const bool fits = file.size() == kHead + std::uint64_t{count} * kFacet;
    if (coloured || !fits || count == 0 || count > kMax) return {};
    return count;
}

} // namespace

std::optional<ScanMesh> readStl(const InputFile& file, const std::function<void()>& alive) {
    const std::optional<std::uint32_t> count = facetsOf(file);
    if (!count) return {};
    ScanMesh mesh;
    resizeLarge(mesh.positions, std::size_t{*count} * 3);
    resizeLarge(mesh.triangles, *count);
    PieceReader in(file, kHead, alive);
    std::atomic<bool> coloured = false;
    const auto use = [&](std::uint64_t first, std::span<const std::byte> records) {
        auto facet = static_cast<std::uint32_t>(first);
        for (std::size_t at = 0; at < records.size(); ++facet, at += kFacet) {
            constexpr unsigned kColoured = 0x8000;
            const std::byte* const record = records.data() + at;
            if ((attributeOf(record) & kColoured) != 0) coloured = true;
            Vec3* const corners = &mesh.positions[std::size_t{facet} * 3];
            std::memcpy(corners, record + kCorners, 3 * sizeof(Vec3));
            for (int i = 0; i < 3; ++i) toNative(corners[i]);
            mesh.triangles[facet] = {{3 * facet, 3 * facet + 1, 3 * facet + 2}};
        }
        return !coloured;
    };
    if (in.readRecords(*count, kFacet, use)) return mesh;
    if (coloured) return {};
    throw FileError(FailureKind::BadData, "",
                    say("it ends before the last of the {0} triangles that its head promises; it is "
                        "damaged: copy or export it again",
                        *count));
}

} // namespace rtcore
