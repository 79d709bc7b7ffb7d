/// The world failed: a file is missing, broken or cannot be written, or a value in it makes no sense.
/// Thrown where it is found, caught once at the border of the program, which prints it and exits.
#pragma once

#include "rtcore/platform/sentence.h"

#include <stdexcept>
#include <string>

namespace rtcore {

enum class FailureKind {
    BadData,     ///< the content is wrong (exit code 65)
    NoInput,     ///< the file is missing or cannot be read (66)
    CannotWrite, ///< the output cannot be written (73)
    TryAgain,    ///< a resource is short for the moment (75)
    Stopped,     ///< the user stopped it (130, 143)
};

/// `what()` reads "file:line:column: what is wrong; what to do", with the parts that are known.
class FileError : public std::runtime_error, public Worded {
  public:
    FileError(FailureKind failure, const std::string& file, const Sentence& message, int line = 0,
              int column = 0);

    FailureKind kind;

  private:
    FileError(FailureKind failure, const Sentence& whole);
};

/// The system's text for one of its error numbers.
Sentence systemReason(int error);

} // namespace rtcore
