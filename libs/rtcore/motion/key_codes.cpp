#include "rtcore/motion/key_codes.h"

#include <algorithm>
#include <array>
#include <utility>

namespace rtcore {

namespace {

constexpr std::array<std::pair<int, std::string_view>, 19> kKeyNames = {{
    {KeyTab, "Tab"},
    {KeyReturn, "Return"},
    {KeyEscape, "Escape"},
    {KeySpace, "Space"},
    {KeyLeft, "Left"},
    {KeyRight, "Right"},
    {KeyUp, "Up"},
    {KeyDown, "Down"},
    {KeyShift, "Shift"},
    {KeyControl, "Control"},
    {KeyAlt, "Alt"},
    {KeyCapsLock, "CapsLock"},
    {KeyPageUp, "PageUp"},
    {KeyPageDown, "PageDown"},
    {KeyHome, "Home"},
    {KeyEnd, "End"},
    {KeyInsert, "Insert"},
    {KeyDelete, "Delete"},
    {KeyBackspace, "Backspace"},
}};

// Not std::toupper, which depends on the locale.
char capital(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

bool sameName(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return capital(x) == capital(y); });
}

bool isPrintable(int key) { return key > KeySpace && key < 127 && !(key >= 'a' && key <= 'z'); }

} // namespace

std::optional<int> keyNamed(std::string_view name) {
    if (name.size() == 1 && isPrintable(capital(name[0]))) return capital(name[0]);
    for (const auto& [key, text] : kKeyNames) {
        if (sameName(text, name)) return key;
    }
    return std::nullopt;
}

std::string keyName(int key) {
    if (isPrintable(key)) return std::string(1, static_cast<char>(key));
    for (const auto& [known, text] : kKeyNames) {
        if (known == key) return std::string(text);
    }
    return {};
}

} // namespace rtcore
