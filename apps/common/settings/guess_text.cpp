#include "common/settings/guess_text.h"

namespace app {

std::string guessText(const rtcore::UpAndUnit& frame) {
    if (frame.upSaid != rtcore::Said::Guessed && frame.unitSaid != rtcore::Said::Guessed) return {};
    return rtcore::describe(frame) + "; --up and --units, or 'up' and 'metresPerUnit' in a .scn, say it";
}

} // namespace app
