/// Reads positions and faces of PLY and OBJ files for tests, independent of the importer that it helps to
/// check. Trusts its files: good for the models of the tests only.
#pragma once

#include "support/sample_meshes.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test {

static_assert(std::endian::native == std::endian::little);

/// Positions x, y, z first in the vertices; triangles or convex polygons; ASCII or little-endian binary.
class PlyReader {
  public:
    explicit PlyReader(const std::filesystem::path& path)
        : in_(path, std::ios::binary), path_(path.string()) {}

    SampleMesh read() {
        const std::vector<Element> elements = readHeader();
        SampleMesh mesh;
        for (const Element& element : elements) {
            for (std::size_t i = 0; i < element.count && in_; ++i) {
                readRecord(element, mesh);
            }
        }
        if (!in_) throw std::runtime_error(path_ + ": too short");
        return mesh;
    }

  private:
    struct Property {
        std::string countType, type; ///< countType is empty unless it is a list
    };
    struct Element {
        std::string name;
        std::size_t count = 0;
        std::vector<Property> properties;
    };

    std::vector<Element> readHeader() {
        std::vector<Element> elements;
        for (std::string line; std::getline(in_, line) && line.rfind("end_header", 0) != 0;) {
            std::istringstream words(line);
            std::string word;
            words >> word;
            if (word == "format") {
                words >> word;
                ascii_ = word == "ascii";
            } else if (word == "element") {
                elements.emplace_back();
                words >> elements.back().name >> elements.back().count;
            } else if (word == "property" && !elements.empty()) {
                Property property;
                words >> property.type;
                if (property.type == "list") words >> property.countType >> property.type;
                elements.back().properties.push_back(property);
            }
        }
        return elements;
    }

    void readRecord(const Element& element, SampleMesh& mesh) {
        std::vector<double> values;
        for (const Property& property : element.properties) {
            const double count = property.countType.empty() ? 1 : number(property.countType);
            for (int i = 0; i < static_cast<int>(count); ++i) values.push_back(number(property.type));
        }
        if (element.name == "vertex" && values.size() >= 3) {
            mesh.addVertex({static_cast<float>(values[0]), static_cast<float>(values[1]),
                            static_cast<float>(values[2])});
        }
        if (element.name != "face") return;
        const auto index = [&](std::size_t i) { return static_cast<std::uint32_t>(values[i]); };
        for (std::size_t i = 2; i < values.size(); ++i) {
            mesh.triangles.push_back({{index(0), index(i - 1), index(i)}});
        }
    }

    double number(const std::string& type) {
        double value = 0;
        if (ascii_) {
            in_ >> value;
            return value;
        }
        if (type == "float" || type == "float32") return binary<float>();
        if (type == "double" || type == "float64") return binary<double>();
        if (type == "uchar" || type == "uint8") return binary<std::uint8_t>();
        if (type == "char" || type == "int8") return binary<std::int8_t>();
        if (type == "ushort" || type == "uint16") return binary<std::uint16_t>();
        if (type == "short" || type == "int16") return binary<std::int16_t>();
        if (type == "int" || type == "int32") return binary<std::int32_t>();
        if (type == "uint" || type == "uint32") return binary<std::uint32_t>();
        throw std::runtime_error(path_ + ": unknown type " + type);
    }
    template <typename T>
    double binary() {
        T value{};
        in_.read(reinterpret_cast<char*>(&value), sizeof value);
        return static_cast<double>(value);
    }

    std::ifstream in_;
    std::string path_;
    bool ascii_ = false;
};

/// Lines "v x y z" and "f a/b/c ..."; everything else is passed over.
inline SampleMesh readObj(const std::filesystem::path& path) {
    std::ifstream in(path);
    SampleMesh mesh;
    for (std::string line; std::getline(in, line);) {
        const char* at = line.c_str();
        char* end = nullptr;
        if (line.rfind("v ", 0) == 0) {
            rtcore::Vec3 p;
            at += 1;
            for (int axis = 0; axis < 3; ++axis, at = end) p[axis] = std::strtof(at, &end);
            mesh.addVertex(p);
        } else if (line.rfind("f ", 0) == 0) {
            std::vector<std::uint32_t> corners;
            for (at += 1; *(at += std::strspn(at, " \t\r")) != 0; at += std::strcspn(at, " \t\r")) {
                const long index = std::strtol(at, nullptr, 10);
                const auto count = static_cast<long>(mesh.vertices.size());
                corners.push_back(static_cast<std::uint32_t>(index < 0 ? count + index : index - 1));
            }
            for (std::size_t i = 2; i < corners.size(); ++i) {
                mesh.triangles.push_back({{corners[0], corners[i - 1], corners[i]}});
            }
        }
    }
    return mesh;
}

/// Throws std::runtime_error when the file holds no mesh.
inline SampleMesh readMesh(const std::filesystem::path& path) {
    SampleMesh mesh = path.extension() == ".obj" ? readObj(path) : PlyReader(path).read();
    if (mesh.triangles.empty()) throw std::runtime_error(path.string() + ": no triangles");
    for (const rtcore::Triangle& t : mesh.triangles) {
        for (const std::uint32_t v : t.v) {
            if (v >= mesh.vertices.size()) throw std::runtime_error(path.string() + ": a vertex is missing");
        }
    }
    return mesh;
}

} // namespace test
