#include "common/key_names.h"

#include <algorithm>
#include <array>
#include <utility>

namespace app {

namespace {

constexpr std::array<std::pair<std::string_view, int>, 8> kNamed{{{"space", key::kSpace},
                                                                  {"left", key::kLeft},
                                                                  {"right", key::kRight},
                                                                  {"up", key::kUp},
                                                                  {"down", key::kDown},
                                                                  {"shift", key::kShift},
                                                                  {"ctrl", key::kControl},
                                                                  {"capslock", key::kCapsLock}}};

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

} // namespace

std::optional<int> keyCode(std::string_view name) {
    std::string plain(name);
    std::transform(plain.begin(), plain.end(), plain.begin(), lower);
    if (plain.size() == 1) {
        const char c = plain.front();
        if (c >= 'a' && c <= 'z') return c - 'a' + 'A';
        if (c >= '0' && c <= '9') return c;
    }
    for (const auto& [known, code] : kNamed) {
        if (known == plain) return code;
    }
    return std::nullopt;
}

std::string keyNames() {
    std::string names = "a to z, 0 to 9";
    for (const auto& [name, code] : kNamed) names.append(", ").append(name);
    return names;
}

} // namespace app
