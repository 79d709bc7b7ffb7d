/// Suggestions for misspelt names in files and on command lines.
#pragma once

#include "rtcore/platform/sentence.h"
#include "rtcore/settings/plain_text.h"

#include <span>
#include <string>
#include <string_view>

namespace rtcore {

/// Insertions, deletions, substitutions and swaps of neighbours that turn `a` into `b`, upper and lower case
/// counting as equal (optimal string alignment, Damerau 1964). Time and memory grow with the product of the
/// lengths.
std::size_t editDistance(std::string_view a, std::string_view b);

/// The member of `known` that is nearest to `name`, or "" when none is near (more than half of the letters
/// differ) or `name` is longer than any name. A dotted name is also found by its last part alone.
std::string_view nearestName(std::string_view name, std::span<const std::string_view> known);

/// Says that `name` is none of `known`, with the nearest one, or with all of them when none is near:
///   unknown key 'eey'; did you mean 'eye'?
Sentence unknownNameMessage(const Sentence& what, std::string_view name,
                            std::span<const std::string_view> known);

} // namespace rtcore
