/// How the texels of an image are looked up between their centres.
#pragma once

namespace rtcore {

enum class TexelFilter { Bilinear, Nearest };

} // namespace rtcore
