#include "rtcore/io/import/gltf/primitive.h"

#include "rtcore/io/import/gltf/draco_mesh.h"
#include "rtcore/platform/large_vector.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace rtcore::gltf {

/// Where the attributes of one primitive come from.
struct PrimitiveReader::Attributes {
    const Json& stated;
    const Json& packedNumbers;         ///< of those that Draco has
    std::unique_ptr<DracoMesh> packed; ///< or nothing
    std::uint64_t vertices = 0;        ///< as many as each of its lists has
    std::vector<std::uint32_t> used;   ///< the only ones that are wanted, ascending; empty: all
};

namespace {

template <typename T>
std::span<float> asFloats(std::vector<T>& list) {
    static_assert(sizeof(T) % sizeof(float) == 0);
    return {reinterpret_cast<float*>(list.data()), list.size() * (sizeof(T) / sizeof(float))};
}

/// The entries of `all` whose numbers are in `used`, or all of them.
template <typename T>
void pick(std::span<const float> all, std::uint32_t components, std::span<const std::uint32_t> used,
          std::vector<T>& list) {
    list.resize(used.size());
    const std::span<float> to = asFloats(list);
    for (std::size_t i = 0; i < used.size(); ++i) {
        for (std::uint32_t c = 0; c < components; ++c)
            to[i * components + c] = all[std::size_t{used[i]} * components + c];
    }
}

std::vector<std::uint32_t> verticesOf(std::span<const Triangle> triangles) {
    std::vector<std::uint32_t> list;
    list.reserve(triangles.size() * 3);
    for (const Triangle& t : triangles) list.insert(list.end(), t.v, t.v + 3);
    std::ranges::sort(list);
    list.erase(std::ranges::unique(list).begin(), list.end());
    return list;
}

/// Whole numbers of these can mean nothing else, even where the file does not say so.
bool isAlwaysNormalized(std::string_view attribute) {
    return attribute.starts_with("COLOR_") || attribute.starts_with("WEIGHTS_");
}

void addDeltas(std::span<float> list, std::span<const float> deltas, float weight) {
    for (std::size_t i = 0; i < list.size(); ++i) list[i] += weight * deltas[i];
}

} // namespace

PrimitiveReader::PrimitiveReader(const Json& root, Accessors& accessors, Views& views)
    : root_(root), accessors_(accessors), views_(views), uses_(gltf::sizeOf(member(root, "accessors"))) {
    for (const Json& mesh : member(root, "meshes")) {
        for (const Json& primitive : member(mesh, "primitives")) {
            for (const Json& number : member(primitive, "attributes")) {
                const auto accessor = wholeNumber(number);
                if (accessor && *accessor < uses_.size()) ++uses_[*accessor];
            }
        }
    }
}

PrimitiveReader::Size PrimitiveReader::sizeOf(const Json& primitive) {
    const auto positions = accessors_.find(index(member(primitive, "attributes"), "POSITION"));
    const bool packed = readsDraco() && !extension(primitive, kDracoExtension).is_null();
    const auto count = [&](std::optional<std::size_t> accessor) {
        return wholeNumber(element(member(root_, "accessors"), accessor), "count", 0);
    };
    const std::uint64_t vertices = positions ? positions->count
                                   : packed  ? count(index(member(primitive, "attributes"), "POSITION"))
                                             : 0;
    const auto corners = index(primitive, "indices");
    const std::uint64_t used = corners ? count(corners) : vertices;
    return {std::min(vertices, used), facesOf(modeOf(primitive), used)};
}

bool PrimitiveReader::hasAlphas(const Json& primitive) {
    auto colours = accessors_.find(index(member(primitive, "attributes"), "COLOR_0"));
    if (!colours || colours->elements.components != 4) return false;
    colours->elements.normalized = true;
    std::vector<float> list(colours->count * 4);
    if (!accessors_.readFloats(*colours, 4, list)) return false;
    for (std::size_t i = 3; i < list.size(); i += 4)
        if (list[i] < 1) return true;
    return false;
}

const std::vector<float>* PrimitiveReader::kept(const std::string& name, std::size_t number,
                                                const Accessor& accessor, std::uint32_t components) {
    Kept& k = kept_[name];
    if (!k.numbers.empty() && k.accessor == number && k.numbers.size() == accessor.count * components)
        return &k.numbers;
    k.accessor = number;
    k.numbers.resize(accessor.count * components);
    if (accessors_.readFloats(accessor, components, k.numbers)) return &k.numbers;
    k.numbers.clear();
    return nullptr;
}

template <typename T>
bool PrimitiveReader::readList(const Attributes& from, const Json& attributes, const char* name,
                               std::uint32_t components, std::vector<T>& list) {
    const Json& packed = member(from.packedNumbers, name);
    const bool ofPrimitive = &attributes == &from.stated;
    if (from.packed && ofPrimitive && !packed.is_null()) {
        const auto number = wholeNumber(packed);
        const std::vector<float> numbers =
            from.packed->floats(static_cast<std::uint32_t>(number.value_or(~0U)), components);
        list.resize(numbers.size() / components);
        std::ranges::copy(numbers, asFloats(list).begin());
        return list.size() == from.vertices && !list.empty();
    }
    const auto number = index(attributes, name);
    auto accessor = accessors_.find(number);
    if (!accessor || accessor->count != from.vertices) return false;
    accessor->elements.normalized |= isAlwaysNormalized(name);
    if (!from.used.empty()) {
        const std::vector<float>* const all = kept(name, *number, *accessor, components);
        if (all != nullptr) pick(*all, components, from.used, list);
        return all != nullptr;
    }
    resizeLarge(list, accessor->count);
    return accessors_.readFloats(*accessor, components, asFloats(list));
}

template <typename T>
void PrimitiveReader::readOptional(const Attributes& from, const char* name, std::uint32_t components,
                                   std::vector<T>& list, Primitive& out) {
    if (member(from.stated, name).is_null()) return;
    if (readList(from, from.stated, name, components, list)) return;
    list.clear();
    ++out.damagedAttributes;
}

bool PrimitiveReader::readCorners(const Json& primitive, const Attributes& from, Primitive& out) {
    const Mode mode = modeOf(primitive);
    if (from.packed) {
        out.list = connected(from.packed->triangles(), from.vertices);
        return true;
    }
    if (member(primitive, "indices").is_null()) {
        out.list = trianglesOf(mode, from.vertices);
        return true;
    }
    const auto corners = accessors_.find(index(primitive, "indices"));
    if (!corners) return false;
    if (mode == Mode::Triangles && corners->count % 3 == 0) {
        std::vector<Triangle> triangles;
        resizeLarge(triangles, corners->count / 3);
        const std::span<std::uint32_t> numbers{reinterpret_cast<std::uint32_t*>(triangles.data()),
                                               corners->count};
        if (!accessors_.readIndices(*corners, numbers)) return false;
        out.list = connected(std::move(triangles), from.vertices);
        return true;
    }
    std::vector<std::uint32_t> numbers(corners->count);
    if (!accessors_.readIndices(*corners, numbers)) return false;
    out.list = trianglesOf(mode, numbers, from.vertices);
    return true;
}

/// Thousands of primitives may name the same list of vertices, each a few of them.
void PrimitiveReader::useFewVertices(Attributes& from, Primitive& out) {
    const auto accessor = index(from.stated, "POSITION");
    const bool few = out.list.triangles.size() * 3 < from.vertices;
    if (from.packed || !few || !accessor || *accessor >= uses_.size() || !isShared(*accessor)) return;
    from.used = verticesOf(out.list.triangles);
    for (Triangle& t : out.list.triangles) {
        for (std::uint32_t& v : t.v)
            v = static_cast<std::uint32_t>(std::ranges::lower_bound(from.used, v) - from.used.begin());
    }
}

void PrimitiveReader::readColours(const Attributes& from, bool alphas, Primitive& out) {
    struct Rgba {
        float r = 0, g = 0, b = 0, a = 0;
    };
    if (!alphas) return readOptional(from, "COLOR_0", 3, out.colours, out);
    std::vector<Rgba> list;
    readOptional(from, "COLOR_0", 4, list, out);
    out.colours.reserve(list.size());
    out.alphas.reserve(list.size());
    for (const Rgba& c : list) {
        out.colours.push_back({c.r, c.g, c.b});
        out.alphas.push_back(c.a);
    }
}

/// A set that is not there is the first one.
std::vector<Vec2> PrimitiveReader::texcoords(const Attributes& from, const TexcoordUse& use, Primitive& out) {
    std::vector<Vec2> list;
    std::string name = "TEXCOORD_" + std::to_string(use.set);
    if (member(from.stated, name.c_str()).is_null()) name = "TEXCOORD_0";
    readOptional(from, name.c_str(), 2, list, out);
    const TexcoordTransform transform(use);
    for (Vec2& t : list) t = transform(t);
    return list;
}

void PrimitiveReader::readTexcoords(const Attributes& from, std::span<const TexcoordUse> uses,
                                    Primitive& out) {
    out.texcoords = texcoords(from, uses[0], out);
    for (const TexcoordUse& use : uses.subspan(1)) {
        out.furtherTexcoords.push_back(texcoords(from, use, out));
        out.furtherTexcoords.back().resize(out.positions.size());
    }
    if (!out.furtherTexcoords.empty()) out.texcoords.resize(out.positions.size());
}

void PrimitiveReader::readInfluences(const Attributes& from, Primitive& out) {
    struct Four {
        std::array<float, 4> v{};
    };
    constexpr int kMaxSets = 8;
    for (int set = 0; set < kMaxSets; ++set) {
        const std::string joints = "JOINTS_" + std::to_string(set),
                          weights = "WEIGHTS_" + std::to_string(set);
        if (member(from.stated, joints.c_str()).is_null()) return;
        std::vector<Four> j, w;
        readOptional(from, joints.c_str(), 4, j, out);
        readOptional(from, weights.c_str(), 4, w, out);
        if (j.empty() || j.size() != w.size()) continue;
        std::vector<Influences>& list = out.influences.emplace_back(j.size());
        for (std::size_t i = 0; i < j.size(); ++i) list[i] = {j[i].v, w[i].v};
    }
}

void PrimitiveReader::morph(const Json& primitive, const Attributes& from, std::span<const float> weights,
                            Primitive& out) {
    const Json& targets = member(primitive, "targets");
    const std::size_t count = std::min(gltf::sizeOf(targets), weights.size());
    std::vector<Vec3> deltas;
    const auto move = [&](const Json& target, const char* name, float weight, std::vector<Vec3>& list) {
        if (list.empty() || member(target, name).is_null()) return;
        if (readList(from, target, name, 3, deltas)) {
            addDeltas(asFloats(list), asFloats(deltas), weight);
        } else {
            ++out.damagedAttributes;
        }
    };
    for (std::size_t t = 0; t < count; ++t) {
        if (weights[t] == 0) continue;
        move(targets[t], "POSITION", weights[t], out.positions);
        move(targets[t], "NORMAL", weights[t], out.normals);
    }
}

Primitive PrimitiveReader::read(const Json& primitive, const PrimitiveUse& use) {
    Primitive out;
    const Json &stated = member(primitive, "attributes"), &packed = extension(primitive, kDracoExtension);
    Attributes from{stated, member(packed, "attributes"), nullptr, 0, {}};
    if (readsDraco() && !packed.is_null()) {
        const auto view = index(packed, "bufferView");
        const std::vector<std::byte> code = view ? views_.bytes(*view) : std::vector<std::byte>();
        from.packed = code.empty() ? nullptr : DracoMesh::decode(code);
    }
    const auto positions = accessors_.find(index(stated, "POSITION"));
    from.vertices = from.packed ? from.packed->vertices() : positions ? positions->count : 0;
    out.damaged = (!from.packed && !positions && !member(stated, "POSITION").is_null()) ||
                  !readCorners(primitive, from, out);
    if (out.damaged || out.list.triangles.empty()) return out;
    useFewVertices(from, out);
    out.damaged = !readList(from, stated, "POSITION", 3, out.positions);
    if (out.damaged) {
        out.list = {};
        out.positions.clear();
        return out;
    }
    readOptional(from, "NORMAL", 3, out.normals, out);
    readTexcoords(from, use.texcoords, out);
    readColours(from, use.alphas, out);
    if (use.skinned) readInfluences(from, out);
    morph(primitive, from, use.weights, out);
    return out;
}

} // namespace rtcore::gltf
