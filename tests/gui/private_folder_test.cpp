/// The folder in which the window hands files to other programs is this user's alone, and is removed even
/// after a window that was killed.
#include "gui/processes/private_folder.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFileInfo>

#include <filesystem>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace {

/// The number of a process that has ended.
int deadProcess() {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    ::waitpid(child, nullptr, 0);
    return child;
}

TEST(PrivateFolder, IsOfThisUserAndTakesAwayWhatTheDeadLeft) {
    const test::TemporaryFolder session;
    const QByteArray before = qgetenv("XDG_RUNTIME_DIR");
    qputenv("XDG_RUNTIME_DIR", session.path().c_str());
    const std::string left = "rtsuite-view-" + std::to_string(deadProcess()) + "-abcdef";
    std::filesystem::create_directory(session / left);
    const std::string alive = "rtsuite-view-" + std::to_string(::getpid()) + "-abcdef";
    std::filesystem::create_directory(session / alive);
    QString file;
    {
        const gui::PrivateFolder folder("view");
        EXPECT_EQ(folder.trouble(), QString());
        file = folder.file(QStringLiteral("a.scn"));
        const QFileInfo place(QFileInfo(file).absolutePath());
        EXPECT_TRUE(place.isDir());
        EXPECT_EQ(std::filesystem::status(place.filePath().toStdString()).permissions(),
                  std::filesystem::perms::owner_all);
    }
    EXPECT_FALSE(QFileInfo(file).dir().exists());
    EXPECT_FALSE(std::filesystem::exists(session / left));
    EXPECT_TRUE(std::filesystem::exists(session / alive)) << "another window's";
    qputenv("XDG_RUNTIME_DIR", "/nowhere");
    const gui::PrivateFolder none("view");
    EXPECT_FALSE(none.trouble().isEmpty());
    EXPECT_EQ(none.file(QStringLiteral("a")), QString());
    before.isEmpty() ? qunsetenv("XDG_RUNTIME_DIR") : qputenv("XDG_RUNTIME_DIR", before);
}

} // namespace
