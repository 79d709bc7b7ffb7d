/// Notes of files on their up axis, their unit and the program that wrote them come through the importer.
#include "import_support.h"

#include "rtcore/scene/model_origin.h"

#include <gtest/gtest.h>

namespace {

using namespace rtcore;

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

ModelOrigin originOf(const std::string& name, const std::string& text) {
    return test::importText(name, text).report.origin;
}

std::string asciiStl(const std::string& name) {
    return "solid " + name +
           "\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
           "0\nendloop\nendfacet\nendsolid\n";
}

std::string binaryStl(std::string head) {
    head.resize(80, ' ');
    const std::uint32_t one = 1;
    const float numbers[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    head.append(reinterpret_cast<const char*>(&one), 4);
    head.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
    return head + std::string(2, '\0');
}

TEST(ExporterNotes, CommentsNameTheProgram) {
    EXPECT_EQ(
        originOf("a.obj", "# Blender v2.79 (sub 0) OBJ File: ''\r\n# www.blender.org\n" + kTriangle).exporter,
        "Blender v2.79 (sub 0) OBJ File: '' www.blender.org");
    EXPECT_EQ(originOf("a.obj", kTriangle + "# too late\n").exporter, "");
    EXPECT_EQ(originOf("a.stl", asciiStl("OpenSCAD_Model")).exporter, "solid OpenSCAD_Model");
    EXPECT_EQ(originOf("a.stl", binaryStl("Exported from Blender-3.4.1")).exporter,
              "Exported from Blender-3.4.1");
    const std::string ply =
        "ply\nformat ascii 1.0\ncomment Created by X\nelement vertex 3\nproperty float x\n"
        "property float y\nproperty float z\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    EXPECT_EQ(originOf("a.ply", ply).exporter, "Created by X");
}

TEST(ExporterNotes, AUnitThatIsStatedCounts) {
    EXPECT_EQ(originOf("a.obj", "# File units = inches\n" + kTriangle).metresPerUnit, 0.0254);
    EXPECT_EQ(originOf("a.obj", "# units: mm\n" + kTriangle).metresPerUnit, 0.001);
    EXPECT_EQ(originOf("a.obj", "# File units = parsecs\n" + kTriangle).metresPerUnit, std::nullopt);
    EXPECT_EQ(originOf("a.obj", "# Uses units\n" + kTriangle).metresPerUnit, std::nullopt);
    EXPECT_EQ(originOf("a.obj", kTriangle).up, std::nullopt);
}

TEST(ExporterNotes, OddHeadsAreOneLineOfText) {
    const std::string notes = originOf("a.stl", binaryStl(std::string("\x01\xFF odd\x7F head", 12))).exporter;
    EXPECT_EQ(notes.find_first_of("\x01\xFF\x7F\n"), std::string::npos);
    EXPECT_LE(originOf("a.obj", "# " + std::string(5000, 'x') + "\n" + kTriangle).exporter.size(), 2000U);
}

TEST(ModelOrigin, LinesThatAreNoneAreSkipped) {
    EXPECT_EQ(readOrigin("up sideways\nmetresPerUnit -3\nmetresPerUnit nan\nother x\nformat\n"),
              ModelOrigin{});
    const ModelOrigin origin{"F", "E e", Vec3{0, -1, 0}, 0.3048};
    EXPECT_EQ(readOrigin(writeOrigin(origin)), origin);
    EXPECT_LE(writeOrigin({std::string(9999, 'f'), std::string(9999, 'e'), Vec3{0, 1, 0}, 1e-300}).size(),
              kMaxOriginBytes);
}

} // namespace
