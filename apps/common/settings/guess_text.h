/// What a program says of what it guesses of a model.
#pragma once

#include "rtcore/survey/up_and_unit.h"

#include <string>

namespace app {

/// Which way is up and how long a unit is, as far as that is guessed, and what says it; empty where nothing
/// is.
std::string guessText(const rtcore::UpAndUnit& frame);

} // namespace app
