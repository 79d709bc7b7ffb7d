/// Exit codes of the importer program, from which importModel makes errors.
#pragma once

namespace rtcore {

enum class ImporterExit {
    Done = 0,
    Usage = 2,
    BadData = 65,     ///< why is on its standard error and in a refusalLine(), without the name of the file
    CannotWrite = 73, ///< likewise, with the name
    NoMemory = 71,
};

} // namespace rtcore
