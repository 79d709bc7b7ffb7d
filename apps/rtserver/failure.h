/// How a failure is told to clients.
#pragma once

#include "rtcore/platform/sentence.h"

#include <exception>
#include <string>

namespace rtserver {

struct Failure {
    Failure(int exitCode, const rtcore::Sentence& sentence);

    int code; ///< the exit code that suits it
    rtcore::Sentence why;
    std::string text; ///< the same in English, printable
};
Failure failureOf(const std::exception& error);

} // namespace rtserver
