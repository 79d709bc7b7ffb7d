#include "rtcore/settings/library_text.h"

#include "rtcore/settings/plain_text.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

constexpr std::size_t kLongestPlace = 64, kLongestText = 300;

} // namespace

Sentence meaningOf(std::string_view text, std::span<const LibraryText> known) {
    for (const auto& [theirs, meaning] : known) {
        const auto places = placesIn(text, theirs);
        if (!places) continue;
        std::vector<Sentence> shown;
        for (const std::string_view each : *places) shown.emplace_back(printable(each, kLongestPlace));
        return {meaning, std::move(shown)};
    }
    return say("a library says \"{0}\"", printable(text, kLongestText));
}

} // namespace rtcore
