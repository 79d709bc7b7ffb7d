#include "bsp_support.h"

#include "rtcore/io/bsp/bsp_checksum.h"

#include <array>
#include <fstream>

using rtcore::BspContent;
using rtcore::BspIdentity;
using rtcore::KdTree;
using rtcore::Model;

namespace {

constexpr BspIdentity kIdentity{987654321012, 0xDEADBEEF, 77};

/// Bit by bit, as the standard of zip files says.
std::uint32_t plainCrc(std::span<const std::byte> bytes, std::uint32_t before) {
    std::uint32_t crc = ~before;
    for (const std::byte byte : bytes) {
        crc ^= std::to_integer<std::uint32_t>(byte);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    return ~crc;
}

} // namespace

TEST(BspChecksum, IsThatOfZipFilesForAnyLength) {
    std::vector<std::byte> bytes(5000);
    std::uint32_t state = 1;
    for (std::byte& byte : bytes)
        byte = static_cast<std::byte>((state = state * 1664525U + 1013904223U) >> 24U);
    for (std::size_t size = 0; size < 700; ++size) {
        const auto part = std::span<const std::byte>(bytes).subspan(size % 5, size);
        EXPECT_EQ(rtcore::crc32Of(part), plainCrc(part, 0)) << size;
        EXPECT_EQ(rtcore::crc32Of(part, 0x12345678), plainCrc(part, 0x12345678)) << size;
    }
    EXPECT_EQ(rtcore::crc32Of(bytes), plainCrc(bytes, 0));
}

TEST(BspRoundTrip, EverythingComesBack) {
    const test::TemporaryFolder folder;
    for (const std::size_t triangles : {1, 20, 5000}) { // read, read, mapped
        const Model model = rtcore::makeModel(test::SampleModel(7).make(triangles));
        const test::SampleTree tree = test::sampleTree(model.mesh);
        const KdTree view = tree.view();
        rtcore::writeBsp(folder / "f.bsp", model, &view, kIdentity);
        const BspContent content = rtcore::readBsp(folder / "f.bsp");
        test::expectEqual(content.model, model);
        ASSERT_TRUE(content.tree);
        test::expectEqual(*content.tree, view);
        EXPECT_EQ(content.identity, kIdentity);
        EXPECT_EQ(content.model.name(content.model.materials[1].nameOffset), "material 1");
    }
}

TEST(BspRoundTrip, FileWithoutATreeHandsOverAModel) {
    const test::TemporaryFolder folder;
    const Model model = rtcore::makeModel(test::SampleModel(8).make(50));
    rtcore::writeBsp(folder / "f.bsp", model, nullptr, {1, 2, 0});
    const BspContent content = rtcore::readBsp(folder / "f.bsp");
    EXPECT_FALSE(content.tree);
    test::expectEqual(content.model, model);
}

TEST(BspRoundTrip, WhereTheModelComesFromComesBack) {
    const test::TemporaryFolder folder;
    const Model model = rtcore::makeModel(test::SampleModel(8).make(5));
    const rtcore::ModelOrigin origin{"STL Importer", "OpenSCAD", rtcore::Vec3{0, 0, -1}, 0.001};
    rtcore::writeBsp(folder / "f.bsp", model, nullptr, {}, {}, origin);
    EXPECT_EQ(rtcore::readBsp(folder / "f.bsp").origin, origin);
    rtcore::writeBsp(folder / "f.bsp", model, nullptr, {}, {}, {"", std::string(9000, 'x') + "\n", {}, {}});
    EXPECT_EQ(rtcore::readBsp(folder / "f.bsp").origin.exporter.find_first_not_of('x'), std::string::npos);
}

TEST(BspRoundTrip, WhatAModelMayLackMayBeMissing) {
    const test::TemporaryFolder folder;
    rtcore::ModelBuffers buffers = test::SampleModel(9).make(10);
    buffers.texcoords.clear();
    buffers.furtherTexcoords.clear();
    buffers.colours.clear();
    buffers.lights.clear();
    buffers.cameras.clear();
    buffers.textures.clear();
    buffers.texels.clear();
    buffers.blocks.clear();
    buffers.materials = {rtcore::Material{}};
    for (auto& s : buffers.shading) s.material = 0;
    const Model model = rtcore::makeModel(std::move(buffers));
    rtcore::writeBsp(folder / "f.bsp", model, nullptr, {});
    test::expectEqual(rtcore::readBsp(folder / "f.bsp").model, model);
}

TEST(BspRoundTrip, ASceneWithoutTrianglesHasATreeOfOneLeaf) {
    const test::TemporaryFolder folder;
    rtcore::ModelBuffers buffers;
    buffers.materials.emplace_back();
    const Model model = rtcore::makeModel(std::move(buffers));
    const std::array nodes{rtcore::KdNode::leaf(0, 0)};
    const KdTree tree{nodes, {}, rtcore::Box3{}, nullptr};
    rtcore::writeBsp(folder / "f.bsp", model, &tree, {});
    const BspContent content = rtcore::readBsp(folder / "f.bsp");
    ASSERT_TRUE(content.tree);
    EXPECT_EQ(content.tree->bounds, rtcore::Box3{});
    EXPECT_EQ(content.tree->nodes.size(), 1U);
    EXPECT_TRUE(content.model.mesh.triangles.empty());
}

TEST(BspRoundTrip, SameContentGivesSameBytes) {
    EXPECT_EQ(test::sampleFile(3, 40), test::sampleFile(3, 40));
    EXPECT_NE(test::sampleFile(3, 40), test::sampleFile(4, 40));
}

TEST(BspRoundTrip, ViewsPointIntoTheFileAndKeepItAlive) {
    const test::Bytes bytes = test::sampleFile(5, 30);
    const std::shared_ptr<std::byte[]> memory(new std::byte[bytes.size()]);
    std::copy(bytes.begin(), bytes.end(), memory.get());
    auto content = std::make_unique<BspContent>(rtcore::readBsp({{memory.get(), bytes.size()}, memory}, "f"));
    const auto inside = [&](const void* p) { return p >= memory.get() && p < memory.get() + bytes.size(); };
    EXPECT_TRUE(inside(content->model.mesh.vertices.data()));
    EXPECT_TRUE(inside(content->model.strings.data()));
    EXPECT_TRUE(inside(content->tree->nodes.data()));
    EXPECT_TRUE(inside(content->tree->references.data()));
    EXPECT_EQ(memory.use_count(), 2) << "this test, and what the model and the tree share";
    const KdTree tree = *content->tree;
    content.reset();
    EXPECT_EQ(memory.use_count(), 2);
}

TEST(BspRoundTrip, SectionsAreAligned) {
    for (const auto& section : test::tableOf(test::sampleFile(5, 30)).sections)
        EXPECT_EQ(section.offset % rtcore::kBspAlignment, 0U);
}

TEST(BspRoundTrip, WarningsAreKeptOneLineEach) {
    const test::TemporaryFolder folder;
    const Model model = rtcore::makeModel(test::SampleModel(2).make(5));
    const std::vector<std::string> warnings{"texture 'a.png' is missing", "", "two\nlines\x7F",
                                            "d\xC3\xADra"};
    rtcore::writeBsp(folder / "f.bsp", model, nullptr, {}, warnings);
    EXPECT_EQ(rtcore::readBsp(folder / "f.bsp").warnings,
              (std::vector<std::string>{warnings[0], "", "two?lines?", warnings[3]}));
    rtcore::writeBsp(folder / "f.bsp", model, nullptr, {},
                     std::vector<std::string>(1000, std::string(500, 'w')));
    EXPECT_EQ(rtcore::readBsp(folder / "f.bsp").warnings.size(), 64U * 1024 / 501);
    rtcore::writeBsp(folder / "f.bsp", model, nullptr, {});
    EXPECT_TRUE(rtcore::readBsp(folder / "f.bsp").warnings.empty());
}

TEST(BspWriting, RefusesATreeOfAnotherModel) {
    const test::TemporaryFolder folder;
    const Model small = rtcore::makeModel(test::SampleModel(1).make(5));
    const Model large = rtcore::makeModel(test::SampleModel(1).make(50));
    const test::SampleTree tree = test::sampleTree(large.mesh);
    const KdTree view = tree.view();
    EXPECT_THROW(rtcore::writeBsp(folder / "f.bsp", small, &view, {}), rtcore::FileError);
    EXPECT_FALSE(std::filesystem::exists(folder / "f.bsp"));
}

TEST(BspWriting, MissingFolderIsAnError) {
    const test::TemporaryFolder folder;
    const Model model = rtcore::makeModel(test::SampleModel(1).make(5));
    try {
        rtcore::writeBsp(folder / "no" / "f.bsp", model, nullptr, {});
        ADD_FAILURE() << "written";
    } catch (const rtcore::FileError& error) {
        EXPECT_EQ(error.kind, rtcore::FailureKind::CannotWrite);
    }
}
