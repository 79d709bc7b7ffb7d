/// The image at rest by paths: how many samples it says it has, how it fades in, and what is saved of it.
#include "gui/window_support.h"

#include "gui/dialogs/statistics_dialog.h"
#include "gui/view/error_colours.h"

#include "common/frames/error_byte.h"

#include "rtcore/neural/net_files.h"
#include "rtcore/upsample/upsample.h"

#include <QClipboard>
#include <QElapsedTimer>
#include <QGuiApplication>
#include <QLabel>

#include <algorithm>
#include <array>
#include <functional>

namespace {

namespace rest_test {

using namespace test;
using namespace gui;

class RestTest : public WindowFixture {
  protected:
    void openByPaths(int samples) {
        window->preferences().set(pref::globalIllumination, true);
        window->preferences().set(pref::stillPathSamples, samples);
        ASSERT_NO_FATAL_FAILURE(open());
    }
    int samples() { return window->view().origin().samples; }
};

TEST_F(RestTest, SaysHowManySamplesItHas) {
    ASSERT_NO_FATAL_FAILURE(openByPaths(5));
    ASSERT_TRUE(comes([&] { return window->view().activity() == QStringLiteral("refined  ·  samples: 5"); }))
        << window->view().activity().toStdString();
    EXPECT_EQ(window->view().origin(), (PictureOrigin{true, 5}));
    action(ActionId::Statistics)->trigger();
    const auto* statistics = window->findChild<StatisticsDialog*>();
    ASSERT_NE(statistics, nullptr);
    const auto says = [&](const QString& words) {
        return comes([&] {
            for (const QLabel* label : statistics->findChildren<QLabel*>())
                if (label->text() == words) return true;
            return false;
        });
    };
    EXPECT_TRUE(says(QStringLiteral("path tracing, samples per pixel: 5")));
    window->preferences().set(pref::progressiveRendering, false);
    EXPECT_TRUE(says(QStringLiteral("live")));
}

TEST_F(RestTest, SamplesGrowUntilSomethingMoves) {
    ASSERT_NO_FATAL_FAILURE(openByPaths(1 << 20));
    int seen = 0, grown = 0;
    ASSERT_TRUE(comes([&] {
        if (samples() > seen) {
            ++grown;
            seen = samples();
        }
        EXPECT_GE(samples(), window->view().showsLive() ? 0 : seen);
        return grown >= 3;
    }));
    EXPECT_TRUE(window->view().activity().contains(QStringLiteral("samples: ")));
    QTest::keyPress(&window->view(), Qt::Key_W);
    EXPECT_TRUE(window->view().showsLive());
    EXPECT_FALSE(window->view().fades());
    EXPECT_FALSE(window->view().activity().contains(QStringLiteral("samples"))) << "at once";
    QTest::keyRelease(&window->view(), Qt::Key_W);
}

TEST_F(RestTest, WhatIsShownIsSavedAndSaysHowItWasMade) {
    ASSERT_NO_FATAL_FAILURE(openByPaths(3));
    ASSERT_TRUE(comes([&] { return samples() == 3 && !window->view().fades(); }));
    action(ActionId::Screenshot)->trigger();
    const QImage saved(file("screenshot-0001.png"));
    EXPECT_EQ(saved.convertToFormat(QImage::Format_RGB32), window->view().picture());
    EXPECT_EQ(saved.text(QStringLiteral("integrator")), QStringLiteral("path"));
    EXPECT_EQ(saved.text(QStringLiteral("samples")), QStringLiteral("3"));
    EXPECT_TRUE(saved.text(QStringLiteral("Software")).startsWith(QStringLiteral("rtsuite ")));
    EXPECT_TRUE(window->view().told().contains(QStringLiteral("path tracing, samples per pixel: 3")))
        << window->view().told().toStdString();

    action(ActionId::CopyImage)->trigger();
    EXPECT_EQ(QGuiApplication::clipboard()->image().convertToFormat(QImage::Format_RGB32),
              window->view().picture());
    EXPECT_TRUE(window->view().told().contains(QStringLiteral("path tracing")));

    window->preferences().set(pref::progressiveRendering, false);
    ASSERT_TRUE(window->view().showsLive());
    action(ActionId::CopyImage)->trigger();
    EXPECT_EQ(QGuiApplication::clipboard()->image().convertToFormat(QImage::Format_RGB32),
              window->session().frame().convertToFormat(QImage::Format_RGB32));
    EXPECT_EQ(window->view().told(), QStringLiteral("The live frame was copied."));
}

// One sees the light that one is about to edit.
TEST_F(RestTest, StaysWhenAPanelOpensUntilThereIsOneAsGood) {
    window->resize(900, 500);
    constexpr int kSamples = 12;
    ASSERT_NO_FATAL_FAILURE(openByPaths(kSamples));
    ASSERT_TRUE(comes([&] { return samples() == kSamples && !window->view().fades(); }));
    const QImage before = window->view().picture();
    bool lost = false, worse = false;
    const auto watch = [&] {
        lost = lost || window->view().showsLive();
        worse = worse || samples() < kSamples;
    };
    QObject::connect(&window->session(), &Session::frameChanged, &window->view(), watch);
    action(ActionId::LightsPanel)->trigger();
    ASSERT_TRUE(comes([&] {
        watch();
        return window->view().picture().size() != before.size();
    }));
    EXPECT_FALSE(lost);
    EXPECT_FALSE(worse);
    EXPECT_EQ(window->view().picture().size(), status().resolution);
    EXPECT_LT(window->view().picture().width(), before.width());
}

TEST_F(RestTest, WhatIsKeptOverAChangeOfSizeGoesWithTheFirstEditOrMovement) {
    window->resize(900, 500);
    ASSERT_NO_FATAL_FAILURE(openByPaths(1 << 20));
    const auto keepOne = [&] {
        ASSERT_TRUE(comes([&] { return !window->view().showsLive() && samples() >= 8; }));
        const QSize size = status().resolution;
        action(ActionId::LightsPanel)->trigger();
        ASSERT_TRUE(comes([&] { return status().resolution != size; }));
        QTest::qWait(50);
        ASSERT_FALSE(window->view().showsLive());
        ASSERT_EQ(window->view().picture().size(), size);
    };
    ASSERT_NO_FATAL_FAILURE(keepOne());
    window->editor().setSetting(QStringLiteral("shadows"), QStringLiteral("false"));
    EXPECT_TRUE(window->view().showsLive()) << "at once";
    ASSERT_NO_FATAL_FAILURE(keepOne());
    QTest::keyClick(&window->view(), Qt::Key_W);
    EXPECT_TRUE(window->view().showsLive());
    ASSERT_NO_FATAL_FAILURE(keepOne());
    ASSERT_TRUE(ask(window->session(), std::string("camera turn 20 0")).done);
    EXPECT_TRUE(comes([&] { return window->view().showsLive(); })) << "by another client";
    ASSERT_NO_FATAL_FAILURE(keepOne());
    ASSERT_TRUE(ask(window->session(), std::string("set reflections false")).done);
    EXPECT_TRUE(comes([&] { return window->view().showsLive(); })) << "an edit of another client";
}

TEST_F(RestTest, StaysWhateverIsWrittenBesideIt) {
    window->resize(900, 500);
    ASSERT_NO_FATAL_FAILURE(openByPaths(1 << 20));
    ASSERT_TRUE(comes([&] { return !window->view().showsLive() && samples() >= 8; }));
    bool lost = false;
    const auto watch = [&] { lost = lost || window->view().showsLive(); };
    QObject::connect(&window->session(), &Session::statusChanged, &window->view(), watch);
    QObject::connect(&window->session(), &Session::frameChanged, &window->view(), watch);
    QObject::connect(&window->editor(), &SceneEditor::stateChanged, &window->view(), watch);
    const auto write = [&](int edits) {
        window->editor().edit("note add 0 0 0 dark");
        ASSERT_TRUE(ask(window->session(), std::string("note text 1 bright")).done);
        ASSERT_TRUE(ask(window->session(), std::string("measure keep distance 0 0 0 1 0 0")).done);
        window->editor().edit("note remove 1");
        ASSERT_TRUE(comes([&] { return window->editor().state().edits == edits; }));
        watch();
    };
    const int before = samples(), edits = window->editor().state().edits;
    ASSERT_NO_FATAL_FAILURE(write(edits + 4));
    EXPECT_TRUE(comes([&] { return samples() > before; }));
    EXPECT_FALSE(lost);
    action(ActionId::LightsPanel)->trigger(); // it is kept over the change of size
    ASSERT_NO_FATAL_FAILURE(write(edits + 8));
    EXPECT_FALSE(lost);
    ASSERT_TRUE(ask(window->session(), std::string("set reflections false")).done);
    EXPECT_TRUE(comes([&] { return lost; }));
}

// Frames of the new size and frames of an edit look alike.
TEST_F(RestTest, AnEditBeforeTheServerHasTheNewSizeIsSeen) {
    window->resize(900, 500);
    ASSERT_NO_FATAL_FAILURE(openByPaths(1 << 20));
    const auto editOnceAsked = [&](const std::function<void()>& edit) {
        ASSERT_TRUE(comes([&] { return !window->view().showsLive() && samples() >= 8; }));
        bool asked = false;
        const auto connection =
            QObject::connect(&window->view(), &FrameView::resolutionWanted, &*window, [&] {
                edit();
                asked = true;
            });
        action(ActionId::LightsPanel)->trigger();
        while (!asked) QTest::qWait(1);
        QObject::disconnect(connection);
    };
    ASSERT_NO_FATAL_FAILURE(editOnceAsked([&] {
        window->editor().setSetting(QStringLiteral("shadows"), QStringLiteral("false"));
        EXPECT_TRUE(window->view().showsLive()) << "at once";
    }));
    ASSERT_NO_FATAL_FAILURE(
        editOnceAsked([&] { window->session().send(std::string("set reflections false")); }));
    EXPECT_TRUE(comes([&] { return window->view().showsLive(); })) << "an edit of another client";
}

TEST_F(RestTest, TellsTheErrorThatANetLeavesAndColoursTheImageByIt) {
    if (rtcore::findNet(rtcore::fileOf(rtcore::Net::Base), {}, RT_PROGRAM_FOLDER).file.empty())
        GTEST_SKIP() << "skipped: there are no weights beside the build";
    ASSERT_NO_FATAL_FAILURE(openByPaths(16));
    FrameView& view = window->view();
    ASSERT_TRUE(comes([&] { return samples() == 16 && !view.fades(); }));
    EXPECT_GT(view.origin().error, 0);
    EXPECT_GE(view.origin().largestError, view.origin().error);
    EXPECT_TRUE(view.activity().contains(QStringLiteral("±"))) << view.activity().toStdString();
    EXPECT_EQ(view.errors().size(), view.picture().size());
    const QImage plain = view.grab().toImage();
    action(ActionId::ShowErrors)->trigger();
    EXPECT_NE(view.grab().toImage(), plain);
    action(ActionId::ShowErrors)->trigger();
    EXPECT_EQ(view.grab().toImage(), plain);
    action(ActionId::ShowErrors)->trigger();
    action(ActionId::Screenshot)->trigger();
    const QImage saved(file("screenshot-0001.png"));
    EXPECT_EQ(saved.convertToFormat(QImage::Format_RGB32), view.picture()) << "without colours";
    EXPECT_TRUE(saved.text(QStringLiteral("denoising")).contains(QStringLiteral(" of 255, largest ")));
}

class FadeTest : public GuiTest {
  protected:
    void SetUp() override {
        GuiTest::SetUp();
        startServer();
        session.connectTo(name());
        ASSERT_TRUE(shows(session));
        view.emplace(session);
        view->setShowOverlay(false);
        view->setIgnoreAspectRatio(true);
        view->resize(160, 120);
        view->show();
        still = QImage(view->devicePixels(), QImage::Format_RGB32);
        still.fill(QColor(250, 10, 250));
    }
    QImage grabbed() { return view->grab().toImage().convertToFormat(QImage::Format_RGB32); }
    using Channel = int (*)(QRgb);
    static constexpr std::array<Channel, 3> kChannels{&qRed, &qGreen, &qBlue};
    /// Whether each channel of `image` lies between those of the others; one level is rounding.
    static bool isBetween(const QImage& image, const QImage& a, const QImage& b) {
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                for (const Channel channel : kChannels) {
                    const auto [low, high] = std::minmax({channel(a.pixel(x, y)), channel(b.pixel(x, y))});
                    const int value = channel(image.pixel(x, y));
                    if (value < low - 1 || value > high + 1) return false;
                }
            }
        }
        return true;
    }

    Session session;
    std::optional<FrameView> view;
    QImage still;
};

TEST_F(FadeTest, ErrorsColourWhatIsSeenOfThem) {
    view->showPicture(still);
    const QImage plain = grabbed();
    QImage errors(still.size(), QImage::Format_Grayscale8);
    errors.fill(app::errorByte(0.1F));
    for (int y = 16; y < 64; ++y) std::fill_n(errors.scanLine(y) + 64, 48, app::errorByte(30));
    view->setShowErrors(true);
    EXPECT_EQ(grabbed(), plain) << "none are known";
    view->showPicture(still, {}, errors);
    const QImage coloured = colouredByErrors(still, errors);
    EXPECT_EQ(coloured.pixelColor(0, 0).saturation(), 0) << "grey where nothing is seen";
    const QColor large = coloured.pixelColor(88, 40);
    EXPECT_GT(large.red(), large.blue() + 60);
    EXPECT_NE(grabbed(), plain);
    EXPECT_EQ(view->shown(), still);
    EXPECT_TRUE(colouredByErrors(still, QImage(3, 3, QImage::Format_Grayscale8)).isNull())
        << "of another size";
    view->showLive();
    EXPECT_TRUE(view->errors().isNull());
}

TEST_F(FadeTest, ByPathsItFadesInAndEndsOnItsOwnPixels) {
    const QImage live = grabbed();
    QElapsedTimer clock;
    clock.start();
    view->showPicture(still, {true, 1});
    EXPECT_TRUE(view->fades());
    EXPECT_EQ(view->picture(), still);
    ASSERT_TRUE(comes([&] {
        const QImage now = grabbed();
        EXPECT_TRUE(isBetween(now, live, still));
        return now != live && now != still;
    })) << "something between";
    QImage better = still;
    better.fill(QColor(240, 20, 240));
    view->showPicture(better, {true, 2});
    ASSERT_TRUE(comes([&] { return !view->fades(); }));
    EXPECT_GE(clock.elapsed(), 290);
    EXPECT_EQ(grabbed(), better);
    view->showPicture(still, {true, 4});
    EXPECT_FALSE(view->fades()) << "the light is the same as before";
}

TEST_F(FadeTest, AMovementEndsItAtOnce) {
    const QImage live = grabbed();
    view->showPicture(still, {true, 1});
    ASSERT_TRUE(comes([&] { return grabbed() != live; }));
    view->showLive();
    EXPECT_FALSE(view->fades());
    EXPECT_EQ(grabbed(), live);
}

TEST_F(FadeTest, TheSameLightNeedsNone) {
    view->showPicture(still, {false, 4});
    EXPECT_FALSE(view->fades());
    EXPECT_EQ(grabbed(), still);
}

// Smooth scaling: without it, each pixel of a smaller frame is a square.
TEST_F(FadeTest, ASmallFrameShowsNoSquares) {
    constexpr int kBlock = 4;
    QImage small(view->devicePixels() / kBlock, QImage::Format_RGB32);
    for (int y = 0; y < small.height(); ++y) {
        for (int x = 0; x < small.width(); ++x)
            small.setPixelColor(x, y, (x * 7 + y * 5) % 11 < 4 ? QColor(250, 20, 40) : QColor(10, 120, 200));
    }
    const auto stepsWithinSquares = [&] {
        const QImage image = grabbed();
        int steps = 0;
        for (int x = 1; x < image.width(); ++x)
            steps += x % kBlock != 0 && image.pixel(x, 60) != image.pixel(x - 1, 60) ? 1 : 0;
        return steps;
    };
    view->setSmoothTransformation(false);
    view->showPicture(small, {false, 1});
    EXPECT_EQ(stepsWithinSquares(), 0);
    view->setSmoothTransformation(true);
    EXPECT_GT(stepsWithinSquares(), 80);
    rtcore::LdrImage wanted(160, 120), pixels(small.width(), small.height());
    for (int y = 0; y < small.height(); ++y) {
        for (int x = 0; x < small.width(); ++x) {
            const QColor colour = small.pixelColor(x, y);
            const auto byte = [](int value) { return static_cast<std::uint8_t>(value); };
            pixels.at(x, y) = {byte(colour.red()), byte(colour.green()), byte(colour.blue())};
        }
    }
    rtcore::upsample(pixels, 1, wanted);
    const QImage shown = grabbed();
    for (int y = 0; y < 120; y += 7) {
        for (int x = 0; x < 160; x += 7)
            EXPECT_EQ(shown.pixelColor(x, y).green(), wanted.at(x, y).g) << "along edges";
    }
}

} // namespace rest_test

} // namespace
