/// The content of a model file once it is imported, or of a .bsp once it is mapped: geometry, materials,
/// textures, and the file's own lights and cameras. Immutable; views stay valid while `storage` lives.
#pragma once

#include "rtcore/scene/camera.h"
#include "rtcore/scene/image.h"
#include "rtcore/scene/light.h"
#include "rtcore/scene/material.h"
#include "rtcore/scene/mesh.h"
#include "rtcore/scene/texel_block.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

/// How a texture continues beyond 0..1 of a coordinate.
enum class TextureWrap : std::uint32_t { Repeat = 0, ClampToEdge = 1, MirroredRepeat = 2 };

/// Between the middles of texels.
enum class TextureFilter : std::uint16_t { Linear = 0, Nearest = 1 };

/// As texels of 4 bytes, or in blocks of 16 opaque ones (texel_block.h).
enum class TextureStorage : std::uint16_t { Texels = 0, Blocks = 1 };

/// One texture: rows from the top, in Model::texels from `firstTexel`, or rows of blocks in Model::blocks
/// from that one. Textures that differ only in how they wrap, lie and are filtered share their texels.
struct Texture {
    std::uint64_t firstTexel = 0; ///< in blocks: the first block
    std::uint32_t width = 0, height = 0;
    TextureWrap wrapU = TextureWrap::Repeat, wrapV = TextureWrap::Repeat;
    TextureFilter filter = TextureFilter::Linear;
    TextureStorage storage = TextureStorage::Texels;
    std::uint32_t texcoordSet = 0; ///< by which it lies on surfaces (Mesh::texcoord)

    bool inBlocks() const { return storage == TextureStorage::Blocks; }
    friend bool operator==(const Texture&, const Texture&) = default;
};
static_assert(sizeof(Texture) == 32);

/// A range of triangles that the model's author kept apart: one mesh under one node.
struct ModelPart {
    std::uint32_t nameOffset = 0;
    std::uint32_t firstTriangle = 0, triangleCount = 0;
    friend bool operator==(const ModelPart&, const ModelPart&) = default;
};
static_assert(sizeof(ModelPart) == 12);

struct Model {
    Mesh mesh;
    std::span<const Material> materials; ///< at least one
    std::span<const Texture> textures;
    std::span<const Rgba8> texels; ///< colour as sRGB, alpha linear
    std::span<const TexelBlock> blocks;
    std::span<const Light> lights;
    std::span<const Camera> cameras;
    std::span<const ModelPart> parts; ///< ascending, none overlap; may leave triangles out, or be empty
    std::span<const char>
        strings; ///< names, each ended by a zero byte; the first is ""; the last byte is zero

    std::shared_ptr<const void> storage; ///< owns all of the above

    /// The name at `offset` of the string table; "" when there is none.
    std::string_view name(std::uint32_t offset) const {
        return offset < strings.size() ? std::string_view(strings.data() + offset) : std::string_view();
    }
};

/// The same with memory of its own: what an importer or a test fills.
struct ModelBuffers {
    std::vector<Vertex> vertices;
    std::vector<Triangle> triangles;
    std::vector<ShadingTriangle> shading;
    std::vector<Vec3> normals;
    std::vector<Vec2> texcoords;
    std::vector<Colour> colours;
    std::vector<float> alphas;
    std::vector<Vec2> furtherTexcoords;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<Rgba8> texels;
    std::vector<TexelBlock> blocks;
    std::vector<Light> lights;
    std::vector<Camera> cameras;
    std::vector<ModelPart> parts;
    std::vector<char> strings{'\0'};

    /// Adds a name to the string table and returns its offset; "" is always 0.
    std::uint32_t addName(std::string_view name);
};

/// Views of what `buffers` holds; takes the memory over.
Model makeModel(ModelBuffers buffers);

} // namespace rtcore
