#include "rtcore/io/text/camera_section.h"
#include "rtcore/io/text/scn_sections.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/settings/plain_text.h"

#include <algorithm>

namespace rtcore {

SceneBookmarks readBookmarks(StrictTable& root, Vec3 up) {
    SceneBookmarks bookmarks;
    for (StrictTable& table : root.tables("bookmark")) {
        root.needVersion(2, "bookmark");
        const auto name = table.text("name");
        SceneBookmark bookmark;
        bookmark.camera = readCamera(table, up, true);
        bookmark.name = table.require("name", name);
        if (bookmark.name.empty()) table.fail("name", say("name is empty; a bookmark is known by its name"));
        if (findBookmark(bookmarks, bookmark.name) != bookmarks.end())
            table.fail("name", say("another bookmark is called {0}, too", inQuotes(bookmark.name)));
        bookmarks.push_back(std::move(bookmark));
    }
    return bookmarks;
}

void writeBookmark(TomlWriter& writer, const SceneBookmark& bookmark) {
    writer.section("[[bookmark]]");
    writer.add("name", bookmark.name);
    writeCamera(writer, bookmark.camera);
}

SceneBookmarks::const_iterator findBookmark(const SceneBookmarks& bookmarks, std::string_view name) {
    return std::find_if(bookmarks.begin(), bookmarks.end(),
                        [&](const SceneBookmark& each) { return each.name == name; });
}

} // namespace rtcore
