#include "common/settings/guess_text.h"

namespace app {

rtcore::Sentence guessText(const rtcore::ModelUnits& units) {
    if (units.upSaid != rtcore::Said::Guessed && units.unitSaid != rtcore::Said::Guessed) return {};
    return rtcore::say("{0}; --up and --units, or 'up' and 'metresPerUnit' in a .scn, say it",
                       rtcore::describe(units));
}

} // namespace app
