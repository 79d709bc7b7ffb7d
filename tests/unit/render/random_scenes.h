/// Small scenes and settings of random numbers, odd ones among them.
#pragma once

#include "rtcore/scene/environment.h"
#include "support/random_numbers.h"
#include "support/small_scene.h"

#include <array>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace test {

/// Not a number, endless, too large, negative, tiny.
inline float oddNumber(Random& random) {
    using Limits = std::numeric_limits<float>;
    constexpr std::array<float, 8> kOdd{
        Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), 1e30F, Limits::max(), -1, 0, 1e-40F};
    return kOdd[random.index(kOdd.size())];
}

class RandomScene {
  public:
    explicit RandomScene(std::uint64_t seed) : random_(seed), odd_(random_.index(3) == 0) {}

    rtcore::Scene scene() {
        SceneBuilder b;
        for (int i = 0; i < 4; ++i) addShape(b);
        b.scene.background = colour(1);
        b.scene.ambient = colour(0.3F);
        if (random_.coin()) b.scene.background = {};
        if (random_.index(3) == 0) b.scene.environments = {sky()};
        if (random_.index(4) == 0) addFog(b.scene.fog);
        const std::size_t lights = random_.index(10) == 0 ? 40 : random_.index(5);
        for (std::size_t i = 0; i < lights; ++i) b.scene.lights.push_back(light());
        return b.finish();
    }

    rtcore::RenderSettings settings() {
        rtcore::RenderSettings s;
        s.width = s.height = 8;
        s.antialiasing = 1 + static_cast<int>(random_.index(2));
        s.maxDepth = static_cast<int>(random_.index(8));
        s.shadows = random_.index(5) != 0;
        s.reflections = random_.index(5) != 0;
        s.refractions = random_.index(5) != 0;
        s.textures = random_.index(5) != 0;
        s.areaLights.samples = static_cast<int>(random_.index(6));
        s.ambientOcclusion.on = random_.index(4) == 0;
        s.skyLight.on = random_.index(4) == 0;
        s.depthOfField.on = random_.index(4) == 0;
        s.fog.shafts = static_cast<int>(random_.index(3));
        s.adaptive = random_.coin() ? 0 : 0.1F;
        s.path.samples = 1 + static_cast<int>(random_.index(4));
        s.path.bounces = static_cast<int>(random_.index(20));
        s.path.rouletteFrom = static_cast<int>(random_.index(9));
        s.path.clampIndirect = random_.coin() ? 0 : random_.number(0, 2);
        s.path.caustics = random_.coin();
        s.path.emitters = static_cast<rtcore::EmitterLight>(random_.index(3));
        s.path.seed = static_cast<int>(random_.index(100));
        s.environmentFilter = static_cast<rtcore::TexelFilter>(random_.index(2));
        return s;
    }

  private:
    /// 0..most, and now and then odd where the scene is.
    float number(float max) {
        return odd_ && random_.index(40) == 0 ? oddNumber(random_) : random_.number(0, max);
    }
    rtcore::Colour colour(float max) {
        const float r = number(max), g = number(max);
        return {r, g, number(max)};
    }

    rtcore::Material material(SceneBuilder& b) {
        rtcore::Material m = matte(0.5F);
        m.diffuse = colour(1);
        if (random_.index(3) == 0) m.specular = colour(0.5F);
        m.shininess = number(random_.coin() ? 5.0F : 100000.0F);
        if (random_.index(3) == 0) m.mirror = colour(1);
        m.mirrorScale = number(1);
        m.fresnel = random_.index(2);
        if (random_.index(3) == 0) m.opacity = random_.coin() ? 0 : random_.number(0, 1);
        m.transmission = colour(1);
        if (random_.index(3) == 0) m.attenuationDistance = number(2);
        m.indexOfRefraction = random_.index(4) == 0 ? 1 : random_.number(1, 3);
        if (random_.index(4) == 0) m.emission = colour(10);
        if (random_.index(4) == 0) m.diffuseTexture = texture(b);
        if (random_.index(4) == 0) m.alphaTexture = texture(b);
        if (random_.index(4) == 0) m.normalTexture = texture(b);
        if (random_.index(4) == 0) m.emissionTexture = texture(b);
        m.alphaCutoff = random_.coin() ? 0 : 0.5F;
        if (random_.index(3) == 0) {
            m.roughness = random_.index(8) == 0 ? number(1) : random_.number(0, 1);
            m.metallic = random_.index(8) == 0 ? number(1) : random_.number(0, 1);
            if (random_.coin()) m.metallicRoughnessTexture = texture(b);
        }
        return m;
    }
    std::uint32_t texture(SceneBuilder& b) {
        const std::uint32_t width = 1 + random_.index(4), height = 1 + random_.index(4);
        std::vector<rtcore::Rgba8> texels;
        const auto byte = [&] { return static_cast<std::uint8_t>(random_.index(256)); };
        for (std::uint32_t i = 0; i < width * height; ++i) {
            const std::uint8_t r = byte(), g = byte(), blue = byte();
            texels.push_back({r, g, blue, byte()});
        }
        return b.texture(width, height, texels);
    }
    void addShape(SceneBuilder& b) {
        const auto number = b.material(material(b));
        const rtcore::Vec3 at = random_.vector(1.5F);
        switch (random_.index(5)) {
        case 0:
            b.sphere(at, random_.number(0.1F, 1), 4, number);
            break;
        case 1:
            b.box(at - rtcore::Vec3{1, 1, 1} * random_.number(0, 1), at + rtcore::Vec3{1, 0.5F, 0.3F}, number,
                  static_cast<int>(1 + random_.index(6)));
            break;
        case 2:
            b.square(at, random_.unitVector(), random_.number(0.1F, 5), number);
            break;
        default: { // with corners that coincide, too
            const rtcore::Vec3 to = random_.index(6) == 0 ? at : random_.vector(2);
            b.triangle(at, to, random_.index(6) == 0 ? at + to : random_.vector(2), number);
        }
        }
    }
    rtcore::Light light() {
        rtcore::Light l;
        l.kind = static_cast<rtcore::LightKind>(random_.index(rtcore::kLightKinds));
        l.position = random_.vector(3);
        l.direction = random_.unitVector();
        l.right = rtcore::basisAround(l.direction).tangent;
        l.intensity = colour(20);
        l.radius = random_.index(3) == 0 ? 0 : number(1);
        l.width = random_.index(4) == 0 ? 0 : number(2);
        l.height = random_.index(4) == 0 ? 1e-20F : number(2);
        l.cosInner = random_.number(-1, 1);
        l.cosOuter = random_.coin() ? l.cosInner : random_.number(-1, l.cosInner);
        l.on = random_.index(6) != 0 ? 1 : 0;
        return l;
    }
    std::shared_ptr<const rtcore::Environment> sky() {
        const int height = 1 + static_cast<int>(random_.index(9));
        rtcore::HdrImage image(2 * height, height);
        for (rtcore::Colour& texel : image.pixels) texel = colour(3);
        auto made = rtcore::Environment::fromEquirectangular(image, "");
        made.turn(random_.number(0, 360), {0, 1, 0});
        return std::make_shared<const rtcore::Environment>(std::move(made));
    }
    void addFog(rtcore::Fog& fog) {
        fog.kind = random_.coin() ? rtcore::FogKind::Homogeneous : rtcore::FogKind::Exponential;
        fog.density = number(0.5F);
        fog.scaleHeight = random_.number(0.1F, 3);
        fog.groundHeight = random_.number(-1, 1);
        fog.colour = colour(1);
        fog.albedo = colour(1);
        fog.surroundings = number(1);
        fog.emission = colour(0.2F);
    }

    Random random_;
    bool odd_;
};

} // namespace test
