#include "rtcore/neural/tensor_archive.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>
#include <utility>

namespace rtcore {

namespace {

constexpr std::uint16_t kMagic = 0x41D7;
constexpr std::uint8_t kMajorVersion = 2;
constexpr std::size_t kMaxFileBytes = std::size_t{64} << 20;
constexpr std::uint32_t kMaxTensors = 256, kMaxTensorSide = 1024;
constexpr std::uint64_t kMaxNumbers = std::uint64_t{1} << 24;
static_assert(std::endian::native == std::endian::little, "archives are little-endian");

/// Reads forward from a position in the archive. Throws Refusal of a broken archive, without the file's name.
class ArchiveReader {
  public:
    ArchiveReader(std::span<const std::byte> bytes, std::uint64_t at) : rest_(bytes) {
        if (at > bytes.size()) throw Refusal("a position lies beyond the end of the file");
        rest_ = bytes.subspan(at);
    }
    template <typename T>
    T number() {
        T value;
        std::memcpy(&value, take(sizeof value).data(), sizeof value);
        return value;
    }
    std::string text(std::size_t length) {
        const std::span<const std::byte> letters = take(length);
        return {reinterpret_cast<const char*>(letters.data()), letters.size()};
    }
    std::span<const std::byte> take(std::uint64_t count) {
        if (count > rest_.size()) throw Refusal("the file is truncated");
        const std::span<const std::byte> taken = rest_.first(count);
        rest_ = rest_.subspan(count);
        return taken;
    }

  private:
    std::span<const std::byte> rest_;
};

float floatOfHalf(std::uint16_t half) {
    const std::uint32_t sign = static_cast<std::uint32_t>(half & 0x8000U) << 16U;
    const std::uint32_t exponent = half >> 10U & 31U, digits = half & 1023U;
    constexpr std::uint32_t kInfinite = 0x7F800000U;
    if (exponent == 31) return std::bit_cast<float>(sign | kInfinite | digits << 13U);
    if (exponent == 0) return std::copysign(static_cast<float>(digits) * 0x1p-24F, sign != 0 ? -1.0F : 1.0F);
    return std::bit_cast<float>(sign | (exponent + 112) << 23U | digits << 13U);
}

float numberAt(std::span<const std::byte> numbers, std::size_t i, bool half) {
    if (half) {
        std::uint16_t bits = 0;
        std::memcpy(&bits, &numbers[2 * i], sizeof bits);
        return floatOfHalf(bits);
    }
    float value = 0;
    std::memcpy(&value, &numbers[4 * i], sizeof value);
    return value;
}

/// The next row of the table: a tensor without its numbers, where these lie, and their type.
struct TableRow {
    std::string name;
    Tensor tensor;
    std::uint64_t count = 1; ///< of numbers; at most 2^40
    bool half = false;
    std::uint64_t position = 0;
};

TableRow readRow(ArchiveReader& table) {
    TableRow row;
    row.name = table.text(table.number<std::uint16_t>());
    const auto dimensions = table.number<std::uint8_t>();
    if (dimensions != 1 && dimensions != 4) throw Refusal("a tensor has neither 1 nor 4 dimensions");
    for (int i = 0; i < dimensions; ++i) {
        const auto side = table.number<std::uint32_t>();
        if (side == 0 || side > kMaxTensorSide)
            throw Refusal(say("a tensor has the side {0}, not 1 to {1}", side, kMaxTensorSide));
        row.tensor.sides.push_back(side);
        row.count *= side;
    }
    if (table.text(dimensions) != (dimensions == 1 ? "x" : "oihw"))
        throw Refusal("a tensor has an unknown layout");
    const std::string type = table.text(1);
    if (type != "h" && type != "f") throw Refusal("a tensor has an unknown type of numbers");
    row.half = type == "h";
    row.position = table.number<std::uint64_t>();
    return row;
}

TensorArchive readAll(std::span<const std::byte> bytes) {
    ArchiveReader head(bytes, 0);
    if (head.number<std::uint16_t>() != kMagic) throw Refusal("this is not a tensor archive (.tza)");
    const auto version = head.number<std::uint8_t>();
    if (version != kMajorVersion) throw Refusal(say("its version is {0}, not {1}", version, kMajorVersion));
    head.number<std::uint8_t>(); // the minor version
    ArchiveReader table(bytes, head.number<std::uint64_t>());
    const auto count = table.number<std::uint32_t>();
    if (count > kMaxTensors) throw Refusal(say("it has more than {0} tensors", kMaxTensors));
    TensorArchive archive;
    std::uint64_t all = 0;
    for (std::uint32_t t = 0; t < count; ++t) {
        TableRow row = readRow(table);
        all += row.count;
        if (all > kMaxNumbers) throw Refusal(say("it has more than {0} numbers", kMaxNumbers));
        const std::span<const std::byte> numbers =
            ArchiveReader(bytes, row.position).take(row.count * (row.half ? 2 : 4));
        row.tensor.values.resize(row.count);
        for (std::size_t i = 0; i < row.count; ++i) {
            const float value = numberAt(numbers, i, row.half);
            if (!std::isfinite(value)) throw Refusal("a number is not finite");
            row.tensor.values[i] = value;
        }
        if (!archive.emplace(std::move(row.name), std::move(row.tensor)).second)
            throw Refusal("two tensors have the same name");
    }
    return archive;
}

} // namespace

TensorArchive parseTensorArchive(std::span<const std::byte> bytes, const std::string& file) {
    try {
        return readAll(bytes);
    } catch (const Refusal& error) {
        throw FileError(FailureKind::BadData, file, error.sentence());
    }
}

TensorArchive readTensorArchive(const std::filesystem::path& file) {
    InputFile input(file);
    if (input.size() > kMaxFileBytes)
        throw FileError(FailureKind::BadData, file.string(),
                        say("weights of {0} bytes; at most {1} are read", input.size(), kMaxFileBytes));
    const FileBytes bytes = input.read();
    if (bytes.bytes.size() > kMaxFileBytes) // a pipe
        throw FileError(FailureKind::BadData, file.string(), say("more than {0} bytes", kMaxFileBytes));
    return parseTensorArchive(bytes.bytes, file.string());
}

} // namespace rtcore
