#include "rtcore/io/import/materials/colour_decoder.h"
#include "rtcore/io/import/scan/ply_elements.h"
#include "rtcore/io/import/scan/ply_numbers.h"
#include "rtcore/platform/large_vector.h"
#include "rtcore/settings/plain_text.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

namespace rtcore {

namespace {

enum class Attribute { Position, Normal, Colour, Texcoord, None };

/// The meaning of a property, by its name.
struct Part {
    std::string_view name;
    Attribute attribute;
    std::size_t component; ///< of a vector; of colours the fourth is not kept
};
constexpr std::array kParts{
    Part{"x", Attribute::Position, 0},
    Part{"y", Attribute::Position, 1},
    Part{"z", Attribute::Position, 2},
    Part{"nx", Attribute::Normal, 0},
    Part{"ny", Attribute::Normal, 1},
    Part{"nz", Attribute::Normal, 2},
    Part{"red", Attribute::Colour, 0},
    Part{"green", Attribute::Colour, 1},
    Part{"blue", Attribute::Colour, 2},
    Part{"alpha", Attribute::Colour, 3},
    Part{"r", Attribute::Colour, 0},
    Part{"g", Attribute::Colour, 1},
    Part{"b", Attribute::Colour, 2},
    Part{"u", Attribute::Texcoord, 0},
    Part{"v", Attribute::Texcoord, 1},
    Part{"s", Attribute::Texcoord, 0},
    Part{"t", Attribute::Texcoord, 1},
    Part{"tx", Attribute::Texcoord, 0},
    Part{"ty", Attribute::Texcoord, 1},
    Part{"texture_u", Attribute::Texcoord, 0},
    Part{"texture_v", Attribute::Texcoord, 1},
    Part{"diffuse_red", Attribute::Colour, 0},
    Part{"diffuse_green", Attribute::Colour, 1},
    Part{"diffuse_blue", Attribute::Colour, 2},
    Part{"diffuse_alpha", Attribute::Colour, 3},
};

Part partOf(std::string_view name) {
    for (const Part& part : kParts) {
        if (part.name == name) return part;
    }
    return {name, Attribute::None, 0};
}

/// Where the numbers of each attribute lie in a vertex of the file.
class VertexLayout {
  public:
    struct Field {
        PlyType type;
        std::size_t offset; ///< bytes
    };

    explicit VertexLayout(const PlyElement& element) {
        std::size_t offset = 0;
        for (const PlyProperty& property : element.properties) {
            const Part part = partOf(property.name);
            // If two properties have one meaning, the later counts.
            if (part.attribute != Attribute::None)
                at(part.attribute)[part.component] = {property.type, offset};
            offset += sizeOf(property.type);
        }
    }
    std::span<const std::optional<Field>> fieldsOf(Attribute attribute) const {
        return fields_[static_cast<std::size_t>(attribute)];
    }
    bool inFloats() const {
        return std::ranges::any_of(fieldsOf(Attribute::Position), [](const auto& field) {
            return field && field->type == PlyType::Float32;
        });
    }
    bool has(Attribute attribute) const {
        for (const auto& field : fieldsOf(attribute)) {
            if (field) return true;
        }
        return false;
    }

  private:
    using Fields = std::array<std::optional<Field>, 4>;
    Fields& at(Attribute attribute) { return fields_[static_cast<std::size_t>(attribute)]; }
    std::array<Fields, static_cast<std::size_t>(Attribute::None)> fields_;
};

/// One number of all vertices, on its way from the file into a list.
struct Column {
    VertexLayout::Field from;
    bool fraction;    ///< a part of a colour
    float* to;        ///< of the first vertex
    std::size_t step; ///< numbers from one vertex to the next
    double zero = 0;  ///< what is taken off

    /// `records` are whole vertices of `size` bytes, the first of which has the number `first`.
    void read(std::span<const std::byte> records, std::size_t size, bool swapped, std::size_t first) const {
        withPlyType(from.type, [&](auto type) {
            using T = decltype(type);
            float* out = to + first * step;
            for (std::size_t at = from.offset; at < records.size(); at += size, out += step) {
                const T value = plyNumber<T>(records.data() + at, swapped);
                *out = fraction    ? fractionOf(value)
                       : zero == 0 ? static_cast<float>(value)
                                   : static_cast<float>(static_cast<double>(value) - zero);
            }
        });
    }
};

/// Makes room in `list` and adds a column for each number that the file has.
template <typename Element>
void addColumns(const VertexLayout& layout, Attribute attribute, std::size_t count,
                std::vector<Element>& list, std::vector<Column>& columns, const FilePoint& zero = {}) {
    if (!layout.has(attribute)) return;
    constexpr std::size_t kNumbers = sizeof(Element) / sizeof(float);
    resizeLarge(list, count);
    auto* const numbers = reinterpret_cast<float*>(list.data());
    for (std::size_t component = 0; component < kNumbers; ++component) {
        if (const auto& field = layout.fieldsOf(attribute)[component])
            columns.push_back({*field, attribute == Attribute::Colour, numbers + component, kNumbers,
                               component < zero.size() ? zero[component] : 0});
    }
}

} // namespace

bool areScanVertices(const PlyElement& element) {
    if (element.name != "vertex" || element.hasList()) return false;
    const VertexLayout layout(element);
    const auto position = layout.fieldsOf(Attribute::Position);
    return position[0] && position[1] && position[2];
}

void readPlyVertices(PlySource& source, const PlyElement& element, ScanMesh& mesh) {
    const std::size_t size = element.fixedSize();
    refuseMoreThanFile(source, element, size);
    if (element.count >= std::numeric_limits<std::uint32_t>::max())
        refuseDamaged(say("it has {0} vertices, more than can be numbered", element.count));
    const VertexLayout layout(element);
    std::vector<Column> columns;
    addColumns(layout, Attribute::Position, element.count, mesh.positions, columns, mesh.origin.at);
    mesh.inFloats = layout.inFloats();
    addColumns(layout, Attribute::Normal, element.count, mesh.normals, columns);
    addColumns(layout, Attribute::Colour, element.count, mesh.colours, columns);
    addColumns(layout, Attribute::Texcoord, element.count, mesh.texcoords, columns);
    const auto use = [&](std::uint64_t first, std::span<const std::byte> records) {
        for (const Column& column : columns) column.read(records, size, source.swapped, first);
        return true;
    };
    if (!source.in.readRecords(element.count, size, use)) {
        refuseDamaged(say("it ends before the last of the {0} elements {1} that its head promises",
                          element.count, inQuotes(element.name)));
    }
    const ColourDecoder decode(false);
    for (Colour& colour : mesh.colours) colour = decode(colour);
}

float plyFraction(PlyType type, double number) {
    return withPlyType(type, [number](auto zero) {
        using T = decltype(zero);
        if constexpr (std::is_floating_point_v<T>) {
            return fractionOf(static_cast<T>(number));
        } else {
            constexpr double kMin = std::numeric_limits<T>::min(), kMax = std::numeric_limits<T>::max();
            return fractionOf(static_cast<T>(number >= kMin ? std::min(number, kMax) : kMin));
        }
    });
}

std::optional<std::size_t> plyColourComponent(const PlyProperty& property) {
    const Part part = partOf(property.name);
    const bool is = part.attribute == Attribute::Colour && part.component < 3 && !property.listLength;
    return is ? std::optional(part.component) : std::nullopt;
}

PlyVertexRows::PlyVertexRows(const PlyElement& element, ScanMesh& mesh) : mesh_(mesh) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const Part part = partOf(element.properties[i].name);
        if (part.attribute == Attribute::None) continue;
        const auto attribute = static_cast<std::size_t>(part.attribute);
        has_[attribute] = true;
        fields_.push_back({i, element.properties[i].type, attribute, part.component});
    }
}

void PlyVertexRows::add(std::span<const double> numbers) {
    std::array<std::array<float, 4>, 4> row{};
    for (const Field& f : fields_) {
        const bool colour = f.attribute == static_cast<std::size_t>(Attribute::Colour);
        const double number = numbers[f.property];
        const bool position = f.attribute == static_cast<std::size_t>(Attribute::Position);
        const double zero = position ? mesh_.origin.at[f.component] : 0;
        row[f.attribute][f.component] =
            colour ? plyFraction(f.type, number) : static_cast<float>(number - zero);
    }
    const auto& [position, normal, colour, texcoord] = row;
    mesh_.positions.push_back({position[0], position[1], position[2]});
    if (has_[1]) mesh_.normals.push_back({normal[0], normal[1], normal[2]});
    if (has_[2]) mesh_.colours.push_back(decode_({colour[0], colour[1], colour[2]}));
    if (has_[3]) mesh_.texcoords.push_back({texcoord[0], texcoord[1]});
}

} // namespace rtcore
