/// Statements of MTL that name an image: "map_Kd -s 2 2 -clamp on wood.png".
#pragma once

#include "rtcore/io/import/obj/mtl_file.h"

#include <string>
#include <string_view>

namespace rtcore {

struct MapStatement {
    std::string name; ///< of the image; "" where there is none
    MtlLayout layout;
    float bump = 1; ///< -bm
    bool clamped = false;
};

/// `words` are those behind the keyword. Options may also stand behind the name, and the name in quotes. What
/// begins with "-" and is no option is a name.
MapStatement mapStatementOf(std::string_view words);

} // namespace rtcore
