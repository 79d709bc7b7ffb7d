/// The keys of a request, checked as they are read.
#pragma once

#include "bridge/control/requests.h"

#include "rtcore/settings/number_text.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace bridge {

using CommandWords = std::vector<std::string>;

/// Every function throws Refused, which names the key.
class RequestFields {
  public:
    explicit RequestFields(const nlohmann::json& request) : request_(request) {}

    bool has(std::string_view key) const {
        const auto found = request_.find(key);
        return found != request_.end() && !found->is_null();
    }
    bool isNull(std::string_view key) const {
        const auto found = request_.find(key);
        return found != request_.end() && found->is_null();
    }
    const nlohmann::json& value(std::string_view key) const {
        const auto found = request_.find(key);
        if (found == request_.end()) throw Refused(fmt::format("'{}' is missing", key));
        return *found;
    }
    double number(std::string_view key) const { return numberOf(value(key), key); }
    std::int64_t integer(std::string_view key) const { return integerOf(value(key), key); }
    bool boolean(std::string_view key) const {
        if (!value(key).is_boolean()) throw Refused(fmt::format("'{}' is true or false", key));
        return value(key).get<bool>();
    }
    std::string text(std::string_view key) const {
        if (!value(key).is_string()) throw Refused(fmt::format("'{}' is a text", key));
        return value(key).get<std::string>();
    }
    bool isArray(std::string_view key) const { return has(key) && value(key).is_array(); }

    /// One of `words`.
    std::string choice(std::string_view key, std::initializer_list<std::string_view> words) const {
        const std::string given = text(key);
        std::string list;
        for (const std::string_view word : words) {
            if (word == given) return given;
            list += (list.empty() ? "" : ", ") + std::string(word);
        }
        throw Refused(fmt::format("'{}' is one of {}", key, list));
    }
    std::string word(std::string_view key) const { return rtcore::shortestText(number(key)); }
    std::string whole(std::string_view key) const { return fmt::format("{}", integer(key)); }
    std::string onOff(std::string_view key) const { return boolean(key) ? "on" : "off"; }
    CommandWords vector(std::string_view key) const {
        constexpr std::size_t kThree = 3;
        if (!isArray(key) || value(key).size() != kThree)
            throw Refused(fmt::format("'{}' is three numbers", key));
        CommandWords words;
        for (const nlohmann::json& each : value(key))
            words.push_back(rtcore::shortestText(numberOf(each, key)));
        return words;
    }

    static double numberOf(const nlohmann::json& value, std::string_view key) {
        if (!value.is_number()) throw Refused(fmt::format("'{}' is a number", key));
        const auto number = value.get<double>();
        if (!std::isfinite(number) || std::abs(number) > app::kMostNumber)
            throw Refused(fmt::format("'{}' is out of range", key));
        return number;
    }
    static std::int64_t integerOf(const nlohmann::json& value, std::string_view key) {
        const double number = numberOf(value, key);
        if (number != std::floor(number) || std::abs(number) > app::kMostWhole)
            throw Refused(fmt::format("'{}' is a whole number", key));
        return static_cast<std::int64_t>(number);
    }

  private:
    const nlohmann::json& request_;
};

inline CommandWords operator+(CommandWords first, const CommandWords& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

} // namespace bridge
