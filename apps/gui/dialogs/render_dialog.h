/// The dialog for a job of the Renderer: its input, output and quality.
#pragma once

#include "gui/dialogs/job_dialog.h"

#include <QSize>

#include <memory>

class QCheckBox;
class QComboBox;
class QLineEdit;
class QSpinBox;

namespace gui {

class FileField;
class ValueBox;

/// The state that the dialog starts from.
struct RenderContext {
    bool live = false;   ///< there is a server whose view can be rendered
    QSize size;          ///< of a live frame
    QString scene;       ///< proposed; may be empty
    QString list;        ///< a recorded list to begin with; may be empty
    QStringList flights; ///< of the server's scene
    QString flight;      ///< one of them to begin with; may be empty
    QString output;      ///< proposed for an image
    int antialiasing = 3;
};

/// A job, and the files that the server has to write for it first.
struct RenderWish {
    JobRequest job;
    QString sceneFile, cameraFile; ///< to be exported; empty: not needed
};

class RenderDialog : public JobDialog {
    Q_OBJECT

  public:
    explicit RenderDialog(const RenderContext& context, QWidget* parent = nullptr);

    enum class Source { View, Scene, List, Flight };
    void setSource(Source source); ///< View and Flight only when there is a server with such
    Source source() const;

  signals:
    void wanted(const gui::RenderWish& wish);

  protected:
    QStringList ownArguments() const override;
    QString missing() const override;
    void finish() override;

  private:
    void makeFields(const RenderContext& context);
    void makeDenoising();
    void layOut();
    void listen();
    void onSource();
    void proposeFilm();
    QString freeFilm() const;
    bool hasFrames() const;     ///< many: of a list or a flight
    bool sceneOfServer() const; ///< it has to be exported
    QString sceneFile() const;
    QString result() const;
    QString exported(const QString& name) const;
    QStringList filmArguments() const;
    QStringList qualityArguments() const;
    QStringList integratorArguments() const;
    QStringList denoisingArguments() const;
    QStringList occlusionArguments() const;
    bool byPaths() const;
    void addNamedSizes();
    void enableFields();

    const bool live_;
    const QString proposedOutput_;
    std::shared_ptr<PrivateFolder> files_; ///< for what the server writes
    QComboBox* source_;
    FileField *scene_, *camera_, *list_, *output_, *film_, *settings_;
    QLineEdit* frames_;
    QComboBox* flight_;
    ValueBox* rate_; ///< frames per second; 0: as recorded
    QComboBox *size_, *integrator_, *denoising_, *occlusion_;
    QSpinBox *width_, *height_, *samples_, *antialiasing_, *occlusionRays_, *bloom_;
    QCheckBox* newNoise_; ///< in each frame of a list
    QWidget *sizeRow_, *integratorRow_, *occlusionRow_;
    QString proposedFilm_;
};

} // namespace gui
