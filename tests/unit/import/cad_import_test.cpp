// Surfaces of CAD programs: files that Open CASCADE writes, read back as triangles.
#include "rtcore/io/import/cad/cad_import.h"
#include "rtcore/io/import/cad/cad_parts.h"

#include "import_support.h"
#include "support/damaged_text.h"

#include "rtcore/io/scene_loader.h"
#include "rtcore/platform/error.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <Message.hxx>
#include <Quantity_ColorRGBA.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp_Explorer.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gp_Trsf.hxx>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>

namespace {

using namespace rtcore;
using test::TemporaryFolder;

/// A red box of 10 x 20 x 30 whose first face is blue, and two instances of a cylinder of radius 5 and height
/// 40 at x = 100 and 200, in an assembly.
Handle(TDocStd_Document) assembly() {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    Handle(TDocStd_Document) document;
    XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
    const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const Handle(XCAFDoc_ColorTool) colours = XCAFDoc_DocumentTool::ColorTool(document->Main());
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 20, 30).Shape();
    const TDF_Label boxLabel = shapes->AddShape(box, false), all = shapes->NewShape();
    const TDF_Label cylinder = shapes->AddShape(BRepPrimAPI_MakeCylinder(5, 40).Shape(), false);
    TDataStd_Name::Set(boxLabel, "box");
    TDataStd_Name::Set(cylinder, "pin");
    TDataStd_Name::Set(all, "frame");
    colours->SetColor(boxLabel, Quantity_Color(1, 0, 0, Quantity_TOC_RGB), XCAFDoc_ColorSurf);
    const TDF_Label face = shapes->AddSubShape(boxLabel, TopExp_Explorer(box, TopAbs_FACE).Current());
    colours->SetColor(face, Quantity_Color(0, 0, 1, Quantity_TOC_RGB), XCAFDoc_ColorSurf);
    shapes->AddComponent(all, boxLabel, TopLoc_Location());
    for (const double x : {100.0, 200.0}) {
        gp_Trsf to;
        to.SetTranslation(gp_Vec(x, 0, 0));
        shapes->AddComponent(all, cylinder, TopLoc_Location(to));
    }
    shapes->UpdateAssemblies();
    return document;
}

void writeStep(const std::filesystem::path& path) {
    STEPCAFControl_Writer writer;
    writer.Transfer(assembly());
    ASSERT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
}

double volume(const FileImport& import, std::size_t part) {
    const ModelPart& range = import.model.parts[part];
    double sum = 0;
    for (std::uint32_t t = range.firstTriangle; t < range.firstTriangle + range.triangleCount; ++t) {
        const auto p = [&](std::size_t i) {
            return import.model.vertices[import.model.triangles[t].v[i]].position();
        };
        sum += static_cast<double>(dot(p(0), cross(p(1), p(2)))) / 6;
    }
    return sum;
}

std::string nameOf(const FileImport& import, std::size_t part) {
    return import.model.strings.data() + import.model.parts[part].nameOffset;
}

/// Assemblies of ten of the assembly below each, with a box at the bottom.
Handle(TDocStd_Document) nestedAssemblies(int levels) {
    Handle(TDocStd_Document) document;
    XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
    const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    TDF_Label below = shapes->AddShape(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), false);
    for (int level = 0; level < levels; ++level) {
        const TDF_Label above = shapes->NewShape();
        for (int i = 0; i < 10; ++i) {
            gp_Trsf to;
            to.SetTranslation(gp_Vec(2 * i, level, 0));
            shapes->AddComponent(above, below, TopLoc_Location(to));
        }
        below = above;
    }
    return document;
}

TEST(CadImport, AssembliesAreCountedBeforeMemoryGoes) {
    EXPECT_EQ(cadPartsOf(nestedAssemblies(2), 1'000'000).size(), 100U);
    try {
        cadPartsOf(nestedAssemblies(9), 0);
        ADD_FAILURE() << "accepted";
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("1000000000 parts, more than"), std::string::npos)
            << error.what();
    }
    try {
        cadPartsOf(nestedAssemblies(4), 1'000'000);
        ADD_FAILURE() << "accepted";
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("10000 parts and 60000 triangles, which take 10 MB"),
                  std::string::npos)
            << error.what();
    }
}

TEST(CadImport, AssembliesOfStep) {
    const TemporaryFolder folder;
    writeStep(folder / "a.step");
    const FileImport import = importCad(folder / "a.step", {});
    ASSERT_EQ(import.model.parts.size(), 3U);
    EXPECT_EQ(nameOf(import, 0), "frame/box");
    EXPECT_EQ(nameOf(import, 2), "frame/pin");
    EXPECT_EQ(import.report.origin.metresPerUnit, 0.001);
    EXPECT_NEAR(volume(import, 0), 6000, 1e-2);
    const double pin = std::numbers::pi * 25 * 40;
    for (const std::size_t part : {1U, 2U}) {
        EXPECT_LT(volume(import, part), pin);
        EXPECT_GT(volume(import, part), 0.98 * pin);
    }
    float right = 0;
    for (const Vertex& v : import.model.vertices) right = std::max(right, v.x);
    EXPECT_NEAR(right, 205, 1e-3);
    std::map<std::string, int> triangles;
    for (std::uint32_t t = 0; t < 12; ++t) {
        const Colour c = import.model.materials[import.model.shading[t].material].diffuse;
        ++triangles[c == Colour{1, 0, 0} ? "red" : c == Colour{0, 0, 1} ? "blue" : "other"];
    }
    EXPECT_EQ(triangles, (std::map<std::string, int>{{"red", 10}, {"blue", 2}}));
}

TEST(CadImport, NormalsAreThoseOfTheSurface) {
    const TemporaryFolder folder;
    writeStep(folder / "a.step");
    const FileImport import = importCad(folder / "a.step", {});
    const ModelPart& pin = import.model.parts[1];
    int round = 0;
    for (std::uint32_t t = pin.firstTriangle; t < pin.firstTriangle + pin.triangleCount; ++t) {
        for (int c = 0; c < 3; ++c) {
            const Vec3 p = import.model.vertices[import.model.triangles[t].v[c]].position();
            const Vec3 n = normalize(import.model.normals[import.model.shading[t].v[c]]);
            if (std::fabs(n.z) > 0.5F) continue;
            ++round;
            EXPECT_TRUE(test::near(n, Vec3{(p.x - 100) / 5, p.y / 5, 0}, 1e-3F));
        }
    }
    EXPECT_GT(round, 50);
}

TEST(CadImport, DeflectionSaysHowFine) {
    const TemporaryFolder folder;
    writeStep(folder / "a.step");
    FileImportOptions fine, coarse;
    fine.deflection = 1e-5F;
    coarse.deflection = 0.05F;
    EXPECT_GT(importCad(folder / "a.step", fine).model.triangles.size(),
              2 * importCad(folder / "a.step", coarse).model.triangles.size());
}

TEST(CadImport, IgesAndBrep) {
    const TemporaryFolder folder;
    IGESCAFControl_Writer writer;
    writer.Transfer(assembly());
    ASSERT_TRUE(writer.Write((folder / "a.igs").c_str()));
    const FileImport iges = importCad(folder / "a.igs", {});
    EXPECT_EQ(iges.report.origin.metresPerUnit, 0.001);
    ASSERT_TRUE(BRepTools::Write(BRepPrimAPI_MakeBox(10, 20, 30).Shape(), (folder / "a.brep").c_str()));
    const FileImport brep = importCad(folder / "a.brep", {});
    EXPECT_EQ(brep.model.triangles.size(), 12U);
    EXPECT_FALSE(brep.report.origin.metresPerUnit);
    EXPECT_NEAR(volume(brep, 0), 6000, 1e-2);
}

std::string textOf(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST(CadImport, WhatCannotBeReadIsSaid) {
    const TemporaryFolder folder;
    const auto complaint = [&](const std::string& text) {
        test::writeText(folder / "a.step", text);
        try {
            importCad(folder / "a.step", {});
        } catch (const FileError& error) {
            return std::string(error.what());
        }
        return std::string("none");
    };
    writeStep(folder / "whole.step");
    const std::string whole = textOf(folder / "whole.step");
    EXPECT_NE(complaint(whole.substr(0, whole.size() / 2)).find("it is cut off"), std::string::npos);
    const std::string empty = whole.substr(0, whole.find("DATA;") + 5) + "\nENDSEC;\nEND-ISO-10303-21;\n";
    EXPECT_NE(
        complaint(empty).find("a STEP file of CAD surfaces, none of which can be read; export it as STL"),
        std::string::npos);
}

TEST(CadImport, TheProgramIsToldTheDeflection) {
    const TemporaryFolder folder;
    writeStep(folder / "a.step");
    ImportOptions coarse;
    coarse.deflection = 0.05F;
    const std::size_t usual = test::importFile(folder / "a.step").model.mesh.triangles.size();
    EXPECT_LT(test::importFile(folder / "a.step", coarse).model.mesh.triangles.size(), usual);
}

TEST(CadImport, AScenesDeflectionIsThatOfItsModelAndOptionsWin) {
    const TemporaryFolder folder;
    writeStep(folder / "a.step");
    test::writeText(folder / "a.scn", "version = 2\nmodel = \"a.step\"\ndeflection = 0.05\n");
    const auto triangles = [&](const char* name, const LoadOptions& options = {}) {
        ::setenv("RT_IMPORTER", RT_TEST_IMPORTER, 1);
        return loadScene(folder / name, options).scene.model.mesh.triangles.size();
    };
    LoadOptions usual;
    usual.import.deflection = kDeflection;
    EXPECT_LT(triangles("a.scn"), triangles("a.step"));
    EXPECT_EQ(triangles("a.scn", usual), triangles("a.step"));
}

/// By the program: rtimport hands over to rtimport_cad.
TEST(CadImport, TheImporterHandsOver) {
    const TemporaryFolder folder;
    writeStep(folder / "a.stp");
    const ImportedModel imported = test::importFile(folder / "a.stp");
    EXPECT_EQ(imported.model.parts.size(), 3U);
    EXPECT_EQ(imported.report.origin.format, "Open CASCADE (STEP, IGES, BREP)");
}

TEST(CadImport, FieldCases) {
    const char* const scenes = std::getenv("RT_TEST_SCENES");
    if (scenes == nullptr) GTEST_SKIP() << "RT_TEST_SCENES is not set";
    const std::filesystem::path path = std::filesystem::path(scenes) / "field3/cad/cad.step";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "no field cases";
    try {
        EXPECT_FALSE(importCad(path, {}).model.triangles.empty());
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("export it as STL"), std::string::npos) << error.what();
    }
}

} // namespace
