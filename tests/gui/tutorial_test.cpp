/// The steps of docs/tutorial.md in the window, carried out: keys and menus are read from its text.
#include "gui/dialog_support.h"
#include "gui/jobs_support.h"
#include "gui/window_support.h"

#include "gui/dialogs/configure_dialog.h"
#include "gui/dialogs/connect_dialog.h"
#include "gui/dialogs/export_camera_dialog.h"
#include "gui/dialogs/keys_dialog.h"
#include "gui/dialogs/plan_dialog.h"
#include "gui/dialogs/recording_dialog.h"
#include "gui/dialogs/render_dialog.h"
#include "gui/dialogs/share_dialog.h"
#include "gui/dialogs/start_server_dialog.h"
#include "gui/dialogs/statistics_dialog.h"
#include "gui/models/action_table.h"
#include "gui/operations/job_operations.h"
#include "gui/operations/scene_editor.h"
#include "gui/panels/sections_panel.h"
#include "gui/panels/value_slider.h"
#include "gui/view/input_capture.h"

#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QSet>
#include <QWheelEvent>

namespace {

using namespace test;
using namespace gui;

QString plain(QString words) { return words.remove(QLatin1Char('&')).remove(QStringLiteral("…")); }

// "Menu > Item", and the shortcut behind it.
const QRegularExpression kMention(QStringLiteral("\\*([A-Z]\\w+) > ([^*]+)\\*(?: \\(([^),]+)[^)]*\\))?"));

class Tutorial : public WithJobs<WindowFixture> {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        QFile file(QStringLiteral(RT_TUTORIAL));
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        page = QString::fromUtf8(file.readAll()).simplified();
    }

    /// The page says so, word for word.
    void says(const char* words) const {
        EXPECT_TRUE(page.contains(QString::fromUtf8(words))) << "the tutorial does not say: " << words;
    }
    /// Chooses it by the shortcut that the page names, or in the menu where it names none.
    void choose(const char* menuAndItem) {
        const QString wanted = QString::fromUtf8(menuAndItem);
        says(("*" + std::string(menuAndItem) + "*").c_str());
        done.insert(wanted);
        for (auto each = kMention.globalMatch(page); each.hasNext();) {
            const QRegularExpressionMatch mention = each.next();
            if (mention.captured(1) + QStringLiteral(" > ") + mention.captured(2) != wanted) continue;
            if (!mention.captured(3).isEmpty()) return type(mention.captured(3));
        }
        for (const ActionRow& row : actionTable()) {
            if (plain(menuText(row.menu)) + QStringLiteral(" > ") + plain(actionText(row)) == wanted)
                return action(row.id)->trigger();
        }
        ADD_FAILURE() << "there is no " << menuAndItem;
    }
    void type(const QString& keys) {
        const QKeyCombination combination = QKeySequence(keys)[0];
        QTest::keyClick(&window->view(), combination.key(), combination.keyboardModifiers());
    }
    template <typename Dialog>
    Dialog* opened() {
        Dialog* dialog = nullptr;
        EXPECT_TRUE(comes([&] {
            dialog = window->findChild<Dialog*>();
            return dialog != nullptr && dialog->isVisible();
        }));
        return dialog;
    }
    /// By Esc; the image has the keyboard again.
    void leave(QDialog* dialog) {
        ASSERT_NE(dialog, nullptr);
        QTest::keyClick(dialog, Qt::Key_Escape);
        back();
    }
    void back() {
        window->activateWindow();
        window->view().setFocus();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&*window));
        // A dialog that goes may take the window's activity with it once more.
        QTest::qWait(100);
        window->view().setFocus();
    }
    void chooseFile(const QString& path) {
        auto* dialog = opened<QFileDialog>();
        ASSERT_NE(dialog, nullptr);
        dialog->findChild<QLineEdit*>()->setText(path);
        QTest::keyClick(dialog->findChild<QLineEdit*>(), Qt::Key_Return);
        ASSERT_TRUE(comes([&] { return window->findChild<QFileDialog*>() == nullptr; }));
        back();
    }
    bool told(const char* words) {
        return comes([&] { return window->view().told().contains(QLatin1String(words)); });
    }
    bool moves(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        const View before = status().view;
        QTest::keyPress(&window->view(), key, modifiers);
        const bool moved = comes([&] { return status().view != before; });
        QTest::keyRelease(&window->view(), key, modifiers);
        return moved;
    }
    bool rests() {
        return comes([&] { return status().idle; });
    }
    bool written(const char* name) {
        return comes([&] { return QFile::exists(file(name)); });
    }

    void openAScene();
    void walk();
    void look();
    void keepAView();
    void renderAStill();
    void record();
    void cutOpen();
    void measure();
    void drawAPlan();
    void share();
    void end();

    QString page;
    QSet<QString> done;
};

void Tutorial::openAScene() {
    choose("File > Open");
    chooseFile(QStringLiteral(RT_NAVE));
    ASSERT_TRUE(shows(window->session())) << text(window->notice().text());
    EXPECT_FALSE(window->notice().isVisible()) << text(window->notice().text());
    choose("Server > Start new server");
    leave(opened<StartServerDialog>());
    choose("Server > Connect");
    leave(opened<ConnectDialog>());
}

void Tutorial::walk() {
    for (const Qt::Key key : {Qt::Key_W, Qt::Key_A, Qt::Key_S, Qt::Key_D, Qt::Key_Up, Qt::Key_I, Qt::Key_O})
        EXPECT_TRUE(moves(key)) << key;
    QTest::keyPress(&window->view(), Qt::Key_CapsLock);
    EXPECT_TRUE(moves(Qt::Key_Left));
    QTest::keyRelease(&window->view(), Qt::Key_CapsLock);

    QTest::mouseClick(&window->view(), Qt::LeftButton);
    ASSERT_TRUE(window->view().input().captured());
    const QVector3D forward = status().view.forward;
    QTest::mouseMove(&window->view(), window->view().rect().center() + QPoint(60, 0));
    QTest::mouseMove(&window->view(), window->view().rect().center() + QPoint(20, 0));
    EXPECT_TRUE(comes([&] { return status().view.forward != forward; }));
    emit window->view().input().wheelTurned(1);
    EXPECT_TRUE(told("speed"));
    type(QStringLiteral("F"));
    ASSERT_TRUE(told("Walking")) << text(window->view().told());
    for (const Qt::Key key : {Qt::Key_Space, Qt::Key_C, Qt::Key_Control}) EXPECT_TRUE(moves(key)) << key;
    QTest::keyPress(&window->view(), Qt::Key_Shift);
    EXPECT_TRUE(moves(Qt::Key_W, Qt::ShiftModifier));
    QTest::keyRelease(&window->view(), Qt::Key_Shift);
    type(QStringLiteral("3"));
    EXPECT_TRUE(told("Light 3: off"));
    type(QStringLiteral("3"));
    EXPECT_TRUE(told("Light 3: on"));
    QTest::keyPress(&window->view(), Qt::Key_M);
    type(QStringLiteral("2"));
    QTest::keyRelease(&window->view(), Qt::Key_M);
    EXPECT_TRUE(told("Environment map 2"));
    type(QStringLiteral("B"));
    EXPECT_TRUE(told("Bloom"));
    type(QStringLiteral("F"));
    EXPECT_TRUE(told("Flying"));
    type(QStringLiteral("Esc"));
    EXPECT_FALSE(window->view().input().captured());
}

void Tutorial::look() {
    says("F1 shows all keys");
    type(QStringLiteral("F1"));
    leave(opened<KeysDialog>());
    choose("Edit > Preferences");
    leave(opened<ConfigureDialog>());
    choose("Window > Statistics");
    leave(opened<StatisticsDialog>());
    choose("Window > Settings panel");
    choose("Window > Lights panel");
    ASSERT_TRUE(comes([&] { return !window->editor().state().lights.isEmpty(); }));
    window->editor().setSetting(QStringLiteral("shadows"), QStringLiteral("false"));
    ASSERT_TRUE(comes([&] { return action(ActionId::Undo)->isEnabled(); }));
    back();
    choose("Edit > Undo");
    EXPECT_TRUE(comes([&] {
        return window->editor().state().settings[QStringLiteral("shadows")] == QStringLiteral("true");
    }));
    back();
    const bool progressive = window->preferences().get(pref::progressiveRendering);
    choose("Render > At rest: live frame");
    EXPECT_NE(window->preferences().get(pref::progressiveRendering), progressive);
    window->preferences().set(pref::progressiveRendering, false);
    says("or just R");
    ASSERT_TRUE(rests());
    choose("Render > Quick render");
    EXPECT_TRUE(comes([&] { return !window->view().showsLive(); })) << text(window->notice().text());
    says("the next movement shows the live frame again");
    EXPECT_TRUE(moves(Qt::Key_W));
    EXPECT_TRUE(window->view().showsLive());
    says("F12 keeps what you see");
    type(QStringLiteral("F12"));
    EXPECT_TRUE(written("screenshot-0001.png"));
}

void Tutorial::keepAView() {
    ASSERT_TRUE(rests());
    choose("Camera > Export camera");
    accept(*opened<ExportCameraDialog>());
    EXPECT_TRUE(written("camera-0001.cam"));
    back();
    const QVector3D kept = status().view.eye;
    const auto isBack = [&] { return comes([&] { return (status().view.eye - kept).length() < 0.01F; }); };
    says("the key E does so without asking, H in high quality");
    type(QStringLiteral("E"));
    EXPECT_TRUE(written("camera-0002.cam"));
    type(QStringLiteral("H"));
    EXPECT_TRUE(written("camera-0003.cam"));
    EXPECT_TRUE(moves(Qt::Key_S) && rests());
    choose("Camera > Import camera");
    chooseFile(file("camera-0001.cam"));
    EXPECT_TRUE(isBack());
    EXPECT_TRUE(moves(Qt::Key_S) && rests());
    window->open(file("camera-0001.cam")); // dropped
    EXPECT_TRUE(isBack());
    QTest::mouseClick(&window->view(), Qt::LeftButton); // who walks need not leave the image
    ASSERT_TRUE(rests());
    choose("Camera > Add bookmark");
    EXPECT_TRUE(told("Alt+1"));
    EXPECT_TRUE(moves(Qt::Key_S) && rests());
    says("Alt+1 leads back to the first one");
    type(QStringLiteral("Alt+1"));
    EXPECT_TRUE(isBack()) << window->view().told().toStdString() << ", off by "
                          << (status().view.eye - kept).length();
    EXPECT_TRUE(window->view().input().captured());
    choose("Window > Bookmarks panel");
    back();
}

void Tutorial::renderAStill() {
    choose("Render > Render");
    auto* dialog = opened<RenderDialog>();
    ASSERT_NE(dialog, nullptr);
    says("its last line is the command that will run");
    EXPECT_TRUE(field<QLineEdit>(*dialog, "Command")->text().startsWith(QStringLiteral("Renderer ")));
    accept(*dialog);
    back();
    JobQueue& queue = window->jobs().queue();
    ASSERT_TRUE(comes([&] { return queue.rowCount() == 1 && !queue.busy(); }, 3 * kPatience));
    EXPECT_EQ(queue.job(0).state, JobState::Done) << text(queue.job(0).log);
    choose("Render > Jobs"); // it came by itself, and goes
    EXPECT_TRUE(window->findChild<QDockWidget*>(QStringLiteral("jobs"))->isHidden());
}

void Tutorial::record() {
    says("choose where, press *Start*. Close the dialog (Esc) and walk. Open it again and press *Stop*.");
    choose("Camera > Recording");
    auto* dialog = opened<RecordingDialog>();
    ASSERT_TRUE(press(*dialog, "Start"));
    ASSERT_TRUE(comes([&] { return status().recording; }));
    leave(dialog);
    QTest::mouseClick(&window->view(), Qt::LeftButton);
    const QVector3D start = status().view.eye;
    EXPECT_TRUE(moves(Qt::Key_W));
    EXPECT_TRUE(rests());
    choose("Camera > Recording");
    dialog = opened<RecordingDialog>();
    ASSERT_TRUE(comes([&] { return press(*dialog, "Stop"); }));
    says("*Play* shows the walk again");
    ASSERT_TRUE(comes([&] { return press(*dialog, "Play"); }));
    ASSERT_TRUE(QFile::exists(file("walk-0001.lst")));
    EXPECT_TRUE(comes([&] { return (status().view.eye - start).length() < 0.01F; }));
    window->open(file("walk-0001.lst")); // dropped
    says("*Render as film* in the dialog does what follows here");
    ASSERT_TRUE(press(*dialog, "Render as film"));
    auto* film = opened<RenderDialog>();
    ASSERT_NE(film, nullptr);
    EXPECT_TRUE(film->arguments().contains(QStringLiteral("--list=") + file("walk-0001.lst")));
    EXPECT_TRUE(film->arguments().contains(QStringLiteral("--video=") + file("walk-0001.mp4")));
    // Images, since a machine for tests may be without ffmpeg.
    field<QLineEdit>(*film, "Film")->clear();
    field<QLineEdit>(*film, "Output file")->setText(file("walk_####.png"));
    field<QLineEdit>(*film, "Frames")->setText(QStringLiteral("1-2"));
    accept(*film);
    JobQueue& queue = window->jobs().queue();
    ASSERT_TRUE(comes([&] { return queue.rowCount() == 2 && !queue.busy(); }, 3 * kPatience));
    EXPECT_EQ(queue.job(1).state, JobState::Done) << text(queue.job(1).log);
    leave(dialog);
}

void Tutorial::cutOpen() {
    const auto& planes = window->editor().state().sections.planes;
    choose("Window > Sections panel");
    auto* panel = window->findChild<SectionsPanel*>();
    ASSERT_NE(panel, nullptr);
    says("*From above*, then the slider");
    panel->above().click();
    ASSERT_TRUE(comes([&] { return planes.size() == 1; }));
    const rtcore::Vec3 before = planes[0].point;
    emit panel->slider().moved(0.75);
    EXPECT_TRUE(comes([&] { return planes.size() == 1 && planes[0].point.y > before.y; }));
    back();
}

void Tutorial::measure() {
    const QRectF area = window->view().pictureArea();
    const auto at = [&](double right, double down) {
        return (area.topLeft() + QPointF(right * area.width(), down * area.height())).toPoint();
    };
    ASSERT_TRUE(rests());
    choose("Light > Light meter");
    const auto* light = window->findChild<QLabel*>(QStringLiteral("lightMeter"));
    ASSERT_NE(light, nullptr);
    QTest::mouseMove(&window->view(), at(0.4, 0.8));
    QTest::mouseMove(&window->view(), at(0.5, 0.8));
    EXPECT_TRUE(comes([&] { return light->isVisible() && light->text().contains(QStringLiteral("lx")); }));
    choose("Light > Light meter");
    const auto& measures = window->editor().state().measures.all;
    choose("View > Measure");
    says("two clicks keep a length");
    QTest::mouseClick(&window->view(), Qt::LeftButton, {}, at(0.3, 0.7));
    QTest::mouseClick(&window->view(), Qt::LeftButton, {}, at(0.7, 0.7));
    EXPECT_TRUE(comes([&] { return measures.size() == 1; }));
    says("Esc ends it");
    type(QStringLiteral("Esc"));
    EXPECT_FALSE(action(ActionId::Measure)->isChecked());
    says("Ctrl+Z takes it back");
    type(QStringLiteral("Ctrl+Z"));
    EXPECT_TRUE(comes([&] { return measures.empty(); }));
}

void Tutorial::drawAPlan() {
    choose("File > Plan");
    auto* dialog = opened<PlanDialog>();
    ASSERT_NE(dialog, nullptr);
    dialog->findChild<QLineEdit*>()->setText(file("plan.pdf"));
    accept(*dialog);
    EXPECT_TRUE(written("plan.pdf")) << text(window->notice().text());
    back();
}

void Tutorial::share() {
    choose("File > Share in a browser");
    auto* dialog = opened<ShareDialog>();
    ASSERT_NE(dialog, nullptr);
    if (hasBridge()) {
        says("gives two links");
        ASSERT_TRUE(press(*dialog, "Share"));
        ASSERT_TRUE(comes([&] { return action(ActionId::ShareInBrowser)->isChecked(); }));
        for (const char* whose : {"Driver's link", "Viewer's link"})
            EXPECT_FALSE(field<QLineEdit>(*dialog, whose)->text().isEmpty()) << whose;
    }
    leave(dialog);
}

void Tutorial::end() {
    says("(Ctrl+K) ends the server, once you have confirmed it");
    choose("Server > Stop server");
    ASSERT_TRUE(press(*opened<QMessageBox>(), "Stop"));
    EXPECT_TRUE(comes([&] { return !window->session().live() && !window->keeper().server().running(); }));
}

TEST_F(Tutorial, IsPlayedWordByWord) {
    if (!QFile::exists(QStringLiteral(RT_NAVE_MODEL)))
        GTEST_SKIP() << "skipped: scripts/make_data.sh has not made the nave";
    ASSERT_NO_FATAL_FAILURE(openAScene());
    ASSERT_NO_FATAL_FAILURE(walk());
    ASSERT_NO_FATAL_FAILURE(look());
    ASSERT_NO_FATAL_FAILURE(keepAView());
    ASSERT_NO_FATAL_FAILURE(renderAStill());
    ASSERT_NO_FATAL_FAILURE(record());
    ASSERT_NO_FATAL_FAILURE(cutOpen());
    ASSERT_NO_FATAL_FAILURE(measure());
    ASSERT_NO_FATAL_FAILURE(drawAPlan());
    ASSERT_NO_FATAL_FAILURE(share());
    ASSERT_NO_FATAL_FAILURE(end());
    for (auto each = kMention.globalMatch(page); each.hasNext();) {
        const QRegularExpressionMatch mention = each.next();
        const QString wanted = mention.captured(1) + QStringLiteral(" > ") + mention.captured(2);
        EXPECT_TRUE(done.contains(wanted)) << "nobody has tried " << text(wanted);
    }
}

// The shortcuts that it names, also where there is no scene to walk in.
TEST_F(Tutorial, NamesMenusAndShortcutsAsTheyAre) {
    int mentions = 0;
    for (auto each = kMention.globalMatch(page); each.hasNext(); ++mentions) {
        const QRegularExpressionMatch mention = each.next();
        bool found = false;
        for (const ActionRow& row : actionTable()) {
            if (plain(menuText(row.menu)) != mention.captured(1) ||
                plain(actionText(row)) != mention.captured(2))
                continue;
            found = true;
            if (mention.captured(3).isEmpty()) continue;
            EXPECT_EQ(text(mention.captured(3)), text(shortcutOf(row).toString())) << row.text;
        }
        EXPECT_TRUE(found) << text(mention.captured(0));
    }
    EXPECT_GT(mentions, 10);
}

} // namespace
