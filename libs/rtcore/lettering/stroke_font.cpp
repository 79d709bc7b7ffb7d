#include "rtcore/lettering/stroke_font.h"

#include <algorithm>
#include <array>

namespace rtcore {

namespace {

// Digits have one width, so that columns of numbers stand below each other.
constexpr auto kGlyphs = std::to_array<Glyph>({
    {' ', 4, ""},
    {'.', 2, "1414"},
    {',', 2, "1402"},
    {'-', 6, "0a6a"},
    {'+', 6, "0a6a 3d37"},
    {'/', 6, "036h"},
    {':', 2, "1515 1b1b"},
    {'0', 8, "2464878d6g2g0d0724"},
    {'1', 8, "2d5g54"},
    {'2', 8, "0d2g6g8d8b0484"},
    {'3', 8, "0e2g6g8e8c6a3a 6a8886642406"},
    {'4', 8, "6g0888 6g64"},
    {'5', 8, "8g1g0a2b6b8986642406"},
    {'6', 8, "7g4g1d0906246486886a2a08"},
    {'7', 8, "0g8g34"},
    {'8', 8, "2a0c0e2g6g8e8c6a2a0806246486886a"},
    {'9', 8, "1444778b8e6g2g0e0c2a6a8c"},
    {'A', 8, "044g84 1878"},
    {'B', 8, "040g5g7e7c5a0a 5a78765404"},
    {'C', 8, "8d6g2g0d07246487"},
    {'D', 8, "040g5g8d875404"},
    {'E', 8, "8g0g0484 0a6a"},
    {'F', 8, "8g0g04 0a6a"},
    {'G', 8, "8d6g2g0d072464878a5a"},
    {'H', 8, "0g04 8g84 0a8a"},
    {'I', 2, "1g14"},
    {'J', 6, "6g67442406"},
    {'K', 8, "0g04 8g08 3b84"},
    {'L', 8, "0g0484"},
    {'M', 10, "040g58aga4"},
    {'N', 8, "040g848g"},
    {'O', 10, "3g7gada77434070d3g"},
    {'P', 8, "040g6g8e8c6a0a"},
    {'Q', 10, "3g7gada77434070d3g 68a4"},
    {'R', 8, "040g6g8e8c6a0a 4a84"},
    {'S', 8, "8e6g2g0e0c2a6a8886642406"},
    {'T', 8, "0g8g 4g44"},
    {'U', 8, "0g072464878g"},
    {'V', 8, "0g448g"},
    {'W', 10, "0g345c74ag"},
    {'X', 8, "0g84 048g"},
    {'Y', 8, "0g4a8g 4a44"},
    {'Z', 8, "0g8g0484"},
    {'a', 6, "6c64 6a4c2c0a06244466"},
    {'b', 6, "0g04 0a2c4c6a66442406"},
    {'c', 6, "6a4c2c0a06244466"},
    {'d', 6, "6g64 6a4c2c0a06244466"},
    {'e', 6, "08686a4c2c0a06244465"},
    {'f', 4, "4g3g2e24 0c4c"},
    {'g', 6, "6c62402001 6a4c2c0a06244466"},
    {'h', 6, "0g04 0a2c4c6a64"},
    {'i', 2, "1c14 1g1g"},
    {'j', 2, "2c221000 2g2g"},
    {'k', 6, "0g04 6c07 2964"},
    {'l', 3, "1g152434"},
    {'m', 10, "0c04 0a2c3c5a54 5a7c8caaa4"},
    {'n', 6, "0c04 0a2c4c6a64"},
    {'o', 6, "2c4c6a664424060a2c"},
    {'p', 6, "0c00 0a2c4c6a66442406"},
    {'q', 6, "6c60 6a4c2c0a06244466"},
    {'r', 4, "0c04 0a2c4c"},
    {'s', 6, "6b4c2c0a195766442405"},
    {'t', 5, "2g263454 0c5c"},
    {'u', 6, "0c06244466 6c64"},
    {'v', 6, "0c346c"},
    {'w', 10, "0c245c84ac"},
    {'x', 6, "0c64 046c"},
    {'y', 6, "0c34 6c2100"},
    {'z', 6, "0c6c0464"},
});

} // namespace

std::optional<Glyph> glyphOf(char letter) {
    const auto found = std::ranges::find(kGlyphs, letter, &Glyph::letter);
    return found == kGlyphs.end() ? std::nullopt : std::optional(*found);
}

} // namespace rtcore
