#include "rtcore/platform/sentence.h"

#include <algorithm>
#include <cstddef>

namespace rtcore {

namespace {

/// The number of the place that begins at `at`: "{7}"; -1: none does.
int placeAt(const std::string& form, std::size_t at) {
    const bool place = at + 2 < form.size() && form[at] == '{' && form[at + 1] >= '0' &&
                       form[at + 1] <= '9' && form[at + 2] == '}';
    return place ? form[at + 1] - '0' : -1;
}

Sentence readAs(std::string_view text, std::span<const char* const> forms, int depth) {
    constexpr int kDeepest = 4;
    for (const char* const form : forms) {
        const auto places = depth < kDeepest ? placesIn(text, form) : std::nullopt;
        if (!places) continue;
        std::vector<Sentence> arguments;
        for (const std::string_view each : *places) arguments.push_back(readAs(each, forms, depth + 1));
        return {form, std::move(arguments)};
    }
    return text;
}

} // namespace

std::optional<std::vector<std::string_view>> placesIn(std::string_view text, std::string_view form) {
    std::vector<std::string_view> places;
    std::size_t at = form.find('{');
    if (!text.starts_with(form.substr(0, at))) return std::nullopt;
    text.remove_prefix(std::min(at, form.size()));
    while (at != std::string_view::npos) {
        const std::size_t next = form.find('{', at + 1);
        const std::string_view behind = form.substr(at + 3, next - std::min(next, at + 3));
        const bool last = next == std::string_view::npos;
        if (last && !text.ends_with(behind)) return std::nullopt;
        const std::size_t end = last ? text.size() - behind.size() : text.find(behind);
        if (end == 0 || end == std::string_view::npos) return std::nullopt;
        places.push_back(text.substr(0, end));
        text.remove_prefix(end + behind.size());
        at = next;
    }
    return text.empty() ? std::optional(places) : std::nullopt;
}

Sentence readAs(std::string_view text, std::span<const char* const> forms) { return readAs(text, forms, 0); }

std::string Sentence::english() const {
    if (!form_) return text_;
    std::string text;
    for (std::size_t i = 0; i < text_.size(); ++i) {
        const int place = placeAt(text_, i);
        if (place < 0 || std::cmp_greater_equal(place, arguments_.size())) {
            text += text_[i];
            continue;
        }
        text += arguments_[static_cast<std::size_t>(place)].english();
        i += 2;
    }
    return text;
}

Sentence sentenceOf(const std::exception& error) {
    if (const auto* worded = dynamic_cast<const Worded*>(&error)) return worded->sentence();
    return Sentence(std::string(error.what()));
}

} // namespace rtcore
