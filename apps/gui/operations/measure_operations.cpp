#include "gui/operations/measure_operations.h"

#include "gui/models/measure_texts.h"
#include "gui/models/output_file.h"
#include "gui/models/preferences.h"
#include "gui/operations/actions.h"
#include "gui/operations/panel_operations.h"
#include "gui/operations/scene_editor.h"
#include "gui/panels/measures_panel.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/input_capture.h"
#include "gui/view/measure_marks.h"
#include "gui/view/notice_bar.h"

#include <QAction>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>

#include <algorithm>

namespace gui {

MeasureOperations::MeasureOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context), panel_(new MeasuresPanel),
      marks_(new MeasureMarks(context.view, context.session, this)) {
    QDockWidget* dock =
        addPanel(context_, panel_, tr("Measures"), QStringLiteral("measures"), ActionId::MeasuresPanel);
    context_.actions.bind(ActionId::ShowMeasures, pref::showMeasures);
    const auto showMarks = [this] { marks_->setShown(context_.preferences.get(pref::showMeasures)); };
    connect(&context_.preferences, &Preferences::changed, marks_, showMarks);
    showMarks();
    context_.actions.onToggle(ActionId::Measure, [this, dock](bool on) {
        if (on == marks_->measuring().has_value()) return;
        if (on) {
            dock->show();
            dock->raise();
        }
        measure(on ? std::optional(last_) : std::nullopt);
    });
    // By what else takes clicks, too.
    connect(context_.actions[ActionId::Measure], &QAction::toggled, this, [this](bool on) {
        if (!on && marks_->measuring()) measure({});
    });
    connect(&context_.editor, &SceneEditor::stateChanged, this, &MeasureOperations::showState);
    connect(&context_.editor, &SceneEditor::sceneChanged, this, [this] { measure({}); });
    const auto enable = [this] {
        panel_->setEnabled(context_.session.live());
        if (!context_.session.live()) measure({});
    };
    connect(&context_.session, &Session::stateChanged, panel_, enable);
    enable();
    connectPanel();
    connectMarks();
}

void MeasureOperations::connectPanel() {
    connect(panel_, &MeasuresPanel::toolChosen, this, &MeasureOperations::measure);
    connect(panel_, &MeasuresPanel::wanted, this,
            [this](const std::string& line) { context_.editor.edit(line); });
    connect(panel_, &MeasuresPanel::goWanted, this, &MeasureOperations::goTo);
    connect(panel_, &MeasuresPanel::exportWanted, this, &MeasureOperations::askForFile);
}

void MeasureOperations::connectMarks() {
    connect(marks_, &MeasureMarks::kept, this, &MeasureOperations::keep);
    connect(marks_, &MeasureMarks::faceWanted, this,
            [this](const QPointF& at) { keep(command::measureKeepFace(at.x(), at.y())); });
    connect(marks_, &MeasureMarks::partWanted, this, &MeasureOperations::keepPart);
    connect(marks_, &MeasureMarks::pointsChanged, this, &MeasureOperations::showHint);
    connect(marks_, &MeasureMarks::nothingCaught, this,
            [this] { context_.view.tell(tr("Nothing of the model is seen there.")); });
    connect(marks_, &MeasureMarks::left, this, [this] { measure({}); });
    connect(marks_, &MeasureMarks::removalWanted, this, [this] {
        if (panel_->selected() >= 0) context_.editor.edit(command::measureRemove(panel_->selected() + 1));
    });
}

void MeasureOperations::showState() {
    panel_->show(context_.editor.state());
    marks_->setState(context_.editor.state());
}

void MeasureOperations::measure(std::optional<rtcore::MeasureKind> kind) {
    if (kind && !context_.session.live()) kind.reset();
    if (kind) {
        last_ = *kind;
        context_.actions[ActionId::AddNote]->setChecked(false);
        context_.view.input().release();
        context_.view.setFocus();
    }
    panel_->setTool(kind);
    marks_->setMeasuring(kind);
    context_.actions[ActionId::Measure]->setChecked(kind.has_value());
    showHint();
}

void MeasureOperations::showHint() {
    const auto kind = marks_->measuring();
    const std::size_t set = marks_->points().size();
    if (!kind) return panel_->setHint({});
    switch (*kind) {
    case rtcore::MeasureKind::Chain:
        return panel_->setHint(set < 2 ? tr("Click points one after another. Shift keeps to an axis.")
                                       : tr("Enter or a double click keeps the chain."));
    case rtcore::MeasureKind::Angle:
        return panel_->setHint(set == 1 ? tr("Click the point that the angle is at.")
                                        : tr("Click three points, the second at the angle."));
    case rtcore::MeasureKind::Height:
        return panel_->setHint(tr("Click a point above the floor."));
    case rtcore::MeasureKind::Area:
        return panel_->setHint(tr("Click a face."));
    case rtcore::MeasureKind::Volume:
        return panel_->setHint(tr("Click a closed part."));
    case rtcore::MeasureKind::Distance:
        break;
    }
    panel_->setHint(tr("Click two points. Shift keeps to an axis, Esc ends."));
}

void MeasureOperations::keep(const std::string& line) { context_.editor.edit(line); }

// The answer to `seen` begins with "part 3".
void MeasureOperations::keepPart(const QPointF& at) {
    context_.session.send(command::seen(at.x(), at.y()), this, [this](const Answer& answer) {
        const int part = answer.text.section(QLatin1Char('\n'), 0, 0).section(QLatin1Char(' '), 1, 1).toInt();
        if (!answer.done || part < 1) return context_.view.tell(tr("Nothing of the model is seen there."));
        keep(command::measureKeepVolume(std::to_string(part)));
    });
}

// From the side where one is, so far away that all of it is in the image.
void MeasureOperations::goTo(int index) {
    const SceneState& state = context_.editor.state();
    if (index < 0 || index >= std::ssize(state.measures.all)) return;
    const rtcore::KeptMeasure& measure = state.measures.all[static_cast<std::size_t>(index)];
    QVector3D lo(1e30F, 1e30F, 1e30F), hi = -lo;
    for (const rtcore::Vec3d& p : measure.points) {
        for (int i = 0; i < 3; ++i) {
            lo[i] = std::min(lo[i], static_cast<float>(p[i]));
            hi[i] = std::max(hi[i], static_cast<float>(p[i]));
        }
    }
    constexpr float kAway = 1.6F, kOfDiagonal = 0.1F;
    const float diagonal = state.bounds.empty() ? 1 : state.bounds.diagonal();
    const float away = std::max(kAway * (hi - lo).length(), kOfDiagonal * diagonal);
    const View& view = context_.session.status().view;
    const QVector3D forward = view.forward.normalized(), eye = (lo + hi) / 2 - away * forward;
    const float width = view.fieldOfView > 0 ? view.fieldOfView : view.parallelWidth;
    context_.view.showLive();
    context_.editor.edit(command::camera({.eye = positionOf(eye, view),
                                          .forward = numbersOf(forward),
                                          .width = width,
                                          .orthographic = !(view.fieldOfView > 0),
                                          .up = numbersOf(view.up)}));
}

void MeasureOperations::askForFile() {
    const QString kept = context_.preferences.get(pref::planFolder);
    const QString folder =
        !kept.isEmpty() && QFileInfo(kept).isDir() ? kept : context_.preferences.picturesFolder();
    auto* dialog = new QFileDialog(&context_.window, tr("Export the measures"),
                                   nextFreeName(folder, QStringLiteral("measures"), QStringLiteral("csv")),
                                   tr("Tables (*.csv)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("csv"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        context_.session.send(command::measureExport(path.toStdString()), this,
                              [this, path](const Answer& answer) {
                                  if (!answer.done) return context_.notice.explain(answer.text, {});
                                  context_.view.tell(tr("The measures were written to %1.").arg(path));
                              });
    });
    dialog->open();
}

} // namespace gui
