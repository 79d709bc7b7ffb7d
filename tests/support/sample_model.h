/// A random model in which every kind of record occurs. The same seed gives the same model.
#pragma once

#include "rtcore/scene/model.h"
#include "rtcore/scene/photometry.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

namespace test {

class SampleModel {
  public:
    explicit SampleModel(std::uint32_t seed) : random_(seed) {}

    /// Small triangles spread over the cube [-1, 1]^3; three vertices, normals, ... each.
    rtcore::ModelBuffers make(std::size_t triangles) {
        addMaterials();
        addTextures();
        addBlocks();
        for (std::size_t i = 0; i < triangles; ++i)
            addTriangle(0.8F / std::cbrt(static_cast<float>(triangles)));
        addLights();
        addCameras();
        addParts();
        return std::move(buffers_);
    }

  private:
    float number(float lo, float hi) {
        const auto fraction =
            static_cast<float>(random_() >> 8U) / 16777216.0F; // equal on every standard library
        return lo + (hi - lo) * fraction;
    }
    rtcore::Vec3 vector(float size) {
        return {number(-size, size), number(-size, size), number(-size, size)};
    }
    rtcore::Colour colour(float hi) { return {number(0, hi), number(0, hi), number(0, hi)}; }

    void addTriangle(float size) {
        auto& b = buffers_;
        const rtcore::Vec3 middle = vector(1);
        rtcore::Triangle triangle;
        rtcore::ShadingTriangle shading;
        for (int corner = 0; corner < 3; ++corner) {
            const rtcore::Vec3 p = middle + vector(size);
            triangle.v[corner] = static_cast<std::uint32_t>(b.vertices.size());
            shading.v[corner] = static_cast<std::uint32_t>(b.normals.size());
            b.vertices.push_back({p.x, p.y, p.z, 0});
            b.normals.push_back(rtcore::normalize(vector(1)));
            b.texcoords.push_back({number(-2, 3), number(-2, 3)});
            b.furtherTexcoords.push_back({b.texcoords.back().y, b.texcoords.back().x});
            b.colours.push_back(colour(1));
            b.alphas.push_back(0.25F * static_cast<float>(corner));
        }
        shading.material = static_cast<std::uint32_t>(random_() % b.materials.size());
        b.triangles.push_back(triangle);
        b.shading.push_back(shading);
    }

    void addMaterials() {
        for (int i = 0; i < 3; ++i) {
            rtcore::Material m;
            m.diffuse = colour(0.5F);
            m.specular = colour(0.5F);
            m.opacity = number(0, 1);
            m.shininess = number(1, 1000);
            m.mirror = colour(1);
            m.emission = colour(10);
            m.fresnel = static_cast<std::uint32_t>(i % 2);
            if (i == 1) m.diffuseTexture = 0;
            if (i == 2) m.alphaTexture = 1;
            m.nameOffset = buffers_.addName("material " + std::to_string(i));
            m.roughness = i == 0 ? rtcore::kNoRoughness : 0.25F * static_cast<float>(i);
            m.metallic = 0.5F * static_cast<float>(i);
            if (i == 2) m.metallicRoughnessTexture = 1;
            m.emissionLights = static_cast<std::uint32_t>(i % 2);
            m.normalScale = 0.5F * static_cast<float>(i);
            m.vertexAlpha = m.tintsEmission = m.frontOnly = static_cast<std::uint32_t>(i % 2);
            if (i == 1) m.transmissionTexture = m.specularTexture = 1;
            buffers_.materials.push_back(m);
        }
    }

    void addTextures() {
        for (const std::uint32_t side : {2U, 5U}) {
            buffers_.textures.push_back({buffers_.texels.size(), side, side + 1,
                                         rtcore::TextureWrap::ClampToEdge,
                                         rtcore::TextureWrap::MirroredRepeat, rtcore::TextureFilter::Nearest,
                                         rtcore::TextureStorage::Texels, side == 5 ? 1U : 0U});
            for (std::uint32_t i = 0; i < side * (side + 1); ++i) {
                const auto bits = static_cast<std::uint32_t>(random_());
                buffers_.texels.push_back(
                    {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8U),
                     static_cast<std::uint8_t>(bits >> 16U), static_cast<std::uint8_t>(bits >> 24U)});
            }
        }
    }

    /// 5 x 3 texels; their random numbers are no others' business.
    void addBlocks() {
        std::mt19937_64 random(7);
        rtcore::Texture texture{1, 5, 3};
        texture.storage = rtcore::TextureStorage::Blocks;
        buffers_.textures.push_back(texture);
        buffers_.blocks.resize(3);
        for (rtcore::TexelBlock& block : buffers_.blocks)
            for (std::uint64_t& row : block.rows) row = random();
    }

    void addLights() {
        for (std::size_t kind = 0; kind < rtcore::kLightKinds; ++kind) {
            rtcore::Light light;
            light.kind = static_cast<rtcore::LightKind>(kind);
            light.position = vector(5);
            light.direction = rtcore::normalize(vector(1));
            light.intensity = colour(100);
            light.radius = number(0, 0.1F);
            light.cosInner = 0.9F;
            light.cosOuter = 0.8F;
            light.right = rtcore::basisAround(light.direction).tangent;
            light.width = number(0.1F, 1);
            light.height = number(0.1F, 1);
            light.nameOffset = buffers_.addName("light");
            if (light.kind == rtcore::LightKind::Ies)
                light.photometry =
                    rtcore::keepPhotometry({{0, 45, 90}, {0, 180, 360}, {9, 8, 0, 9, 4, 1, 9, 8, 0}});
            buffers_.lights.push_back(light);
        }
    }

    void addCameras() {
        for (int i = 0; i < 2; ++i) {
            rtcore::Camera camera;
            camera.eye = vector(5);
            camera.forward = {number(-1, 1), 0.2F, -1};
            camera.horizontalFov = number(20, 150);
            camera.nameOffset = buffers_.addName("camera " + std::to_string(i));
            if (i == 1) camera.kind = rtcore::CameraKind::Orthographic;
            camera.orthographicWidth = static_cast<float>(i);
            camera.aspect = 1.5F * static_cast<float>(i);
            buffers_.cameras.push_back(camera);
        }
    }

    /// Two, with a triangle or more between them that belongs to none.
    void addParts() {
        const auto all = static_cast<std::uint32_t>(buffers_.triangles.size());
        buffers_.parts.push_back({buffers_.addName("first part"), 0, all / 3});
        buffers_.parts.push_back({0, all - all / 3, all / 3});
    }

    std::mt19937 random_;
    rtcore::ModelBuffers buffers_;
};

} // namespace test
