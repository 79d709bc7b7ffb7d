/// The dialogs by themselves: what they say, and that they can be used without a mouse.
#include "gui/dialog_support.h"
#include "gui/gui_support.h"

#include "gui/dialogs/about_dialog.h"
#include "gui/dialogs/configure_dialog.h"
#include "gui/dialogs/connect_dialog.h"
#include "gui/dialogs/export_camera_dialog.h"
#include "gui/dialogs/key_bindings_page.h"
#include "gui/dialogs/keys_dialog.h"
#include "gui/dialogs/log_dialog.h"
#include "gui/dialogs/plan_dialog.h"
#include "gui/dialogs/recording_dialog.h"
#include "gui/dialogs/share_dialog.h"
#include "gui/dialogs/start_server_dialog.h"
#include "gui/dialogs/statistics_dialog.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableWidget>

namespace {

using namespace test;
using namespace gui;

class DialogsTest : public GuiTest {
  protected:
    // A field has a name of its own, or a label that belongs to it.
    static bool isNamed(const QWidget* field, const QWidget& dialog) {
        if (!field->accessibleName().isEmpty()) return true;
        const QList<QLabel*> labels = dialog.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
            return label->buddy() == field ||
                   (label->buddy() != nullptr && label->buddy()->focusProxy() == field);
        });
    }
    static void check(QDialog& dialog) {
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        EXPECT_FALSE(dialog.windowTitle().isEmpty());
        for (QWidget* field : dialog.findChildren<QWidget*>()) {
            const bool input = qobject_cast<QLineEdit*>(field) != nullptr ||
                               qobject_cast<QComboBox*>(field) != nullptr ||
                               qobject_cast<QAbstractSpinBox*>(field) != nullptr;
            const bool inner = qobject_cast<QAbstractSpinBox*>(field->parentWidget()) != nullptr;
            if (!input || inner) continue;
            EXPECT_TRUE(isNamed(field, dialog))
                << dialog.windowTitle().toStdString() << ": " << field->metaObject()->className();
            EXPECT_NE(field->focusPolicy() & Qt::TabFocus, 0);
        }
        for (const QPushButton* button : dialog.findChildren<QPushButton*>())
            EXPECT_FALSE(button->text().isEmpty());
        for (const QLabel* label : dialog.findChildren<QLabel*>()) {
            if (label->buddy() == nullptr) {
                EXPECT_FALSE(label->text().contains(QLatin1Char('&')))
                    << dialog.windowTitle().toStdString() << ": " << label->text().toStdString();
            }
        }
    }
    static void accept(QDialog& dialog) {
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        auto* buttons = dialog.findChild<QDialogButtonBox*>();
        for (QAbstractButton* button : buttons->buttons()) {
            if (buttons->buttonRole(button) == QDialogButtonBox::AcceptRole) button->click();
        }
    }

    Preferences preferences;
    Session session;
};

TEST_F(DialogsTest, EveryFieldHasANameAndEveryMnemonicAField) {
    StartServerDialog start(preferences, name(), QSize(640, 480));
    ExportCameraDialog exporting(file("a.cam"), QSize(640, 480), preferences);
    RecordingDialog recording(session, QStringLiteral("/tmp"));
    StatisticsDialog statistics(
        session, [] { return 0.003; }, [] { return QStringLiteral("live"); });
    ConfigureDialog configure(preferences, session);
    ConnectDialog connecting(name());
    AboutDialog about;
    KeysDialog keys(session);
    LogDialog log([] { return QStringLiteral("text"); });
    ShareDialog share(preferences, {});
    PlanDialog plan(file("plan.pdf"), preferences);
    for (QDialog* dialog :
         std::initializer_list<QDialog*>{&start, &exporting, &recording, &statistics, &configure, &connecting,
                                         &about, &keys, &log, &share, &plan})
        check(*dialog);
}

// Not the file dialog of "Browse".
TEST_F(DialogsTest, EnterInAFieldAccepts) {
    preferences.addRecentFile(file("room.obj"));
    StartServerDialog start(preferences, name(), QSize(640, 480));
    ExportCameraDialog exporting(file("a.cam"), QSize(640, 480), preferences);
    for (QDialog* dialog : std::initializer_list<QDialog*>{&start, &exporting}) {
        dialog->setAttribute(Qt::WA_DeleteOnClose, false);
        dialog->show();
        QTest::keyClick(dialog->findChild<QLineEdit*>(), Qt::Key_Return);
        EXPECT_EQ(dialog->result(), QDialog::Accepted) << dialog->windowTitle().toStdString();
    }
}

TEST_F(DialogsTest, StartServerAsksForWhatIsWritten) {
    preferences.addRecentFile(file("room.obj"));
    StartServerDialog dialog(preferences, name(), QSize(640, 480));
    const ServerRequest request = dialog.request();
    EXPECT_EQ(request.scene, file("room.obj"));
    EXPECT_EQ(request.instance, name());
    EXPECT_EQ(request.resolution, QSize(640, 480));
    QSignalSpy wanted(&dialog, &StartServerDialog::wanted);
    accept(dialog);
    EXPECT_EQ(wanted.count(), 1);
}

TEST_F(DialogsTest, StartServerRefusesAFileThatIsNotThere) {
    preferences.addRecentFile(file("room.obj"));
    StartServerDialog dialog(preferences, name(), QSize(640, 480));
    QSignalSpy wanted(&dialog, &StartServerDialog::wanted);
    dialog.findChild<QLineEdit*>()->setText(file("nothing.obj"));
    accept(dialog);
    EXPECT_EQ(wanted.count(), 0);
}

TEST_F(DialogsTest, ExportCameraGivesAllFourNumbers) {
    ExportCameraDialog dialog(file("a.cam"), QSize(320, 200), preferences);
    CameraExport camera;
    QObject::connect(&dialog, &ExportCameraDialog::wanted, &dialog,
                     [&](const CameraExport& given) { camera = given; });
    accept(dialog);
    EXPECT_EQ(camera.path, file("a.cam"));
    EXPECT_EQ(camera.size, QSize(320, 200));
    EXPECT_EQ(camera.antialiasing, 1);
    EXPECT_EQ(camera.bloom, 0);
}

TEST_F(DialogsTest, PlanGivesWhatWasChosenAndKeepsIt) {
    PlanDialog dialog(file("plan.pdf"), preferences);
    dialog.setStoreys({0, 2.8});
    const QList<QComboBox*> boxes = dialog.findChildren<QComboBox*>();
    ASSERT_EQ(boxes.size(), 4);
    EXPECT_EQ(boxes[1]->count(), 3) << "the camera's, and two";
    boxes[1]->setCurrentIndex(2);
    boxes[2]->setCurrentText(QStringLiteral("A3"));
    field<QDoubleSpinBox>(dialog, "Scale")->setValue(50);
    PlanWish plan;
    QObject::connect(&dialog, &PlanDialog::wanted, &dialog, [&](const PlanWish& wish) { plan = wish; });
    accept(dialog);
    EXPECT_EQ(plan.path, file("plan.pdf"));
    EXPECT_EQ(plan.side, QStringLiteral("above"));
    EXPECT_EQ(plan.storey, 2);
    EXPECT_EQ(plan.paper, QStringLiteral("A3"));
    EXPECT_EQ(plan.scale, 50);
    EXPECT_EQ(plan.height, 1.2);
    EXPECT_FALSE(plan.hasLight()) << "of lines alone";
    EXPECT_FALSE(boxes[3]->isEnabled());
    PlanDialog next(file("plan.pdf"), preferences);
    EXPECT_EQ(next.findChildren<QComboBox*>()[2]->currentText(), QStringLiteral("A3"));
    next.findChildren<QComboBox*>()[0]->setCurrentIndex(1);
    EXPECT_FALSE(next.findChildren<QComboBox*>()[1]->isEnabled()) << "an elevation has no storey";
    next.findChild<QLineEdit*>()->setText(file("plan.PNG"));
    EXPECT_TRUE(next.findChildren<QComboBox*>()[3]->isEnabled());
    next.findChildren<QComboBox*>()[3]->setCurrentIndex(2);
    field<QDoubleSpinBox>(next, "Resolution")->setValue(150);
    QObject::connect(&next, &PlanDialog::wanted, &next, [&](const PlanWish& wish) { plan = wish; });
    accept(next);
    EXPECT_TRUE(plan.hasLight());
    EXPECT_EQ(plan.image, QStringLiteral("both"));
    EXPECT_EQ(plan.dpi, 150);
}

TEST_F(DialogsTest, KeyBindingsSayWhatIsWrong) {
    KeyBindingsPage page;
    page.setBindings(defaultBindings());
    EXPECT_TRUE(page.valid());
    EXPECT_EQ(page.bindings(), defaultBindings());
    auto* table = page.findChild<QTableWidget*>();
    table->item(0, 0)->setText(QStringLiteral("Wheel"));
    EXPECT_FALSE(page.valid());
    table->item(0, 0)->setText(table->item(1, 0)->text());
    EXPECT_FALSE(page.valid()) << "twice";
    table->item(0, 0)->setText(QStringLiteral("z"));
    EXPECT_TRUE(page.valid());
    EXPECT_EQ(page.bindings().first().keys, QStringLiteral("Z"));
}

TEST_F(DialogsTest, ConfigureBindsKeysOnTheServer) {
    startServer();
    session.connectTo(name());
    ASSERT_TRUE(shows(session));
    ConfigureDialog dialog(preferences, session);
    QTest::qWait(200); // the server's bindings are there
    dialog.findChild<QTableWidget*>()->item(0, 0)->setText(QStringLiteral("Z"));
    accept(dialog);
    const QList<Binding> bindings = readBindings(ask(session, QStringLiteral("bindings")).text);
    EXPECT_EQ(bindings.size(), defaultBindings().size());
    EXPECT_TRUE(bindings.contains(Binding{QStringLiteral("Z"), QStringLiteral("forward"), 0}));
    EXPECT_FALSE(bindings.contains(defaultBindings().first()));
    EXPECT_FALSE(preferences.get(pref::bindings).isEmpty());
}

TEST_F(DialogsTest, RecordingStartsAndStops) {
    startServer();
    session.connectTo(name());
    ASSERT_TRUE(shows(session));
    RecordingDialog dialog(session, QString::fromStdString(folder().path().string()));
    dialog.setAttribute(Qt::WA_DeleteOnClose, false);
    QPushButton* button = nullptr;
    for (QPushButton* each : dialog.findChildren<QPushButton*>()) {
        if (each->text().contains(QStringLiteral("Start"))) button = each;
    }
    ASSERT_NE(button, nullptr);
    button->click();
    ASSERT_TRUE(comes([&] { return session.status().recording; }));
    EXPECT_TRUE(comes([&] { return button->text().contains(QStringLiteral("Stop")); }));
    button->click();
    ASSERT_TRUE(comes([&] { return !session.status().recording; }));
    EXPECT_TRUE(QFile::exists(file("walk-0001.lst")));
    ASSERT_TRUE(ask(session, QStringLiteral("camera set 9 9 9 0 0 -1")).done);
    ASSERT_TRUE(comes([&] { return session.status().view.eye == QVector3D(9, 9, 9); }));
    ASSERT_TRUE(comes([&] { return press(dialog, "Play"); }));
    EXPECT_TRUE(comes([&] { return session.status().view.eye != QVector3D(9, 9, 9); }));
}

TEST_F(DialogsTest, ARecordingIsKnownToADialogThatIsOpenedLater) {
    startServer();
    session.connectTo(name());
    ASSERT_TRUE(shows(session));
    const auto make = [this] {
        auto dialog =
            std::make_unique<RecordingDialog>(session, QString::fromStdString(folder().path().string()));
        dialog->setAttribute(Qt::WA_DeleteOnClose, false);
        return dialog;
    };
    const auto path = [](const RecordingDialog& dialog) { return dialog.findChild<QLineEdit*>()->text(); };
    const auto says = [](const RecordingDialog& dialog, const QRegularExpression& words) {
        return comes([&] {
            const QList<QLabel*> labels = dialog.findChildren<QLabel*>();
            return std::any_of(labels.begin(), labels.end(),
                               [&](const QLabel* label) { return label->text().contains(words); });
        });
    };
    auto dialog = make();
    ASSERT_TRUE(press(*dialog, "Start"));
    ASSERT_TRUE(comes([&] { return session.status().recording; }));
    dialog.reset();
    QTest::qWait(1200);
    dialog = make();
    ASSERT_TRUE(says(*dialog, QRegularExpression(QStringLiteral("walk-0001.lst for [1-9][0-9.]* s"))));
    EXPECT_EQ(path(*dialog), file("walk-0001.lst"));
    ASSERT_TRUE(comes([&] { return press(*dialog, "Stop"); }));
    ASSERT_TRUE(says(*dialog, QRegularExpression(QStringLiteral("Recorded: .*walk-0001.lst"))));
    QSignalSpy film(dialog.get(), &RecordingDialog::filmWanted);
    ASSERT_TRUE(comes([&] { return press(*dialog, "film"); }));
    EXPECT_EQ(film.value(0).value(0).toString(), file("walk-0001.lst"));

    ASSERT_TRUE(comes([&] { return press(*dialog, "Start"); })) << "what is recorded stays";
    ASSERT_TRUE(says(*dialog, QRegularExpression(QStringLiteral("Recording walk-0002.lst"))));
    ASSERT_TRUE(comes([&] { return press(*dialog, "Stop"); }));
    ASSERT_TRUE(comes([&] { return press(*dialog, "Play"); }));
    EXPECT_TRUE(says(*dialog, QRegularExpression(QStringLiteral("Recorded: .*walk-0002.lst"))));

    dialog->findChild<QLineEdit*>()->setText(file("nothing.lst"));
    EXPECT_FALSE(press(*dialog, "Play"));
    EXPECT_FALSE(press(*dialog, "film"));
    dialog->findChild<QLineEdit*>()->setText(file("walk-0001.lst"));
    EXPECT_TRUE(press(*dialog, "Play")) << "any list";
    ASSERT_TRUE(press(*dialog, "film"));
    EXPECT_EQ(film.last().value(0).toString(), file("walk-0001.lst"));
}

TEST_F(DialogsTest, TheCheatSheetNamesEveryKindOfKey) {
    const QString page = keysPage(defaultBindings());
    for (const char* text : {"W", "CapsLock+Left", "Ctrl+S", "R+L", "F12"})
        EXPECT_TRUE(page.contains(QLatin1String(text))) << text;
}

} // namespace
