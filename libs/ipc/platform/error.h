/// Errors between the processes. Thrown by constructors and by functions that say so; `what()` tells what
/// to do.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace ipc {

enum class Problem {
    BadName,        ///< an instance is 1 to 32 letters, digits, '_' or '-'
    AlreadyRunning, ///< another server has this instance
    NoServer,       ///< no server answers to this instance
    NoSlot,         ///< all slots for commanding clients are taken
    WrongVersion,   ///< the two programs are of different versions
    NotYours,       ///< a name is taken by another user, or open to others
    NoSpace,        ///< shared memory is full
    TooLarge,       ///< a command or a frame is beyond the limits
    System,         ///< the operating system refused something else
};

class Error : public std::runtime_error {
  public:
    /// `form` is English, a literal, and the key by which programs find its translation; {0}, {1}, ... in it
    /// stand for `arguments`, which are the same in every language.
    Error(Problem kind, const char* form, std::vector<std::string> arguments = {});
    Problem problem;
    const char* form;
    std::vector<std::string> arguments;
};

} // namespace ipc
