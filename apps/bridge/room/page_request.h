/// A text message of a page, read.
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string_view>

namespace bridge {

struct PageRequest {
    nlohmann::json content;      ///< an object
    std::uint32_t id = 0;        ///< of the request, for its answer
    const char* wrong = nullptr; ///< why it is none, for the close; null: it is one
};

PageRequest readPageRequest(std::string_view message);

} // namespace bridge
