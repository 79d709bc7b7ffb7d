#include "gui/operations/plan_operations.h"

#include "gui/dialogs/plan_dialog.h"
#include "gui/dialogs/render_dialog.h"
#include "gui/models/output_file.h"
#include "gui/operations/actions.h"
#include "gui/processes/private_folder.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/notice_bar.h"

#include <QAction>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QPointer>
#include <QRegularExpression>

#include <memory>

namespace gui {

namespace {

/// Of the answer to `storeys`: "1 2.800 80.10", a line for each.
std::vector<double> floorsOf(const QString& answer) {
    std::vector<double> floors;
    for (const QString& line : answer.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        bool good = false;
        const double floor = line.section(QLatin1Char(' '), 1, 1).toDouble(&good);
        if (good) floors.push_back(floor);
    }
    return floors;
}

/// The first one, where the answer tells of several: "3 sheets: plan-A1.png to plan-A3.png".
QString fileOf(const PlanWish& plan, const QString& answer) {
    static const QRegularExpression sheets(QStringLiteral("^[0-9]+ sheets: (.+) to .+$"),
                                           QRegularExpression::MultilineOption);
    const QRegularExpressionMatch told = sheets.match(answer);
    return told.hasMatch() ? QFileInfo(plan.path).dir().filePath(told.captured(1)) : plan.path;
}

RenderWish renderWishOf(const PlanWish& plan, const QString& result) {
    const auto files = std::make_shared<PrivateFolder>("plan");
    const QString scene = files->file(QStringLiteral("view.scn"));
    QStringList words{scene};
    const auto option = [&words](const char* name, const QString& value) {
        words.append(QStringLiteral("--plan%1=%2").arg(QLatin1String(name), value));
    };
    const auto number = [](double value) {
        return QString::number(value, 'g', QLocale::FloatingPointShortest);
    };
    option("", plan.path);
    option("-from", plan.side);
    option("-scale", number(plan.scale));
    option("-dpi", number(plan.dpi));
    option("-image", plan.image);
    if (plan.paper != QLatin1String("sheet")) option("-paper", plan.paper);
    if (plan.side == QLatin1String("above")) {
        option("-height", number(plan.height));
        if (plan.storey > 0) option("-storey", QString::number(plan.storey));
    }
    return {.job = {QFileInfo(plan.path).fileName(), QStringLiteral("Renderer"), words, result, files},
            .sceneFile = scene,
            .cameraFile = {}};
}

} // namespace

PlanOperations::PlanOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context) {
    context_.actions.on(ActionId::Plan, [this] { ask(); });
}

void PlanOperations::ask() {
    const QString kept = context_.preferences.get(pref::planFolder);
    const QString folder =
        !kept.isEmpty() && QFileInfo(kept).isDir() ? kept : context_.preferences.picturesFolder();
    const QPointer<PlanDialog> dialog =
        new PlanDialog(nextFreeName(folder, QStringLiteral("plan"), QStringLiteral("pdf")),
                       context_.preferences, &context_.window);
    connect(dialog, &PlanDialog::wanted, this, &PlanOperations::draw);
    context_.session.send(command::storeys(), this, [dialog](const Answer& answer) {
        if (dialog && answer.done) dialog->setStoreys(floorsOf(answer.text));
    });
    dialog->open();
}

void PlanOperations::draw(const PlanWish& plan) {
    context_.preferences.set(pref::planFolder, QFileInfo(plan.path).absolutePath());
    context_.view.tell(tr("Drawing the plan…"));
    const std::string line = command::plan(plan.path.toStdString(), plan.side.toStdString(), plan.scale,
                                           plan.paper.toStdString(), plan.storey, plan.height, plan.dpi);
    context_.session.send(line, this, [this, plan](const Answer& answer) {
        if (answer.done) return onDrawn(plan, fileOf(plan, answer.text));
        context_.view.tell({});
        context_.notice.explain(answer.text, {context_.actions[ActionId::UpAndUnit]});
    });
}

// The server has lines at once; what could not be drawn has no light either.
void PlanOperations::onDrawn(const PlanWish& plan, const QString& file) {
    context_.view.tell(tr("The plan was written to %1.").arg(file));
    if (!plan.hasLight()) return;
    const RenderWish wish = renderWishOf(plan, file);
    if (!wish.job.files->trouble().isEmpty()) return context_.notice.explain(wish.job.files->trouble(), {});
    emit lightWanted(wish);
}

} // namespace gui
