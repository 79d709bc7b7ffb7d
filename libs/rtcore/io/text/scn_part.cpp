#include "rtcore/io/text/scn_sections.h"

namespace rtcore {

PartDescription readPart(StrictTable& table) {
    const NameOrNumber which = readNameOrNumber(table, "a part");
    const auto hidden = table.boolean("hidden"), uncut = table.boolean("uncut");
    table.finish();
    which.check(table);
    if (!uncut) table.require("hidden", hidden);
    return {which.name.value_or(""), which.number, hidden, uncut};
}

void writePart(TomlWriter& writer, const PartDescription& part, std::string_view header) {
    writer.section(header);
    part.number ? writer.add("number", *part.number) : writer.add("name", part.pattern);
    if (part.hidden) writer.add("hidden", *part.hidden);
    if (part.uncut) writer.add("uncut", *part.uncut);
}

} // namespace rtcore
