#include "common/commands/step_label.h"

#include "common/cli/command_line.h"
#include "common/commands/command_lookup.h"
#include "common/commands/quoting.h"

#include <vector>

namespace app {

StepLabel stepLabel(const std::string& step) {
    try {
        const std::vector<std::string> words = splitWords(step);
        const FoundCommand found = findCommand(words);
        const std::string of = found.words < words.size() ? words[found.words] : std::string();
        return {found.command->step, of.substr(of.rfind('/') + 1),
                found.command->id == CommandId::Set && !of.empty()};
    } catch (const UsageError&) { // of a newer server
        return {};
    }
}

} // namespace app
