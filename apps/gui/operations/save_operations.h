/// Save, Save as, Pack; and the question before changes are lost.
#pragma once

#include "gui/operations/gui_context.h"

#include <QObject>
#include <QPointer>
#include <QString>

#include <functional>
#include <optional>
#include <string>

class QAction;
class QMessageBox;
class QTimer;

namespace gui {

struct Answer;

class SaveOperations : public QObject {
    Q_OBJECT

  public:
    SaveOperations(const GuiContext& context, QObject* parent);

    /// Whether the window may close. Otherwise the user is asked, and closes it by the answer, or not.
    bool mayClose();
    /// Does `go`, which ends the scene that is shown, at once or as the user answers.
    void beforeLeaving(const std::function<void()>& go);

  signals:
    /// Data that the window itself keeps for the scene has to go to the server now.
    void aboutToSave();
    /// The scene was saved as another file than before.
    void savedAs(const QString& path);

  private:
    using Then = std::function<void()>;
    void save(const Then& then = {});
    void saveAs(const Then& then = {});
    void saveTo(const QString& path, const Then& then);
    void confirmReplacing(const QString& path, const Then& replace);
    void write(const QString& path, bool replace, const Then& then);
    void onSaved(const Answer& answer, const QString& path, const Then& then);
    void pack();
    void packInto(const QString& folder, bool outside);
    void onPacked(const Answer& answer, const QString& folder);
    void confirmOutside(QString files, const QString& folder);
    void showPackProgress();
    void ask(const Then& go);
    bool wouldLose() const;
    bool othersWatch() const;

    GuiContext context_;
    QAction* stopPacking_; ///< offered while a pack is made
    QTimer* packProgress_;
    QPointer<QMessageBox> question_;
    std::optional<int> discarded_; ///< edits that the user gave up
};

} // namespace gui
