#include "rtcore/settings/nearest_name.h"

#include "rtcore/platform/sentence.h"

#include <algorithm>
#include <vector>

namespace rtcore {

namespace {

constexpr std::size_t kLongestName = 64;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string_view lastPart(std::string_view name) {
    const auto dot = name.rfind('.');
    return dot == std::string_view::npos ? name : name.substr(dot + 1);
}

} // namespace

std::size_t editDistance(std::string_view a, std::string_view b) {
    // Three rows of the table of distances between prefixes: two letters back, one letter back, now.
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) now[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before.swap(last);
        last.swap(now);
        now[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool equal = lower(a[i - 1]) == lower(b[j - 1]);
            now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + (equal ? 0 : 1)});
            const bool swapped =
                i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
            if (swapped) now[j] = std::min(now[j], before[j - 2] + 1);
        }
    }
    return now[b.size()];
}

namespace {

/// editDistance(), or `limit` where the lengths alone differ by as much.
std::size_t distanceBelow(std::size_t limit, std::string_view a, std::string_view b) {
    const std::size_t apart = a.size() > b.size() ? a.size() - b.size() : b.size() - a.size();
    return apart >= limit ? limit : editDistance(a, b);
}

} // namespace

std::string_view nearestName(std::string_view name, std::span<const std::string_view> known) {
    if (name.size() > kLongestName) return {};
    std::string_view nearest;
    std::size_t best = std::max<std::size_t>(2, name.size() / 2) + 1;
    for (const std::string_view candidate : known) {
        // The last part alone counts one more, so that a name which fits as a whole wins.
        const std::size_t distance = std::min(distanceBelow(best, name, candidate),
                                              distanceBelow(best, name, lastPart(candidate)) + 1);
        if (distance >= best) continue;
        best = distance;
        nearest = candidate;
    }
    return nearest;
}

Sentence unknownNameMessage(const Sentence& what, std::string_view name,
                            std::span<const std::string_view> known) {
    const std::string_view nearest = nearestName(name, known);
    if (!nearest.empty())
        return say("unknown {0} {1}; did you mean {2}?", what, inQuotes(name), inQuotes(nearest));
    std::string all;
    for (const std::string_view candidate : known) all.append(all.empty() ? "" : " ").append(candidate);
    return say("unknown {0} {1}; known: {2}", what, inQuotes(name), all);
}

} // namespace rtcore
