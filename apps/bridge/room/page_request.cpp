#include "bridge/room/page_request.h"

#include <utility>

namespace bridge {

PageRequest readPageRequest(std::string_view message) {
    using nlohmann::json;
    constexpr int kDepth = 16;
    int depth = 0;
    const auto shallow = [&](int, json::parse_event_t event, json&) {
        if (event == json::parse_event_t::object_start || event == json::parse_event_t::array_start) ++depth;
        if (event == json::parse_event_t::object_end || event == json::parse_event_t::array_end) --depth;
        return depth <= kDepth;
    };
    PageRequest request;
    request.content = json::parse(message, shallow, false);
    if (!request.content.is_object()) {
        request.wrong = "a text message is a JSON object";
        return request;
    }
    const auto number = request.content.find("id");
    constexpr double kMax = 4294967295.0;
    if (number == request.content.end() || !number->is_number_integer() || number->get<double>() < 0 ||
        number->get<double>() > kMax) {
        request.wrong = "a request has an id from 0 to 4294967295";
        return request;
    }
    request.id = number->get<std::uint32_t>();
    return request;
}

} // namespace bridge
