#include "rtcore/io/text/strict_table.h"

#include "rtcore/io/text/text_file.h"
#include "rtcore/io/text/toml_writer.h"
#include "rtcore/math/nearest_float.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/settings/nearest_name.h"
#include "rtcore/settings/number_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace rtcore {

namespace {

[[noreturn]] void failAt(const std::string& file, TextPosition position, const Sentence& message) {
    throw FileError(FailureKind::BadData, file, message, position.line, position.column);
}

[[noreturn]] void failType(const std::string& file, std::string_view key, const TextValue& value,
                           const Sentence& wanted) {
    failAt(file, value.position, say("{0} is {1}, but takes {2}", key, describeType(value), wanted));
}

Sentence describeLimits(const Limits& limits) {
    if (limits.minimum <= kAnyNumber.minimum) return say("a finite number");
    const std::string min = shortestText(limits.minimum), max = shortestText(limits.maximum);
    const bool above = limits.minimumExcluded, below = limits.maximumExcluded;
    if (limits.maximum >= kAnyNumber.maximum)
        return say(above ? "a finite number above {0}" : "a finite number at least {0}", min);
    if (above)
        return say(below ? "a number above {0} and below {1}" : "a number above {0} and at most {1}", min,
                   max);
    return say(below ? "a number at least {0} and below {1}" : "a number at least {0} and at most {1}", min,
               max);
}

template <typename Number>
bool within(Number value, const Limits& limits) {
    const auto low = static_cast<Number>(limits.minimum), high = static_cast<Number>(limits.maximum);
    const bool aboveLow = limits.minimumExcluded ? value > low : value >= low;
    const bool belowHigh = limits.maximumExcluded ? value < high : value <= high;
    return std::isfinite(value) && aboveLow && belowHigh;
}

/// Where a number is read: for the messages.
struct Place {
    const std::string& file;
    std::string_view key;
};

double anyNumber(const Place& place, const TextValue& value, const Limits& limits) {
    if (const auto* whole = std::get_if<std::int64_t>(&value.content)) return static_cast<double>(*whole);
    if (const auto* number = std::get_if<double>(&value.content)) return *number;
    failType(place.file, place.key, value, describeLimits(limits));
}

template <typename Number>
Number checkedNumber(const Place& place, const TextValue& value, const Limits& limits) {
    const double number = anyNumber(place, value, limits);
    Number rounded{};
    if constexpr (std::is_same_v<Number, float>) {
        rounded = nearestFloat(number);
    } else {
        rounded = number;
    }
    if (within(rounded, limits)) return rounded;
    failAt(place.file, value.position,
           say("{0} is {1}, but takes {2}", place.key, shortestText(number), describeLimits(limits)));
}

template <typename Number = float>
std::array<Number, 3> threeNumbers(const Place& place, const TextValue& value, const Limits& limits) {
    const auto* array = std::get_if<TextArray>(&value.content);
    if (array == nullptr) failType(place.file, place.key, value, say("three numbers in brackets"));
    if (array->size() != 3)
        failAt(place.file, value.position,
               say("{0} has {1} values, but takes three numbers in brackets", place.key, array->size()));
    std::array<Number, 3> numbers{};
    for (std::size_t i = 0; i < 3; ++i) numbers[i] = checkedNumber<Number>(place, (*array)[i], limits);
    return numbers;
}

std::filesystem::path checkedPath(const Place& place, const TextValue& value,
                                  const std::filesystem::path& folder) {
    const auto* text = std::get_if<std::string>(&value.content);
    if (text == nullptr) failType(place.file, place.key, value, say("a path in quotes"));
    const bool hasZero = text->find('\0') != std::string::npos;
    if (text->empty() || hasZero)
        failAt(place.file, value.position, say("{0} is no path; give the name of a file", place.key));
    return folder / pathFromUtf8(*text);
}

} // namespace

Sentence describeType(const TextValue& value) {
    constexpr std::array<const char*, 7> names{
        form("a date or time"), form("true or false"), form("a whole number"), form("a number"),
        form("text"),           form("an array"),      form("a table")};
    return names[value.content.index()];
}

StrictTable::StrictTable(const TextValue& table, const std::string& file) : table_(&table), file_(&file) {}

const TextEntry* StrictTable::find(std::string_view key) const {
    const auto& entries = std::get<TextTable>(table_->content).entries;
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const TextEntry& e) { return e.key == key; });
    return found == entries.end() ? nullptr : &*found;
}

const TextValue* StrictTable::value(std::string_view key) {
    asked_.push_back(key);
    const TextEntry* entry = find(key);
    return entry == nullptr ? nullptr : &entry->value;
}

template <typename T>
const T* StrictTable::typed(std::string_view key, const Sentence& wanted) {
    const TextValue* found = value(key);
    if (found == nullptr) return nullptr;
    const T* content = std::get_if<T>(&found->content);
    if (content == nullptr) failType(*file_, key, *found, wanted);
    return content;
}

std::optional<bool> StrictTable::boolean(std::string_view key) {
    const bool* flag = typed<bool>(key, form("true or false"));
    return flag == nullptr ? std::nullopt : std::optional(*flag);
}

std::optional<int> StrictTable::integer(std::string_view key, int minimum, int maximum) {
    const Sentence range = say("a whole number from {0} to {1}", minimum, maximum);
    const auto* whole = typed<std::int64_t>(key, range);
    if (whole == nullptr) return std::nullopt;
    if (*whole < minimum || *whole > maximum) fail(key, say("{0} is {1}, but takes {2}", key, *whole, range));
    return static_cast<int>(*whole);
}

std::optional<std::vector<int>> StrictTable::integers(std::string_view key, int minimum, int maximum) {
    const auto* array = typed<TextArray>(key, form("whole numbers in brackets"));
    if (array == nullptr) return std::nullopt;
    const Sentence range = say("only whole numbers from {0} to {1}", minimum, maximum);
    std::vector<int> numbers;
    for (const TextValue& item : *array) {
        const std::int64_t* number = std::get_if<std::int64_t>(&item.content);
        if (number == nullptr) failType(*file_, key, item, range);
        if (*number < minimum || *number > maximum)
            fail(key, say("{0} has {1}, but takes {2}", key, *number, range));
        numbers.push_back(static_cast<int>(*number));
    }
    return numbers;
}

std::optional<float> StrictTable::number(std::string_view key, const Limits& limits) {
    const TextValue* found = value(key);
    return found == nullptr ? std::nullopt
                            : std::optional(checkedNumber<float>({*file_, key}, *found, limits));
}

std::optional<double> StrictTable::preciseNumber(std::string_view key, const Limits& limits) {
    const TextValue* found = value(key);
    return found == nullptr ? std::nullopt
                            : std::optional(checkedNumber<double>({*file_, key}, *found, limits));
}

std::optional<std::string> StrictTable::text(std::string_view key) {
    const std::string* found = typed<std::string>(key, form("text in quotes"));
    return found == nullptr ? std::nullopt : std::optional(*found);
}

std::optional<std::size_t> StrictTable::choice(std::string_view key,
                                               std::span<const std::string_view> names) {
    const std::string* name = typed<std::string>(key, form("a name in quotes"));
    if (name == nullptr) return std::nullopt;
    const auto found = std::find(names.begin(), names.end(), *name);
    if (found == names.end()) fail(key, unknownNameMessage(key, *name, names));
    return static_cast<std::size_t>(found - names.begin());
}

std::optional<Vec3> StrictTable::vector(std::string_view key) {
    const TextValue* found = value(key);
    if (found == nullptr) return std::nullopt;
    const auto [x, y, z] = threeNumbers({*file_, key}, *found, kAnyNumber);
    return Vec3{x, y, z};
}

std::optional<Vec3> StrictTable::position(std::string_view key) {
    if (shift_ == FilePoint{}) return vector(key);
    const TextValue* found = value(key);
    if (found == nullptr) return std::nullopt;
    const auto p = threeNumbers<double>({*file_, key}, *found, kAnyNumber);
    return Vec3{nearestFloat(p[0] + shift_[0]), nearestFloat(p[1] + shift_[1]),
                nearestFloat(p[2] + shift_[2])};
}

std::optional<FilePoint> StrictTable::precisePosition(std::string_view key) {
    const TextValue* found = value(key);
    if (found == nullptr) return std::nullopt;
    return shifted(threeNumbers<double>({*file_, key}, *found, kCoordinate));
}

std::optional<std::vector<FilePoint>> StrictTable::positions(std::string_view key) {
    const auto* array = typed<TextArray>(key, form("positions in brackets"));
    if (array == nullptr) return std::nullopt;
    std::vector<FilePoint> points;
    for (const TextValue& item : *array)
        points.push_back(shifted(threeNumbers<double>({*file_, key}, item, kCoordinate)));
    return points;
}

FilePoint StrictTable::shifted(FilePoint point) const {
    for (std::size_t i = 0; i < 3; ++i) point[i] += shift_[i];
    return point;
}

std::optional<float> StrictTable::height(std::string_view key, Vec3 up) {
    if (shift_ == FilePoint{}) return number(key, kAnyNumber);
    const auto height = preciseNumber(key, kAnyNumber);
    if (!height) return std::nullopt;
    double shift = 0;
    for (int i = 0; i < 3; ++i) shift += double{up[i]} * shift_[static_cast<std::size_t>(i)];
    return nearestFloat(*height + shift);
}

LocalOrigin StrictTable::readOrigin(const std::optional<LocalOrigin>& zero) {
    LocalOrigin own;
    if (const TextValue* found = value("origin"))
        own.at = threeNumbers<double>({*file_, "origin"}, *found, kCoordinate);
    if (!zero) return own;
    for (std::size_t i = 0; i < 3; ++i) shift_[i] = own.at[i] - zero->at[i];
    return *zero;
}

std::optional<Colour> StrictTable::colour(std::string_view key, const Limits& limits) {
    const TextValue* found = value(key);
    if (found == nullptr) return std::nullopt;
    const auto [r, g, b] = threeNumbers({*file_, key}, *found, limits);
    return Colour{r, g, b};
}

std::optional<Colour> StrictTable::colourOrNumber(std::string_view key, const Limits& limits) {
    const TextEntry* entry = find(key);
    const bool array = entry != nullptr && std::holds_alternative<TextArray>(entry->value.content);
    if (array) return colour(key, limits);
    const std::optional<float> grey = number(key, limits);
    return grey ? std::optional(Colour{*grey, *grey, *grey}) : std::nullopt;
}

std::optional<std::vector<bool>> StrictTable::booleans(std::string_view key) {
    const auto* array = typed<TextArray>(key, form("true and false in brackets"));
    if (array == nullptr) return std::nullopt;
    std::vector<bool> flags;
    for (const TextValue& item : *array) {
        const bool* flag = std::get_if<bool>(&item.content);
        if (flag == nullptr) failType(*file_, key, item, say("only true and false"));
        flags.push_back(*flag);
    }
    return flags;
}

std::optional<std::vector<std::string>> StrictTable::texts(std::string_view key) {
    const auto* array = typed<TextArray>(key, form("texts in brackets"));
    if (array == nullptr) return std::nullopt;
    std::vector<std::string> result;
    for (const TextValue& item : *array) {
        const auto* text = std::get_if<std::string>(&item.content);
        if (text == nullptr) failType(*file_, key, item, say("only texts in quotes"));
        result.push_back(*text);
    }
    return result;
}

std::optional<std::filesystem::path> StrictTable::path(std::string_view key,
                                                       const std::filesystem::path& folder) {
    const TextValue* found = value(key);
    return found == nullptr ? std::nullopt : std::optional(checkedPath({*file_, key}, *found, folder));
}

std::optional<std::vector<std::filesystem::path>> StrictTable::paths(std::string_view key,
                                                                     const std::filesystem::path& folder) {
    const auto* array = typed<TextArray>(key, form("paths in brackets"));
    if (array == nullptr) return std::nullopt;
    std::vector<std::filesystem::path> result;
    for (const TextValue& item : *array) result.push_back(checkedPath({*file_, key}, item, folder));
    return result;
}

std::optional<StrictTable> StrictTable::table(std::string_view key) {
    const TextValue* found = value(key);
    if (found == nullptr) return std::nullopt;
    if (!std::holds_alternative<TextTable>(found->content))
        failType(*file_, key, *found, say("a table, [{0}]", key));
    return within(*found);
}

StrictTable StrictTable::within(const TextValue& table) const {
    StrictTable result(table, *file_);
    result.version_ = version_;
    result.shift_ = shift_;
    return result;
}

std::vector<StrictTable> StrictTable::tables(std::string_view key) {
    const Sentence wanted = say("tables, [[{0}]]", key);
    std::vector<StrictTable> result;
    const auto* array = typed<TextArray>(key, wanted);
    if (array == nullptr) return result;
    for (const TextValue& item : *array) {
        if (!std::holds_alternative<TextTable>(item.content)) failType(*file_, key, item, wanted);
        result.push_back(within(item));
    }
    return result;
}

void StrictTable::checkVersion(int newest) {
    const auto* version = typed<std::int64_t>("version", std::to_string(newest));
    if (version == nullptr)
        failAt(*file_, {1, 1}, say("the version is missing; begin the file with: version = {0}", newest));
    if (*version < 1 || *version > newest)
        fail("version", say(newest > 1 ? "version {0} is unknown; this program reads version 1 to {1}"
                                       : "version {0} is unknown; this program reads version {1}",
                            *version, newest));
    version_ = static_cast<int>(*version);
}

void StrictTable::needVersion(int version, std::string_view key) const {
    if (version_ >= version || find(key) == nullptr) return;
    fail(key, say("{0} came with version {1} of this format; begin the file with: version = {1}",
                  inQuotes(key), version));
}

void StrictTable::finish() const {
    for (const TextEntry& entry : std::get<TextTable>(table_->content).entries) {
        const bool known = std::find(asked_.begin(), asked_.end(), entry.key) != asked_.end();
        if (!known) failAt(*file_, entry.position, unknownNameMessage(form("key"), entry.key, asked_));
    }
}

void StrictTable::fail(std::string_view key, const Sentence& message) const {
    const TextEntry* entry = find(key);
    failAt(*file_, entry == nullptr ? table_->position : entry->value.position, message);
}

void StrictTable::failMissing(std::string_view key) const {
    failAt(*file_, table_->position, say("the key {0} is missing here; add it", inQuotes(key)));
}

} // namespace rtcore
