/// Primitives of glTF meshes as lists that the importer works with.
#pragma once

#include "rtcore/io/import/gltf/accessors.h"
#include "rtcore/io/import/gltf/texcoord_use.h"
#include "rtcore/io/import/gltf/triangles.h"
#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace rtcore::gltf {

class DracoMesh;

/// Four of the joints that move a vertex.
struct Influences {
    std::array<float, 4> joints{}, weights{}; ///< numbers in the skin's list; any floats
};

/// The lists of attributes are empty or as long as `positions`.
struct Primitive {
    TriangleList list;
    std::vector<Vec3> positions, normals;            ///< where the file has them, moved by morph targets
    std::vector<Vec2> texcoords;                     ///< as the material lays its images; (0, 0) = lower left
    std::vector<std::vector<Vec2>> furtherTexcoords; ///< where it lays some otherwise; by set
    std::vector<Colour> colours;
    std::vector<float> alphas;
    std::vector<std::vector<Influences>> influences; ///< one list for each set of four
    bool damaged = false;                ///< positions or corners cannot be read: all lists are empty
    std::uint32_t damagedAttributes = 0; ///< left out
};

/// The parts of it that a use asks for.
struct PrimitiveUse {
    std::vector<TexcoordUse> texcoords{1}; ///< one for each set; at least one
    bool alphas = false;                   ///< those of its colours count
    bool skinned = false;                  ///< with influences
    std::span<const float> weights;        ///< of its morph targets
};

class PrimitiveReader {
  public:
    /// All must outlive the object.
    PrimitiveReader(const Json& root, Accessors& accessors, Views& views);

    Primitive read(const Json& primitive, const PrimitiveUse& use);
    /// Upper bounds of what read() gives, from the JSON alone.
    struct Size {
        std::uint64_t vertices = 0, faces = 0;
    };
    Size sizeOf(const Json& primitive);
    /// Whether some colour of its vertices covers less than all.
    bool hasAlphas(const Json& primitive);

  private:
    struct Attributes;
    bool isShared(std::size_t accessor) const { return uses_[accessor] > 1; }
    bool readCorners(const Json& primitive, const Attributes& from, Primitive& out);
    /// `components` numbers of each vertex, in the vertices' own order or in that of `from.used`.
    template <typename T>
    bool readList(const Attributes& from, const Json& attributes, const char* name, std::uint32_t components,
                  std::vector<T>& list);
    template <typename T>
    void readOptional(const Attributes& from, const char* name, std::uint32_t components,
                      std::vector<T>& list, Primitive& out);
    void useFewVertices(Attributes& from, Primitive& out);
    void readColours(const Attributes& from, bool alphas, Primitive& out);
    std::vector<Vec2> texcoords(const Attributes& from, const TexcoordUse& use, Primitive& out);
    void readTexcoords(const Attributes& from, std::span<const TexcoordUse> uses, Primitive& out);
    void readInfluences(const Attributes& from, Primitive& out);
    void morph(const Json& primitive, const Attributes& from, std::span<const float> weights, Primitive& out);
    const std::vector<float>* kept(const std::string& name, std::size_t number, const Accessor& accessor,
                                   std::uint32_t components);

    const Json& root_;
    Accessors& accessors_;
    Views& views_;
    std::vector<std::uint32_t> uses_; ///< by accessor: how many attributes name it
    struct Kept {
        std::size_t accessor = 0;
        std::vector<float> numbers;
    };
    std::map<std::string, Kept> kept_; ///< by attribute: the list that primitives share which was read last
};

} // namespace rtcore::gltf
