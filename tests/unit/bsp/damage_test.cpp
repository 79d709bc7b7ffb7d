// Accidents: whatever happens to a file between writing and reading is noticed.
#include "bsp_support.h"

#include <array>
#include <limits>

using test::Bytes;

namespace {

Bytes bytesOf(const std::string& text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

void expectRefusal(const Bytes& bytes, const std::string& words) {
    const auto said = test::refusal(bytes);
    ASSERT_TRUE(said) << "accepted; expected: " << words;
    EXPECT_NE(said->find(words), std::string::npos) << *said;
}

void expectRefusal(Bytes bytes, rtcore::BspHeader header, const std::string& words) {
    test::seal(bytes, header);
    expectRefusal(bytes, words);
}

} // namespace

TEST(BspDamage, everyTruncationIsRefused) {
    const Bytes whole = test::sampleFile(1, 6);
    ASSERT_LT(whole.size(), 4096U);
    for (std::size_t length = 0; length < whole.size(); ++length) {
        ASSERT_TRUE(test::refusal(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length))))
            << "cut off at " << length << " of " << whole.size();
    }
    EXPECT_FALSE(test::refusal(whole));
}

TEST(BspDamage, everyFlippedBitIsRefused) {
    Bytes bytes = test::sampleFile(2, 6);
    ASSERT_LT(bytes.size(), 4096U);
    for (std::size_t bit = 0; bit < bytes.size() * 8; ++bit) {
        bytes[bit / 8] ^= std::byte{1} << (bit % 8);
        ASSERT_TRUE(test::refusal(bytes)) << "bit " << bit % 8 << " of byte " << bit / 8;
        bytes[bit / 8] ^= std::byte{1} << (bit % 8);
    }
    EXPECT_FALSE(test::refusal(bytes));
}

TEST(BspDamage, bytesBehindTheEndAreRefused) {
    Bytes bytes = test::sampleFile(3, 6);
    bytes.push_back(std::byte{0});
    expectRefusal(bytes, "longer than it should be");
}

TEST(BspDamage, aFileOnDiskIsCheckedAsOneInMemory) {
    const test::TemporaryFolder folder;
    Bytes bytes = test::sampleFile(4, 3000);
    ASSERT_GT(bytes.size(), 65536U) << "is to be mapped";
    for (const std::size_t at : {std::size_t{100}, bytes.size() / 2, bytes.size() - 1}) {
        bytes[at] ^= std::byte{1};
        const std::array pieces{std::span<const std::byte>(bytes)};
        rtcore::writeFileAtomically(folder / "f.bsp", pieces);
        bytes[at] ^= std::byte{1};
        try {
            rtcore::readBsp(folder / "f.bsp");
            ADD_FAILURE() << "accepted with byte " << at << " changed";
        } catch (const rtcore::FileError& error) {
            const std::string said = error.what();
            EXPECT_TRUE(said.starts_with((folder / "f.bsp").string() + ": ")) << said;
            EXPECT_TRUE(said.ends_with("build it again with BSPBuilder")) << said;
        }
    }
}

TEST(BspDamage, otherFilesOfThisEndingAreNamedSo) {
    for (const std::string& head :
         {std::string("IBSP") + std::string(500, '\0'), std::string("VBSP\x13") + std::string(500, '\1'),
          std::string("BSP2"), std::string("version = 1\n"), std::string()}) {
        EXPECT_FALSE(rtcore::isBsp(bytesOf(head)));
        expectRefusal(bytesOf(head), "is no .bsp file of this suite");
    }
    const Bytes sound = test::sampleFile(1, 1);
    EXPECT_TRUE(rtcore::isBsp(std::span(sound).first(8)));
    EXPECT_FALSE(rtcore::isBsp(std::span(sound).first(7)));
}

TEST(BspDamage, otherVersionsAndByteOrdersAreNamedSo) {
    const Bytes bytes = test::sampleFile(1, 6);
    rtcore::BspHeader header = test::headerOf(bytes);
    header.version += 1;
    expectRefusal(bytes, header, "another version");
    header.byteOrder = 0x04030201;
    expectRefusal(bytes, header, "other byte order");
}

TEST(BspDamage, sectionTableThatLiesIsRefused) {
    const Bytes bytes = test::sampleFile(1, 6);
    const rtcore::BspHeader sound = test::headerOf(bytes);
    for (std::size_t i = 0; i < rtcore::kBspSections; ++i) {
        const std::string name = rtcore::kBspSectionNames[i];
        // The second row: times the size of an element they wrap around to the end that would be right.
        const std::uint64_t own = sound.sections[i].count, one = 1;
        for (const std::uint64_t count : {~one, one << 61U, one << 32U, sound.fileSize, own + 64, one - 1, //
                                          own + (one << 60U), own + (one << 61U), own + (one << 62U)}) {
            if (count == own) continue;
            rtcore::BspHeader header = sound;
            header.sections[i].count = count;
            expectRefusal(bytes, header, "section");
        }
        for (const std::uint64_t offset : {std::uint64_t{0}, sound.sections[i].offset + 64,
                                           sound.sections[i].offset + 1, ~std::uint64_t{0} - 63}) {
            rtcore::BspHeader header = sound;
            header.sections[i].offset = offset;
            expectRefusal(bytes, header, "section " + name + " begins at the wrong place");
        }
        rtcore::BspHeader header = sound;
        header.sections[i].elementSize = 0;
        expectRefusal(bytes, header, "section " + name + " has elements of the wrong size");
    }
}

TEST(BspDamage, headerThatMakesNoSenseIsRefused) {
    const Bytes bytes = test::sampleFile(1, 6);
    const rtcore::BspHeader sound = test::headerOf(bytes);
    rtcore::BspHeader header = sound;
    header.hasTree = 0;
    expectRefusal(bytes, header, "belongs to no tree");
    header = sound;
    header.hasTree = 2;
    expectRefusal(bytes, header, "flags");
    header = sound;
    header.reserved[3] = 1;
    expectRefusal(bytes, header, "reserved");
    header = sound;
    header.boundsHi[1] = std::numeric_limits<float>::quiet_NaN();
    expectRefusal(bytes, header, "bounds");
    header = sound;
    header.boundsLo = header.boundsHi = {0, 0, 0};
    expectRefusal(bytes, header, "splits outside of its cell");
    header = sound;
    header.headerSize = 64;
    expectRefusal(bytes, header, "wrong size");
}

TEST(BspDamage, paddingMustBeZero) {
    Bytes bytes = test::sampleFile(1, 6);
    const rtcore::BspHeader header = test::headerOf(bytes);
    int gaps = 0;
    for (std::size_t i = 1; i < rtcore::kBspSections; ++i) {
        const auto& before = header.sections[i - 1];
        const std::size_t gap = before.offset + before.count * before.elementSize;
        if (gap == header.sections[i].offset) continue;
        ++gaps;
        bytes[gap] = std::byte{1};
        expectRefusal(bytes, header, "not zero");
        bytes[gap] = std::byte{0};
    }
    EXPECT_GT(gaps, 3);
}
