/// The page of an empty window: scenes to begin with.
#include "gui/window_support.h"

#include "gui/models/example_scenes.h"
#include "gui/view/input_capture.h"
#include "gui/view/start_page.h"

#include <QFileDialog>
#include <QLabel>
#include <QPushButton>

#include <filesystem>
#include <fstream>

namespace {

using namespace test;
using namespace gui;

class StartPageTest : public WindowFixture {
  protected:
    StartPage& page() { return *window->findChild<StartPage*>(); }
    QPushButton* button(const QString& text) {
        for (QPushButton* each : page().findChildren<QPushButton*>()) {
            if (each->text() == text && each->isVisible()) return each;
        }
        return nullptr;
    }
};

TEST_F(StartPageTest, IsThereUntilAServerIsAndWhenItWasLeft) {
    EXPECT_TRUE(page().isVisible());
    EXPECT_NE(button(QStringLiteral("Open a scene or a &model…")), nullptr);
    open();
    EXPECT_FALSE(page().isVisible());
    action(ActionId::Disconnect)->trigger();
    EXPECT_TRUE(comes([&] { return page().isVisible(); }));
    QPushButton* recent = button(QStringLiteral("room.obj"));
    ASSERT_NE(recent, nullptr);
    recent->click();
    EXPECT_TRUE(shows(window->session()));
    EXPECT_FALSE(page().isVisible());
}

TEST_F(StartPageTest, ReturnPressesTheButtonThatHasTheFocus) {
    int asked = 0;
    QObject::connect(&page(), &StartPage::chooseWanted, [&] { ++asked; });
    QPushButton* choose = button(QStringLiteral("Open a scene or a &model…"));
    ASSERT_NE(choose, nullptr);
    const auto dialog = [&] { return window->findChild<QFileDialog*>(); };
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Space}) {
        choose->setFocus();
        QTest::keyClick(choose, key);
        ASSERT_TRUE(comes([&] { return dialog() != nullptr; }));
        dialog()->reject();
        ASSERT_TRUE(comes([&] { return dialog() == nullptr; }));
    }
    EXPECT_EQ(asked, 3);
    EXPECT_FALSE(window->view().input().captured()) << "Return is not the image's, too";
}

TEST_F(StartPageTest, HasTheColoursOfTheTheme) {
    const auto lightness = [&] {
        const QImage image = button(QStringLiteral("Open a scene or a &model…"))->grab().toImage();
        return image.pixelColor(8, image.height() / 2).lightness();
    };
    window->preferences().set(pref::theme, QStringLiteral("light"));
    EXPECT_TRUE(comes([&] { return lightness() > 180; }));
    window->preferences().set(pref::theme, QStringLiteral("dark"));
    EXPECT_TRUE(comes([&] { return lightness() < 100; })) << lightness();
    for (const QLabel* label : page().findChildren<QLabel*>())
        EXPECT_GT(label->palette().color(QPalette::WindowText).lightness(), 180)
            << "on the viewport's dark ground";
    window->preferences().set(pref::theme, QStringLiteral("system"));
}

TEST_F(StartPageTest, LeavesASmallWindowSmall) {
    window->resize(240, 200);
    EXPECT_TRUE(comes([&] { return window->width() <= 320; })) << window->width();
}

TEST_F(StartPageTest, OffersWhatIsInstalledWithItsModel) {
    const std::filesystem::path scenes = folder() / "scenes";
    for (const char* name : {"nave", "mirrors"}) {
        std::filesystem::create_directories(scenes / name / "generated");
        std::ofstream(scenes / name / (std::string(name) + ".scn")) << "version = 1\n";
    }
    std::ofstream(scenes / "nave" / "generated" / "nave.glb") << "glTF";
    const QList<ExampleScene> found = exampleScenesIn(QString::fromStdString(scenes.string()));
    ASSERT_EQ(found.size(), 1) << "that of mirrors has no model";
    EXPECT_EQ(found[0].name, QStringLiteral("Basilica in the sun"));
    EXPECT_TRUE(found[0].path.endsWith(QStringLiteral("scenes/nave/nave.scn")));
    EXPECT_TRUE(exampleScenesIn(file("none")).isEmpty());
    StartPage own(found, {}, nullptr);
    QString opened;
    QObject::connect(&own, &StartPage::openWanted, [&](const QString& path) { opened = path; });
    for (QPushButton* each : own.findChildren<QPushButton*>()) {
        if (each->text() == found[0].name) each->click();
    }
    EXPECT_EQ(opened, found[0].path);
}

} // namespace
