#include "rtcore/io/bsp/bsp_file.h"
#include "rtcore/io/bsp/bsp_table.h"
#include "rtcore/io/bsp/bsp_version3.h"
#include "rtcore/io/bsp/model_check.h"

#include "rtcore/accel/validation.h"
#include "rtcore/platform/error.h"
#include "rtcore/scene/model_photometry.h"

#include <algorithm>
#include <cstring>
#include <string_view>
#include <utility>

namespace rtcore {

namespace {

/// The memory behind the views: the file, and copies of sections whose elements are not of our size.
struct Storage {
    std::shared_ptr<const void> file;
    std::vector<std::shared_ptr<const void>> copies;
};

/// One file on its way from bytes to views; every step throws at the first fault.
class Reader {
  public:
    Reader(FileBytes file, const std::string& name)
        : file_(std::move(file)), name_(name), table_(readBspTable(file_.bytes, name)) {}

    BspContent read() {
        BspContent content;
        content.identity = table_.identity;
        content.model = readModel();
        placeLuminaires(content.model);
        content.warnings = linesOf(readText(BspSection::Warnings, kMaxBspWarningBytes));
        content.origin = readOrigin(readText(BspSection::Origin, kMaxOriginBytes));
        KdTree tree{view<KdNode>(BspSection::Nodes), view<std::uint32_t>(BspSection::References),
                    table_.bounds, nullptr};
        if (const auto problem = checkModel(content.model)) fail(say("section {0}", *problem));
        if (table_.version < 4) convertMaterials(content.model);
        content.model.storage = tree.storage = storage();
        if (table_.hasTree) {
            const auto problem = validateKdTree(tree, content.model.mesh.triangles.size());
            if (problem) fail(say("section nodes: {0}", *problem));
            content.tree = std::move(tree);
        } else if (!tree.nodes.empty() || !tree.references.empty()) {
            fail(form("section nodes belongs to no tree"));
        }
        return content;
    }

  private:
    [[noreturn]] void fail(const Sentence& problem) const { failBsp(name_, problem); }

    /// In place where the elements are ours, else a copy.
    template <typename T>
    std::span<const T> view(BspSection section) {
        static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= 16);
        const BspSectionEntry* const entry = table_.find(section);
        if (entry == nullptr || entry->count == 0) return {};
        const std::byte* const first = file_.bytes.data() + entry->offset;
        if (entry->elementSize == sizeof(T)) return {reinterpret_cast<const T*>(first), entry->count};
        return copy<T>(section, *entry, first);
    }

    /// Elements longer than ours, of a later writer: their beginning. Shorter ones, of an earlier one: what
    /// they lack has its default.
    template <typename T>
    std::span<const T> copy(BspSection section, const BspSectionEntry& entry, const std::byte* from) {
        if (entry.elementSize < kindOf(section).minSize)
            fail(say("section {0} has elements of the wrong size", kindOf(section).name));
        auto copies = std::make_shared<std::vector<T>>(entry.count, T{});
        const std::size_t known = std::min<std::size_t>(entry.elementSize, sizeof(T));
        for (T& element : *copies) {
            std::memcpy(&element, from, known);
            from += entry.elementSize;
        }
        copies_.push_back(copies);
        return *copies;
    }

    Model readModel() {
        Model model;
        model.mesh = {view<Vertex>(BspSection::Vertices),
                      view<Triangle>(BspSection::Triangles),
                      view<ShadingTriangle>(BspSection::Shading),
                      view<Vec3>(BspSection::Normals),
                      view<Vec2>(BspSection::Texcoords),
                      view<Colour>(BspSection::Colours),
                      view<float>(BspSection::Alphas),
                      view<Vec2>(BspSection::TexcoordSets)};
        model.materials = view<Material>(BspSection::Materials);
        model.textures = view<Texture>(BspSection::Textures);
        model.texels = view<Rgba8>(BspSection::Texels);
        model.blocks = view<TexelBlock>(BspSection::TexelBlocks);
        model.lights = view<Light>(BspSection::Lights);
        model.cameras = view<Camera>(BspSection::Cameras);
        model.parts = view<ModelPart>(BspSection::Parts);
        model.strings = view<char>(BspSection::Strings);
        static constexpr Material kPlain{};
        static constexpr char kNoNames[1] = {};
        if (table_.find(BspSection::Materials) == nullptr) model.materials = {&kPlain, 1};
        if (table_.find(BspSection::Strings) == nullptr) model.strings = kNoNames;
        return model;
    }

    std::vector<PhotometricWeb> readLuminaires() {
        std::span<const double> numbers = view<double>(BspSection::Luminaires);
        std::vector<PhotometricWeb> webs;
        const auto failHere = [&] {
            fail(say("section {0} is no list of distributions", kindOf(BspSection::Luminaires).name));
        };
        if (numbers.size() > kMaxModelWebNumbers) failHere();
        while (!numbers.empty()) {
            auto web = takeWeb(numbers);
            if (!web || webs.size() == kMaxModelPhotometries) failHere();
            webs.push_back(std::move(*web));
        }
        return webs;
    }

    /// Lights name distributions of the file; in memory they name those that are kept.
    void placeLuminaires(Model& model) {
        const std::vector<PhotometricWeb> webs = readLuminaires();
        const auto named = [](const Light& light) { return light.photometry != 0; };
        if (std::ranges::none_of(model.lights, named)) return;
        auto lights = std::make_shared<std::vector<Light>>(model.lights.begin(), model.lights.end());
        std::vector<std::uint32_t> kept(webs.size()); // each once: to find it again all of it is compared
        for (Light& light : *lights) {
            if (!named(light)) continue;
            if (light.photometry > webs.size())
                fail(form("section lights: one names a luminaire that is not there"));
            const std::size_t number = light.photometry - 1;
            if (kept[number] == 0) kept[number] = keep(webs[number]);
            light.photometry = kept[number];
        }
        model.lights = *lights;
        copies_.push_back(std::move(lights));
    }

    std::uint32_t keep(const PhotometricWeb& web) const {
        try {
            return keepPhotometry(web);
        } catch (const Refusal& full) {
            throw FileError(FailureKind::BadData, name_, full.sentence());
        }
    }

    void convertMaterials(Model& model) {
        if (std::ranges::none_of(model.materials, hasRoughness)) return;
        const auto materials = std::make_shared<const std::vector<Material>>(materialsOfVersion3(model));
        model.materials = *materials;
        copies_.push_back(materials);
    }

    /// Lines of printable text.
    std::string_view readText(BspSection section, std::size_t max) {
        const std::span<const char> text = view<char>(section);
        const bool printable = std::all_of(text.begin(), text.end(), [](char c) {
            const auto code = static_cast<unsigned char>(c);
            return c == '\n' || (code >= 0x20 && code != 0x7F);
        });
        if (!printable || text.size() > max || (!text.empty() && text.back() != '\n'))
            fail(say("section {0} is no text", kindOf(section).name));
        return {text.data(), text.size()};
    }

    static std::vector<std::string> linesOf(std::string_view text) {
        std::vector<std::string> lines;
        while (!text.empty()) {
            const std::size_t end = text.find('\n');
            lines.emplace_back(text.substr(0, end));
            text.remove_prefix(end + 1);
        }
        return lines;
    }

    std::shared_ptr<const void> storage() {
        if (copies_.empty()) return file_.owner;
        return std::make_shared<const Storage>(Storage{file_.owner, std::move(copies_)});
    }

    FileBytes file_;
    const std::string& name_;
    BspTable table_;
    std::vector<std::shared_ptr<const void>> copies_;
};

} // namespace

BspContent readBsp(const std::filesystem::path& path) { return readBsp(openFileBytes(path), path.string()); }

BspContent readBsp(FileBytes file, const std::string& name) { return Reader(std::move(file), name).read(); }

} // namespace rtcore
