/// Flights: their panel alone, and making and playing them with a real server.
#include "gui/dialog_support.h"
#include "gui/jobs_support.h"
#include "gui/window_support.h"

#include "gui/dialogs/render_dialog.h"
#include "gui/models/plain_text.h"
#include "gui/operations/job_operations.h"
#include "gui/operations/scene_editor.h"
#include "gui/panels/flight_keys.h"
#include "gui/panels/flight_player.h"
#include "gui/panels/flights_panel.h"
#include "gui/panels/value_box.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QTableWidget>

#include <gtest/gtest.h>

namespace gui {
namespace {

using test::comes;

SceneState flownState() {
    SceneState state;
    state.flights = {
        {.name = QStringLiteral("<b>in & out</b>"),
         .seconds = 12.5,
         .closed = true,
         .keyCount = 3,
         .keyTimes = {0, 5000, 12500}},
        {.name = QStringLiteral("walk"),
         .seconds = 4,
         .timing = rtcore::FlightTiming::Times,
         .keyCount = 2,
         .keyTimes = {0, 4000}},
        {.name = QStringLiteral("round"), .seconds = 10, .turntable = true, .keyCount = 1, .keyTimes = {0}}};
    return state;
}

class FlightsPanelTest : public testing::Test {
  protected:
    FlightsPanelTest() {
        const auto take = [this](const std::string& line) { lines.push_back(line); };
        QObject::connect(&panel, &FlightsPanel::wanted, &panel, take);
        QObject::connect(&panel, &FlightsPanel::edited, &panel,
                         [take](const QString&, const std::string& line) { take(line); });
        const auto tell = [take](const char* what) {
            return [take, what](const QString& name, double seconds) {
                take(what + name.toStdString() + ' ' + QString::number(seconds).toStdString());
            };
        };
        QObject::connect(&panel, &FlightsPanel::goWanted, &panel, tell("go "));
        QObject::connect(&panel, &FlightsPanel::playWanted, &panel, tell("play "));
        QObject::connect(&panel, &FlightsPanel::stopWanted, &panel, [take] { take("stop"); });
        QObject::connect(&panel, &FlightsPanel::keyWanted, &panel,
                         [take](const QString& name) { take("key " + name.toStdString()); });
        QObject::connect(&panel, &FlightsPanel::filmWanted, &panel,
                         [take](const QString& name) { take("film " + name.toStdString()); });
    }
    void type(const QString& name) {
        panel.list().item(0, 0)->setText(name);
        QCoreApplication::processEvents(); // the list is done with its editor
    }
    QString cell(int row, int column) { return panel.list().item(row, column)->text(); }

    FlightsPanel panel;
    std::vector<std::string> lines;
};

TEST_F(FlightsPanelTest, ShowsNamesAsText) {
    EXPECT_FALSE(panel.removal().isEnabled());
    panel.show(flownState());
    ASSERT_EQ(panel.list().rowCount(), 3);
    EXPECT_EQ(cell(0, 0), QStringLiteral("<b>in & out</b>"));
    EXPECT_EQ(cell(0, 1), QStringLiteral("12.5"));
    EXPECT_EQ(cell(0, 2), QStringLiteral("3"));
    EXPECT_EQ(cell(2, 2), QStringLiteral("turntable"));
    EXPECT_EQ(panel.list().item(0, 0)->toolTip(), plainTip(QStringLiteral("<b>in & out</b>")));
    EXPECT_EQ(panel.selected(), QStringLiteral("<b>in & out</b>"));
    EXPECT_EQ(panel.keys().list().count(), 3);
    EXPECT_EQ(panel.keys().list().item(1)->text(), QStringLiteral("2: at 5.0 s"));
    EXPECT_EQ(panel.player().slider().maximum(), 12500);
    EXPECT_TRUE(panel.closing().isChecked());
    EXPECT_EQ(panel.seconds().value(), 12.5);
    EXPECT_TRUE(lines.empty()) << lines[0];
}

TEST_F(FlightsPanelTest, OffersWhatTheFlightTakes) {
    panel.show(flownState());
    EXPECT_FALSE(panel.passing().isEnabled()) << "the scene has no bookmarks";
    panel.keys().list().setCurrentRow(1);
    EXPECT_FALSE(panel.keys().time().isEnabled()) << "it is even";
    panel.select(QStringLiteral("walk"));
    EXPECT_FALSE(panel.closing().isEnabled());
    EXPECT_FALSE(panel.keys().time().isEnabled()) << "the first is at 0";
    panel.keys().list().setCurrentRow(1);
    EXPECT_TRUE(panel.keys().time().isEnabled());
    EXPECT_FALSE(panel.keys().movingDown().isEnabled());
    panel.select(QStringLiteral("round"));
    EXPECT_FALSE(panel.keys().adding().isEnabled());
    EXPECT_FALSE(panel.closing().isEnabled());
    SceneState state = flownState();
    state.bookmarks = QStringList{QStringLiteral("a")};
    panel.show(state);
    EXPECT_TRUE(panel.passing().isEnabled());
    EXPECT_TRUE(lines.empty()) << lines[0];
}

TEST_F(FlightsPanelTest, SendsWhatButtonsAndFieldsSay) {
    SceneState state = flownState();
    state.flights[0].name = QStringLiteral("Flight 1");
    state.bookmarks = QStringList{QStringLiteral("a")};
    panel.show(state);
    panel.making().click();
    panel.turning().click();
    panel.passing().click();
    panel.filming().click();
    panel.seconds().setValue(20);
    panel.closing().click();
    panel.timing().setCurrentIndex(1);
    emit panel.timing().activated(1);
    panel.removal().click();
    EXPECT_EQ(lines,
              (std::vector<std::string>{"key Flight 2", "flight turntable \"Turntable 1\" 10",
                                        "flight through \"Views 1\" 10", "film Flight 1",
                                        "flight seconds \"Flight 1\" 20", "flight closed \"Flight 1\" off",
                                        "flight timing \"Flight 1\" times", "flight remove \"Flight 1\""}));
}

TEST_F(FlightsPanelTest, SendsWhatIsToBeDoneWithKeyFrames) {
    panel.show(flownState());
    panel.select(QStringLiteral("walk"));
    FlightKeys& keys = panel.keys();
    keys.list().setCurrentRow(1);
    keys.adding().click();
    keys.replacing().click();
    emit keys.list().itemActivated(keys.list().item(1));
    EXPECT_EQ(panel.player().seconds(), 4);
    keys.time().setValue(3);
    keys.movingUp().click();
    EXPECT_EQ(keys.selected(), 0) << "it goes with the key frame";
    keys.movingDown().click();
    keys.removal().click();
    EXPECT_EQ(lines, (std::vector<std::string>{"key walk", "flight key set walk 2", "go walk 4",
                                               "flight key time walk 2 3", "flight key move walk 2 1",
                                               "flight key move walk 1 2", "flight key remove walk 2"}));
}

TEST_F(FlightsPanelTest, PlaysFromTheSlider) {
    panel.show(flownState());
    FlightPlayer& player = panel.player();
    player.slider().setValue(2500);
    player.button().click();
    player.setPlaying(true);
    player.button().click();
    player.setPlaying(false);
    player.showSeconds(12.5);
    player.button().click();
    EXPECT_EQ(lines, (std::vector<std::string>{"go <b>in & out</b> 2.5", "play <b>in & out</b> 2.5", "stop",
                                               "play <b>in & out</b> 0"}));
}

TEST_F(FlightsPanelTest, GoesWhereTheSliderIsClicked) {
    panel.show(flownState());
    panel.resize(400, 700);
    panel.QWidget::show();
    QSlider& slider = panel.player().slider();
    QTest::mouseClick(&slider, Qt::LeftButton, {}, slider.rect().center());
    EXPECT_NEAR(slider.value(), 6250, 250);
    EXPECT_FALSE(slider.isSliderDown());
    EXPECT_EQ(lines.size(), 1U);
}

TEST_F(FlightsPanelTest, LeavesOneSelectedByAClickBelowTheRows) {
    panel.show(flownState());
    panel.resize(400, 700);
    panel.QWidget::show();
    QWidget* area = panel.list().viewport();
    QTest::mouseClick(area, Qt::LeftButton, {}, QPoint(area->width() / 2, area->height() - 2));
    QCoreApplication::processEvents();
    EXPECT_EQ(panel.list().selectedItems().size(), 3);
    EXPECT_EQ(panel.selected(), QStringLiteral("<b>in & out</b>"));
}

TEST_F(FlightsPanelTest, KeepsTheSelectedOneThroughChanges) {
    SceneState state = flownState();
    panel.show(state);
    panel.select(QStringLiteral("walk"));
    panel.player().showSeconds(1);
    state.flights.erase(state.flights.begin());
    panel.show(state);
    EXPECT_EQ(panel.selected(), QStringLiteral("walk"));
    EXPECT_EQ(panel.player().seconds(), 1);
    type(QStringLiteral(" the walk "));
    EXPECT_EQ(lines, (std::vector<std::string>{"flight rename walk \"the walk\""}));
    panel.refused();
    EXPECT_EQ(cell(0, 0), QStringLiteral("walk"));
    type(QStringLiteral(" "));
    EXPECT_EQ(cell(0, 0), QStringLiteral("walk"));
    EXPECT_EQ(lines.size(), 1U);
    panel.making().click();
    state.flights.push_back(
        {.name = QStringLiteral("Flight 1"), .seconds = 10, .keyCount = 1, .keyTimes = {0}});
    panel.show(state);
    EXPECT_EQ(panel.selected(), QStringLiteral("Flight 1"));
    EXPECT_EQ(panel.player().seconds(), 0);
    state.flights.back().keyCount = 2;
    state.flights.back().keyTimes = {0, 10000};
    panel.show(state);
    EXPECT_EQ(panel.keys().selected(), 1) << "the new one";
    panel.show(SceneState());
    EXPECT_EQ(panel.selected(), QString());
    EXPECT_EQ(panel.keys().list().count(), 0);
}

class FlightsOfAServer : public test::WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        openAndRest();
    }
    FlightsPanel& panel() { return *window->findChild<FlightsPanel*>(); }
    const std::vector<ShownFlight>& flights() { return window->editor().state().flights; }
    void look(double x) {
        const QVector3D before = status().view.eye;
        ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set %1 2 5 0 0 -1 50").arg(x)).done);
        ASSERT_TRUE(comes([&] { return status().view.eye != before && status().idle; }));
    }
    bool hasKeys(int count) {
        return comes([&] { return !flights().empty() && flights()[0].keyCount == count; });
    }
    /// From x = -1 to x = 1.
    void makeFlight() {
        ASSERT_NO_FATAL_FAILURE(look(-1));
        action(ActionId::AddKeyFrame)->trigger();
        ASSERT_TRUE(hasKeys(1));
        ASSERT_NO_FATAL_FAILURE(look(1));
        action(ActionId::AddKeyFrame)->trigger();
        ASSERT_TRUE(hasKeys(2));
    }
};

TEST_F(FlightsOfAServer, AreMadeOfViewsAndTakenBack) {
    ASSERT_NO_FATAL_FAILURE(makeFlight());
    EXPECT_EQ(flights()[0].name, QStringLiteral("Flight 1"));
    EXPECT_EQ(flights()[0].keyTimes, (std::vector<int>{0, 10000}));
    EXPECT_EQ(window->view().told(), QStringLiteral("Key frame 2 of Flight 1"));
    EXPECT_EQ(panel().selected(), QStringLiteral("Flight 1"));
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(hasKeys(1));
    panel().removal().click();
    EXPECT_TRUE(comes([&] { return flights().empty(); }));
}

TEST_F(FlightsOfAServer, GetKeyFramesByAKeyWhileOneWalks) {
    window->view().input().capture();
    QTest::keyClick(&window->view(), Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_TRUE(hasKeys(1));
    EXPECT_TRUE(window->view().input().captured());
}

TEST_F(FlightsOfAServer, AreScrubbedInOneStep) {
    ASSERT_NO_FATAL_FAILURE(makeFlight());
    const int edits = window->editor().state().edits;
    QSlider& slider = panel().player().slider();
    slider.setSliderDown(true);
    for (int time = 9000; time > 5000; time -= 100) slider.setValue(time);
    QTest::qWait(static_cast<int>(SceneEditor::kOneGesture) + 100);
    slider.setValue(5000);
    slider.setSliderDown(false);
    EXPECT_TRUE(comes([&] { return std::abs(status().view.eye.x()) < 1e-3F; })) << "in the middle";
    EXPECT_TRUE(comes([&] { return window->editor().state().edits == edits + 1; }));
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(comes([&] { return std::abs(status().view.eye.x() - 1) < 1e-3F; }));
}

TEST_F(FlightsOfAServer, ArePlayedUntilTheyAreStopped) {
    ASSERT_NO_FATAL_FAILURE(makeFlight());
    FlightPlayer& player = panel().player();
    player.button().click();
    ASSERT_TRUE(comes([&] { return player.playing(); }));
    EXPECT_TRUE(comes([&] { return player.seconds() > 0 && status().view.eye.x() < -0.5F; }));
    player.button().click();
    EXPECT_FALSE(player.playing());
    ASSERT_TRUE(comes([&] { return status().idle; }));
    EXPECT_LT(status().view.eye.x(), 1);
    player.button().click();
    ASSERT_TRUE(comes([&] { return player.playing(); }));
    emit window->view().input().keyPressed('W');
    EXPECT_FALSE(player.playing()) << "moving ends it";
    ASSERT_TRUE(ask(window->session(), QStringLiteral("play stop")).done);
}

TEST_F(FlightsOfAServer, AreRenamedAndRefusedBySentences) {
    ASSERT_NO_FATAL_FAILURE(makeFlight());
    panel().player().showSeconds(4);
    panel().list().item(0, 0)->setText(QStringLiteral("to the <i>altar</i>"));
    EXPECT_TRUE(comes([&] { return flights()[0].name == QStringLiteral("to the <i>altar</i>"); }));
    EXPECT_EQ(panel().selected(), QStringLiteral("to the <i>altar</i>"));
    EXPECT_EQ(panel().player().seconds(), 4) << "it is the same one";
    panel().turning().click();
    ASSERT_TRUE(comes([&] { return flights().size() == 2; }));
    panel().list().item(0, 0)->setText(QStringLiteral("Turntable 1"));
    EXPECT_TRUE(
        comes([&] { return panel().list().item(0, 0)->text() == QStringLiteral("to the <i>altar</i>"); }));
    EXPECT_EQ(flights().size(), 2U);
}

TEST_F(FlightsOfAServer, BecomeFilms) {
    ASSERT_NO_FATAL_FAILURE(makeFlight());
    panel().filming().click();
    auto* dialog = window->findChild<RenderDialog*>();
    ASSERT_NE(dialog, nullptr);
    EXPECT_EQ(dialog->source(), RenderDialog::Source::Flight);
    EXPECT_TRUE(dialog->arguments().contains(QStringLiteral("--flight=Flight 1")));
    EXPECT_TRUE(dialog->arguments().contains(QStringLiteral("--fps=25")));
    EXPECT_TRUE(dialog->arguments().contains(QStringLiteral("--video=") + file("Flight 1-0001.mp4")));
    // Images, since a machine for tests may be without ffmpeg.
    test::field<QLineEdit>(*dialog, "Film")->clear();
    test::field<QLineEdit>(*dialog, "Output file")->setText(file("frame_####.png"));
    test::field<QLineEdit>(*dialog, "Frames")->setText(QStringLiteral("251"));
    test::field<ValueBox>(*dialog, "Frames per second")->setValue(30);
    EXPECT_TRUE(dialog->arguments().contains(QStringLiteral("--fps=30")));
    test::accept(*dialog);
    JobQueue& queue = window->findChild<JobOperations*>()->queue();
    ASSERT_TRUE(comes([&] { return queue.rowCount() == 1 && !queue.busy(); }));
    EXPECT_EQ(queue.job(0).state, JobState::Done) << queue.job(0).log.toStdString();
    EXPECT_TRUE(QFile::exists(file("frame_0251.png")));
}

} // namespace
} // namespace gui
