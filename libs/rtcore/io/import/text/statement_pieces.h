/// A file of text in pieces of whole statements.
#pragma once

#include "rtcore/platform/files.h"

#include <cstdint>
#include <functional>
#include <string_view>

namespace rtcore {

/// Calls `use` with pieces of the file from the byte `from` on, in their order, that begin and end as
/// StatementText needs it, and with the offset of the bytes that come next. A mark of the byte order at the
/// beginning is left out. Bytes are copied out of the file, so that one that shrinks meanwhile ends early. A
/// statement may be as long as the file. `alive` is called now and then. Throws what InputFile throws, and
/// std::bad_alloc.
using UseStatements = std::function<void(std::string_view text, std::uint64_t next)>;
void forEachStatements(const InputFile& file, const std::function<void()>& alive, const UseStatements& use,
                       std::uint64_t from = 0);

} // namespace rtcore
