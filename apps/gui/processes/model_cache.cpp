#include "gui/processes/model_cache.h"

#include "gui/processes/programs.h"

#include "common/process/background.h"
#include "common/process/private_files.h"

#include "rtcore/io/import/model_import.h"
#include "rtcore/io/text/scn.h"
#include "rtcore/platform/error.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QDirIterator>
#include <QFileInfo>
#include <QProcess>

#include <optional>
#include <utility>

namespace gui {

namespace {

/// A model, and how it is imported.
struct Source {
    QString path;
    float creaseAngle = rtcore::kCreaseAngle;
    bool flipTextures = false;
    rtcore::PoseChoice pose = {};
    float deflection = rtcore::kDeflection;
};

// Nothing for a file that is no model or cannot be read: the loader reports it.
std::optional<Source> sourceOf(const QString& scene) {
    Source source{QFileInfo(scene).absoluteFilePath()};
    if (source.path.endsWith(QLatin1String(".scn"))) {
        try {
            const rtcore::SceneFile file = rtcore::readSceneFile(source.path.toStdString());
            source = {QString::fromStdString(file.model.string()), file.creaseAngle, file.flipTextures,
                      file.pose, file.deflection};
        } catch (const rtcore::FileError&) {
            return std::nullopt;
        }
    }
    const QFileInfo model(source.path);
    if (!model.isFile() || model.suffix().toLower() == QLatin1String("bsp")) return std::nullopt;
    source.path = model.canonicalFilePath();
    return source;
}

void add(QCryptographicHash& hash, const QFileInfo& file) {
    hash.addData(file.filePath().toUtf8());
    hash.addData(QByteArray::number(file.size()));
    hash.addData(QByteArray::number(file.lastModified().toMSecsSinceEpoch()));
}

// Files that models may name: materials, textures, buffers; at most one folder below that of the model.
void addCompanions(QCryptographicHash& hash, const QFileInfo& model) {
    const QStringList alone{QStringLiteral("ply"), QStringLiteral("stl"), QStringLiteral("off"),
                            QStringLiteral("glb")};
    if (alone.contains(model.suffix().toLower())) return;
    const QStringList names = QStringLiteral("*.mtl *.bin *.md5anim *.png *.jpg *.jpeg *.tga *.bmp *.dds "
                                             "*.gif *.tif *.tiff *.ppm *.webp *.jp2 "
                                             "*.psd *.pcx *.sgi *.exr *.hdr *.pfm")
                                  .split(QLatin1Char(' '));
    const auto addAll = [&](const QDir& folder) {
        for (const QFileInfo& file : folder.entryInfoList(names, QDir::Files, QDir::Name)) add(hash, file);
    };
    const QDir folder = model.absoluteDir();
    addAll(folder);
    for (const QFileInfo& each : folder.entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name))
        addAll(QDir(each.filePath()));
}

QDir cacheFolder() {
    return QFileInfo(logPath(QStringLiteral("x"))).dir().filePath(QStringLiteral("models"));
}

QString fileFor(const Source& source) {
    QCryptographicHash hash(QCryptographicHash::Sha1);
    const QFileInfo model(source.path);
    add(hash, model);
    addCompanions(hash, model);
    hash.addData(QByteArray::number(static_cast<double>(source.creaseAngle), 'g', 9));
    hash.addData(source.flipTextures ? "flipped" : "upright");
    if (source.pose != rtcore::PoseChoice{}) hash.addData(QByteArray::fromStdString(poseText(source.pose)));
    if (source.deflection != rtcore::kDeflection)
        hash.addData(QByteArray::number(static_cast<double>(source.deflection), 'g', 9));
    return cacheFolder().filePath(QString::fromLatin1(hash.result().toHex()) + QStringLiteral(".bsp"));
}

} // namespace

ModelCache::ModelCache(QObject* parent) : QObject(parent) {}

ModelCache::~ModelCache() {
    stop();
    constexpr int kPatience = 1000;
    for (QProcess* each : findChildren<QProcess*>()) {
        each->disconnect();
        each->waitForFinished(kPatience);
    }
}

QString ModelCache::find(const QString& scene) const {
    const std::optional<Source> source = megabytes_ > 0 ? sourceOf(scene) : std::nullopt;
    if (!source) return {};
    QFile file(fileFor(*source));
    // Use makes a file young: the oldest ones are removed first.
    if (!file.open(QIODevice::ReadWrite | QIODevice::ExistingOnly)) return {};
    file.setFileTime(QDateTime::currentDateTime(), QFileDevice::FileModificationTime);
    return file.fileName();
}

QString ModelCache::lightFolder() const { return megabytes_ > 0 ? cacheFolder().path() : QString(); }

void ModelCache::keep(const QString& scene) {
    const std::optional<Source> source = megabytes_ > 0 ? sourceOf(scene) : std::nullopt;
    const QString program = programPath(QStringLiteral("BSPBuilder"));
    if (!source || program.isEmpty()) return;
    const QString bsp = fileFor(*source);
    if (QFileInfo::exists(bsp) || bsp == building_) return;
    stop();
    app::makePrivateFolder(cacheFolder().path().toStdString());
    building_ = bsp;
    builder_ = new QProcess(this);
    builder_->setStandardOutputFile(QProcess::nullDevice());
    builder_->setStandardErrorFile(QProcess::nullDevice());
    builder_->setChildProcessModifier([] {
        app::lowerPriority();
        app::keepOthersOut();
    });
    connect(builder_, &QProcess::finished, this, [this, bsp] { finish(bsp); });
    QStringList words{
        source->path, bsp, QStringLiteral("--progress=none"),
        QStringLiteral("--crease-angle=%1").arg(static_cast<double>(source->creaseAngle), 0, 'g', 9),
        QStringLiteral("--parent=%1").arg(QCoreApplication::applicationPid())};
    if (source->flipTextures) words.append(QStringLiteral("--flip-textures"));
    if (source->pose != rtcore::PoseChoice{})
        words.append(QStringLiteral("--pose=") + QString::fromStdString(poseText(source->pose)));
    if (source->deflection != rtcore::kDeflection)
        words.append(
            QStringLiteral("--deflection=%1").arg(static_cast<double>(source->deflection), 0, 'g', 9));
    builder_->start(program, words);
}

void ModelCache::finish(const QString& bsp) {
    std::exchange(builder_, nullptr)->deleteLater();
    building_.clear();
    makeRoom();
    if (QFileInfo::exists(bsp)) emit kept(bsp);
}

// The oldest go first.
void ModelCache::makeRoom() const {
    const QDir folder = cacheFolder();
    constexpr qint64 kMegabyte = 1024 * 1024;
    qint64 room = megabytes_ * kMegabyte;
    const QStringList kept{QStringLiteral("*.bsp"), QStringLiteral("*.light")};
    for (const QFileInfo& file : folder.entryInfoList(kept, QDir::Files, QDir::Time)) {
        room -= file.size();
        if (room < 0) QFile::remove(file.filePath());
    }
    // Earlier versions kept what the builds printed.
    for (const QFileInfo& printed : folder.entryInfoList({QStringLiteral("*.bsp.txt")}, QDir::Files))
        QFile::remove(printed.filePath());
}

void ModelCache::stop() {
    if (builder_ == nullptr) return;
    QProcess* const builder = std::exchange(builder_, nullptr);
    building_.clear();
    builder->disconnect(this);
    connect(builder, &QProcess::finished, builder, &QObject::deleteLater);
    builder->state() == QProcess::Starting ? builder->kill() : builder->terminate();
}

} // namespace gui
