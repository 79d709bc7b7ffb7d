// 3MF: units, objects and where they stand, colours of every kind, and what is refused.
#include "rtcore/io/import/threemf/threemf_import.h"

#include "import_support.h"
#include "support/damaged_text.h"
#include "zip_writer.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/platform/error.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>

namespace {

using namespace rtcore;
using test::TemporaryFolder;

const std::string kRelations =
    R"(<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">)"
    R"(<Relationship Target="/3D/box.model" Id="r" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>)"
    R"(</Relationships>)";

/// A model part: `attributes` of its outermost element, resources, and what is built.
std::string partText(const std::string& resources, const std::string& build,
                     const std::string& attributes = "") {
    return R"(<?xml version="1.0" encoding="UTF-8"?><model xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02")"
           R"( xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02")"
           R"( xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06" )" +
           attributes + "><resources>" + resources + "</resources><build>" + build + "</build></model>";
}

/// A square in the plane z = 0 that faces up, of two triangles with these attributes.
std::string square(const std::string& first = "", const std::string& second = "") {
    return R"(<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="1" y="1" z="0"/>)"
           R"(<vertex x="0" y="1" z="0"/></vertices><triangles><triangle v1="0" v2="1" v3="2" )" +
           first + R"(/><triangle v1="0" v2="2" v3="3" )" + second + "/></triangles></mesh>";
}

const std::string kItem = R"(<item objectid="1"/>)";

std::string packageOf(const std::map<std::string, std::string>& parts) {
    test::ZipWriter zip;
    zip.add("_rels/.rels", kRelations);
    for (const auto& [name, bytes] : parts) zip.add(name, bytes, !name.ends_with(".png"));
    return zip.text();
}

FileImport readPackage(const std::string& package) {
    const TemporaryFolder folder;
    test::writeText(folder / "a.3mf", package);
    auto import = importThreeMf(folder / "a.3mf", {});
    EXPECT_TRUE(import);
    return std::move(*import);
}

FileImport readPart(const std::string& part) { return readPackage(packageOf({{"3D/box.model", part}})); }

std::string packageComplaint(const std::string& package) {
    try {
        readPackage(package);
    } catch (const FileError& error) {
        EXPECT_EQ(error.kind, FailureKind::BadData);
        return error.what();
    }
    return "none";
}

std::string packageWarnings(const FileImport& import) {
    std::string all;
    for (const Sentence& warning : import.report.warnings) all += warning.english() + "\n";
    return all;
}

const Material& triangleMaterial(const FileImport& import, std::size_t triangle) {
    return import.model.materials[import.model.shading[triangle].material];
}

Colour cornerColour(const FileImport& import, std::size_t triangle, int corner) {
    const Material& m = triangleMaterial(import, triangle);
    if (import.model.colours.empty()) return m.diffuse;
    return m.diffuse * import.model.colours[import.model.shading[triangle].v[corner]];
}

std::string pngOf(const LdrImage& image) {
    const std::vector<std::byte> bytes = encodeImage(image, "png");
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

constexpr Colour kRed{1, 0, 0}, kGreen{0, 1, 0}, kBlue{0, 0, 1};

TEST(ThreeMf, UnitsAsTheFormatSays) {
    const std::map<std::string, double> units{{"micron", 1e-6}, {"millimeter", 0.001}, {"centimeter", 0.01},
                                              {"inch", 0.0254}, {"foot", 0.3048},      {"meter", 1},
                                              {"parsec", 0.001}};
    for (const auto& [unit, metres] : units) {
        const FileImport import =
            readPart(partText("<object id=\"1\">" + square() + "</object>", kItem, "unit=\"" + unit + "\""));
        EXPECT_EQ(import.report.origin.metresPerUnit, metres) << unit;
        EXPECT_EQ(import.report.origin.up, (Vec3{0, 0, 1}));
        EXPECT_EQ(import.model.triangles.size(), 2U);
        EXPECT_EQ(triangleMaterial(import, 0).diffuse, (Colour{0.6F, 0.6F, 0.6F}));
    }
}

TEST(ThreeMf, ComponentsStandWhereTheyShall) {
    // Rows of the transform are images of the axes: x goes to y here.
    const std::string resources =
        "<object id=\"1\" name=\"plate\">" + square() +
        "</object><object id=\"2\" name=\"pair\"><components>" +
        R"(<component objectid="1" transform="0 2 0 -1 0 0 0 0 1 10 0 0"/><component objectid="1"/>)" +
        R"(<component objectid="9"/></components></object>)";
    const FileImport import =
        readPart(partText(resources, R"(<item objectid="2" transform="1 0 0 0 1 0 0 0 -1 0 0 5"/>)"));
    ASSERT_EQ(import.model.triangles.size(), 4U);
    const auto at = [&](std::size_t triangle, std::size_t corner) {
        return import.model.vertices[import.model.triangles[triangle].v[corner]].position();
    };
    EXPECT_EQ(at(0, 0), (Vec3{10, 0, 5}));
    // The item mirrors, so that the front stays the front only if corners go round the other way.
    EXPECT_EQ(at(0, 2), (Vec3{10, 2, 5}));
    EXPECT_EQ(at(0, 1), (Vec3{9, 2, 5}));
    ASSERT_EQ(import.model.parts.size(), 2U);
    EXPECT_STREQ(import.model.strings.data() + import.model.parts[1].nameOffset, "pair/plate");
    EXPECT_NE(packageWarnings(import).find("1 of its components are left out"), std::string::npos);
}

TEST(ThreeMf, PartsOfProductionAreRead) {
    const std::string root = partText(
        R"(<object id="1"><components><component p:path="/3D/Objects/my%20part.model" objectid="7"/></components></object>)",
        kItem, "requiredextensions=\"p\"");
    const std::string part = partText("<object id=\"7\" name=\"far\">" + square() + "</object>", "");
    const FileImport import =
        readPackage(packageOf({{"3D/box.model", root}, {"3D/objects/My part.model", part}}));
    EXPECT_EQ(import.model.triangles.size(), 2U);
    EXPECT_NE(
        packageComplaint(packageOf({{"3D/box.model", root}})).find("/3D/Objects/my%20part.model is missing"),
        std::string::npos);
}

TEST(ThreeMf, ColoursOfMaterialsAndCorners) {
    const std::string groups =
        R"(<basematerials id="5"><base name="PLA red" displaycolor="#FF0000"/><base name="soft" displaycolor="#00FF0080"/></basematerials>)"
        R"(<m:colorgroup id="6"><m:color color="#FF0000"/><m:color color="#00FF00FF"/><m:color color="#0000FF"/></m:colorgroup>)"
        R"(<m:compositematerials id="8" matid="5" matindices="0 1"><m:composite values="3 1"/></m:compositematerials>)";
    const auto withSquare = [&](const std::string& object, const std::string& a, const std::string& b) {
        return readPart(
            partText(groups + "<object id=\"1\" " + object + ">" + square(a, b) + "</object>", kItem));
    };
    const FileImport materials = withSquare("pid=\"5\" pindex=\"1\"", "pid=\"5\" p1=\"0\"", "");
    EXPECT_EQ(triangleMaterial(materials, 0).diffuse, kRed);
    EXPECT_EQ(triangleMaterial(materials, 1).diffuse, kGreen);
    EXPECT_NEAR(triangleMaterial(materials, 1).opacity, 128.0 / 255, 1e-6);
    EXPECT_STREQ(materials.model.strings.data() + triangleMaterial(materials, 0).nameOffset, "PLA red");

    const FileImport colours = withSquare("pid=\"6\" pindex=\"2\"", "p1=\"0\" p2=\"1\" p3=\"2\"", "");
    const Colour corners[] = {kRed, kGreen, kBlue};
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(cornerColour(colours, 0, i), corners[i]);
        EXPECT_EQ(cornerColour(colours, 1, i), kBlue);
    }
    EXPECT_EQ(packageWarnings(colours), "");

    const FileImport mixed = withSquare("", "pid=\"8\" p1=\"0\"", "pid=\"6\" p1=\"3\"");
    EXPECT_NEAR(cornerColour(mixed, 0, 0).r, 0.5, 1e-6) << "weights are at most 1";
    EXPECT_EQ(triangleMaterial(mixed, 1).diffuse, (Colour{0.6F, 0.6F, 0.6F}));
    EXPECT_NE(packageWarnings(mixed).find("1 triangles name colours or materials that do not exist"),
              std::string::npos);
}

TEST(ThreeMf, MetalOfDisplayProperties) {
    const std::string groups =
        R"(<m:pbmetallicdisplayproperties id="3"><m:pbmetallic name="brass" metallicness="1" roughness="0.25"/></m:pbmetallicdisplayproperties>)"
        R"(<basematerials id="5" displaypropertiesid="3"><base name="brass" displaycolor="#FFFF00"/></basematerials>)";
    const FileImport import = readPart(
        partText(groups + "<object id=\"1\" pid=\"5\" pindex=\"0\">" + square() + "</object>", kItem));
    EXPECT_EQ(triangleMaterial(import, 0).metallic, 1);
    EXPECT_FLOAT_EQ(triangleMaterial(import, 0).roughness, 0.25F);
}

const std::string kImageGroups =
    R"(<m:texture2d id="2" path="/3D/a.png" contenttype="image/png" tilestyleu="clamp" filter="nearest"/>)"
    R"(<m:texture2dgroup id="4" texid="2"><m:tex2coord u="0" v="0"/><m:tex2coord u="1" v="0"/><m:tex2coord u="1" v="1"/></m:texture2dgroup>)";

TEST(ThreeMf, ImagesLieOnTrianglesAndFailWhite) {
    const std::string part = partText(kImageGroups + "<object id=\"1\">" +
                                          square("pid=\"4\" p1=\"0\" p2=\"1\" p3=\"2\"", "") + "</object>",
                                      kItem);
    LdrImage image(2, 1);
    image.pixels = {{255, 0, 0, 255}, {0, 255, 0, 255}};
    const FileImport import = readPackage(packageOf({{"3D/box.model", part}, {"3D/a.png", pngOf(image)}}));
    ASSERT_EQ(import.model.textures.size(), 1U);
    EXPECT_EQ(import.model.textures[0].wrapU, TextureWrap::ClampToEdge);
    EXPECT_EQ(import.model.textures[0].wrapV, TextureWrap::Repeat);
    EXPECT_EQ(import.model.textures[0].filter, TextureFilter::Nearest);
    EXPECT_EQ(import.model.texcoords[import.model.shading[0].v[2]], (Vec2{1, 1}));
    EXPECT_EQ(triangleMaterial(import, 0).diffuse, kWhite);
    EXPECT_EQ(triangleMaterial(import, 1).diffuseTexture, kNoTexture);

    const FileImport broken = readPackage(packageOf({{"3D/box.model", part}, {"3D/a.png", "no image"}}));
    EXPECT_EQ(triangleMaterial(broken, 0).diffuse, kWhite);
    EXPECT_NE(packageWarnings(broken).find("3D/a.png"), std::string::npos);
}

TEST(ThreeMf, NothingOutsideOfThePackageIsRead) {
    const TemporaryFolder folder;
    LdrImage image(1, 1);
    std::filesystem::create_directories(folder / "3D");
    writeImage(folder / "3D/a.png", image);
    const std::string part = partText(kImageGroups + "<object id=\"1\">" +
                                          square("pid=\"4\" p1=\"0\" p2=\"1\" p3=\"2\"", "") + "</object>",
                                      kItem);
    test::writeText(folder / "a.3mf", packageOf({{"3D/box.model", part}}));
    const auto import = importThreeMf(folder / "a.3mf", {});
    ASSERT_TRUE(import);
    EXPECT_TRUE(import->model.textures.empty());
    EXPECT_EQ(import->report.files.size(), 1U);
    EXPECT_NE(packageWarnings(*import).find("it is missing in the package"), std::string::npos);
}

/// A half-covering image over a colour; a second one multiplied with both.
TEST(ThreeMf, LayersAreBlended) {
    const std::string groups =
        kImageGroups +
        R"(<m:colorgroup id="6"><m:color color="#0000FF"/></m:colorgroup>)"
        R"(<m:texture2d id="12" path="/3D/b.png" contenttype="image/png"/>)"
        R"(<m:texture2dgroup id="14" texid="12"><m:tex2coord u="0" v="0"/><m:tex2coord u="1" v="0"/><m:tex2coord u="1" v="1"/></m:texture2dgroup>)"
        R"(<m:multiproperties id="9" pids="6 4 14" blendmethods="mix multiply"><m:multi pindices="0 0 0"/><m:multi pindices="0 1 1"/><m:multi pindices="0 2 2"/></m:multiproperties>)";
    const std::string part = partText(groups + "<object id=\"1\">" +
                                          square("pid=\"9\" p1=\"0\" p2=\"1\" p3=\"2\"", "") + "</object>",
                                      kItem);
    LdrImage cover(2, 1), factor(2, 2);
    cover.pixels = {{255, 0, 0, 255}, {255, 0, 0, 0}};
    factor.pixels = {{255, 255, 255, 255}, {255, 255, 255, 255}, {0, 0, 0, 255}, {255, 255, 255, 255}};
    const FileImport import = readPackage(
        packageOf({{"3D/box.model", part}, {"3D/a.png", pngOf(cover)}, {"3D/b.png", pngOf(factor)}}));
    ASSERT_EQ(import.model.textures.size(), 1U);
    const std::vector<Rgba8> blended{{255, 0, 0, 255}, {0, 0, 255, 255}, {0, 0, 0, 255}, {0, 0, 255, 255}};
    EXPECT_EQ(import.model.texels, blended);
    EXPECT_EQ(packageWarnings(import), "");
}

TEST(ThreeMf, ExtensionsThatAreNotReadAreSaid) {
    const std::string spaces = R"(xmlns:s="http://schemas.microsoft.com/3dmanufacturing/slice/2015/07" )";
    const std::string resources =
        R"(<s:slicestack id="3"><s:slice ztop="1"><s:vertices><s:vertex x="1" y="1"/></s:vertices></s:slice></s:slicestack><object id="1">)" +
        square() + "</object>";
    EXPECT_NE(packageComplaint(packageOf({{"3D/box.model",
                                           partText(resources, kItem, spaces + "requiredextensions=\"s\"")}}))
                  .find("it needs 'slice', which is not read"),
              std::string::npos);
    const FileImport import = readPart(partText(resources, kItem, spaces));
    EXPECT_EQ(import.model.triangles.size(), 2U);
    EXPECT_EQ(packageWarnings(import), "ignored, since not supported: 'slicestack'\n");
}

TEST(ThreeMf, WhatCannotBeIsRefused) {
    const auto complaint = [](const std::string& part) {
        return packageComplaint(packageOf({{"3D/box.model", part}}));
    };
    EXPECT_NE(complaint("<model><a></model>").find("line 1 of its part /3D/box.model is no XML"),
              std::string::npos);
    EXPECT_NE(complaint("<!DOCTYPE m [<!ENTITY a \"b\">]><m>&a;</m>").find("declares a document type"),
              std::string::npos);
    const std::string loop = partText(
        R"(<object id="1"><components><component objectid="2"/></components></object><object id="2"><components><component objectid="1"/></components></object>)",
        kItem);
    EXPECT_NE(complaint(loop).find("holds itself"), std::string::npos);
    std::string doubling = "<object id=\"1\">" + square() + "</object>";
    for (int i = 2; i < 60; ++i)
        doubling += fmt::format(
            R"(<object id="{0}"><components><component objectid="{1}"/><component objectid="{1}"/></components></object>)",
            i, i - 1);
    EXPECT_NE(complaint(partText(doubling, "<item objectid=\"59\"/>")).find("parts, more than"),
              std::string::npos);
    EXPECT_NE(complaint(partText("", "")).find("it holds no triangles"), std::string::npos);
    test::ZipWriter other;
    other.add("readme.txt", "x");
    EXPECT_NE(packageComplaint(other.text()).find("no 3MF model inside"), std::string::npos);
}

TEST(ThreeMf, PackagesThatFillMemoryAreRefused) {
    std::string part = partText("<object id=\"1\">" + square() + "</object>", kItem);
    part.insert(part.find("<build>"), std::string(300'000'000, ' '));
    EXPECT_NE(
        packageComplaint(packageOf({{"3D/box.model", part}})).find("unpacks to more than 200 times its size"),
        std::string::npos);
}

TEST(ThreeMf, OtherNamesAreOfOtherReaders) {
    const TemporaryFolder folder;
    test::writeText(folder / "a.obj", "v 0 0 0\n");
    EXPECT_FALSE(importThreeMf(folder / "a.obj", {}));
    test::writeText(folder / "a.3mf", "solid a\n");
    EXPECT_THROW(importThreeMf(folder / "a.3mf", {}), FileError);
}

/// Cases of people's reports; where they are is told by RT_TEST_SCENES.
TEST(ThreeMf, FieldCases) {
    const char* const scenes = std::getenv("RT_TEST_SCENES");
    if (scenes == nullptr) GTEST_SKIP() << "RT_TEST_SCENES is not set";
    const std::filesystem::path folder = std::filesystem::path(scenes) / "field3/threemf";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no field cases";
    const auto read = [&](const char* name) { return std::move(*importThreeMf(folder / name, {})); };
    EXPECT_EQ(read("puck_inch.3mf").report.origin.metresPerUnit, 0.0254);
    const FileImport groups = read("colorgroup.3mf");
    const Colour turns[] = {kRed, kGreen, kBlue};
    for (std::size_t t = 0; t < 12; ++t) EXPECT_EQ(cornerColour(groups, t, 0), turns[t % 3]) << t;
    const FileImport materials = read("triangle_materials.3mf");
    EXPECT_EQ(materials.model.materials.size(), 2U);
    const FileImport pyramid = read("pyramid_vertexcolor.3mf");
    EXPECT_EQ(cornerColour(pyramid, 0, 0), kRed);
    EXPECT_EQ(cornerColour(pyramid, 0, 1), kBlue);
    const FileImport layers = read("multiprop-opaque.3mf");
    EXPECT_EQ(layers.model.textures.size(), 1U);
    EXPECT_EQ(packageWarnings(layers), "");
}

/// Whatever the bytes: a sound model or a FileError. More of them: RT_MUTATIONS.
TEST(ThreeMf, DamagedFilesAreSoundOrRefused) {
    static constexpr std::array<std::string_view, 22> kTokens{"<",
                                                              ">",
                                                              "/>",
                                                              "\"",
                                                              "=",
                                                              " p1=\"9\"",
                                                              " pid=\"6\"",
                                                              "4294967295",
                                                              "-1",
                                                              "1e999",
                                                              "nan",
                                                              "#FF",
                                                              "&amp;",
                                                              "&#0;",
                                                              "<object id=\"1\">",
                                                              "</object>",
                                                              "<m:multi pindices=\"1\"/>",
                                                              "PK\x01\x02",
                                                              "PK\x05\x06",
                                                              "\xFF\xFF\xFF\xFF",
                                                              "../",
                                                              "<b:c/>"};
    const std::string groups =
        kImageGroups +
        R"(<m:colorgroup id="6"><m:color color="#0000FF80"/><m:color color="#FF00FF"/></m:colorgroup>)"
        R"(<basematerials id="5" displaypropertiesid="3"><base name="a" displaycolor="#FF0000"/><base name="b" displaycolor="#00FF0080"/></basematerials>)"
        R"(<m:pbmetallicdisplayproperties id="3"><m:pbmetallic metallicness="1" roughness="0"/></m:pbmetallicdisplayproperties>)"
        R"(<m:compositematerials id="8" matid="5" matindices="0 1"><m:composite values=".5 .5"/></m:compositematerials>)"
        R"(<m:multiproperties id="9" pids="6 4 8" blendmethods="multiply"><m:multi pindices="0 0 0"/><m:multi pindices="1 2"/></m:multiproperties>)";
    const std::string part = partText(
        groups + "<object id=\"1\" name=\"a\" pid=\"8\" pindex=\"0\">" +
            square("pid=\"9\" p1=\"0\" p2=\"1\"", "pid=\"4\" p1=\"2\"") +
            R"(</object><object id="2"><components><component objectid="1" transform="1 0 0 0 1 0 0 0 1 0 0 5"/><component p:path="/3D/b.model" objectid="1"/></components></object>)",
        R"(<item objectid="2"/><item objectid="1" transform="-1 0 0 0 1 0 0 0 1 0 0 0"/>)");
    const std::string second = partText("<object id=\"1\" pid=\"5\" pindex=\"0\">" +
                                            square("pid=\"6\" p1=\"0\" p2=\"1\"", "") + "</object>",
                                        "");
    const std::map<std::string, std::string> sound{
        {"3D/box.model", part}, {"3D/b.model", second}, {"3D/a.png", pngOf(LdrImage(2, 2))}};
    test::ZipWriter plain; // whose bytes are damaged as they are
    for (const auto& [name, bytes] : sound) plain.add(name, bytes, false);
    test::DamagedText packages({packageOf(sound), plain.text()}, kTokens, 21),
        parts({part, second}, kTokens, 22);
    const TemporaryFolder folder;
    FileImportOptions options;
    options.memoryLimit = 200'000'000;
    long read = 0, refused = 0;
    for (long i = 0; i < test::damagedTexts(); ++i) {
        std::map<std::string, std::string> changed = sound;
        changed[i % 4 < 2 ? "3D/box.model" : "3D/b.model"] = parts.next();
        test::writeText(folder / "a.3mf", i % 2 == 0 ? packages.next() : packageOf(changed));
        try {
            const auto import = importThreeMf(folder / "a.3mf", options);
            ASSERT_TRUE(import);
            ++read;
            for (const Triangle& t : import->model.triangles)
                for (const std::uint32_t v : t.v) ASSERT_LT(v, import->model.vertices.size());
            for (const ShadingTriangle& t : import->model.shading)
                ASSERT_LT(t.material, import->model.materials.size());
        } catch (const FileError& error) {
            ++refused;
            EXPECT_EQ(error.kind, FailureKind::BadData) << error.what();
        }
    }
    EXPECT_GT(read, 0);
    EXPECT_GT(refused, 0);
}

} // namespace
