// Accidents and malice: what is no file of light is refused, and what is taken works.

#include "light_file_support.h"

#include "rtcore/io/bsp/bsp_checksum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <random>
#include <span>

namespace rtcore {
namespace {

constexpr std::uint32_t kTelling[] = {0,          1,          2,          3,          0x7FFFFFFF, 0x80000000,
                                      0xFFFFFFFF, 0xFFFFFFFE, 0x7F800000, 0xFF800000, 0x7FC00000, 0x7F7FFFFF,
                                      0x00000001, 0x3F800000, 0xBF800000, 0x5E5E0000, 0x40000000, 0x00010000};

void putWord(test::Bytes& bytes, std::size_t at, std::uint32_t word) {
    std::memcpy(bytes.data() + at, &word, sizeof word);
}

/// Makes the checksum right.
void seal(test::Bytes& bytes) {
    if (bytes.size() < kLightHeadBytes) return;
    putWord(bytes, 12, crc32Of(std::span<const std::byte>(bytes).subspan(kLightCrcFrom)));
}

TEST(LightDamage, EveryTruncationIsRefused) {
    const test::LearnedRoom learned(1, 3);
    const test::Bytes whole = learned.bytes();
    const LightKey key = learned.key();
    ASSERT_LT(whole.size(), 60000U);
    EXPECT_FALSE(test::refusal(whole, key));
    for (std::size_t length = 0; length < whole.size(); ++length) {
        test::Bytes bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
        ASSERT_TRUE(test::refusal(bytes, key)) << length;
        seal(bytes);
        ASSERT_TRUE(test::refusal(bytes, key)) << length;
    }
    test::Bytes longer = whole;
    longer.push_back(std::byte{0});
    seal(longer);
    EXPECT_NE(test::refusal(longer, key)->find("longer than it should be"), std::string::npos);
}

TEST(LightDamage, EveryFlippedBitIsRefused) {
    const test::LearnedRoom learned(1, 1);
    test::Bytes bytes = learned.bytes();
    const LightKey key = learned.key();
    for (std::size_t bit = 0; bit < bytes.size() * 8; bit += bit < 1024 ? 1 : 29) {
        bytes[bit / 8] ^= std::byte{1} << (bit % 8);
        const auto said = test::refusal(bytes, key);
        ASSERT_TRUE(said) << bit;
        EXPECT_TRUE(said->starts_with("room.light: ")) << *said;
        EXPECT_NE(said->find("delete it"), std::string::npos) << *said;
        bytes[bit / 8] ^= std::byte{1} << (bit % 8);
    }
}

TEST(LightDamage, CountsAreCheckedBeforeAnythingIsAllocated) {
    const test::LearnedRoom learned(1, 1);
    const LightKey key = learned.key();
    for (const std::size_t at : {std::size_t{56}, std::size_t{60}}) {
        for (const std::uint32_t count : {0xFFFFFFFFU, 0x7FFFFFFFU, 1'500'000U, 1'500'001U, 400'000U}) {
            test::Bytes bytes = learned.bytes();
            putWord(bytes, at, count);
            seal(bytes);
            EXPECT_TRUE(test::refusal(bytes, key)) << at << ' ' << count;
        }
    }
}

TEST(LightDamage, OtherVersionsAndFilesAreNamedSo) {
    const test::LearnedRoom learned(1, 1);
    test::Bytes bytes = learned.bytes();
    putWord(bytes, 8, kLightVersion + 1);
    EXPECT_NE(test::refusal(bytes, learned.key())->find("another version"), std::string::npos);
    bytes.assign(500, std::byte{'x'});
    EXPECT_NE(test::refusal(bytes, learned.key())->find("is no file of indirect light"), std::string::npos);
    EXPECT_NE(test::refusal({}, learned.key())->find("is no file of indirect light"), std::string::npos);
}

/// Some words of a file are others, and its checksum is right.
class LightMutator {
  public:
    test::Bytes mutate(test::Bytes bytes) {
        for (std::size_t changes = 1 + below(4); changes > 0; --changes) change(bytes);
        if (below(16) != 0) seal(bytes);
        return bytes;
    }

  private:
    std::size_t below(std::size_t n) { return random_() % n; }
    void change(test::Bytes& bytes) {
        // Half of them where fields are, so that ranges are met and not only order.
        const bool aligned = below(2) == 0;
        const std::size_t records = kLightHeadBytes + 145 * below(8) + 4 * below(36);
        std::size_t at = aligned ? records : 16 + below(bytes.size() - 20);
        if (at + 4 > bytes.size()) at = bytes.size() - 4;
        std::uint32_t word = kTelling[below(std::size(kTelling))];
        switch (below(5)) {
        case 0:
            bytes[at] ^= std::byte{1} << below(8);
            return;
        case 1:
            word = static_cast<std::uint32_t>(random_());
            break;
        case 2:
            std::memcpy(&word, bytes.data() + below(bytes.size() - 4), sizeof word);
            break;
        case 3:
            std::memcpy(&word, bytes.data() + at, sizeof word);
            word += static_cast<std::uint32_t>(below(9)) - 4;
            break;
        default:
            break;
        }
        putWord(bytes, at, word);
    }

    std::mt19937 random_{11};
};

/// RT_MUTATIONS: how many files.
int mutants() {
    const char* const asked = std::getenv("RT_MUTATIONS");
    return asked == nullptr ? 20000 : std::max(1, std::atoi(asked));
}

TEST(LightDamage, MutantsAreRefusedOrHarmless) {
    test::LearnedRoom learned(3, 20);
    const test::Bytes sound = learned.bytes();
    const LightKey key = learned.key();
    LightMutator mutator;
    int taken = 0;
    const int files = mutants();
    for (int i = 0; i < files; ++i) {
        const test::Bytes bytes = mutator.mutate(sound);
        LightFile file;
        try {
            file = readLightFile(bytes, key, "room.light");
        } catch (const FileError& error) {
            ASSERT_EQ(error.kind, FailureKind::BadData);
            continue;
        }
        if (file.match != LightMatch::Same || ++taken % 10 != 0) continue;
        learned.room.light.restore(file.light);
        learned.room.learn(2, 60, 1);
        ASSERT_TRUE(isFinite(learned.room.mean())) << i;
    }
    EXPECT_GT(taken, files / 20);
    EXPECT_LT(taken, files / 4 * 3);
}

} // namespace
} // namespace rtcore
