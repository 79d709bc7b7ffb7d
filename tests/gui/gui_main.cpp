// A QApplication for the tests, with preferences and logs of its own.
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <QApplication>

int main(int argc, char** argv) {
    const test::TemporaryFolder folder;
    qputenv("XDG_CONFIG_HOME", (folder / "config").c_str());
    qputenv("XDG_DATA_HOME", (folder / "data").c_str());
    qputenv("XDG_CACHE_HOME", (folder / "cache").c_str());
    qputenv("RT_KEEP_PRIORITY", "1");
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
    testing::InitGoogleTest(&argc, argv);
    const QApplication application(argc, argv);
    return RUN_ALL_TESTS();
}
