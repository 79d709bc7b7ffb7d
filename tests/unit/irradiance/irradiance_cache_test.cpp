#include "rtcore/irradiance/irradiance_cache.h"

#include "rtcore/simd/instruction_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <random>
#include <vector>

namespace rtcore {
namespace {

constexpr Box3 kBounds{{-1, -1, -1}, {9, 9, 9}};

IrradianceRecord recordAt(Vec3 position, float radius, float light, Vec3 normal = {0, 0, 1}) {
    IrradianceRecord record;
    record.position = position;
    record.radius = radius;
    record.normal = normal;
    record.confidence = 1;
    record.irradiance = Colour{1, 0.5F, 0.25F} * light;
    record.distance = 1;
    return record;
}

Receiver receiverAt(Vec3 position, float pixel = 0.01F, Vec3 normal = {0, 0, 1}) {
    return {position, normal, normal, pixel};
}

IrradianceCache emptyCache() {
    IrradianceCache cache;
    cache.clear(kBounds);
    cache.setGuess({7, 7, 7});
    return cache;
}

ArrivingLight lightAt(const IrradianceCache& cache, const Receiver& receiver) {
    ArrivingLight arriving;
    cache.lookUp({&receiver, 1}, {&arriving, 1});
    return arriving;
}

TEST(IrradianceCache, GuessesWhereThereAreNoRecords) {
    const ArrivingLight light = lightAt(emptyCache(), receiverAt({1, 1, 1}));
    EXPECT_EQ(light.irradiance, (Colour{7, 7, 7}));
    EXPECT_EQ(light.lacking, kDensities - 1);
    EXPECT_EQ(light.weight, 0);
    EXPECT_TRUE(std::isinf(light.distance));
}

TEST(IrradianceCache, ARecordTellsOfThePointsAround) {
    IrradianceCache cache = emptyCache();
    cache.add(recordAt({1, 1, 1}, 0.2F, 3));
    for (const Vec3 near : {Vec3{1, 1, 1}, Vec3{1.1F, 0.9F, 1}, Vec3{1, 1.15F, 1.01F}}) {
        const ArrivingLight light = lightAt(cache, receiverAt(near));
        EXPECT_NEAR(light.irradiance.r, 3, 1e-5);
        EXPECT_NEAR(light.irradiance.g, 1.5F, 1e-5);
        EXPECT_GT(light.weight, 0);
        EXPECT_NEAR(light.distance, 1, 1e-5);
    }
}

TEST(IrradianceCache, ARecordTellsNothingOfOtherFacesNorBeyondItsRadiusOrBehindItsWall) {
    IrradianceCache cache = emptyCache();
    IrradianceRecord record = recordAt({1, 1, 1}, 0.2F, 3);
    record.walls[1] = {{-1, 0, 0}, -1.1F}; // x <= 1.1
    cache.add(record);
    EXPECT_GT(lightAt(cache, receiverAt({1.09F, 1, 1})).weight, 0);
    for (const Receiver& other :
         {receiverAt({1.11F, 1, 1}), receiverAt({0.79F, 1, 1}), receiverAt({1, 1, 1.06F}),
          receiverAt({1, 1, 1}, 0.01F, {0, 0, -1}), receiverAt({1, 1, 1}, 0.01F, {0.8F, 0, 0.6F})})
        EXPECT_EQ(lightAt(cache, other).weight, 0) << other.position.x << ' ' << other.position.z;
}

TEST(IrradianceCache, NearestRecordIsTheGuessWhereNoneFits) {
    IrradianceCache cache = emptyCache();
    cache.add(recordAt({1, 1, 1}, 0.2F, 3));
    cache.add(recordAt({1.3F, 1, 1}, 0.2F, 5));
    const ArrivingLight light = lightAt(cache, receiverAt({1.12F, 1, 1.1F}));
    EXPECT_EQ(light.weight, 0);
    EXPECT_FLOAT_EQ(light.irradiance.r, 3);
}

TEST(IrradianceCache, ShadingNormalsThatLeanSeeLessOfEvenLightFromAbove) {
    IrradianceCache cache = emptyCache();
    cache.add(recordAt({1, 1, 1}, 0.2F, 1));
    for (const float angle : {0.0F, 0.4F, 0.9F, 1.4F}) {
        Receiver receiver = receiverAt({1, 1, 1});
        receiver.normal = {std::sin(angle), 0, std::cos(angle)};
        EXPECT_NEAR(lightAt(cache, receiver).irradiance.r, (1 + std::cos(angle)) / 2, 1e-5) << angle;
    }
}

TEST(IrradianceCache, ShadingNormalsThatLeanTowardsTheLightSeeMore) {
    // A distant light at 45 degrees: slant 1 along x.
    IrradianceCache cache = emptyCache();
    IrradianceRecord record = recordAt({1, 1, 1}, 0.2F, 1);
    record.slant = {1, 0, 0};
    cache.add(record);
    Receiver receiver = receiverAt({1, 1, 1});
    const float angle = 0.02F;
    receiver.normal = {std::sin(angle), 0, std::cos(angle)};
    EXPECT_NEAR(lightAt(cache, receiver).irradiance.r, std::cos(angle) + std::sin(angle), 2e-4);
}

TEST(IrradianceCache, TellsTheCoarsestDensityThatLacks) {
    IrradianceCache cache = emptyCache();
    const Receiver receiver = receiverAt({1, 1, 1}); // pixels of 0.01: fine records have 0.4
    const auto addRadius = [&](float radius) {
        for (int i = 0; i < 2; ++i) cache.add(recordAt({1, 1, 1}, radius, 1));
    };
    addRadius(4);
    EXPECT_EQ(lightAt(cache, receiver).lacking, 2);
    addRadius(2.4F);
    EXPECT_EQ(lightAt(cache, receiver).lacking, 1);
    addRadius(1.2F);
    EXPECT_EQ(lightAt(cache, receiver).lacking, 0);
    addRadius(0.4F);
    EXPECT_EQ(lightAt(cache, receiver).lacking, -1);
}

TEST(IrradianceCache, FineRecordsTakeThePositionOfCoarseOnes) {
    IrradianceCache cache = emptyCache();
    for (int i = 0; i < 2; ++i) cache.add(recordAt({1, 1, 1}, 2.4F, 9));
    EXPECT_NEAR(lightAt(cache, receiverAt({1, 1, 1})).irradiance.r, 9, 1e-4);
    for (int i = 0; i < 2; ++i) cache.add(recordAt({1, 1, 1}, 0.4F, 2));
    EXPECT_NEAR(lightAt(cache, receiverAt({1, 1, 1})).irradiance.r, 2, 1e-4);
}

TEST(IrradianceCache, NewRecordsCoverButTellNothing) {
    IrradianceCache cache = emptyCache();
    for (int i = 0; i < 2; ++i) {
        for (const float radius : {0.4F, 1.2F, 2.4F}) {
            IrradianceRecord record = recordAt({1, 1, 1}, radius, 5);
            record.confidence = 0;
            cache.add(record);
        }
    }
    const ArrivingLight light = lightAt(cache, receiverAt({1, 1, 1}));
    EXPECT_EQ(light.lacking, -1);
    EXPECT_EQ(light.weight, 0);
    EXPECT_EQ(light.irradiance, (Colour{7, 7, 7}));
}

TEST(IrradianceCache, NotesWhichRecordsWereUsed) {
    IrradianceCache cache = emptyCache();
    const auto near = cache.add(recordAt({1, 1, 1}, 0.2F, 1)), far = cache.add(recordAt({2, 1, 1}, 0.2F, 1));
    const Receiver receiver = receiverAt({1, 1, 1});
    ArrivingLight arriving;
    cache.lookUp({&receiver, 1}, {&arriving, 1});
    EXPECT_EQ(cache.lastUse(near), 0U);
    cache.lookUp({&receiver, 1}, {&arriving, 1}, 17);
    EXPECT_EQ(cache.lastUse(near), 17U);
    EXPECT_EQ(cache.lastUse(far), 0U);
}

TEST(IrradianceCache, LooksUpWithoutOneRecord) {
    IrradianceCache cache = emptyCache();
    const auto first = cache.add(recordAt({1, 1, 1}, 0.4F, 1));
    cache.add(recordAt({1.05F, 1, 1}, 0.4F, 3));
    EXPECT_NEAR(cache.lookUpWithout(first, receiverAt({1, 1, 1})).irradiance.r, 3, 1e-5);
}

/// Records on three sides of a box and in it, of all sizes.
class Crowd {
  public:
    explicit Crowd(std::size_t count) : cache(emptyCache()) {
        for (std::size_t i = 0; i < count; ++i) {
            const Site at = site();
            IrradianceRecord record =
                recordAt(at.position, 0.08F * std::exp2(7 * number()), number(), at.normal);
            record.confidence = number() < 0.2F ? 0 : number();
            record.slant = {number() - 0.5F, number() - 0.5F, number() - 0.5F};
            record.distance =
                number() < 0.1F ? std::numeric_limits<float>::infinity() : 0.1F + 4 * number() * number();
            if (number() < 0.3F) {
                const Vec3 wall = site().normal;
                record.walls[number() < 0.5F ? 0 : 1] = {wall, dot(wall, record.position) -
                                                                   number() * record.radius};
            }
            cache.add(record);
        }
    }
    Receiver receiver() {
        const Site at = site();
        Receiver r = receiverAt(at.position, 0.002F + 0.02F * number(), at.normal);
        r.normal = normalize(r.face + Vec3{number() - 0.5F, number() - 0.5F, number() - 0.5F});
        return r;
    }
    /// As pixels beside each other see them.
    std::vector<Receiver> tile() {
        const Receiver first = receiver();
        const auto [across, up] = basisAround(first.face);
        std::vector<Receiver> tile;
        for (int i = 0; i < 64; ++i) {
            tile.push_back(first);
            tile.back().position += across * (first.pixel * static_cast<float>(i % 8)) +
                                    up * (first.pixel * static_cast<float>(i / 8));
            if (i % 5 == 3) tile.back() = receiver(); // an edge of an object
            if (i % 7 == 5) tile.back().pixel = 0;
        }
        return tile;
    }
    float number() { return std::uniform_real_distribution<float>(0, 1)(random_); }

    IrradianceCache cache;

  private:
    struct Site {
        Vec3 position, normal;
    };
    Site site() {
        Vec3 position{4 * number(), 4 * number(), 4 * number()};
        Vec3 normal{number() * 0.2F, number() * 0.2F, number() * 0.2F};
        const int axis = static_cast<int>(number() * 2.999F);
        if (number() < 0.8F) position[axis] = 0.01F * number();
        normal[axis] += 1;
        return {position, normalize(normal)};
    }
    std::mt19937 random_{7};
};

int levelOf(const RecordIndex& index, float radius) {
    int level = 0;
    while (index.side(level) < 2 * radius) ++level;
    return level;
}

/// record_lookup.h word by word, over all records; radii have not shrunk, or to less than 0.7.
ArrivingLight sumOfAll(const IrradianceCache& cache, const Receiver& to) {
    struct Sums {
        double kernel = 0, known = 0, weight = 0, light = 0;
    };
    std::array<Sums, kDensities + 1> sums;
    double distance = 0, kernels = 0;
    const auto covered = [&](int level) {
        const double side = 0.7 / 4 * cache.index().side(level);
        const double fine = sums[0].known, middle = fine + sums[1].known, coarse = middle + sums[2].known;
        if (fine >= 1.5) return true;
        if (middle >= 1.5) return side >= 1.42 * 48 * to.pixel;
        return coarse >= 1.5 && side >= 1.42 * 144 * to.pixel;
    };
    std::vector<std::pair<int, std::uint32_t>> ordered;
    for (std::uint32_t number = 0; number < cache.size(); ++number)
        ordered.emplace_back(levelOf(cache.index(), cache.record(number).radius), number);
    std::ranges::sort(ordered);
    int before = ordered[0].first;
    for (const auto& [level, number] : ordered) {
        if (level != before && covered(before)) break;
        before = level;
        const IrradianceRecord& record = cache.record(number);
        const Vec3 apart = to.position - record.position;
        const double square = dot(apart, apart), r = record.radius, agreement = dot(to.face, record.normal);
        const double off = std::abs(0.5 * dot(apart, to.face + record.normal)) / (0.25 * r);
        if (square >= r * r || agreement <= 0.6 || off >= 1 || !record.walls[0].isBefore(to.position) ||
            !record.walls[1].isBefore(to.position))
            continue;
        const double near = 1 - square / (r * r);
        const double kernel = near * near * (1 - off * off) * (agreement - 0.6) / 0.4;
        std::size_t density = 0;
        while (density < kDensities &&
               record.radius > 1.42F * RecordRadii::of(static_cast<int>(density), record.distance, to.pixel))
            ++density;
        Sums& sum = sums[density];
        const double cosine = dot(record.normal, to.normal);
        const double weight = kernel * record.confidence / (r * r);
        sum.kernel += kernel;
        sum.known += kernel * record.confidence;
        sum.weight += weight;
        sum.light += weight * record.irradiance.r *
                     std::max(0.0, cosine + dot(record.slant, to.normal) + (1 - cosine) / 2);
        distance += kernel * record.distance;
        kernels += kernel;
    }
    ArrivingLight result;
    Sums so;
    double rest = 1, light = 0;
    for (std::size_t density = 0; density <= kDensities; ++density) {
        so.kernel += sums[density].kernel;
        so.known += sums[density].known;
        so.weight += sums[density].weight;
        so.light += sums[density].light;
        if (density < kDensities && so.kernel < 1) result.lacking = static_cast<std::int8_t>(density);
        if (so.weight == 0) continue;
        const double part = density < kDensities ? std::min(1.0, 1.5 * so.known) : 1;
        light += rest * part * so.light / so.weight;
        rest *= 1 - part;
    }
    result.irradiance.r = static_cast<float>(light);
    result.weight = static_cast<float>(so.weight);
    return result;
}

TEST(IrradianceCache, IsTheSumOverAllRecordsThatTellSomething) {
    Crowd crowd(4000);
    int known = 0, fine = 0;
    for (int i = 0; i < 600; ++i) {
        const Receiver receiver = crowd.receiver();
        const ArrivingLight light = lightAt(crowd.cache, receiver),
                            expected = sumOfAll(crowd.cache, receiver);
        EXPECT_EQ(light.lacking, expected.lacking);
        if (expected.weight == 0) continue;
        ++known;
        fine += expected.lacking < 0 ? 1 : 0;
        EXPECT_NEAR(light.irradiance.r, expected.irradiance.r, 1e-4F * (1 + expected.irradiance.r));
    }
    EXPECT_GT(known, 400);
    EXPECT_GT(fine, 50);
}

bool sameBits(const ArrivingLight& a, const ArrivingLight& b) {
    const auto same = [](float x, float y) {
        return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
    };
    return same(a.irradiance.r, b.irradiance.r) && same(a.irradiance.g, b.irradiance.g) &&
           same(a.irradiance.b, b.irradiance.b) && a.lacking == b.lacking && same(a.distance, b.distance) &&
           same(a.weight, b.weight);
}

TEST(IrradianceCache, TheSameBitsAloneTogetherAndByEveryInstructionSet) {
    Crowd crowd(4000);
    std::vector<Receiver> receivers;
    for (int i = 0; i < 12; ++i) {
        const std::vector<Receiver> tile = crowd.tile();
        receivers.insert(receivers.end(), tile.begin(), tile.end());
    }
    receivers.pop_back();
    std::vector<ArrivingLight> alone(receivers.size()), together(receivers.size());
    for (std::size_t i = 0; i < receivers.size(); ++i) alone[i] = lightAt(crowd.cache, receivers[i]);
    for (const std::string& name : instructionSets()) {
        ASSERT_TRUE(useInstructionSet(name));
        crowd.cache.lookUp(receivers, together);
        for (std::size_t i = 0; i < receivers.size(); ++i)
            EXPECT_TRUE(sameBits(alone[i], together[i])) << name << ' ' << i;
    }
    useInstructionSet("auto");
}

TEST(IrradianceCache, IsAsRightWhereRadiiHaveShrunk) {
    Crowd crowd(1500);
    for (std::uint32_t number = 0; number < crowd.cache.size(); ++number) {
        if (number % 3 != 0)
            crowd.cache.shrink(number, crowd.cache.record(number).radius * 0.69F * crowd.number());
    }
    crowd.cache.shrink(0, 100); // never larger
    for (int i = 0; i < 300; ++i) {
        const Receiver receiver = crowd.receiver();
        const ArrivingLight light = lightAt(crowd.cache, receiver),
                            expected = sumOfAll(crowd.cache, receiver);
        EXPECT_EQ(light.lacking, expected.lacking);
        if (expected.weight == 0) continue;
        EXPECT_NEAR(light.irradiance.r, expected.irradiance.r, 1e-4F * (1 + expected.irradiance.r));
    }
}

TEST(IrradianceCache, HasTheSameBitsHoweverItCameAbout) {
    // Radii have shrunk in another order, records came and went, and all was restored.
    Crowd crowd(1500), other(1500);
    const auto count = static_cast<std::uint32_t>(crowd.cache.size());
    const auto shrink = [](IrradianceCache& cache, std::uint32_t number) {
        cache.shrink(number, cache.record(number).radius * (0.2F + 0.1F * static_cast<float>(number % 8)));
    };
    for (std::uint32_t number = 0; number < count; ++number) shrink(crowd.cache, number);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t number = i * 7 % count;
        if (i % 3 == 0) other.cache.add(recordAt({other.number(), other.number(), 0}, 30, 1));
        shrink(other.cache, number);
        if (i % 3 == 0) other.cache.removeLast(1);
    }
    IrradianceCache restored;
    restored.restore(kBounds, crowd.cache.state());
    EXPECT_EQ(restored.state(), crowd.cache.state());
    EXPECT_EQ(other.cache.state(), crowd.cache.state());
    EXPECT_EQ(other.cache.index().levels(), crowd.cache.index().levels());
    EXPECT_EQ(restored.index().levels(), crowd.cache.index().levels());
    for (int i = 0; i < 1000; ++i) {
        const Receiver receiver = crowd.receiver();
        const ArrivingLight light = lightAt(crowd.cache, receiver);
        EXPECT_TRUE(sameBits(light, lightAt(other.cache, receiver)));
        EXPECT_TRUE(sameBits(light, lightAt(restored, receiver)));
    }
}

TEST(IrradianceCache, KeepsSomeRecordsAsTheyAre) {
    Crowd crowd(1500);
    std::vector<std::uint8_t> kept;
    std::vector<IrradianceRecord> left;
    for (std::uint32_t number = 0; number < crowd.cache.size(); ++number) {
        kept.push_back(number % 5 < 2 ? 1 : 0);
        crowd.cache.use(number, number);
        if (kept.back() != 0) left.push_back(crowd.cache.record(number));
    }
    crowd.cache.keep(kept);
    ASSERT_EQ(crowd.cache.size(), left.size());
    for (std::uint32_t number = 0; number < left.size(); ++number) {
        EXPECT_EQ(crowd.cache.record(number).position, left[number].position);
        EXPECT_EQ(crowd.cache.lastUse(number), number / 2 * 5 + number % 2);
    }
    for (int i = 0; i < 200; ++i) {
        const Receiver receiver = crowd.receiver();
        EXPECT_EQ(lightAt(crowd.cache, receiver).lacking, sumOfAll(crowd.cache, receiver).lacking);
    }
}

TEST(IrradianceCache, TakesAnyNumbers) {
    Crowd crowd(200);
    const float infinite = std::numeric_limits<float>::infinity(),
                none = std::numeric_limits<float>::quiet_NaN();
    for (const float odd : {infinite, -infinite, none, 1e30F, -1e38F}) {
        Receiver receiver = receiverAt({odd, 1, odd});
        EXPECT_EQ(lightAt(crowd.cache, receiver).weight, 0);
        receiver = receiverAt({1, 1, 0}, odd);
        lightAt(crowd.cache, receiver);
        crowd.cache.add(recordAt({odd, 0, 1}, 0.3F, 1));
        crowd.cache.add(recordAt({1, 0, 1}, std::fabs(odd), 1));
    }
}

TEST(IrradianceCache, IsSmall) {
    IrradianceCache cache = emptyCache();
    for (int y = 0; y < 200; ++y) {
        for (int x = 0; x < 200; ++x)
            cache.add(recordAt({0.04F * static_cast<float>(x), 0.04F * static_cast<float>(y), 0}, 0.08F, 1));
    }
    EXPECT_LT(cache.memory(), cache.size() * 600);
}

} // namespace
} // namespace rtcore
