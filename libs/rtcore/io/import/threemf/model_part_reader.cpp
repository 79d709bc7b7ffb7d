#include "rtcore/io/import/threemf/model_part_reader.h"

#include "rtcore/io/import/threemf/attribute_values.h"
#include "rtcore/io/import/threemf/xml_events.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace rtcore::threemf {

namespace {

constexpr std::string_view kCore = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
constexpr std::array kReadSpaces{
    kCore, std::string_view("http://schemas.microsoft.com/3dmanufacturing/material/2015/02"),
    std::string_view("http://schemas.microsoft.com/3dmanufacturing/production/2015/06"),
    std::string_view("http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07")};

bool isRead(std::string_view space) { return std::ranges::find(kReadSpaces, space) != kReadSpaces.end(); }

/// "slice" of ".../3dmanufacturing/slice/2015/07".
std::string extensionName(std::string_view space) {
    constexpr std::string_view kBefore = "/3dmanufacturing/";
    const std::size_t at = space.find(kBefore);
    if (at == std::string_view::npos) return std::string(space);
    space.remove_prefix(at + kBefore.size());
    return std::string(space.substr(0, space.find('/')));
}

void addOnce(std::vector<std::string>& names, std::string_view name) {
    constexpr std::size_t kMaxNames = 20;
    if (names.size() < kMaxNames && std::ranges::find(names, name) == names.end()) names.emplace_back(name);
}

class PartEvents : public XmlEvents {
  public:
    explicit PartEvents(PartContent& part) : part_(part) {}

    void declare(std::string_view prefix, std::string_view space) override {
        prefixes_[std::string(prefix)] = std::string(space);
    }

    void begin(const XmlElement& element) override {
        ++depth_;
        if (unread_ > 0) return;
        if (!element.space().empty() && !isRead(element.space())) {
            addOnce(part_.ignored, element.name());
            unread_ = depth_;
            return;
        }
        const auto at = std::ranges::find(kElements, element.name(), &Known::name);
        if (at != kElements.end()) (this->*at->begin)(element);
    }

    void end(XmlName name) override {
        if (unread_ == depth_) unread_ = 0;
        --depth_;
        if (unread_ > 0) return;
        if (name.name == "object") object_ = nullptr;
        if (name.name == "metadata") inApplication_ = false;
    }

    void text(std::string_view piece) override {
        constexpr std::size_t kMaxText = 200;
        if (inApplication_ && part_.application.size() < kMaxText)
            part_.application.append(piece.substr(0, kMaxText - part_.application.size()));
    }

  private:
    struct Known {
        std::string_view name;
        void (PartEvents::*begin)(const XmlElement&);
    };

    void model(const XmlElement& e) {
        part_.metresPerUnit = metresOf(e.text("unit"));
        forEachWord(e.attribute("requiredextensions").value_or(""), [&](std::string_view prefix) {
            const auto known = prefixes_.find(std::string(prefix));
            const std::string_view space =
                known != prefixes_.end() ? std::string_view(known->second) : prefix;
            if (!isRead(space)) addOnce(part_.required, extensionName(space));
        });
    }
    void metadata(const XmlElement& e) { inApplication_ = e.attribute("name") == "Application"; }

    // Groups.

    PropertyGroup& newGroup(const XmlElement& e, GroupKind kind) {
        group_ = &part_.groups[numberOf(e.attribute("id"))];
        *group_ = {};
        group_->kind = kind;
        return *group_;
    }
    void materials(const XmlElement& e) {
        newGroup(e, GroupKind::Materials).display = numberOf(e.attribute("displaypropertiesid"));
    }
    void material(const XmlElement& e) {
        if (group_ == nullptr) return;
        group_->paints.push_back(paintOf(e.attribute("displaycolor")));
        group_->names.push_back(e.text("name"));
    }
    void colours(const XmlElement& e) { newGroup(e, GroupKind::Colours); }
    void colour(const XmlElement& e) {
        if (group_ != nullptr) group_->paints.push_back(paintOf(e.attribute("color")));
    }
    void textureGroup(const XmlElement& e) {
        newGroup(e, GroupKind::Texture).source = numberOf(e.attribute("texid"));
    }
    void coordinate(const XmlElement& e) {
        if (group_ != nullptr)
            group_->coordinates.push_back({realOf(e.attribute("u"), 0), realOf(e.attribute("v"), 0)});
    }
    /// Files have a handful; each entry takes memory for all of them.
    static std::vector<std::uint32_t> columnsOf(Value text) {
        constexpr std::size_t kMaxColumns = 32;
        std::vector<std::uint32_t> columns = numbersOf(text);
        columns.resize(std::min(columns.size(), kMaxColumns));
        return columns;
    }
    void composites(const XmlElement& e) {
        PropertyGroup& group = newGroup(e, GroupKind::Composites);
        group.source = numberOf(e.attribute("matid"));
        group.columns = columnsOf(e.attribute("matindices"));
    }
    void composite(const XmlElement& e) {
        if (group_ == nullptr) return;
        const std::size_t first = group_->weights.size();
        forEachWord(e.attribute("values").value_or(""), [&](std::string_view word) {
            if (group_->weights.size() < first + group_->columns.size())
                group_->weights.push_back(realOf(word, 0));
        });
        group_->weights.resize(first + group_->columns.size(), 0);
    }
    void layers(const XmlElement& e) {
        PropertyGroup& group = newGroup(e, GroupKind::Layers);
        group.columns = columnsOf(e.attribute("pids"));
        group.multiplies.assign(group.columns.size(), 0);
        std::size_t column = 1; // the lowest has nothing below it
        forEachWord(e.attribute("blendmethods").value_or(""), [&](std::string_view word) {
            if (column < group.multiplies.size()) group.multiplies[column++] = word == "multiply" ? 1 : 0;
        });
    }
    void layer(const XmlElement& e) {
        if (group_ == nullptr) return;
        const std::size_t first = group_->rows.size();
        std::vector<std::uint32_t> row = numbersOf(e.attribute("pindices"));
        row.resize(group_->columns.size(), 0); // as the format says of those that are left out
        group_->rows.insert(group_->rows.begin() + static_cast<std::ptrdiff_t>(first), row.begin(),
                            row.end());
    }
    void texture(const XmlElement& e) {
        TextureSource& texture = part_.textures[numberOf(e.attribute("id"))];
        texture.path = e.text("path");
        texture.wrapU = wrapOf(e.attribute("tilestyleu"));
        texture.wrapV = wrapOf(e.attribute("tilestylev"));
        if (e.attribute("filter") == "nearest") texture.filter = TextureFilter::Nearest;
    }

    // How materials reflect.

    void displays(const XmlElement& e) {
        displays_ = &part_.displays[numberOf(e.attribute("id"))];
        displays_->clear();
    }
    void metallic(const XmlElement& e) {
        if (displays_ == nullptr) return;
        displays_->push_back({.metallic = true,
                              .metal = realOf(e.attribute("metallicness"), 0),
                              .roughness = realOf(e.attribute("roughness"), 1),
                              .specular = {},
                              .glossiness = 0});
    }
    void specular(const XmlElement& e) {
        if (displays_ == nullptr) return;
        constexpr std::string_view kUsual = "#383838";
        displays_->push_back({.metallic = false,
                              .metal = 0,
                              .roughness = 1,
                              .specular = paintOf(e.attribute("specularcolor").value_or(kUsual)).colour,
                              .glossiness = realOf(e.attribute("glossiness"), 0)});
    }
    void unreadDisplays(const XmlElement& e) { addOnce(part_.ignored, e.name()); }

    // Objects.

    void object(const XmlElement& e) {
        const std::uint32_t id = numberOf(e.attribute("id"));
        object_ = &part_.objects[id];
        *object_ = {};
        object_->name = e.text("name");
        if (object_->name.empty()) object_->name = e.text("partnumber");
        const std::uint32_t entry = numberOf(e.attribute("pindex"));
        object_->properties = {numberOf(e.attribute("pid")), {entry, entry, entry}};
    }
    void vertex(const XmlElement& e) {
        if (object_ == nullptr) return;
        object_->positions.push_back(
            {coordinateOf(e.attribute("x")), coordinateOf(e.attribute("y")), coordinateOf(e.attribute("z"))});
    }
    void triangle(const XmlElement& e) {
        if (object_ == nullptr) return;
        const Triangle t{
            {numberOf(e.attribute("v1")), numberOf(e.attribute("v2")), numberOf(e.attribute("v3"))}};
        const std::size_t vertices = object_->positions.size();
        if (t.v[0] >= vertices || t.v[1] >= vertices || t.v[2] >= vertices) {
            ++object_->unconnected;
            return;
        }
        if (e.anyAttribute("paint_color")) addOnce(part_.ignored, "paint_color");
        if (e.anyAttribute("mmu_segmentation")) addOnce(part_.ignored, "mmu_segmentation");
        const Properties own = propertiesOf(e);
        std::vector<Properties>& list = object_->ownProperties;
        if (list.empty() && own != object_->properties)
            list.resize(object_->triangles.size(), object_->properties);
        object_->triangles.push_back(t);
        if (!list.empty() || own != object_->properties) list.push_back(own);
    }
    /// A group without entries is that of the object's; corners that say nothing are as the first.
    Properties propertiesOf(const XmlElement& e) const {
        Properties own{
            numberOf(e.attribute("pid")),
            {numberOf(e.attribute("p1")), numberOf(e.attribute("p2")), numberOf(e.attribute("p3"))}};
        if (own.entries[0] == kNoNumber) return object_->properties;
        if (own.group == kNoNumber) own.group = object_->properties.group;
        for (std::size_t i = 1; i < 3; ++i)
            if (own.entries[i] == kNoNumber) own.entries[i] = own.entries[0];
        return own;
    }
    static Component componentOf(const XmlElement& e) {
        return {std::string(e.anyAttribute("path").value_or("")), numberOf(e.attribute("objectid")),
                transformOf(e.attribute("transform"))};
    }
    void component(const XmlElement& e) {
        if (object_ != nullptr) object_->components.push_back(componentOf(e));
    }
    void item(const XmlElement& e) { part_.items.push_back(componentOf(e)); }

    static const std::array<Known, 24> kElements;

    PartContent& part_;
    std::map<std::string, std::string> prefixes_;
    PropertyGroup* group_ = nullptr;
    std::vector<Display>* displays_ = nullptr;
    Object* object_ = nullptr;
    std::uint64_t depth_ = 0, unread_ = 0; ///< where an element began that is not read; 0 = nowhere
    bool inApplication_ = false;
};

/// The commonest first.
const std::array<PartEvents::Known, 24> PartEvents::kElements{{
    {"triangle", &PartEvents::triangle},
    {"vertex", &PartEvents::vertex},
    {"color", &PartEvents::colour},
    {"tex2coord", &PartEvents::coordinate},
    {"multi", &PartEvents::layer},
    {"composite", &PartEvents::composite},
    {"base", &PartEvents::material},
    {"component", &PartEvents::component},
    {"item", &PartEvents::item},
    {"object", &PartEvents::object},
    {"model", &PartEvents::model},
    {"metadata", &PartEvents::metadata},
    {"basematerials", &PartEvents::materials},
    {"colorgroup", &PartEvents::colours},
    {"texture2dgroup", &PartEvents::textureGroup},
    {"compositematerials", &PartEvents::composites},
    {"multiproperties", &PartEvents::layers},
    {"texture2d", &PartEvents::texture},
    {"pbmetallicdisplayproperties", &PartEvents::displays},
    {"pbmetallic", &PartEvents::metallic},
    {"pbspeculardisplayproperties", &PartEvents::displays},
    {"pbspecular", &PartEvents::specular},
    {"translucentdisplayproperties", &PartEvents::unreadDisplays},
    {"pbmetallictexturedisplayproperties", &PartEvents::unreadDisplays},
}};

} // namespace

PartContent readModelPart(Package& package, std::string_view name) {
    PartContent part;
    PartEvents events(part);
    XmlReader reader(events, std::string(name));
    package.read(name, [&](std::span<const char> piece) { reader.read(piece); });
    reader.finish();
    return part;
}

} // namespace rtcore::threemf
