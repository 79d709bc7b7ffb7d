/// Texts for the options of the programs in the window. An option that is added to a program gets its texts
/// by itself, in English until translations/tables_cs.ts has them.
#pragma once

#include "common/cli/options.h"

#include <QString>
#include <QStringList>

namespace gui {

/// The label of an option in a form: "Crease angle" for "crease-angle".
QString optionLabel(const app::Option& option);
QString optionGroupTitle(const app::OptionGroup& group);
/// Its help, as a sentence for a tooltip, in rich text.
QString optionTip(const app::Option& option);
/// The tooltip of an option that has a field of its own; empty when the table has no such option.
QString optionTip(const app::ProgramSpec& spec, const char* name);
/// "40" where the help ends with "[40]".
QString optionDefault(const app::Option& option);

/// All that is translated of a program's table, in English; the context is "ProgramOptions".
QStringList optionTexts(const app::ProgramSpec& spec);

} // namespace gui
