#include "rtcore/io/import/gltf/json_members.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtcore::gltf {

namespace {

const Json kNothing;

template <typename Number>
std::optional<Number> numberOf(const Json& value) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    if (!value.is_number()) return std::nullopt;
    const auto read = value.get<double>();
    if (std::isnan(read)) return std::nullopt;
    return static_cast<Number>(std::clamp(read, -kLargest, kLargest));
}

} // namespace

const Json& member(const Json& object, const char* name) {
    if (!object.is_object()) return kNothing;
    const auto at = object.find(name);
    return at != object.end() ? *at : kNothing;
}

const Json& element(const Json& list, std::optional<std::size_t> index) {
    return index && *index < sizeOf(list) ? list[*index] : kNothing;
}

const Json& extension(const Json& object, const char* name) {
    return member(member(object, "extensions"), name);
}

std::optional<std::uint64_t> wholeNumber(const Json& value) {
    constexpr double kMax = 9007199254740992.0;
    if (!value.is_number()) return std::nullopt;
    const auto read = value.get<double>();
    if (!(read >= 0) || read > kMax || read != std::floor(read)) return std::nullopt;
    return static_cast<std::uint64_t>(read);
}

std::optional<std::size_t> index(const Json& object, const char* name) {
    return wholeNumber(member(object, name));
}

std::uint64_t wholeNumber(const Json& object, const char* name, std::uint64_t otherwise) {
    return wholeNumber(member(object, name)).value_or(otherwise);
}

float number(const Json& object, const char* name, float otherwise) {
    return numberOf<float>(member(object, name)).value_or(otherwise);
}

bool flag(const Json& object, const char* name, bool otherwise) {
    const Json& value = member(object, name);
    return value.is_boolean() ? value.get<bool>() : otherwise;
}

std::string text(const Json& object, const char* name) {
    const Json& value = member(object, name);
    return value.is_string() ? value.get<std::string>() : std::string();
}

template <std::size_t N, typename Number>
std::optional<std::array<Number, N>> numbers(const Json& object, const char* name) {
    const Json& list = member(object, name);
    if (sizeOf(list) != N) return std::nullopt;
    std::array<Number, N> read{};
    for (std::size_t i = 0; i < N; ++i) {
        const auto value = numberOf<Number>(list[i]);
        if (!value) return std::nullopt;
        read[i] = *value;
    }
    return read;
}

template std::optional<std::array<float, 2>> numbers<2>(const Json&, const char*);
template std::optional<std::array<float, 3>> numbers<3>(const Json&, const char*);
template std::optional<std::array<float, 4>> numbers<4>(const Json&, const char*);
template std::optional<std::array<float, 16>> numbers<16>(const Json&, const char*);
template std::optional<std::array<double, 3>> numbers<3, double>(const Json&, const char*);
template std::optional<std::array<double, 4>> numbers<4, double>(const Json&, const char*);
template std::optional<std::array<double, 16>> numbers<16, double>(const Json&, const char*);

} // namespace rtcore::gltf
