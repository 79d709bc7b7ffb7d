#include "ipc/platform/error.h"

#include <fmt/args.h>
#include <fmt/core.h>

#include <utility>

namespace ipc {

namespace {

std::string filled(const char* form, const std::vector<std::string>& arguments) {
    fmt::dynamic_format_arg_store<fmt::format_context> store;
    for (const std::string& each : arguments) store.push_back(each);
    return fmt::vformat(form, store);
}

} // namespace

Error::Error(Problem kind, const char* text, std::vector<std::string> places)
    : std::runtime_error(filled(text, places)), problem(kind), form(text), arguments(std::move(places)) {}

} // namespace ipc
