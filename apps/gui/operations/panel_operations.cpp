#include "gui/operations/panel_operations.h"

#include "gui/models/at_rest.h"
#include "gui/models/plain_text.h"
#include "gui/models/preferences.h"
#include "gui/operations/actions.h"
#include "gui/operations/scene_editor.h"
#include "gui/panels/fold_box.h"
#include "gui/panels/settings_panel.h"
#include "gui/view/frame_view.h"
#include "gui/view/notice_bar.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QMainWindow>
#include <QShortcut>

#include <algorithm>

namespace gui {

namespace {

void focusFirst(const QWidget& panel) {
    for (QWidget* field : panel.findChildren<QWidget*>()) {
        const bool takes = (field->focusPolicy() & Qt::TabFocus) != 0 && field->isEnabledTo(&panel);
        if (takes && field->isVisibleTo(&panel)) return field->setFocus(Qt::ShortcutFocusReason);
    }
}

bool isBehindAnother(const QDockWidget& dock) { return dock.isVisible() && dock.visibleRegion().isEmpty(); }

} // namespace

// Without this the keys would go on to a field of another panel, or nowhere.
void leadBack(QDockWidget& dock, FrameView& view) {
    auto* back = new QShortcut(Qt::Key_Escape, &dock, nullptr, nullptr, Qt::WidgetWithChildrenShortcut);
    QObject::connect(back, &QShortcut::activated, &view, qOverload<>(&QWidget::setFocus));
    QObject::connect(&dock, &QDockWidget::visibilityChanged, &view, [&dock, &view] {
        if (dock.isHidden()) view.setFocus();
    });
}

QDockWidget* addPanel(const GuiContext& context, QWidget* panel, const QString& title, const QString& name,
                      ActionId action, Qt::DockWidgetArea area) {
    auto* window = qobject_cast<QMainWindow*>(&context.window);
    auto* dock = new QDockWidget(title, window);
    dock->setObjectName(name); // restoreState() knows it by this
    dock->setWidget(panel);
    dock->setAllowedAreas(area == Qt::RightDockWidgetArea ? Qt::LeftDockWidgetArea | area
                                                          : Qt::TopDockWidgetArea | area);
    const QList<QDockWidget*> others = window->findChildren<QDockWidget*>();
    window->addDockWidget(area, dock);
    for (QDockWidget* other : others) {
        if (other == dock || window->dockWidgetArea(other) != area) continue;
        window->tabifyDockWidget(other, dock);
        break;
    }
    dock->hide();
    QAction* toggle = context.actions[action];
    // A panel behind another one comes to the front first.
    QObject::connect(toggle, &QAction::triggered, dock, [dock, panel, toggle](bool on) {
        const bool show = on || isBehindAnother(*dock);
        toggle->setChecked(show);
        dock->setVisible(show);
        if (!show) return;
        dock->raise();
        focusFirst(*panel);
    });
    leadBack(*dock, context.view);
    QObject::connect(dock->toggleViewAction(), &QAction::toggled, toggle, &QAction::setChecked);
    return dock;
}

PanelOperations::PanelOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context) {
    addSettings();
    addUndo();
    context_.actions.on(ActionId::AllPanels, [this] { switchAll(); });
    connect(&context_.editor, &SceneEditor::refused, this,
            [this](const QString& text) { context_.notice.explain(text, {}); });
}

// Hidden panels come back as they were; at first these are all but the jobs.
void PanelOperations::switchAll() {
    const QList<QDockWidget*> all = context_.window.findChildren<QDockWidget*>();
    QList<QDockWidget*> shown = all;
    shown.removeIf([](const QDockWidget* dock) { return dock->isHidden(); });
    if (!shown.isEmpty()) {
        std::stable_partition(shown.begin(), shown.end(),
                              [](const QDockWidget* dock) { return isBehindAnother(*dock); });
        hidden_ = shown;
        for (QDockWidget* dock : shown) dock->hide();
        return;
    }
    if (hidden_.isEmpty()) {
        hidden_ = all;
        hidden_.removeIf([](const QDockWidget* dock) { return dock->objectName() == QLatin1String("jobs"); });
    }
    for (QDockWidget* dock : hidden_) dock->show();
    for (QDockWidget* dock : hidden_) dock->raise();
}

void PanelOperations::addSettings() {
    auto* panel = new SettingsPanel;
    addPanel(context_, panel, tr("Settings"), QStringLiteral("settings"), ActionId::SettingsPanel);
    SceneEditor& editor = context_.editor;
    connect(&editor, &SceneEditor::stateChanged, panel,
            [panel, &editor] { panel->show(editor.state().settings); });
    connect(panel, &SettingsPanel::edited, &editor, &SceneEditor::setSetting);
    connect(panel, &SettingsPanel::defaultsWanted, &editor, &SceneEditor::setDefaults);
    connect(panel, &SettingsPanel::qualityWanted, &editor,
            [&editor](const QString& name) { editor.edit(command::quality(name.toStdString())); });
    addAtRest(*panel);
    panel->advanced().setFolded(!context_.preferences.get(pref::advancedSettings));
    connect(&panel->advanced(), &FoldBox::foldedChanged, this,
            [this](bool folded) { context_.preferences.set(pref::advancedSettings, !folded); });
    panel->setFolded(context_.preferences.get(pref::foldedSettings));
    connect(panel, &SettingsPanel::foldedChanged, this,
            [this](const QStringList& folded) { context_.preferences.set(pref::foldedSettings, folded); });
}

// A preference of the window, not of the server: the image that is rendered when nothing moves.
void PanelOperations::addAtRest(SettingsPanel& panel) {
    auto* box = new QComboBox;
    fillAtRest(*box);
    box->setAccessibleName(tr("Image at rest"));
    box->setToolTip(plainTip(tr("What is shown when the camera rests")));
    panel.addToMain(tr("Image at rest:"), box);
    Preferences& preferences = context_.preferences;
    const auto show = [box, &preferences] { box->setCurrentIndex(static_cast<int>(atRest(preferences))); };
    show();
    connect(box, &QComboBox::activated, this,
            [&preferences](int chosen) { setAtRest(preferences, static_cast<AtRest>(chosen)); });
    connect(&preferences, &Preferences::changed, box, show);
}

void PanelOperations::addUndo() {
    SceneEditor& editor = context_.editor;
    context_.actions.on(ActionId::Undo, [this] {
        context_.view.tell(tr("Undone: %1").arg(context_.editor.undoText()));
        context_.editor.undo();
    });
    context_.actions.on(ActionId::Redo, [this] {
        context_.view.tell(tr("Redone: %1").arg(context_.editor.redoText()));
        context_.editor.redo();
    });
    connect(&editor, &SceneEditor::stateChanged, this, &PanelOperations::showUndo);
    showUndo();
}

void PanelOperations::showUndo() {
    const auto show = [&](ActionId id, const QString& what) {
        QAction* action = context_.actions[id];
        action->setEnabled(!what.isEmpty());
        const QString text = actionText(actionRow(id));
        action->setText(what.isEmpty() ? text : tr("%1: %2").arg(text, plainEntry(what)));
        const QString tip = actionTip(actionRow(id));
        action->setToolTip(
            plainTip(what.isEmpty() ? tip : tr("%1: %2").arg(QString(text).remove(QLatin1Char('&')), what)));
    };
    show(ActionId::Undo, context_.editor.undoText());
    show(ActionId::Redo, context_.editor.redoText());
}

} // namespace gui
