/// The words in names of materials and parts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

/// Its runs of letters in lower case, Latin letters without their marks: "Fenêtre_Étage2" has "fenetre" and
/// "etage". A capital after a small letter begins a word. Names are UTF-8; other letters end a word. At least
/// one word, which may be empty.
std::vector<std::string> nameWords(std::string_view name);

} // namespace rtcore
