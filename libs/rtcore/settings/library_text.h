/// Texts of libraries about files, in sentences of ours, which can be translated.
#pragma once

#include "rtcore/platform/sentence.h"

#include <span>
#include <string_view>

namespace rtcore {

/// Texts of one kind, as a form with places - "expected '{0}', saw '{1}'" -, and what they mean to people: a
/// form with some of these places.
struct LibraryText {
    const char *theirs, *meaning;
};

/// The meaning of `text` by the first of `known` that it may have been made of. Of others the text itself, in
/// quotes: only that stays as it is in another language.
Sentence meaningOf(std::string_view text, std::span<const LibraryText> known);

} // namespace rtcore
