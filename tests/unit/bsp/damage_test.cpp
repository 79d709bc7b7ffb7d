// Accidents: whatever happens to a file between writing and reading is noticed.
#include "bsp_support.h"

#include <array>
#include <limits>

#include <sys/mman.h>

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

void expectRefusal(Bytes bytes, const test::FileTable& table, const std::string& words) {
    test::seal(bytes, table);
    expectRefusal(bytes, words);
}

} // namespace

TEST(BspDamage, EveryTruncationIsRefused) {
    const Bytes whole = test::sampleFile(1, 6);
    ASSERT_LT(whole.size(), 4864U);
    for (std::size_t length = 0; length < whole.size(); ++length) {
        ASSERT_TRUE(test::refusal(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length))))
            << "cut off at " << length << " of " << whole.size();
    }
    EXPECT_FALSE(test::refusal(whole));
}

TEST(BspDamage, EveryFlippedBitIsRefused) {
    Bytes bytes = test::sampleFile(2, 6);
    ASSERT_LT(bytes.size(), 4864U);
    for (std::size_t bit = 0; bit < bytes.size() * 8; ++bit) {
        bytes[bit / 8] ^= std::byte{1} << (bit % 8);
        ASSERT_TRUE(test::refusal(bytes)) << "bit " << bit % 8 << " of byte " << bit / 8;
        bytes[bit / 8] ^= std::byte{1} << (bit % 8);
    }
    EXPECT_FALSE(test::refusal(bytes));
}

TEST(BspDamage, BytesBehindTheEndAreRefused) {
    Bytes bytes = test::sampleFile(3, 6);
    bytes.push_back(std::byte{0});
    expectRefusal(bytes, "longer than it should be");
}

// A terabyte, of which all but the beginning may not be touched.
TEST(BspDamage, WhatTheHeadGivesAwayIsRefusedBeforeTheRestIsRead) {
    constexpr std::size_t kSize = std::size_t{1} << 40, kReadable = 65536;
    void* const room = ::mmap(nullptr, kSize, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    ASSERT_NE(room, MAP_FAILED);
    const std::shared_ptr<void> owner(room, [](void* memory) { ::munmap(memory, kSize); });
    ASSERT_EQ(::mprotect(room, kReadable, PROT_READ | PROT_WRITE), 0);
    const Bytes sample = test::sampleFile(5, 6);
    const auto said = [&](const test::FileTable& table) {
        std::memcpy(room, sample.data(), sample.size());
        std::memcpy(static_cast<std::byte*>(room) + sizeof table.head, table.sections.data(),
                    table.sections.size() * sizeof(rtcore::BspSectionEntry));
        rtcore::BspHead head = table.head;
        head.fileSize = kSize;
        head.headCrc = rtcore::headCrcOf(head);
        std::memcpy(room, &head, sizeof head);
        try {
            rtcore::readBsp({{static_cast<const std::byte*>(room), kSize}, owner}, "long.bsp");
        } catch (const rtcore::FileError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    test::FileTable table = test::tableOf(sample);
    EXPECT_NE(said(table).find("the last section does not end with the file"), std::string::npos);
    table.sections.front().count = kSize;
    EXPECT_NE(said(table).find("ends behind the end of the file"), std::string::npos);
    table = test::tableOf(sample);
    table.sections.back().name = table.sections.front().name;
    table.sections.back().count = (kSize - table.sections.back().offset) / table.sections.back().elementSize;
    EXPECT_NE(said(table).find("two sections have the same name"), std::string::npos);
}

TEST(BspDamage, AFileOnDiskIsCheckedAsOneInMemory) {
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

TEST(BspDamage, OtherFilesOfThisEndingAreNamedSo) {
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

TEST(BspDamage, OtherVersionsAndByteOrdersAreNamedSo) {
    const Bytes bytes = test::sampleFile(1, 6);
    test::FileTable table = test::tableOf(bytes);
    for (const std::uint32_t version : {0U, 1U, rtcore::kBspVersion + 1, 0x04000000U}) {
        table.head.version = version;
        expectRefusal(bytes, table, "another version");
    }
    table.head.byteOrder = 0x04030201;
    expectRefusal(bytes, table, "other byte order");
}

TEST(BspDamage, SectionTableThatLiesIsRefused) {
    const Bytes bytes = test::sampleFile(1, 6);
    const test::FileTable sound = test::tableOf(bytes);
    for (std::size_t i = 0; i < rtcore::kBspSections; ++i) {
        const std::string name(rtcore::kBspSectionKinds[i].name);
        // The second row: times the size of an element they wrap around to the end that would be right.
        const std::uint64_t own = sound.sections[i].count, one = 1;
        for (const std::uint64_t count :
             {~one, one << 61U, one << 32U, sound.head.fileSize, own + 64, one - 1, //
              own + (one << 60U), own + (one << 61U), own + (one << 62U)}) {
            if (count == own) continue;
            test::FileTable table = sound;
            table.sections[i].count = count;
            expectRefusal(bytes, table, "section");
        }
        for (const std::uint64_t offset : {std::uint64_t{0}, sound.sections[i].offset + 64,
                                           sound.sections[i].offset + 1, ~std::uint64_t{0} - 63}) {
            test::FileTable table = sound;
            table.sections[i].offset = offset;
            expectRefusal(bytes, table, "section " + name + " begins at the wrong place");
        }
        test::FileTable table = sound;
        table.sections[i].elementSize = 0;
        expectRefusal(bytes, table, "section " + name + " has elements of the wrong size");
    }
}

TEST(BspDamage, NamesOfSectionsAreChecked) {
    const Bytes bytes = test::sampleFile(1, 6);
    const test::FileTable sound = test::tableOf(bytes);
    test::FileTable table = sound;
    table.sections[5].name = table.sections[6].name;
    expectRefusal(bytes, table, "the same name");
    table = sound;
    table.sections[5].name = {};
    expectRefusal(bytes, table, "no proper name");
    table = sound;
    table.sections[5].name.back() = 'x';
    expectRefusal(bytes, table, "no proper name");
    table = sound;
    table.head.sectionCount = 0xFFFFFFFF;
    expectRefusal(bytes, table, "wrong size");
    table.head.sectionCount = 1024;
    expectRefusal(bytes, table, "the table of sections is cut off");
    table.head.sectionCount = 0;
    table.sections.clear();
    expectRefusal(bytes, table, "does not end with the file");
}

TEST(BspDamage, WarningsAndOriginMustBeText) {
    const Bytes sound = test::sampleFile(1, 6);
    const std::vector<rtcore::BspSectionEntry> sections = test::tableOf(sound).sections;
    for (const rtcore::BspSection section : {rtcore::BspSection::Warnings, rtcore::BspSection::Origin}) {
        const auto i = static_cast<std::size_t>(section);
        const std::string name = test::nameOf(sections[i]);
        ASSERT_EQ(name, section == rtcore::BspSection::Origin ? "origin" : "warnings");
        for (const std::size_t at : {std::size_t{0}, static_cast<std::size_t>(sections[i].count) - 1}) {
            Bytes bytes = sound;
            bytes[sections[i].offset + at] = static_cast<std::byte>(at == 0 ? '\x1B' : 'x');
            expectRefusal(bytes, test::tableOf(bytes), "section " + name + " is no text");
        }
    }
}

TEST(BspDamage, HeaderThatMakesNoSenseIsRefused) {
    const Bytes bytes = test::sampleFile(1, 6);
    const test::FileTable sound = test::tableOf(bytes);
    test::FileTable table = sound;
    table.head.hasTree = 0;
    expectRefusal(bytes, table, "belongs to no tree");
    table = sound;
    table.head.hasTree = 2;
    expectRefusal(bytes, table, "flags");
    table = sound;
    table.head.reserved[3] = 1;
    expectRefusal(bytes, table, "reserved");
    table = sound;
    table.head.boundsHi[1] = std::numeric_limits<float>::quiet_NaN();
    expectRefusal(bytes, table, "bounds");
    table = sound;
    table.head.boundsLo = table.head.boundsHi = {0, 0, 0};
    expectRefusal(bytes, table, "splits outside of its cell");
    table = sound;
    table.head.headSize = 64;
    expectRefusal(bytes, table, "wrong size");
}

TEST(BspDamage, PaddingMustBeZero) {
    Bytes bytes = test::sampleFile(1, 6);
    const test::FileTable table = test::tableOf(bytes);
    int gaps = 0;
    for (std::size_t i = 1; i < rtcore::kBspSections; ++i) {
        const auto& before = table.sections[i - 1];
        const std::size_t gap = before.offset + before.count * before.elementSize;
        if (gap == table.sections[i].offset) continue;
        ++gaps;
        bytes[gap] = std::byte{1};
        expectRefusal(bytes, table, "not zero");
        bytes[gap] = std::byte{0};
    }
    EXPECT_GT(gaps, 3);
}
