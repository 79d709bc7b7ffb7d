/// Images of materials as their authors meant them: normal maps, heights, masks, and how they lie.
#include "process/models/quads_file.h"

#include <cstdlib>
#include <fstream>
#include <functional>

namespace {

using rtcore::Colour;
using rtcore::LdrImage;
using rtcore::Rgba8;
using test::emitting;
using test::metallicRoughness;
using test::QuadsFile;

class MapsSeen : public test::SeenFiles {
  protected:
    void writeImage(const std::string& name, int width, int height,
                    const std::function<Rgba8(int, int)>& texel) {
        LdrImage image(width, height);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x)
                image.pixels[static_cast<std::size_t>(y * width + x)] = texel(x, y);
        }
        const std::vector<std::byte> bytes = rtcore::encodeImage(image, "png");
        std::ofstream(folder / name, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
    static constexpr const char* kWide = "[camera]\neye = [0, 0, 3]\nforward = [0, 0, -1]\nfov = 30\n";
    static std::string images(const std::string& sampler = "") {
        return std::string(",\"images\":[{\"uri\":\"i.png\"}],\"textures\":[{\"source\":0") +
               (sampler.empty() ? "}]" : ",\"sampler\":0}],\"samplers\":[" + sampler + "]");
    }
    /// A square of OBJ with these lines of its material.
    void writeObj(const std::string& lines) {
        test::writeText(folder / "m.obj",
                        "mtllib m.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\n"
                        "vt 1 1\nvt 0 1\nvn 0 0 1\nusemtl a\nf 1/1/1 2/2/1 3/3/1 4/4/1\n");
        test::writeText(folder / "m.mtl", "newmtl a\n" + lines);
    }
    float seenObj(const std::string& lines, const std::string& integrator = "whitted") {
        writeObj(lines);
        return see("m.obj", integrator, std::string(kStraight) + kSun).mean().g;
    }
};

Rgba8 grey(int code) {
    const auto c = static_cast<std::uint8_t>(code);
    return {c, c, c, 255};
}
Rgba8 halves(int x, int) { return grey(x < 4 ? 0 : 255); }

TEST_F(MapsSeen, NormalMapsLeanAsFarAsTheirScaleSays) {
    // 30 degrees to the right: (0.5, 0, 0.866).
    writeImage("i.png", 4, 4, [](int, int) { return Rgba8{191, 128, 238, 255}; });
    const auto seen = [&](const std::string& scale, const char* integrator) {
        QuadsFile file(
            {{0, metallicRoughness("0.8,0.8,0.8,1", 1, ",\"normalTexture\":{\"index\":0" + scale + "}")}});
        file.more = images();
        test::writeText(folder / "m.gltf", file.text());
        return see("m.gltf", integrator, std::string(kStraight) + kSun).mean().g;
    };
    for (const char* integrator : {"path", "whitted"}) {
        const float flat = seen(",\"scale\":0", integrator), whole = seen("", integrator);
        EXPECT_EQ(seen(",\"scale\":1", integrator), whole);
        EXPECT_NEAR(whole / flat, 0.866F, 0.03F) << integrator;
        EXPECT_NEAR(seen(",\"scale\":0.5", integrator) / flat, 0.961F, 0.02F)
            << integrator; // atan(0.5 tan 30)
    }
}

TEST_F(MapsSeen, TransmissionIsThatOfTheTexture) {
    writeImage("i.png", 8, 8, halves);
    const std::string glass = ",\"extensions\":{\"KHR_materials_transmission\":{\"transmissionFactor\":1,"
                              "\"transmissionTexture\":{\"index\":0}}}";
    QuadsFile file({{0, metallicRoughness("1,1,1,1", 0, glass)}, {-1, emitting()}});
    file.more = images() + ",\"extensionsUsed\":[\"KHR_materials_transmission\"]";
    test::writeText(folder / "m.gltf", file.text());
    for (const char* integrator : {"path", "whitted"}) {
        const Seen seen = see("m.gltf", integrator, kWide);
        EXPECT_LT(seen.mean(0.1, 0.3).g, 0.1F) << integrator;
        EXPECT_NEAR(seen.mean(0.7, 0.9).g, 0.923F, 0.01F) << integrator;
    }
}

TEST_F(MapsSeen, NearestTexelsHaveNoBlendBetweenThem) {
    writeImage("i.png", 2, 2, [](int x, int) { return grey(x == 0 ? 0 : 255); });
    const std::string unlit = ",\"extensions\":{\"KHR_materials_unlit\":{}}";
    const auto seen = [&](const std::string& sampler) {
        QuadsFile file({{0, "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}" + unlit + "}"}});
        file.more = images(sampler) + ",\"extensionsUsed\":[\"KHR_materials_unlit\"]";
        test::writeText(folder / "m.gltf", file.text());
        return see("m.gltf", "whitted", kStraight);
    };
    const std::string clamped = "\"wrapS\":33071,\"wrapT\":33071";
    const Seen sharp = seen("{\"magFilter\":9728," + clamped + "}"), soft = seen("{" + clamped + "}");
    EXPECT_EQ(sharp.mean(0.05, 0.45).g, 0.0F);
    EXPECT_EQ(sharp.mean(0.55, 0.95).g, 1.0F);
    EXPECT_GT(soft.mean(0.05, 0.45).g, 0.05F);
    EXPECT_LT(soft.mean(0.55, 0.95).g, 0.95F);
    // The same where many points are looked up at once: lit colours.
    const auto lit = [&](const std::string& sampler) {
        QuadsFile file(
            {{0, "{\"pbrMetallicRoughness\":{\"metallicFactor\":0,\"baseColorTexture\":{\"index\":0}}}"}});
        file.more = images(sampler);
        test::writeText(folder / "m.gltf", file.text());
        return see("m.gltf", "whitted", std::string(kStraight) + kSun);
    };
    const Seen step = lit("{\"magFilter\":9728," + clamped + "}");
    EXPECT_NEAR(step.mean(0.05, 0.2).g, step.mean(0.3, 0.45).g, 5e-3F);
    EXPECT_NEAR(step.mean(0.55, 0.7).g, step.mean(0.8, 0.95).g, 5e-3F);
}

TEST_F(MapsSeen, HeightsOfMtlAreSlopes) {
    // White stands a tenth of the width above black: slope 0.1, times 4.
    writeImage("ramp.png", 64, 64, [](int x, int) { return grey(4 * x); });
    const std::string plain = "Kd .5 .5 .5\nillum 1\n";
    EXPECT_NEAR(seenObj(plain), 0.5F, 0.001F);
    for (const char* statement : {"map_Bump", "bump", "map_bump"}) {
        EXPECT_NEAR(seenObj(plain + statement + " -bm 4 ramp.png\n"), 0.5F / std::sqrt(1.16F), 0.003F)
            << statement;
        EXPECT_NEAR(seenObj(plain + statement + " -bm -4 ramp.png\n"), 0.5F / std::sqrt(1.16F), 0.003F);
    }
    EXPECT_NEAR(seenObj(plain + "bump ramp.png\n"), 0.5F / std::sqrt(1.01F), 0.003F);
    EXPECT_NEAR(seenObj(plain + "bump -bm 4 ramp.png\n", "path"), 0.5F / std::sqrt(1.16F), 0.003F);
    // Towards the light that comes from the left the rising slope is brighter than the falling one.
    writeImage("rise.png", 64, 64, [](int x, int) { return grey(4 * x); });
    writeImage("fall.png", 64, 64, [](int x, int) { return grey(252 - 4 * x); });
    const std::string left =
        "[[light]]\nkind = \"directional\"\ndirection = [1, 0, -1]\nintensity = [4, 4, 4]\n";
    const auto fromLeft = [&](const std::string& image) {
        writeObj(plain + "bump -bm 4 " + image + "\n");
        return see("m.obj", "whitted", kStraight + left).mean().g;
    };
    EXPECT_GT(fromLeft("rise.png"), 1.5F * fromLeft("fall.png"));
    // Programs write normal maps there, too.
    writeImage("normals.png", 32, 32, [](int x, int) {
        return x < 16 ? Rgba8{191, 128, 238, 255} : Rgba8{64, 128, 238, 255};
    });
    EXPECT_NEAR(seenObj(plain + "map_Bump normals.png\n"), 0.5F * 0.866F, 0.01F);
}

TEST_F(MapsSeen, ColoursOfHighlightsAreThoseOfTheirImage) {
    writeImage("black.png", 2, 2, [](int, int) { return grey(0); });
    writeImage("white.png", 2, 2, [](int, int) { return grey(255); });
    writeImage("half.png", 8, 8, halves);
    const std::string shiny = "Kd 0 0 0\nKs 1 1 1\nNs 20\nillum 2\n";
    for (const char* integrator : {"path", "whitted"}) {
        const float plain = seenObj(shiny, integrator);
        EXPECT_GT(plain, 0.5F);
        EXPECT_EQ(seenObj(shiny + "map_Ks black.png\n", integrator), 0.0F) << integrator;
        EXPECT_NEAR(seenObj(shiny + "map_Ks white.png\n", integrator), plain, 0.02F * plain) << integrator;
        writeObj(shiny + "map_Ks half.png\n");
        const Seen halved = see("m.obj", integrator, std::string(kWide) + kSun);
        EXPECT_LT(halved.mean(0, 0.3).g, 0.01F);
        EXPECT_GT(halved.mean(0.7, 1).g, 0.5F * plain) << integrator;
        // A mirror's, too: it shows the black around it or the light of the sky.
        const std::string mirror = "Kd 0 0 0\nKs 1 1 1\nillum 3\n";
        const auto mirrored = [&](const std::string& lines) {
            writeObj(mirror + lines);
            return see("m.obj", integrator, std::string("background = [1, 1, 1]\n") + kStraight).mean().g;
        };
        EXPECT_NEAR(mirrored(""), 1, 0.01F);
        EXPECT_NEAR(mirrored("map_Ks black.png\n"), 0, 0.01F) << integrator;
    }
}

TEST_F(MapsSeen, CoordinatesAreScaledAndMovedAsMtlSays) {
    writeImage("half.png", 8, 8, halves);
    const std::string plain = "Kd 1 1 1\nillum 1\nmap_Kd ";
    const auto at = [&](const std::string& options, double x) {
        writeObj(plain + options + "half.png\n");
        const std::string camera =
            "[camera]\neye = [" + std::to_string(x) + ", 0.2, 3]\nforward = [0, 0, -1]\nfov = 1\n";
        return see("m.obj", "whitted", camera + kSun).mean().g;
    };
    EXPECT_NEAR(at("", 0.4), 1, 0.01F); // u = 0.7
    EXPECT_NEAR(at("-s 0.25 0.25 1 ", 0.4), 0, 0.01F);
    EXPECT_NEAR(at("-s 2 2 1 ", 0.4), 0, 0.01F);
    EXPECT_NEAR(at("-s 2 2 ", 0.4), 0, 0.01F) << "the last numbers may be left out";
    EXPECT_NEAR(at("-s 2 -o 0.5 ", 0.4), 1, 0.01F);
    EXPECT_NEAR(at("-o 0.5 0 0 ", 0.4), 0, 0.01F);
    EXPECT_NEAR(at("-o 0.5 0 0 -s 2 1 1 ", 0.4), 1, 0.01F) << "scaled first";
    EXPECT_NEAR(at("-clamp on -s 2 1 1 ", 0.4), 1, 0.01F);
}

TEST_F(MapsSeen, TheSharedCasesAreRight) {
    const char* const scenes = std::getenv("RT_TEST_SCENES");
    if (scenes == nullptr || !std::filesystem::exists(std::filesystem::path(scenes) / "truth3"))
        GTEST_SKIP() << "RT_TEST_SCENES is not set";
    const auto seen = [&](const std::string& name) {
        return seeScene(std::filesystem::path(scenes) / "truth3" / (name + ".scn"), "path");
    };
    EXPECT_NEAR(seen("normal_scale_0").mean().g, 0.276F, 0.003F);
    const Seen transmission = seen("transmission_texture");
    EXPECT_LT(transmission.mean(6 / 64.0, 20 / 64.0).g, 0.1F);
    EXPECT_NEAR(transmission.mean(44 / 64.0, 58 / 64.0).g, 0.923F, 0.01F);
    EXPECT_LT(seen("bump").mean().g, 0.48F);
    EXPECT_NEAR(seen("scaled").mean().g, 0, 0.01F);
}

} // namespace
