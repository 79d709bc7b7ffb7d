/// The files of the page, built into the program.
#pragma once

#include <span>
#include <string_view>

namespace bridge {

struct PageBody {
    std::string_view bytes;
    std::string_view tag; ///< entity tag, with its quotes
};

struct PageFile {
    std::string_view path;  ///< "/picture.js"
    PageBody plain, packed; ///< packed: by gzip
};

/// The first one is what `/` shows. Valid for the whole run of the program; safe from many threads.
std::span<const PageFile> pageFiles();

} // namespace bridge
