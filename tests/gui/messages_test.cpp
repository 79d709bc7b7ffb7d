/// The server's messages are seen in the window.
#include "gui/lit_scene.h"
#include "gui/window_support.h"

#include "gui/dialogs/log_dialog.h"
#include "gui/dialogs/up_and_unit_dialog.h"
#include "gui/models/messages.h"
#include "gui/panels/value_box.h"
#include "gui/view/overlay.h"

#include <QComboBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTranslator>

namespace {

using namespace test;
using namespace gui;

std::string text(const QString& from) { return from.toStdString(); }

const char* const kMissing =
    "bare.obj: 2 textures are missing, so their materials are plain: 'one.png' and 'two.png'";

class MessagesTest : public WindowFixture {
  protected:
    /// Two triangles in a material each, whose textures are not there.
    void writeBareModel() {
        writeText(folder() / "bare.mtl", "newmtl a\nmap_Kd one.png\nnewmtl b\nmap_Kd two.png\n");
        writeText(folder() / "bare.obj",
                  "mtllib bare.mtl\nv 0 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\nvt 0 0\nvt 1 1\n"
                  "vt 0 1\nusemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 3/2 4/3\n");
    }
    bool told(const char* words) {
        return comes([&] { return window->view().told() == QLatin1String(words); });
    }
};

TEST_F(MessagesTest, MissingTexturesAreCountedInANotice) {
    writeBareModel();
    open("bare.obj");
    ASSERT_TRUE(comes([&] { return window->notice().isVisible(); }));
    EXPECT_EQ(text(window->notice().text()), kMissing);
    window->notice().findChild<QPushButton*>()->click();
    const auto* log = window->findChild<LogDialog*>();
    ASSERT_NE(log, nullptr) << "with the names";
    EXPECT_TRUE(log->findChild<QPlainTextEdit*>()->toPlainText().contains(QStringLiteral("two.png")));
    EXPECT_FALSE(window->notice().isVisible());

    MainWindow other(name()); // which did not start the server
    other.show();
    other.connectToServer();
    ASSERT_TRUE(comes([&] { return other.notice().isVisible(); }));
    EXPECT_EQ(text(other.notice().text()), kMissing);
    other.notice().findChild<QPushButton*>()->click();
    const auto* otherLog = other.findChild<LogDialog*>();
    ASSERT_NE(otherLog, nullptr);
    EXPECT_TRUE(otherLog->findChild<QPlainTextEdit*>()->toPlainText().contains(QStringLiteral("two.png")));
    other.close();
}

// A cached model is not imported again.
TEST_F(MessagesTest, AKeptModelStillLacksItsTextures) {
    writeBareModel();
    open("bare.obj");
    ASSERT_TRUE(comes([&] { return !window->keeper().models().find(file("bare.obj")).isEmpty(); }));
    ASSERT_TRUE(comes([&] { return !window->keeper().models().building(); }));
    window->close();
    window.emplace(name());
    window->show();
    open("bare.obj");
    ASSERT_TRUE(comes([&] { return window->notice().isVisible(); }));
    EXPECT_EQ(text(window->notice().text()), kMissing);
    window->notice().findChild<QPushButton*>()->click();
    const auto* log = window->findChild<LogDialog*>();
    ASSERT_NE(log, nullptr);
    EXPECT_TRUE(log->findChild<QPlainTextEdit*>()->toPlainText().contains(QStringLiteral("one.png")));
}

TEST_F(MessagesTest, TheNoticeIsThatOfTheSceneThatIsShown) {
    writeBareModel();
    open("bare.obj");
    ASSERT_TRUE(comes([&] { return window->notice().isVisible(); }));
    window->open(file("room.obj"));
    ASSERT_TRUE(comes([&] { return window->windowTitle().contains(QStringLiteral("room.obj")); }))
        << text(window->notice().text()) << text(window->view().told());
    EXPECT_FALSE(window->notice().isVisible());
    window->open(file("bare.obj"));
    EXPECT_TRUE(comes([&] {
        return window->notice().isVisible() && window->notice().text().contains(QStringLiteral("missing"));
    })) << "again";
}

TEST_F(MessagesTest, WhatAKeyDidIsTold) {
    writeLitScene(folder());
    openAndRest("lit.scn");
    QTest::keyClick(&window->view(), Qt::Key_2);
    EXPECT_TRUE(told("Light 2: off")) << text(window->view().told());
    QTest::keyClick(&window->view(), Qt::Key_2);
    EXPECT_TRUE(told("Light 2: on"));
    QTest::keyClick(&window->view(), Qt::Key_7);
    EXPECT_TRUE(told("There is no light 7."));
    QTest::keyClick(&window->view(), Qt::Key_B);
    EXPECT_TRUE(told("Bloom: on"));
    QTest::keyPress(&window->view(), Qt::Key_M);
    QTest::keyClick(&window->view(), Qt::Key_2);
    QTest::keyRelease(&window->view(), Qt::Key_M);
    EXPECT_TRUE(told("Environment map 2"));
    MainWindow other(name());
    other.show();
    other.connectToServer();
    ASSERT_TRUE(shows(other.session()));
    ASSERT_TRUE(ask(other.session(), QStringLiteral("ping")).done);
    QTest::qWait(100);
    EXPECT_EQ(text(other.view().told()), "") << "that was before it came";
    other.close();
}

// A guess that may be wrong comes with a button that decides otherwise.
TEST_F(MessagesTest, TheOtherUpAxisIsOffered) {
    writeText(folder() / "part.stl",
              "solid OpenSCAD_Model\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 40 0 0\n"
              "   vertex 0 40 20\n  endloop\n endfacet\nendsolid\n");
    open("part.stl");
    ASSERT_TRUE(comes([&] { return window->notice().isVisible(); }));
    ASSERT_TRUE(comes([&] { return window->notice().text().contains(QStringLiteral("is up")); }));
    EXPECT_EQ(text(window->notice().text()), "+Z is up (guessed, usual for OpenSCAD).\n"
                                             "1 unit = 0.001 m (guessed, usual for OpenSCAD).");
    const auto isUp = [&](const char* axis) {
        return comes([&] { return window->editor().state().up == QLatin1String(axis); });
    };
    EXPECT_TRUE(isUp("+z"));
    auto* const turn = window->notice().findChild<QPushButton*>();
    EXPECT_EQ(text(turn->text()), "+Y is up");
    turn->click();
    EXPECT_FALSE(window->notice().isVisible());
    EXPECT_TRUE(isUp("+y"));
    EXPECT_TRUE(comes([&] { return text(window->editor().undoText()) == "up axis"; }));
    window->editor().undo();
    EXPECT_TRUE(isUp("+z"));
}

TEST_F(MessagesTest, TheUnitIsOffered) {
    writeText(folder() / "part.stl",
              "solid OpenSCAD_Model\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 40 0 0\n"
              "   vertex 0 40 20\n  endloop\n endfacet\nendsolid\n");
    open("part.stl");
    ASSERT_TRUE(comes([&] { return window->notice().findChildren<QPushButton*>().size() >= 2; }));
    window->notice().findChildren<QPushButton*>()[1]->click();
    auto* const dialog = window->findChild<UpAndUnitDialog*>();
    ASSERT_NE(dialog, nullptr);
    const QList<QComboBox*> choices = dialog->findChildren<QComboBox*>();
    auto* const length = dialog->findChild<ValueBox*>();
    ASSERT_EQ(choices.size(), 2);
    EXPECT_EQ(text(choices[0]->currentText()), "+Z");
    EXPECT_EQ(text(choices[1]->currentText()), "Millimetres");
    EXPECT_EQ(length->value(), 0.001);
    const auto unitIs = [&](float metres) {
        return comes([&] { return window->editor().state().metresPerUnit == metres; });
    };
    choices[1]->setCurrentIndex(choices[1]->findText(QStringLiteral("Inches")));
    EXPECT_TRUE(unitIs(0.0254F));
    EXPECT_TRUE(comes([&] { return length->value() == 0.0254; }));
    length->setValue(0.9144);
    EXPECT_TRUE(unitIs(0.9144F));
    EXPECT_TRUE(comes([&] { return choices[1]->currentText() == QStringLiteral("Others"); }));
    choices[0]->setCurrentIndex(choices[0]->findText(QStringLiteral("+Y")));
    EXPECT_TRUE(comes([&] { return window->editor().state().up == QStringLiteral("+y"); }));
    for (auto* button : dialog->findChildren<QPushButton*>()) {
        if (button->text().contains(QStringLiteral("guessed"))) button->click();
    }
    EXPECT_TRUE(comes([&] { return window->editor().state().up == QStringLiteral("+z"); }));
    EXPECT_TRUE(unitIs(0.001F));
    EXPECT_TRUE(comes([&] { return window->editor().state().edits == 5; }));
    dialog->close();
}

Message told(const char* detail) {
    return {1, false, QStringLiteral("in English"), true, readSentence(QString::fromUtf8(detail))};
}

TEST(Messages, AnOfferIsRead) {
    const auto offer = readUpOffer(
        told(R"(["{0} is taken for up ({1}); 'up {2}' turns the model","+z",["by its shape"],"+y"])"));
    ASSERT_TRUE(offer);
    EXPECT_EQ(text(offer->text), "+Z is up (guessed, by its shape).");
    EXPECT_EQ(text(offer->other), "+y");
    EXPECT_FALSE(readUpOffer(told(R"(["+z is taken for up"])")));
    EXPECT_FALSE(readUpOffer(told("")));
    const auto unit = readUnitOffer(told(
        R"(["{0} m are taken for a unit ({1}); 'units' sets another","0.0254",["usual for {0}",".wrl"]])"));
    ASSERT_TRUE(unit);
    EXPECT_EQ(text(*unit), "1 unit = 0.0254 m (guessed, usual for .wrl).");
    EXPECT_FALSE(readUnitOffer(told(R"(["+z is taken for up"])")));
    const auto materials = readMaterialOffer(told(R"x(["{0}; 'material reset *' takes them as they are",
                 ["{0} materials are guessed by name ({1})","3",["{0}, {1}",["glass"],["metal"]]]])x"));
    ASSERT_TRUE(materials);
    EXPECT_EQ(text(*materials), "Materials guessed by name: 3 (glass, metal).");
}

TEST(Messages, AnOfferToSwitchFillLightsOffNamesThem) {
    const auto offer = readFillOffer(told(
        R"(["indirect light is rendered, and {0} stand in for it: it counts twice; to switch them off: {1}",
            "'fill'","light 2 off; quit; light 31 off"])"));
    ASSERT_TRUE(offer);
    EXPECT_TRUE(offer->text.contains(QLatin1String("'fill'")));
    EXPECT_EQ(offer->lights, (QList<int>{2, 31})) << "nothing else is taken from a server";
    EXPECT_FALSE(readFillOffer(told(R"(["+z is taken for up"])")));
}

#ifdef RT_TRANSLATED
// Each language has its own word order and plurals.
TEST(Messages, AreTranslatedAsAWhole) {
    const auto warning = [](const char* detail) { return text(told(detail).shown()); };
    const char* const refusal =
        R"(["{0}: {1}","a {0}.cam",["cannot be read: {0}",["No such file or directory"]]])";
    const auto unit = [](const char* habit) {
        const std::string why = std::string(R"(["usual for {0}",)") + habit + "]";
        return *readUnitOffer(told(
            (R"(["{0} m are taken for a unit ({1}); 'units' sets another","0.01",)" + why + "]").c_str()));
    };
    EXPECT_EQ(text(told(refusal).shown()), "a {0}.cam: cannot be read: No such file or directory");
    QTranslator czech, sentences;
    ASSERT_TRUE(czech.load(QStringLiteral(":/translations/gui_cs.qm")));
    ASSERT_TRUE(sentences.load(QStringLiteral(":/translations/sentences_cs.qm")));
    QCoreApplication::installTranslator(&czech);
    QCoreApplication::installTranslator(&sentences);
    EXPECT_EQ(warning(R"(["texture {0} is missing; its material is plain","'x and y'"])"),
              "chybí textura 'x and y'; její materiál je jednobarevný");
    EXPECT_EQ(warning(R"(["{0}' and '{1}","'a","b'"])"), "'a' a 'b'");
    EXPECT_EQ(warning(R"(["{0}' and {1} more","'a', 'b","7"])"), "'a', 'b' a další (7)");
    EXPECT_TRUE(unit(R"(["{0} files","OBJ"])").endsWith(QStringLiteral("obvyklé pro soubory OBJ).")));
    EXPECT_TRUE(unit(R"(["such files"])").endsWith(QStringLiteral("obvyklé pro takové soubory).")));
    EXPECT_EQ(text(told(refusal).shown()), "a {0}.cam: nelze přečíst: takový soubor ani složka tu není");
    EXPECT_EQ(text(serverText(QStringLiteral("plain"), QStringLiteral("[7]"))), "plain");
    EXPECT_EQ(text(serverText(QStringLiteral("plain"), QString(100, QLatin1Char('[')))), "plain");
    EXPECT_EQ(text(serverText({}, QStringLiteral("[\"a new thing {0}\",\"x\"]"))), "a new thing x");
    QCoreApplication::removeTranslator(&czech);
    QCoreApplication::removeTranslator(&sentences);
}
#endif

TEST(Messages, AreReadLineByLine) {
    const QList<Message> messages =
        readMessages(QStringLiteral("3 warning a b: c\nnonsense\n4 event light 2 off\n5 other x\n6 offer y"),
                     QStringLiteral("\n\n[\"light {0} off\",\"2\"]\n\n"));
    ASSERT_EQ(messages.size(), 3);
    EXPECT_TRUE(messages[2].offer);
    EXPECT_TRUE(messages[0].warning);
    EXPECT_EQ(text(messages[0].text), "a b: c");
    EXPECT_EQ(messages[1].number, 4U);
    EXPECT_EQ(text(eventText(messages[1])), "Light 2: off");
    EXPECT_EQ(text(eventText(told("[\"a new thing\"]"))), "a new thing") << "what is new stays English";
}

TEST(Messages, OfOneKindAreCounted) {
    QStringList warnings{
        QStringLiteral("/a b/m.obj: 3 of 35 triangles are damaged"),
        QStringLiteral("/a b/m.obj: 22 textures are missing, so their materials are plain: 'a/b.png', ...")};
    for (const char* name : {"a", "b"})
        warnings.append(QStringLiteral("/c.obj: light '%1' of a/b: it is left out").arg(QLatin1String(name)));
    EXPECT_EQ(text(warningsText(warnings)),
              "m.obj: 3 of 35 triangles are damaged\n"
              "m.obj: 22 textures are missing, so their materials are plain: 'a/b.png', ...\n"
              "c.obj: light 'a' of a/b: it is left out (and others like this: 1)");
    EXPECT_EQ(text(warningsText(
                  {QStringLiteral("/a.obj: 'x%2y' is new"), QStringLiteral("/a.obj: 'x%3y' is new")})),
              "a.obj: 'x%2y' is new (and others like this: 1)")
        << "a name is no place for a number";
    for (const char* kind : {"x", "y", "z"}) warnings.append(QLatin1String(kind));
    EXPECT_TRUE(warningsText(warnings).endsWith(QStringLiteral("x\nFurther warnings: 2")));
}

TEST(Figures, SayThatACoarsePictureIsRefined) {
    ServerStatus status;
    status.resolution = QSize(800, 600);
    const auto figures = [&](const QSize& frame, bool still) {
        return text(overlayText(status, frame, still, {}));
    };
    EXPECT_NE(figures({100, 75}, true).find("(12 %)  ·  Fly  ·  sharpening"), std::string::npos);
    EXPECT_NE(figures({100, 75}, false).find("drawing"), std::string::npos) << "while it moves";
    EXPECT_NE(figures({800, 600}, true).find("drawing"), std::string::npos);
    EXPECT_EQ(figures({800, 600}, true).find("fps"), std::string::npos) << "0 fps tells nothing";
    status.kept = 0.979;
    EXPECT_NE(figures({600, 450}, false).find("800 × 600 (75 %)  ·  Fly"), std::string::npos);
    status.framesPerSecond = 25;
    EXPECT_EQ(figures({800, 600}, true).rfind("25 fps", 0), 0U);
    status.idle = true;
    EXPECT_NE(figures({800, 600}, true).find("complete"), std::string::npos);
}

TEST(Figures, SayHowSureIndirectLightIsWhileItIsLearned) {
    ServerStatus status;
    status.resolution = QSize(800, 600);
    const auto figures = [&] { return text(overlayText(status, {800, 600}, false, {})); };
    EXPECT_EQ(figures(), "800 × 600  ·  Fly  ·  drawing") << "there is none";
    status.indirectError = 0.034;
    EXPECT_EQ(figures(), "800 × 600  ·  Fly  ·  drawing  ·  indirect light ±3 %");
    status.idle = true;
    EXPECT_EQ(figures(), "800 × 600  ·  Fly  ·  complete");
}

TEST(Figures, TellWhatTheRendererDoesInPlaceOfComplete) {
    ServerStatus status;
    status.resolution = QSize(800, 600);
    const auto figures = [&] {
        return text(overlayText(status, {800, 600}, true, QStringLiteral("refined")));
    };
    EXPECT_EQ(figures(), "800 × 600  ·  Fly  ·  drawing  ·  refined");
    status.idle = true;
    EXPECT_EQ(figures(), "800 × 600  ·  Fly  ·  refined");
    status.paused = true;
    EXPECT_EQ(figures(), "800 × 600  ·  Fly  ·  paused  ·  refined");
}

} // namespace
