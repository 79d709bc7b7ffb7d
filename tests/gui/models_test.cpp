/// The tables behind menus, keys and preferences.
#include "gui/models/action_table.h"
#include "gui/models/bindings.h"
#include "gui/models/key_map.h"
#include "gui/models/preferences.h"
#include "gui/models/still_quality.h"

#include "gui/gui_support.h"

#include "rtcore/motion/key_codes.h"

#include <QFile>
#include <QKeyEvent>
#include <QSet>
#include <QSignalSpy>

namespace {

using namespace gui;

TEST(ActionTable, EachShortcutStandsOnceAndCanBeRead) {
    for (const ShortcutScheme scheme : {ShortcutScheme::Desktop, ShortcutScheme::Thesis}) {
        QSet<QString> seen;
        for (const ActionRow& row : actionTable()) {
            if (*row.shortcut == '\0') continue;
            const QString keys = shortcutOf(row, scheme).toString();
            EXPECT_FALSE(keys.isEmpty()) << row.text;
            EXPECT_FALSE(seen.contains(keys)) << row.text;
            seen.insert(keys);
        }
    }
}

TEST(ActionTable, EachMenuHasEachMnemonicOnce) {
    QSet<QString> seen;
    for (const ActionRow& row : actionTable()) {
        const QString text = actionText(row);
        const qsizetype mark = text.indexOf(QLatin1Char('&'));
        ASSERT_GE(mark, 0) << row.text;
        const QString key = QString::number(static_cast<int>(row.menu)) + text[mark + 1].toLower();
        EXPECT_FALSE(seen.contains(key)) << row.text;
        seen.insert(key);
        EXPECT_FALSE(actionTip(row).isEmpty()) << row.text;
    }
}

// The thesis names these.
TEST(ActionTable, TheWellKnownShortcutsAreThere) {
    const auto shortcut = [](ActionId id, ShortcutScheme scheme = ShortcutScheme::Thesis) {
        return shortcutOf(actionRow(id), scheme).toString().toStdString();
    };
    EXPECT_EQ(shortcut(ActionId::Connect), "Ctrl+C");
    EXPECT_EQ(shortcut(ActionId::StartServer), "Ctrl+S");
    EXPECT_EQ(shortcut(ActionId::QuickRender), "Ctrl+R");
    EXPECT_EQ(shortcut(ActionId::StopServer), "Ctrl+K");
    EXPECT_EQ(shortcut(ActionId::AtRestLive), "Ctrl+H");
    const ShortcutScheme desktop = shortcutSchemeOf(QStringLiteral("desktop"));
    EXPECT_EQ(shortcut(ActionId::Save, desktop), "Ctrl+S");
    EXPECT_EQ(shortcut(ActionId::SaveAs, desktop), "Ctrl+Shift+S");
    EXPECT_EQ(shortcut(ActionId::CopyCamera, desktop), "Ctrl+C");
    EXPECT_EQ(shortcut(ActionId::PasteCamera, desktop), "Ctrl+V");
    EXPECT_EQ(shortcut(ActionId::Undo, desktop), "Ctrl+Z");
    EXPECT_EQ(shortcut(ActionId::FullScreen, desktop), "F11");
    EXPECT_EQ(shortcutSchemeOf(QStringLiteral("thesis")), ShortcutScheme::Thesis);
}

TEST(Bindings, AreReadAsTheyAreWritten) {
    const QList<Binding> read =
        readBindings(QStringLiteral("W forward\nm+3 selectEnvironment 3\nbad\nW fly\n\n"));
    ASSERT_EQ(read.size(), 2);
    EXPECT_EQ(read[0], (Binding{QStringLiteral("W"), QStringLiteral("forward"), 0}));
    EXPECT_EQ(read[1], (Binding{QStringLiteral("M+3"), QStringLiteral("selectEnvironment"), 3}));
    EXPECT_EQ(bindCommand(read[1]), "bind M+3 selectEnvironment 3");
}

TEST(Bindings, KeysAreSpeltAsTheServerDoes) {
    EXPECT_EQ(normalKeys(QStringLiteral("capslock+left")), QStringLiteral("CapsLock+Left"));
    EXPECT_EQ(normalKeys(QStringLiteral("+")), QStringLiteral("+"));
    EXPECT_FALSE(normalKeys(QStringLiteral("Wheel")));
    EXPECT_FALSE(normalKeys(QString()));
    EXPECT_FALSE(normalKeys(QStringLiteral("M+")));
}

TEST(Bindings, ChangesAreTheDifference) {
    const QList<Binding> before = defaultBindings();
    EXPECT_TRUE(bindingChanges(before, before).empty());
    QList<Binding> after = before;
    after[0].action = QStringLiteral("jump");
    after.removeLast();
    after.append({QStringLiteral("Z"), QStringLiteral("forward"), 0});
    EXPECT_EQ(bindingChanges(before, after),
              (std::vector<std::string>{unbindCommand(before.last().keys), bindCommand(after[0]),
                                        bindCommand(after.last())}));
}

TEST(Bindings, EveryActionHasATitle) {
    for (const QString& action : bindableActions())
        EXPECT_NE(actionTitle(action), QString()) << action.toStdString();
}

int code(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier, const QString& text = {}) {
    return keyCodeOf(QKeyEvent(QEvent::KeyPress, key, modifiers, text));
}

TEST(KeyMap, GoesByTheKeyNotByItsText) {
    EXPECT_EQ(code(Qt::Key_W, Qt::NoModifier, QStringLiteral("w")), 'W');
    EXPECT_EQ(code(Qt::Key_W, Qt::ShiftModifier, QStringLiteral("W")), 'W');
    EXPECT_EQ(code(Qt::Key_W, Qt::ControlModifier, QStringLiteral("\x17")), 'W');
    EXPECT_EQ(code(Qt::Key_3), '3');
    EXPECT_EQ(code(Qt::Key_3, Qt::KeypadModifier), '3');
    EXPECT_EQ(code(Qt::Key_CapsLock), rtcore::KeyCapsLock);
    EXPECT_EQ(code(Qt::Key_Left), rtcore::KeyLeft);
    EXPECT_EQ(code(Qt::Key_Space, Qt::NoModifier, QStringLiteral(" ")), rtcore::KeySpace);
    EXPECT_EQ(code(Qt::Key_F5), rtcore::KeyNone);
    EXPECT_EQ(code(Qt::Key_Eacute), rtcore::KeyNone);
}

class PreferencesTest : public test::GuiTest {};

TEST_F(PreferencesTest, AreKept) {
    {
        Preferences preferences;
        QSignalSpy changes(&preferences, &Preferences::changed);
        EXPECT_EQ(preferences.get(pref::highQualitySize), QSize(1920, 1080));
        preferences.set(pref::theme, QStringLiteral("dark"));
        preferences.set(pref::theme, QStringLiteral("dark"));
        preferences.set(pref::mouseSensitivity, 0.5);
        EXPECT_EQ(changes.count(), 2);
    }
    const Preferences again;
    EXPECT_EQ(again.get(pref::theme), QStringLiteral("dark"));
    EXPECT_EQ(again.get(pref::mouseSensitivity), 0.5);
}

TEST_F(PreferencesTest, StillsAreAsTheLivePictureUnlessTheUserWantsMore) {
    Preferences preferences;
    EXPECT_TRUE(stillQuality(preferences).byPaths) << "unless the user wants less";
    EXPECT_FALSE(rendererOptions(stillQuality(preferences))
                     .join(QLatin1Char(' '))
                     .contains(QStringLiteral("--samples")))
        << "as many as the scene's quality says";
    preferences.set(pref::globalIllumination, false);
    EXPECT_EQ(rendererOptions(stillQuality(preferences)), QStringList{QStringLiteral("--antialiasing=3")});
    preferences.set(pref::stillBloom, 0);
    preferences.set(pref::stillOcclusion, QStringLiteral("off"));
    EXPECT_EQ(rendererOptions(stillQuality(preferences)).mid(1),
              (QStringList{QStringLiteral("--bloom=0"), QStringLiteral("--no-ambient-occlusion")}));
    preferences.set(pref::stillAntialiasing, 5);
    preferences.set(pref::stillBloom, 40);
    preferences.set(pref::stillOcclusion, QStringLiteral("on"));
    preferences.set(pref::stillOcclusionSamples, 16);
    const QStringList options = rendererOptions(stillQuality(preferences));
    EXPECT_EQ(options, (QStringList{QStringLiteral("--antialiasing=5"), QStringLiteral("--bloom=40"),
                                    QStringLiteral("--ambient-occlusion"),
                                    QStringLiteral("--setting=ambientOcclusion.samples=16")}));
    preferences.set(pref::globalIllumination, true);
    preferences.set(pref::stillPathSamples, 2);
    const QStringList byPaths = rendererOptions(stillQuality(preferences));
    EXPECT_EQ(byPaths, (QStringList{QStringLiteral("--bloom=40"), QStringLiteral("--samples=2"),
                                    QStringLiteral("--integrator=path"),
                                    QStringLiteral("--setting=exposure.recorded=automatic"),
                                    QStringLiteral("--setting=path.filter=4"),
                                    QStringLiteral("--setting=denoise.net=automatic")}));
    const auto denoising = [&] { return rendererOptions(stillQuality(preferences)).mid(4); };
    preferences.set(pref::stillDenoise, QStringLiteral("filter"));
    EXPECT_EQ(denoising(), (QStringList{QStringLiteral("--setting=path.filter=4"),
                                        QStringLiteral("--setting=denoise.net=off")}));
    const QStringList off{QStringLiteral("--setting=path.filter=0"),
                          QStringLiteral("--setting=denoise.net=off")};
    preferences.set(pref::stillDenoise, QStringLiteral("off"));
    EXPECT_EQ(denoising(), off);
    preferences.set(pref::stillDenoise, QString());
    preferences.set(pref::stillFilter, 0);
    EXPECT_EQ(denoising(), off) << "as it was stored before there were nets";
    std::vector<std::string> words{"room.obj", "-o", "a.png", "-w", "8", "-h", "8"};
    for (const QString& option : byPaths) words.push_back(option.toStdString());
    EXPECT_EQ(test::renderer(words, {.folder = folder().path()}).exitCode, 0);
    words.resize(7);
    for (const QString& option : options) words.push_back(option.toStdString());
    EXPECT_EQ(test::renderer(words, {.folder = folder().path()}).exitCode, 0);
}

TEST_F(PreferencesTest, RecentFilesAreTheLastTenThatAreThere) {
    Preferences preferences;
    for (int i = 0; i < 15; ++i) {
        test::writeText(folder() / (std::to_string(i) + ".obj"), "v 0 0 0\n");
        preferences.addRecentFile(file(std::to_string(i) + ".obj"));
    }
    preferences.addRecentFile(file("9.obj"));
    EXPECT_EQ(preferences.recentFiles().size(), 10);
    EXPECT_EQ(preferences.recentFiles().first(), file("9.obj"));
    QFile::remove(file("9.obj"));
    EXPECT_FALSE(preferences.recentFiles().contains(file("9.obj")));
}

TEST_F(PreferencesTest, NamesOfNewFilesAreFree) {
    const QString folder = QString::fromStdString(this->folder().path().string());
    const QString first = nextFreeName(folder, QStringLiteral("a"), QStringLiteral("png"));
    EXPECT_EQ(first, folder + QStringLiteral("/a-0001.png"));
    test::writeText(first.toStdString(), "");
    EXPECT_EQ(nextFreeName(folder, QStringLiteral("a"), QStringLiteral("png")),
              folder + QStringLiteral("/a-0002.png"));
}

} // namespace
