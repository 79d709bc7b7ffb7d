/// All that is remembered of indirect light, as a value: to be kept in a file, and taken up again.
#pragma once

#include "rtcore/gathering/record_passes.h"
#include "rtcore/irradiance/irradiance_cache.h"
#include "rtcore/irradiance/outgoing_cells.h"
#include "rtcore/math/box.h"
#include "rtcore/platform/sentence.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace rtcore {

/// As IndirectLight::state() gives it.
struct IndirectState {
    /// As many as IndirectLight remembers, and what some steps may add.
    static constexpr std::size_t kMaxRecords = 400'000, kMaxCells = 1'500'000;

    Box3 bounds; ///< by which places are told apart
    IrradianceState irradiance;
    PassesState passes;                     ///< of the same records
    std::vector<OutgoingCells::Cell> cells; ///< ascending by key
    std::uint32_t frame = 0;                ///< steps so far
    bool guesses = false;                   ///< the guess is of this light

    friend bool operator==(const IndirectState&, const IndirectState&) = default;
};

/// Whether a light that goes on there works, however the state came about: counts, numbers and their ranges,
/// and that nothing is so crowded that it is found slowly. Nothing when all is well, else what is wrong.
/// Takes some tenths of a second at most.
std::optional<Sentence> checkIndirectState(const IndirectState& kept);

} // namespace rtcore
