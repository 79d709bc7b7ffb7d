// Rays that leave surfaces: do they hit what they leave, do they pass what touches it, do trees matter?
// Triangles from 1 : 1 to 1 : 100,000. RT_LEAVING_RAYS sets how many rays are traced in all (2,000,000 unless
// told; 1,000,000,000 in the long check), by single rays and by waves of each instruction set in turn.
#include "rtcore/accel/builder.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/kernels/single_ray.h"
#include "rtcore/math/triangle.h"
#include "rtcore/simd/instruction_set.h"
#include "support/sample_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

using rtcore::KdRayTracer;
using rtcore::LeafRecords;
using rtcore::Mesh;
using rtcore::Ray;
using rtcore::Vec3;
using test::Random;
using test::SampleMesh;

namespace {

// Products of three differences of floats are exact in it, nearly.
#ifdef __SIZEOF_FLOAT128__
using Exact = __float128;
#else
using Exact = long double; // as long, where it is no name of its own
static_assert(std::numeric_limits<Exact>::digits == 113);
#endif

std::uint64_t allRays() {
    const char* const text = std::getenv("RT_LEAVING_RAYS");
    const long long count = text != nullptr ? std::atoll(text) : 0;
    return count > 0 ? static_cast<std::uint64_t>(count) : 2'000'000;
}

constexpr float kLength = 1000;
constexpr float kRatios[] = {1, 10, 100, 333, 1500, 10'000, 100'000};
constexpr float kOffsets[] = {0, 100, 10'000};
enum class Form { Pair, Strip, Fan, Doubled, Beam };
constexpr Form kForms[] = {Form::Pair, Form::Strip, Form::Fan, Form::Doubled, Form::Beam};

/// Flat and of `width`, but for the beam: a closed one of square section.
SampleMesh shapeOf(Form form, float width) {
    SampleMesh mesh;
    const auto quad = [&](Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
        const std::uint32_t first = mesh.addVertex(a);
        mesh.addVertex(b);
        mesh.addVertex(c);
        mesh.addVertex(d);
        mesh.addQuad(first, first + 1, first + 2, first + 3);
    };
    switch (form) {
    case Form::Pair:
    case Form::Doubled:
        for (int i = 0; i < (form == Form::Pair ? 1 : 2); ++i) {
            quad({0, 0, 0}, {kLength, 0, 0}, {kLength, 0, width}, {0, 0, width});
        }
        break;
    case Form::Strip:
        for (int i = 0; i < 6; ++i) {
            const float z = width * static_cast<float>(i);
            quad({0, 0, z}, {kLength, 0, z}, {kLength, 0, z + width}, {0, 0, z + width});
        }
        break;
    case Form::Fan:
        for (int i = 0; i < 6; ++i) {
            const float z = width * static_cast<float>(i);
            mesh.addTriangle({0, 0, 0}, {kLength, 0, z}, {kLength, 0, z + width});
        }
        break;
    case Form::Beam:
        mesh = test::boxGrid(1);
        mesh.map([=](Vec3 p) { return Vec3{p.x * kLength / 2, p.y * width / 2, p.z * width / 2}; });
        break;
    }
    return mesh;
}

struct ExactVec {
    Exact x, y, z;
};
ExactVec differenceOf(Vec3 a, Vec3 b) { return {Exact{a.x} - b.x, Exact{a.y} - b.y, Exact{a.z} - b.z}; }
ExactVec crossOf(const ExactVec& a, const ExactVec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Exact dotOf(const ExactVec& a, const ExactVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// A triangle's plane, of a normal twice as long as its area.
struct ExactPlane {
    ExactPlane(const Mesh& mesh, std::uint32_t triangle)
        : point(mesh.position(triangle, 0)),
          normal(crossOf(differenceOf(mesh.position(triangle, 1), point),
                         differenceOf(mesh.position(triangle, 2), point))) {
        length = std::sqrt(static_cast<double>(dotOf(normal, normal)));
    }
    double heightOf(Vec3 p) const {
        return static_cast<double>(dotOf(normal, differenceOf(p, point))) / length;
    }
    double slopeOf(Vec3 d) const { return static_cast<double>(dotOf(normal, differenceOf(d, {}))) / length; }

    Vec3 point;
    ExactVec normal;
    double length;
};

/// A point of the triangle on which a ray starts: on its face, an edge or a corner by turns of `number`.
Vec3 pointOf(const Mesh& mesh, std::uint32_t triangle, std::uint64_t number, Random& random) {
    float u = random.number(0, 1);
    float v = random.number(0, 1 - u);
    if (number % 4 == 2) v = number % 8 == 2 ? 0.0F : 1 - u;
    if (number % 4 == 3) u = v = 0;
    return mesh.position(triangle, 0) * (1 - u - v) + mesh.position(triangle, 1) * u +
           mesh.position(triangle, 2) * v;
}

float clearanceOf(const Mesh& mesh, std::uint32_t triangle) {
    return rtcore::surfaceClearance(mesh.position(triangle, 0), mesh.position(triangle, 1),
                                    mesh.position(triangle, 2), normalize(mesh.geometricNormal(triangle)));
}

struct Totals {
    std::uint64_t rays = 0, selfHits = 0, leaks = 0, differing = 0;
    std::uint64_t besideFaces = 0; ///< nearer to another face than the start is rounded
};

/// A mesh in both kinds of trees, and rays that leave it.
class Subject {
  public:
    Subject(SampleMesh sample, bool closed, std::string name)
        : sample_(std::move(sample)), mesh_(sample_.view()), closed_(closed), name_(std::move(name)) {
        for (const rtcore::BuildMethod method : {rtcore::BuildMethod::Exact, rtcore::BuildMethod::Fast}) {
            rtcore::BuildOptions options;
            options.method = method;
            options.intersectionCost = 4; // deep, with many planes
            trees_.push_back(buildKdTree(mesh_, options));
        }
        for (const rtcore::KdTree& tree : trees_) {
            tracers_.emplace_back(tree, mesh_, LeafRecords::Inline);
            tracers_.emplace_back(tree, mesh_, LeafRecords::Shared);
        }
        for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) planes_.emplace_back(mesh_, i);
    }

    void trace(std::uint64_t rays, std::uint64_t seed, Totals& totals) const {
        constexpr std::size_t kWave = 1024;
        Random random(seed);
        for (std::uint64_t done = 0; done < rays; done += kWave) {
            rtcore::RayWave wave;
            std::vector<std::uint32_t> left;
            fill(kWave, done / kWave, random, wave, left);
            judge(wave, left, (done / kWave + seed) % 2 == 0, totals);
        }
    }

  private:
    /// Rays that leave triangles, 64 at a time in similar directions where `number` is even, else in any.
    void fill(std::size_t count, std::uint64_t number, Random& random, rtcore::RayWave& wave,
              std::vector<std::uint32_t>& left) const {
        Vec3 around{};
        for (std::size_t i = 0; wave.size() < count; ++i) {
            const std::uint32_t triangle = random.index(mesh_.triangles.size());
            const ExactPlane& plane = planes_[triangle];
            if (i % 64 == 0) around = random.unitVector();
            Vec3 direction = random.unitVector();
            if (number % 2 == 0) direction = normalize(around + random.unitVector() * 0.1F);
            // On the side of the normal, inside the beam; in rounding's reach of the plane it is left open.
            const float side = closed_ ? inwards(plane) : random.coin() ? 1.0F : -1.0F;
            if (plane.slopeOf(direction) * double{side} < 0) direction = -direction;
            if (std::fabs(plane.slopeOf(direction)) < 1e-6) continue;
            const Vec3 normal = normalOf(plane) * side;
            const Vec3 p = pointOf(mesh_, triangle, closed_ ? 0 : i, random);
            wave.push({p + normal * clearanceOf(mesh_, triangle), 0, direction,
                       std::numeric_limits<float>::infinity()});
            left.push_back(triangle);
        }
    }

    static Vec3 normalOf(const ExactPlane& plane) {
        return {static_cast<float>(static_cast<double>(plane.normal.x) / plane.length),
                static_cast<float>(static_cast<double>(plane.normal.y) / plane.length),
                static_cast<float>(static_cast<double>(plane.normal.z) / plane.length)};
    }

    /// The side of a beam's face that is inside.
    float inwards(const ExactPlane& plane) const {
        const rtcore::Box3 box = trees_[0].bounds;
        return plane.heightOf((box.lo + box.hi) * 0.5F) > 0 ? 1.0F : -1.0F;
    }

    /// How far rounding may move a start across the plane of a triangle near it.
    double roundingAt(std::uint32_t triangle) const {
        const Vec3 normal = normalOf(planes_[triangle]);
        double across = 0;
        for (int axis = 0; axis < 3; ++axis) {
            double extent = 0;
            for (int corner = 0; corner < 3; ++corner)
                extent = std::max(extent, std::fabs(double{mesh_.position(triangle, corner)[axis]}));
            across += extent * std::fabs(double{normal[axis]});
        }
        constexpr double kStart = 6; // of three products, their sum, 1 - u - v, and of the step off the face
        return kStart * 0x1p-24 * across;
    }

    bool isBesideFace(const Ray& ray, std::uint32_t left) const {
        for (std::uint32_t i = 0; i < planes_.size(); ++i) {
            if (i / 2 == left / 2) continue;
            const double height = planes_[i].heightOf(ray.origin) * double{inwards(planes_[i])};
            if (height < roundingAt(i)) return true;
        }
        return false;
    }

    /// Single rays and waves find the same bits in each tree; what they find is right.
    void judge(const rtcore::RayWave& wave, const std::vector<std::uint32_t>& left, bool records,
               Totals& totals) const {
        rtcore::HitWave hits[2];
        std::vector<std::uint8_t> occluded;
        for (std::size_t tree = 0; tree < 2; ++tree) {
            const KdRayTracer& tracer = tracers_[2 * tree + (records ? 0 : 1)];
            tracer.intersect(rtcore::RayKind::Scattered, wave, hits[tree]);
            tracer.occluded(rtcore::RayKind::Shadow, wave, occluded);
            for (std::size_t i = 0; i < wave.size(); ++i) {
                rtcore::Hit hit;
                const bool found = intersect(trees_[tree], mesh_, wave.ray(i), hit);
                const rtcore::Hit other = hits[tree].hit(i);
                const rtcore::Hit first = hits[0].hit(i);
                const bool same = found == hits[tree].isHit(i) && found == (occluded[i] != 0) &&
                                  found == hits[0].isHit(i) &&
                                  (!found || (isSame(hit, other) && isSame(hit, first)));
                if (!same && ++totals.differing <= 3) report("differs", wave.ray(i), hit.triangle);
            }
        }
        totals.rays += wave.size();
        for (std::size_t i = 0; i < wave.size(); ++i) {
            const Ray ray = wave.ray(i);
            if (closed_) {
                if (isBesideFace(ray, left[i])) {
                    ++totals.besideFaces;
                } else if (!hits[0].isHit(i)) {
                    if (++totals.leaks <= 3) report("leaks", ray, left[i]);
                } else if (hits[0].triangle[i] / 2 == left[i] / 2 && !isMet(ray, hits[0].triangle[i])) {
                    if (++totals.selfHits <= 3) report("hits what it leaves", ray, left[i]);
                }
            } else if (hits[0].isHit(i) && !isMet(ray, hits[0].triangle[i])) {
                if (++totals.selfHits <= 3) report("hits what it leaves", ray, left[i]);
            }
        }
    }

    /// Whether the ray truly goes towards the triangle's plane: corners that rounding moved bend what was
    /// flat.
    bool isMet(const Ray& ray, std::uint32_t triangle) const {
        const ExactPlane& plane = planes_[triangle];
        return plane.heightOf(ray.origin) * plane.slopeOf(ray.direction) < 0;
    }

    static bool isSame(const rtcore::Hit& a, const rtcore::Hit& b) {
        const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x); };
        return a.triangle == b.triangle && bits(a.t) == bits(b.t) && bits(a.u) == bits(b.u) &&
               bits(a.v) == bits(b.v);
    }

    void report(const char* what, const Ray& ray, std::uint32_t triangle) const {
        std::printf("%s: %s, triangle %d, origin %a %a %a direction %a %a %a\n", name_.c_str(), what,
                    static_cast<int>(triangle), double{ray.origin.x}, double{ray.origin.y},
                    double{ray.origin.z}, double{ray.direction.x}, double{ray.direction.y},
                    double{ray.direction.z});
    }

    SampleMesh sample_;
    Mesh mesh_;
    bool closed_;
    std::string name_;
    std::vector<rtcore::KdTree> trees_;
    std::vector<KdRayTracer> tracers_;
    std::vector<ExactPlane> planes_;
};

/// Too narrow for its place in space: the clearance would reach through it, or its corners fall together.
bool isLostInRounding(float width, float offset) { return width < 0.001F * (kLength + offset) * 0.06F; }

struct Case {
    Form form;
    float ratio, offset, size;
    bool turned;
};

std::vector<Case> allCases() {
    std::vector<Case> cases;
    for (const Form form : kForms) {
        for (const float ratio : kRatios) {
            for (const float offset : kOffsets) {
                if (form == Form::Beam && isLostInRounding(kLength / ratio, offset)) continue;
                if (kLength / ratio < offset * 0x1p-20F) continue;
                for (const bool turned : {false, true}) {
                    for (const float size : {1e-3F, 1.0F})
                        cases.push_back({form, ratio, offset, size, turned});
                }
            }
        }
    }
    return cases;
}

Subject subjectOf(const Case& c) {
    SampleMesh mesh = shapeOf(c.form, kLength / c.ratio);
    if (c.turned) mesh.rotate(static_cast<std::uint64_t>(c.ratio) + 7);
    mesh.move({c.offset, 0.6F * c.offset, -c.offset}).scale(c.size);
    const char* const names[] = {"pair", "strip", "fan", "doubled", "beam"};
    return {std::move(mesh), c.form == Form::Beam,
            std::string(names[static_cast<int>(c.form)]) + " 1:" + std::to_string(static_cast<int>(c.ratio)) +
                " offset " + std::to_string(static_cast<int>(c.offset)) + (c.turned ? " turned" : "") +
                (c.size < 1 ? " small" : "")};
}

} // namespace

TEST(Leaving, RaysHitNothingOfWhatTheyLeaveAndAllThatTheyMeet) {
    const std::vector<Case> cases = allCases();
    const std::vector<std::string> sets = rtcore::instructionSets();
    const std::uint64_t raysOfCase = allRays() / (cases.size() * sets.size()) + 1;
    for (const std::string& set : sets) {
        ASSERT_TRUE(rtcore::useInstructionSet(set));
        Totals all;
#pragma omp parallel for schedule(dynamic)
        for (std::size_t i = 0; i < cases.size(); ++i) {
            Totals own;
            subjectOf(cases[i]).trace(raysOfCase, 10 * i + 1, own);
#pragma omp critical
            {
                all.rays += own.rays;
                all.selfHits += own.selfHits;
                all.leaks += own.leaks;
                all.differing += own.differing;
                all.besideFaces += own.besideFaces;
            }
        }
        std::printf("%s: %llu rays, %llu hit what they leave, %llu leak, %llu differ, %llu beside faces\n",
                    set.c_str(), static_cast<unsigned long long>(all.rays),
                    static_cast<unsigned long long>(all.selfHits), static_cast<unsigned long long>(all.leaks),
                    static_cast<unsigned long long>(all.differing),
                    static_cast<unsigned long long>(all.besideFaces));
        EXPECT_EQ(all.selfHits, 0U);
        EXPECT_EQ(all.leaks, 0U);
        EXPECT_EQ(all.differing, 0U);
    }
    rtcore::useInstructionSet("auto");
}
