/// The camera that a scene is first seen by, and what is up in it.
#pragma once

#include "rtcore/io/loading/loading.h"

namespace rtcore {

/// The options win over a .scn, that over the model's file, that over a guess.
void decideModelUnits(Loading& loading);

/// One of the model's own that shows it, or else one that does; the others become bookmarks.
void chooseCamera(Loading& loading);

} // namespace rtcore
