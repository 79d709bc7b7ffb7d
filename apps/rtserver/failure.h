/// How a failure is told to clients.
#pragma once

#include <exception>
#include <string>

namespace rtserver {

struct Failure {
    int code; ///< the exit code that suits it
    std::string text;
};
Failure failureOf(const std::exception& error);

} // namespace rtserver
