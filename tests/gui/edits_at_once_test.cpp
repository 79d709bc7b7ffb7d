/// Edits of the window and of CUI at once, all taken back and made again. RT_EDITS: how many.
#include "gui/lit_scene.h"
#include "gui/window_support.h"

#include "common/commands/state_report.h"
#include "gui/operations/scene_editor.h"

#include <QProcess>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <random>

namespace gui {
namespace {

using test::comes;

class EditsAtOnce : public test::WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        test::writeLitScene(folder());
        openAndRest("lit.scn");
    }
    const SceneState& state() { return window->editor().state(); }
    QStringList command(const QString& line) {
        return QStringList{QStringLiteral("--instance=") + name()} + line.split(QLatin1Char(' '));
    }
    QByteArray run(const QString& line) {
        QProcess cui;
        cui.start(QString::fromStdString(test::programPath("CUI")), command(line));
        EXPECT_TRUE(comes([&] { return cui.state() == QProcess::NotRunning; })) << line.toStdString();
        EXPECT_EQ(cui.exitCode(), 0) << line.toStdString() << cui.readAllStandardError().toStdString();
        return cui.readAllStandardOutput();
    }
    /// As the server counts them: on a busy machine the window learns of those of others later.
    int madeEdits() { return app::parseStateReport(run(QStringLiteral("state")).toStdString()).edits; }
    /// All that can be seen and saved of what is shown.
    std::string shown() {
        run(QStringLiteral("wait-idle"));
        run(QStringLiteral("screenshot ") + file("shown.png"));
        run(QStringLiteral("export scene ") + file("shown.scn"));
        const std::string all =
            test::readBytes(folder() / "shown.png") + test::readBytes(folder() / "shown.scn");
        std::filesystem::remove(folder() / "shown.png");
        std::filesystem::remove(folder() / "shown.scn");
        return all;
    }
    QString number(int min, int max) {
        return QString::number(std::uniform_int_distribution<int>(min, max)(random_));
    }
    QString oneOf(const QStringList& words) {
        return words[std::uniform_int_distribution<qsizetype>(0, words.size() - 1)(random_)];
    }
    /// An edit of any kind; one that does not fit the scene is refused.
    QString randomEdit() {
        const QStringList kinds{
            QStringLiteral("set maxDepth ") + number(1, 6),
            QStringLiteral("set shadows ") + oneOf({QStringLiteral("true"), QStringLiteral("false")}),
            QStringLiteral("set exposure.value 1.") + number(0, 9),
            QStringLiteral("light 1 toggle"),
            QStringLiteral("light power 2 ") + number(10, 900),
            QStringLiteral("light move 1 at ") + number(-4, 4) + QStringLiteral(" 5 ") + number(-4, 4),
            QStringLiteral("light temperature 1 ") + number(2000, 9000),
            QStringLiteral("light add ") + oneOf({QStringLiteral("point"), QStringLiteral("sphere")}),
            QStringLiteral("light remove ") + number(1, 9),
            QStringLiteral("environment ") + number(1, 3),
            QStringLiteral("environment rotation ") + number(-180, 180),
            QStringLiteral("sky hour ") + number(6, 18),
            QStringLiteral("sky turbidity ") + number(2, 9),
            QStringLiteral("sky ") + oneOf({QStringLiteral("on"), QStringLiteral("off")}),
            QStringLiteral("sky ground ") + oneOf({QStringLiteral("on"), QStringLiteral("off")}),
            QStringLiteral("look ") +
                oneOf({QStringLiteral("sky"), QStringLiteral("studio"), QStringLiteral("headlight")}),
            QStringLiteral("material set 1 roughness 0.") + number(1, 9),
            QStringLiteral("material set 1 diffuse 0.") + number(1, 9) + QStringLiteral(" 0.5 0.2"),
            QStringLiteral("material reset 1"),
            QStringLiteral("part hide ") + number(1, 3),
            QStringLiteral("part show-all"),
            QStringLiteral("up ") + oneOf({QStringLiteral("+y"), QStringLiteral("+z")}),
            QStringLiteral("units ") + oneOf({QStringLiteral("m"), QStringLiteral("cm")}),
            QStringLiteral("camera set ") + number(-3, 3) + QStringLiteral(" 1.5 6 0 0 -1"),
            QStringLiteral("bookmark add b") + number(1, 5),
        };
        return oneOf(kinds);
    }
    /// One after the other by programs of their own, while the window's go on.
    void sendByCui(int count) {
        for (int i = 0; i < count; ++i) lines_.append(randomEdit());
        QObject::connect(&cui_, &QProcess::finished, &cui_, [this] { sendNext(); });
        sendNext();
    }
    void sendNext() {
        if (lines_.isEmpty()) return;
        cui_.start(QString::fromStdString(test::programPath("CUI")), command(lines_.takeFirst()));
    }
    void sendByWindow(int count) {
        int answered = 0, done = 0;
        for (int i = 0; i < count; ++i) {
            window->editor().edit(randomEdit().toStdString(), [&](const Answer& answer) {
                ++answered;
                done += answer.done ? 1 : 0;
            });
            ASSERT_TRUE(comes([&] { return answered > i; }));
        }
        EXPECT_GT(done, count / 2);
    }
    bool sent() {
        return comes([&] { return lines_.isEmpty() && cui_.state() == QProcess::NotRunning; }, 600'000);
    }
    void go(ActionId id) {
        const bool forth = id == ActionId::Redo;
        for (;;) {
            const QString what = forth ? window->editor().redoText() : window->editor().undoText();
            if (what.isEmpty()) return;
            const int before = state().edits;
            action(id)->trigger();
            ASSERT_TRUE(comes([&] { return state().edits == before + (forth ? 1 : -1); }))
                << what.toStdString();
        }
    }

    std::mt19937 random_{20261};
    QStringList lines_;
    QProcess cui_;
};

TEST_F(EditsAtOnce, OfTheWindowAndOfCuiAreTakenBackToTheFirstBits) {
    const char* const wanted = std::getenv("RT_EDITS");
    const int edits = wanted != nullptr ? std::atoi(wanted) : 60;
    const std::string first = shown();
    sendByCui(edits / 2);
    sendByWindow(edits - edits / 2);
    ASSERT_TRUE(sent());
    ASSERT_TRUE(comes([&] { return !window->editor().undoText().isEmpty(); }));
    const std::string last = shown();
    EXPECT_NE(last, first);
    const int made = madeEdits();
    ASSERT_TRUE(comes([&] { return state().edits == made; }));
    EXPECT_GT(made, edits / 4);
    RecordProperty("edits", made);
    go(ActionId::Undo);
    EXPECT_EQ(state().edits, 0);
    EXPECT_FALSE(state().modified);
    EXPECT_TRUE(shown() == first) << "after " << made << " edits";
    go(ActionId::Redo);
    EXPECT_EQ(state().edits, made);
    EXPECT_TRUE(shown() == last) << "after " << made << " edits";
    go(ActionId::Undo);
}

} // namespace
} // namespace gui
