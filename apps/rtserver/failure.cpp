#include "rtserver/failure.h"

#include "common/cli/command_line.h"
#include "common/process/error_sentence.h"
#include "common/process/exit_codes.h"
#include "common/process/ipc_exit_code.h"

#include "ipc/platform/error.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/settings/plain_text.h"

#include <new>
#include <stdexcept>

namespace rtserver {

namespace {

app::ExitCode exitCodeOf(const std::exception& error) {
    if (const auto* file = dynamic_cast<const rtcore::FileError*>(&error)) return app::exitCodeOf(file->kind);
    if (dynamic_cast<const std::invalid_argument*>(&error) != nullptr) return app::ExitCode::Usage;
    if (dynamic_cast<const app::UsageError*>(&error) != nullptr) return app::ExitCode::Usage;
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return app::ExitCode::TryAgain;
    if (const auto* link = dynamic_cast<const ipc::Error*>(&error)) return app::exitCodeOf(link->problem);
    return app::ExitCode::Failed;
}

} // namespace

Failure::Failure(int exitCode, const rtcore::Sentence& sentence)
    : code(exitCode), why(sentence), text(rtcore::printable(sentence.english())) {}

Failure failureOf(const std::exception& error) {
    const bool memory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
    return {static_cast<int>(exitCodeOf(error)),
            memory ? rtcore::say("not enough memory") : app::sentenceOf(error)};
}

} // namespace rtserver
