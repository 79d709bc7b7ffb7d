/// Progressive rendering in the whole window, with real servers and Renderers.
#include "gui/gui_support.h"
#include "gui/processes_of.h"

#include "gui/main_window.h"
#include "gui/operations/actions.h"
#include "gui/processes/preview_process.h"
#include "gui/session/pixel_order.h"
#include "gui/session/preview_reader.h"
#include "gui/session/server_list.h"
#include "gui/view/frame_view.h"
#include "gui/view/notice_bar.h"
#include "ipc/endpoint/link.h"

#include <QAction>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QSignalSpy>

#include <array>
#include <csignal>
#include <cstdlib>
#include <random>
#include <unistd.h>

namespace {

using namespace test;
using namespace gui;

const QString kRenderer = QStringLiteral("Renderer");

qint64 residentKilobytes() {
    QFile file(QStringLiteral("/proc/self/statm"));
    if (!file.open(QIODevice::ReadOnly)) return 0;
    return QString::fromUtf8(file.readAll()).section(QLatin1Char(' '), 1, 1).toLongLong() *
           (::sysconf(_SC_PAGESIZE) / 1024);
}

qint64 difference(const QImage& a, const QImage& b) {
    qint64 sum = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
            sum +=
                std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q));
        }
    }
    return sum;
}

class ProgressiveTest : public GuiTest {
  protected:
    void TearDown() override {
        if (!window) return;
        window->close();
        window.reset();
        EXPECT_TRUE(childrenOf(::getpid(), kRenderer).isEmpty());
    }
    void open(int antialiasing) {
        window.emplace(name());
        window->preferences().set(pref::pictureScale, 25);
        window->preferences().set(pref::stillAntialiasing, antialiasing);
        window->preferences().set(pref::globalIllumination, false);
        window->resize(400, 320);
        window->show();
        window->activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&*window));
        window->open(file("room.obj"));
        ASSERT_TRUE(shows(window->session())) << window->notice().text().toStdString();
        ASSERT_TRUE(comes([&] { return window->session().status().idle; }));
    }
    bool renders() { return window->view().activity().contains(QLatin1String("rendering")); }
    /// The Renderer of the window; 0: there is none.
    static pid_t rendererProcess() { return childrenOf(::getpid(), kRenderer).value(0).process; }
    /// The view as the Renderer by itself renders it.
    QImage rendered(int antialiasing) {
        const QSize size = window->session().status().resolution;
        EXPECT_TRUE(ask(window->session(), command::exportScene(file("own.scn").toStdString())).done);
        EXPECT_TRUE(ask(window->session(), command::exportCamera(file("own.cam").toStdString(), size.width(),
                                                                 size.height(), antialiasing, 0))
                        .done);
        const ProgramResult result =
            renderer({"own.scn", "--camera=own.cam", "-o", "own.png"}, {.folder = folder().path()});
        EXPECT_EQ(result.exitCode, 0) << result.error;
        return QImage(file("own.png")).convertToFormat(QImage::Format_RGB32);
    }
    /// Until the eye has got used to the light, too.
    void look(const QString& camera) {
        ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set ") + camera).done);
        ASSERT_TRUE(ask(window->session(), QStringLiteral("wait-idle")).done);
    }
    QAction* action(ActionId id) { return window->actions()[id]; }

    std::optional<MainWindow> window;
};

TEST(PreviewPixels, ThoseWithoutASampleOfTheirOwnAreTheLiveOnes) {
    std::array<std::byte, 8> pixels{std::byte{1}, std::byte{2}, std::byte{3}, std::byte{255},
                                    std::byte{4}, std::byte{5}, std::byte{6}, std::byte{0}};
    const std::array<std::byte, 8> below{std::byte{7}, std::byte{7}, std::byte{7},  std::byte{255},
                                         std::byte{8}, std::byte{9}, std::byte{10}, std::byte{255}};
    toRgb32Over(pixels, below);
    const std::array<std::byte, 8> expected{std::byte{3}, std::byte{2}, std::byte{1},  std::byte{255},
                                            std::byte{8}, std::byte{9}, std::byte{10}, std::byte{255}};
    EXPECT_EQ(pixels, expected);
}

TEST_F(ProgressiveTest, AtRestThePictureBecomesTheRenderersOwn) {
    ASSERT_NO_FATAL_FAILURE(open(3));
    const QImage expected = rendered(3);
    EXPECT_TRUE(comes([&] { return window->view().picture() == expected; }))
        << window->notice().text().toStdString();
    EXPECT_NE(window->session().frame(), expected);
    EXPECT_TRUE(comes([&] { return !renders(); }));
    QTest::qWait(600);
    EXPECT_FALSE(renders()) << "once is enough";
    EXPECT_FALSE(window->view().showsLive());
}

TEST_F(ProgressiveTest, TheRendererKeepsTheModelForTheNextView) {
    ASSERT_NO_FATAL_FAILURE(open(2));
    rendered(2); // beside the model, where it may be one of its textures
    ASSERT_NO_FATAL_FAILURE(look(QStringLiteral("0.4 2 6 0 0 -1 60")));
    ASSERT_TRUE(comes([&] { return !window->view().showsLive() && !renders(); }));
    const pid_t first = rendererProcess();
    ASSERT_NE(first, 0);
    ASSERT_NO_FATAL_FAILURE(look(QStringLiteral("0.5 2 6 0 0 -1 60")));
    const QImage moved = rendered(2);
    EXPECT_TRUE(comes([&] { return window->view().picture() == moved; }));
    EXPECT_EQ(rendererProcess(), first);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("light 1 off")).done);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("wait-idle")).done);
    const QImage edited = rendered(2);
    EXPECT_NE(edited, moved);
    EXPECT_TRUE(comes([&] { return window->view().picture() == edited; })) << "with what was edited";
    EXPECT_EQ(rendererProcess(), first);
    window->preferences().set(pref::stillAntialiasing, 3);
    const QImage finer = rendered(3);
    EXPECT_TRUE(comes([&] { return window->view().picture() == finer; }));
    EXPECT_NE(rendererProcess(), first) << "other options need another";
    action(ActionId::AtRestLive)->trigger();
    EXPECT_TRUE(comes([&] { return rendererProcess() == 0; })) << "none is kept for nothing";
}

TEST_F(ProgressiveTest, QuickRenderIsTheRenderersPictureToo) {
    ASSERT_NO_FATAL_FAILURE(open(2));
    window->preferences().set(pref::progressiveRendering, false);
    ASSERT_TRUE(comes([&] { return !renders() && window->view().showsLive(); }));
    const QImage expected = rendered(2);
    action(ActionId::QuickRender)->trigger();
    EXPECT_TRUE(comes([&] { return window->view().picture() == expected; }));
}

TEST_F(ProgressiveTest, AKeyShowsTheLivePictureInTheSameFrameAndEndsTheRendering) {
    ASSERT_NO_FATAL_FAILURE(open(16));
    ASSERT_TRUE(comes([&] { return renders(); }));
    ASSERT_TRUE(comes([&] { return !window->view().showsLive(); })) << "it refines what is seen";
    QElapsedTimer clock;
    clock.start();
    QTest::keyPress(&window->view(), Qt::Key_W);
    EXPECT_TRUE(window->view().showsLive());
    EXPECT_LT(clock.elapsed(), 500) << "nothing is waited for";
    EXPECT_TRUE(comes([&] { return !renders(); }));
    QTest::keyRelease(&window->view(), Qt::Key_W);
    EXPECT_TRUE(comes([&] { return renders(); })) << "and once more, from there";
}

// On a busy machine a Renderer takes longer to die than the next one waits for its name.
TEST_F(ProgressiveTest, ANameThatIsNotFreeYetIsWaitedFor) {
    startServer();
    Session session;
    session.connectTo(name());
    ASSERT_TRUE(shows(session));
    const ModelCache models;
    PreviewProcess preview(session, models);
    QSignalSpy failures(&preview, &PreviewProcess::failed);
    bool done = false;
    QObject::connect(&preview, &PreviewProcess::refined, &preview,
                     [&](const QImage&, bool last) { done = last; });
    const ipc::Names names(preview.instance().toStdString());
    std::optional<ipc::Segment> dying = ipc::Segment::createLocked(names.control(), 0, ipc::kServerLock);
    ASSERT_TRUE(dying.has_value());
    preview.render({.antialiasing = 2});
    QTest::qWait(3000);
    EXPECT_FALSE(done);
    dying.reset();
    EXPECT_TRUE(comes([&] { return done; }));
    EXPECT_TRUE(failures.isEmpty()) << failures.front().front().toString().toStdString();
}

TEST_F(ProgressiveTest, SoDoesWhateverElseMovesTheCamera) {
    ASSERT_NO_FATAL_FAILURE(open(2));
    ASSERT_TRUE(comes([&] { return !window->view().showsLive(); }));
    ASSERT_NO_FATAL_FAILURE(look(QStringLiteral("0.5 2 6 0 0 -1 60")));
    const QImage expected = rendered(2);
    EXPECT_TRUE(comes([&] { return window->view().picture() == expected; }));
    ASSERT_TRUE(ask(window->session(), QStringLiteral("light 1 off")).done);
    EXPECT_TRUE(comes([&] { return window->view().picture() != expected; }));
}

TEST_F(ProgressiveTest, EitherSideSwitchesItOff) {
    ASSERT_NO_FATAL_FAILURE(open(2));
    ASSERT_TRUE(comes([&] { return !window->view().showsLive(); }));
    action(ActionId::AtRestLive)->trigger();
    EXPECT_TRUE(window->view().showsLive());
    QTest::qWait(700);
    EXPECT_FALSE(renders());
    ASSERT_TRUE(ask(window->session(), QStringLiteral("idle off")).done);
    action(ActionId::AtRestLive)->trigger();
    QTest::qWait(700);
    EXPECT_TRUE(window->view().showsLive());
    EXPECT_FALSE(renders());
    ASSERT_TRUE(ask(window->session(), QStringLiteral("idle on")).done);
    EXPECT_TRUE(comes([&] { return !window->view().showsLive(); }));
}

TEST_F(ProgressiveTest, APreviewIsNoServerToConnectTo) {
    ASSERT_NO_FATAL_FAILURE(open(16));
    ASSERT_TRUE(comes([&] { return renders(); }));
    bool found = false;
    ASSERT_TRUE(comes([&] {
        PreviewReader reader(previewInstance(0), 0);
        for (const RunningServer& each : runningServers())
            found = found || each.instance.startsWith(previewPrefix());
        return !window->view().showsLive();
    }));
    EXPECT_FALSE(found);
}

// An old image would be nearer to what was seen before.
TEST_F(ProgressiveTest, InterruptedAtAnyMomentItShowsNoOldPicture) {
    const char* const asked = std::getenv("RT_INTERRUPTIONS");
    const int rounds = asked == nullptr ? 20 : std::atoi(asked);
    ASSERT_NO_FATAL_FAILURE(open(12));
    const std::array places{QStringLiteral("0.5 2 6 0 0 -1 60"), QStringLiteral("0.5 2 6 0.4 -0.9 -1 60")};
    std::array<QImage, 2> live;
    for (std::size_t i = 0; i < 2; ++i) {
        ASSERT_NO_FATAL_FAILURE(look(places[i]));
        QTest::qWait(100);
        live[i] = window->session().frame().copy();
    }
    ASSERT_GT(difference(live[0], live[1]), 100000);

    std::mt19937 random(7);
    const auto upTo = [&](int max) { return static_cast<int>(random() % static_cast<unsigned>(max + 1)); };
    int shown = 0, old = 0;
    qint64 memory = 0;
    std::size_t here = 1;
    for (int round = 0; round < rounds; ++round) {
        if (round == 10) memory = residentKilobytes();
        const std::size_t there = 1 - here;
        bool arrived = false;
        window->session().send("camera set " + places[there].toStdString(), &*window,
                               [&](const Answer&) { arrived = true; });
        ASSERT_TRUE(comes([&] { return arrived; }));
        // The status of the new view comes with its frame.
        ASSERT_TRUE(comes([&] {
            return difference(window->session().frame(), live[there]) <
                   difference(window->session().frame(), live[here]);
        }));
        QElapsedTimer clock;
        clock.start();
        // Sometimes until there is something to interrupt, however busy the machine is.
        const bool patient = upTo(3) == 0;
        const int wait = upTo(700), before = shown;
        const void* seen = nullptr;
        while (clock.elapsed() < wait || (patient && shown == before && clock.elapsed() < kPatience)) {
            QTest::qWait(1);
            const QImage& picture = window->view().picture();
            if (picture.isNull() || picture.constBits() == seen) continue;
            seen = picture.constBits();
            ++shown;
            if (difference(picture, live[there]) >= difference(picture, live[here])) ++old;
        }
        if (upTo(1) == 0) {
            QTest::keyClick(&window->view(), Qt::Key_X); // bound to nothing: still a reason to look
            EXPECT_TRUE(window->view().showsLive());
        }
        here = there;
    }
    EXPECT_EQ(old, 0);
    EXPECT_GT(shown, rounds / 10);
    if (rounds > 10) {
        const qint64 grown = residentKilobytes() - memory;
        EXPECT_LT(grown, 16 * 1024);
        ::testing::Test::RecordProperty("kilobytesMore", static_cast<int>(grown));
    }
    ::testing::Test::RecordProperty("pictures", shown);
    action(ActionId::AtRestLive)->trigger();
    EXPECT_TRUE(comes([&] { return rendererProcess() == 0; })) << "none runs, and none is a zombie";
    EXPECT_LE(window->findChildren<QProcess*>().size(), 1) << "the server";
}

TEST_F(ProgressiveTest, WhenTheWindowIsKilledTheRendererIsGoneWithinASecond) {
    QSettings settings(QSettings::IniFormat, QSettings::UserScope, QStringLiteral("rtsuite"),
                       QStringLiteral("GUI"));
    settings.setValue(QLatin1String(pref::stillAntialiasing.name), 16);
    settings.sync();
    RunningProgram program(programPath("GUI"), {"room.obj", "--instance=" + instance.name()},
                           {.folder = folder().path()});
    pid_t gui = 0;
    ASSERT_TRUE(
        comes([&] { return (gui = childrenOf(::getpid(), QStringLiteral("GUI")).value(0).process) != 0; }));
    QList<Child> renderers;
    ASSERT_TRUE(comes([&] { return !(renderers = childrenOf(gui, kRenderer)).isEmpty(); }));
    const pid_t renderer = renderers.front().process;
    QTest::qWait(100);
    const pid_t served = childrenOf(gui, QStringLiteral("RTServer")).value(0).process;
    program.send(SIGKILL);
    EXPECT_TRUE(comes([&] { return !runs(renderer); }));
    program.wait();
    EXPECT_TRUE(comes([&] { return !runs(served); }));
}

} // namespace
