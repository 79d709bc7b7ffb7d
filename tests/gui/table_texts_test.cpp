/// The texts that the window takes from the tables of settings and options are in translations/tables_cs.ts.
/// RT_RENEW_DOCS=1 in the environment brings that file up to date: new ones come in as unfinished.
#include "gui/models/edit_labels.h"
#include "gui/models/option_names.h"
#include "gui/models/setting_labels.h"
#include "gui/panels/light_fields.h"

#include "gui/translation_file.h"

#include "bspbuilder/builder_spec.h"
#include "renderer/renderer_spec.h"
#include "rtcore/settings/settings_table.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QFile>
#include <QTranslator>

namespace {

using namespace gui;
using test::Message;

constexpr const char* kFile = RT_TRANSLATIONS "/tables_cs.ts";

struct Context {
    QString name;
    QStringList texts;
};

QList<Context> tables() {
    QStringList options = optionTexts(renderer::rendererSpec());
    options.append(optionTexts(bspbuilder::builderSpec()));
    options.removeDuplicates();
    return {{QStringLiteral("Settings"), settingTexts()},
            {QStringLiteral("Edits"), editTexts()},
            {QStringLiteral("LightKinds"), lightKindTexts()},
            {QStringLiteral("ProgramOptions"), options}};
}

using Known = QMap<std::pair<QString, QString>, Message>; // by context and source

Known known() {
    Known all;
    for (const Message& each : test::messages(QString::fromUtf8(kFile)))
        all[{each.context, each.source}] = each;
    return all;
}

QString line(int depth, const QString& text) {
    return QString(depth * 4, QLatin1Char(' ')) + text + QLatin1Char('\n');
}

QString element(const QString& name, const QString& text) {
    return QStringLiteral("<%1>%2</%1>").arg(name, text.toHtmlEscaped());
}

QString written(const Known& present) {
    QString file = QStringLiteral("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<!DOCTYPE TS>\n"
                                  "<TS version=\"2.1\" language=\"cs\" sourcelanguage=\"en\">\n");
    for (const Context& context : tables()) {
        file += line(0, QStringLiteral("<context>")) + line(1, element(QStringLiteral("name"), context.name));
        for (const QString& text : context.texts) {
            const Message message = present.value({context.name, text});
            file += line(1, QStringLiteral("<message>")) + line(2, element(QStringLiteral("source"), text)) +
                    line(2, message.finished
                                ? element(QStringLiteral("translation"), message.translation)
                                : QStringLiteral("<translation type=\"unfinished\"></translation>")) +
                    line(1, QStringLiteral("</message>"));
        }
        file += line(0, QStringLiteral("</context>"));
    }
    return file + QStringLiteral("</TS>\n");
}

TEST(TableTexts, AreAllTranslated) {
    const Known present = known();
    if (qEnvironmentVariableIsSet("RT_RENEW_DOCS")) {
        QFile file(QString::fromUtf8(kFile));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(written(present).toUtf8());
        return;
    }
    for (const Context& context : tables()) {
        for (const QString& text : context.texts)
            EXPECT_TRUE(present.value({context.name, text}).finished)
                << context.name.toStdString() << ": \"" << text.toStdString() << "\" has no translation. "
                << "RT_RENEW_DOCS=1 test_gui --gtest_filter=TableTexts.* adds it to " << kFile
                << "; then translate it there";
    }
}

TEST(TableTexts, StayEnglishWithoutATranslation) {
    EXPECT_EQ(settingGroup("noSuchEffect"), QStringLiteral("No such effect"));
    EXPECT_EQ(settingLabel("noSuchEffect.maxSpeed"), QStringLiteral("Max speed"));
    EXPECT_EQ(settingHelp("what nobody has translated"), QStringLiteral("what nobody has translated"));
    app::Option option;
    option.name = "no-such-fps";
    option.help = "nothing at all [40]";
    EXPECT_EQ(optionLabel(option), QStringLiteral("No such FPS"));
    EXPECT_EQ(optionDefault(option), QStringLiteral("40"));
    EXPECT_EQ(optionTip(option),
              QStringLiteral("<qt>Nothing at all [40].<br><code>--no-such-fps</code></qt>"));
}

TEST(TableTexts, SettingsStandInGroups) {
    const auto group = [](std::string_view name) { return settingGroup(rtcore::requireSetting(name).group); };
    EXPECT_EQ(group("ambientOcclusion.samples"), QStringLiteral("Ambient occlusion"));
    EXPECT_EQ(group("shadows"), QStringLiteral("Rays"));
    EXPECT_EQ(group("toneMapping"), group("exposure.mode"));
    EXPECT_EQ(group("width"), QStringLiteral("Image"));
}

TEST(TableTexts, TipsTellNameRangeAndDefault) {
    const QString tip = settingTip(rtcore::requireSetting("ambientOcclusion.samples"));
    for (const char* part : {"ambientOcclusion.samples", "1 to 4096", "default: "})
        EXPECT_TRUE(tip.contains(QLatin1String(part))) << part << " in " << tip.toStdString();
    EXPECT_TRUE(settingTip(rtcore::requireSetting("shadows")).contains(QStringLiteral("default: on")));
    EXPECT_TRUE(
        settingTip(rtcore::requireSetting("exposure.mode")).contains(QStringLiteral("default: Automatic")));
    EXPECT_TRUE(settingTip(rtcore::requireSetting("ambientOcclusion.distance"))
                    .contains(QStringLiteral("at least 0")));
}

#ifdef RT_TRANSLATED
TEST(TableTexts, AreCzechInTheCzechWindow) {
    QTranslator translator;
    ASSERT_TRUE(translator.load(QStringLiteral(":/translations/tables_cs.qm")));
    QCoreApplication::installTranslator(&translator);
    const rtcore::Setting& shadows = rtcore::requireSetting("shadows");
    EXPECT_EQ(settingLabel(shadows.name), QStringLiteral("Stíny"));
    EXPECT_NE(settingHelp(shadows.help), QString::fromUtf8(shadows.help.data()));
    const app::Option* list = renderer::rendererSpec().find("list");
    ASSERT_NE(list, nullptr);
    EXPECT_FALSE(optionTip(*list).contains(QString::fromStdString(list->help).toHtmlEscaped()));
}
#endif

} // namespace
