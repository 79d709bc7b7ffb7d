#include "gui/operations/model_operations.h"

#include "gui/operations/actions.h"
#include "gui/operations/panel_operations.h"
#include "gui/operations/scene_editor.h"
#include "gui/panels/material_fields.h"
#include "gui/panels/model_panel.h"
#include "gui/view/frame_view.h"
#include "gui/view/input_capture.h"

#include <QColor>
#include <QDockWidget>
#include <QMenu>

#include <algorithm>
#include <utility>
#include <vector>

namespace gui {

namespace {

using namespace std::chrono_literals;

constexpr auto kCollect = 150ms;  ///< of changes, before the lists are asked for
constexpr auto kMarkRest = 250ms; ///< of the camera, before the mark is asked for
constexpr QRgb kMark = 0xffffa028;

std::vector<std::string> wordsOf(const QStringList& list) {
    std::vector<std::string> words;
    for (const QString& each : list) words.push_back(each.toStdString());
    return words;
}

} // namespace

ModelOperations::ModelOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context), panel_(new ModelPanel),
      dock_(addPanel(context_, panel_, tr("Model"), QStringLiteral("model"), ActionId::ModelPanel)) {
    connectPanel();
    connectFields();
    refresh_.setSingleShot(true);
    rest_.setSingleShot(true);
    connect(&refresh_, &QTimer::timeout, this, &ModelOperations::refresh);
    connect(&rest_, &QTimer::timeout, this, &ModelOperations::askMark);
    connect(dock_, &QDockWidget::visibilityChanged, this, [this](bool visible) {
        if (visible) refresh_.start(0ms);
    });
    connect(&context_.editor, &SceneEditor::stateChanged, this, [this] {
        if (dock_->isVisible() || marked_ != 0) refresh_.start(kCollect);
    });
    connect(&context_.editor, &SceneEditor::sceneChanged, this, [this] {
        select(false, 0);
        panel_->selectPart(0);
        panel_->fields().show(std::nullopt);
        panel_->forgetCopy();
    });
    connect(&context_.session, &Session::frameChanged, this, &ModelOperations::onFrame);
    connect(&context_.view.input(), &InputCapture::picked, this, &ModelOperations::pick);
    context_.actions.on(ActionId::FitSelection, [this] { fitSelected(); });
    connect(&context_.view.input(), &InputCapture::capturedChanged, this, [this](bool captured) {
        if (captured) select(false, 0);
    });
}

void ModelOperations::connectPanel() {
    SceneEditor& editor = context_.editor;
    connect(panel_, &ModelPanel::hideWanted, this,
            [&editor](const QStringList& parts) { editor.edit(command::partHide(wordsOf(parts))); });
    connect(panel_, &ModelPanel::showWanted, this,
            [&editor](const QStringList& parts) { editor.edit(command::partShow(wordsOf(parts))); });
    connect(panel_, &ModelPanel::isolateWanted, this,
            [&editor](const QStringList& parts) { editor.edit(command::partIsolate(wordsOf(parts))); });
    connect(panel_, &ModelPanel::leaveWanted, this,
            [&editor](const QStringList& parts) { editor.edit(command::sectionLeave(wordsOf(parts))); });
    connect(panel_, &ModelPanel::cutWanted, this,
            [&editor](const QStringList& parts) { editor.edit(command::sectionCut(wordsOf(parts))); });
    connect(panel_, &ModelPanel::showAllWanted, this, [&editor] { editor.edit(command::partShowAll()); });
    connect(panel_, &ModelPanel::partChosen, this, [this](int number) { select(false, number); });
    connect(panel_, &ModelPanel::materialChosen, this, [this](int number) {
        select(true, number);
        askFields();
    });
    connect(panel_, &ModelPanel::pasteWanted, this, [this](int from, const QList<int>& to) {
        std::vector<std::string> words;
        for (const int number : to) words.push_back(std::to_string(number));
        select(false, 0); // its mark would hide the change
        context_.editor.edit(command::materialCopy(from, words));
    });
    connect(panel_, &ModelPanel::presetWanted, this, &ModelOperations::setPreset);
}

// For all of them one step of undo.
void ModelOperations::setPreset(const QList<int>& materials, const QString& name) {
    select(false, 0);
    for (qsizetype i = 0; i < materials.size(); ++i) {
        const std::string line = command::materialPreset(materials[i], name.toStdString());
        context_.editor.edit(i == 0 ? line : command::also(line));
    }
}

void ModelOperations::connectFields() {
    MaterialFields* fields = &panel_->fields();
    connect(fields, &MaterialFields::numberEdited, this, [this](const QString& key, double value) {
        setMaterial(key,
                    command::materialSet(panel_->chosenMaterial(), key.toStdString(), std::vector{value}));
    });
    connect(fields, &MaterialFields::colourEdited, this,
            [this](const QString& key, const std::array<float, 3>& linear) {
                const std::vector<double> values(linear.begin(), linear.end());
                setMaterial(key, command::materialSet(panel_->chosenMaterial(), key.toStdString(), values));
            });
    connect(fields, &MaterialFields::switched, this, [this](const QString& key, bool on) {
        setMaterial(key, command::materialSwitch(panel_->chosenMaterial(), key.toStdString(), on));
    });
    connect(fields, &MaterialFields::resetWanted, this,
            [this] { context_.editor.edit(command::materialReset(panel_->chosenMaterial())); });
}

// One gesture is one step of undo.
void ModelOperations::setMaterial(const QString& key, const std::string& line) {
    const QString which = QString::number(panel_->chosenMaterial()) + QLatin1Char(' ') + key;
    const bool goesOn = which == lastKey_ && sinceSet_.elapsed() < SceneEditor::kOneGesture;
    lastKey_ = which;
    sinceSet_.start();
    select(false, 0); // its mark would hide the change
    context_.editor.edit(goesOn ? command::also(line) : line, [this](const Answer& answer) {
        if (!answer.done) context_.view.tell(answer.text);
        refresh_.start(kCollect);
    });
}

// --- The lists ---

void ModelOperations::refresh() {
    if (!context_.session.live()) {
        panel_->showParts({});
        panel_->showMaterials({});
        panel_->fields().show(std::nullopt);
        return;
    }
    askParts(1, {});
    askMaterials(1, {});
    if (panel_->presets().isEmpty()) askPresets();
}

void ModelOperations::askPresets() {
    context_.session.send(command::materialPresets(), this, [this](const Answer& answer) {
        if (answer.done) panel_->showPresets(answer.text.split(QLatin1Char('\n'), Qt::SkipEmptyParts));
    });
}

void ModelOperations::askParts(int from, const QList<PartRow>& before) {
    context_.session.send(command::parts(from), this, [this, before](const Answer& answer) {
        const QList<PartRow> more = answer.done ? readParts(answer.text) : QList<PartRow>();
        if (more.isEmpty()) return panel_->showParts(before);
        askParts(more.last().number + 1, before + more);
    });
}

void ModelOperations::askMaterials(int from, const QList<MaterialRow>& before) {
    context_.session.send(command::materials(from), this, [this, before](const Answer& answer) {
        const QList<MaterialRow> more = answer.done ? readMaterials(answer.text) : QList<MaterialRow>();
        if (more.isEmpty()) {
            panel_->showMaterials(before);
            return askFields();
        }
        askMaterials(more.last().number + 1, before + more);
    });
}

void ModelOperations::askFields() {
    const int number = panel_->chosenMaterial();
    if (number == 0) return panel_->fields().show(std::nullopt);
    context_.session.send(command::materialGet(number), this, [this, number](const Answer& answer) {
        if (answer.done && number == panel_->chosenMaterial())
            panel_->fields().show(readMaterialState(answer.text));
    });
}

// --- The selection ---

void ModelOperations::pick(const QPointF& position) {
    const std::optional<QPointF> point = context_.view.inPicture(position);
    if (!point || !context_.session.live()) return;
    const auto fraction = [](double value) { return std::clamp((1 + value) / 2, 0.0, 1.0); };
    const QPoint place = context_.view.mapToGlobal(position.toPoint());
    context_.session.send(command::seen(fraction(point->x()), fraction(-point->y())), this,
                          [this, place](const Answer& answer) {
                              const auto seen = answer.done ? readSeen(answer.text) : std::nullopt;
                              panel_->selectPart(seen ? seen->part : 0);
                              panel_->selectMaterial(seen ? seen->material : 0);
                              select(false, seen ? seen->part : 0);
                              askFields();
                              if (!seen) return context_.view.tell(tr("Nothing of the model is seen there."));
                              context_.view.tell(
                                  QString(answer.text).replace(QLatin1Char('\n'), QLatin1String(", ")));
                              openMenu(place);
                          });
}

void ModelOperations::openMenu(const QPoint& place) {
    const std::vector<std::string> part{std::to_string(marked_)};
    auto* menu = new QMenu(&context_.window);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    SceneEditor& editor = context_.editor;
    QAction* hide =
        menu->addAction(tr("&Hide"), this, [&editor, part] { editor.edit(command::partHide(part)); });
    QAction* isolate =
        menu->addAction(tr("&Isolate"), this, [&editor, part] { editor.edit(command::partIsolate(part)); });
    QAction* leave = menu->addAction(tr("Do &not cut"), this,
                                     [&editor, part] { editor.edit(command::sectionLeave(part)); });
    QAction* fit = menu->addAction(tr("&Go there"), this, &ModelOperations::fitSelected);
    for (QAction* action : {hide, isolate, leave, fit}) action->setEnabled(marked_ != 0);
    menu->addAction(tr("Show &all"), this, [&editor] { editor.edit(command::partShowAll()); });
    menu->addSeparator();
    menu->addAction(tr("Edit the &material"), this, [this] {
        dock_->show();
        dock_->raise();
        panel_->fields().setFocus();
    });
    menu->popup(place);
}

void ModelOperations::fitSelected() {
    if (marked_ == 0 || markMaterial_)
        return context_.view.tell(
            tr("No part is selected: a right click on the image, or a row of the model panel, selects one."));
    context_.editor.edit(command::cameraFit({std::to_string(marked_)}));
}

void ModelOperations::select(bool material, int number) {
    markMaterial_ = material;
    marked_ = number;
    context_.view.setMark({});
    if (number != 0) askMark();
}

void ModelOperations::onFrame() {
    if (marked_ == 0 || context_.session.status().view == markedView_) return;
    context_.view.setMark({});
    rest_.start(kMarkRest);
}

void ModelOperations::askMark() {
    if (marked_ == 0 || !context_.session.live()) return;
    markedView_ = context_.session.status().view;
    context_.session.send(command::mask(markMaterial_, marked_), this,
                          [this, marked = marked_, material = markMaterial_](const Answer& answer) {
                              if (marked != marked_ || material != markMaterial_) return;
                              context_.view.setMark(
                                  answer.done ? readMark(answer.text, QColor::fromRgb(kMark)) : QImage());
                          });
}

} // namespace gui
