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

// A box of 3 x 2 x 2.5 m in millimetres, upright in z, as it is turned and scaled by what the file says.
constexpr const char* kBuilding = R"(ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('','',(''),(''),'','','');
FILE_SCHEMA(('IFC2X3'));
ENDSEC;
DATA;
#1=IFCPERSON($,'a',$,$,$,$,$,$);
#2=IFCORGANIZATION($,'a',$,$,$);
#3=IFCPERSONANDORGANIZATION(#1,#2,$);
#4=IFCAPPLICATION(#2,'1','a','a');
#5=IFCOWNERHISTORY(#3,#4,$,.ADDED.,$,$,$,0);
#6=IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.);
#7=IFCUNITASSIGNMENT((#6));
#8=IFCCARTESIANPOINT((0.,0.,0.));
#9=IFCAXIS2PLACEMENT3D(#8,$,$);
#10=IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-5,#9,$);
#11=IFCPROJECT('1AAAAAAAAAAAAAAAAAAAA1',#5,'p',$,$,$,$,(#10),#7);
#12=IFCLOCALPLACEMENT($,#9);
#13=IFCSITE('1AAAAAAAAAAAAAAAAAAAA2',#5,'s',$,$,#12,$,$,.ELEMENT.,$,$,$,$,$);
#14=IFCBUILDING('1AAAAAAAAAAAAAAAAAAAA3',#5,'b',$,$,#12,$,$,.ELEMENT.,$,$,$);
#15=IFCRELAGGREGATES('1AAAAAAAAAAAAAAAAAAAA4',#5,$,$,#11,(#13));
#16=IFCRELAGGREGATES('1AAAAAAAAAAAAAAAAAAAA5',#5,$,$,#13,(#14));
#17=IFCCARTESIANPOINT((1500.,1000.));
#18=IFCAXIS2PLACEMENT2D(#17,$);
#19=IFCRECTANGLEPROFILEDEF(.AREA.,$,#18,3000.,2000.);
#20=IFCDIRECTION((0.,0.,1.));
#21=IFCEXTRUDEDAREASOLID(#19,#9,#20,2500.);
#22=IFCSHAPEREPRESENTATION(#10,'Body','SweptSolid',(#21));
#23=IFCPRODUCTDEFINITIONSHAPE($,$,(#22));
#24=IFCBUILDINGELEMENTPROXY('1AAAAAAAAAAAAAAAAAAAA6',#5,'box',$,$,#12,#23,$,$);
#25=IFCRELCONTAINEDINSPATIALSTRUCTURE('1AAAAAAAAAAAAAAAAAAAA7',#5,$,$,(#24),#14);
ENDSEC;
END-ISO-10303-21;
)";

TEST(ExporterNotes, BuildingsAreInMetres) {
    const auto import = test::importText("a.ifc", kBuilding);
    EXPECT_EQ(import.report.origin.metresPerUnit, 1);
    EXPECT_EQ(import.report.origin.up, (Vec3{0, 1, 0}));
    Box3 bounds;
    const Mesh& mesh = import.model.mesh;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (int corner = 0; corner < 3; ++corner) bounds.extend(mesh.position(t, corner));
    EXPECT_NEAR(length(bounds.hi - bounds.lo - Vec3{3, 2.5F, 2}), 0, 1e-5);
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
