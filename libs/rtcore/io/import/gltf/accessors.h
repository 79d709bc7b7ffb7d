/// Typed lists of numbers in the buffers of a glTF file.
#pragma once

#include "rtcore/io/import/gltf/buffers.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace rtcore::gltf {

/// The numbers that stand for them in files.
enum class Component : std::uint32_t {
    Byte = 5120,
    UnsignedByte = 5121,
    Short = 5122,
    UnsignedShort = 5123,
    UnsignedInt = 5125,
    Float = 5126
};
std::size_t bytesOf(Component component);

/// Elements of `components` numbers of one kind, that follow each other every `stride` bytes of a view.
struct Elements {
    std::size_t view = 0;
    std::uint64_t offset = 0, stride = 0;
    Component component = Component::Float;
    std::uint32_t components = 1; ///< 1, 2, 3, 4, 9, 16
    bool normalized = false;      ///< whole numbers stand for 0..1 or -1..1
};

struct Sparse {
    std::uint64_t count = 0;
    Elements indices, values;
};

/// An accessor of which all bytes are there.
struct Accessor {
    std::uint64_t count = 0;
    Elements elements;
    bool zeros = false; ///< in place of `elements`
    std::optional<Sparse> sparse;
};

class Accessors {
  public:
    /// Both must outlive the object.
    Accessors(const Json& root, Views& views) : root_(root), views_(views) {}

    /// Nothing where there is none, or it is damaged or leads beyond its view. At most 2^32 - 1 elements;
    /// 2^24 where they are only said to be 0.
    std::optional<Accessor> find(std::optional<std::size_t> number);

    /// The first `components` numbers of all elements, 0 for those that elements do not have, as
    /// `count * components` floats; false where they cannot be read. Integers divide by the largest of their
    /// kind where they are normalised.
    bool readFloats(const Accessor& accessor, std::uint32_t components, std::span<float> room);
    /// The first number of all elements; false where they are no unsigned integers or cannot be read.
    bool readIndices(const Accessor& accessor, std::span<std::uint32_t> room);

  private:
    std::optional<Elements> elements(const Json& stated, Component component, std::uint32_t components,
                                     std::uint64_t count);
    std::optional<Sparse> sparse(const Json& stated, const Elements& of, std::uint64_t count);
    /// Calls use(first, bytes, number of elements) for pieces of all elements; false where it does.
    template <typename Use>
    bool forPieces(const Elements& elements, std::uint64_t count, Use use);
    bool readPlain(const Elements& elements, std::uint64_t count, std::uint32_t components,
                   std::span<float> room);
    bool readPlain(const Elements& elements, std::uint64_t count, std::span<std::uint32_t> room);
    bool replace(const Sparse& sparse, std::uint64_t count, std::uint32_t components, std::span<float> room);

    const Json& root_;
    Views& views_;
};

} // namespace rtcore::gltf
