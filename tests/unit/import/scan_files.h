/// Binary PLY and STL files of every kind, made by the tests.
#pragma once

#include "rtcore/math/vec.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace test {

/// A number in the bytes of a file.
struct PlyNumber {
    std::string type;
    double value;
};

inline std::string plyBytes(const PlyNumber& number, bool bigEndian) {
    const auto bytes = [&](auto value) {
        std::string text(sizeof value, '\0');
        std::memcpy(text.data(), &value, sizeof value);
        if (bigEndian != (std::endian::native == std::endian::big)) std::reverse(text.begin(), text.end());
        return text;
    };
    const std::string& type = number.type;
    if (type == "char" || type == "int8") return bytes(static_cast<std::int8_t>(number.value));
    if (type == "uchar" || type == "uint8") return bytes(static_cast<std::uint8_t>(number.value));
    if (type == "short" || type == "int16") return bytes(static_cast<std::int16_t>(number.value));
    if (type == "ushort" || type == "uint16") return bytes(static_cast<std::uint16_t>(number.value));
    if (type == "int" || type == "int32") return bytes(static_cast<std::int32_t>(number.value));
    if (type == "uint" || type == "uint32") return bytes(static_cast<std::uint32_t>(number.value));
    if (type == "double" || type == "float64") return bytes(number.value);
    return bytes(static_cast<float>(number.value));
}

/// The contents from which a PLY file is written.
struct PlyFile {
    struct Property {
        std::string type, name;
        std::vector<double> values; ///< by vertex, over again from the first when there are more vertices
    };

    bool bigEndian = false;
    std::string positionType = "float", lengthType = "uchar", indexType = "int";
    std::string indexName = "vertex_indices";
    std::vector<std::array<double, 3>> positions;
    std::vector<Property> attributes = {};              ///< of vertices, behind the position
    std::vector<std::vector<double>> faces = {};        ///< vertices
    std::string before = {}, between = {}, behind = {}; ///< types of other properties: in front of the
                                                        ///< vertices' x, the faces' list and behind that
    std::string otherElement = {};                      ///< type of its one property; before the vertices
    std::string otherName = "edge";
    std::string headLines = "comment made by a test\n"; ///< behind the format

    std::string text() const {
        std::string file =
            "ply\nformat binary_" + std::string(bigEndian ? "big" : "little") + "_endian 1.0\n" + headLines;
        const auto property = [&](const std::string& type, const std::string& name) {
            if (!type.empty()) file += "property " + type + " " + name + "\n";
        };
        if (!otherElement.empty()) file += "element " + otherName + " 3\n";
        property(otherElement, "view");
        file += "element vertex " + std::to_string(positions.size()) + "\n";
        property(before, "quality");
        for (const char* name : {"x", "y", "z"}) property(positionType, name);
        for (const Property& a : attributes) property(a.type, a.name);
        file += "element face " + std::to_string(faces.size()) + "\n";
        property(between, "flags");
        file += "property list " + lengthType + " " + indexType + " " + indexName + "\n";
        property(behind, "region");
        file += "end_header\n";
        addData(file);
        return file;
    }

  private:
    void addData(std::string& file) const {
        const auto put = [&](const std::string& type, double value) {
            if (!type.empty()) file += plyBytes({type, value}, bigEndian);
        };
        for (int i = 0; i < 3; ++i) put(otherElement, i);
        for (std::size_t v = 0; v < positions.size(); ++v) {
            put(before, 7);
            for (const double p : positions[v]) put(positionType, p);
            for (const Property& a : attributes) put(a.type, a.values[v % a.values.size()]);
        }
        for (const std::vector<double>& face : faces) {
            put(between, 1);
            put(lengthType, static_cast<double>(face.size()));
            for (const double v : face) put(indexType, v);
            put(behind, 2);
        }
    }
};

/// A binary STL file of triangles, three corners each, little-endian.
inline std::string stlText(const std::vector<std::array<rtcore::Vec3, 3>>& triangles,
                           const std::string& title = "a test", std::uint16_t attribute = 0) {
    std::string file = title;
    file.resize(80, '\0');
    const auto put = [&](const std::string& type, double value) { file += plyBytes({type, value}, false); };
    put("uint", static_cast<double>(triangles.size()));
    for (const auto& corners : triangles) {
        for (const double n : {0.0, 0.0, 1.0}) put("float", n);
        for (const rtcore::Vec3& p : corners) {
            for (const float v : {p.x, p.y, p.z}) put("float", static_cast<double>(v));
        }
        put("ushort", attribute);
    }
    return file;
}

} // namespace test
