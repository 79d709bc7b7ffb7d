/// The window of a result: all of the image, its own pixels, copies of it.
#include "gui/gui_support.h"

#include "gui/dialogs/picture_dialog.h"
#include "gui/view/picture_view.h"

#include "process/sample_scene.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QGuiApplication>
#include <QScreen>
#include <QScrollBar>
#include <QTest>
#include <QToolButton>

namespace {

using namespace gui;

class PictureTest : public testing::Test {
  protected:
    QString path(const char* name) const { return QString::fromStdString((folder / name).string()); }
    QString write(QSize size) const {
        QImage picture(size, QImage::Format_RGB32);
        picture.fill(qRgb(200, 100, 50));
        EXPECT_TRUE(picture.save(path("result.png")));
        return path("result.png");
    }
    static void open(PictureDialog& dialog) {
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
    }

    test::TemporaryFolder folder;
};

TEST_F(PictureTest, AllOfALargePictureIsSeenAndTheScreenHasRoom) {
    PictureDialog dialog(write({1500, 4000}));
    open(dialog);
    EXPECT_LT(dialog.height(), QGuiApplication::primaryScreen()->availableSize().height());
    PictureView& view = dialog.view();
    EXPECT_TRUE(view.fitted());
    EXPECT_LE(view.mapFromScene(view.sceneRect()).boundingRect().height(), view.viewport()->height() + 1);
    const double before = view.zoom();
    dialog.resize(dialog.width(), dialog.height() / 2);
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.zoom() < before * 0.6; })) << "fits again";
}

TEST_F(PictureTest, ASmallPictureIsNotBlownUp) {
    PictureDialog dialog(write({60, 40}));
    open(dialog);
    EXPECT_EQ(dialog.view().zoom(), 1);
    for (const QToolButton* button : dialog.findChildren<QToolButton*>())
        EXPECT_TRUE(dialog.rect().contains(QRect(button->mapTo(&dialog, QPoint()), button->size())))
            << button->text().toStdString();
}

TEST_F(PictureTest, KeysZoomAndMove) {
    PictureDialog dialog(write({3000, 2000}));
    open(dialog);
    PictureView& view = dialog.view();
    const double fitted = view.zoom();
    QTest::keyClick(&view, Qt::Key_1);
    EXPECT_EQ(view.zoom(), 1);
    EXPECT_FALSE(view.fitted());
    const int left = view.horizontalScrollBar()->value();
    QTest::keyClick(&view, Qt::Key_Right);
    EXPECT_GT(view.horizontalScrollBar()->value(), left);
    QTest::keyClick(&view, Qt::Key_Plus);
    EXPECT_GT(view.zoom(), 1);
    QTest::keyClick(&view, Qt::Key_0);
    EXPECT_EQ(view.zoom(), fitted);
    test::doubleClick(view.viewport());
    EXPECT_EQ(view.zoom(), 1);
    test::doubleClick(view.viewport());
    EXPECT_EQ(view.zoom(), fitted);
    for (int i = 0; i < 100; ++i) QTest::keyClick(&view, Qt::Key_Plus);
    EXPECT_LE(view.zoom(), 32);
}

TEST_F(PictureTest, EscCloses) {
    PictureDialog dialog(write({300, 200}));
    open(dialog);
    QTest::keyClick(&dialog.view(), Qt::Key_Escape);
    EXPECT_FALSE(dialog.isVisible());
}

TEST_F(PictureTest, ACopyIsTheSameFileOrAnotherFormat) {
    PictureDialog dialog(write({30, 20}));
    EXPECT_EQ(dialog.saveTo(path("copy.png")), QString());
    QFile from(path("result.png")), to(path("copy.png"));
    ASSERT_TRUE(from.open(QIODevice::ReadOnly) && to.open(QIODevice::ReadOnly));
    EXPECT_EQ(from.readAll(), to.readAll());
    EXPECT_EQ(dialog.saveTo(path("copy.bmp")), QString());
    EXPECT_EQ(QImage(path("copy.bmp")).size(), QSize(30, 20));
    EXPECT_EQ(dialog.saveTo(path("result.png")), QString()) << "onto itself";
    EXPECT_FALSE(QImage(path("result.png")).isNull());
}

TEST_F(PictureTest, WhatCannotBeWrittenIsToldAndNothingIsThere) {
    PictureDialog dialog(write({30, 20}));
    EXPECT_NE(dialog.saveTo(path("copy.nosuchkind")), QString());
    EXPECT_FALSE(QFile::exists(path("copy.nosuchkind")));
    EXPECT_NE(dialog.saveTo(path("no/such/folder.png")), QString());
}

TEST_F(PictureTest, AFileOfAnotherKindIsNotReadable) {
    test::writeText(folder / "film.mp4", "no image");
    PictureDialog dialog(path("film.mp4"));
    EXPECT_FALSE(dialog.readable());
}

} // namespace
