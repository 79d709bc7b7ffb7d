#include "common/process/message.h"

#include "common/process/terminal.h"

#include "rtcore/io/text/sentence_json.h"
#include "rtcore/settings/plain_text.h"

#include <cstdlib>
#include <new>
#include <string>

namespace app {

namespace {

std::string messageLine(std::string_view program, std::string_view text) {
    return std::string(program).append(": ").append(rtcore::printable(text)).append("\n");
}

bool wantsSentences() {
    // The environment does not change while a program runs.
    static const char* const wanted = std::getenv("RT_SENTENCES"); // NOLINT(concurrency-mt-unsafe)
    return wanted != nullptr && std::string_view(wanted) == "1";
}

/// Writes what `make` gives.
template <typename Make>
void writeMade(Make make) noexcept {
    try {
        writeError(make());
    } catch (const std::bad_alloc&) {
        writeError("not enough memory\n");
    }
}

} // namespace

void printMessage(std::string_view program, std::string_view text) noexcept {
    writeMade([&] { return messageLine(program, text); });
}

void printSentence(std::string_view program, const rtcore::Sentence& said) noexcept {
    writeMade([&] {
        const std::string record =
            wantsSentences() && said.isForm() ? "\x1E" + rtcore::sentenceJson(said) + "\n" : "";
        return record + messageLine(program, said.english());
    });
}

void printForm(std::string_view program, const char* form) noexcept {
    try {
        printSentence(program, form);
    } catch (const std::bad_alloc&) {
        printMessage(program, form);
    }
}

} // namespace app
