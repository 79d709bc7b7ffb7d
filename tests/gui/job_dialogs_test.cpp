/// The dialogs that feed the queue.
#include "gui/dialog_support.h"
#include "gui/jobs_support.h"

#include "gui/dialogs/build_dialog.h"
#include "gui/dialogs/option_fields.h"
#include "gui/dialogs/render_dialog.h"

#include "bspbuilder/builder_spec.h"

#include "rtcore/neural/net_files.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSpinBox>

#include <algorithm>

namespace {

using namespace test;
using namespace gui;

class JobDialogsTest : public WithJobs<GuiTest> {};

TEST_F(JobDialogsTest, ABuildMakesAValidTree) {
    BuildDialog dialog(file("room.obj"));
    dialog.setAttribute(Qt::WA_DeleteOnClose, false);
    JobRequest wanted;
    QObject::connect(&dialog, &BuildDialog::wanted, &dialog, [&](const JobRequest& job) { wanted = job; });
    dialog.findChild<QCheckBox*>()->setChecked(true);
    field<QSpinBox>(dialog, "Histogram")->setValue(8);
    accept(dialog);
    EXPECT_EQ(wanted.result, file("room.bsp"));
    EXPECT_TRUE(wanted.arguments.contains(QStringLiteral("--fast")));
    EXPECT_TRUE(wanted.arguments.contains(QStringLiteral("--histogram=8")));
    JobQueue queue;
    const quint64 id = queue.add(wanted);
    ASSERT_TRUE(becomes(queue, id, JobState::Done)) << text(queue.job(0).message);
    EXPECT_FALSE(queue.job(0).log.isEmpty());
    EXPECT_EQ(test::renderer({"room.bsp", "-o", "b.png", "-w", "8", "-h", "8"}, {.folder = folder().path()})
                  .exitCode,
              0);
}

TEST_F(JobDialogsTest, CommandsAreWrittenForAShell) {
    EXPECT_EQ(text(commandText(QStringLiteral("Renderer"),
                               {QStringLiteral("/a b/it's.obj"), QStringLiteral("--output=/x.png")})),
              "Renderer '/a b/it'\\''s.obj' --output=/x.png");
}

TEST_F(JobDialogsTest, TheTableOfOptionsMakesTheFields) {
    app::ProgramSpec spec = bspbuilder::builderSpec();
    spec.groups.push_back({"New",
                           {{.name = "brand-new",
                             .value = app::ValueKind::Choice,
                             .help = "something that came later [one]",
                             .choices = {"one", "two"}},
                            {.name = "answer", .help = "answers", .answers = true},
                            {.name = "pair", .value = app::ValueKind::Text, .argument = "NAME=VALUE"}}});
    const OptionFields fields(spec, {QStringLiteral("fast")});
    EXPECT_TRUE(fields.arguments().isEmpty());
    auto* box = field<QComboBox>(fields, "Brand new");
    ASSERT_NE(box, nullptr);
    EXPECT_TRUE(box->toolTip().contains(QStringLiteral("came later")));
    EXPECT_TRUE(box->itemText(0).contains(QStringLiteral("one")));
    box->setCurrentIndex(2);
    field<QLineEdit>(fields, "Crease angle")->setText(QStringLiteral("25.5"));
    field<QLineEdit>(fields, "Pair")->setText(QStringLiteral("a=1 b=\"2 3\""));
    for (QCheckBox* check : fields.findChildren<QCheckBox*>()) {
        EXPECT_FALSE(check->text().contains(QStringLiteral("Fast")));
        if (check->text() == QStringLiteral("Flip textures")) check->setChecked(true);
        EXPECT_NE(check->text(), QStringLiteral("Answer"));
    }
    const QStringList words = fields.arguments();
    EXPECT_EQ(words.size(), 5);
    for (const char* word : {"--crease-angle=25.5", "--flip-textures", "--brand-new=two", "--pair=a=1"})
        EXPECT_TRUE(words.contains(QLatin1String(word))) << word;
}

TEST_F(JobDialogsTest, RenderDialogShowsTheCommandAndWhatIsWrong) {
    RenderContext context;
    context.scene = file("room.obj");
    context.output = file("out.png");
    RenderDialog dialog(context);
    auto* command = field<QLineEdit>(dialog, "Command");
    auto* buttons = dialog.findChild<QDialogButtonBox*>();
    const auto acceptable = [&] {
        for (QAbstractButton* button : buttons->buttons()) {
            if (buttons->buttonRole(button) == QDialogButtonBox::AcceptRole) return button->isEnabled();
        }
        return false;
    };
    EXPECT_TRUE(acceptable());
    EXPECT_TRUE(command->text().startsWith(QStringLiteral("Renderer /")));
    EXPECT_TRUE(command->text().contains(QStringLiteral("--antialiasing=3")));
    field<QLineEdit>(dialog, "Turns")->setText(QStringLiteral("many"));
    EXPECT_FALSE(acceptable()) << "the table says: a number";
    field<QLineEdit>(dialog, "Turns")->setText(QString());
    EXPECT_TRUE(acceptable());
    field<QComboBox>(dialog, "Resolution")->setCurrentText(QStringLiteral("4K"));
    EXPECT_TRUE(command->text().contains(QStringLiteral("--width=3840 --height=2160")));
    field<QComboBox>(dialog, "Resolution")->setCurrentText(QStringLiteral("A4 upright"));
    EXPECT_TRUE(command->text().contains(QStringLiteral("--width=2480 --height=3508")));
    QSignalSpy wanted(&dialog, &RenderDialog::wanted);
    dialog.setAttribute(Qt::WA_DeleteOnClose, false);
    dialog.show();
    QTest::keyClick(field<QLineEdit>(dialog, "Output file"), Qt::Key_Return);
    EXPECT_EQ(wanted.count(), 1) << "Return renders";
    dialog.setSource(RenderDialog::Source::List);
    EXPECT_FALSE(acceptable()) << "no list";
    dialog.setSource(RenderDialog::Source::View);
    EXPECT_EQ(dialog.source(), RenderDialog::Source::List) << "there is no server";
    for (const char* unfit : {"Preview", "Parent", "Progress", "Format"}) {
        for (const QLineEdit* line : dialog.findChildren<QLineEdit*>())
            EXPECT_NE(line->accessibleName(), QLatin1String(unfit));
    }
}

TEST_F(JobDialogsTest, WhatPathsDoNotUseIsGrey) {
    RenderContext context;
    context.scene = file("room.obj");
    context.output = file("out.png");
    RenderDialog dialog(context);
    const auto has = [&](const char* word) { return dialog.arguments().contains(QLatin1String(word)); };
    auto* integrator = field<QComboBox>(dialog, "Quality");
    auto* samples = field<QSpinBox>(dialog, "Samples of path tracing");
    auto* occlusion = field<QComboBox>(dialog, "Ambient occlusion");
    auto* rays = field<QSpinBox>(dialog, "Rays of the ambient occlusion");
    auto* antialiasing = field<QSpinBox>(dialog, "Anti-aliasing");
    auto* distance = field<QLineEdit>(dialog, "AO distance");
    occlusion->setCurrentIndex(1);
    rays->setValue(7);
    distance->setText(QStringLiteral("2"));
    const QStringList before = dialog.arguments();
    EXPECT_TRUE(has("--ao-samples=7") && has("--ao-distance=2") && has("--antialiasing=3"));
    EXPECT_FALSE(samples->isEnabled());

    integrator->setCurrentIndex(2);
    for (const QWidget* grey : std::initializer_list<QWidget*>{antialiasing, occlusion, rays, distance})
        EXPECT_FALSE(grey->isEnabled()) << grey->metaObject()->className();
    samples->setValue(64);
    EXPECT_TRUE(has("--integrator=path") && has("--samples=64"));
    for (const QString& word : dialog.arguments())
        EXPECT_FALSE(word.startsWith(QLatin1String("--a"))) << text(word);
    auto* denoising = field<QComboBox>(dialog, "Denoise");
    const bool net = !rtcore::findNet(rtcore::fileOf(rtcore::Net::Base)).file.empty();
    EXPECT_TRUE(has(net ? "--denoise=base@d0057057" : "--setting=path.filter=4"))
        << "unless the user wants noise";
    denoising->setCurrentIndex(2);
    EXPECT_TRUE(has("--denoise=large@08130cdc"));
    denoising->setCurrentIndex(3);
    EXPECT_TRUE(has("--denoise=off") && has("--setting=path.filter=4"));
    denoising->setCurrentIndex(4);
    EXPECT_TRUE(has("--denoise=off") && has("--setting=path.filter=0"));
    EXPECT_FALSE(has("--setting=path.seedPerFrame=true")) << "for lists";
    dialog.setSource(RenderDialog::Source::List);
    EXPECT_TRUE(has("--setting=path.seedPerFrame=true"));
    dialog.setSource(RenderDialog::Source::Scene);

    integrator->setCurrentIndex(0);
    EXPECT_FALSE(denoising->isEnabled());
    EXPECT_EQ(dialog.arguments(), before);
    EXPECT_TRUE(rays->isEnabled() && antialiasing->isEnabled() && distance->isEnabled());
}

TEST_F(JobDialogsTest, AFilmIsNamedLikeItsListUntilSomebodyNamesIt) {
    RenderDialog dialog(RenderContext{});
    dialog.setAttribute(Qt::WA_DeleteOnClose, false);
    dialog.setSource(RenderDialog::Source::List);
    auto* list = field<QLineEdit>(dialog, "List of cameras");
    auto* film = field<QLineEdit>(dialog, "Film");
    for (const QChar letter : file("walk-0001.lst")) {
        QTest::keyClick(list, letter.toLatin1());
        EXPECT_FALSE(film->text().startsWith(QStringLiteral("//"))) << text(list->text());
    }
    EXPECT_EQ(text(film->text()), text(file("walk-0001.mp4")));
    list->setText(file("other.lst"));
    EXPECT_EQ(text(film->text()), text(file("other.mp4")));
    list->clear();
    EXPECT_EQ(film->text(), QString());
    film->setText(file("mine.webm"));
    list->setText(file("walk-0001.lst"));
    EXPECT_EQ(text(film->text()), text(file("mine.webm")));
}

TEST_F(JobDialogsTest, EveryFieldHasANameAndEveryMnemonicIsUsedOnce) {
    RenderContext context;
    context.live = true;
    RenderDialog render(context);
    BuildDialog build(file("room.obj"));
    for (QDialog* dialog : std::initializer_list<QDialog*>{&render, &build}) {
        QStringList texts;
        for (const QLabel* label : dialog->findChildren<QLabel*>()) {
            if (label->buddy() == nullptr) continue;
            texts.append(label->text());
            EXPECT_NE(label->buddy()->focusPolicy(), Qt::NoFocus) << text(label->text());
        }
        for (const QAbstractButton* button : dialog->findChildren<QAbstractButton*>())
            texts.append(button->text());
        QStringList mnemonics;
        for (const QString& each : texts) {
            const qsizetype at = each.indexOf(QLatin1Char('&'));
            if (at < 0) continue;
            EXPECT_FALSE(mnemonics.contains(each.mid(at + 1, 1).toLower())) << text(each);
            mnemonics.append(each.mid(at + 1, 1).toLower());
        }
        for (const QWidget* widget : dialog->findChildren<QWidget*>()) {
            const auto* edit = qobject_cast<const QLineEdit*>(widget);
            const bool input =
                (edit != nullptr && qobject_cast<QAbstractSpinBox*>(edit->parentWidget()) == nullptr) ||
                qobject_cast<const QComboBox*>(widget) != nullptr ||
                qobject_cast<const QSpinBox*>(widget) != nullptr;
            if (!input) continue;
            const QList<QLabel*> labels = dialog->findChildren<QLabel*>();
            const bool labelled = std::any_of(labels.begin(), labels.end(),
                                              [&](const QLabel* label) { return label->buddy() == widget; });
            EXPECT_TRUE(labelled || !widget->accessibleName().isEmpty()) << widget->metaObject()->className();
        }
    }
}

} // namespace
