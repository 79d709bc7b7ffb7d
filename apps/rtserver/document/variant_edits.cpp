#include "rtserver/document/variant_edits.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/settings/plain_text.h"

#include <algorithm>
#include <utility>

namespace rtserver {

namespace {

using rtcore::SceneVariant;

rtcore::VariantScene shownBy(const Document& document) {
    return {*document.scene(), document.settings().skyLight.on};
}

const SceneVariant& activeVariant(const Document& document) {
    static const SceneVariant kNone;
    const VariantBook& book = document.variants();
    const auto found = rtcore::findVariant(book.all, book.active);
    return found != book.all.end() ? *found : kNone;
}

SceneVariant& variantIn(VariantBook& book, const std::string& name) {
    return *std::ranges::find(book.all, name, &SceneVariant::name);
}

/// The settings first: they may be refused.
void show(Document& document, const SceneVariant& variant) {
    rtcore::VariantScene shown = shownBy(document);
    switchVariant(shown, *document.variants().base, activeVariant(document), variant);
    if (shown.skyLight != document.settings().skyLight.on) document.assign({{"skyLight.on", shown.skyLight}});
    document.publish(std::move(shown.scene));
    VariantBook book = document.variants();
    book.active = variant.name;
    document.setVariants(std::move(book));
}

void checkName(const std::string& name) {
    if (const auto problem = rtcore::problemOfVariantName(name)) throw rtcore::BadValue(*problem);
}

} // namespace

const SceneVariant& variantNamed(const Document& document, const std::string& name) {
    const rtcore::SceneVariants& all = document.variants().all;
    const auto found = rtcore::findVariant(all, name);
    if (found != all.end()) return *found;
    throw rtcore::Refusal(
        rtcore::say("the scene has no variant {0}; 'variant list' lists them", rtcore::inQuotes(name)));
}

void addVariant(Document& document, const std::string& name) {
    checkName(name);
    VariantBook book = document.variants();
    SceneVariant made = differences(*book.base, shownBy(document));
    if (made.empty())
        throw rtcore::Refusal("nothing differs from the base; change materials, parts, lights or the sky "
                              "first");
    made.name = name;
    if (const auto former = std::ranges::find(book.all, name, &SceneVariant::name); former != book.all.end())
        *former = std::move(made);
    else if (book.all.size() < rtcore::kMaxVariants)
        book.all.push_back(std::move(made));
    else
        throw rtcore::Refusal(
            rtcore::say("there are {0} variants already; remove one first", rtcore::kMaxVariants));
    book.active = name;
    document.setVariants(std::move(book));
}

void updateVariant(Document& document, const std::string& name) {
    SceneVariant now = updated(variantNamed(document, name), *document.variants().base, shownBy(document));
    VariantBook book = document.variants();
    variantIn(book, name) = std::move(now);
    book.active = name;
    document.setVariants(std::move(book));
}

void renameVariant(Document& document, const std::string& name, const std::string& to) {
    (void)variantNamed(document, name);
    checkName(to);
    VariantBook book = document.variants();
    if (to != name && rtcore::findVariant(book.all, to) != book.all.end())
        throw rtcore::BadValue(rtcore::say("another variant is called {0}", rtcore::inQuotes(to)));
    variantIn(book, name).name = to;
    if (book.active == name) book.active = to;
    document.setVariants(std::move(book));
}

void removeVariant(Document& document, const std::string& name) {
    (void)variantNamed(document, name);
    VariantBook book = document.variants();
    std::erase_if(book.all, [&](const SceneVariant& each) { return each.name == name; });
    if (book.active == name) book.active.clear();
    document.setVariants(std::move(book));
}

void rebaseVariants(Document& document) {
    VariantBook book = document.variants();
    book.active.clear();
    book.base = variantScene(*document.scene(), document.settings());
    document.setVariants(std::move(book));
}

void goToVariant(Document& document, const std::string& name) {
    show(document, variantNamed(document, name));
}

void leaveVariant(Document& document) { show(document, SceneVariant()); }

} // namespace rtserver
