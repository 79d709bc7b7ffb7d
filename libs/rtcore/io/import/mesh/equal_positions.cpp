#include "rtcore/io/import/mesh/equal_positions.h"

#include "rtcore/io/import/mesh/first_of_same.h"

namespace rtcore {

std::vector<std::uint32_t> firstOfEqualPositions(std::span<const Vec3> positions) {
    const auto hashOf = [&](std::uint32_t i) -> std::optional<std::uint64_t> {
        const Vec3 p = withoutTraces(positions[i]);
        return isUsablePosition(p) ? std::optional(hashOfPosition(p)) : std::nullopt;
    };
    return firstOfSame(positions.size(), hashOf, [&](std::uint32_t a, std::uint32_t b) {
        return withoutTraces(positions[a]) == withoutTraces(positions[b]);
    });
}

} // namespace rtcore
