/// The strip of saved views, which has the bookmarks of the panel.
#include "gui/models/bookmark_store.h"
#include "gui/models/view_pictures.h"
#include "gui/operations/scene_editor.h"
#include "gui/panels/bookmarks_panel.h"
#include "gui/panels/views_strip.h"
#include "gui/window_support.h"

#include <QDir>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QSignalSpy>
#include <QToolButton>

namespace {

namespace views_strip_test {

using namespace test;
using namespace gui;

void forgetViews() {
    QDir(BookmarkStore::usualFolder()).removeRecursively();
    QDir(ViewPictures::usualFolder()).removeRecursively();
}

class ViewsStripTest : public WindowFixture {
  protected:
    void SetUp() override {
        forgetViews();
        ASSERT_NO_FATAL_FAILURE(WindowFixture::SetUp());
        window->preferences().set(pref::progressiveRendering, false);
        window->resize(900, 640);
        writeText(folder() / "marked.scn",
                  "version = 2\nmodel = \"room.obj\"\n"
                  "[[bookmark]]\nname = \"Door\"\neye = [1, 2, 4]\nlookAt = [0, 1, 0]\n"
                  "[[bookmark]]\nname = \"Above\"\neye = [0, 9, 1]\nlookAt = [0, 1, 0]\n");
    }
    void TearDown() override {
        WindowFixture::TearDown();
        forgetViews();
    }
    void openWithStrip(const std::string& scene) {
        ASSERT_NO_FATAL_FAILURE(openAndRest(scene));
        action(ActionId::ViewsStrip)->trigger();
        ASSERT_TRUE(comes([&] { return strip().isVisible(); }));
    }
    ViewsStrip& strip() { return *window->findChild<ViewsStrip*>(); }
    static QStringList namesIn(QListWidget& list) {
        QStringList names;
        for (int i = 0; i < list.count(); ++i) names.append(list.item(i)->text());
        return names;
    }
    bool shows(const QStringList& names) {
        return comes([&] {
            return namesIn(strip().list()) == names &&
                   namesIn(window->findChild<BookmarksPanel*>()->list()) == names;
        });
    }
    void keepView(const char* camera, int count) {
        ASSERT_TRUE(ask(window->session(), QString::fromLatin1(camera)).done);
        ASSERT_TRUE(ask(window->session(), QStringLiteral("wait-idle")).done);
        strip().adder().click();
        ASSERT_TRUE(comes([&] { return strip().list().count() == count; }));
    }
    QPoint middleOf(int row) { return strip().list().visualItemRect(strip().list().item(row)).center(); }
    void click(int row) { QTest::mouseClick(strip().list().viewport(), Qt::LeftButton, {}, middleOf(row)); }
    QAction* entry(const char* text) {
        for (QAction* each : strip().menu().actions())
            if (each->text().remove(QLatin1Char('&')) == QLatin1String(text)) return each;
        throw std::logic_error(text);
    }
    bool isAt(QVector3D eye) {
        return comes([&] { return (status().view.eye - eye).length() < 1e-3F; });
    }
};

TEST_F(ViewsStripTest, AClickGoesToAView) {
    ASSERT_NO_FATAL_FAILURE(openWithStrip("room.obj"));
    ASSERT_NO_FATAL_FAILURE(keepView("camera set 1 2 5 0 0 -1", 1));
    ASSERT_NO_FATAL_FAILURE(keepView("camera set -1 2 5 0 0 -1", 2));
    EXPECT_TRUE(shows({QStringLiteral("Place 1"), QStringLiteral("Place 2")}));
    EXPECT_FALSE(strip().list().item(1)->toolTip().contains(QStringLiteral("comes"))) << "it has an image";
    click(0);
    EXPECT_TRUE(isAt({1, 2, 5}));
    click(1);
    EXPECT_TRUE(isAt({-1, 2, 5}));
    strip().list().setCurrentRow(0);
    strip().list().setFocus();
    QTest::keyClick(&strip().list(), Qt::Key_Return);
    EXPECT_TRUE(isAt({1, 2, 5}));
    QTest::keyClick(&strip().list(), Qt::Key_Escape);
    EXPECT_TRUE(comes([&] { return window->view().hasFocus(); }));
}

TEST_F(ViewsStripTest, AViewIsReplacedByTheCurrentOne) {
    ASSERT_NO_FATAL_FAILURE(openWithStrip("room.obj"));
    ASSERT_NO_FATAL_FAILURE(keepView("camera set 1 2 5 0 0 -1", 1));
    BookmarkStore store;
    store.setScene(file("room.obj"));
    const BookmarkFiles before = store.read(store.list().front());
    EXPECT_FALSE(before.picture.isEmpty());
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set -2 2 5 1 0 -1")).done);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("wait-idle")).done);
    ASSERT_TRUE(comes([&] { return window->editor().state().edits == 2; })); // two cameras
    strip().list().setCurrentRow(0);
    entry("Replace by the current view")->trigger();
    ASSERT_TRUE(comes([&] { return store.read(store.list().front()).camera != before.camera; }));
    EXPECT_NE(store.read(store.list().front()).picture, before.picture);
    EXPECT_TRUE(action(ActionId::Undo)->text().contains(QStringLiteral("replace")));
    action(ActionId::Undo)->trigger();
    EXPECT_EQ(store.read(store.list().front()).camera, before.camera);
    EXPECT_EQ(store.read(store.list().front()).picture, before.picture);
    click(0);
    EXPECT_TRUE(isAt({1, 2, 5}));
}

// In the scene and in the window's own files.
TEST_F(ViewsStripTest, WhatIsKeptTwiceIsOneStep) {
    ASSERT_NO_FATAL_FAILURE(openWithStrip("room.obj"));
    ASSERT_NO_FATAL_FAILURE(keepView("camera set 1 2 5 0 0 -1", 1));
    ASSERT_TRUE(ask(window->session(), QStringLiteral("bookmark add \"Place 1\"")).done);
    window->editor().refresh();
    const auto inScene = [&](const QStringList& names) {
        return comes([&] { return window->editor().state().bookmarks == names; });
    };
    BookmarkStore store;
    store.setScene(file("room.obj"));
    const QStringList one{QStringLiteral("Place 1")}, other{QStringLiteral("Altar")};
    ASSERT_TRUE(inScene(one) && shows(one));
    const int edits = window->editor().state().edits;
    strip().list().item(0)->setText(other[0]);
    ASSERT_TRUE(inScene(other) && shows(other));
    EXPECT_EQ(store.list().front().name, other[0]);
    strip().list().setCurrentRow(0);
    emit window->findChild<BookmarksPanel*>()->deleteWanted(0);
    ASSERT_TRUE(inScene({}) && shows({}));
    EXPECT_TRUE(store.list().isEmpty());
    action(ActionId::Undo)->trigger();
    ASSERT_TRUE(inScene(other) && shows(other));
    EXPECT_EQ(store.list().size(), 1);
    action(ActionId::Undo)->trigger();
    ASSERT_TRUE(inScene(one) && shows(one));
    EXPECT_EQ(window->editor().state().edits, edits);
    action(ActionId::Redo)->trigger();
    ASSERT_TRUE(inScene(other) && shows(other));
    EXPECT_EQ(store.list().front().name, other[0]);
    action(ActionId::Redo)->trigger();
    ASSERT_TRUE(inScene({}) && shows({}));
    EXPECT_TRUE(store.list().isEmpty());
}

TEST_F(ViewsStripTest, BothOfAViewThatIsKeptTwiceAreReplacedInOneStep) {
    ASSERT_NO_FATAL_FAILURE(openWithStrip("room.obj"));
    ASSERT_NO_FATAL_FAILURE(keepView("camera set 1 2 5 0 0 -1", 1));
    ASSERT_TRUE(ask(window->session(), QStringLiteral("bookmark add \"Place 1\"")).done);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set -2 2 5 1 0 -1")).done);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("wait-idle")).done);
    window->editor().refresh();
    const auto view = [&] { return window->editor().state().bookmarkViews.value(0); };
    ASSERT_TRUE(comes([&] { return window->editor().state().edits == 3 && !view().isEmpty(); }));
    BookmarkStore store;
    store.setScene(file("room.obj"));
    const QString seen = view();
    const BookmarkFiles before = store.read(store.list().front());
    strip().list().setCurrentRow(0);
    entry("Replace by the current view")->trigger();
    ASSERT_TRUE(comes([&] { return view() != seen; }));
    EXPECT_NE(store.read(store.list().front()).camera, before.camera);
    ASSERT_TRUE(comes([&] { return window->editor().state().edits == 4; }));
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(comes([&] { return view() == seen; }));
    EXPECT_EQ(store.read(store.list().front()).camera, before.camera);
    EXPECT_EQ(window->editor().state().edits, 3);
}

TEST_F(ViewsStripTest, AViewThatWasReplacedAndRenamedComesBackOnce) {
    ASSERT_NO_FATAL_FAILURE(openWithStrip("room.obj"));
    ASSERT_NO_FATAL_FAILURE(keepView("camera set 1 2 5 0 0 -1", 1));
    BookmarkStore store;
    store.setScene(file("room.obj"));
    const BookmarkFiles before = store.read(store.list().front());
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set -2 2 5 1 0 -1")).done);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("wait-idle")).done);
    ASSERT_TRUE(comes([&] { return window->editor().state().edits == 2; }));
    strip().list().setCurrentRow(0);
    entry("Replace by the current view")->trigger();
    ASSERT_TRUE(comes([&] { return store.read(store.list().front()).camera != before.camera; }));
    strip().list().item(0)->setText(QStringLiteral("Altar"));
    ASSERT_TRUE(shows({QStringLiteral("Altar")}));
    EXPECT_TRUE(action(ActionId::Undo)->text().contains(QStringLiteral("rename")));
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(shows({QStringLiteral("Place 1")}));
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(shows({QStringLiteral("Place 1")})) << "no second one";
    EXPECT_EQ(store.read(store.list().front()).camera, before.camera);
    EXPECT_EQ(store.read(store.list().front()).picture, before.picture);
    action(ActionId::Redo)->trigger();
    action(ActionId::Redo)->trigger();
    EXPECT_TRUE(shows({QStringLiteral("Altar")}));
    EXPECT_NE(store.read(store.list().front()).camera, before.camera);
}

TEST_F(ViewsStripTest, AViewOfTheSceneHasItsImageAgainWhenItIsBack) {
    ASSERT_NO_FATAL_FAILURE(openWithStrip("marked.scn"));
    ASSERT_TRUE(shows({QStringLiteral("Door"), QStringLiteral("Above")}));
    click(0);
    const auto seen = [&] {
        ViewPictures pictures;
        pictures.setScene(file("marked.scn"));
        return pictures.picture(window->editor().state().bookmarkViews.value(0));
    };
    ASSERT_TRUE(comes([&] { return !seen().isNull(); }));
    const QImage door = seen();
    const QString view = window->editor().state().bookmarkViews.value(0);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set -2 2 5 1 0 -1")).done);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("wait-idle")).done);
    strip().list().setCurrentRow(0);
    entry("Replace by the current view")->trigger();
    ASSERT_TRUE(
        comes([&] { return window->editor().state().bookmarkViews.value(0) != view && !seen().isNull(); }));
    EXPECT_NE(seen(), door);
    action(ActionId::Undo)->trigger();
    ASSERT_TRUE(comes([&] { return window->editor().state().bookmarkViews.value(0) == view; }));
    EXPECT_EQ(seen(), door);
    ASSERT_TRUE(
        ask(window->session(), QStringLiteral("bookmark add Door")).done); // by another client, perhaps
    ASSERT_TRUE(comes([&] { return window->editor().state().bookmarkViews.value(0) != view; }));
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set 3 2 5 1 0 -1")).done);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("bookmark add Door")).done);
    EXPECT_TRUE(comes([&] { return strip().list().item(0)->toolTip().contains(QStringLiteral("comes")); }))
        << "another view has no image yet";
}

template <typename List>
void keepsATypedName(List& shown) {
    QList<BookmarkRow> rows{{QStringLiteral("a"), {}}, {QStringLiteral("b"), {}}};
    shown.show(rows);
    shown.list().editItem(shown.list().item(1));
    auto* const typed = shown.list().template findChild<QLineEdit*>();
    ASSERT_NE(typed, nullptr);
    typed->setText(QStringLiteral("half a na"));
    rows[1].picture = QImage(16, 10, QImage::Format_RGB32);
    shown.show(rows);
    ASSERT_EQ(shown.list().template findChild<QLineEdit*>(), typed) << "an image came";
    EXPECT_EQ(typed->text(), QStringLiteral("half a na"));
}

TEST(ViewListTest, ANameThatIsBeingTypedIsKeptWhereOnlyImagesChange) {
    ViewsStrip strip;
    keepsATypedName(strip);
    BookmarksPanel panel;
    keepsATypedName(panel);
}

TEST(ViewListTest, OneViewMovesAtATimeAndStaysTheCurrentOne) {
    ViewsStrip strip;
    const BookmarkRow a{QStringLiteral("a"), {}}, b{QStringLiteral("b"), {}}, c{QStringLiteral("c"), {}};
    QList<std::pair<int, int>> moves;
    QObject::connect(&strip, &ViewsStrip::moveWanted, &strip, [&](int row, int by) {
        moves.append({row, by});
    });
    strip.show({a, b, c});
    strip.list().setCurrentRow(2);
    QAction* left = nullptr;
    for (QAction* each : strip.menu().actions())
        if (each->shortcut() == QKeySequence(Qt::CTRL | Qt::Key_Left)) left = each;
    ASSERT_NE(left, nullptr);
    left->trigger();
    left->trigger();
    EXPECT_EQ(moves, (QList<std::pair<int, int>>{{2, -1}})) << "until it is there";
    strip.show({a, c, b});
    EXPECT_EQ(strip.list().currentRow(), 1);
    left->trigger();
    strip.show({a, c, b}); // refused
    EXPECT_EQ(strip.list().currentRow(), 1);
    EXPECT_EQ(moves.size(), 2);
}

TEST_F(ViewsStripTest, ViewsAreMovedRenamedAndDeleted) {
    ASSERT_NO_FATAL_FAILURE(openWithStrip("room.obj"));
    for (int i = 1; i <= 3; ++i) ASSERT_NO_FATAL_FAILURE(keepView("camera set 1 2 5 0 0 -1", i));
    strip().list().setCurrentRow(2);
    EXPECT_FALSE(entry("Move right")->isEnabled());
    strip().list().setFocus();
    QTest::keyClick(&strip().list(), Qt::Key_Left, Qt::ControlModifier);
    EXPECT_TRUE(shows({QStringLiteral("Place 1"), QStringLiteral("Place 3"), QStringLiteral("Place 2")}));
    EXPECT_EQ(strip().list().currentRow(), 1);
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(shows({QStringLiteral("Place 1"), QStringLiteral("Place 2"), QStringLiteral("Place 3")}));
    strip().list().item(0)->setText(QStringLiteral("Altar"));
    EXPECT_TRUE(shows({QStringLiteral("Altar"), QStringLiteral("Place 2"), QStringLiteral("Place 3")}));
    strip().list().setCurrentRow(1);
    QTest::keyClick(&strip().list(), Qt::Key_Delete);
    EXPECT_TRUE(shows({QStringLiteral("Altar"), QStringLiteral("Place 3")}));
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(shows({QStringLiteral("Altar"), QStringLiteral("Place 2"), QStringLiteral("Place 3")}));
}

// The scene's file has none, and the window does not know their cameras before.
TEST_F(ViewsStripTest, AViewOfTheSceneGetsItsImageWhenItIsVisited) {
    ASSERT_NO_FATAL_FAILURE(openWithStrip("marked.scn"));
    ASSERT_TRUE(shows({QStringLiteral("Door"), QStringLiteral("Above")}));
    EXPECT_TRUE(strip().list().item(0)->toolTip().contains(QStringLiteral("comes")));
    click(0);
    ASSERT_TRUE(isAt({1, 2, 4}));
    EXPECT_TRUE(comes([&] { return !strip().list().item(0)->toolTip().contains(QStringLiteral("comes")); }));
    EXPECT_TRUE(strip().list().item(1)->toolTip().contains(QStringLiteral("comes")));
    ViewPictures pictures;
    pictures.setScene(file("marked.scn"));
    const QImage seen = pictures.picture(window->editor().state().bookmarkViews.value(0));
    EXPECT_FALSE(seen.isNull());
    EXPECT_LE(seen.width(), 320);
    // It keeps it under another name, and another position.
    strip().list().item(0)->setText(QStringLiteral("Gate"));
    ASSERT_TRUE(shows({QStringLiteral("Gate"), QStringLiteral("Above")}));
    EXPECT_FALSE(strip().list().item(0)->toolTip().contains(QStringLiteral("comes")));
    strip().list().setCurrentRow(0);
    entry("Move right")->trigger();
    ASSERT_TRUE(shows({QStringLiteral("Above"), QStringLiteral("Gate")}));
    EXPECT_FALSE(strip().list().item(1)->toolTip().contains(QStringLiteral("comes")));
    ASSERT_TRUE(comes([&] { return action(ActionId::Undo)->isEnabled(); }));
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(shows({QStringLiteral("Gate"), QStringLiteral("Above")}));
}

TEST_F(ViewsStripTest, AViewThatIsLeftAtOnceGetsNoImage) {
    ASSERT_NO_FATAL_FAILURE(openWithStrip("marked.scn"));
    ASSERT_TRUE(shows({QStringLiteral("Door"), QStringLiteral("Above")}));
    emit strip().goWanted(0);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set 0 2 7 0 0 -1")).done);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("wait-idle")).done);
    QTest::qWait(200);
    ViewPictures pictures;
    pictures.setScene(file("marked.scn"));
    EXPECT_TRUE(pictures.picture(window->editor().state().bookmarkViews.value(0)).isNull());
    EXPECT_FALSE(window->editor().state().bookmarkViews.value(0).isEmpty());
}

TEST(ViewPicturesTest, AreFewSmallAndPrivate) {
    const TemporaryFolder folder;
    ViewPictures pictures(QString::fromStdString((folder / "views").string()));
    QImage image(32, 20, QImage::Format_RGB32);
    image.fill(Qt::red);
    pictures.keep(QStringLiteral("nowhere"), image);
    pictures.setScene(QStringLiteral("/a.scn"));
    for (int i = 0; i < ViewPictures::kMaxFiles + 5; ++i) pictures.keep(QString::number(i), image);
    const QDir files(QString::fromStdString((folder / "views").string()));
    EXPECT_EQ(files.entryList(QDir::Files).size(), ViewPictures::kMaxFiles);
    EXPECT_FALSE(pictures.picture(QString::number(ViewPictures::kMaxFiles + 4)).isNull()) << "the newest";
    for (const QFileInfo& file : files.entryInfoList(QDir::Files))
        ASSERT_FALSE(file.permission(QFileDevice::ReadGroup) || file.permission(QFileDevice::ReadOther));
    pictures.setScene(QStringLiteral("/other.scn"));
    EXPECT_TRUE(pictures.picture(QString::number(ViewPictures::kMaxFiles + 4)).isNull());
    pictures.keep(QString(), image);
    EXPECT_TRUE(pictures.picture(QString()).isNull()) << "of no view";
}

} // namespace views_strip_test

} // namespace
