#include "bridge/control/request_words.h"

#include "rtcore/io/text/scn.h"
#include "rtcore/io/text/sun_date.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/settings/number_text.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace bridge {

namespace {

using app::ArgumentType;
using app::CommandArgument;
using nlohmann::json;

rtcore::Sentence nameOf(const CommandArgument& argument) {
    return argument.name.empty() ? rtcore::say("a word") : rtcore::Sentence(argument.name);
}

double numberOf(const CommandArgument& argument, const json& value) {
    if (!value.is_number()) throw Refused(rtcore::say("{0} is a number", nameOf(argument)));
    const auto number = value.get<double>();
    if (!std::isfinite(number) || std::abs(number) > app::kMaxNumber)
        throw Refused(rtcore::say("{0} is out of range", nameOf(argument)));
    return number;
}

std::string wholeWord(const CommandArgument& argument, const json& value, double min, double max) {
    const double number = numberOf(argument, value);
    if (number != std::floor(number) || number < min || number > max)
        throw Refused(
            rtcore::say("{0} is a whole number, at least {1}", nameOf(argument), fmt::format("{}", min)));
    return fmt::format("{}", static_cast<std::int64_t>(number));
}

std::string materialValueWord(const CommandArgument& argument, const json& value) {
    if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
    return rtcore::shortestText(numberOf(argument, value));
}

std::string materialKeyWord(const json& value) {
    if (value.is_string())
        for (const std::string_view key : rtcore::materialKeys())
            if (key == value.get_ref<const std::string&>()) return std::string(key);
    throw Refused("there is no such key of a material");
}

std::string dateWord(const json& value) {
    const auto day =
        value.is_string() ? rtcore::calendarDateOf(value.get_ref<const std::string&>()) : std::nullopt;
    if (!day) throw Refused("DATE is a day from 1800 to 2200, such as 2026-06-21");
    return rtcore::calendarDateText(*day);
}

std::string numberedName(const json& value, std::span<const std::string> names, const char* refusal) {
    const double number = value.is_number() ? value.get<double>() : 0;
    if (!(number >= 1 && number <= static_cast<double>(names.size()) && number == std::floor(number)))
        throw Refused(refusal);
    return names[static_cast<std::size_t>(number) - 1];
}

std::string settingWord(const json& value) {
    const rtcore::Setting* const setting =
        value.is_string() ? rtcore::findSetting(value.get_ref<const std::string&>()) : nullptr;
    if (setting == nullptr || setting->name != value.get_ref<const std::string&>() ||
        !setting->browser.offered)
        throw Refused("there is no such setting");
    return std::string(setting->name);
}

std::string noteWord(const json& value) {
    if (!value.is_string()) throw Refused("the text of a note is a text");
    rtcore::SceneNote note{
        .point = {}, .text = rtcore::noteText(value.get_ref<const std::string&>()), .view = {}};
    if (const auto problem = problemOf(note)) throw Refused(problem->why);
    return std::move(note.text);
}

std::string authorWord(const json& value) {
    if (!value.is_string()) throw Refused("the name of an author is a text");
    std::string name = rtcore::noteAuthor(value.get_ref<const std::string&>());
    const rtcore::SceneNote note{.point = {}, .text = "a", .author = name, .view = {}};
    if (const auto problem = problemOf(note)) throw Refused(problem->why);
    return name;
}

/// One of the words that may stand in an argument's place.
std::optional<std::string> tableWord(const CommandArgument& argument, const json& value) {
    if (!value.is_string()) return std::nullopt;
    const std::vector<std::string_view> words = app::wordsOf(argument);
    const auto found = std::ranges::find(words, value.get_ref<const std::string&>());
    return found == words.end() ? std::nullopt : std::optional(std::string(*found));
}

} // namespace

std::string wordOf(const CommandArgument& argument, const json& value, const RequestContext& context) {
    constexpr double kMin = std::numeric_limits<std::int32_t>::min();
    if (const auto word = tableWord(argument, value)) return *word;
    switch (argument.type) {
    case ArgumentType::Integer:
        return wholeWord(argument, value, std::max(argument.minimum, kMin), app::kMaxWhole);
    case ArgumentType::Number:
        return rtcore::shortestText(numberOf(argument, value));
    case ArgumentType::Choice:
        throw Refused(rtcore::say("a word is one of {0}", argument.words));
    case ArgumentType::Setting:
        return settingWord(value);
    case ArgumentType::Date:
        return dateWord(value);
    case ArgumentType::Part:
    case ArgumentType::Material:
        return wholeWord(argument, value, 1, app::kMaxWhole);
    case ArgumentType::MaterialKey:
        return materialKeyWord(value);
    case ArgumentType::MaterialValue:
        return materialValueWord(argument, value);
    case ArgumentType::Bookmark:
        return numberedName(value, context.bookmarks, "there is no such bookmark");
    case ArgumentType::Flight:
        return numberedName(value, context.flights, "there is no such flight");
    case ArgumentType::Variant:
        return numberedName(value, context.variants, "there is no such variant");
    case ArgumentType::Note:
        return noteWord(value);
    case ArgumentType::Author:
        return authorWord(value);
    case ArgumentType::Text:
    case ArgumentType::Path:
    case ArgumentType::SettingValue: // of `set`, which knows the setting
    case ArgumentType::Key:
    case ArgumentType::Action:
        break;
    }
    throw Refused(rtcore::say("pages give no {0}", nameOf(argument)));
}

} // namespace bridge
