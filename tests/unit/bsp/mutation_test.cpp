// Malice: files whose checksums are right and whose content is not. Whatever is accepted must be safe to use.
#include "bsp_support.h"

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
        if (bytes.size() < sizeof(rtcore::BspHeader)) return bytes;
        rtcore::BspHeader header = test::headerOf(bytes);
        if (below(8) != 0) restore(header, bytes.size());
        test::seal(bytes, header);
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
        if (bytes.size() < sizeof(rtcore::BspHeader)) return;
        rtcore::BspHeader header = test::headerOf(bytes);
        header.sections[below(rtcore::kBspSections)].count += below(5) - 2;
        if (below(4) == 0) bytes.resize(std::max<std::size_t>(sizeof header, bytes.size() - below(80)));
        header.fileSize = bytes.size();
        std::memcpy(bytes.data(), &header, sizeof header);
    }
    /// Most mutations should get past the first checks.
    static void restore(rtcore::BspHeader& header, std::size_t size) {
        header.magic = rtcore::kBspMagic;
        header.byteOrder = rtcore::kBspByteOrder;
        header.version = rtcore::kBspVersion;
        header.headerSize = sizeof header;
        header.sectionCount = rtcore::kBspSections;
        header.fileSize = size;
        header.reserved = {};
        std::uint64_t end = sizeof header;
        for (std::size_t i = 0; i < rtcore::kBspSections; ++i) {
            header.sections[i].offset = (end + 63) / 64 * 64;
            header.sections[i].elementSize = rtcore::kBspElementSizes[i];
            end = header.sections[i].offset + header.sections[i].count * rtcore::kBspElementSizes[i];
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
        for (const rtcore::Material& m : model_.materials) useMaterial(m);
        for (const rtcore::Light& l : model_.lights) {
            add(l.position);
            add(l.direction);
            sum_ += double{l.intensity.r} + static_cast<double>(model_.name(l.nameOffset).size());
        }
        for (const rtcore::Camera& c : model_.cameras) {
            add(c.eye);
            sum_ += static_cast<double>(model_.name(c.nameOffset).size());
        }
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
        const auto texels = model_.texels.subspan(t.firstTexel, std::size_t{t.width} * t.height);
        sum_ += texels.front().r + texels.back().g;
    }
    void useMaterial(const rtcore::Material& m) {
        for (const std::uint32_t t : {m.diffuseTexture, m.alphaTexture, m.normalTexture, m.emissionTexture}) {
            if (t != rtcore::kNoTexture) useTexture(model_.textures[t]);
        }
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
    return wanted != nullptr ? std::atol(wanted) : 4000;
}

} // namespace

TEST(BspMutation, whatIsAcceptedIsSafeToUse) {
    const Bytes sound = test::sampleFile(11, 30);
    Mutator mutator(20240607);
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
