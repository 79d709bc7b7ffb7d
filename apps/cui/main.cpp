/// CUI: commands a server from a shell.
#include "cui/argument_order.h"
#include "cui/cui_run.h"
#include "cui/cui_spec.h"

#include "common/cli/run_program.h"

#include <vector>

int main(int argc, char** argv) {
    const std::vector<std::string> ordered =
        cui::optionsFirst(cui::cuiSpec(), std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc));
    std::vector<const char*> words{cui::cuiSpec().name.c_str()};
    for (const std::string& word : ordered) words.push_back(word.c_str());
    return app::runProgram(static_cast<int>(words.size()), words.data(), cui::cuiSpec(), cui::runCui);
}
