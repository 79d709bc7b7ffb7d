/// Distributions of the luminaires that a model brings.
#pragma once

#include "rtcore/scene/model.h"
#include "rtcore/scene/photometry.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rtcore {

/// What keepPhotometry() was given for that number; null for 0 and what was never kept. It stays as long as
/// the process runs. Safe from many threads.
const PhotometricWeb* keptWeb(std::uint32_t number);

/// The numbers of the lights' distributions, each once, in the order of the lights. Files name them by their
/// place in this list, counted from 1.
std::vector<std::uint32_t> photometriesOf(std::span<const Light> lights);

/// In one model, at most: distributions, and numbers of them all together (numbersOf()).
inline constexpr std::size_t kMaxModelPhotometries = 256, kMaxModelWebNumbers = std::size_t{1} << 21;

/// As one list: how many gammas, how many planes, the gammas, the planes, the candela.
std::vector<double> numbersOf(const PhotometricWeb& web);

/// Whether it is one that files may hold: angles ascend, by a thousandth of a degree or more, planes go
/// around, and intensities are from 0 to 10^18 cd, one of them 10^-30 or more.
bool isSoundWeb(const PhotometricWeb& web);

/// The way back: takes one from the front of `numbers`. Nothing where counts do not fit them, or it is not
/// sound.
std::optional<PhotometricWeb> takeWeb(std::span<const double>& numbers);

} // namespace rtcore
