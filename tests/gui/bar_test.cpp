/// The tool bar: it shows what the actions say, can be hidden, and its icons are the page's.
#include "gui/window_support.h"

#include "gui/models/installed_skies.h"
#include "gui/operations/scene_editor.h"
#include "gui/view/symbol_icon.h"
#include "gui/view/symbol_path.h"

#include <QGuiApplication>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>

namespace gui {
namespace {

using test::comes;

class BarTest : public test::WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        window->preferences().set(pref::progressiveRendering, false);
        window->resize(700, 480);
    }
    QToolBar& bar() { return *window->findChild<QToolBar*>(); }
    QToolButton& button(ActionId id) {
        return *qobject_cast<QToolButton*>(bar().widgetForAction(action(id)));
    }
};

TEST_F(BarTest, ItsArrowsFollowWhatCanBeTakenBack) {
    ASSERT_TRUE(bar().isVisible());
    EXPECT_FALSE(button(ActionId::Undo).isEnabled() || button(ActionId::Redo).isEnabled());
    openAndRest();
    window->editor().setSetting(QStringLiteral("shadows"), QStringLiteral("false"));
    ASSERT_TRUE(comes([&] { return button(ActionId::Undo).isEnabled(); }));
    EXPECT_EQ(button(ActionId::Undo).toolTip(), QStringLiteral("Undo: Shadows"));
    button(ActionId::Undo).click();
    ASSERT_TRUE(comes([&] { return !button(ActionId::Undo).isEnabled(); }));
    EXPECT_TRUE(button(ActionId::Redo).isEnabled());
    EXPECT_EQ(button(ActionId::Redo).toolTip(), QStringLiteral("Redo: Shadows"));
    button(ActionId::Redo).click();
    EXPECT_TRUE(comes([&] { return !button(ActionId::Redo).isEnabled(); }));
}

TEST_F(BarTest, ItsModesAreThoseOfTheView) {
    openAndRest();
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set 0 1.8 3 0 0 -1")).done);
    const auto is = [&](ActionId wanted) {
        return comes([&] {
            for (const ActionId each : {ActionId::Orbit, ActionId::Walk, ActionId::Fly})
                if (button(each).isChecked() != (each == wanted)) return false;
            return true;
        });
    };
    button(ActionId::Fly).click();
    EXPECT_TRUE(is(ActionId::Fly));
    button(ActionId::Orbit).click();
    EXPECT_TRUE(is(ActionId::Orbit));
    button(ActionId::Walk).click();
    EXPECT_TRUE(is(ActionId::Walk)) << window->view().told().toStdString();
    EXPECT_TRUE(comes([&] { return status().view.walking; }));
    EXPECT_EQ(QApplication::focusWidget(), &window->view()) << "the keys stay the camera's";
}

TEST_F(BarTest, ItsLightsAreThoseOfTheMenu) {
    openAndRest();
    const QList<QToolButton*> buttons = bar().findChildren<QToolButton*>();
    const auto light = std::find_if(buttons.begin(), buttons.end(),
                                    [](const QToolButton* each) { return each->menu() != nullptr; });
    ASSERT_NE(light, buttons.end());
    const QList<QAction*> entries = (*light)->menu()->actions();
    for (const ActionId id : {ActionId::LookSky, ActionId::LookStudio, ActionId::OpenEnvironment})
        EXPECT_TRUE(entries.contains(action(id)));
    const QList<InstalledSky> skies = installedSkies();
    if (skies.isEmpty()) GTEST_SKIP() << "no environment maps are installed";
    const auto menu = std::find_if(entries.begin(), entries.end(),
                                   [](const QAction* each) { return each->menu() != nullptr; });
    ASSERT_NE(menu, entries.end());
    ASSERT_EQ((*menu)->menu()->actions().size(), skies.size());
    (*menu)->menu()->actions().first()->trigger();
    EXPECT_TRUE(comes([&] { return static_cast<bool>(window->editor().state().map); }));
}

TEST_F(BarTest, ItIsHiddenByTheMenuAndStaysSo) {
    EXPECT_TRUE(action(ActionId::ShowBar)->isChecked());
    action(ActionId::ShowBar)->trigger();
    EXPECT_FALSE(bar().isVisible());
    window->close();
    {
        MainWindow next(name());
        next.show();
        EXPECT_FALSE(next.findChild<QToolBar*>()->isVisible());
        EXPECT_FALSE(next.actions()[ActionId::ShowBar]->isChecked());
        next.actions()[ActionId::ShowBar]->trigger();
        EXPECT_TRUE(next.findChild<QToolBar*>()->isVisible());
        next.close();
    }
    MainWindow last(name());
    EXPECT_TRUE(last.actions()[ActionId::ShowBar]->isChecked());
}

TEST_F(BarTest, AFullScreenHasNone) {
    action(ActionId::FullScreen)->trigger();
    ASSERT_TRUE(comes([&] { return !bar().isVisible(); }));
    action(ActionId::FullScreen)->trigger();
    EXPECT_TRUE(comes([&] { return bar().isVisible(); }));
    EXPECT_TRUE(action(ActionId::ShowBar)->isChecked());
}

/// Pixels of the symbol that are drawn.
int inkOf(const QIcon& icon, QIcon::Mode mode, QColor* colour = nullptr) {
    const QImage image = icon.pixmap(QSize(24, 24), 1, mode).toImage().convertToFormat(QImage::Format_ARGB32);
    int ink = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (image.pixelColor(x, y).alpha() < 250) continue;
            ++ink;
            if (colour != nullptr) *colour = image.pixelColor(x, y);
        }
    }
    return ink;
}

TEST_F(BarTest, ItsIconsAreThereInTheColourOfLetters) {
    for (QToolButton* each : bar().findChildren<QToolButton*>()) {
        if (!each->isVisible()) continue; // Qt's own, for what does not fit
        EXPECT_GT(inkOf(each->icon(), QIcon::Normal), 10) << each->toolTip().toStdString();
        EXPECT_FALSE(each->toolTip().isEmpty());
    }
    const QPalette before = QGuiApplication::palette();
    QPalette palette = before;
    palette.setColor(QPalette::ButtonText, QColor(10, 200, 30));
    QGuiApplication::setPalette(palette);
    QColor colour;
    (void)inkOf(symbolIcon(QStringLiteral("undo")), QIcon::Normal, &colour);
    EXPECT_EQ(colour, QColor(10, 200, 30));
    QGuiApplication::setPalette(before);
}

TEST(SymbolPaths, AreReadAsSvgWritesThem) {
    EXPECT_EQ(pathOf(QStringLiteral("M4 7h16M4 12v-2L1 1z")).boundingRect(), QRectF(1, 1, 19, 11));
    const QPainterPath lines = pathOf(QStringLiteral("m1 1 2 0.5.5-1"));
    EXPECT_EQ(lines.currentPosition(), QPointF(3.5, 0.5)) << "further points of a move are lines";
    // Half a circle and three quarters of one; both end where they say.
    const QPainterPath half = pathOf(QStringLiteral("M14 9a6 6 0 0 1 0 12"));
    EXPECT_LT((half.currentPosition() - QPointF(14, 21)).manhattanLength(), 1e-6);
    EXPECT_NEAR(half.boundingRect().right(), 20, 0.02) << "with the clock, which is to the right";
    const QPainterPath large = pathOf(QStringLiteral("M12 4a8 8 0 1 0 8 8"));
    EXPECT_NEAR(large.boundingRect().left(), 4, 0.02);
    EXPECT_NEAR(large.boundingRect().bottom(), 20, 0.02);
    for (const char* each : {"", "z 5", "5 5", "M1", "Q1 2 3 4", "M0 0a0 0 0 0 0 4 4"})
        (void)pathOf(QString::fromLatin1(each)); // comes to an end
    EXPECT_TRUE(symbolPath(QStringLiteral("nothing")).isEmpty());
}

} // namespace
} // namespace gui
