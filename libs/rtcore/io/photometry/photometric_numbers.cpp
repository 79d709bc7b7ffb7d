#include "rtcore/io/photometry/photometric_numbers.h"

#include "rtcore/platform/error.h"
#include "rtcore/settings/number_text.h"
#include "rtcore/settings/plain_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace rtcore {

namespace {

constexpr std::string_view kSpace = " \t\r\v\f\x1A"; // the last one ended files of DOS

std::string_view trimmed(std::string_view line) {
    const std::size_t first = line.find_first_not_of(kSpace);
    if (first == std::string_view::npos) return {};
    return line.substr(first, line.find_last_not_of(kSpace) - first + 1);
}

} // namespace

std::optional<std::string_view> PhotometricLines::next() {
    if (rest_.empty()) return std::nullopt;
    const std::size_t end = rest_.find('\n');
    const std::string_view line = rest_.substr(0, end);
    rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
    ++line_;
    return trimmed(line);
}

void PhotometricLines::fail(const Sentence& message) const {
    throw FileError(FailureKind::BadData, name_, message, line_);
}

void PhotometricLines::failCutOff(const char* wanted) const {
    fail(say("the file ends where {0} should follow; it was cut off, so get it again", say(wanted)));
}

double PhotometricLines::number(std::string_view words, const char* wanted) const {
    constexpr double kMax = 1e9;
    if (words.starts_with('+')) words.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), value);
    if (error != std::errc{} || end != words.data() + words.size() || !(std::fabs(value) <= kMax))
        fail(say("{0} should stand here, a number, and not '{1}'", say(wanted),
                 printable(words.substr(0, 40))));
    return value;
}

void checkNumber(const PhotometricLines& lines, double number, const char* wanted, const NumberRange& range) {
    const bool fits = number >= range.min && number <= range.max;
    if (fits && (!range.whole || number == std::floor(number))) return;
    lines.fail(say(range.whole ? "{0} is {1}, but is a whole number from {2} to {3}"
                               : "{0} is {1}, but is from {2} to {3}",
                   say(wanted), shortestText(number), shortestText(range.min), shortestText(range.max)));
}

void checkCounts(const PhotometricLines& lines, std::size_t gammas, std::size_t planes) {
    if (gammas * planes > kMaxIntensities)
        lines.fail(say("{0} times {1} angles are too many; at most {2} intensities are taken", gammas, planes,
                       kMaxIntensities));
}

void checkAngle(const PhotometricLines& lines, const std::vector<double>& before, double angle,
                const NumberRange& range) {
    constexpr double kApart = 1e-3;
    checkNumber(lines, angle, form("an angle"), range);
    if (!before.empty() && angle < before.back() + kApart)
        lines.fail(say("the angle {0} follows {1}; angles ascend, by a thousandth of a degree or more",
                       shortestText(angle), shortestText(before.back())));
}

void failBehindLast(const PhotometricLines& lines, std::string_view more) {
    lines.fail(say("more follows behind the last intensity: '{0}'; the numbers of angles are wrong, or what "
                   "follows is to be removed",
                   printable(more.substr(0, 40))));
}

void checkLit(const PhotometricLines& lines, const std::vector<double>& candela) {
    if (std::ranges::none_of(candela, [](double each) { return each > 0; }))
        lines.fail(say("all intensities are zero; choose the file of a luminaire that gives off light"));
}

} // namespace rtcore
