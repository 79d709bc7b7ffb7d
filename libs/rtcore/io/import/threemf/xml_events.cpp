#include "rtcore/io/import/threemf/xml_events.h"

#include "rtcore/platform/error.h"

#include <expat.h>

#include <cstring>
#include <exception>
#include <utility>

namespace rtcore::threemf {

namespace {

constexpr char kBetween = '\n'; // stands in no name

XmlName splitName(const char* text) {
    const char* const between = std::strchr(text, kBetween);
    if (between == nullptr) return {"", text};
    return {{text, static_cast<std::size_t>(between - text)}, between + 1};
}

} // namespace

std::optional<std::string_view> XmlElement::attribute(std::string_view name) const {
    for (const char* const* at = attributes_; *at != nullptr; at += 2)
        if (name == *at) return at[1];
    return std::nullopt;
}

std::optional<std::string_view> XmlElement::anyAttribute(std::string_view name) const {
    for (const char* const* at = attributes_; *at != nullptr; at += 2)
        if (splitName(*at).name == name) return at[1];
    return std::nullopt;
}

/// Exceptions cannot pass through expat, which is C: they wait until it has returned.
struct XmlReader::Parser {
    Parser(XmlEvents& to, std::string name)
        : events(to), part(std::move(name)), xml(XML_ParserCreateNS(nullptr, kBetween)) {
        if (xml == nullptr) throw std::bad_alloc();
        XML_SetUserData(xml, this);
        XML_SetElementHandler(xml, onBegin, onEnd);
        XML_SetCharacterDataHandler(xml, onText);
        XML_SetStartNamespaceDeclHandler(xml, onPrefix);
        XML_SetStartDoctypeDeclHandler(xml, onDoctype);
    }
    ~Parser() { XML_ParserFree(xml); }
    Parser(const Parser&) = delete;
    Parser& operator=(const Parser&) = delete;

    template <typename Tell>
    static void guarded(void* self, const Tell& tell) {
        auto& parser = *static_cast<Parser*>(self);
        if (parser.failure) return;
        try {
            tell(parser);
        } catch (...) {
            parser.failure = std::current_exception();
            XML_StopParser(parser.xml, XML_FALSE);
        }
    }
    static void onBegin(void* self, const char* name, const char** attributes) {
        guarded(self, [&](Parser& p) { p.events.begin({splitName(name), attributes}); });
    }
    static void onEnd(void* self, const char* name) {
        guarded(self, [&](Parser& p) { p.events.end(splitName(name)); });
    }
    static void onText(void* self, const char* text, int size) {
        guarded(self, [&](Parser& p) { p.events.text({text, static_cast<std::size_t>(size)}); });
    }
    static void onPrefix(void* self, const char* prefix, const char* space) {
        guarded(self, [&](Parser& p) {
            p.events.declare(prefix == nullptr ? "" : prefix, space == nullptr ? "" : space);
        });
    }
    static void onDoctype(void* self, const char*, const char*, const char*, int) {
        guarded(self, [](const Parser& p) {
            throw FileError(
                FailureKind::BadData, "",
                say("its part {0} declares a document type, which 3MF forbids; export it again", p.part));
        });
    }

    XmlEvents& events;
    std::string part;
    XML_Parser xml;
    std::exception_ptr failure;
};

XmlReader::XmlReader(XmlEvents& events, std::string part)
    : parser_(std::make_unique<Parser>(events, std::move(part))) {}

XmlReader::~XmlReader() = default;

void XmlReader::parse(std::span<const char> piece, bool last) {
    const XML_Parser xml = parser_->xml;
    const XML_Status status =
        XML_Parse(xml, piece.data(), static_cast<int>(piece.size()), last ? XML_TRUE : XML_FALSE);
    if (parser_->failure) std::rethrow_exception(parser_->failure);
    if (status != XML_STATUS_ERROR) return;
    if (XML_GetErrorCode(xml) == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
    throw FileError(FailureKind::BadData, "",
                    say("line {0} of its part {1} is no XML ({2}); copy or export it again",
                        XML_GetCurrentLineNumber(xml), parser_->part,
                        std::string(XML_ErrorString(XML_GetErrorCode(xml)))));
}

void XmlReader::read(std::span<const char> piece) { parse(piece, false); }

void XmlReader::finish() { parse({}, true); }

} // namespace rtcore::threemf
