#include "common/commands/outline_text.h"

#include "rtcore/platform/error.h"
#include "rtcore/settings/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <system_error>

namespace app {

namespace {

const std::string kOutlineName = "the server's outline"; // in errors
constexpr std::size_t kMaxStoreys = 1000;
constexpr int kMaxSteps = 1'000'000;

[[noreturn]] void fail() {
    throw rtcore::FileError(rtcore::FailureKind::BadData, kOutlineName, "it cannot be read");
}

template <typename Numbers>
void addNumbers(std::string& text, std::string_view name, const Numbers& numbers) {
    text += name;
    for (const auto number : numbers) text += ' ' + rtcore::shortestText(number);
    text += '\n';
}

void addLines(std::string& text, std::string_view name, const std::vector<ToldOutline::Line>& lines) {
    for (const ToldOutline::Line& line : lines) {
        text += name;
        for (const auto& [x, y] : line) fmt::format_to(std::back_inserter(text), " {} {}", x, y);
        text += '\n';
    }
}

/// The words of one line, one after another.
class LineWords {
  public:
    explicit LineWords(std::string_view line) : rest_(line) {}

    bool more() const { return !rest_.empty(); }
    std::string_view word() {
        const std::size_t end = std::min(rest_.find(' '), rest_.size());
        const std::string_view word = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        return word;
    }
    template <typename Number>
    Number number() {
        const std::string_view text = word();
        Number value{};
        const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
        if (read.ec != std::errc() || read.ptr != text.data() + text.size()) fail();
        return value;
    }
    double finite() {
        const auto value = number<double>();
        if (!std::isfinite(value)) fail();
        return value;
    }
    template <typename Number, std::size_t kCount>
    void read(std::array<Number, kCount>& values) {
        for (Number& value : values) value = static_cast<Number>(finite());
    }
    int steps() {
        const auto value = number<int>();
        if (value < 0 || value > kMaxSteps) fail();
        return value;
    }
    ToldOutline::Line line() {
        ToldOutline::Line line;
        while (more()) {
            const int x = steps();
            line.push_back({x, steps()});
        }
        if (line.size() < 2) fail();
        return line;
    }

  private:
    std::string_view rest_;
};

void take(ToldOutline& outline, LineWords words) {
    const std::string_view name = words.word();
    if (name == "storey") {
        outline.storey = words.number<int>();
    } else if (name == "floors") {
        while (words.more() && outline.floors.size() < kMaxStoreys) outline.floors.push_back(words.finite());
    } else if (name == "top") {
        outline.top = words.finite();
    } else if (name == "eye") {
        outline.eyeHeight = words.finite();
    } else if (name == "corner") {
        words.read(outline.corner);
    } else if (name == "right") {
        words.read(outline.right);
    } else if (name == "ahead") {
        words.read(outline.ahead);
    } else if (name == "up") {
        words.read(outline.up);
    } else if (name == "step") {
        outline.step = words.finite();
    } else if (name == "size") {
        outline.size = {words.steps(), 0};
        outline.size[1] = words.steps();
    } else if (name == "solid") {
        outline.solids.push_back(words.line());
    } else if (name == "line") {
        outline.lines.push_back(words.line());
    } else if (name == "light") {
        outline.light.push_back(words.line());
    }
}

} // namespace

int storeyAt(const std::vector<double>& floors, double top, double eye) {
    if (floors.empty()) return 0;
    int storey = 0;
    while (static_cast<std::size_t>(storey) < floors.size() && floors[static_cast<std::size_t>(storey)] < eye)
        ++storey;
    return eye > top ? 1 : std::max(storey, 1);
}

std::string formatOutline(const ToldOutline& outline) {
    std::string text = fmt::format("storey {}\n", outline.storey);
    addNumbers(text, "floors", outline.floors);
    addNumbers(text, "top", std::array{outline.top});
    addNumbers(text, "eye", std::array{outline.eyeHeight});
    addNumbers(text, "corner", outline.corner);
    addNumbers(text, "right", outline.right);
    addNumbers(text, "ahead", outline.ahead);
    addNumbers(text, "up", outline.up);
    addNumbers(text, "step", std::array{outline.step});
    text += fmt::format("size {} {}\n", outline.size[0], outline.size[1]);
    addLines(text, "solid", outline.solids);
    addLines(text, "line", outline.lines);
    addLines(text, "light", outline.light);
    text.pop_back();
    return text;
}

ToldOutline parseOutline(std::string_view text) {
    ToldOutline outline;
    if (!text.starts_with("storey ")) fail();
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        take(outline, LineWords(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    const bool named =
        outline.storey >= 0 && static_cast<std::size_t>(outline.storey) <= outline.floors.size();
    if (!named || !(outline.step > 0)) fail();
    return outline;
}

} // namespace app
