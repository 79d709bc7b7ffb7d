#include "rtcore/neural/tensor_archive.h"

#include "made_net.h"
#include "support/temporary_folder.h"

#include "rtcore/platform/error.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace {

using rtcore::parseTensorArchive;
using rtcore::TensorArchive;
using test::archiveBytes;
using Bytes = std::vector<std::byte>;

/// Two small tensors whose numbers are halves, too.
TensorArchive sample() {
    return {{"a.weight", {{2, 1, 3, 3}, std::vector<float>(18, 0.5F)}}, {"a.bias", {{2}, {-0.25F, 3}}}};
}

/// Why it is refused; "" where it is not.
std::string refusal(std::span<const std::byte> bytes) {
    try {
        parseTensorArchive(bytes, "x.tza");
    } catch (const rtcore::FileError& error) {
        EXPECT_EQ(error.kind, rtcore::FailureKind::BadData);
        return error.what();
    }
    return "";
}

template <typename T>
Bytes with(Bytes bytes, std::size_t at, T value) {
    std::memcpy(&bytes[at], &value, sizeof value);
    return bytes;
}

std::size_t tableOf(const Bytes& bytes) {
    std::uint64_t table = 0;
    std::memcpy(&table, &bytes[4], sizeof table);
    return table;
}

TEST(TensorArchives, AreReadAsTheyWereWritten) {
    for (const bool halves : {false, true}) {
        const TensorArchive read = parseTensorArchive(archiveBytes(sample(), halves), "x.tza");
        ASSERT_EQ(read.size(), 2U);
        for (const auto& [name, tensor] : sample()) {
            EXPECT_EQ(read.at(name).sides, tensor.sides);
            EXPECT_EQ(read.at(name).values, tensor.values);
        }
    }
}

TEST(TensorArchives, OfFilesAreReadToo) {
    const test::TemporaryFolder folder;
    const Bytes bytes = archiveBytes(sample(), true);
    std::ofstream(folder / "a.tza", std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    EXPECT_EQ(rtcore::readTensorArchive(folder / "a.tza").size(), 2U);
    EXPECT_THROW(rtcore::readTensorArchive(folder / "none.tza"), rtcore::FileError);
    std::filesystem::resize_file(folder / "a.tza", (std::uintmax_t{64} << 20U) + 1);
    EXPECT_THROW(rtcore::readTensorArchive(folder / "a.tza"), rtcore::FileError);
}

TEST(TensorArchives, ThatAreDamagedAreRefused) {
    const Bytes good = archiveBytes(sample(), true);
    const std::size_t table = tableOf(good);
    const std::size_t name = table + 4, dimensions = name + 2 + std::string("a.bias").size();
    const std::size_t side = dimensions + 1, layout = side + 4, type = layout + 1, position = type + 1;
    EXPECT_EQ(refusal(good), "");
    EXPECT_NE(refusal(with(good, 0, std::uint16_t{1})).find("not a tensor archive"), std::string::npos);
    EXPECT_NE(refusal(with(good, 2, std::uint8_t{3})).find("version is 3"), std::string::npos);
    for (const std::uint64_t far : {good.size() + 1, std::size_t{1} << 63U, ~std::size_t{0}}) {
        EXPECT_NE(refusal(with(good, 4, far)).find("beyond the end"), std::string::npos);
        EXPECT_NE(refusal(with(good, position, far)).find("beyond the end"), std::string::npos);
    }
    EXPECT_NE(refusal(with(good, position, good.size() - 3)).find("truncated"), std::string::npos);
    EXPECT_NE(refusal(with(good, table, std::uint32_t{257})).find("256 tensors"), std::string::npos);
    EXPECT_NE(refusal(with(good, dimensions, std::uint8_t{2})).find("dimensions"), std::string::npos);
    EXPECT_NE(refusal(with(good, side, std::uint32_t{0})).find("side 0"), std::string::npos);
    EXPECT_NE(refusal(with(good, side, std::uint32_t{1025})).find("side 1025"), std::string::npos);
    EXPECT_NE(refusal(with(good, layout, 'y')).find("layout"), std::string::npos);
    EXPECT_NE(refusal(with(good, type, 'd')).find("type"), std::string::npos);
    for (const std::uint16_t half : std::initializer_list<std::uint16_t>{0x7C00, 0xFC00, 0x7E00})
        EXPECT_NE(refusal(with(good, 64, half)).find("not finite"), std::string::npos);
    for (std::size_t size = 0; size < good.size(); ++size)
        EXPECT_NE(refusal(std::span(good).first(size)), "") << size;

    TensorArchive twice = sample();
    twice["b.bias"] = twice["a.bias"];
    const Bytes two = archiveBytes(twice, true);
    Bytes same = two;
    const std::string other = "b.bias";
    const auto* const found =
        std::search(same.data(), same.data() + same.size(), reinterpret_cast<const std::byte*>(other.data()),
                    reinterpret_cast<const std::byte*>(other.data()) + other.size());
    same[static_cast<std::size_t>(found - same.data())] = std::byte{'a'};
    EXPECT_NE(refusal(same).find("same name"), std::string::npos);

    TensorArchive many;
    for (int i = 0; i < 20; ++i) many["t" + std::to_string(i)] = {{1024, 1024, 1, 1}, {}};
    EXPECT_NE(refusal(archiveBytes(many, true)), "") << "2^24 numbers are enough";
}

/// RT_MUTATIONS: how many. Either they are refused, or all that was read is whole.
TEST(TensorArchives, MutatedAnywhereHarmNothing) {
    const char* const asked = std::getenv("RT_MUTATIONS");
    const int count = asked != nullptr ? std::atoi(asked) : 3000;
    const Bytes good = archiveBytes(sample(), true);
    const std::size_t table = tableOf(good);
    std::mt19937 random(3);
    for (int i = 0; i < count; ++i) {
        Bytes bytes = good;
        for (unsigned changes = random() % 4 + 1; changes-- > 0;) {
            const std::size_t from = random() % 4 == 0 ? 0 : table; // where all but numbers is
            bytes[from + random() % (bytes.size() - from)] = static_cast<std::byte>(random());
        }
        if (random() % 8 == 0) bytes.resize(random() % (bytes.size() + 1));
        try {
            for (const auto& [name, tensor] : parseTensorArchive(bytes, "x.tza")) {
                std::size_t values = 1;
                for (const std::uint32_t side : tensor.sides) values *= side;
                EXPECT_EQ(tensor.values.size(), values);
            }
        } catch (const rtcore::FileError&) {
        }
    }
}

} // namespace
