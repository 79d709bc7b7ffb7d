/// Parts shared by the tests of .bsp files: a file in memory, and the comparison of contents.
#pragma once

#include "rtcore/io/bsp/bsp_checksum.h"
#include "rtcore/io/bsp/bsp_file.h"
#include "rtcore/platform/error.h"
#include "support/sample_model.h"
#include "support/sample_tree.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace test {

using Bytes = std::vector<std::byte>;

inline Bytes fileContent(const std::filesystem::path& path) {
    const rtcore::FileBytes file = rtcore::openFileBytes(path);
    return {file.bytes.begin(), file.bytes.end()};
}

/// A sample model with its tree, as the bytes of a file.
inline Bytes sampleFile(std::uint32_t seed, std::size_t triangles) {
    const TemporaryFolder folder;
    const rtcore::Model model = rtcore::makeModel(SampleModel(seed).make(triangles));
    const SampleTree tree = sampleTree(model.mesh, 2);
    const rtcore::KdTree view = tree.view();
    rtcore::writeBsp(folder / "sample.bsp", model, &view, {1234, 0xABCD, 42},
                     std::vector<std::string>{"a texture is missing", "a light is left out"},
                     {"a format", "a program", rtcore::Vec3{0, 0, 1}, 0.01});
    return fileContent(folder / "sample.bsp");
}

/// Reads from memory of exactly that size, so that a sanitizer sees every step beyond the end.
inline rtcore::BspContent readFrom(const Bytes& bytes) {
    const std::shared_ptr<std::byte[]> memory(new std::byte[bytes.size()]);
    std::copy(bytes.begin(), bytes.end(), memory.get());
    return rtcore::readBsp({{memory.get(), bytes.size()}, memory}, "memory.bsp");
}

/// The complaint of readBsp() about the bytes; nothing when it accepts them.
inline std::optional<std::string> refusal(const Bytes& bytes) {
    try {
        readFrom(bytes);
    } catch (const rtcore::FileError& error) {
        EXPECT_EQ(error.kind, rtcore::FailureKind::BadData);
        return error.what();
    }
    return {};
}

/// The head and the section table of a file of the current version.
struct FileTable {
    rtcore::BspHead head;
    std::vector<rtcore::BspSectionEntry> sections;
};

/// As far as the bytes reach.
inline FileTable tableOf(const Bytes& bytes) {
    FileTable table;
    std::memcpy(&table.head, bytes.data(), sizeof table.head);
    const std::size_t room = (bytes.size() - sizeof table.head) / sizeof(rtcore::BspSectionEntry);
    table.sections.resize(std::min<std::size_t>(table.head.sectionCount, room));
    if (!table.sections.empty()) {
        std::memcpy(table.sections.data(), bytes.data() + sizeof table.head,
                    table.sections.size() * sizeof(rtcore::BspSectionEntry));
    }
    return table;
}

/// Puts head and table in, with both checksums made right.
inline void seal(Bytes& bytes, FileTable table) {
    if (!table.sections.empty()) {
        std::memcpy(bytes.data() + sizeof table.head, table.sections.data(),
                    table.sections.size() * sizeof(rtcore::BspSectionEntry));
    }
    table.head.payloadCrc = rtcore::crc32Of(std::span(bytes).subspan(sizeof table.head));
    table.head.headCrc = rtcore::headCrcOf(table.head);
    std::memcpy(bytes.data(), &table.head, sizeof table.head);
}

inline std::string nameOf(const rtcore::BspSectionEntry& entry) {
    return {entry.name.data(), ::strnlen(entry.name.data(), entry.name.size())};
}

template <typename T>
bool equal(std::span<const T> a, std::span<const T> b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

inline void expectEqual(const rtcore::Model& a, const rtcore::Model& b) {
    EXPECT_TRUE(equal(a.mesh.vertices, b.mesh.vertices));
    EXPECT_TRUE(equal(a.mesh.triangles, b.mesh.triangles));
    EXPECT_TRUE(equal(a.mesh.shading, b.mesh.shading));
    EXPECT_TRUE(equal(a.mesh.normals, b.mesh.normals));
    EXPECT_TRUE(equal(a.mesh.texcoords, b.mesh.texcoords));
    EXPECT_TRUE(equal(a.mesh.colours, b.mesh.colours));
    EXPECT_TRUE(equal(a.mesh.alphas, b.mesh.alphas));
    EXPECT_TRUE(equal(a.mesh.furtherTexcoords, b.mesh.furtherTexcoords));
    EXPECT_TRUE(equal(a.materials, b.materials));
    EXPECT_TRUE(equal(a.textures, b.textures));
    EXPECT_TRUE(equal(a.texels, b.texels));
    EXPECT_TRUE(equal(a.blocks, b.blocks));
    EXPECT_TRUE(equal(a.lights, b.lights));
    EXPECT_TRUE(equal(a.cameras, b.cameras));
    EXPECT_TRUE(equal(a.parts, b.parts));
    EXPECT_TRUE(equal(a.strings, b.strings));
}

inline void expectEqual(const rtcore::KdTree& a, const rtcore::KdTree& b) {
    EXPECT_TRUE(std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(),
                           [](rtcore::KdNode x, rtcore::KdNode y) {
                               return x.bits == y.bits && x.firstReference == y.firstReference;
                           }));
    EXPECT_TRUE(equal(a.references, b.references));
    EXPECT_EQ(a.bounds, b.bounds);
}

} // namespace test
