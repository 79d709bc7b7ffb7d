// Each formula gives the same bits for one number and in every lane of every instruction set, whatever it is
// given: also infinite, denormal and no numbers. RT_FORMULA_INPUTS: how many inputs, instead of some
// thousands.
#include "rtcore/simd/instruction_set.h"

#include "support/random_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "unit/simd/formulas_test.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/lights/emitters-inl.h"
#include "rtcore/lights/environment_sampler-inl.h"
#include "rtcore/lights/light_direction-inl.h"
#include "rtcore/math/octahedron-inl.h"
#include "rtcore/math/triangle-inl.h"
#include "rtcore/post/tone_map-inl.h"
#include "rtcore/sampling/alias-inl.h"
#include "rtcore/sampling/disc-inl.h"
#include "rtcore/sampling/owen-inl.h"
#include "rtcore/scattering/coat-inl.h"
#include "rtcore/scattering/fresnel-inl.h"
#include "rtcore/scattering/metallic-inl.h"
#include "rtcore/scattering/phong_scattering-inl.h"
#include "rtcore/shading/surface/texture-inl.h"

#ifndef RT_TESTS_FORMULAS_
#define RT_TESTS_FORMULAS_
namespace rtcore {

/// The largest numbers of inputs and outputs of the formulas of one kind.
inline constexpr std::size_t kInputs = 16, kOutputs = 8 * kLightKinds;
/// Numbers that are worked on at once.
inline constexpr std::size_t kBlock = 64;
using Columns = std::array<std::array<float, kBlock>, std::max(kInputs, kOutputs)>;

enum class Formulas {
    Scattering,
    Mirrors,
    Lights,
    AreaLights,
    Triangles,
    Pictures,
    Shapes,
    Powers,
    Textures,
    Numbers,
    LightDirections,
    Directions,
    EmittingTriangles,
    Matte,
    Microfacets,
    Metals,
    PhongPaths
};
inline constexpr Formulas kFormulas[] = {
    Formulas::Scattering,        Formulas::Mirrors,  Formulas::Lights,          Formulas::AreaLights,
    Formulas::Triangles,         Formulas::Pictures, Formulas::Shapes,          Formulas::Powers,
    Formulas::Textures,          Formulas::Numbers,  Formulas::LightDirections, Formulas::Directions,
    Formulas::EmittingTriangles, Formulas::Matte,    Formulas::Microfacets,     Formulas::Metals,
    Formulas::PhongPaths};

inline const AliasTable& someTable() {
    static const AliasTable table(std::vector<double>{3, 0, 1, 0.125, 7});
    return table;
}

inline HdrImage someTexels(int width, int height) {
    HdrImage image(width, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = {static_cast<float>(i * i % 7), 1, static_cast<float>(i % 3)};
    return image;
}
/// A sampler of an image of the sphere, or of a cube's faces.
inline EnvironmentSampler samplerOf(Environment environment) {
    environment.turn(33, {0, 0.6F, 0.8F});
    EnvironmentSampler sampler;
    sampler.prepare({&environment, {}, TexelFilter::Bilinear});
    return sampler;
}
inline EnvironmentRows someDirections(bool cube) {
    static const EnvironmentSampler ofSphere =
        samplerOf(Environment::fromEquirectangular(someTexels(5, 3), ""));
    static const EnvironmentSampler ofCube = [] {
        std::array<HdrImage, 6> faces;
        faces.fill(someTexels(3, 3));
        return samplerOf(Environment::fromCube(faces, ""));
    }();
    return (cube ? ofCube : ofSphere).rows();
}
inline EmitterRows someTriangles() {
    static constexpr std::uint32_t kNumbers[] = {1, 0, 4, 2, 3};
    static constexpr std::uint32_t kCorners[] = {0, 1, 2, 1, 2, 3, 3, 2, 0, 4, 1, 0, 2, 3, 4};
    static constexpr float kVertices[] = {0, 0.5F, 1,  0, 2,    -1, 0.25F, 0, 3, 1,
                                          1, 0,    -1, 2, 0.1F, 0,  1,     1, 4, 0};
    return {someTable().rows(), kNumbers, kCorners, kVertices};
}

inline Light lightOf(LightKind kind) {
    Light light;
    light.kind = kind;
    light.position = {0.25F, 1, -0.5F};
    light.direction = {0.6F, -0.8F, 0};
    light.right = {0, 0, 1};
    light.width = 0.5F;
    light.height = 0.75F;
    light.intensity = {10, 7, 10};
    light.radius = 0.125F;
    light.cosInner = 0.9F;
    light.cosOuter = 0.3F;
    if (kind == LightKind::Ies)
        light.photometry =
            keepPhotometry({{0, 15, 60, 90}, {0, 70, 360}, {9, 8, 5, 0, 9, 2, 4, 0, 9, 8, 5, 0}});
    return light;
}

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

HWY_INLINE float asNumber(bool a) { return a ? 1 : 0; }
HWY_INLINE Float asNumber(Mask a) { return selectOrZero(a, Float(1)); }
HWY_INLINE float asNumber(std::int32_t a) { return std::bit_cast<float>(a); }
HWY_INLINE Float asNumber(Int a) { return floatOf(a); }
HWY_INLINE float asNumber(std::uint32_t a) { return std::bit_cast<float>(a); }
HWY_INLINE Float asNumber(Uint a) { return floatOf(a); }

/// Collects what formulas give.
template <typename F>
struct Results {
    F values[kOutputs];
    std::size_t count = 0;

    HWY_INLINE void add(F value) { values[count++] = value; }
    HWY_INLINE void add(Vec3Of<F> v) { add(v.x), add(v.y), add(v.z); }
    HWY_INLINE void add(const LightSample<F>& s) {
        add(s.toLight), add(s.irradiance), add(s.free), add(s.spread);
    }
};

/// Samples of a light, and how the ray of the direction `d` meets it.
template <LightKind kind, typename F>
HWY_INLINE void addLightDirection(Vec3Of<F> position, Vec3Of<F> d, F u, F v, Results<F>& out) {
    const Light light = lightOf(kind);
    const LightDirectionSample<F> sample = sampleLightDirection<kind, F>(light, position, u, v);
    out.add(sample.toLight), out.add(sample.free), out.add(sample.irradiance), out.add(sample.density);
    const F distance = hitLight<kind, F>(light, position, d);
    out.add(distance);
    out.add(sampleDensity<kind, F>(light, position, d, distance));
    out.add(lightDirectionDensity<kind, F>(light, position, d, distance));
}

/// Adds the light that each kind of light sends to `position`; of area lights, the stratum with these u, v.
template <std::size_t i = 0, typename F>
HWY_INLINE void addLights(bool areaLights, Vec3Of<F> position, F u, F v, Results<F>& out) {
    if constexpr (i < kLightKinds) {
        constexpr auto kind = static_cast<LightKind>(i);
        if constexpr (isAreaLight(kind)) {
            if (areaLights) out.add(sampleLight<kind, F>(lightOf(kind), position, {u, v, 0.25F, 0.125F}));
        } else {
            if (!areaLights) out.add(sampleLight<kind, F>(lightOf(kind), position));
        }
        addLights<i + 1, F>(areaLights, position, u, v, out);
    }
}

template <typename F>
HWY_INLINE void addTaps(const Taps<F>& taps, Results<F>& out) {
    out.add(asNumber(taps.first));
    out.add(asNumber(taps.second));
    out.add(taps.fraction);
}

template <typename F>
HWY_INLINE void calculate(Formulas formulas, const F* x, Results<F>& out) {
    const Vec3Of<F> a{x[0], x[1], x[2]}, b{x[3], x[4], x[5]}, c{x[6], x[7], x[8]};
    switch (formulas) {
    case Formulas::Scattering: {
        out.add(roughLobe<F>(x[9], x[10], x[11]));
        out.add(terminatorFactor<F>(a, b, x[9], x[10]));
        F shininess = x[12], scale = x[13];
        widenLobe<F>(x[14], shininess, scale);
        out.add(shininess);
        out.add(scale);
        break;
    }
    case Formulas::Mirrors:
        out.add(fresnelSchlick<F>(a, x[9]));
        out.add(mirrorDirection<F>(a, b, c));
        break;
    case Formulas::Lights:
        addLights<0, F>(false, a, x[14], x[15], out);
        break;
    case Formulas::AreaLights: // u, v in [0, 1)
        addLights<0, F>(true, a, x[14], x[15], out);
        break;
    case Formulas::Triangles: {
        const Corners<F> corners{a, b, c};
        out.add(interpolate<F>(corners, x[9], x[10]));
        out.add(normalOf<F>(corners));
        out.add(asNumber(normalsBehind<F>(corners, a)));
        out.add(surfaceClearance<F>(corners, b));
        break;
    }
    case Formulas::Pictures:
        out.add(toneMapChannels<F>(a, max(abs(x[9]), F(1e-30F))));
        out.add(toneMapLuminance<F>(b, max(abs(x[9]), F(1e-30F))));
        out.add(asNumber(chordOf<F>(x[10])));
        out.add(srgbCode<F>(x[10], x[11], x[12]));
        out.add(ditherThreshold<F>(x[14] * 30000.0F, 17));
        out.add(asNumber(quantise<F>(x[13], F(0.25F))));
        break;
    case Formulas::Shapes: {
        const auto disc = onDisc<F>(x[14], x[15]);
        out.add(disc.x);
        out.add(disc.y);
        const auto turn = unitCircle<F>(x[14]);
        out.add(turn.cosine);
        out.add(turn.sine);
        out.add(aroundAxis<F>(a, turn));
        out.add(smoothstep<F>(x[9]));
        break;
    }
    case Formulas::Powers: // of cosines above 0 and exponents of at least 1
        out.add(phongLobe<F>(max(x[14], F(1e-6F)), 1.0F + x[15] * 100000.0F, x[9]));
        break;
    case Formulas::Textures:
        addTaps<F>(tapsAt<true, F>(x[9], 37U, 0U), out);
        for (const std::uint32_t wrap : {0U, 1U, 2U}) addTaps<F>(tapsAt<false, F>(x[9], 37U, wrap), out);
        break;
    case Formulas::LightDirections: // u, v in [0, 1)
        addLightDirection<LightKind::Sphere, F>(a, b, x[14], x[15], out);
        addLightDirection<LightKind::Rectangle, F>(a, b, x[14], x[15], out);
        addLightDirection<LightKind::Spot, F>(a, b, x[14], x[15], out);
        break;
    case Formulas::Directions: {
        for (const bool cube : {false, true}) {
            const EnvironmentSample<F> sample =
                sampleEnvironment<F>(someDirections(cube), bitsOf(x[9]), bitsOf(x[10]));
            out.add(sample.direction), out.add(sample.density);
            const auto point = environmentPoint<F>(someDirections(cube), a);
            out.add(point.density);
            out.add(asNumber(toUint(point.across))), out.add(asNumber(toUint(point.down)));
        }
        out.add(octahedronDirection<F>(x[14], x[15]));
        out.add(fastAtan2<F>(x[10], x[11]));
        const auto circle = fastCircle<F>(x[12]);
        out.add(circle.cosine), out.add(circle.sine);
        break;
    }
    case Formulas::EmittingTriangles: {
        const EmitterSample<F> sample = sampleEmitter<F>(someTriangles(), x[14], x[15], bitsOf(x[9]));
        out.add(asNumber(sample.triangle)), out.add(sample.u), out.add(sample.v), out.add(sample.position);
        out.add(sample.normal), out.add(sample.density);
        out.add(bySolidAngle<F>(x[10], x[11], x[12]));
        break;
    }
    case Formulas::Numbers: {
        const auto name = nameOfPixel(bitsOf(x[9]), bitsOf(x[10]));
        const auto use = (bitsOf(x[11]) & UintOf<F>(0xFFFU)) | UintOf<F>(useBits(SampleDimension::Lobe, 0));
        const auto point = pointInSequence<F>(name, bitsOf(x[12]), use);
        out.add(point.u);
        out.add(point.v);
        const auto index = sampleIndex<F>(someTable().rows(), bitsOf(x[13]));
        out.add(asNumber(index));
        out.add(probabilityOf<F>(someTable().rows(), index));
        break;
    }
    case Formulas::Matte:
        out.add(lambertDensity<F>(x[9]));
        out.add(sampleLambert<F>(a, {x[14], x[15]}));
        break;
    case Formulas::Microfacets: {
        const F alpha = ggxAlpha<F>(x[9]);
        const auto viewer = liftedViewer<F>(b, a);
        out.add(viewer);
        const auto scattering = scatterGgx<F>(a, viewer, c, alpha);
        out.add(scattering.lobe);
        out.add(scattering.density);
        out.add(scattering.fresnelCosine);
        out.add(sampleGgx<F>(a, viewer, alpha, {x[14], x[15]}));
        const auto albedo = ggxAlbedo<F>(ggxAlbedoTable(), x[10], x[9]);
        out.add(albedo.straight);
        out.add(albedo.grazing);
        break;
    }
    case Formulas::Metals: { // also of both lobes in one vector
        const auto lobes =
            metallicLobes<F>(ggxAlbedoTable(), a, x[9], x[10], {F(0.04F), F(0.04F), F(0.04F)}, x[11]);
        out.add(lobes.diffuse);
        out.add(lobes.straight);
        out.add(lobes.grazing);
        out.add(lobes.further);
        out.add(glossProbability<F>(lobes));
        const auto scattering = scatterMetallic<F>(lobes, b, c, a);
        out.add(scattering.reflectance);
        out.add(scattering.density);
        out.add(sampleMetallic<F>(lobes, b, c, x[13], {x[14], x[15]}));
        const auto coat = coatLobe<F>(ggxAlbedoTable(), x[9], x[10], x[11]);
        out.add(coat.albedo);
        out.add(scatterCoat<F>(coat, b, c, a).reflectance);
        out.add(coatProbability<F>(coat.albedo, lobes.diffuse));
        break;
    }
    case Formulas::PhongPaths: { // cosines of unit vectors, as pow() asks for
        const F length = max(abs(x[3]) + abs(x[4]) + abs(x[5]), F(1)) * F(2);
        const auto ordinary = isFinite(length) & isFinite(c.x) & isFinite(c.y) & isFinite(c.z);
        const auto toLight = selectOrZero(ordinary, b / length);
        const auto toViewer = selectOrZero(ordinary, c / max(abs(c.x) + abs(c.y) + abs(c.z), F(1)));
        const PhongLobes<F> lobes{b, c, 1.0F + x[15] * 1000.0F, x[9], x[10]};
        const auto scattering = scatterPhong<F>(lobes, broadcast<F>(Vec3{0, 0.6F, 0.8F}), toViewer, toLight);
        out.add(scattering.reflectance);
        out.add(scattering.density);
        out.add(samplePhongScattering<F>(lobes, broadcast<F>(Vec3{0, 0.6F, 0.8F}), toViewer, x[13],
                                         {x[14], x[15]}));
        break;
    }
    }
}

std::size_t calculateBlock(Formulas formulas, const Columns& in, Columns& out) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < kBlock; i += lanes()) {
        Float x[kInputs];
        for (std::size_t k = 0; k < kInputs; ++k) x[k] = load(&in[k][i]);
        Results<Float> results;
        calculate<Float>(formulas, x, results);
        count = results.count;
        for (std::size_t k = 0; k < count; ++k) store(results.values[k], &out[k][i]);
    }
    return count;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(calculateBlock);

namespace {

/// As often an ordinary number as any at all; the last two are in [0, 1).
Columns randomColumns(test::Random& random) {
    Columns in;
    for (std::size_t k = 0; k < kInputs; ++k) {
        for (float& x : in[k]) {
            const bool ordinary = random.coin();
            const auto bits = static_cast<std::uint32_t>(random.index(std::size_t{1} << 32U));
            x = ordinary ? random.number(-2, 2) : std::bit_cast<float>(bits);
            if (random.index(50) == 0) x = 0;
            if (random.index(200) == 0) x = std::numeric_limits<float>::quiet_NaN();
            if (random.index(200) == 0) x = std::numeric_limits<float>::infinity();
            if (k >= kInputs - 2) x = random.number(0, 0.9999999F);
        }
    }
    return in;
}

bool sameBits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) ||
           (std::isnan(a) && std::isnan(b));
}

TEST(Formulas, GiveTheSameBitsForOneNumberAndInEveryLane) {
    const char* const wanted = std::getenv("RT_FORMULA_INPUTS");
    const std::size_t inputs = wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 20000;
    for (const std::string& name : instructionSets()) {
        ASSERT_TRUE(useInstructionSet(name));
        test::Random random(1);
        for (std::size_t done = 0; done < inputs; done += kBlock) {
            const Columns in = randomColumns(random);
            for (const Formulas formulas : kFormulas) {
                Columns out;
                const std::size_t count = HWY_DYNAMIC_DISPATCH(calculateBlock)(formulas, in, out);
                ASSERT_GT(count, 0U);
                for (std::size_t i = 0; i < kBlock; ++i) {
                    float x[kInputs];
                    for (std::size_t k = 0; k < kInputs; ++k) x[k] = in[k][i];
                    HWY_NAMESPACE::Results<float> expected;
                    HWY_NAMESPACE::calculate<float>(formulas, x, expected);
                    for (std::size_t k = 0; k < count; ++k) {
                        ASSERT_TRUE(sameBits(out[k][i], expected.values[k]))
                            << name << ", formulas " << static_cast<int>(formulas) << ", result " << k << ": "
                            << out[k][i] << " is not " << expected.values[k] << "; input "
                            << testing::PrintToString(x);
                    }
                }
            }
        }
    }
    useInstructionSet("auto");
}

} // namespace
} // namespace rtcore
#endif
