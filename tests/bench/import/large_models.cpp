#include "bench/import/large_models.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace bench {

namespace {

constexpr std::uint32_t kColumns = 2500, kRows = 2000, kWidth = kColumns + 1;

struct Kind {
    std::uint32_t objects;
    bool normals, texcoords, quads;
};

struct Point {
    float x, y, z;
};

Point positionAt(std::uint32_t column, std::uint32_t row) {
    const float u = static_cast<float>(column) / kColumns, v = static_cast<float>(row) / kRows;
    return {10 * u - 5, 0.3F * std::sin(20 * u) * std::cos(15 * v), 8 * v - 4};
}

Point normalAt(std::uint32_t column, std::uint32_t row) {
    const float u = static_cast<float>(column) / kColumns, v = static_cast<float>(row) / kRows;
    const float x = -0.6F * std::cos(20 * u) * std::cos(15 * v),
                z = 0.56F * std::sin(20 * u) * std::sin(15 * v);
    const float length = std::sqrt(x * x + 1 + z * z);
    return {x / length, 1 / length, z / length};
}

/// Rows of quads of one object; `Use` gets the numbers of a quad's corners, counted from its first row.
struct Strip {
    std::uint32_t firstRow, rows;

    std::size_t vertices() const { return std::size_t{rows + 1} * kWidth; }

    template <typename Use>
    void forEachQuad(const Use& use) const {
        for (std::uint32_t row = 0; row < rows; ++row) {
            for (std::uint32_t column = 0; column < kColumns; ++column) {
                const std::uint32_t a = row * kWidth + column;
                use(a, a + kWidth, a + kWidth + 1, a + 1);
            }
        }
    }
    template <typename Use>
    void forEachVertex(const Use& use) const {
        for (std::uint32_t row = 0; row <= rows; ++row)
            for (std::uint32_t column = 0; column < kWidth; ++column) use(column, firstRow + row);
    }
};

std::vector<Strip> stripsOf(std::uint32_t objects) {
    std::vector<Strip> strips;
    for (std::uint32_t i = 0; i < objects; ++i) {
        const std::uint32_t first = kRows * i / objects;
        strips.push_back({first, kRows * (i + 1) / objects - first});
    }
    return strips;
}

/// Accessors, each with a view of its own, of the chunk that comes to lie behind the JSON.
class GlbFile {
  public:
    void add(const Strip& strip, const Kind& kind) {
        std::vector<float> positions, normals, texcoords;
        strip.forEachVertex([&](std::uint32_t column, std::uint32_t row) {
            const Point p = positionAt(column, row), n = normalAt(column, row);
            positions.insert(positions.end(), {p.x, p.y, p.z});
            if (kind.normals) normals.insert(normals.end(), {n.x, n.y, n.z});
            if (kind.texcoords)
                texcoords.insert(texcoords.end(),
                                 {static_cast<float>(column) / kColumns, static_cast<float>(row) / kRows});
        });
        std::vector<std::uint32_t> corners;
        strip.forEachQuad([&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
            corners.insert(corners.end(), {a, b, c, a, c, d});
        });
        std::string attributes = fmt::format(R"("POSITION":{})", addList(positions, 3, "VEC3"));
        if (kind.normals) attributes += fmt::format(R"(,"NORMAL":{})", addList(normals, 3, "VEC3"));
        if (kind.texcoords) attributes += fmt::format(R"(,"TEXCOORD_0":{})", addList(texcoords, 2, "VEC2"));
        const std::size_t indices = addList(corners, 1, "SCALAR");
        append(meshes_, fmt::format(R"({{"primitives":[{{"attributes":{{{}}},"indices":{}}}]}})", attributes,
                                    indices));
        append(nodes_, fmt::format(R"({{"name":"strip {0}","mesh":{0}}})", nodeCount_));
        append(roots_, fmt::format("{}", nodeCount_++));
    }

    void write(std::ofstream& file) const {
        std::string json = fmt::format(
            R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[{}]}}],"nodes":[{}],"meshes":[{}],)"
            R"("accessors":[{}],"bufferViews":[{}],"buffers":[{{"byteLength":{}}}]}})",
            roots_, nodes_, meshes_, accessors_, views_, bytes_.size());
        json.resize((json.size() + 3) / 4 * 4, ' ');
        writeWords(file, {0x46546C67, 2, 12 + 8 + json.size() + 8 + bytes_.size(), json.size(), 0x4E4F534A});
        file << json;
        writeWords(file, {bytes_.size(), 0x004E4942});
        file.write(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
    }

  private:
    static void append(std::string& list, const std::string& element) {
        if (!list.empty()) list += ',';
        list += element;
    }

    static void writeWords(std::ofstream& file, std::initializer_list<std::size_t> words) {
        for (const std::size_t word : words) {
            const auto value = static_cast<std::uint32_t>(word);
            file.write(reinterpret_cast<const char*>(&value), sizeof value);
        }
    }

    /// The number of its accessor.
    template <typename Number>
    std::size_t addList(const std::vector<Number>& numbers, std::size_t components, const char* type) {
        const std::size_t size = numbers.size() * sizeof(Number), offset = bytes_.size();
        bytes_.resize(offset + size);
        std::memcpy(bytes_.data() + offset, numbers.data(), size);
        append(views_, fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{}}})", offset, size));
        const bool isFloat = std::is_same_v<Number, float>;
        append(accessors_,
               fmt::format(R"({{"bufferView":{},"componentType":{},"count":{},"type":"{}"}})", accessorCount_,
                           isFloat ? 5126 : 5125, numbers.size() / components, type));
        return accessorCount_++;
    }

    std::string accessors_, views_, meshes_, nodes_, roots_;
    std::size_t accessorCount_ = 0, nodeCount_ = 0;
    std::vector<char> bytes_;
};

class ObjFile {
  public:
    explicit ObjFile(std::ofstream& file) : file_(file) {}

    void add(const Strip& strip, const Kind& kind) {
        const std::size_t number = strips_++;
        if (kind.objects > 1) put("g strip{0}\nusemtl paint{1}\n", number, number % 7);
        strip.forEachVertex([&](std::uint32_t column, std::uint32_t row) {
            const Point p = positionAt(column, row), n = normalAt(column, row);
            put("v {:.6f} {:.6f} {:.6f}\n", p.x, p.y, p.z);
            if (kind.texcoords)
                put("vt {:.6f} {:.6f}\n", static_cast<float>(column) / kColumns,
                    static_cast<float>(row) / kRows);
            if (kind.normals) put("vn {:.6f} {:.6f} {:.6f}\n", n.x, n.y, n.z);
        });
        strip.forEachQuad([&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
            put("f");
            for (const std::size_t v : {a, b, c}) putCorner(v, strip, kind);
            if (!kind.quads) {
                put("\nf");
                for (const std::size_t v : {a, c}) putCorner(v, strip, kind);
            }
            putCorner(d, strip, kind);
            put("\n");
        });
        first_ += strip.vertices();
        flush();
    }

  private:
    void putCorner(std::size_t v, const Strip& strip, const Kind& kind) {
        const std::size_t count = strip.vertices(), i = first_ + v + 1;
        // Texture coordinates from the last one back, and normals of every second vertex.
        const std::size_t texcoord = kind.quads ? first_ + count - v : i,
                          normal = kind.quads ? first_ + v / 2 + 1 : i;
        if (kind.texcoords) {
            put(" {}/{}/{}", i, texcoord, normal);
        } else if (kind.normals) {
            put(" {}//{}", i, normal);
        } else {
            put(" {}", i);
        }
    }

    template <typename... Arguments>
    void put(fmt::format_string<Arguments...> form, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(text_), form, std::forward<Arguments>(arguments)...);
        if (text_.size() > (std::size_t{1} << 20)) flush();
    }
    void flush() {
        file_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
        text_.clear();
    }

    std::ofstream& file_;
    fmt::memory_buffer text_;
    std::size_t strips_ = 0, first_ = 0; ///< vertices of the strips before
};

Kind kindOf(std::string_view name) {
    if (name == "whole") return {1, true, true, false};
    if (name == "bare") return {1, false, false, false};
    if (name == "objects") return {1000, true, false, false};
    if (name == "quads") return {45, true, true, true};
    throw std::runtime_error("unknown kind of model; whole, bare, objects and quads are known");
}

} // namespace

void writeLargeModel(std::string_view name, const std::filesystem::path& path) {
    const Kind kind = kindOf(name);
    std::ofstream file(path, std::ios::binary);
    if (path.extension() == ".glb") {
        GlbFile glb;
        for (const Strip& strip : stripsOf(kind.objects)) glb.add(strip, kind);
        glb.write(file);
    } else {
        ObjFile obj(file);
        for (const Strip& strip : stripsOf(kind.objects)) obj.add(strip, kind);
    }
    if (!file.flush()) throw std::runtime_error("the model cannot be written");
}

} // namespace bench
