/// Edits of the variants of a document.
#pragma once

#include "rtserver/document/document.h"

#include <string>

namespace rtserver {

// Names are those of variants() unless said otherwise. They throw rtcore::Refusal where there is no such
// variant, rtcore::BadValue for a name that none can have; nothing is changed then.

const rtcore::SceneVariant& variantNamed(const Document& document, const std::string& name);

/// Keeps all in which what is shown differs from the base under that name, in place of a variant that has
/// it, and makes it the active one. Throws rtcore::Refusal where nothing differs.
void addVariant(Document& document, const std::string& name);
/// What it names is kept as it is shown.
void updateVariant(Document& document, const std::string& name);
void renameVariant(Document& document, const std::string& name, const std::string& to);
/// What is shown stays.
void removeVariant(Document& document, const std::string& name);
/// What is shown is what variants are of from now on; none is active.
void rebaseVariants(Document& document);

/// Shows it in place of the active one.
void goToVariant(Document& document, const std::string& name);
/// The base in place of the active one.
void leaveVariant(Document& document);

} // namespace rtserver
