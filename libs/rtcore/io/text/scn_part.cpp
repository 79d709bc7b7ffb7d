#include "rtcore/io/text/scn_sections.h"

namespace rtcore {

PartDescription readPart(StrictTable& table) {
    const NameOrNumber which = readNameOrNumber(table, "a part");
    const auto hidden = table.boolean("hidden");
    table.finish();
    which.check(table);
    return {which.name.value_or(""), which.number, table.require("hidden", hidden)};
}

void writePart(TomlWriter& writer, const PartDescription& part) {
    writer.section("[[part]]");
    part.number ? writer.add("number", *part.number) : writer.add("name", part.pattern);
    writer.add("hidden", part.hidden);
}

} // namespace rtcore
