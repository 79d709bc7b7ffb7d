#include "rtcore/io/import/gltf/accessors.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace rtcore::gltf {

namespace {

constexpr std::uint64_t kMaxElements = 0xFFFFFFFFU, kMaxZeros = std::uint64_t{1} << 24U;
constexpr std::size_t kPiece = std::size_t{1} << 18U; ///< bytes, which stay in the cache

std::optional<Component> componentOf(const Json& stated) {
    const std::uint64_t code = wholeNumber(stated, "componentType", 0);
    if (code < 5120 || code > 5126 || code == 5124) return std::nullopt;
    return static_cast<Component>(code);
}

std::uint32_t componentsOf(const Json& stated) {
    using Row = std::pair<std::string_view, std::uint32_t>;
    static constexpr std::array kTypes{Row{"SCALAR", 1}, Row{"VEC2", 2}, Row{"VEC3", 3}, Row{"VEC4", 4},
                                       Row{"MAT2", 4},   Row{"MAT3", 9}, Row{"MAT4", 16}};
    const std::string type = text(stated, "type");
    for (const auto& [name, count] : kTypes)
        if (type == name) return count;
    return 0;
}

std::uint64_t elementBytes(const Elements& e) { return bytesOf(e.component) * e.components; }

template <typename T>
T load(const std::byte* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

template <typename T>
float asFloat(T value, bool normalized) {
    if constexpr (std::is_same_v<T, float>) {
        return value;
    } else {
        if (!normalized) return static_cast<float>(value);
        const float part = static_cast<float>(value) / static_cast<float>(std::numeric_limits<T>::max());
        return std::is_signed_v<T> ? std::max(part, -1.0F) : part;
    }
}

/// The numbers of elements, one element every `stride` bytes.
template <typename T>
void convert(const std::byte* from, std::uint64_t count, const Elements& e, std::uint32_t components,
             float* to) {
    const std::uint32_t there = std::min(components, e.components);
    for (std::uint64_t i = 0; i < count; ++i, from += e.stride, to += components) {
        for (std::uint32_t c = 0; c < there; ++c)
            to[c] = asFloat(load<T>(from + c * sizeof(T)), e.normalized);
        for (std::uint32_t c = there; c < components; ++c) to[c] = 0;
    }
}

void convert(const std::byte* from, std::uint64_t count, const Elements& e, std::uint32_t components,
             float* to) {
    switch (e.component) {
    case Component::Byte:
        return convert<std::int8_t>(from, count, e, components, to);
    case Component::UnsignedByte:
        return convert<std::uint8_t>(from, count, e, components, to);
    case Component::Short:
        return convert<std::int16_t>(from, count, e, components, to);
    case Component::UnsignedShort:
        return convert<std::uint16_t>(from, count, e, components, to);
    case Component::UnsignedInt:
        return convert<std::uint32_t>(from, count, e, components, to);
    case Component::Float:
        return convert<float>(from, count, e, components, to);
    }
}

template <typename T>
void copyIndices(const std::byte* from, std::uint64_t count, std::uint64_t stride, std::uint32_t* to) {
    for (std::uint64_t i = 0; i < count; ++i) to[i] = load<T>(from + i * stride);
}

} // namespace

std::size_t bytesOf(Component component) {
    switch (component) {
    case Component::Byte:
    case Component::UnsignedByte:
        return 1;
    case Component::Short:
    case Component::UnsignedShort:
        return 2;
    case Component::UnsignedInt:
    case Component::Float:
        break;
    }
    return 4;
}

/// `stated` names a view, or has one (of sparse accessors).
std::optional<Elements> Accessors::elements(const Json& stated, Component component, std::uint32_t components,
                                            std::uint64_t count) {
    const auto view = index(stated, "bufferView");
    if (!view) return std::nullopt;
    Elements e{*view, wholeNumber(stated, "byteOffset", 0), views_.stride(*view), component, components,
               false};
    const std::uint64_t size = views_.size(*view), own = elementBytes(e);
    if (e.stride == 0) e.stride = own;
    if (e.stride > kMaxElements || e.offset > size) return std::nullopt;
    if (count > 0 && (count - 1) * e.stride + own > size - e.offset) return std::nullopt;
    return e;
}

std::optional<Sparse> Accessors::sparse(const Json& stated, const Elements& of, std::uint64_t count) {
    Sparse result;
    result.count = wholeNumber(stated, "count", 0);
    const Json& indices = member(stated, "indices");
    const auto component = componentOf(indices);
    if (result.count == 0 || result.count > count || !component) return std::nullopt;
    const auto where = elements(indices, *component, 1, result.count);
    const auto what = elements(member(stated, "values"), of.component, of.components, result.count);
    if (!where || !what) return std::nullopt;
    result.indices = *where;
    result.values = *what;
    result.values.normalized = of.normalized;
    return result;
}

std::optional<Accessor> Accessors::find(std::optional<std::size_t> number) {
    const Json& stated = element(member(root_, "accessors"), number);
    const auto component = componentOf(stated);
    const std::uint32_t components = componentsOf(stated);
    Accessor a;
    a.count = wholeNumber(stated, "count", kMaxElements + 1);
    if (!component || components == 0 || a.count > kMaxElements) return std::nullopt;
    a.zeros = member(stated, "bufferView").is_null();
    if (a.zeros) {
        if (a.count > kMaxZeros) return std::nullopt;
        a.elements.component = *component;
        a.elements.components = components;
    } else {
        const auto plain = elements(stated, *component, components, a.count);
        if (!plain) return std::nullopt;
        a.elements = *plain;
    }
    a.elements.normalized = flag(stated, "normalized", false);
    if (const Json& some = member(stated, "sparse"); !some.is_null()) {
        a.sparse = sparse(some, a.elements, a.count);
        if (!a.sparse) return std::nullopt;
    }
    return a;
}

template <typename Use>
bool Accessors::forPieces(const Elements& e, std::uint64_t count, Use use) {
    const std::uint64_t own = elementBytes(e);
    const std::uint64_t max = std::max<std::uint64_t>(kPiece / e.stride, 1);
    std::vector<std::byte> piece;
    for (std::uint64_t first = 0; first < count; first += max) {
        const std::uint64_t some = std::min(max, count - first);
        piece.resize((some - 1) * e.stride + own);
        if (!views_.read(e.view, e.offset + first * e.stride, piece)) return false;
        use(first, piece.data(), some);
    }
    return true;
}

bool Accessors::readPlain(const Elements& e, std::uint64_t count, std::uint32_t components,
                          std::span<float> room) {
    const bool asIs =
        e.component == Component::Float && e.components == components && e.stride == elementBytes(e);
    if (asIs) return views_.read(e.view, e.offset, std::as_writable_bytes(room));
    return forPieces(e, count, [&](std::uint64_t first, const std::byte* bytes, std::uint64_t some) {
        convert(bytes, some, e, components, room.data() + first * components);
    });
}

bool Accessors::readPlain(const Elements& e, std::uint64_t count, std::span<std::uint32_t> room) {
    if (e.component == Component::UnsignedInt && e.stride == sizeof(std::uint32_t))
        return views_.read(e.view, e.offset, std::as_writable_bytes(room));
    return forPieces(e, count, [&](std::uint64_t first, const std::byte* bytes, std::uint64_t some) {
        std::uint32_t* const to = room.data() + first;
        if (e.component == Component::UnsignedByte) copyIndices<std::uint8_t>(bytes, some, e.stride, to);
        if (e.component == Component::UnsignedShort) copyIndices<std::uint16_t>(bytes, some, e.stride, to);
        if (e.component == Component::UnsignedInt) copyIndices<std::uint32_t>(bytes, some, e.stride, to);
    });
}

bool Accessors::replace(const Sparse& sparse, std::uint64_t count, std::uint32_t components,
                        std::span<float> room) {
    std::vector<std::uint32_t> where(sparse.count);
    std::vector<float> what(sparse.count * components);
    if (!readPlain(sparse.indices, sparse.count, where) ||
        !readPlain(sparse.values, sparse.count, components, what))
        return false;
    for (std::size_t i = 0; i < where.size(); ++i) {
        if (where[i] >= count) return false;
        std::copy_n(what.begin() + static_cast<std::ptrdiff_t>(i * components), components,
                    room.begin() + static_cast<std::ptrdiff_t>(std::size_t{where[i]} * components));
    }
    return true;
}

bool Accessors::readFloats(const Accessor& a, std::uint32_t components, std::span<float> room) {
    if (a.zeros) {
        std::ranges::fill(room, 0.0F);
    } else if (!readPlain(a.elements, a.count, components, room)) {
        return false;
    }
    return !a.sparse || replace(*a.sparse, a.count, components, room);
}

bool Accessors::readIndices(const Accessor& a, std::span<std::uint32_t> room) {
    const Component c = a.elements.component;
    const bool unsignedWhole =
        c == Component::UnsignedByte || c == Component::UnsignedShort || c == Component::UnsignedInt;
    if (!unsignedWhole || a.sparse) return false;
    if (a.zeros) std::ranges::fill(room, 0U);
    return a.zeros || readPlain(a.elements, a.count, room);
}

} // namespace rtcore::gltf
