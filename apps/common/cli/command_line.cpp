#include "common/cli/command_line.h"

#include "rtcore/settings/nearest_name.h"
#include "rtcore/settings/number_text.h"

#include <boost/program_options/errors.hpp>
#include <boost/program_options/options_description.hpp>
#include <boost/program_options/parsers.hpp>
#include <boost/program_options/value_semantic.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>

namespace app {

namespace po = boost::program_options;

namespace {

// "-ao" would be "-a o" to Boost, so the thesis' spellings are turned into long ones first, and old names
// into present ones. (Its own way, allow_long_disguise, breaks "-a" as soon as "-ao" exists.)
std::vector<std::string> replaceOldSpellings(const ProgramSpec& spec,
                                             std::span<const std::string> arguments) {
    std::map<std::string, std::string> spellings;
    for (const OptionGroup& group : spec.groups) {
        for (const Option& option : group.options) {
            for (const std::string& spelling : option.thesis) spellings[spelling] = "--" + option.name;
            for (const std::string& name : option.formerly) spellings["--" + name] = "--" + option.name;
        }
    }
    std::vector<std::string> result(arguments.begin(), arguments.end());
    for (std::string& argument : result) {
        if (argument == "--") break;
        const std::size_t end = argument.starts_with("--") ? argument.find('=') : std::string::npos;
        if (const auto found = spellings.find(argument.substr(0, end)); found != spellings.end())
            argument.replace(0, end, found->second);
    }
    return result;
}

po::options_description describe(const ProgramSpec& spec) {
    po::options_description description;
    for (const OptionGroup& group : spec.groups) {
        for (const Option& option : group.options) {
            std::string names = option.name;
            if (option.letter != 0) names += std::string(",") + option.letter;
            if (option.value == ValueKind::None) {
                description.add_options()(names.c_str(), "");
            } else {
                description.add_options()(names.c_str(), po::value<std::string>(), "");
            }
        }
    }
    return description;
}

std::string describeSyntaxError(const po::invalid_syntax& error) {
    const std::string name = "option '" + error.get_option_name() + "'";
    switch (error.kind()) {
    case po::invalid_syntax::extra_parameter:
        return name + " takes no value";
    case po::invalid_syntax::missing_parameter:
    case po::invalid_syntax::empty_adjacent_parameter:
        return name + " needs a value";
    default:
        return "unrecognised argument " + rtcore::inQuotes(error.tokens());
    }
}

std::string describeUnknown(const ProgramSpec& spec, const std::string& given) {
    std::vector<std::string_view> known;
    for (const OptionGroup& group : spec.groups) {
        for (const Option& option : group.options) known.push_back(option.name);
    }
    std::string_view nearest;
    if (given.starts_with("--")) nearest = rtcore::nearestName(std::string_view(given).substr(2), known);
    std::string text = "unknown option " + rtcore::inQuotes(given);
    if (!nearest.empty()) text.append("; did you mean '--").append(nearest).append("'?");
    return text;
}

po::parsed_options runBoost(const ProgramSpec& spec, const po::options_description& description,
                            const std::vector<std::string>& arguments) {
    try {
        const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
        return po::command_line_parser(arguments).options(description).style(style).run();
    } catch (const po::unknown_option& error) {
        throw UsageError(describeUnknown(spec, error.get_option_name()));
    } catch (const po::invalid_syntax& error) {
        throw UsageError(describeSyntaxError(error));
    } catch (const po::error& error) {
        throw UsageError(error.what());
    }
}

std::string rangeText(const Option& option) {
    const bool low = option.minimum > std::numeric_limits<double>::lowest();
    const bool high = option.maximum < std::numeric_limits<double>::max();
    const std::string min = rtcore::shortestText(option.minimum);
    const std::string max = rtcore::shortestText(option.maximum);
    if (low && high) return fmt::format(" from {} to {}", min, max);
    if (low) return " of at least " + min;
    if (high) return " of at most " + max;
    return "";
}

std::string listOf(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

[[noreturn]] void refuse(const Option& option, const std::string& value, const std::string& wanted) {
    throw UsageError("option '--" + option.name + "': " + rtcore::inQuotes(value) + " is not " + wanted);
}

template <typename Value>
void checkRange(const Option& option, const std::string& text, const std::optional<Value>& value,
                const std::string& type) {
    const bool good = value && static_cast<double>(*value) >= option.minimum &&
                      static_cast<double>(*value) <= option.maximum;
    if (!good) refuse(option, text, type + rangeText(option));
}

void checkValue(const Option& option, const std::string& value) {
    switch (option.value) {
    case ValueKind::None:
        break;
    case ValueKind::Text:
        if (value.empty()) throw UsageError("option '--" + option.name + "' needs a value");
        break;
    case ValueKind::Integer:
        checkRange(option, value, parseInteger(value), "a whole number");
        break;
    case ValueKind::Number:
        checkRange(option, value, parseNumber(value), "a number");
        break;
    case ValueKind::Choice:
        if (std::find(option.choices.begin(), option.choices.end(), value) == option.choices.end()) {
            refuse(option, value, "one of " + listOf(option.choices));
        }
        break;
    }
}

void checkPositionals(const ProgramSpec& spec, const Arguments& arguments) {
    const std::size_t given = arguments.positionals().size();
    for (const std::string& name : arguments.positionals()) {
        if (name.empty()) throw UsageError("an argument is empty");
    }
    const bool repeats = !spec.positionals.empty() && spec.positionals.back().repeats;
    if (given > spec.positionals.size() && !repeats) {
        throw UsageError("unexpected argument " +
                         rtcore::inQuotes(arguments.positionals()[spec.positionals.size()]));
    }
    const auto answers = [&](const Occurrence& occurrence) {
        const Option* option = spec.find(occurrence.name);
        return option != nullptr && option->answers;
    };
    if (std::any_of(arguments.options().begin(), arguments.options().end(), answers)) return;
    if (given < spec.requiredPositionals()) throw UsageError("missing " + spec.positionals[given].name);
}

} // namespace

std::optional<std::int64_t> parseInteger(std::string_view text) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::optional<double> parseNumber(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::optional<std::string> Arguments::text(std::string_view name) const {
    const auto found = std::find_if(options_.rbegin(), options_.rend(),
                                    [&](const Occurrence& option) { return option.name == name; });
    if (found == options_.rend()) return std::nullopt;
    return found->value;
}

std::optional<std::int64_t> Arguments::integer(std::string_view name) const {
    const std::optional<std::string> value = text(name);
    return value ? parseInteger(*value) : std::nullopt;
}

std::optional<double> Arguments::number(std::string_view name) const {
    const std::optional<std::string> value = text(name);
    return value ? parseNumber(*value) : std::nullopt;
}

std::vector<std::string> Arguments::all(std::string_view name) const {
    std::vector<std::string> values;
    for (const Occurrence& option : options_) {
        if (option.name == name) values.push_back(option.value);
    }
    return values;
}

Arguments parseCommandLine(const ProgramSpec& spec, std::span<const std::string> arguments) {
    const po::options_description description = describe(spec);
    const po::parsed_options parsed = runBoost(spec, description, replaceOldSpellings(spec, arguments));

    std::vector<Occurrence> options;
    std::vector<std::string> positionals;
    for (const po::option& option : parsed.options) {
        if (option.position_key >= 0) {
            positionals.insert(positionals.end(), option.value.begin(), option.value.end());
            continue;
        }
        const std::string value = option.value.empty() ? std::string() : option.value.front();
        // Boost sees that "-o --width" lacks a value, but not that "-o --width=3" does.
        const bool apart = option.original_tokens.size() > 1;
        if (apart && value.starts_with("--"))
            throw UsageError("option '--" + option.string_key + "' needs a value");
        if (const Option* known = spec.find(option.string_key)) checkValue(*known, value);
        options.push_back({option.string_key, value});
    }
    Arguments result(std::move(options), std::move(positionals));
    checkPositionals(spec, result);
    return result;
}

} // namespace app
