// Malice: files whose checksums are right and whose content is not. Whatever is accepted must be safe to use.
#include "bsp_support.h"

#include "rtcore/io/bsp/bsp_version2.h"
#include "rtcore/scene/material_textures.h"
#include "rtcore/scene/photometry.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

using test::Bytes;

namespace {

constexpr std::uint32_t kTelling[] = {0,          1,          2,          3,          0x7FFFFFFF, 0x80000000,
                                      0xFFFFFFFF, 0xFFFFFFFE, 0x7F800000, 0xFF800000, 0x7FC00000, 0x7F7FFFFF,
                                      0x00000001, 0x3F800000, 0xBF800000, 0x5E5E0000, 0x40000000, 0x00010000};

class Mutator {
  public:
    explicit Mutator(std::uint32_t seed) : random_(seed) {}

    Bytes mutate(Bytes bytes) {
        const std::size_t changes = 1 + below(4);
        for (std::size_t i = 0; i < changes; ++i) change(bytes);
        if (bytes.size() < sizeof(rtcore::BspHead)) return bytes;
        test::FileTable table = test::tableOf(bytes);
        if (below(8) != 0) restore(table, bytes.size());
        if (below(4) == 0) changeSection(table);
        test::seal(bytes, table);
        return bytes;
    }

  private:
    std::size_t below(std::size_t n) { return random_() % n; }

    void change(Bytes& bytes) {
        const std::size_t at = below(bytes.size());
        const std::size_t word = at / 4 * 4;
        switch (below(7)) {
        case 0:
            bytes[at] ^= std::byte{1} << below(8);
            break;
        case 1:
            bytes[at] = static_cast<std::byte>(random_());
            break;
        case 2:
            putWord(bytes, word, kTelling[below(std::size(kTelling))]);
            break;
        case 3:
            putWord(bytes, word, static_cast<std::uint32_t>(random_()));
            break;
        case 4:
            changeCount(bytes);
            break;
        case 5:
            copyWord(bytes, word, below(bytes.size()) / 4 * 4);
            break;
        default:
            nudge(bytes, word);
            break;
        }
    }
    static void putWord(Bytes& bytes, std::size_t at, std::uint32_t value) {
        if (at + 4 <= bytes.size()) std::memcpy(bytes.data() + at, &value, 4);
    }
    static void copyWord(Bytes& bytes, std::size_t to, std::size_t from) {
        if (std::max(to, from) + 4 <= bytes.size()) std::memmove(bytes.data() + to, bytes.data() + from, 4);
    }
    void nudge(Bytes& bytes, std::size_t at) {
        if (at + 4 > bytes.size()) return;
        std::uint32_t value = 0;
        std::memcpy(&value, bytes.data() + at, 4);
        putWord(bytes, at, value + static_cast<std::uint32_t>(below(9)) - 4);
    }
    /// Moves the border between two sections, or cuts the last one.
    void changeCount(Bytes& bytes) {
        test::FileTable table = test::tableOf(bytes);
        if (!table.sections.empty()) table.sections[below(table.sections.size())].count += below(5) - 2;
        test::seal(bytes, table);
        if (below(4) == 0) bytes.resize(std::max<std::size_t>(sizeof table.head, bytes.size() - below(80)));
    }
    /// A section of another name, of elements of another size with or without as many bytes, in another's
    /// place.
    void changeSection(test::FileTable& table) {
        if (table.sections.empty()) return;
        rtcore::BspSectionEntry& section = table.sections[below(table.sections.size())];
        rtcore::BspSectionEntry& other = table.sections[below(table.sections.size())];
        const std::uint64_t bytes = section.count * section.elementSize;
        switch (below(4)) {
        case 0:
            section.name[below(section.name.size())] ^= static_cast<char>(1 + below(127));
            break;
        case 1:
            section.elementSize = static_cast<std::uint32_t>(1 + below(200));
            section.count = bytes / section.elementSize;
            break;
        case 2:
            section.elementSize += static_cast<std::uint32_t>(below(17)) - 8;
            break;
        default:
            std::swap(section.name, other.name);
            break;
        }
    }
    /// Most mutations should get past the first checks.
    static void restore(test::FileTable& table, std::size_t size) {
        table.head.magic = rtcore::kBspMagic;
        table.head.byteOrder = rtcore::kBspByteOrder;
        table.head.version = rtcore::kBspVersion;
        table.head.headSize = sizeof table.head;
        table.sections.resize(std::min(table.sections.size(), rtcore::kBspSections));
        table.head.sectionCount = static_cast<std::uint32_t>(table.sections.size());
        table.head.fileSize = size;
        table.head.reserved = {};
        std::uint64_t end = sizeof table.head + table.sections.size() * sizeof(rtcore::BspSectionEntry);
        for (std::size_t i = 0; i < table.sections.size(); ++i) {
            rtcore::BspSectionEntry& section = table.sections[i];
            const rtcore::BspSectionKind& kind = rtcore::kBspSectionKinds[i];
            section.name = {};
            std::copy(kind.name.begin(), kind.name.end(), section.name.begin());
            section.elementSize = kind.elementSize;
            section.offset = (end + 63) / 64 * 64;
            end = section.offset + section.count * section.elementSize;
        }
    }

    std::mt19937 random_;
};

/// Uses everything in `content` as a tracer would, without asking; the sum keeps the compiler from skipping
/// it.
class Walker {
  public:
    explicit Walker(const rtcore::BspContent& content) : content_(content), model_(content.model) {}

    double walk() {
        for (std::uint32_t t = 0; t < model_.mesh.triangles.size(); ++t) useTriangle(t);
        for (const rtcore::Vertex& v : model_.mesh.vertices) add(v.position());
        for (const rtcore::Vec3& n : model_.mesh.normals) add(n);
        for (const rtcore::Texture& t : model_.textures) useTexture(t);
        for (const rtcore::Rgba8& t : model_.texels) sum_ += t.r + t.a;
        for (const rtcore::TexelBlock& b : model_.blocks)
            for (std::uint32_t i = 0; i < rtcore::kBlockTexels; ++i) sum_ += rtcore::texelOf(b, i).g;
        for (const rtcore::Material& m : model_.materials) useMaterial(m);
        for (const rtcore::Light& l : model_.lights) {
            add(l.position);
            add(l.direction);
            const rtcore::Photometry& web = rtcore::photometryOf(l);
            sum_ += double{web.relative[std::size_t{web.gammaCount} * web.planeCount - 1]} + web.mean;
            sum_ += double{l.intensity.r} + static_cast<double>(model_.name(l.nameOffset).size());
        }
        for (const rtcore::Camera& c : model_.cameras) {
            add(c.eye);
            sum_ += static_cast<double>(model_.name(c.nameOffset).size());
        }
        for (const rtcore::ModelPart& p : model_.parts) {
            for (std::uint32_t t = 0; t < p.triangleCount; ++t) useTriangle(p.firstTriangle + t);
            sum_ += static_cast<double>(model_.name(p.nameOffset).size());
        }
        for (const std::string& warning : content_.warnings) sum_ += static_cast<double>(warning.size());
        if (content_.tree) useTree(*content_.tree);
        return sum_;
    }

  private:
    void add(rtcore::Vec3 v) { sum_ += double{v.x} + v.y + v.z; }

    void useTriangle(std::uint32_t t) {
        add(model_.mesh.geometricNormal(t));
        const rtcore::ShadingTriangle& s = model_.mesh.shading[t];
        for (const std::uint32_t i : s.v) {
            add(model_.mesh.normals[i]);
            if (!model_.mesh.texcoords.empty()) sum_ += double{model_.mesh.texcoords[i].x};
            if (!model_.mesh.colours.empty()) sum_ += double{model_.mesh.colours[i].g};
        }
        sum_ += double{model_.materials[s.material].opacity};
    }
    void useTexture(const rtcore::Texture& t) {
        if (t.inBlocks()) {
            const std::size_t blocks = std::size_t{(t.width + 3) / 4} * ((t.height + 3) / 4);
            sum_ += rtcore::texelOf(model_.blocks.subspan(t.firstTexel, blocks).back(), 15).r;
            return;
        }
        const auto texels = model_.texels.subspan(t.firstTexel, std::size_t{t.width} * t.height);
        sum_ += texels.front().r + texels.back().g;
    }
    void useMaterial(const rtcore::Material& m) {
        for (const auto texture : rtcore::kMaterialTextures)
            if (m.*texture != rtcore::kNoTexture) useTexture(model_.textures[m.*texture]);
        sum_ += static_cast<double>(model_.name(m.nameOffset).size());
    }
    void useTree(const rtcore::KdTree& tree) {
        std::uint32_t stack[rtcore::kMaxKdDepth];
        std::size_t pending = 0;
        std::uint32_t node = 0;
        while (true) {
            const rtcore::KdNode n = tree.nodes[node];
            if (!n.isLeaf()) {
                sum_ += double{n.split};
                stack[pending++] = n.lowerChild() + 1;
                node = n.lowerChild();
                continue;
            }
            for (std::uint32_t i = 0; i < n.count(); ++i) useTriangle(tree.references[n.firstReference + i]);
            if (pending == 0) return;
            node = stack[--pending];
        }
    }

    const rtcore::BspContent& content_;
    const rtcore::Model& model_;
    double sum_ = 0;
};

long mutationCount() {
    const char* wanted = std::getenv("RT_MUTATIONS");
    return wanted != nullptr ? std::atol(wanted) : 10000;
}

/// A file of version 2 with some words of its own or of kTelling in other places, and right checksums.
class OldMutator {
  public:
    explicit OldMutator(std::uint32_t seed) : random_(seed) {}

    Bytes mutate(Bytes bytes) {
        const std::size_t words = bytes.size() / 4;
        for (std::size_t changes = 1 + random_() % 4; changes > 0; --changes) {
            std::uint32_t word = kTelling[random_() % std::size(kTelling)];
            if (random_() % 2 == 0) std::memcpy(&word, bytes.data() + random_() % words * 4, 4);
            // The head up to its sections is not of interest: flags alone decide there.
            const std::size_t at = 76 / 4 + random_() % (words - 76 / 4);
            std::memcpy(bytes.data() + at * 4, &word, 4);
        }
        rtcore::BspHead2 head;
        std::memcpy(&head, bytes.data(), sizeof head);
        head.payloadCrc = rtcore::crc32Of(std::span(bytes).subspan(sizeof head));
        head.reserved = {};
        std::memcpy(bytes.data(), &head, sizeof head);
        head.headCrc = rtcore::crc32Of(std::span(bytes).first(offsetof(rtcore::BspHead2, headCrc)));
        std::memcpy(bytes.data(), &head, sizeof head);
        return bytes;
    }

  private:
    std::mt19937 random_;
};

/// Reads RT_MUTATIONS files and uses what is accepted.
template <typename SomeMutator>
void readMutations(const Bytes& sound, SomeMutator mutator) {
    const long count = mutationCount();
    long accepted = 0;
    const auto start = std::chrono::steady_clock::now();
    for (long i = 0; i < count; ++i) {
        const Bytes bytes = mutator.mutate(sound);
        try {
            const rtcore::BspContent content = test::readFrom(bytes);
            ++accepted;
            ASSERT_TRUE(std::isfinite(Walker(content).walk())) << "mutation " << i;
        } catch (const rtcore::FileError& error) {
            ASSERT_EQ(error.kind, rtcore::FailureKind::BadData) << "mutation " << i << ": " << error.what();
        }
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::printf("%ld mutations, %ld accepted, %.0f per second\n", count, accepted,
                static_cast<double>(count) / seconds.count());
    EXPECT_GT(accepted, count / 50) << "the mutations must reach beyond the first checks";
    EXPECT_LT(accepted, count * 9 / 10);
}

} // namespace

TEST(BspMutation, WhatIsAcceptedIsSafeToUse) { readMutations(test::sampleFile(11, 30), Mutator(20240607)); }

TEST(BspMutation, WhatIsAcceptedOfVersion2IsSafeToUse) {
    readMutations(test::fileContent(RT_VERSION_2_FILE), OldMutator(20240608));
}
