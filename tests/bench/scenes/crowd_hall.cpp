#include "bench/scenes/crowd_hall.h"

#include "rtcore/math/constants.h"
#include "rtcore/simd/portable_math.h"
#include "support/random_numbers.h"

#include <cstdint>

namespace bench {

namespace {

using rtcore::Vec3;
using test::SampleMesh;

constexpr float kLength = 30, kHeight = 6, kWidth = 12; ///< of the hall
constexpr float kSlender = 1500;                        ///< strips are so many times as long as wide

// --- A figure ---

/// A tube with rounded ends around the way from `from` to `to`, thickest in its middle, with folds along it
/// as cloth has them: 2 * rings * slices triangles.
struct Limb {
    Vec3 from, to;
    float thin, thick; ///< radii at the ends and in the middle
    std::uint32_t rings, slices;
    float folds = 0; ///< their depth, of the radius
};

void addLimb(SampleMesh& mesh, const Limb& limb) {
    const Vec3 way = limb.to - limb.from;
    const rtcore::Basis side = rtcore::basisAround(normalize(way));
    const std::uint32_t first = mesh.addVertex(limb.from);
    for (std::uint32_t ring = 0; ring < limb.rings; ++ring) {
        const float along = (static_cast<float>(ring) + 0.5F) / static_cast<float>(limb.rings);
        const float belly = rtcore::portableSin(rtcore::kPi * along);
        const float end = along < 0.5F ? along : 1 - along;
        constexpr float kRound = 0.08F; // of the length, at each end
        const float rounding = end < kRound ? std::sqrt(end * (2 * kRound - end)) / kRound : 1;
        for (std::uint32_t slice = 0; slice < limb.slices; ++slice) {
            const float angle = 2 * rtcore::kPi * static_cast<float>(slice) / static_cast<float>(limb.slices);
            const float fold = 1 + limb.folds * rtcore::portableSin(9 * angle + 5 * along);
            const float radius = (limb.thin + (limb.thick - limb.thin) * belly) * rounding * fold;
            mesh.addVertex(limb.from + way * along + side.tangent * (radius * rtcore::portableCos(angle)) +
                           side.bitangent * (radius * rtcore::portableSin(angle)));
        }
    }
    const std::uint32_t last = mesh.addVertex(limb.to);
    const auto at = [&](std::uint32_t ring, std::uint32_t slice) {
        return first + 1 + ring * limb.slices + slice % limb.slices;
    };
    for (std::uint32_t slice = 0; slice < limb.slices; ++slice) {
        mesh.triangles.push_back({{first, at(0, slice + 1), at(0, slice)}});
        for (std::uint32_t ring = 0; ring + 1 < limb.rings; ++ring)
            mesh.addQuad(at(ring, slice), at(ring, slice + 1), at(ring + 1, slice + 1), at(ring + 1, slice));
        mesh.triangles.push_back({{at(limb.rings - 1, slice), at(limb.rings - 1, slice + 1), last}});
    }
}

/// 1.8 high, on the origin, looking along z; 20,000 triangles.
SampleMesh figure(test::Random& random) {
    const auto sway = [&] { return random.number(-0.06F, 0.06F); };
    SampleMesh mesh;
    addLimb(mesh, {{0, 0.82F, 0}, {sway() * 0.5F, 1.5F, sway() * 0.5F}, 0.13F, 0.21F, 60, 80, 0.05F});
    addLimb(mesh, {{0, 1.5F, 0.01F}, {0, 1.8F, 0.02F}, 0.07F, 0.105F, 30, 40});
    for (const float side : {-1.0F, 1.0F}) {
        const Vec3 hand{side * (0.3F + sway()), 0.85F + sway(), 0.15F + 2 * sway()};
        addLimb(mesh, {{side * 0.18F, 1.45F, 0}, hand, 0.045F, 0.06F, 40, 25, 0.08F});
        addLimb(mesh, {{side * 0.1F, 0.9F, 0}, {side * 0.11F, 0, sway()}, 0.06F, 0.09F, 40, 25, 0.06F});
    }
    return mesh;
}

void addCrowd(SampleMesh& mesh) {
    constexpr int kColumns = 10, kRows = 5;
    constexpr float kApart = 0.62F;
    test::Random random(3);
    const Vec3 corner{kLength / 2 - kApart * kColumns / 2, 0, kWidth / 2 - kApart * kRows / 2};
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            const float turned = random.number(0, 2 * rtcore::kPi), tall = random.number(0.88F, 1.1F);
            const float sine = rtcore::portableSin(turned), cosine = rtcore::portableCos(turned);
            const Vec3 place =
                corner + Vec3{static_cast<float>(column) * kApart + random.number(-0.1F, 0.1F), 0.03F,
                              static_cast<float>(row) * kApart + random.number(-0.1F, 0.1F)};
            mesh.append(figure(random).map([&](Vec3 p) {
                return place + Vec3{cosine * p.x + sine * p.z, p.y, cosine * p.z - sine * p.x} * tall;
            }));
        }
    }
}

// --- The hall ---

/// `count` strips side by side, the first from `corner` along `length`; each next one is `across` further,
/// and reaches to it, but for what `raised` lifts every second one.
void addStrips(SampleMesh& mesh, Vec3 corner, Vec3 length, Vec3 across, Vec3 raised, int count) {
    for (int i = 0; i < count; ++i) {
        const Vec3 start = corner + across * static_cast<float>(i) + (i % 2 == 0 ? Vec3{} : raised);
        const std::uint32_t a = mesh.addVertex(start);
        mesh.addVertex(start + length);
        mesh.addVertex(start + length + across);
        mesh.addVertex(start + across);
        mesh.addQuad(a, a + 1, a + 2, a + 3);
    }
}

int stripsIn(float width, float length) { return static_cast<int>(width * kSlender / length); }

void addShell(SampleMesh& mesh) {
    constexpr float kAlong = kLength / kSlender, kAcross = kWidth / kSlender, kRaised = 0.002F;
    const Vec3 along{kLength, 0, 0}, across{0, 0, kWidth};
    const int wide = stripsIn(kWidth, kLength), high = stripsIn(kHeight, kLength),
              end = stripsIn(kHeight, kWidth);
    addStrips(mesh, {0, 0, 0}, along, {0, 0, kAlong}, {0, kRaised, 0}, wide);
    addStrips(mesh, {0, kHeight, 0}, along, {0, 0, kAlong}, {0, -kRaised, 0}, wide);
    addStrips(mesh, {0, 0, 0}, along, {0, kAlong, 0}, {0, 0, kRaised}, high);
    addStrips(mesh, {0, 0, kWidth}, along, {0, kAlong, 0}, {0, 0, -kRaised}, high);
    addStrips(mesh, {0, 0, 0}, across, {0, kAcross, 0}, {kRaised, 0, 0}, end);
    addStrips(mesh, {kLength, 0, 0}, across, {0, kAcross, 0}, {-kRaised, 0, 0}, end);
}

/// Blinds before both long walls: tilted slats, a hand's breadth apart.
void addBlinds(SampleMesh& mesh) {
    constexpr float kSlat = kLength / kSlender;
    for (int i = 0; i < 100; ++i) {
        const float y = 1 + 0.035F * static_cast<float>(i);
        addStrips(mesh, {0, y, 0.2F}, {kLength, 0, 0}, {0, 0.6F * kSlat, 0.8F * kSlat}, {}, 1);
        addStrips(mesh, {0, y, kWidth - 0.2F}, {kLength, 0, 0}, {0, 0.6F * kSlat, -0.8F * kSlat}, {}, 1);
    }
}

/// Benches of fine slats, with backs: rows of them on both sides of the crowd.
void addBenches(SampleMesh& mesh) {
    constexpr float kBench = 4, kSlat = kBench / kSlender, kDeep = 0.4F, kSeat = 0.45F;
    const int slats = stripsIn(kDeep, kBench);
    for (int i = 0; i < 12; ++i) {
        const Vec3 corner{1.5F + 4.6F * static_cast<float>(i % 6), kSeat, i < 6 ? 2.2F : kWidth - 2.6F};
        const Vec3 length{kBench, 0, 0};
        addStrips(mesh, corner, length, {0, 0, kSlat}, {0, -0.01F, 0}, slats);
        addStrips(mesh, corner, length, {0, kSlat, 0}, {0, 0, 0.01F}, slats);
    }
}

} // namespace

SampleMesh crowdInHall() {
    SampleMesh mesh;
    addShell(mesh);
    addBlinds(mesh);
    addBenches(mesh);
    addCrowd(mesh);
    return mesh;
}

} // namespace bench
