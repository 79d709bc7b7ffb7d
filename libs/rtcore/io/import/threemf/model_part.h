/// The contents of a model part of a 3MF package: 3MF core 1.3, materials and properties 1.2, production 1.1.
#pragma once

#include "rtcore/io/import/mesh/affine.h"
#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"
#include "rtcore/scene/mesh.h"
#include "rtcore/scene/model.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace rtcore::threemf {

inline constexpr std::uint32_t kNoNumber = 0xFFFFFFFFU;

struct Paint {
    Colour colour = kWhite; ///< linear
    float alpha = 1;
    friend bool operator==(const Paint&, const Paint&) = default;
};

enum class GroupKind : std::uint8_t { Materials, Colours, Texture, Composites, Layers };

/// What the numbers of corners stand for, by the kind of the group.
struct PropertyGroup {
    GroupKind kind = GroupKind::Colours;
    std::vector<Paint> paints;        ///< Materials, Colours: each entry's
    std::vector<std::string> names;   ///< Materials: each entry's
    std::vector<Vec2> coordinates;    ///< Texture: each entry's
    std::uint32_t source = kNoNumber; ///< Texture: the image; Composites: the group of their parts
    /// Composites: numbers in that group; Layers: numbers of groups, the lowest first.
    std::vector<std::uint32_t> columns;
    std::vector<float> weights;        ///< Composites: a row of columns for each entry
    std::vector<std::uint32_t> rows;   ///< Layers: the same
    std::vector<char> multiplies;      ///< Layers: whether a column is multiplied with what is below it
    std::uint32_t display = kNoNumber; ///< Materials: the group of their properties
};

/// How a material reflects, beside its colour.
struct Display {
    bool metallic = false; ///< else by its specular colour
    float metal = 0, roughness = 1;
    Colour specular;
    float glossiness = 0;
};

struct TextureSource {
    std::string path; ///< of a part
    TextureWrap wrapU = TextureWrap::Repeat, wrapV = TextureWrap::Repeat;
    TextureFilter filter = TextureFilter::Linear;
};

/// Numbers of a group and of its entries at the corners of a triangle.
struct Properties {
    std::uint32_t group = kNoNumber;
    std::array<std::uint32_t, 3> entries{kNoNumber, kNoNumber, kNoNumber};
    friend bool operator==(const Properties&, const Properties&) = default;
};

struct Component {
    std::string part; ///< "" = the same
    std::uint32_t object = kNoNumber;
    Affine transform;
};

struct Object {
    std::string name;
    std::vector<Vec3> positions;
    std::vector<Triangle> triangles;       ///< indices below positions.size()
    Properties properties;                 ///< of triangles that have none of their own
    std::vector<Properties> ownProperties; ///< empty, or as long as `triangles`
    std::vector<Component> components;
    std::uint64_t unconnected = 0; ///< triangles left out: a corner does not exist
};

struct PartContent {
    double metresPerUnit = 0.001;
    std::string application;           ///< that wrote it
    std::vector<std::string> required; ///< extensions that are not read
    std::vector<std::string> ignored;  ///< elements of others, each once
    std::map<std::uint32_t, PropertyGroup> groups;
    std::map<std::uint32_t, std::vector<Display>> displays;
    std::map<std::uint32_t, TextureSource> textures;
    std::map<std::uint32_t, Object> objects;
    std::vector<Component> items; ///< to be built
};

} // namespace rtcore::threemf
