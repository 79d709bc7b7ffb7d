/// Random glTF files beside plain ones that show the same (make_gltf_census.py).
#include "rtcore/io/scene_loader.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/render/camera_rays.h"
#include "rtcore/render/image_renderer.h"
#include "rtcore/survey/closest_hit.h"
#include "rtcore/survey/framing.h"

#include "support/run_program.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using rtcore::Colour;
using rtcore::Vec3;

constexpr int kWidth = 96, kHeight = 72;

/// In even white light, which shows base colours.
rtcore::LoadedScene loadEvenly(const fs::path& model, const fs::path& scene) {
    rtcore::LoadOptions options;
    options.build.method = rtcore::BuildMethod::Fast;
    options.model = model;
    return rtcore::loadScene(scene, options);
}

rtcore::Camera viewOf(const rtcore::LoadedScene& loaded, Vec3 forward) {
    rtcore::Camera camera;
    camera.forward = forward;
    camera.horizontalFov = 50;
    const rtcore::Mesh& mesh = loaded.scene.model.mesh;
    return rtcore::framed(mesh, mesh.bounds(), camera, float{kWidth} / kHeight);
}

/// The number of the part to which a triangle belongs.
int partOf(const rtcore::Model& model, std::uint32_t triangle) {
    for (std::size_t p = 0; p < model.parts.size(); ++p) {
        if (triangle - model.parts[p].firstTriangle < model.parts[p].triangleCount)
            return static_cast<int>(p);
    }
    return -1;
}

bool isFront(const rtcore::Mesh& mesh, std::uint32_t triangle, Vec3 seenAlong) {
    const auto corner = [&](int i) { return mesh.vertices[mesh.triangles[triangle].v[i]].position(); };
    const Vec3 a = corner(0), b = corner(1), c = corner(2);
    return dot(cross(b - a, c - a), seenAlong) < 0;
}

/// The part that is hit first behind each pixel, whatever its material: 2 for each before it, 1 where the
/// front is seen; -1: none.
std::vector<int> partsSeen(const rtcore::LoadedScene& loaded, const rtcore::Camera& camera) {
    const rtcore::CameraRays rays(camera, kWidth, kHeight);
    const rtcore::Model& model = loaded.scene.model;
    std::vector<int> seen;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const rtcore::Ray ray = rays.at(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
            const auto hit = rtcore::closestHit(loaded.tree, model.mesh, ray.origin, ray.direction);
            int part = -1;
            if (hit)
                part = 2 * partOf(model, hit->triangle) +
                       (isFront(model.mesh, hit->triangle, ray.direction) ? 1 : 0);
            seen.push_back(part);
        }
    }
    return seen;
}

struct Pixels {
    std::vector<rtcore::AovPixel> aovs;
    std::vector<Colour> colours;
    std::vector<int> parts;
};

Pixels render(const rtcore::LoadedScene& loaded, const rtcore::Camera& camera) {
    rtcore::RenderSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.antialiasing = 1;
    const rtcore::KdRayTracer tracer(loaded.tree, loaded.scene.model.mesh);
    const rtcore::View view{loaded.scene, tracer, camera, settings};
    rtcore::RenderControl control{.threads = 1};
    rtcore::Frame frame;
    rtcore::ImageRenderers renderers;
    EXPECT_TRUE(renderers.of(settings.integrator).render(view, control, {.aovs = true}, frame));
    return {frame.aovs.pixels(), frame.radiance.pixels, partsSeen(loaded, camera)};
}

/// Fractions of the pixels that one or both images cover.
struct Agreement {
    double mask = 1, colour = 1, normal = 1, part = 1;
    double meanColour = 0; ///< the difference of means, of the largest channel
};

bool isNear(Colour a, Colour b) {
    return std::fabs(a.r - b.r) <= 0.02F && std::fabs(a.g - b.g) <= 0.02F && std::fabs(a.b - b.b) <= 0.02F;
}

Agreement compare(const Pixels& a, const Pixels& b) {
    double any = 0, both = 0, colour = 0, normal = 0, part = 0, hits = 0;
    Colour difference;
    for (std::size_t i = 0; i < a.aovs.size(); ++i) {
        hits += a.parts[i] >= 0 || b.parts[i] >= 0 ? 1 : 0;
        part += a.parts[i] >= 0 && a.parts[i] == b.parts[i] ? 1 : 0;
        const bool inA = a.aovs[i].covered > 0, inB = b.aovs[i].covered > 0;
        any += inA || inB ? 1 : 0;
        if (!inA || !inB) continue;
        ++both;
        const Colour x = a.colours[i], y = b.colours[i];
        colour += isNear(x, y) ? 1 : 0;
        normal += dot(a.aovs[i].normal, b.aovs[i].normal) > 0.99F ? 1 : 0;
        difference += x - y;
    }
    if (any == 0) return {};
    const double all = std::max(both, 1.0);
    const Colour size{std::fabs(difference.r), std::fabs(difference.g), std::fabs(difference.b)};
    return {both / any, colour / all, normal / all, part / std::max(hits, 1.0),
            double{maxComponent(size)} / all};
}

class GltfCensus : public testing::Test {
  protected:
    struct Entry {
        std::string file;
        std::size_t parts = 0;
        fs::path plain() const { return file.substr(0, file.find('.')) + ".plain.glb"; }
    };

    void make(const std::string& count) {
        const std::string python = "/usr/bin/python3";
        if (!fs::exists(python)) GTEST_SKIP() << "python3 is missing: the files cannot be made";
        const fs::path script = fs::path(RT_SOURCE_FOLDER) / "tests/strangers/make_gltf_census.py";
        const test::ProgramResult made =
            test::runProgram(python, {script.string(), folder_.path().string(), count});
        ASSERT_EQ(made.exitCode, 0) << made.error;
        std::ifstream list(folder_ / "census.txt");
        for (Entry entry; list >> entry.file >> entry.parts;) entries_.push_back(entry);
        std::ofstream(folder_ / "even.scn") << "version = 1\nmodel = \"1.glb\"\nambient = [1, 1, 1]\n";
    }

    void expectSame(const Entry& entry) {
        const rtcore::LoadedScene plain = loadEvenly(folder_ / entry.plain(), folder_ / "even.scn");
        const rtcore::LoadedScene own = loadEvenly(folder_ / entry.file, folder_ / "even.scn");
        ASSERT_EQ(plain.scene.model.parts.size(), entry.parts);
        EXPECT_EQ(own.scene.model.parts.size(), entry.parts);
        EXPECT_EQ(own.scene.model.mesh.triangles.size(), plain.scene.model.mesh.triangles.size());
        EXPECT_EQ(own.warnings.size(), plain.warnings.size());
        for (const Vec3 forward : {Vec3{-0.5F, -0.4F, -0.77F}, Vec3{0.6F, 0.5F, 0.62F}}) {
            const rtcore::Camera camera = viewOf(plain, forward);
            const Agreement agreement = compare(render(own, camera), render(plain, camera));
            EXPECT_GE(agreement.mask, 0.97);
            EXPECT_GE(agreement.part, 0.97);
            EXPECT_GE(agreement.normal, 0.97);
            EXPECT_GE(agreement.colour, 0.97);
            EXPECT_LE(agreement.meanColour, 0.02);
        }
    }

    test::TemporaryFolder folder_;
    std::vector<Entry> entries_;
};

TEST_F(GltfCensus, FilesShowWhatPlainOnesShow) {
    const char* const count = std::getenv("RT_GLTF_CENSUS");
    make(count != nullptr ? count : "60");
    for (const Entry& entry : entries_) {
        SCOPED_TRACE(entry.file);
        expectSame(entry);
    }
}

} // namespace
