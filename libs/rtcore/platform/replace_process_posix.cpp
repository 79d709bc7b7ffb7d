#include "rtcore/platform/replace_process.h"

#include <unistd.h>

namespace rtcore {

void becomeProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
    std::string name = program.string();
    std::vector<std::string> words = arguments;
    std::vector<char*> pointers{name.data()};
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    ::execv(name.c_str(), pointers.data());
}

} // namespace rtcore
