#include "rtcore/io/text/toml_guard.h"

#include "rtcore/io/text/text_file.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"

#include <algorithm>
#include <vector>

namespace rtcore {

namespace {

/// Walks over the text once and knows only strings, comments, brackets and whether a key or a value comes
/// next.
class Guard {
  public:
    Guard(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    void run() {
        while (at_ < text_.size()) step();
    }

  private:
    void step() {
        const char c = text_[at_];
        switch (c) {
        case '"':
        case '\'':
            skipString(c);
            return;
        case '#':
            skipTo(text_.find('\n', at_));
            return;
        case '\n':
            endLine();
            break;
        case '.':
            countDot();
            break;
        case '=':
            startValue();
            break;
        case ',':
            startItem();
            break;
        case '[':
        case '{':
            open(c);
            break;
        case ']':
        case '}':
            close();
            break;
        default:
            break;
        }
        ++at_;
    }

    void endLine() {
        if (!brackets_.empty()) return;
        inKey_ = true;
        dotsOfKey_ = 0;
    }

    void countDot() {
        if (!inKey_) return;
        if (++dotsOfKey_ >= kMaxTomlDepth) refuse(form("a key has too many parts"));
        if (++dots_ > kMaxTomlDots) refuse(form("too many keys with dots"));
    }

    void countValue() {
        if (++values_ > kMaxTomlValues) refuse(form("too many values"));
    }

    void startValue() {
        inKey_ = false;
        countValue();
    }

    void startItem() {
        inKey_ = !brackets_.empty() && brackets_.back() == '{';
        dotsOfKey_ = 0;
        countValue();
    }

    void open(char bracket) {
        countValue();
        // The brackets of [table] and [[table]] close on their own line and enclose a key.
        if (inKey_ && bracket == '[') return;
        if (brackets_.size() >= kMaxTomlDepth) refuse(form("too many brackets within brackets"));
        brackets_.push_back(bracket);
        inKey_ = bracket == '{';
        dotsOfKey_ = 0;
    }

    void close() {
        if (!brackets_.empty()) brackets_.pop_back();
        inKey_ = false;
    }

    void skipString(char quote) {
        const std::string triple(3, quote);
        const bool multiLine = text_.substr(at_, 3) == triple;
        at_ += multiLine ? 3 : 1;
        while (at_ < text_.size()) {
            if (text_[at_] == '\\' && quote == '"') {
                at_ += 2;
            } else if (multiLine ? text_.substr(at_, 3) == triple : text_[at_] == quote) {
                at_ += multiLine ? 3 : 1;
                // A multi-line string may end with one or two quotes of its own.
                while (multiLine && at_ < text_.size() && text_[at_] == quote) ++at_;
                return;
            } else if (text_[at_] == '\n' && !multiLine) {
                return;
            } else {
                ++at_;
            }
        }
    }

    void skipTo(std::size_t position) { at_ = std::min(position, text_.size()); }

    [[noreturn]] void refuse(const char* what) const {
        const TextPosition position = positionAt(text_, at_);
        throw FileError(FailureKind::BadData, file_, say("{0}; no scene needs that", what), position.line,
                        position.column);
    }

    std::string_view text_;
    const std::string& file_;
    std::size_t at_ = 0;
    std::vector<char> brackets_; ///< open ones of values
    bool inKey_ = true;
    std::size_t dotsOfKey_ = 0, dots_ = 0, values_ = 0;
};

} // namespace

void guardToml(std::string_view text, const std::string& file) { Guard(text, file).run(); }

} // namespace rtcore
