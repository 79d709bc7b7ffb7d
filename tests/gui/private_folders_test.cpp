/// Files that the window keeps for its user are closed to other users of the machine.
#include "gui/window_support.h"

#include "gui/models/bookmark_store.h"
#include "gui/processes/model_cache.h"

#include <QDir>
#include <QDirIterator>
#include <QSignalSpy>

#include <sys/stat.h>

namespace {

using namespace test;
using namespace gui;

unsigned modeOf(const QString& path) {
    struct stat facts {};
    EXPECT_EQ(::stat(path.toUtf8().constData(), &facts), 0) << path.toStdString();
    return facts.st_mode & 0777U;
}

class PrivateFolders : public WindowFixture {
  protected:
    PrivateFolders() : before_(::umask(022)) {}
    ~PrivateFolders() override { ::umask(before_); }

    static QString rtsuite(const char* variable) {
        return qEnvironmentVariable(variable) + QStringLiteral("/rtsuite");
    }

  private:
    mode_t before_;
};

TEST_F(PrivateFolders, HoldLogsModelsBookmarksAndSettings) {
    for (const char* each : {"XDG_CACHE_HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME"}) {
        QDir(rtsuite(each)).removeRecursively();
        ASSERT_TRUE(QDir().mkpath(rtsuite(each))); // as earlier versions made it
        EXPECT_EQ(modeOf(rtsuite(each)), 0755U);
    }
    window.reset();
    window.emplace(name()); // which finds them so
    ASSERT_NO_FATAL_FAILURE(open());
    ModelCache models;
    models.setLimit(100);
    QSignalSpy kept(&models, &ModelCache::kept);
    models.keep(file("room.obj"));
    BookmarkStore store;
    store.setScene(file("room.obj"));
    EXPECT_EQ(store.add(QStringLiteral("door"), "fov = 60\n", QImage(4, 4, QImage::Format_RGB32)), QString());
    window->preferences().addRecentFile(file("room.obj"));
    window.reset();
    ASSERT_TRUE(comes([&] { return !kept.isEmpty(); }));
    EXPECT_EQ(modeOf(rtsuite("XDG_CACHE_HOME")), 0700U);
    EXPECT_EQ(modeOf(rtsuite("XDG_DATA_HOME") + QStringLiteral("/bookmarks")), 0700U);
    EXPECT_EQ(modeOf(rtsuite("XDG_CONFIG_HOME")), 0700U);
    QStringList files;
    for (const char* each : {"XDG_CACHE_HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME"}) {
        QDirIterator all(rtsuite(each), QDir::Files, QDirIterator::Subdirectories);
        while (all.hasNext()) files.append(all.next());
    }
    for (const QString& path : files) EXPECT_EQ(modeOf(path), 0600U) << path.toStdString();
    for (const char* ending : {".log", ".bsp", ".cam", ".png", ".ini"})
        EXPECT_FALSE(files.filter(QLatin1String(ending)).isEmpty()) << ending;
}

} // namespace
