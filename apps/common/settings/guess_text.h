/// A program's guesses about a model, as text.
#pragma once

#include "rtcore/survey/model_units.h"

#include <string>

namespace app {

/// Which way is up and how long a unit is, as far as that is guessed, and what says it; empty where nothing
/// is.
rtcore::Sentence guessText(const rtcore::ModelUnits& units);

} // namespace app
