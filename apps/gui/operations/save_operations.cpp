#include "gui/operations/save_operations.h"

#include "gui/operations/actions.h"
#include "gui/operations/scene_editor.h"
#include "gui/processes/server_keeper.h"
#include "gui/view/frame_view.h"
#include "gui/view/notice_bar.h"
#include "gui/view/plain_widgets.h"

#include "common/commands/pack_words.h"
#include "common/process/stop.h"

#include "rtcore/io/text/written_mark.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QPushButton>
#include <QTimer>

#include <array>

namespace gui {

namespace {

bool isScene(const QString& path) { return QFileInfo(path).suffix() == QLatin1String("scn"); }

// One that cannot be read is told by the server.
bool isByHand(const QString& path) {
    try {
        return rtcore::isWrittenByHand(path.toStdString());
    } catch (const std::exception&) {
        return false;
    }
}

} // namespace

SaveOperations::SaveOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context), stopPacking_(new QAction(tr("&Stop packing"), this)),
      packProgress_(new QTimer(this)) {
    constexpr int kProgressStep = 300; // milliseconds
    packProgress_->setInterval(kProgressStep);
    connect(packProgress_, &QTimer::timeout, this, &SaveOperations::showPackProgress);
    connect(stopPacking_, &QAction::triggered, this, [this] { context_.session.send(command::packStop()); });
    context_.actions.on(ActionId::Save, [this] { save(); });
    context_.actions.on(ActionId::SaveAs, [this] { saveAs(); });
    context_.actions.on(ActionId::Pack, [this] { pack(); });
    connect(&context_.editor, &SceneEditor::stateChanged, this,
            [this] { context_.window.setWindowModified(context_.editor.state().modified); });
    connect(&context_.editor, &SceneEditor::sceneChanged, this, [this] { discarded_.reset(); });
}

// --- Saving ---

void SaveOperations::save(const Then& then) {
    const QString path = context_.editor.scene();
    if (path.isEmpty()) return; // the server has not said yet
    isScene(path) ? saveTo(path, then) : saveAs(then);
}

void SaveOperations::saveAs(const Then& then) {
    const QFileInfo scene(context_.editor.scene());
    const QString proposal = scene.dir().filePath(scene.completeBaseName() + QStringLiteral(".scn"));
    auto* dialog = new QFileDialog(&context_.window, tr("Save the scene as"), proposal, tr("Scenes (*.scn)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("scn"));
    dialog->selectFile(proposal);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, then](const QString& path) { saveTo(path, then); });
    dialog->open();
}

void SaveOperations::saveTo(const QString& path, const Then& then) {
    if (!isByHand(path)) return write(path, false, then);
    confirmReplacing(path, [this, path, then] { write(path, true, then); });
}

void SaveOperations::confirmReplacing(const QString& path, const Then& replace) {
    const QString name = QFileInfo(path).fileName();
    QMessageBox* box =
        plainQuestion(tr("Replace a file"),
                      tr("“%1” was written or changed by hand. Its comments and its layout are lost "
                         "when it is saved. The old file is kept as “%1~”.")
                          .arg(name),
                      tr("&Replace"), replace, &context_.window);
    const QPushButton* other = box->addButton(tr("Save &as…"), QMessageBox::ActionRole);
    connect(other, &QPushButton::clicked, this, [this] { saveAs(); });
    box->open();
}

void SaveOperations::write(const QString& path, bool replace, const Then& then) {
    emit aboutToSave();
    const bool own = path == context_.editor.scene();
    const std::string line = own ? command::save(replace)
                                 : command::saveAs(QFileInfo(path).absoluteFilePath().toStdString(), replace);
    context_.editor.edit(line, [this, path, then](const Answer& answer) { onSaved(answer, path, then); });
}

void SaveOperations::onSaved(const Answer& answer, const QString& path, const Then& then) {
    if (!answer.done) return context_.notice.explain(answer.text, {context_.actions[ActionId::SaveAs]});
    context_.notice.hide();
    if (path != context_.editor.scene()) emit savedAs(path);
    if (context_.keeper.ours()) context_.keeper.sceneLoaded(path);
    context_.preferences.addRecentFile(path);
    context_.view.tell(tr("Saved as “%1”.").arg(QFileInfo(path).fileName()));
    if (then) then();
}

// --- Packing ---

void SaveOperations::pack() {
    const QFileInfo scene(context_.editor.scene());
    auto* dialog =
        new QFileDialog(&context_.window, tr("Pack the scene into a new folder"),
                        scene.dir().filePath(scene.completeBaseName() + QStringLiteral("-packed")));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setLabelText(QFileDialog::FileName, tr("&Folder:"));
    dialog->setLabelText(QFileDialog::Accept, tr("&Pack"));
    dialog->setOption(QFileDialog::DontConfirmOverwrite);
    dialog->selectFile(scene.completeBaseName() + QStringLiteral("-packed"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) { packInto(path, false); });
    dialog->open();
}

void SaveOperations::packInto(const QString& folder, bool outside) {
    emit aboutToSave();
    const QString packing = tr("Packing into “%1”…").arg(folder);
    context_.notice.explain(packing, {stopPacking_});
    packProgress_->start();
    context_.session.send(command::pack(folder.toStdString(), outside), this,
                          [this, folder, packing](const Answer& answer) {
                              packProgress_->stop();
                              if (context_.notice.text() == packing) context_.notice.hide();
                              onPacked(answer, folder);
                          });
}

void SaveOperations::onPacked(const Answer& answer, const QString& folder) {
    context_.view.tell(answer.done ? tr("Packed into “%1”.").arg(folder) : QString());
    const auto said = readSentence(answer.detail);
    if (const auto* const refusal = said ? said->find(app::kPackRefusal) : nullptr)
        return confirmOutside(refusal->argument(0), folder);
    // Files that were left out are listed in lines of their own.
    if (!answer.done) return context_.notice.explain(answer.text, {});
    QStringList lines = answer.text.split(QLatin1Char('\n')).mid(1);
    for (QString& line : lines) line = translatedAs(line, std::array{app::kLeftOut});
    if (!lines.isEmpty()) context_.notice.explain(lines.join(QLatin1Char('\n')), {});
}

void SaveOperations::confirmOutside(QString files, const QString& folder) {
    files.replace(QLatin1String("', a link to '"), tr("', a link to '"));
    const QString text = tr("The scene names files outside of its folder. With them, the pack "
                            "shows them to all who get it:\n\n%1")
                             .arg(files);
    const auto pack = [this, folder] { packInto(folder, true); };
    plainQuestion(tr("Pack files from elsewhere"), text, tr("&Pack them, too"), pack, &context_.window)
        ->open();
}

void SaveOperations::showPackProgress() {
    context_.session.send(command::packProgress(), this, [this](const Answer& answer) {
        const auto fraction = app::packedFraction(answer.text.toStdString());
        if (fraction && packProgress_->isActive())
            context_.view.tell(tr("Packing: %1 %").arg(qRound(100 * *fraction)));
    });
}

// --- Before changes are lost ---

bool SaveOperations::mayClose() {
    const bool staysOpen = context_.keeper.ours() && context_.preferences.get(pref::keepServers);
    if (staysOpen || !wouldLose() || othersWatch()) return true;
    ask([this] { context_.window.close(); });
    return false;
}

void SaveOperations::beforeLeaving(const std::function<void()>& go) { wouldLose() ? ask(go) : go(); }

bool SaveOperations::wouldLose() const {
    const SceneState& state = context_.editor.state();
    return context_.session.live() && state.modified && discarded_ != state.edits && !app::stopRequested();
}

void SaveOperations::ask(const Then& go) {
    if (question_ != nullptr) return question_->raise();
    question_ = plainBox(QMessageBox::Question, tr("Unsaved changes"),
                         tr("Save the changes of “%1”?").arg(QFileInfo(context_.editor.scene()).fileName()),
                         &context_.window);
    QPushButton* save = question_->addButton(tr("&Save"), QMessageBox::AcceptRole);
    const QPushButton* discard = question_->addButton(tr("&Discard"), QMessageBox::DestructiveRole);
    question_->addButton(QMessageBox::Cancel);
    question_->setDefaultButton(save);
    const auto leave = [this, go] {
        discarded_ = context_.editor.state().edits;
        go();
    };
    connect(save, &QPushButton::clicked, this, [this, leave] { this->save(leave); });
    connect(discard, &QPushButton::clicked, this, leave);
    question_->open();
}

bool SaveOperations::othersWatch() const {
    return context_.session.live() && context_.keeper.othersUse(context_.session.instance());
}

} // namespace gui
