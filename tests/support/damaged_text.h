/// Text that is damaged at random, the same for the same seed on every standard library.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace test {

/// How many a test tries; more of them by RT_MUTATIONS.
inline long damagedTexts() {
    const char* const wanted = std::getenv("RT_MUTATIONS");
    const long count = wanted == nullptr ? 0 : std::atol(wanted);
    return count > 0 ? count : 1500;
}

/// Tokens of TOML, and some that may not stand there.
inline constexpr std::array<std::string_view, 24> kTomlTokens{"=",
                                                              "[",
                                                              "]",
                                                              "{",
                                                              "}",
                                                              "\"",
                                                              "'",
                                                              "\"\"\"",
                                                              "\n",
                                                              "\r",
                                                              ".",
                                                              ",",
                                                              "nan",
                                                              "-inf",
                                                              "1e999",
                                                              "-0.0",
                                                              "9223372036854775807",
                                                              "1979-05-27T07:32:00Z",
                                                              "true",
                                                              "\\u0000",
                                                              "\xFF",
                                                              "\xEF\xBB\xBF",
                                                              "a.b.c.d",
                                                              "[["};

/// The same for JSON.
inline constexpr std::array<std::string_view, 22> kJsonTokens{
    "{",          "}",       "[",     "]",        ":",
    ",",          "\"",      "null",  "true",     "false",
    "-1",         "0.5",     "1e999", "-0",       "18446744073709551616",
    "4294967295", "\\ud800", "\xFF",  "[[[[[[[[", "{}",
    "[]",         "\"\""};

/// Damages examples in one to three places; pieces of one get into another.
class DamagedText {
  public:
    DamagedText(std::vector<std::string> examples, std::span<const std::string_view> tokens,
                std::uint32_t seed)
        : examples_(std::move(examples)), tokens_(tokens), bits_(seed) {}

    std::string next() {
        std::string text = example();
        for (std::size_t damages = 1 + below(3); damages > 0; --damages) text = damage(std::move(text));
        return text;
    }

  private:
    std::size_t below(std::size_t end) { return static_cast<std::uint32_t>(bits_()) % end; }
    std::size_t position(const std::string& text) { return below(text.size() + 1); }
    const std::string& example() { return examples_[below(examples_.size())]; }
    std::string_view token() { return tokens_[below(tokens_.size())]; }
    std::string piece(const std::string& text) {
        const std::size_t at = position(text);
        return text.substr(at, below(40));
    }

    std::string damage(std::string text) {
        const std::size_t at = position(text);
        switch (below(8)) {
        case 0:
            return text.substr(0, at);
        case 1:
            return text.substr(at);
        case 2:
            return text.insert(at, token());
        case 3:
            return text.insert(at, piece(example()));
        case 4:
            return text.erase(at, below(12));
        case 5:
            return text.insert(at, 1, static_cast<char>(below(256)));
        case 6: {
            const std::size_t length = below(12);
            return text.replace(at, length, token());
        }
        default:
            break;
        }
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ static_cast<char>(1U << below(8)));
        return text;
    }

    std::vector<std::string> examples_;
    std::span<const std::string_view> tokens_;
    std::mt19937 bits_;
};

} // namespace test
