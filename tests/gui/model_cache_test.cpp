/// The model cache: quicker, and otherwise without effect.
#include "gui/gui_support.h"

#include "gui/main_window.h"
#include "gui/processes/model_cache.h"

#include <QDir>
#include <QFileInfo>
#include <QSignalSpy>

namespace {

using namespace test;
using namespace gui;

class ModelCacheTest : public GuiTest {
  protected:
    void SetUp() override {
        GuiTest::SetUp();
        QDir(cache()).removeRecursively();
        models.setLimit(100);
    }
    static QString cache() {
        return qEnvironmentVariable("XDG_CACHE_HOME") + QStringLiteral("/rtsuite/models");
    }
    static QStringList files() { return QDir(cache()).entryList(QDir::Files); }
    void keep(const QString& scene) {
        QSignalSpy kept(&models, &ModelCache::kept);
        models.keep(scene);
        ASSERT_TRUE(comes([&] { return !kept.isEmpty(); }));
    }
    /// The first live frame, and what the server says of its scene.
    std::pair<std::string, std::string> shown(const QString& scene, const std::vector<std::string>& options) {
        std::vector<std::string> words{scene.toStdString(), "--instance=" + instance.name(),
                                       "--resolution=120x90"};
        words.insert(words.end(), options.begin(), options.end());
        RunningProgram program(programPath("RTServer"), words, {.folder = folder().path()});
        EXPECT_TRUE(program.waitForError("ready: "));
        Session session;
        session.connectTo(name());
        EXPECT_TRUE(shows(session));
        EXPECT_TRUE(ask(session, QStringLiteral("wait-idle")).done);
        EXPECT_TRUE(ask(session, command::screenshot(file("shown.png").toStdString())).done);
        EXPECT_TRUE(ask(session, command::exportScene(file("shown.scn").toStdString())).done);
        program.send(SIGTERM);
        EXPECT_EQ(program.wait().exitCode, 143);
        return {readBytes(folder() / "shown.png"), readBytes(folder() / "shown.scn")};
    }
    ModelCache models;
};

TEST_F(ModelCacheTest, ThePictureAndTheScenesDescriptionStayTheSameToTheBit) {
    writeText(folder() / "own.scn", "version = 1\nmodel = \"room.obj\"\ncreaseAngle = 10\n");
    for (const char* const scene : {"room.obj", "own.scn"}) {
        EXPECT_TRUE(models.find(file(scene)).isEmpty());
        ASSERT_NO_FATAL_FAILURE(keep(file(scene)));
        const QString bsp = models.find(file(scene));
        ASSERT_FALSE(bsp.isEmpty());
        const auto plain = shown(file(scene), {});
        const auto quick = shown(file(scene), {"--cached-model=" + bsp.toStdString()});
        EXPECT_TRUE(plain.first == quick.first) << scene;
        EXPECT_EQ(plain.second, quick.second) << "the model keeps its name";
        EXPECT_NE(plain.second.find("room.obj"), std::string::npos) << plain.second;
    }
    EXPECT_EQ(files().size(), 2) << "another crease angle makes another model";
}

TEST_F(ModelCacheTest, AnotherPoseMakesAnotherModel) {
    writeText(folder() / "rest.scn", "version = 2\nmodel = \"room.obj\"\n");
    writeText(folder() / "first.scn", "version = 2\nmodel = \"room.obj\"\npose = \"first\"\n");
    ASSERT_NO_FATAL_FAILURE(keep(file("rest.scn")));
    EXPECT_FALSE(models.find(file("room.obj")).isEmpty());
    EXPECT_TRUE(models.find(file("first.scn")).isEmpty());
    ASSERT_NO_FATAL_FAILURE(keep(file("first.scn")));
    EXPECT_NE(models.find(file("first.scn")), models.find(file("rest.scn")));
}

TEST_F(ModelCacheTest, AnotherDeflectionMakesAnotherModel) {
    writeText(folder() / "usual.scn", "version = 2\nmodel = \"room.obj\"\ndeflection = 0.0005\n");
    writeText(folder() / "fine.scn", "version = 2\nmodel = \"room.obj\"\ndeflection = 0.00001\n");
    ASSERT_NO_FATAL_FAILURE(keep(file("room.obj")));
    EXPECT_FALSE(models.find(file("usual.scn")).isEmpty());
    EXPECT_TRUE(models.find(file("fine.scn")).isEmpty());
    ASSERT_NO_FATAL_FAILURE(keep(file("fine.scn")));
    EXPECT_FALSE(models.find(file("fine.scn")).isEmpty());
}

TEST_F(ModelCacheTest, ABrokenFileIsNoHarm) {
    writeText(folder() / "broken.bsp", "rubbish");
    EXPECT_TRUE(shown(file("room.obj"), {"--built-model=broken.bsp"}) == shown(file("room.obj"), {}));
}

TEST_F(ModelCacheTest, AChangedModelOrMaterialIsMadeAnew) {
    ASSERT_NO_FATAL_FAILURE(keep(file("room.obj")));
    ASSERT_FALSE(models.find(file("room.obj")).isEmpty());
    writeText(folder() / "room.mtl", "newmtl a\n");
    EXPECT_TRUE(models.find(file("room.obj")).isEmpty());
    ASSERT_NO_FATAL_FAILURE(keep(file("room.obj")));
    writeText(folder() / "room.obj", readBytes(folder() / "room.obj") + "# more\n");
    EXPECT_TRUE(models.find(file("room.obj")).isEmpty());
}

TEST_F(ModelCacheTest, WhatIsATreeOrNothingIsNotKept) {
    models.keep(file("nothing.obj"));
    models.keep(file("nothing.scn"));
    ASSERT_EQ(bspBuilder({"room.obj", "room.bsp"}, {.folder = folder().path()}).exitCode, 0);
    models.keep(file("room.bsp"));
    models.setLimit(0);
    models.keep(file("room.obj"));
    EXPECT_FALSE(models.building());
}

TEST_F(ModelCacheTest, TheOldestMakeRoom) {
    ASSERT_NO_FATAL_FAILURE(keep(file("room.obj")));
    const QString first = models.find(file("room.obj"));
    QFile old(cache() + QStringLiteral("/old.bsp"));
    ASSERT_TRUE(old.open(QIODevice::WriteOnly));
    ASSERT_TRUE(old.resize(qint64{100} * 1024 * 1024));
    ASSERT_TRUE(old.setFileTime(QDateTime::currentDateTime().addDays(-2), QFileDevice::FileModificationTime));
    old.close();
    ASSERT_TRUE(QFile::copy(old.fileName(), cache() + QStringLiteral("/old.light")));
    QFile light(cache() + QStringLiteral("/old.light"));
    ASSERT_TRUE(light.open(QIODevice::ReadWrite));
    ASSERT_TRUE(
        light.setFileTime(QDateTime::currentDateTime().addDays(-3), QFileDevice::FileModificationTime));
    light.close();
    writeRoom(folder() / "other.obj");
    ASSERT_NO_FATAL_FAILURE(keep(file("other.obj")));
    EXPECT_FALSE(light.exists());
    EXPECT_FALSE(old.exists());
    EXPECT_TRUE(QFile::exists(first));
}

TEST_F(ModelCacheTest, AWindowThatOpensAModelKeepsIt) {
    {
        MainWindow window(name());
        window.show();
        window.open(file("room.obj"));
        ASSERT_TRUE(shows(window.session()));
        EXPECT_TRUE(comes([&] { return !models.find(file("room.obj")).isEmpty(); }));
        window.close();
    }
    MainWindow window(name());
    window.show();
    window.open(file("room.obj"));
    ASSERT_TRUE(shows(window.session()));
    EXPECT_TRUE(
        window.keeper().server().request().options.contains(QStringLiteral("--light-cache=") + cache()));
    EXPECT_TRUE(
        window.keeper().server().request().options.last().startsWith(QStringLiteral("--cached-model=")));
    window.close();
}

} // namespace
