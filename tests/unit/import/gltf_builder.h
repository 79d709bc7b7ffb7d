/// glTF files put together by tests, piece by piece.
#pragma once

#include "rtcore/io/import/gltf/gltf_import.h"
#include "support/temporary_folder.h"
#include "unit/import/gltf_text.h"
#include "unit/import/import_support.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace test {

using Json = nlohmann::json;

/// The numbers of glTF for kinds of components.
template <typename T>
constexpr int componentType() {
    if constexpr (std::is_same_v<T, std::int8_t>) return 5120;
    if constexpr (std::is_same_v<T, std::uint8_t>) return 5121;
    if constexpr (std::is_same_v<T, std::int16_t>) return 5122;
    if constexpr (std::is_same_v<T, std::uint16_t>) return 5123;
    if constexpr (std::is_same_v<T, std::uint32_t>) return 5125;
    return 5126;
}

class GltfBuilder {
  public:
    Json root = {{"asset", {{"version", "2.0"}}},
                 {"accessors", Json::array()},
                 {"bufferViews", Json::array()},
                 {"meshes", Json::array()},
                 {"nodes", Json::array()}};
    std::string bytes; ///< of buffer 0

    int view(std::string_view content, int stride = 0) {
        while (bytes.size() % 4 != 0) bytes += '\0';
        Json stated = {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", content.size()}};
        if (stride > 0) stated["byteStride"] = stride;
        root["bufferViews"].push_back(stated);
        bytes += content;
        return static_cast<int>(root["bufferViews"].size()) - 1;
    }
    template <typename T>
    int accessor(const std::vector<T>& numbers, const std::string& type, bool normalized = false) {
        const std::size_t components = type == "SCALAR" ? 1
                                       : type == "VEC2" ? 2
                                       : type == "VEC3" ? 3
                                       : type == "VEC4" ? 4
                                                        : 16;
        const std::string_view content(reinterpret_cast<const char*>(numbers.data()),
                                       numbers.size() * sizeof(T));
        Json stated = {{"bufferView", view(content)},
                       {"componentType", componentType<T>()},
                       {"count", numbers.size() / components},
                       {"type", type}};
        if (normalized) stated["normalized"] = true;
        return accessor(stated);
    }
    int accessor(const Json& stated) {
        root["accessors"].push_back(stated);
        return static_cast<int>(root["accessors"].size()) - 1;
    }
    int mesh(const Json& primitives) {
        root["meshes"].push_back({{"primitives", primitives}});
        return static_cast<int>(root["meshes"].size()) - 1;
    }
    int node(const Json& stated) {
        root["nodes"].push_back(stated);
        return static_cast<int>(root["nodes"].size()) - 1;
    }
    /// A node with a mesh of one primitive.
    int show(const Json& primitive) { return node({{"mesh", mesh(Json::array({primitive}))}}); }

    std::string binary() const {
        Json whole = root;
        whole["buffers"] = {{{"byteLength", bytes.size()}}};
        return container(whole.dump(), bytes);
    }
    static std::string container(std::string json, std::string body, bool padded = true) {
        while (padded && json.size() % 4 != 0) json += ' ';
        while (padded && body.size() % 4 != 0) body += '\0';
        const std::string chunks =
            word(json.size()) + "JSON" + json + word(body.size()) + std::string("BIN", 4) + body;
        return "glTF" + word(2) + word(12 + chunks.size()) + chunks;
    }
    static std::string word(std::size_t value) {
        std::string four;
        for (unsigned shift = 0; shift < 32; shift += 8) four += static_cast<char>(value >> shift & 0xFFU);
        return four;
    }

    rtcore::FileImport import() const { return importBytes("m.glb", binary()); }
    static rtcore::FileImport importBytes(const std::string& name, const std::string& content) {
        const TemporaryFolder folder;
        writeText(folder / name, content);
        auto read = rtcore::importGltf(folder / name, {});
        if (!read) throw std::runtime_error("no glTF");
        return std::move(*read);
    }
};

/// Two triangles that make the square (0 0 0) (1 1 0), seen from +z.
inline const std::vector<float> kSquare{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
inline const std::vector<std::uint16_t> kSquareCorners{0, 1, 2, 0, 2, 3};

/// A file that shows it.
inline GltfBuilder squareFile() {
    GltfBuilder file;
    const int positions = file.accessor(kSquare, "VEC3");
    const int corners = file.accessor(kSquareCorners, "SCALAR");
    file.show({{"attributes", {{"POSITION", positions}}}, {"indices", corners}});
    return file;
}

inline rtcore::Mesh meshOf(const rtcore::ModelBuffers& model) {
    return {model.vertices,  model.triangles, model.shading, model.normals,
            model.texcoords, model.colours,   model.alphas};
}

/// In the coordinates of the file.
inline rtcore::Vec3 cornerInFile(const rtcore::FileImport& import, std::uint32_t triangle, int corner) {
    const auto [x, y, z] = import.report.origin.zero.inFile(meshOf(import.model).position(triangle, corner));
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

inline std::string warningsOf(const rtcore::FileImport& import) {
    std::string text;
    for (const rtcore::Sentence& warning : import.report.warnings) text += warning.english() + "\n";
    return text;
}

/// Why a file is refused; "" when it is not.
inline std::string refusalOf(const GltfBuilder& file) {
    try {
        file.import();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

} // namespace test
