#include "rtcore/io/import/scan/stl_file.h"

#include "rtcore/io/import/materials/colour_decoder.h"
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

/// By what programs write into the attributes of facets, if any of them has a bit set.
enum class ColourRule {
    VisCam, ///< bit 15 set: a colour of its own, blue in the lowest bits
    Magics, ///< bit 15 clear: a colour of its own, red in the lowest bits; else that of the head
};

struct StlHead {
    std::uint32_t facets;
    ColourRule rule = ColourRule::VisCam;
    Colour colour{0.6F, 0.6F, 0.6F}; ///< of facets without one of their own
};

float fractionOfByte(char byte) { return static_cast<float>(static_cast<unsigned char>(byte)) / 255; }

/// Nothing if the file is not what it says.
std::optional<StlHead> headOf(const InputFile& file) {
    std::array<std::byte, kHead> head{};
    if (file.readAt(0, head) < kHead) return {};
    std::uint32_t count = 0;
    for (std::size_t i = 4; i-- > 0;) count = count << 8U | std::to_integer<std::uint32_t>(head[kTitle + i]);
    const bool fits = file.size() == kHead + std::uint64_t{count} * kFacet;
    if (!fits || count == 0 || count > kMax) return {};
    StlHead result{count};
    const std::string_view title(reinterpret_cast<const char*>(head.data()), kTitle);
    constexpr std::string_view kMark = "COLOR=";
    const std::size_t at = title.find(kMark);
    if (at == std::string_view::npos) return result;
    result.rule = ColourRule::Magics;
    const std::string_view bytes = title.substr(at + kMark.size());
    result.colour = kWhite;
    if (bytes.size() >= 3)
        result.colour = {fractionOfByte(bytes[0]), fractionOfByte(bytes[1]), fractionOfByte(bytes[2])};
    return result;
}

/// Encoded as sRGB.
Colour colourOf(std::uint16_t attribute, const StlHead& head) {
    constexpr unsigned kFlag = 0x8000, kFive = 31;
    const bool own = ((attribute & kFlag) != 0) == (head.rule == ColourRule::VisCam);
    if (!own) return head.colour;
    const auto part = [attribute](unsigned shift) {
        return static_cast<float>(attribute >> shift & kFive) * (1.0F / 31.0F);
    };
    if (head.rule == ColourRule::Magics) return {part(0), part(5), part(10)};
    return {part(10), part(5), part(0)};
}

} // namespace

std::optional<StlFile> readStl(const InputFile& file, const LocalOrigin& origin,
                               const std::function<void()>& alive) {
    const std::optional<StlHead> head = headOf(file);
    if (!head) return {};
    StlFile stl;
    ScanMesh& mesh = stl.mesh;
    mesh.origin = origin;
    mesh.inFloats = true;
    resizeLarge(mesh.positions, std::size_t{head->facets} * 3);
    resizeLarge(mesh.triangles, head->facets);
    std::vector<std::uint16_t> attributes;
    resizeLarge(attributes, head->facets);
    PieceReader in(file, kHead, alive);
    std::atomic<bool> flagged = false, set = false;
    const auto use = [&](std::uint64_t first, std::span<const std::byte> records) {
        auto facet = static_cast<std::uint32_t>(first);
        for (std::size_t at = 0; at < records.size(); ++facet, at += kFacet) {
            constexpr unsigned kFlag = 0x8000;
            const std::byte* const record = records.data() + at;
            attributes[facet] = attributeOf(record);
            if ((attributes[facet] & kFlag) != 0) flagged = true;
            if (attributes[facet] != 0) set = true;
            Vec3* const corners = &mesh.positions[std::size_t{facet} * 3];
            std::memcpy(corners, record + kCorners, 3 * sizeof(Vec3));
            for (int i = 0; i < 3; ++i) toNative(corners[i]);
            if (!origin.isZero())
                for (int i = 0; i < 3; ++i) corners[i] = origin.local(filePoint(corners[i]));
            mesh.triangles[facet] = {{3 * facet, 3 * facet + 1, 3 * facet + 2}};
        }
        return true;
    };
    if (!in.readRecords(head->facets, kFacet, use)) {
        throw FileError(FailureKind::BadData, "",
                        say("it ends before the last of the {0} triangles that its head promises; it is "
                            "damaged: copy or export it again",
                            head->facets));
    }
    const bool magics = head->rule == ColourRule::Magics;
    // Attributes that are all 0 say nothing; without the flag they are what programs keep there for
    // themselves.
    if (magics ? set : flagged) {
        const ColourDecoder decode(false);
        resizeLarge(mesh.colours, mesh.positions.size());
        for (std::size_t i = 0; i < mesh.colours.size(); ++i)
            mesh.colours[i] = decode(colourOf(attributes[i / 3], *head));
    } else if (magics) {
        stl.colour = head->colour;
    }
    return stl;
}

} // namespace rtcore
