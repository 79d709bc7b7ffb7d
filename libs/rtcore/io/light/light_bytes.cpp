#include "rtcore/io/light/light_bytes.h"

#include "rtcore/io/bsp/bsp_checksum.h"

#include <bit>

namespace rtcore {

namespace {

/// Passes numbers to bytes, for which there is room.
class Putting {
  public:
    explicit Putting(std::byte* at) : at_(at) {}

    void operator()(std::uint8_t x) { *at_++ = static_cast<std::byte>(x); }
    void operator()(std::uint32_t x) {
        for (int i = 0; i < 4; ++i) at_[i] = static_cast<std::byte>(x >> (8 * i));
        at_ += 4;
    }

  private:
    std::byte* at_;
};

/// Passes bytes to numbers; there are enough of them.
class Taking {
  public:
    explicit Taking(const std::byte* at) : at_(at) {}

    void operator()(std::uint8_t& x) { x = std::to_integer<std::uint8_t>(*at_++); }
    void operator()(std::uint32_t& x) {
        x = 0;
        for (int i = 0; i < 4; ++i) x |= std::to_integer<std::uint32_t>(at_[i]) << (8 * i);
        at_ += 4;
    }

  private:
    const std::byte* at_;
};

/// Records are laid out once, for both ways: a number is const where it is put.
void pass(Putting& bytes, std::uint32_t x) { bytes(x); }
void pass(Taking& bytes, std::uint32_t& x) { bytes(x); }
void pass(Putting& bytes, std::uint64_t x) {
    bytes(static_cast<std::uint32_t>(x));
    bytes(static_cast<std::uint32_t>(x >> 32));
}
void pass(Taking& bytes, std::uint64_t& x) {
    std::uint32_t low = 0, high = 0;
    bytes(low);
    bytes(high);
    x = std::uint64_t{high} << 32 | low;
}
void pass(Putting& bytes, float x) { bytes(std::bit_cast<std::uint32_t>(x)); }
void pass(Taking& bytes, float& x) {
    std::uint32_t bits = 0;
    bytes(bits);
    x = std::bit_cast<float>(bits);
}
void passVec(auto& bytes, auto& v) {
    for (auto* const x : {&v.x, &v.y, &v.z}) pass(bytes, *x);
}
void passColour(auto& bytes, auto& c) {
    for (auto* const x : {&c.r, &c.g, &c.b}) pass(bytes, *x);
}

void passHead(auto& bytes, auto& head) {
    for (auto& each : head.magic) bytes(each);
    pass(bytes, head.version);
    pass(bytes, head.crc);
    pass(bytes, head.surfaces);
    pass(bytes, head.light);
    for (auto* const x : {&head.frame, &head.names, &head.guesses}) pass(bytes, *x);
    passColour(bytes, head.guess);
    pass(bytes, head.records);
    pass(bytes, head.cells);
}

void passRecord(auto& bytes, auto& record) {
    passVec(bytes, record.position);
    pass(bytes, record.radius);
    passVec(bytes, record.normal);
    pass(bytes, record.confidence);
    passColour(bytes, record.irradiance);
    passVec(bytes, record.slant);
    pass(bytes, record.distance);
    for (auto& wall : record.walls) {
        passVec(bytes, wall.normal);
        pass(bytes, wall.offset);
    }
}

/// Without what the record says, too.
void passHistory(auto& bytes, auto& history) {
    passVec(bytes, history.vector);
    for (auto* const x : {&history.pixel, &history.shrink, &history.inverseLengths}) pass(bytes, *x);
    for (auto* const x : {&history.passes, &history.allPasses, &history.name}) pass(bytes, *x);
    bytes(history.density);
}

void passCell(auto& bytes, auto& cell) {
    pass(bytes, cell.key);
    passColour(bytes, cell.sum);
    pass(bytes, cell.squares);
    pass(bytes, cell.count);
    pass(bytes, cell.frame);
}

LightHead headOf(const LightKey& key, const IndirectState& light) {
    LightHead head;
    head.surfaces = key.surfaces;
    head.light = key.light;
    head.frame = light.frame;
    head.names = light.passes.names;
    head.guesses = light.guesses ? 1 : 0;
    head.guess = light.irradiance.guess;
    head.records = static_cast<std::uint32_t>(light.irradiance.records.size());
    head.cells = static_cast<std::uint32_t>(light.cells.size());
    return head;
}

} // namespace

std::vector<std::byte> lightBytes(const LightKey& key, const IndirectState& light) {
    LightHead head = headOf(key, light);
    std::vector<std::byte> bytes(sizeOf(head));
    Putting putting(bytes.data());
    passHead(putting, head);
    for (std::size_t i = 0; i < head.records; ++i) {
        const RecordHistory& history = light.passes.histories[i];
        passRecord(putting, light.irradiance.records[i]);
        pass(putting, light.irradiance.indexed[i]);
        pass(putting, light.irradiance.lastUse[i]);
        for (const float distance : history.walls.distances()) pass(putting, distance);
        passHistory(putting, history);
    }
    for (const OutgoingCells::Cell& cell : light.cells) passCell(putting, cell);
    head.crc = crc32Of(std::span<const std::byte>(bytes).subspan(kLightCrcFrom));
    Putting first(bytes.data());
    passHead(first, head);
    return bytes;
}

LightHead lightHeadOf(std::span<const std::byte> bytes) {
    LightHead head;
    Taking taking(bytes.data());
    passHead(taking, head);
    return head;
}

IndirectState lightBehind(const LightHead& head, std::span<const std::byte> bytes, const Box3& bounds) {
    IndirectState light;
    light.bounds = bounds;
    light.irradiance.guess = head.guess;
    light.irradiance.records.resize(head.records);
    light.irradiance.indexed.resize(head.records);
    light.irradiance.lastUse.resize(head.records);
    light.passes.histories.resize(head.records);
    light.passes.names = head.names;
    light.cells.resize(head.cells);
    light.frame = head.frame;
    light.guesses = head.guesses != 0;
    Taking taking(bytes.data());
    for (std::size_t i = 0; i < head.records; ++i) {
        IrradianceRecord& record = light.irradiance.records[i];
        RecordHistory& history = light.passes.histories[i];
        std::array<float, 2> distances{};
        passRecord(taking, record);
        pass(taking, light.irradiance.indexed[i]);
        pass(taking, light.irradiance.lastUse[i]);
        for (float& distance : distances) pass(taking, distance);
        passHistory(taking, history);
        history.irradiance = record.irradiance;
        history.walls = NearestWalls::from(record.walls, distances);
    }
    for (OutgoingCells::Cell& cell : light.cells) passCell(taking, cell);
    return light;
}

} // namespace rtcore
