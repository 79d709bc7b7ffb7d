#include "common/cli/run_program.h"

#include "common/cli/completion.h"
#include "common/cli/help_text.h"
#include "common/cli/man_page.h"
#include "common/process/message.h"
#include "common/process/stop.h"
#include "common/process/terminal.h"

#include "rtcore/platform/error.h"
#include "rtcore/simd/instruction_set.h"

#include <exception>
#include <new>
#include <stdexcept>

namespace app {

namespace {

ExitCode parseAndRun(const ProgramSpec& spec, const std::vector<std::string>& words,
                     const std::function<ExitCode(const Arguments&)>& work) {
    if (words.empty() && (spec.positionals.empty() || spec.requiredPositionals() > 0)) {
        writeError(briefText(spec));
        return ExitCode::Usage;
    }
    try {
        rtcore::useInstructionSetOfEnvironment();
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
    const Arguments arguments = parseCommandLine(spec, words);
    if (arguments.has("help")) {
        writeOutput(helpText(spec));
    } else if (arguments.has("version")) {
        writeOutput(versionText(spec));
    } else {
        return work(arguments);
    }
    return ExitCode::Done;
}

// Questions of shells and of the build, which are no options for people.
bool answerForPackaging(const ProgramSpec& spec, std::span<const std::string> words) {
    if (words.empty()) return false;
    if (words.front() == kCompleteOption) {
        writeOutput(completionText(completeWords(spec, words.subspan(1))));
    } else if (words.front() == kManPageOption && words.size() == 1) {
        writeOutput(manPage(spec));
    } else {
        return false;
    }
    return true;
}

} // namespace

int runProgram(int argc, const char* const* argv, const ProgramSpec& spec,
               const std::function<ExitCode(const Arguments&)>& work) {
    ExitCode code = ExitCode::Failed;
    try {
        installSignalHandlers();
        const std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
        if (answerForPackaging(spec, words)) return static_cast<int>(ExitCode::Done);
        code = parseAndRun(withStandardOptions(spec), words, work);
    } catch (const UsageError& error) {
        printSentence(spec.name, error.sentence());
        writeError("Try '" + spec.name + " --help'.\n");
        code = ExitCode::Usage;
    } catch (const rtcore::FileError& error) {
        printSentence(spec.name, error.sentence());
        code = exitCodeOf(error.kind);
    } catch (const std::bad_alloc&) {
        printForm(spec.name, rtcore::form("not enough memory; make the image or the model smaller, or use a "
                                          "machine with more"));
    } catch (const std::length_error& error) {
        printSentence(spec.name, rtcore::say("the input is too large: {0}", std::string(error.what())));
    } catch (const std::exception& error) {
        printSentence(spec.name, rtcore::sentenceOf(error));
    } catch (...) {
        printForm(spec.name, rtcore::form("unknown error"));
    }
    return static_cast<int>(code);
}

} // namespace app
