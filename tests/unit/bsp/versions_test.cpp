// Files of earlier and of later writers.
#include "bsp_support.h"

#include <limits>
#include <utility>

using test::Bytes;

namespace {

/// A file whose sections are taken apart, to be put together otherwise.
struct Parts {
    test::FileTable table;
    std::vector<Bytes> contents; ///< one for each section

    explicit Parts(const Bytes& file) : table(test::tableOf(file)) {
        for (const rtcore::BspSectionEntry& s : table.sections) {
            const auto begin = file.begin() + static_cast<std::ptrdiff_t>(s.offset);
            contents.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(s.count * s.elementSize));
        }
    }

    std::size_t indexOf(const std::string& name) const {
        std::size_t i = 0;
        while (test::nameOf(table.sections.at(i)) != name) ++i;
        return i;
    }

    void add(const std::string& name, std::uint32_t elementSize, std::size_t count) {
        rtcore::BspSectionEntry entry{};
        std::copy(name.begin(), name.end(), entry.name.begin());
        entry.elementSize = elementSize;
        entry.count = count;
        table.sections.insert(table.sections.begin(), entry);
        contents.insert(contents.begin(), Bytes(elementSize * count, std::byte{0xA5}));
    }
    void remove(const std::string& name) {
        const auto i = static_cast<std::ptrdiff_t>(indexOf(name));
        table.sections.erase(table.sections.begin() + i);
        contents.erase(contents.begin() + i);
    }
    /// Cuts the elements, or makes them longer by bytes that mean nothing to us.
    void resizeElements(const std::string& name, std::uint32_t size) {
        const std::size_t i = indexOf(name);
        const std::uint32_t old = table.sections[i].elementSize;
        Bytes resized(table.sections[i].count * size, std::byte{0xA5});
        for (std::size_t e = 0; e < table.sections[i].count; ++e) {
            const auto from = contents[i].begin() + static_cast<std::ptrdiff_t>(e * old);
            std::copy(from, from + std::min(old, size),
                      resized.begin() + static_cast<std::ptrdiff_t>(e * size));
        }
        contents[i] = resized;
        table.sections[i].elementSize = size;
    }

    Bytes file() {
        Bytes bytes(sizeof table.head + table.sections.size() * sizeof(rtcore::BspSectionEntry));
        for (std::size_t i = 0; i < contents.size(); ++i) {
            bytes.resize((bytes.size() + 63) / 64 * 64);
            table.sections[i].offset = bytes.size();
            bytes.insert(bytes.end(), contents[i].begin(), contents[i].end());
        }
        table.head.fileSize = bytes.size();
        table.head.sectionCount = static_cast<std::uint32_t>(table.sections.size());
        test::seal(bytes, table);
        return bytes;
    }
};

/// The sample of sampleFile() itself.
rtcore::ModelBuffers sample() { return test::SampleModel(6).make(12); }
Parts sampleParts() { return Parts(test::sampleFile(6, 12)); }

void expectModel(const rtcore::BspContent& content, rtcore::ModelBuffers expected) {
    test::expectEqual(content.model, rtcore::makeModel(std::move(expected)));
    EXPECT_TRUE(content.tree);
}

} // namespace

// Made by the BSPBuilder that wrote version 2, from a glTF of a textured square and a glowing triangle.
TEST(BspVersions, AFileOfVersion2GivesTheSameModel) {
    const rtcore::BspContent content = rtcore::readBsp(std::filesystem::path(RT_VERSION_2_FILE));
    const rtcore::Model& model = content.model;
    ASSERT_TRUE(content.tree);
    EXPECT_EQ(content.tree->references.size(), 3U);
    EXPECT_EQ(content.tree->bounds, (rtcore::Box3{{0, 0, 0}, {1, 1, 1}}));
    EXPECT_EQ(content.identity.sourceSize, 3264U);

    ASSERT_EQ(model.mesh.triangles.size(), 3U);
    EXPECT_EQ(model.mesh.vertices.size(), 7U);
    EXPECT_EQ(model.mesh.position(1, 2), (rtcore::Vec3{0, 1, 0}));
    EXPECT_EQ(model.mesh.colours[model.mesh.shading[2].v[0]], (rtcore::Colour{0.5F, 0.25F, 1}));

    rtcore::Material shining; // with the defaults of what version 2 did not have
    shining.diffuse = {0.5F, 0.25F, 0.125F};
    shining.emission = {1, 0.5F, 0.25F};
    shining.specular = {0.04F, 0.04F, 0.04F};
    shining.shininess = 0;
    shining.mirrorScale = 0;
    ASSERT_EQ(model.materials.size(), 2U);
    EXPECT_EQ(model.name(model.materials[1].nameOffset), "shining");
    shining.nameOffset = model.materials[1].nameOffset;
    EXPECT_EQ(model.materials[1], shining);
    EXPECT_EQ(model.materials[0].diffuseTexture, 0U);
    EXPECT_EQ(model.materials[0].metallicRoughnessTexture, rtcore::kNoTexture);

    ASSERT_EQ(model.textures.size(), 1U);
    EXPECT_EQ(model.textures[0], (rtcore::Texture{0, 2, 2}));
    EXPECT_EQ(model.texels[3], (rtcore::Rgba8{255, 255, 255, 128}));

    ASSERT_EQ(model.cameras.size(), 1U);
    EXPECT_EQ(model.cameras[0].eye, (rtcore::Vec3{0.5F, 0.5F, 4}));
    EXPECT_EQ(model.cameras[0].kind, rtcore::CameraKind::Perspective);
    EXPECT_EQ(model.cameras[0].aspect, 0);
    ASSERT_EQ(model.lights.size(), 1U);
    EXPECT_EQ(model.lights[0].intensity, (rtcore::Colour{8, 4, 2}));
    EXPECT_EQ(model.name(model.lights[0].nameOffset), "lamp");
    EXPECT_TRUE(model.parts.empty());
    EXPECT_TRUE(content.warnings.empty());
}

// Made by the BSPBuilder that wrote materials of 164 bytes, from a glTF of a pane of varnished water.
TEST(BspVersions, AFileFromBeforePrioritiesHasTheDefault) {
    const rtcore::BspContent content = rtcore::readBsp(std::filesystem::path(RT_BEFORE_PRIORITY_FILE));
    ASSERT_EQ(content.model.materials.size(), 1U);
    const rtcore::Material& water = content.model.materials[0];
    EXPECT_EQ(content.model.name(water.nameOffset), "water");
    EXPECT_EQ(water.indexOfRefraction, 1.33F);
    EXPECT_EQ(water.coat, 0.5F);
    EXPECT_EQ(water.coatRoughness, 0.25F);
    EXPECT_EQ(water.priority, 0);
}

TEST(BspVersions, ACopyOfItOutlivesTheReader) {
    std::optional<rtcore::BspContent> content = rtcore::readBsp(std::filesystem::path(RT_VERSION_2_FILE));
    const rtcore::Model model = content->model;
    const rtcore::KdTree tree = *content->tree;
    content.reset();
    EXPECT_EQ(model.materials[1].emission.r, 1); // as AddressSanitizer sees
    EXPECT_EQ(tree.nodes.size(), 1U);
}

TEST(BspVersions, EveryFlippedBitOfAFileOfVersion2IsRefused) {
    Bytes bytes = test::fileContent(RT_VERSION_2_FILE);
    for (std::size_t bit = 0; bit < bytes.size() * 8; ++bit) {
        bytes[bit / 8] ^= std::byte{1} << (bit % 8);
        ASSERT_TRUE(test::refusal(bytes)) << "bit " << bit % 8 << " of byte " << bit / 8;
        bytes[bit / 8] ^= std::byte{1} << (bit % 8);
    }
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        ASSERT_TRUE(test::refusal(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length))));
    }
}

TEST(BspVersions, SectionsOfUnknownNamesAreSkipped) {
    Parts parts = sampleParts();
    parts.add("lightmaps", 7, 33);
    parts.add("twelve bytes", 4, 1);
    parts.add("\x1B[2J", 1, 0);
    expectModel(test::readFrom(parts.file()), sample());
}

TEST(BspVersions, TheOrderOfSectionsIsFree) {
    Parts parts = sampleParts();
    std::reverse(parts.contents.begin(), parts.contents.end());
    std::reverse(parts.table.sections.begin(), parts.table.sections.end());
    expectModel(test::readFrom(parts.file()), sample());
}

TEST(BspVersions, MissingSectionsTakeTheirDefault) {
    Parts parts = sampleParts();
    rtcore::ModelBuffers expected = sample();
    parts.resizeElements("textures", offsetof(rtcore::Texture, texcoordSet));
    for (const char* name :
         {"parts", "cameras", "lights", "luminaires", "texcoords", "texcoordsets", "colours", "warnings"})
        parts.remove(name);
    expected.parts.clear();
    expected.cameras.clear();
    expected.lights.clear();
    expected.texcoords.clear();
    expected.furtherTexcoords.clear();
    for (rtcore::Texture& t : expected.textures) t.texcoordSet = 0;
    expected.colours.clear();
    const rtcore::BspContent content = test::readFrom(parts.file());
    expectModel(content, expected);
    EXPECT_TRUE(content.warnings.empty());

    parts.remove("normals");
    EXPECT_TRUE(test::refusal(parts.file())) << "triangles name normals";
}

TEST(BspVersions, AFileWithoutMaterialsAndNamesIsPlain) {
    rtcore::ModelBuffers buffers = sample();
    for (rtcore::ShadingTriangle& s : buffers.shading) s.material = 0;
    buffers.cameras.clear();
    buffers.lights.clear();
    buffers.parts.clear();
    const test::TemporaryFolder folder;
    rtcore::writeBsp(folder / "f.bsp", rtcore::makeModel(std::move(buffers)), nullptr, {});
    Parts parts(test::fileContent(folder / "f.bsp"));
    parts.remove("materials");
    parts.remove("strings");
    const rtcore::Model model = test::readFrom(parts.file()).model;
    ASSERT_EQ(model.materials.size(), 1U);
    EXPECT_EQ(model.materials[0], rtcore::Material{});
    EXPECT_EQ(model.name(0), "");
}

TEST(BspVersions, LongerElementsOfALaterWriterAreReadByTheirBeginning) {
    for (const rtcore::BspSectionKind& kind : rtcore::kBspSectionKinds) {
        Parts parts = sampleParts();
        parts.resizeElements(std::string(kind.name), kind.elementSize + 4);
        SCOPED_TRACE(kind.name);
        expectModel(test::readFrom(parts.file()), sample());
    }
}

// Version 3 held the lobes that Phong's model gets from roughness and metal.
TEST(BspVersions, MaterialsOfVersion3GetTheirBaseColoursBack) {
    rtcore::Material plain, metal, mixed;
    plain.roughness = 0.5F;
    plain.diffuse = {0.5F, 0.25F, 0.125F};
    plain.specular = rtcore::kWhite * 0.04F;
    plain.shininess = 7.5F;
    metal = plain;
    metal.metallic = 1;
    metal.diffuse = {};
    metal.specular = {0.75F, 0.5F, 0.25F};
    metal.mirror = metal.specular;
    metal.fresnel = 1;
    mixed = plain;
    mixed.metallic = 0.5F;
    mixed.diffuse = {0.375F, 0.25F, 0.125F};
    const std::array materials{metal, plain, mixed};
    Parts parts = sampleParts();
    std::memcpy(parts.contents[parts.indexOf("materials")].data(), materials.data(), sizeof materials);
    parts.table.head.version = 3;
    const rtcore::BspContent content = test::readFrom(parts.file());
    const std::span<const rtcore::Material> read = content.model.materials;
    ASSERT_EQ(read.size(), 3U);
    EXPECT_EQ(read[0].diffuse, (rtcore::Colour{0.75F, 0.5F, 0.25F}));
    EXPECT_EQ(read[0].metallic, 1.0F);
    EXPECT_EQ(read[1].diffuse, plain.diffuse);
    EXPECT_EQ(read[2].diffuse, (rtcore::Colour{0.75F, 0.5F, 0.25F}));
    for (const rtcore::Material& m : read) {
        EXPECT_EQ(m.roughness, 0.5F);
        EXPECT_EQ(m.specular, rtcore::kWhite * 0.04F);
        EXPECT_EQ(m.mirror, rtcore::Colour{});
    }
    parts.table.head.version = rtcore::kBspVersion;
    EXPECT_EQ(test::readFrom(parts.file()).model.materials[0].diffuse, rtcore::Colour{}) << "as it stands";
}

TEST(BspVersions, WhatShorterElementsLackHasItsDefault) {
    Parts parts = sampleParts();
    parts.resizeElements("materials", offsetof(rtcore::Material, metallic));
    parts.resizeElements("textures", offsetof(rtcore::Texture, wrapV));
    parts.resizeElements("cameras", offsetof(rtcore::Camera, kind));
    rtcore::ModelBuffers expected = sample();
    for (rtcore::Material& m : expected.materials) {
        m.metallic = 0;
        m.metallicRoughnessTexture = rtcore::kNoTexture;
        m.emissionLights = 0;
        m.normalScale = 1;
        m.vertexAlpha = m.tintsEmission = m.frontOnly = 0;
        m.transmissionTexture = m.specularTexture = rtcore::kNoTexture;
    }
    for (rtcore::Texture& t : expected.textures) {
        t.wrapV = rtcore::TextureWrap::Repeat;
        t.filter = rtcore::TextureFilter::Linear;
        t.storage = rtcore::TextureStorage::Texels;
        t.texcoordSet = 0;
    }
    for (rtcore::Camera& c : expected.cameras) {
        c.kind = rtcore::CameraKind::Perspective;
        c.orthographicWidth = c.aspect = 0;
    }
    expectModel(test::readFrom(parts.file()), expected);
}

// Made by the BSPBuilder of before, from a glTF of a triangle, a bulb and a luminaire.
TEST(BspVersions, AFileFromBeforeLuminairesGivesTheSameModel) {
    const rtcore::BspContent content = rtcore::readBsp(std::filesystem::path(RT_BEFORE_LUMINAIRES_FILE));
    ASSERT_EQ(content.model.lights.size(), 2U);
    EXPECT_EQ(content.model.lights[0].intensity, (rtcore::Colour{8, 8, 8}));
    EXPECT_EQ(content.model.lights[1].kind, rtcore::LightKind::Point);
    EXPECT_EQ(content.model.lights[1].intensity, (rtcore::Colour{5, 2.5F, 1.25F}));
    EXPECT_EQ(content.model.name(content.model.lights[1].nameOffset), "luminaire");
    ASSERT_EQ(content.warnings.size(), 1U);
}

TEST(BspVersions, LuminairesThatAreNotThereOrNoneAreRefused) {
    Parts gone = sampleParts();
    gone.remove("luminaires");
    EXPECT_TRUE(test::refusal(gone.file()));
    const auto refusalWith = [](std::size_t index, double number) {
        Parts parts = sampleParts();
        std::memcpy(parts.contents[parts.indexOf("luminaires")].data() + index * sizeof number, &number,
                    sizeof number);
        return test::refusal(parts.file()).value_or("");
    };
    const std::string refused = "no list of distributions";
    const double none = std::numeric_limits<double>::quiet_NaN();
    for (const auto& [index, number] : std::vector<std::pair<std::size_t, double>>{{0, 1},
                                                                                   {0, 2},
                                                                                   {0, 1e18},
                                                                                   {0, none},
                                                                                   {1, 4},
                                                                                   {1, 2.5},
                                                                                   {2, -1},
                                                                                   {3, 0},
                                                                                   {4, 181},
                                                                                   {7, 350},
                                                                                   {8, -1},
                                                                                   {8, none}})
        EXPECT_NE(refusalWith(index, number).find(refused), std::string::npos) << index << ' ' << number;
    EXPECT_EQ(refusalWith(8, 7), "") << "another one of the kind";
}

TEST(BspVersions, AModelWithoutBlocksIsWrittenAsVersion4) {
    const auto write = [](rtcore::ModelBuffers buffers) {
        const test::TemporaryFolder folder;
        rtcore::writeBsp(folder / "f.bsp", rtcore::makeModel(std::move(buffers)), nullptr, {});
        return test::tableOf(test::fileContent(folder / "f.bsp"));
    };
    rtcore::ModelBuffers buffers = sample();
    EXPECT_EQ(write(buffers).head.version, 6U);
    EXPECT_EQ(test::nameOf(write(buffers).sections.back()), "luminaires");
    for (rtcore::Light& light : buffers.lights) light.photometry = 0;
    EXPECT_EQ(write(buffers).head.version, 5U);
    EXPECT_EQ(test::nameOf(write(buffers).sections.back()), "texelblocks");
    buffers.blocks.clear();
    buffers.textures.pop_back();
    EXPECT_EQ(write(buffers).head.version, 4U);
    EXPECT_EQ(test::nameOf(write(buffers).sections.back()), "origin");
}

TEST(BspVersions, ElementsShorterThanAnybodyWroteAreRefused) {
    for (const rtcore::BspSectionKind& kind : rtcore::kBspSectionKinds) {
        if (kind.minSize == 1) continue;
        Parts parts = sampleParts();
        parts.resizeElements(std::string(kind.name), kind.minSize - 1);
        const auto said = test::refusal(parts.file());
        ASSERT_TRUE(said) << kind.name;
        EXPECT_NE(said->find("section " + std::string(kind.name) + " has elements of the wrong size"),
                  std::string::npos)
            << *said;
    }
}
