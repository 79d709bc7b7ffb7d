/// Statements of OBJ and MTL files: a keyword and words up to the end of a line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rtcore {

/// Reads words of a text whose last character ends a line. Lines end in "\n", "\r\n" or "\r"; a backslash
/// before that end joins the next one to it.
class StatementText {
  public:
    explicit StatementText(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

    bool atEnd() const { return at_ == end_; }
    /// Lines that end before here.
    std::uint64_t lines() const { return lines_; }

    /// Passes over blanks; whether a word of this line follows.
    bool hasWord() {
        while (at_ != end_) {
            while (isBlank(*at_)) ++at_;
            if (*at_ != '\\' || !isLineEnd(at_[1])) return !isLineEnd(*at_);
            ++at_;
            passLineEnd();
        }
        return false;
    }
    /// The character with which the next word begins, behind hasWord().
    char next() const { return *at_; }
    /// The next word; "" at the end of the line.
    std::string_view word() {
        if (!hasWord()) return {};
        const char* const first = at_;
        while (!endsWord()) ++at_;
        return {first, static_cast<std::size_t>(at_ - first)};
    }
    /// All that is left of the statement, without blanks at both ends; lines that are joined have one between
    /// them.
    std::string rest();
    /// Passes over the rest of the line, as joined to no other one, and its end.
    void endLine() {
        if (at_ == end_) return;
        while (!isLineEnd(*at_)) ++at_;
        passLineEnd();
    }
    /// The same where a backslash joins lines.
    void endStatement() {
        while (hasWord()) word();
        if (at_ != end_) passLineEnd();
    }

    /// The next word, if it is a number: from 1 up, or below 0; else 0, and no word is passed over. A number
    /// behind a slash is a part of a word.
    std::int64_t wholeNumber() {
        const char* at = at_;
        const bool negative = *at == '-';
        if (negative) ++at;
        std::int64_t value = 0;
        constexpr std::int64_t kMax = std::int64_t{1} << 40;
        for (; *at >= '0' && *at <= '9'; ++at)
            if (value < kMax) value = value * 10 + (*at - '0');
        if (value == 0) return 0;
        at_ = at;
        return negative ? -value : value;
    }
    /// Passes over a slash.
    bool slash() {
        const bool is = *at_ == '/';
        if (is) ++at_;
        return is;
    }
    bool endsWord() const { return isBlank(*at_) || isLineEnd(*at_) || (*at_ == '\\' && isLineEnd(at_[1])); }

    /// The next word as a number; nothing where there is none, and the word is passed over then.
    std::optional<float> number();
    /// The same less `zero`, which counts before it is rounded.
    std::optional<float> coordinate(double zero);
    /// The same with all its digits, and a point alone before its fraction.
    std::optional<double> preciseNumber();

  private:
    static bool isBlank(char c) {
        constexpr std::uint64_t kBlanks =
            1U << 0U | 1U << 9U | 1U << 11U | 1U << 12U | std::uint64_t{1} << 32U;
        const auto code = static_cast<unsigned char>(c);
        return code <= 32 && (kBlanks >> code & 1U) != 0;
    }
    static bool isLineEnd(char c) { return c == '\n' || c == '\r'; }
    void passLineEnd() {
        const bool two = *at_ == '\r' && at_ + 1 != end_ && at_[1] == '\n';
        at_ += two ? 2 : 1;
        ++lines_;
    }

    const char* at_;
    const char* end_;
    std::uint64_t lines_ = 0;
};

/// A word as a number, with a point or a comma before its fraction; infinite where it is too large, and no
/// number where it says so. Nothing for what is none.
std::optional<float> numberOf(std::string_view word);
std::optional<double> preciseNumberOf(std::string_view word);

/// In small letters.
std::string inSmallLetters(std::string_view text);
/// Without blanks at both ends, and without quotes around all of it.
std::string_view unquoted(std::string_view text);

/// The end of the last whole statement in a piece of a file: behind an end of a line that joins no other one;
/// 0 where there is none. A line feed may follow "\r" at the end of the piece, so that does not count.
std::size_t wholeStatements(std::string_view piece);

} // namespace rtcore
