# Writes the page's files as byte tables: cmake -D FOLDER=... -D FILES="a;b" -D MADE_FOLDER=... -D MADE_FILES="c"
# -D OUTPUT=... -P embed.cmake
set(tables)
set(rows)
set(number 0)
macro(embed folder name)
    file(READ ${folder}/${name} bytes HEX)
    string(REGEX REPLACE "(................................................................)" "\\1\n" bytes "${bytes}")
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
    string(APPEND tables "constexpr unsigned char kFile${number}[] = {\n${bytes}0};\n")
    string(APPEND rows "    {\"/${name}\", textOf(kFile${number}, sizeof kFile${number} - 1)},\n")
    math(EXPR number "${number} + 1")
endmacro()
foreach(name ${FILES})
    embed(${FOLDER} ${name})
endforeach()
foreach(name ${MADE_FILES})
    embed(${MADE_FOLDER} ${name})
endforeach()
file(WRITE ${OUTPUT} "// Made by apps/bridge/embed.cmake.
#include \"bridge/net/page_files.h\"

namespace bridge {

namespace {

${tables}
std::string_view textOf(const unsigned char* bytes, std::size_t size) {
    return {reinterpret_cast<const char*>(bytes), size};
}

} // namespace

std::span<const PageFile> pageFiles() {
    static const PageFile files[] = {
${rows}    };
    return files;
}

} // namespace bridge
")
