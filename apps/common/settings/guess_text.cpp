#include "common/settings/guess_text.h"

namespace app {

std::string guessText(const rtcore::ModelUnits& units) {
    if (units.upSaid != rtcore::Said::Guessed && units.unitSaid != rtcore::Said::Guessed) return {};
    return rtcore::describe(units) + "; --up and --units, or 'up' and 'metresPerUnit' in a .scn, say it";
}

} // namespace app
