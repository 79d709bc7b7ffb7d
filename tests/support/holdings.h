/// The resources of the system that a process holds, to see that they do not grow.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <system_error>

#include <sys/types.h>

namespace test {

struct Holdings {
    std::size_t privateBytes = 0; ///< resident, of its own
    std::size_t sharedBytes = 0;  ///< resident, of shared memory
    std::size_t descriptors = 0, threads = 0, children = 0;
    std::size_t names = 0; ///< in shared memory, where the caller counts them
};

inline Holdings holdingsOf(pid_t process) {
    const std::string folder = "/proc/" + std::to_string(process);
    Holdings result;
    std::ifstream status(folder + "/status");
    for (std::string line; std::getline(status, line);) {
        std::istringstream words(line);
        std::string name;
        std::size_t value = 0;
        words >> name >> value;
        if (name == "RssAnon:") result.privateBytes = value * 1024;
        if (name == "RssShmem:") result.sharedBytes = value * 1024;
        if (name == "Threads:") result.threads = value;
    }
    std::error_code none; // it may end meanwhile
    const std::filesystem::directory_iterator descriptors(folder + "/fd", none);
    result.descriptors = static_cast<std::size_t>(std::distance(descriptors, {}));
    for (const auto& task : std::filesystem::directory_iterator(folder + "/task", none)) {
        std::ifstream children(task.path() / "children");
        for (std::string child; children >> child;) ++result.children;
    }
    return result;
}

} // namespace test
