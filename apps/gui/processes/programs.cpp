#include "gui/processes/programs.h"

#include "common/process/private_files.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace gui {

QString programPath(const QString& name) {
    const QString beside = QStandardPaths::findExecutable(name, {QCoreApplication::applicationDirPath()});
    return beside.isEmpty() ? QStandardPaths::findExecutable(name) : beside;
}

QString logPath(const QString& name) {
    const QString folder =
        QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) + QStringLiteral("/rtsuite");
    app::makePrivateFolder(folder.toStdString());
    return QStringLiteral("%1/%2.log").arg(folder, name);
}

QString sessionFolder() {
    const QString session = qEnvironmentVariable("XDG_RUNTIME_DIR");
    return session.isEmpty() ? QDir::tempPath() : session;
}

QString sceneFilter() {
    const QString models = QStringLiteral("*.3ds *.3mf *.ac *.ase *.b3d *.blend *.brep *.bvh *.cob *.dae "
                                          "*.dxf *.fbx *.glb *.gltf *.ifc *.iges *.igs *.irr "
                                          "*.lwo *.lws *.md2 *.md3 *.md5mesh *.ms3d *.nff *.obj *.off *.ply "
                                          "*.pts *.q3o *.smd *.step *.stl *.stp "
                                          "*.x *.x3d *.xgl *.xyz *.zgl");
    const auto tr = [](const char* text) { return QCoreApplication::translate("Programs", text); };
    return tr(QT_TRANSLATE_NOOP("Programs", "Scenes and models")) +
           QStringLiteral(" (*.scn *.bsp %1)").arg(models) + QStringLiteral(";;") +
           tr(QT_TRANSLATE_NOOP("Programs", "Scene descriptions")) + QStringLiteral(" (*.scn)") +
           QStringLiteral(";;") + tr(QT_TRANSLATE_NOOP("Programs", "All files")) + QStringLiteral(" (*)");
}

} // namespace gui
