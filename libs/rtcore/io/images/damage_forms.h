/// Faults of damaged images, whichever reader or library finds them.
#pragma once

#include "rtcore/platform/sentence.h"

namespace rtcore::damage {

inline constexpr const char *kEndsEarly =
                                form("the file ends too early: it is damaged or was not copied completely"),
                            *kHeader = form("its head makes no sense"),
                            *kPixels = form("its pixels cannot be decoded"),
                            *kChecksum = form("the checksum of its part {0} is wrong"),
                            *kUnread = form("it is of a kind that is not read; convert it to PNG");

} // namespace rtcore::damage
