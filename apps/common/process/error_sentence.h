/// Errors as sentences that clients can show in another language.
#pragma once

#include "ipc/platform/error.h"

#include "rtcore/platform/sentence.h"

#include <exception>
#include <string>
#include <vector>

namespace app {

/// rtcore::sentenceOf(), which also knows the errors of shared memory.
inline rtcore::Sentence sentenceOf(const std::exception& error) {
    const auto* const link = dynamic_cast<const ipc::Error*>(&error);
    if (link == nullptr) return rtcore::sentenceOf(error);
    std::vector<rtcore::Sentence> arguments;
    for (const std::string& each : link->arguments) arguments.emplace_back(each);
    return {link->form, std::move(arguments)};
}

} // namespace app
