/// Models written by the tests, imported by the real program.
#pragma once

#include "rtcore/io/import/model_import.h"
#include "support/temporary_folder.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace test {

/// Points RT_IMPORTER at a program for the lifetime of the object.
class ChosenImporter {
  public:
    explicit ChosenImporter(const std::filesystem::path& program) {
        ::setenv("RT_IMPORTER", program.c_str(), 1);
    }
    ~ChosenImporter() { ::setenv("RT_IMPORTER", RT_TEST_IMPORTER, 1); }
    ChosenImporter(const ChosenImporter&) = delete;
    ChosenImporter& operator=(const ChosenImporter&) = delete;
};

/// A new file, also where there is one: file systems wait for the disk when one is emptied and closed.
inline void writeText(const std::filesystem::path& path, const std::string& text) {
    std::filesystem::remove(path);
    std::ofstream(path, std::ios::binary) << text;
}

inline rtcore::ImportedModel importFile(const std::filesystem::path& path,
                                        const rtcore::ImportOptions& options = {}) {
    ::setenv("RT_IMPORTER", RT_TEST_IMPORTER, 1);
    return rtcore::importModel(path, options);
}

/// Writes one file of this name and imports it.
inline rtcore::ImportedModel importText(const std::string& name, const std::string& text,
                                        const rtcore::ImportOptions& options = {}) {
    const TemporaryFolder folder;
    writeText(folder / name, text);
    return importFile(folder / name, options);
}

inline double areaOf(const rtcore::Mesh& mesh) {
    double sum = 0;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        sum += 0.5 * static_cast<double>(rtcore::length(mesh.geometricNormal(t)));
    }
    return sum;
}

/// Six times the enclosed volume would be negative for triangles that face inwards.
inline double volumeOf(const rtcore::Mesh& mesh) {
    double sum = 0;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto p = [&](int i) { return mesh.position(t, i); };
        sum += static_cast<double>(rtcore::dot(p(0), rtcore::cross(p(1), p(2)))) / 6;
    }
    return sum;
}

inline rtcore::Vec3 normalOf(const rtcore::Mesh& mesh, std::uint32_t triangle, int corner) {
    return mesh.normals[mesh.shading[triangle].v[corner]];
}

inline const rtcore::Material& materialNamed(const rtcore::Model& model, const std::string& name) {
    for (const rtcore::Material& m : model.materials) {
        if (model.name(m.nameOffset) == name) return m;
    }
    throw std::runtime_error("no material " + name);
}

inline bool near(rtcore::Vec3 a, rtcore::Vec3 b, float tolerance = 1e-4F) {
    return rtcore::length(a - b) <= tolerance;
}
inline bool near(rtcore::Colour a, rtcore::Colour b, float tolerance = 1e-4F) {
    return near(rtcore::Vec3{a.r, a.g, a.b}, rtcore::Vec3{b.r, b.g, b.b}, tolerance);
}

/// The cube [-1, 1]^3 of six quads that face outwards, as OBJ.
inline const char* const kCubeObj = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\n"
                                    "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
                                    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

} // namespace test
