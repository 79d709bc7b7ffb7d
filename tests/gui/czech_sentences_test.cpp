/// The sentences of jobs in a Czech window, to the last word.
#include "gui/jobs_support.h"

#include "gui/session/server_sentence.h"

#include "rtcore/io/text/scn.h"
#include "rtcore/platform/error.h"

#include <QFile>
#include <QImage>
#include <QTranslator>

#ifdef RT_TRANSLATED
namespace {

using namespace test;
using namespace gui;

class CzechSentences : public WithJobs<GuiTest> {
  protected:
    void SetUp() override {
        GuiTest::SetUp();
        ASSERT_TRUE(sentences_.load(QStringLiteral(":/translations/sentences_cs.qm")));
        QCoreApplication::installTranslator(&sentences_);
    }
    void TearDown() override {
        QCoreApplication::removeTranslator(&sentences_);
        GuiTest::TearDown();
    }
    /// Flips a bit of the byte that is so far behind the first `mark`.
    void damage(const std::string& name, const char* mark, qsizetype behind) const {
        QFile file(this->file(name));
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        QByteArray bytes = file.readAll();
        file.close();
        const qsizetype at = bytes.indexOf(mark);
        ASSERT_GE(at, 0);
        bytes[at + behind] = static_cast<char>(bytes[at + behind] ^ 1);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    }
    std::string named(const std::string& name, const std::string& text) const {
        return this->text(file(name)) + ": " + text;
    }

  private:
    QTranslator sentences_;
};

TEST_F(CzechSentences, OfDamagedText) {
    const auto said = [](const std::string& scene) {
        try {
            rtcore::parseSceneFile(scene, "a.scn");
        } catch (const rtcore::FileError& error) {
            return text(translated(error));
        }
        return std::string("no error");
    };
    EXPECT_EQ(said("version 1"), "a.scn:1:9: tady má být =, ne '1'; řádek má tvar klíč = hodnota");
    EXPECT_EQ(said("model = room.obj"),
              "a.scn:1:9: toto není hodnota; text patří do uvozovek, přepínač je true nebo false");
    EXPECT_EQ(said("up = \"+y\nmodel = 'a'"),
              "a.scn:1:9: text nekončí; uzavřete jeho uvozovky na tomtéž řádku");
}

TEST_F(CzechSentences, OfJobs) {
    QImage texture(8, 8, QImage::Format_RGB888);
    texture.fill(Qt::red);
    ASSERT_TRUE(texture.save(file("red.png")));
    damage("red.png", "IHDR", 17); // its checksum
    writeText(folder() / "wall.mtl", "newmtl wall\nmap_Kd red.png\n");
    writeText(folder() / "wall.obj", "mtllib wall.mtl\nv 0 0 0\nv 4 0 0\nv 4 3 0\nvt 0 0\nvt 1 1\nvt 0 1\n"
                                     "usemtl wall\nf 1/1 2/2 3/3\n");
    const std::string warning =
        "varování: " +
        named("wall.obj", "textura " +
                              named("red.png", "poškozený PNG: nesouhlasí kontrolní součet jeho části IHDR") +
                              "; její materiál je jednobarevný\n");
    JobQueue queue;
    JobRequest ofModel = shortRender("a.png"), ofTree = shortRender("b.png");
    ofModel.arguments[0] = file("wall.obj");
    ofTree.arguments[0] = file("wall.bsp");
    const quint64 build = queue.add({QStringLiteral("wall.bsp"),
                                     QStringLiteral("BSPBuilder"),
                                     {file("wall.obj"), file("wall.bsp")},
                                     file("wall.bsp"),
                                     nullptr});
    const quint64 first = queue.add(ofModel), second = queue.add(ofTree);
    ASSERT_TRUE(becomes(queue, second, JobState::Done)) << text(queue.job(2).message);
    EXPECT_EQ(text(queue.job(queue.rowOf(build)).log), "BSPBuilder: " + warning);
    EXPECT_EQ(text(queue.job(queue.rowOf(first)).log), "Renderer: " + warning);
    EXPECT_EQ(text(queue.job(queue.rowOf(second)).log),
              "Renderer: varování: " + named("wall.bsp", warning.substr(warning.find("textura"))))
        << "the .bsp has kept it";

    damage("wall.bsp", "texture {0}", 0);
    const quint64 damaged = queue.add(ofTree);
    ASSERT_TRUE(becomes(queue, damaged, JobState::Failed));
    EXPECT_EQ(text(queue.job(queue.rowOf(damaged)).message),
              named("wall.bsp", "oddíly jsou poškozené (nesouhlasí kontrolní součet); vytvořte ho znovu "
                                "programem BSPBuilder"));
}

} // namespace
#endif
